// SPDX-License-Identifier: MIT
#include "core/inspection/ReportCandidates.h"

#include <algorithm>

#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

std::vector<const Photo*> photosOf(const InspectionState& state, const std::string& candidateId) {
    std::vector<const Photo*> photos;
    for (const Photo& photo : state.photos) {
        if (std::ranges::find(photo.candidateIds, candidateId) != photo.candidateIds.end()) photos.push_back(&photo);
    }
    return photos;
}

std::string labelsOf(const Decision& decision) {
    std::vector<std::string> names;
    for (const PhotoLabel& label : decision.labels) {
        names.push_back(label.label);
    }
    return joined(names, " and ");
}

/// Each reader's last decision on each of the candidate's photos.
std::vector<std::string> decisionLines(const InspectionState& state, const std::vector<const Photo*>& photos) {
    std::vector<std::string> lines;
    for (const Photo* photo : photos) {
        for (const Decision* decision : countingDecisions(state.decisions, photo->id)) {
            std::string line = decision->labeller + ": " + labelsOf(*decision) + ", " + timeText(decision->time);
            if (photos.size() > 1) line += ", " + photo->id;
            if (!decision->comment.empty()) line += " (" + decision->comment + ")";
            lines.push_back(line);
        }
    }
    return lines;
}

const Waypoint* waypointOf(const InspectionState& state, const std::string& candidateId) {
    if (!state.plan) return nullptr;
    const auto found = std::ranges::find_if(state.plan->waypoints, [&](const Waypoint& waypoint) {
        return std::ranges::find(waypoint.candidateIds, candidateId) != waypoint.candidateIds.end();
    });
    return found == state.plan->waypoints.end() ? nullptr : &*found;
}

std::ptrdiff_t photosPlanned(const InspectionState& state, const std::string& candidateId) {
    if (!state.plan) return 0;
    return std::ranges::count_if(state.plan->waypoints, [&](const Waypoint& waypoint) {
        return waypoint.pose_map &&
               std::ranges::find(waypoint.candidateIds, candidateId) != waypoint.candidateIds.end();
    });
}

/// What is to be said where the plan does not show the whole candidate; empty where it does.
std::string plannedPart(const InspectionState& state, const std::string& candidateId) {
    if (!state.plan) return {};
    const auto view = std::ranges::find(state.plan->views, candidateId, &CandidateView::candidateId);
    if (view == state.plan->views.end() || view->rest == WaypointStatus::Ok || view->share == 0.0) return {};
    return percent(view->share) + " of it; the rest is " + toString(view->rest);
}

std::string reasonWithoutPhoto(const InspectionState& state, const std::string& candidateId) {
    const Waypoint* waypoint = waypointOf(state, candidateId);
    if (waypoint == nullptr) return "no visit was planned";
    if (waypoint->status != WaypointStatus::Ok) {
        return "no place was found to photograph it from: " + toString(waypoint->status);
    }
    const auto visit = std::ranges::find(state.visits, waypoint->id, &Visit::waypointId);
    if (visit == state.visits.end() || visit->state == VisitState::Draft) return "it has not been visited";
    const std::string why = reasonText(*visit).empty() ? std::string() : ": " + reasonText(*visit);
    return "the visit " + waypoint->id + " is " + toString(visit->state) + why;
}

bool anyoneNotSure(const InspectionState& state, const std::vector<const Photo*>& photos) {
    for (const Photo* photo : photos) {
        for (const Decision* decision : countingDecisions(state.decisions, photo->id)) {
            const bool notSure = std::ranges::any_of(decision->labels, [&](const PhotoLabel& label) {
                return kindOf(state.labelSet, label.label) == LabelKind::NotSure;
            });
            if (notSure) return true;
        }
    }
    return false;
}

std::string verdictText(const ReportCandidate& candidate, bool notSure) {
    switch (candidate.verdict) {
        case Verdict::Finding:
            return "FOD: " + candidate.labels;
        case Verdict::NoFod:
            return "decided: no FOD";
        case Verdict::Open:
            if (notSure) return "open: a reader is not sure";
            return "open: the readers disagree";
        case Verdict::Undecided:
            return "open: photos wait for a decision";
        case Verdict::NotPhotographed:
            return "open: no photo";
    }
    return kNotRecorded;
}

std::vector<ReportField> fieldsOf(const Candidate& candidate, Metric metric) {
    return {{"Size (length × width × height)", sizeText(candidate.size_m)},
            {"Height above the floor", length(candidate.heightAboveFloor_m)},
            {"Place in the reference frame", placeText(candidate.centroid_reference)},
            {"Place in the map frame", placeText(candidate.centroid_map)},
            {"Points (voxels)", std::to_string(candidate.voxels.size())},
            {"Greatest discrepancy", discrepancyText(candidate.discrepancyMax, metric)},
            {"Mean discrepancy", discrepancyText(candidate.discrepancyMean, metric)}};
}

}  // namespace

std::vector<ReportCandidate> reportCandidates(const InspectionState& state) {
    std::vector<ReportCandidate> list;
    const std::vector<CandidateVerdict> verdicts = verdictsOf(state);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        const Candidate& candidate = state.detection->candidates->candidates[i];
        const std::vector<const Photo*> photos = photosOf(state, candidate.id);
        ReportCandidate told;
        told.id = candidate.id;
        told.verdict = verdicts[i].verdict;
        told.labels = joined(verdicts[i].fodLabels, ", ");
        told.verdictText = verdictText(told, anyoneNotSure(state, photos));
        told.fields = fieldsOf(candidate, state.detection->parameters.candidates.metric);
        if (const std::string part = plannedPart(state, candidate.id); !part.empty())
            told.fields.push_back({"Planned to be photographed", part});
        for (const Photo* photo : photos) {
            told.photoIds.push_back(photo->id);
        }
        told.decisions = decisionLines(state, photos);
        if (photos.empty()) {
            told.noPhotoReason = reasonWithoutPhoto(state, candidate.id);
        } else if (told.verdict == Verdict::NotPhotographed) {
            told.noPhotoReason = photosPlanned(state, candidate.id) > 1
                                     ? "only a part of it was photographed"
                                     : "it lies outside the picture that was taken for it";
        }
        told.centroid_reference = candidate.centroid_reference;
        list.push_back(std::move(told));
    }
    return list;
}

}  // namespace fodscope
