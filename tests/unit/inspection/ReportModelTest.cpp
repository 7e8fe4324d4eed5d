// SPDX-License-Identifier: MIT
#include "core/inspection/ReportModel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "core/inspection/Inspection.h"
#include "core/inspection/ReportText.h"
#include "tests/fakes/MemoryJournal.h"
#include "tests/fakes/SampleInspection.h"

namespace fodscope {
namespace {

using testing::HasSubstr;

InspectionState sampleState() {
    test::MemoryJournal journal;
    Inspection inspection({}, journal);
    test::fillInspection(inspection);
    return inspection.state();
}

InspectionState stateWithoutFindings() {
    InspectionState state = sampleState();
    state.decisions.clear();
    for (const char* photo : {"P-001", "P-002"}) {
        state.decisions.push_back({photo, "Anna", {1'795'000'200'000}, {{kNoFod, std::nullopt}}, "", false});
    }
    return state;
}

void addAll(std::string& text, const std::vector<ReportField>& fields) {
    for (const ReportField& field : fields) {
        text += field.name + "\n" + field.value + "\n";
    }
}

void addAll(std::string& text, const std::vector<ReportCandidate>& candidates) {
    for (const ReportCandidate& candidate : candidates) {
        text += candidate.id + "\n" + candidate.verdictText + "\n" + candidate.noPhotoReason + "\n";
        text += joined(candidate.decisions, "\n");
        addAll(text, candidate.fields);
    }
}

std::string everythingIn(const ReportModel& model) {
    std::string text = model.title + "\n" + model.statement + "\n" + model.method + "\n";
    for (const auto* fields :
         {&model.inspection, &model.sources, &model.alignment, &model.coverage, &model.counts, &model.parameters}) {
        addAll(text, *fields);
    }
    for (const auto* candidates : {&model.findings, &model.open, &model.rejected}) {
        addAll(text, *candidates);
    }
    return text + joined(model.missing, "\n") + joined(model.limits, "\n");
}

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string valueOf(const std::vector<ReportField>& fields, const std::string& name) {
    const auto found = std::ranges::find(fields, name, &ReportField::name);
    return found == fields.end() ? "(no such field)" : found->value;
}

TEST(ReportModel, NeverClaimsThatThereIsNoFod) {
    InspectionState nothingFound = stateWithoutFindings();
    auto none = std::make_shared<CandidateSet>();
    none->candidateOfVoxel.assign(5, -1);
    InspectionState noCandidates = nothingFound;
    noCandidates.detection->candidates = none;
    InspectionState bad = nothingFound;
    bad.detection->candidates.reset();
    bad.detection->field.reset();
    bad.detection->coverage.reset();
    for (const InspectionState& state : {sampleState(), nothingFound, noCandidates, bad, InspectionState()}) {
        const std::string text =
            lowerCase(everythingIn(makeReportModel(state)) + sessionJson(state) + reportCsv(state));
        for (const char* claim : {"free of fod", "fod-free", "fod free", "free of foreign", "is clean", "is clear",
                                  "contains no fod", "there is no fod"}) {
            EXPECT_EQ(text.find(claim), std::string::npos) << claim;
        }
    }
}

TEST(ReportModel, StatesFindingsAndWhatWasObserved) {
    const ReportModel model = makeReportModel(sampleState());
    EXPECT_EQ(model.statement,
              "2 candidates: 1 finding, 1 open. 66 % of the reference surface was observed (within 10 cm of a point of "
              "the map, by point density; no sensor rays were used); nothing is said about the rest.");
    ASSERT_EQ(model.findings.size(), 1u);
    EXPECT_EQ(model.findings[0].id, "C-002");
    EXPECT_EQ(model.findings[0].labels, "hammer, drill");
    EXPECT_EQ(model.findings[0].verdictText, "FOD: hammer, drill");
    EXPECT_EQ(model.findings[0].photoIds, (std::vector<std::string>{"P-001", "P-002"}));
    EXPECT_EQ(model.findings[0].decisions,
              (std::vector<std::string>{"Anna: hammer and drill, 2026-11-18 11:10 UTC, P-001 (two, \"both\")"}));
    EXPECT_EQ(valueOf(model.findings[0].fields, "Size (length × width × height)"), "25 × 10 × 6 cm");
    EXPECT_EQ(valueOf(model.findings[0].fields, "Height above the floor"), "38 mm");
    ASSERT_EQ(model.open.size(), 1u);
    EXPECT_EQ(model.open[0].noPhotoReason, "no place was found to photograph it from: hidden");
    EXPECT_TRUE(model.missing.empty()) << joined(model.missing, "\n");
}

TEST(ReportModel, NoFindingIsNotPassedOffAsAllWell) {
    const ReportModel model = makeReportModel(stateWithoutFindings());
    EXPECT_THAT(model.statement, HasSubstr("2 candidates: no findings, 1 decided no FOD, 1 open."));
    EXPECT_THAT(model.statement, HasSubstr("No finding does not mean that no FOD is there"));
}

TEST(ReportModel, LimitsNameTheSmallestObjectAndWhatWasNotObserved) {
    const std::string limits = joined(makeReportModel(sampleState()).limits, "\n");
    EXPECT_THAT(limits, HasSubstr("smaller than about 40 mm (two voxels of the comparison)"));
    EXPECT_THAT(limits, HasSubstr("not observed (34 %)"));
    EXPECT_THAT(limits, HasSubstr("No sensor rays were used"));
    EXPECT_THAT(limits, HasSubstr("1 candidate has no photo"));
    EXPECT_THAT(limits, HasSubstr("1 reference point no nominal map supports"));
}

TEST(ReportModel, WhatNobodyRecordedIsSaidToBeNotRecorded) {
    const ReportModel model = makeReportModel(InspectionState());
    for (const auto* fields : {&model.inspection, &model.sources, &model.alignment, &model.coverage}) {
        for (const ReportField& field : *fields) {
            EXPECT_EQ(field.value, "not recorded") << field.name;
        }
    }
    EXPECT_THAT(model.statement, HasSubstr("nothing is said about FOD"));
    EXPECT_EQ(model.missing.size(), 4u);
}

TEST(ReportModel, ABadAlignmentClaimsNothing) {
    InspectionState state = sampleState();
    state.detection->candidates.reset();
    state.detection->registration.quality = RegistrationQuality::Bad;
    const ReportModel model = makeReportModel(state);
    EXPECT_THAT(model.statement, HasSubstr("no candidates are claimed"));
    EXPECT_TRUE(model.findings.empty() && model.open.empty() && model.rejected.empty());
    EXPECT_EQ(valueOf(model.alignment, "Alignment"), "bad: no candidates are claimed");
    EXPECT_EQ(valueOf(model.counts, "Findings"), "not known");
}

TEST(ReportModel, ADraftNamesWhatIsMissing) {
    InspectionState state = sampleState();
    state.header.inspector.clear();
    state.decisions.clear();
    state.visits[0].state = VisitState::Driving;
    EXPECT_EQ(makeReportModel(state).missing,
              (std::vector<std::string>{"The inspector's name is not recorded.", "1 visit has not been made.",
                                        "1 candidate waits for a decision on its photos."}));
}

/// The tables of RFC 4180 back into fields.
std::vector<std::vector<std::string>> parseCsv(const std::string& text) {
    std::vector<std::vector<std::string>> rows(1, {""});
    bool inQuotes = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inQuotes && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
            rows.back().back() += text[++i];
        } else if (c == '"') {
            inQuotes = !inQuotes;
        } else if (!inQuotes && c == ',') {
            rows.back().emplace_back();
        } else if (!inQuotes && c == '\r' && i + 1 < text.size() && text[i + 1] == '\n') {
            ++i;
            rows.push_back({""});
        } else {
            rows.back().back() += c;
        }
    }
    rows.pop_back();
    return rows;
}

TEST(ReportCsv, QuotesAsRfc4180Says) {
    InspectionState state = sampleState();
    state.decisions[0].comment = "a \"b\", c\r\nd";
    const auto rows = parseCsv(reportCsv(state));
    ASSERT_EQ(rows.size(), 3u);
    for (const auto& row : rows) {
        EXPECT_EQ(row.size(), rows[0].size());
    }
    EXPECT_EQ(rows[0][0], "candidate");
    EXPECT_EQ(rows[2][0], "C-002");
    EXPECT_EQ(rows[2][1], "finding");
    EXPECT_EQ(rows[2][2], "hammer, drill");
    EXPECT_EQ(rows[2][3], "1.0100");
    EXPECT_THAT(rows[2].back(), HasSubstr("(a \"b\", c\r\nd)"));
}

TEST(SessionJson, HoldsEverythingButTheBytes) {
    const auto json = nlohmann::json::parse(sessionJson(sampleState()));
    EXPECT_EQ(json.at("schema"), "fodscope.session/1");
    EXPECT_EQ(json.at("inspection").at("ship"), "USS \"Example\"");
    EXPECT_EQ(json.at("detection").at("candidates").size(), 2u);
    EXPECT_EQ(json.at("detection").at("candidates").at(1).at("verdict"), "finding");
    EXPECT_EQ(json.at("detection").at("registration").at("T_reference_from_map").at(3),
              nlohmann::json::array({0.0, 0.0, 0.0, 1.0}));
    EXPECT_EQ(json.at("waypoints").size(), 2u);
    EXPECT_TRUE(json.at("waypoints").at(1).at("pose_map").is_null());
    EXPECT_EQ(json.at("visits").at(1).at("state"), "skipped");
    EXPECT_EQ(json.at("photos").at(0).at("bytes"), 11);
    EXPECT_EQ(json.at("decisions").size(), 3u);
    EXPECT_EQ(json.at("decisions").at(2).at("undo"), true);
    EXPECT_EQ(json.at("parameters").at("candidates").at("threshold"), 2.9);
    EXPECT_EQ(json.at("reports").at(0).at("file"), "report.pdf");
}

TEST(SessionJson, IsValidForANewInspectionToo) {
    const auto json = nlohmann::json::parse(sessionJson(InspectionState()));
    EXPECT_TRUE(json.at("detection").is_null());
    EXPECT_TRUE(json.at("inspection").at("ship").is_null());
}

TEST(ReportText, SharesAreRoundedDownAndLengthsNameTheirUnit) {
    EXPECT_EQ(percent(0.83), "83 %");
    EXPECT_EQ(percent(0.999), "99 %");
    EXPECT_EQ(percent(1.0), "100 %");
    EXPECT_EQ(percent(std::nan("")), "not recorded");
    EXPECT_EQ(length(0.0081), "8 mm");
    EXPECT_EQ(length(0.34), "34 cm");
    EXPECT_EQ(length(1.2), "1.20 m");
    EXPECT_EQ(fixed(-0.001, 2), "0.00");
}

}  // namespace
}  // namespace fodscope
