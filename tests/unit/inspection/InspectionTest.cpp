// SPDX-License-Identifier: MIT
#include "core/inspection/Inspection.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/common/Error.h"
#include "core/common/Hash.h"
#include "tests/fakes/MemoryJournal.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

using test::MemoryJournal;

std::vector<std::string> idsOf(const Inspection& inspection) {
    std::vector<std::string> ids;
    for (const Candidate& candidate : inspection.state().detection->candidates->candidates) {
        ids.push_back(candidate.id);
    }
    return ids;
}

/// The sample's voxels 2 and 3 as the only candidate.
DetectionResult onlySecondCluster() {
    DetectionResult result = test::sampleDetection();
    auto candidates = std::make_shared<CandidateSet>(*result.candidates);
    candidates->candidates.erase(candidates->candidates.begin());
    candidates->candidates[0].id = "C-001";
    candidates->candidateOfVoxel = {-1, -1, 0, 0, -1};
    result.candidates = candidates;
    return result;
}

TEST(Inspection, EveryActGoesToTheJournalInItsOrder) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    test::fillInspection(inspection);
    EXPECT_EQ(journal.acts, (std::vector<std::string>{"header", "reference", "map", "detection", "parameters", "plan",
                                                      "visit", "visit", "visit", "photo", "photo", "label set",
                                                      "decision", "decision", "decision", "report"}));
}

TEST(Inspection, NothingChangesWhenTheJournalFails) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.setLabelSet(test::sampleLabels());
    inspection.adoptDetection(Parameters(), test::sampleDetection());
    inspection.adoptPlan(test::sampleGrid(), test::samplePlan());
    const Inspection fresh({}, journal);
    const InspectionState planned = inspection.state();
    inspection.addPhoto(test::samplePhoto("W-01", "C-001", "photo"));
    inspection.decide("P-001", "Anna", {{"hammer", std::nullopt}}, "", {1});
    const InspectionState before = inspection.state();

    journal.diskIsFull = true;
    Parameters other;
    other.candidates.threshold = 9.0;
    const std::vector<std::function<void()>> acts{
        [&] { inspection.setHeader(test::sampleHeader()); },
        [&] { inspection.setParameters(other); },
        [&] {
            inspection.updateVisit({"W-01", VisitState::Driving, "g", {}, "", 1, 0});
        },
        [&] { inspection.addPhoto(test::samplePhoto("W-01", "C-001", "photo")); },
        [&] {
            inspection.setLabelSet({"Other", {}});
        },
        [&] {
            inspection.decide("P-001", "Anna", {{"drill", std::nullopt}}, "", {2});
        },
        [&] { inspection.undoDecision("Anna", {3}); },
        [&] {
            inspection.reportIssued({{4}, "Anna", "report.pdf", ""});
        },
    };
    for (const auto& act : acts) {
        EXPECT_THROW(act(), Error);
        test::expectEqual(inspection.state(), before);
    }

    Inspection unfrozen(planned, journal);
    const std::vector<std::function<void()>> earlyActs{
        [&] {
            unfrozen.setReference({"r.ply", "", 3}, std::make_shared<const ReferenceMap>(test::sampleReference()));
        },
        [&] {
            unfrozen.setMap({"m.pcd", "", 3});
        },
        [&] { unfrozen.adoptDetection(other, test::sampleDetection()); },
        [&] { unfrozen.adoptPlan(test::sampleGrid(), test::samplePlan()); },
    };
    for (const auto& act : earlyActs) {
        EXPECT_THROW(act(), Error);
        test::expectEqual(unfrozen.state(), planned);
    }
    test::expectEqual(fresh.state(), {});
}

TEST(Inspection, CandidatesKeepTheirIdsWhileTuning) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.adoptDetection(Parameters(), test::sampleDetection());
    EXPECT_EQ(idsOf(inspection), (std::vector<std::string>{"C-001", "C-002"}));
    inspection.adoptDetection(Parameters(), onlySecondCluster());
    EXPECT_EQ(idsOf(inspection), (std::vector<std::string>{"C-002"}));
    inspection.adoptDetection(Parameters(), test::sampleDetection());
    EXPECT_EQ(idsOf(inspection), (std::vector<std::string>{"C-003", "C-002"}));
    EXPECT_EQ(inspection.state().highestCandidateNumber, 3);
}

TEST(Inspection, IdsAreNotCarriedOverToOtherVoxels) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.adoptDetection(Parameters(), test::sampleDetection());
    DetectionResult other = test::sampleDetection();
    auto field = std::make_shared<DiscrepancyField>(*other.field);
    field->points[0].x() += 0.01;
    other.field = field;
    inspection.adoptDetection(Parameters(), other);
    EXPECT_EQ(idsOf(inspection), (std::vector<std::string>{"C-003", "C-004"}));
}

TEST(Inspection, CandidatesFreezeWhenTheVisitsBegin) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.adoptDetection(Parameters(), test::sampleDetection());
    inspection.adoptPlan(test::sampleGrid(), test::samplePlan());
    EXPECT_FALSE(inspection.candidatesAreFrozen());
    inspection.adoptPlan(test::sampleGrid(), test::samplePlan());
    inspection.updateVisit({"W-01", VisitState::Sent, "goal-1", {}, "", 1, 0});
    EXPECT_TRUE(inspection.candidatesAreFrozen());
    const auto acts = journal.acts;
    EXPECT_THROW(inspection.adoptDetection(Parameters(), test::sampleDetection()), Error);
    EXPECT_THROW(inspection.adoptPlan(test::sampleGrid(), test::samplePlan()), Error);
    EXPECT_THROW(inspection.setMap({"other.pcd", "x", 1}), Error);
    EXPECT_EQ(journal.acts, acts);
    // A visit that is put back to be driven again has begun all the same.
    inspection.updateVisit({"W-01", VisitState::Draft, "", {}, "", 1, 0});
    EXPECT_TRUE(inspection.candidatesAreFrozen());
}

TEST(Inspection, ADetectionMakesThePlanForEarlierCandidatesVoid) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.adoptDetection(Parameters(), test::sampleDetection());
    inspection.adoptPlan(test::sampleGrid(), test::samplePlan());
    inspection.adoptDetection(Parameters(), onlySecondCluster());
    EXPECT_FALSE(inspection.state().plan.has_value());
    EXPECT_FALSE(inspection.state().grid_map.has_value());
    EXPECT_TRUE(inspection.state().visits.empty());
}

TEST(Inspection, ThereIsNothingToPlanWithoutCandidates) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    EXPECT_THROW(inspection.adoptPlan(test::sampleGrid(), test::samplePlan()), Error);
    inspection.adoptDetection(Parameters(), DetectionResult());
    EXPECT_THROW(inspection.adoptPlan(test::sampleGrid(), test::samplePlan()), Error);
}

TEST(Inspection, PhotosGetIdsInOrderAndTheFingerprintOfTheirBytes) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    EXPECT_EQ(inspection.addPhoto(test::samplePhoto("W-01", "C-001", "abc")).id, "P-001");
    const Photo& second = inspection.addPhoto(test::samplePhoto("W-02", "C-002", "abc"));
    EXPECT_EQ(second.id, "P-002");
    EXPECT_EQ(second.sha256, sha256(std::string_view("abc")));
    EXPECT_THROW(inspection.addPhoto(Photo()), Error);
    EXPECT_EQ(inspection.state().photos.size(), 2u);
}

TEST(Inspection, DecisionsThatMeanNothingAreRefused) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.setLabelSet(test::sampleLabels());
    inspection.addPhoto(test::samplePhoto("W-01", "C-001", "photo"));
    const auto decide = [&](const std::string& photo, const std::string& labeller,
                            const std::vector<PhotoLabel>& labels) {
        inspection.decide(photo, labeller, labels, "", {1});
    };
    EXPECT_THROW(decide("P-002", "Anna", {{"hammer", std::nullopt}}), Error);
    EXPECT_THROW(decide("P-001", " ", {{"hammer", std::nullopt}}), Error);
    EXPECT_THROW(decide("P-001", "Anna", {}), Error);
    EXPECT_THROW(decide("P-001", "Anna", {{"wrench", std::nullopt}}), Error);
    EXPECT_THROW(decide("P-001", "Anna", {{"hammer", std::nullopt}, {kNoFod, std::nullopt}}), Error);
    EXPECT_THROW(decide("P-001", "Anna", {{"hammer", PixelBox{1, 1, 0, 5}}}), Error);
    EXPECT_TRUE(inspection.state().decisions.empty());
    decide("P-001", "Anna", {{"hammer", PixelBox{1, 1, 4, 5}}, {"hammer", PixelBox{10, 1, 4, 5}}});
    EXPECT_EQ(inspection.state().decisions.size(), 1u);
}

TEST(Inspection, UndoRestoresWhatCountedBeforeAndKeepsTheRecord) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.setLabelSet(test::sampleLabels());
    inspection.addPhoto(test::samplePhoto("W-01", "C-001", "photo"));
    EXPECT_FALSE(inspection.undoDecision("Anna", {0}));
    inspection.decide("P-001", "Anna", {{"hammer", std::nullopt}}, "seen well", {1});
    inspection.decide("P-001", "Anna", {{kNoFod, std::nullopt}}, "", {2});
    EXPECT_EQ(inspection.undoDecision("Anna", {3}), "P-001");
    const Decision* counts = lastDecision(inspection.state().decisions, "P-001", "Anna");
    ASSERT_NE(counts, nullptr);
    EXPECT_EQ(counts->labels[0].label, "hammer");
    EXPECT_EQ(counts->comment, "seen well");
    EXPECT_EQ(inspection.undoDecision("Anna", {4}), "P-001");
    EXPECT_EQ(lastDecision(inspection.state().decisions, "P-001", "Anna"), nullptr);
    EXPECT_FALSE(inspection.undoDecision("Anna", {5}));
    EXPECT_EQ(inspection.state().decisions.size(), 4u);
}

TEST(Inspection, WhatDoesNotChangeIsNoAct) {
    MemoryJournal journal;
    Inspection inspection({}, journal);
    inspection.setParameters(Parameters());
    inspection.setLabelSet(LabelSet());
    EXPECT_TRUE(journal.acts.empty());
    EXPECT_THROW(inspection.updateVisit({"W-99", VisitState::Sent, "", {}, "", 1, 0}), Error);
}

TEST(Inspection, NewHeadersHaveIdsOfTheirOwn) {
    const InspectionHeader header = newInspectionHeader();
    EXPECT_EQ(header.id.size(), 32u);
    EXPECT_EQ(header.id.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_NE(header.id, newInspectionHeader().id);
    EXPECT_GT(header.created.milliseconds, 0);
    EXPECT_FALSE(header.softwareVersion.empty());
}

}  // namespace
}  // namespace fodscope
