// SPDX-License-Identifier: MIT
#include "ui/report/PageFlow.h"

namespace fodscope::report {

namespace {

/// Height of an item and those it must stay with.
double groupHeight(const Flow& flow, std::size_t first) {
    double height = flow[first].height;
    for (std::size_t index = first; flow[index].keepWithNext && index + 1 < flow.size(); ++index) {
        height += flow[index + 1].spaceBefore + flow[index + 1].height;
    }
    return height;
}

}  // namespace

std::vector<PlacedPage> paginate(const Flow& flow, double contentHeight) {
    std::vector<PlacedPage> pages(1);
    double used = 0.0;
    const auto turn = [&] {
        pages.emplace_back();
        used = 0.0;
    };
    bool held = false;  // the item before keeps with this one: its group was already found to fit
    for (std::size_t index = 0; index < flow.size(); ++index) {
        const FlowItem& item = flow[index];
        const double wanted = held ? item.height : groupHeight(flow, index);
        const double needed = wanted <= contentHeight ? wanted : item.height;
        const bool isFirst = pages.back().empty();
        const bool overflows = used + item.spaceBefore + needed > contentHeight;
        if (!isFirst && (item.startsPage || overflows)) turn();
        if (pages.back().empty() && item.repeatedHeader && pages.size() > 1) {
            pages.back().push_back({item.repeatedHeader.get(), 0.0});
            used = item.repeatedHeader->height;
        } else if (!pages.back().empty()) {
            used += item.spaceBefore;
        }
        pages.back().push_back({&item, used});
        used += item.height;
        held = item.keepWithNext && wanted <= contentHeight;
    }
    return pages;
}

}  // namespace fodscope::report
