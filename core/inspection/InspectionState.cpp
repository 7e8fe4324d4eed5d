// SPDX-License-Identifier: MIT
#include "core/inspection/InspectionState.h"

#include <algorithm>
#include <random>

#include "core/common/Version.h"
#include "core/inspection/BoxOwners.h"

namespace fodscope {
namespace {

std::string randomId() {
    constexpr const char* kDigits = "0123456789abcdef";
    std::random_device random;
    std::uniform_int_distribution<int> digit(0, 15);
    std::string id;
    for (int i = 0; i < 32; ++i) {
        id += kDigits[digit(random)];
    }
    return id;
}

void dropPlan(InspectionState& state) {
    state.grid_map.reset();
    state.plan.reset();
    state.visits.clear();
}

void dropDetection(InspectionState& state) {
    state.detection.reset();
    dropPlan(state);
}

/// Without a fingerprint nobody can tell, so it counts as another.
bool isAnother(const std::optional<SourceFile>& before, const SourceFile& now) {
    return !before || now.sha256.empty() || before->sha256 != now.sha256;
}

bool hasBegun(const Visit& visit) {
    return visit.state != VisitState::Draft || visit.tries > 0 || !visit.goalId.empty();
}

}  // namespace

InspectionHeader newInspectionHeader() {
    InspectionHeader header;
    header.id = randomId();
    header.created = UtcTime::now();
    header.softwareVersion = kVersion;
    return header;
}

void applyReference(InspectionState& state, const SourceFile& source, std::shared_ptr<const ReferenceMap> reference) {
    if (isAnother(state.referenceSource, source)) dropDetection(state);
    state.referenceSource = source;
    state.reference = std::move(reference);
}

void applyMap(InspectionState& state, const SourceFile& source) {
    if (isAnother(state.mapSource, source)) dropDetection(state);
    state.mapSource = source;
}

void applyDetection(InspectionState& state, const DetectionRecord& detection, int highestCandidateNumber) {
    dropPlan(state);
    state.parameters = detection.parameters;
    state.detection = detection;
    state.highestCandidateNumber = highestCandidateNumber;
}

void applyPlan(InspectionState& state, const OccupancyGrid& grid_map, const VisitPlan& plan,
               const std::vector<Visit>& visits) {
    state.grid_map = grid_map;
    state.plan = plan;
    state.visits = visits;
}

void applyRoute(InspectionState& state, const InspectionRoute& route, const std::vector<Visit>& visits) {
    state.route = route;
    state.routeVisits = visits;
}

bool applyVisit(InspectionState& state, const Visit& visit) {
    for (std::vector<Visit>* visits : {&state.visits, &state.routeVisits}) {
        const auto found = std::ranges::find(*visits, visit.waypointId, &Visit::waypointId);
        if (found == visits->end()) continue;
        *found = visit;
        return true;
    }
    return false;
}

bool visitsHaveBegun(const InspectionState& state) {
    return std::ranges::any_of(state.visits, hasBegun) ||
           std::ranges::any_of(state.photos, [](const Photo& photo) { return !isRoutePose(photo.waypointId); });
}

const Visit* findVisit(const InspectionState& state, const std::string& waypointId) {
    for (const std::vector<Visit>* visits : {&state.visits, &state.routeVisits}) {
        const auto found = std::ranges::find(*visits, waypointId, &Visit::waypointId);
        if (found != visits->end()) return &*found;
    }
    return nullptr;
}

std::vector<PhotoMark> photoMarks(const InspectionState& state) {
    std::vector<PhotoMark> marks;
    for (const Photo& photo : state.photos)
        marks.push_back({photo.requestId, photo.sha256});
    return marks;
}

const Photo* findPhoto(const InspectionState& state, const std::string& photoId) {
    const auto found = std::ranges::find(state.photos, photoId, &Photo::id);
    return found == state.photos.end() ? nullptr : &*found;
}

std::vector<CandidateVerdict> verdictsOf(const InspectionState& state) {
    if (!state.detection || !state.detection->candidates) return {};
    std::vector<std::string> ids;
    for (const Candidate& candidate : state.detection->candidates->candidates) {
        ids.push_back(candidate.id);
    }
    const std::vector<OwnedDecision> owned = ownDecisions(state);
    std::vector<CandidateVerdict> verdicts;
    for (const std::string& id : ids) {
        const auto [photos, decisions] = wordsOn(id, state, owned);
        const std::vector<std::string> one{id};
        verdicts.push_back(resolveVerdicts(one, photos, decisions, state.labelSet).front());
    }
    return verdicts;
}

}  // namespace fodscope
