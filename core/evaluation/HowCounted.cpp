// SPDX-License-Identifier: MIT
#include "core/evaluation/EvaluationReport.h"
#include "core/evaluation/Summary.h"
#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string plain(double value) {
    std::string text = std::to_string(value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return text;
}

/// E.g. ": 3 hidden, 1 unreachable"; what is not among them failed on the drive.
std::string reasonsOf(const PhotoSummary& photos) {
    std::string text;
    std::size_t told = 0;
    for (const auto& [reason, count] : photos.reasons) {
        text += (text.empty() ? ": " : ", ") + std::to_string(count) + " " + reason;
        told += count;
    }
    if (told < photos.candidatesWithoutPhoto)
        text += (text.empty() ? ": " : ", ") + std::to_string(photos.candidatesWithoutPhoto - told) +
                " whose visit failed";
    return text;
}

void sayPhotos(const EvaluationSummary& summary, std::vector<std::string>& lines) {
    if (!summary.photos) return;
    lines.push_back(
        "Photos: every candidate was visited by the simulated robot in the trial's world; one photo may show several "
        "candidates, and a large candidate may take several photos. A FOD is on a photo when at least 200 of its "
        "1280x720 pixels show it. Precision is photos that show FOD over all photos, recall is FOD on at least one "
        "photo over all FOD, photos per FOD is all photos over all FOD. The metres are the planned drives along the "
        "cost map, summed over the trials; always to the nearest waypoint left, they would be " +
        fixed(summary.photos->nearestNext_m, 1) + ".");
    if (summary.photos->candidatesWithoutPhoto > 0)
        lines.push_back(std::to_string(summary.photos->candidatesWithoutPhoto) +
                        " candidates were not photographed" + reasonsOf(*summary.photos) + ".");
    if (summary.photos->candidatesInPart > 0)
        lines.push_back(std::to_string(summary.photos->candidatesInPart) +
                        " candidates are on photos only in part: the rest is out of the camera's picture, or hidden.");
}

}  // namespace

std::vector<std::string> howCounted(const Evaluation& evaluation) {
    const EvaluationSummary summary = summarize(evaluation.trials);
    std::vector<std::string> lines;
    lines.push_back(
        std::to_string(evaluation.trials.size()) + " trials with " + std::to_string(summary.fods) +
        " FOD. Nominal maps (without FOD) left out of every figure: " + std::to_string(evaluation.nominalMaps.size()) +
        (evaluation.nominalMaps.empty() ? "." : " (" + joined(evaluation.nominalMaps) + ")."));
    lines.push_back(evaluation.settings.placement == TrialPlacement::Stored
                        ? "Each map was placed by its stored T_cad_from_map; nothing was registered."
                        : "Each map was registered by the program, from T_cad_from_map_initial where there is one.");
    if (!summary.failedTrials.empty())
        lines.push_back(
            "Failed to register: " + joined(summary.failedTrials) +
            ". Nothing is known of candidates there, so these trials are in no count of candidates or points; their "
            "FOD were not found: they count as missed in the recalls and are charged 7.5 m.");
    lines.push_back(
        "Distances are 3-D, from a FOD's gt_centroid_map to the nearest candidate's centroid; a tie goes to the lower "
        "id. All FOD count, observed in the map or not; 'observed' recalls take only those that are.");
    lines.push_back(
        "A candidate is associated when it is the nearest one of at least one FOD, however far it lies. Unassociated "
        "points are the voxels above the threshold, before clustering, that are not in an associated candidate. A "
        "false candidate lies farther than 0.3 m from every FOD: the honest count.");
    lines.push_back(
        "Cost of a trial: mean distance of its FOD + " + plain(evaluation.settings.lambda) +
        " x unassociated candidates; mean cost: the mean over the trials. A FOD in a trial without candidates is "
        "charged 7.5 m in the cost and in the distance error (" +
        std::to_string(summary.chargedFods) + " FOD here).");
    lines.push_back("Plus-minus is the standard deviation (n - 1) over trials, for the distance error over FOD.");
    lines.push_back(
        "A registration's corner error is its greatest displacement of a corner of the reference's bounds against the "
        "stored T_cad_from_map; it says nothing where the reference is not in the CAD's frame.");
    lines.push_back("Recall at 0.15 m and 0.30 m: share of FOD with a candidate at most so far away, over all trials.");
    sayPhotos(summary, lines);
    return lines;
}

}  // namespace fodscope
