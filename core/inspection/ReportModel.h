// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// A name and its value, both ready to be read by a person.
struct ReportField {
    std::string name;
    std::string value;
};

/// A candidate as the report tells it.
struct ReportCandidate {
    std::string id;
    Verdict verdict = Verdict::NotPhotographed;
    std::string verdictText;
    std::string labels;
    std::vector<ReportField> fields;
    /// Photos that show it, by id.
    std::vector<std::string> photoIds;
    /// Each reader's last decision: "Anna: hammer, 2026-11-21 10:15 UTC".
    std::vector<std::string> decisions;
    /// Why there is no photo, when there is none.
    std::string noPhotoReason;
    Eigen::Vector3d centroid_reference = Eigen::Vector3d::Zero();
};

/// The content of a report, made once from the inspection's state; PDF, HTML, CSV and JSON are forms of it that cannot
/// disagree. Never says "free of FOD"; unknown values read "not recorded".
struct ReportModel {
    std::string title;
    std::string statement;
    std::vector<ReportField> inspection;
    std::vector<ReportField> sources;
    std::vector<ReportField> alignment;
    std::vector<ReportField> coverage;
    std::vector<ReportField> counts;
    std::vector<ReportField> parameters;
    std::string method;
    std::vector<ReportCandidate> findings;
    std::vector<ReportCandidate> open;
    std::vector<ReportCandidate> rejected;
    /// What is still missing before the report can be issued without "draft", one sentence each.
    std::vector<std::string> missing;
    std::vector<std::string> limits;
};

ReportModel makeReportModel(const InspectionState& state);

/// CSV of all candidates with verdict, labels, place and size; one header line, RFC 4180.
std::string reportCsv(const InspectionState& state);

/// JSON of the session ("fodscope.session/1"): everything but the bytes of photos and clouds.
std::string sessionJson(const InspectionState& state);

}  // namespace fodscope
