// SPDX-License-Identifier: MIT
#include "ui/report/PageFlow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fodscope::report {
namespace {

FlowItem item(double height, double spaceBefore = 0.0, bool keepWithNext = false) {
    FlowItem made;
    made.height = height;
    made.spaceBefore = spaceBefore;
    made.keepWithNext = keepWithNext;
    return made;
}

std::vector<std::size_t> itemsOnPages(const Flow& flow, double height) {
    std::vector<std::size_t> counts;
    for (const PlacedPage& page : paginate(flow, height))
        counts.push_back(page.size());
    return counts;
}

TEST(Paginate, FillsPagesFromTheTop) {
    const Flow flow{item(40), item(40, 10), item(40, 10)};
    const auto pages = paginate(flow, 100);
    ASSERT_EQ(pages.size(), 2U);
    EXPECT_DOUBLE_EQ(pages[0][1].top, 50.0);
    EXPECT_DOUBLE_EQ(pages[1][0].top, 0.0) << "no gap above the first item of a page";
}

TEST(Paginate, AHeadingStaysWithWhatItHeads) {
    EXPECT_THAT(itemsOnPages({item(60), item(20, 0, true), item(30)}, 100), testing::ElementsAre(1, 2));
}

TEST(Paginate, AGroupHigherThanAPageIsBroken) {
    EXPECT_THAT(itemsOnPages({item(60, 0, true), item(70, 0, true), item(20)}, 100), testing::ElementsAre(1, 2));
}

TEST(Paginate, AnItemHigherThanAPageGetsItsOwn) {
    EXPECT_THAT(itemsOnPages({item(10), item(500), item(10)}, 100), testing::ElementsAre(1, 1, 1));
}

TEST(Paginate, ATableHeaderComesAgainOnTheNextPage) {
    const auto header = std::make_shared<FlowItem>(item(20, 0, true));
    Flow flow{*header};
    for (int row = 0; row < 7; ++row) {
        flow.push_back(item(30));
        flow.back().repeatedHeader = header;
    }
    const auto pages = paginate(flow, 100);
    ASSERT_EQ(pages.size(), 4U);
    for (std::size_t page = 1; page < pages.size(); ++page) {
        EXPECT_EQ(pages[page][0].item, header.get());
        EXPECT_DOUBLE_EQ(pages[page][1].top, 20.0);
    }
}

TEST(Paginate, NothingIsLostOrOverflows) {
    Flow flow;
    for (int index = 0; index < 200; ++index)
        flow.push_back(item(7 + (index * 13) % 40, index % 5, index % 6 == 0));
    std::size_t placed = 0;
    for (const PlacedPage& page : paginate(flow, 120)) {
        placed += page.size();
        EXPECT_LE(page.back().top + page.back().item->height, 120.0);
    }
    EXPECT_EQ(placed, flow.size());
    EXPECT_EQ(paginate({}, 100).size(), 1U);
}

}  // namespace
}  // namespace fodscope::report
