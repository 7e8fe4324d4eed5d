// SPDX-License-Identifier: MIT
#include "core/labels/ConfusionMatrix.h"

#include <algorithm>

#include "core/labels/LabelSet.h"

namespace fodscope {
namespace {

/// @return the only entry, or `mixed`
std::string onlyOf(const std::vector<std::string>& names) {
    return names.size() == 1 ? names.front() : kMixed;
}

bool isType(const std::string& name) {
    return name != kNoFod && name != kNotSure && name != kMixed && name != kMissed;
}

std::size_t indexOf(const std::vector<std::string>& names, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

}  // namespace

std::vector<ConfusionEntry> confusionEntries(const std::set<std::string>& labelled,
                                             const std::set<std::string>& actual) {
    std::vector<ConfusionEntry> entries;
    if (labelled.empty()) return entries;
    if (labelled.contains(kNoFod)) {
        const std::vector<std::string> there(actual.begin(), actual.end());
        entries.push_back({kNoFod, there.empty() ? kNoFod : onlyOf(there)});
        return entries;
    }
    std::vector<std::string> extraLabels, fodLeft;
    for (const std::string& label : labelled) {
        if (actual.contains(label))
            entries.push_back({label, label});
        else
            extraLabels.push_back(label);
    }
    for (const std::string& type : actual)
        if (!labelled.contains(type)) fodLeft.push_back(type);
    if (fodLeft.empty()) {
        for (const std::string& label : extraLabels)
            entries.push_back({label, kNoFod});
    } else if (extraLabels.empty()) {
        for (const std::string& type : fodLeft)
            entries.push_back({kMissed, type});
    } else {
        entries.push_back({onlyOf(extraLabels), onlyOf(fodLeft)});
    }
    return entries;
}

std::size_t ConfusionMatrix::total() const {
    std::size_t sum = 0;
    for (const auto& row : counts)
        for (const std::size_t count : row)
            sum += count;
    return sum;
}

std::size_t ConfusionMatrix::correct() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = 0; j < columns.size(); ++j)
            if (rows[i] == columns[j] && rows[i] != kMixed) sum += counts[i][j];
    return sum;
}

std::optional<double> ConfusionMatrix::accuracy() const {
    const std::size_t all = total();
    if (all == 0) return std::nullopt;
    return static_cast<double>(correct()) / static_cast<double>(all);
}

ConfusionMatrix confusionMatrix(const std::vector<ConfusionEntry>& entries) {
    std::set<std::string> types;
    for (const ConfusionEntry& entry : entries)
        for (const std::string& name : {entry.labelled, entry.actual})
            if (isType(name)) types.insert(name);
    ConfusionMatrix matrix;
    matrix.columns.assign(types.begin(), types.end());
    matrix.columns.push_back(kNoFod);
    matrix.columns.push_back(kMixed);
    matrix.rows = matrix.columns;
    matrix.rows.push_back(kMissed);
    matrix.rows.push_back(kNotSure);
    matrix.counts.assign(matrix.rows.size(), std::vector<std::size_t>(matrix.columns.size(), 0));
    for (const ConfusionEntry& entry : entries)
        ++matrix.counts[indexOf(matrix.rows, entry.labelled)][indexOf(matrix.columns, entry.actual)];
    return matrix;
}

}  // namespace fodscope
