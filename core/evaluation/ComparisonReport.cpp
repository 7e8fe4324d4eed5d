// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "core/evaluation/Comparison.h"
#include "core/evaluation/TextTable.h"
#include "core/inspection/JsonNumbers.h"
#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t kLineWidth = 110;

/// p-values keep their digits: small ones matter.
Json exactOrNull(const std::optional<double>& value) {
    return value ? Json(*value) : Json(nullptr);
}

Json orNull(const std::optional<double>& value) {
    return value ? rounded(*value) : Json(nullptr);
}

std::string orUnknown(const std::optional<double>& value, int decimals) {
    return value ? fixed(*value, decimals) : "-";
}

std::string methodOf(const WilcoxonResult& test) {
    return test.method == WilcoxonMethod::Exact ? "exact" : "normal";
}

std::string quantityInWords(const std::string& quantity) {
    if (quantity == "unassociated_points") return "unassociated points per trial";
    if (quantity == "unassociated_candidates") return "unassociated candidates per trial";
    return "distance error per FOD [m]";
}

std::vector<std::string> howCounted(const Comparison& comparison) {
    std::vector<std::string> lines = {
        "One-sided Wilcoxon signed-rank tests of A - B as scipy.stats.wilcoxon does them (zero differences left out, "
        "no "
        "continuity correction; exact for at most 50 pairs without zero differences, else the normal approximation). "
        "Trials are paired by name, FOD by their place in the trial; n is the number of pairs. '-': nothing differs.",
        "A FOD without a candidate is charged 7.5 m."};
    std::string failed;
    for (const std::string& name : comparison.failedTrials)
        failed += (failed.empty() ? "" : ", ") + name;
    if (!failed.empty()) lines.push_back("Failed to register in A or B, and in no pair of counts: " + failed + ".");
    return lines;
}

}  // namespace

std::string comparisonJson(const Comparison& comparison) {
    Json root = {
        {"schema", "fodscope.comparison/1"}, {"a", comparison.fileA},   {"b", comparison.fileB},
        {"trials", comparison.trials},       {"fods", comparison.fods}, {"failed_trials", comparison.failedTrials}};
    for (const PairedTest& one : comparison.tests)
        root["tests"][one.quantity] = {{"n", one.test.pairs},
                                       {"zeros", one.test.zeros},
                                       {"mean_a", orNull(one.meanA)},
                                       {"mean_b", orNull(one.meanB)},
                                       {"statistic", exactOrNull(one.test.statistic)},
                                       {"p_a_smaller_than_b", exactOrNull(one.test.less)},
                                       {"p_b_smaller_than_a", exactOrNull(one.test.greater)},
                                       {"method", methodOf(one.test)}};
    root["how_counted"] = howCounted(comparison);
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string comparisonText(const Comparison& comparison) {
    std::vector<std::vector<std::string>> rows = {
        {"", "n", "differ", "mean A", "mean B", "p: A smaller than B", "p: B smaller than A", "method"}};
    for (const PairedTest& one : comparison.tests)
        rows.push_back({quantityInWords(one.quantity), std::to_string(one.test.pairs),
                        std::to_string(one.test.pairs - one.test.zeros), orUnknown(one.meanA, 3),
                        orUnknown(one.meanB, 3), orUnknown(one.test.less, 4), orUnknown(one.test.greater, 4),
                        methodOf(one.test)});
    std::string text = "A  " + comparison.fileA + "\nB  " + comparison.fileB + "\n\n" +
                       std::to_string(comparison.trials) + " trials with " + std::to_string(comparison.fods) +
                       " FOD in both\n" + textTable(rows) + "\nHow it was counted\n";
    for (const std::string& line : howCounted(comparison))
        text += wrapped(line, kLineWidth);
    return text;
}

}  // namespace fodscope
