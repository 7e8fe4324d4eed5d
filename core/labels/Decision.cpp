// SPDX-License-Identifier: MIT
#include "core/labels/Decision.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace fodscope {
namespace {

enum class PhotoVerdict { Waiting, Open, NoFod, Fod };

std::set<std::string> distinctLabels(const Decision& decision) {
    std::set<std::string> names;
    for (const PhotoLabel& label : decision.labels) {
        names.insert(label.label);
    }
    return names;
}

bool names(const Decision& decision, LabelKind kind, const LabelSet& labels) {
    return std::ranges::any_of(decision.labels,
                               [&](const PhotoLabel& label) { return kindOf(labels, label.label) == kind; });
}

PhotoVerdict verdictOfPhoto(const std::vector<const Decision*>& counting, const LabelSet& labels) {
    if (counting.empty()) return PhotoVerdict::Waiting;
    const auto first = distinctLabels(*counting.front());
    for (const Decision* decision : counting) {
        if (names(*decision, LabelKind::NotSure, labels) || distinctLabels(*decision) != first)
            return PhotoVerdict::Open;
    }
    return names(*counting.front(), LabelKind::Fod, labels) ? PhotoVerdict::Fod : PhotoVerdict::NoFod;
}

void addFodLabels(const std::vector<const Decision*>& counting, const LabelSet& labels,
                  std::vector<std::string>& fodLabels) {
    for (const Decision* decision : counting) {
        for (const PhotoLabel& label : decision->labels) {
            const bool isNew = std::ranges::find(fodLabels, label.label) == fodLabels.end();
            if (isNew && kindOf(labels, label.label) == LabelKind::Fod) fodLabels.push_back(label.label);
        }
    }
}

Verdict combined(const std::vector<PhotoVerdict>& photos) {
    const auto any = [&](PhotoVerdict verdict) { return std::ranges::find(photos, verdict) != photos.end(); };
    if (photos.empty()) return Verdict::NotPhotographed;
    if (any(PhotoVerdict::Fod)) return Verdict::Finding;
    if (any(PhotoVerdict::Open)) return Verdict::Open;
    return any(PhotoVerdict::Waiting) ? Verdict::Undecided : Verdict::NoFod;
}

}  // namespace

std::string toString(Verdict verdict) {
    switch (verdict) {
        case Verdict::NotPhotographed:
            return "not photographed";
        case Verdict::Undecided:
            return "undecided";
        case Verdict::Open:
            return "open";
        case Verdict::NoFod:
            return "no FOD";
        case Verdict::Finding:
            return "finding";
    }
    return "unknown";
}

const Decision* lastDecision(std::span<const Decision> decisions, const std::string& photoId,
                             const std::string& labeller) {
    for (auto decision = decisions.rbegin(); decision != decisions.rend(); ++decision) {
        if (decision->photoId == photoId && decision->labeller == labeller) {
            return decision->labels.empty() ? nullptr : &*decision;
        }
    }
    return nullptr;
}

std::vector<const Decision*> countingDecisions(std::span<const Decision> decisions, const std::string& photoId) {
    std::vector<const Decision*> counting;
    std::set<std::string> readers;
    for (const Decision& decision : decisions) {
        if (decision.photoId != photoId || !readers.insert(decision.labeller).second) continue;
        if (const Decision* last = lastDecision(decisions, photoId, decision.labeller)) counting.push_back(last);
    }
    return counting;
}

std::vector<CandidateVerdict> resolveVerdicts(std::span<const std::string> candidateIds,
                                              std::span<const PhotoSubject> photos, std::span<const Decision> decisions,
                                              const LabelSet& labels) {
    std::vector<CandidateVerdict> verdicts;
    for (const std::string& id : candidateIds) {
        CandidateVerdict result{id, Verdict::NotPhotographed, {}};
        std::vector<PhotoVerdict> photoVerdicts;
        std::vector<std::string> resolvedLabels;
        std::vector<std::string> namedLabels;
        for (const PhotoSubject& photo : photos) {
            if (std::ranges::find(photo.candidateIds, id) == photo.candidateIds.end()) continue;
            const auto counting = countingDecisions(decisions, photo.photoId);
            photoVerdicts.push_back(verdictOfPhoto(counting, labels));
            addFodLabels(counting, labels, namedLabels);
            if (photoVerdicts.back() == PhotoVerdict::Fod) addFodLabels(counting, labels, resolvedLabels);
        }
        result.verdict = combined(photoVerdicts);
        result.fodLabels = result.verdict == Verdict::Finding ? resolvedLabels : namedLabels;
        verdicts.push_back(std::move(result));
    }
    return verdicts;
}

std::optional<Decision> undoOf(std::span<const Decision> decisions, const std::string& labeller, UtcTime time) {
    std::vector<const Decision*> acts;
    for (const Decision& decision : decisions) {
        if (decision.labeller != labeller) continue;
        if (!decision.takesBack) {
            acts.push_back(&decision);
        } else if (!acts.empty()) {
            acts.pop_back();
        }
    }
    if (acts.empty()) return std::nullopt;
    Decision undo;
    undo.photoId = acts.back()->photoId;
    undo.labeller = labeller;
    undo.time = time;
    undo.takesBack = true;
    const auto earlier = std::find_if(std::next(acts.rbegin()), acts.rend(),
                                      [&](const Decision* act) { return act->photoId == undo.photoId; });
    if (earlier != acts.rend()) {
        undo.labels = (*earlier)->labels;
        undo.comment = (*earlier)->comment;
    }
    return undo;
}

}  // namespace fodscope
