// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/evaluation/PhotoSearch.h"
#include "core/evaluation/SearchReport.h"
#include "core/inspection/JsonNumbers.h"
#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

using Json = nlohmann::ordered_json;

std::string valuesAt(const PhotoSearchResult& result, const GridPoint& point) {
    const CandidateSettings values = result.settingsAt(point);
    return "threshold " + fixed(values.threshold, 4) + (values.metric == Metric::Euclidean ? " m" : "") +
           ", cluster cutoff " + fixed(values.clusterCutoff_m, 3) + " m, least points " +
           std::to_string(values.minimumPoints);
}

std::string outcomeWords(const PhotoSearchResult& result, const PhotoOutcome& outcome) {
    return std::to_string(outcome.photos) + " photos show " + std::to_string(outcome.fodsShown) + " of " +
           std::to_string(result.fodCount) + " FOD (recall " + fixed(result.recallOf(outcome), 3) + ", precision " +
           (outcome.precision() ? fixed(*outcome.precision(), 3) : std::string("-")) + ", " +
           fixed(static_cast<double>(outcome.photos) / static_cast<double>(result.fodCount), 2) + " photos per FOD)";
}

std::size_t leftOut(const PhotoSearchResult& result) {
    return static_cast<std::size_t>(
        std::ranges::count_if(result.outcomes, [](const auto& outcome) { return !outcome.has_value(); }));
}

Json jsonOf(const PhotoSearchResult& result, const PhotoChoice& choice) {
    const CandidateSettings values = result.settingsAt(choice.point);
    const PhotoOutcome& outcome = choice.outcome;
    return {{"recall", rounded(result.recallOf(outcome))},
            {"precision", outcome.precision() ? rounded(*outcome.precision()) : Json()},
            {"photos", outcome.photos},
            {"photos_with_fod", outcome.photosWithFod},
            {"fods_shown", outcome.fodsShown},
            {"photos_per_fod", rounded(static_cast<double>(outcome.photos) / static_cast<double>(result.fodCount))},
            {"candidates", outcome.candidates},
            {"candidates_without_photo", outcome.candidatesWithoutPhoto},
            {"threshold", values.threshold},
            {"cluster_cutoff_m", values.clusterCutoff_m},
            {"minimum_points", values.minimumPoints}};
}

}  // namespace

std::vector<std::string> photoSearchFindings(const PhotoSearchResult& result) {
    std::vector<std::string> lines;
    lines.push_back("Searched " + std::to_string(result.outcomes.size()) + " grid points over " +
                    std::to_string(result.trialCount) + " trials with " + std::to_string(result.fodCount) + " FOD.");
    if (const std::size_t count = leftOut(result); count > 0)
        lines.push_back(std::to_string(count) + " of them were left out: more than " +
                        std::to_string(result.settings.mostCandidates) + " candidates in a trial.");
    if (result.best) {
        lines.push_back("Fewest photos at a recall of at least " + fixed(result.settings.recall, 3) + ": " +
                        valuesAt(result, result.best->point) + ".");
        lines.push_back("There " + outcomeWords(result, result.best->outcome) + ".");
    } else if (!result.curve.empty()) {
        lines.push_back("No grid point shows as many FOD as a recall of " + fixed(result.settings.recall, 3) +
                        " asks for; at most " + outcomeWords(result, result.curve.back().outcome) + ".");
    }
    return lines;
}

std::vector<std::string> photoSearchMethod(const PhotoSearchResult& result) {
    std::vector<std::string> lines;
    lines.push_back(
        "At each grid point the candidates of every trial were planned for and photographed: a FOD is shown when at "
        "least 200 pixels");
    lines.push_back("of a photo 1280 pixels wide, cast into the trial's world, are its own. Grid: " +
                    std::to_string(result.cutoffs_m.size()) + " cluster cutoffs from " +
                    fixed(result.cutoffs_m.front(), 3) + " to " + fixed(result.cutoffs_m.back(), 3) + " m,");
    lines.push_back(std::to_string(result.thresholds.size()) + " thresholds from " +
                    fixed(result.thresholds.front(), 4) + " to " + fixed(result.thresholds.back(), 4) +
                    ", least points " + std::to_string(result.leastPoints.front()) + " to " +
                    std::to_string(result.leastPoints.back()) + "; metric " + nameOf(result.settings.grid.metric) +
                    ", " + nameOf(result.settings.grid.linkage) + " linkage.");
    return lines;
}

std::string photoSearchJson(const PhotoSearchResult& result) {
    Json root;
    root["schema"] = "fodscope.photo-search/1";
    root["recall_wanted"] = rounded(result.settings.recall);
    root["trials"] = result.trialCount;
    root["fods"] = result.fodCount;
    root["metric"] = nameOf(result.settings.grid.metric);
    root["linkage"] = nameOf(result.settings.grid.linkage);
    root["grid_points"] = result.outcomes.size();
    root["grid_points_left_out"] = leftOut(result);
    root["best"] = result.best ? jsonOf(result, *result.best) : Json();
    root["curve"] = Json::array();
    for (const PhotoChoice& choice : result.curve)
        root["curve"].push_back(jsonOf(result, choice));
    return root.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace fodscope
