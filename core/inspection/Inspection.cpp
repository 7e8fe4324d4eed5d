// SPDX-License-Identifier: MIT
#include "core/inspection/Inspection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/common/Error.h"
#include "core/common/Hash.h"
#include "core/inspection/CandidateIds.h"

namespace fodscope {
namespace {

bool isBlank(const std::string& text) {
    return text.find_first_not_of(" \t\r\n") == std::string::npos;
}

/// Voxel indices mean the same in two fields only when the voxels do.
bool sameVoxels(const DetectionRecord& earlier, const DetectionResult& later) {
    return earlier.field && later.field &&
           (earlier.field == later.field || earlier.field->points == later.field->points);
}

std::string photoIdOf(std::size_t number) {
    char text[32];
    std::snprintf(text, sizeof text, "P-%03zu", number);
    return text;
}

bool isBox(const PixelBox& box) {
    const bool finite = std::isfinite(box.left_px) && std::isfinite(box.top_px) && std::isfinite(box.width_px) &&
                        std::isfinite(box.height_px);
    return finite && box.width_px > 0.0 && box.height_px > 0.0;
}

void checkLabels(const LabelSet& labelSet, const std::vector<PhotoLabel>& labels, const std::string& photoId) {
    if (labels.empty()) throw Error(photoId, "the decision has no label", "give at least one label");
    for (const PhotoLabel& label : labels) {
        const Label* known = labelSet.find(label.label);
        if (known == nullptr) {
            throw Error(photoId, "the label set \"" + labelSet.name + "\" has no label \"" + label.label + "\"",
                        "choose one of its labels");
        }
        if (known->kind == LabelKind::NoFod && labels.size() > 1) {
            throw Error(photoId, std::string("`") + kNoFod + "` stands beside other labels",
                        "decide for one or the other");
        }
        if (label.box && !isBox(*label.box)) {
            throw Error(photoId, "the box of \"" + label.label + "\" has no extent", "draw it anew");
        }
    }
}

}  // namespace

Inspection::Inspection(InspectionState state, Journal& journal) : state_(std::move(state)), journal_(journal) {}

void Inspection::requireUnfrozen(const std::string& what) const {
    if (!candidatesAreFrozen()) return;
    throw Error(what, "cannot change any more: the visits have begun and the candidates are frozen",
                "start a new inspection for another detection");
}

void Inspection::setHeader(const InspectionHeader& header) {
    journal_.recordHeader(header);
    state_.header = header;
}

void Inspection::setReference(const SourceFile& source, std::shared_ptr<const ReferenceMap> reference) {
    requireUnfrozen("reference map");
    if (!reference || reference->points.empty()) {
        throw Error(source.path, "the reference map has no points", "choose another reference map");
    }
    journal_.recordReference(source, *reference);
    applyReference(state_, source, std::move(reference));
}

void Inspection::setMap(const SourceFile& source) {
    requireUnfrozen("map");
    journal_.recordMap(source);
    applyMap(state_, source);
}

void Inspection::setParameters(const Parameters& parameters) {
    if (parameters == state_.parameters) return;
    journal_.recordParameters(parameters);
    state_.parameters = parameters;
}

void Inspection::adoptDetection(const Parameters& parameters, const DetectionResult& result) {
    requireUnfrozen("candidates");
    DetectionRecord record;
    record.parameters = parameters;
    record.registration = result.registration;
    record.floorHeight_m = result.floorHeight_m;
    record.field = result.field;
    record.coverage = result.coverage;
    int highest = state_.highestCandidateNumber;
    if (result.candidates) {
        auto candidates = std::make_shared<CandidateSet>(*result.candidates);
        const bool carriesOver =
            state_.detection && state_.detection->candidates && sameVoxels(*state_.detection, result);
        carryOverIds(carriesOver ? *state_.detection->candidates : CandidateSet(), *candidates, highest);
        record.candidates = std::move(candidates);
    }
    journal_.recordDetection(record, highest);
    applyDetection(state_, record, highest);
}

bool Inspection::candidatesAreFrozen() const {
    return visitsHaveBegun(state_);
}

void Inspection::adoptPlan(const OccupancyGrid& grid_map, const VisitPlan& plan) {
    requireUnfrozen("plan");
    if (!state_.detection || !state_.detection->candidates || state_.detection->candidates->candidates.empty()) {
        throw Error("plan", "there are no candidates to visit", "lower the threshold or issue the report as it is");
    }
    std::vector<Visit> visits;
    for (const Waypoint& waypoint : plan.waypoints) {
        Visit visit;
        visit.waypointId = waypoint.id;
        visits.push_back(visit);
    }
    journal_.recordPlan(grid_map, plan, visits);
    applyPlan(state_, grid_map, plan, visits);
}

void Inspection::setRoute(InspectionRoute route) {
    route.highestNumber = state_.route.highestNumber;
    for (RoutePose& pose : route.poses) {
        const auto before = std::ranges::find(state_.route.poses, pose.id, &RoutePose::id);
        const bool isKnown = before != state_.route.poses.end();
        const Visit* visit = findVisit(state_, pose.id);
        if (!isKnown || (*before != pose && visit != nullptr && visit->tries > 0)) pose.id.clear();
    }
    route = numbered(std::move(route));
    std::vector<Visit> visits;
    for (const RoutePose& pose : route.poses) {
        const auto known = std::ranges::find(state_.routeVisits, pose.id, &Visit::waypointId);
        Visit visit;
        visit.waypointId = pose.id;
        visits.push_back(known == state_.routeVisits.end() ? visit : *known);
    }
    if (route == state_.route) return;
    journal_.recordRoute(route, visits);
    applyRoute(state_, route, visits);
}

void Inspection::updateVisit(const Visit& visit) {
    const Visit* known = findVisit(state_, visit.waypointId);
    if (known == nullptr) {
        throw Error(visit.waypointId, "the plan has no such waypoint", "plan the visits again");
    }
    if (*known == visit) return;
    journal_.recordVisit(visit);
    applyVisit(state_, visit);
}

void Inspection::resumeVisits() {
    const std::vector<PhotoMark> kept = photoMarks(state_);
    for (const std::vector<Visit>& visits :
         {resumedVisits(state_.visits, kept), resumedVisits(state_.routeVisits, kept)})
        for (const Visit& visit : visits)
            updateVisit(visit);
}

const Photo& Inspection::addPhoto(Photo photo) {
    if (photo.bytes.empty()) throw Error("photo", "the robot sent an empty photo", "take it again");
    photo.id = photoIdOf(state_.photos.size() + 1);
    photo.sha256 = sha256(photo.bytes);
    state_.photos.reserve(state_.photos.size() + 1);
    journal_.recordPhoto(photo);
    state_.photos.push_back(std::move(photo));
    return state_.photos.back();
}

void Inspection::setLabelSet(const LabelSet& labelSet) {
    if (labelSet == state_.labelSet) return;
    journal_.recordLabelSet(labelSet);
    state_.labelSet = labelSet;
}

void Inspection::decide(const std::string& photoId, const std::string& labeller, const std::vector<PhotoLabel>& labels,
                        const std::string& comment, UtcTime time) {
    if (findPhoto(state_, photoId) == nullptr) {
        throw Error(photoId, "this inspection has no such photo", "choose one of its photos");
    }
    if (isBlank(labeller)) throw Error(photoId, "the decision has no labeller", "give your name");
    checkLabels(state_.labelSet, labels, photoId);
    Decision decision;
    decision.photoId = photoId;
    decision.labeller = labeller;
    decision.time = time;
    decision.labels = labels;
    decision.comment = comment;
    state_.decisions.reserve(state_.decisions.size() + 1);
    journal_.recordDecision(decision);
    state_.decisions.push_back(std::move(decision));
}

std::optional<std::string> Inspection::undoDecision(const std::string& labeller, UtcTime time) {
    const std::optional<Decision> undo = undoOf(state_.decisions, labeller, time);
    if (!undo) return std::nullopt;
    journal_.recordDecision(*undo);
    state_.decisions.push_back(*undo);
    return undo->photoId;
}

void Inspection::reportIssued(const ReportRecord& report) {
    journal_.recordReport(report);
    state_.reports.push_back(report);
}

}  // namespace fodscope
