// SPDX-License-Identifier: MIT
#include "core/inspection/ReportModel.h"

#include <algorithm>

#include "core/inspection/ParameterTable.h"
#include "core/inspection/ReportCandidates.h"
#include "core/inspection/ReportLimits.h"
#include "core/inspection/ReportMethod.h"
#include "core/inspection/ReportText.h"

namespace fodscope {
namespace {

std::string observedMeans(const CoverageSettings& settings) {
    return "within " + fixed(settings.observedWithin_m * 100.0, 0) +
           " cm of a point of the map, by point density; no sensor rays were used";
}

std::size_t countOf(const std::vector<ReportCandidate>& candidates, Verdict verdict) {
    return static_cast<std::size_t>(std::ranges::count(candidates, verdict, &ReportCandidate::verdict));
}

std::string candidateSentence(const ReportModel& model) {
    const std::size_t total = model.findings.size() + model.open.size() + model.rejected.size();
    if (total == 0) return "No candidate exceeds the threshold.";
    std::vector<std::string> parts{counted(model.findings.size(), "finding", "findings")};
    if (!model.rejected.empty()) parts.push_back(std::to_string(model.rejected.size()) + " decided no FOD");
    if (!model.open.empty()) parts.push_back(std::to_string(model.open.size()) + " open");
    return counted(total, "candidate", "candidates") + ": " + joined(parts, ", ") + ".";
}

std::string coverageSentence(const InspectionState& state) {
    const DetectionRecord& detection = *state.detection;
    if (!detection.coverage) return "How much of the reference surface was observed is not recorded.";
    return percent(detection.coverage->observedShare) + " of the reference surface was observed (" +
           observedMeans(detection.parameters.coverage) + "); nothing is said about the rest.";
}

std::string statementOf(const InspectionState& state, const ReportModel& model) {
    if (!state.detection) return "No map has been compared with a reference map; nothing is said about FOD.";
    if (!state.detection->candidates) {
        return "The map could not be aligned with the reference map; no candidates are claimed and nothing is said "
               "about FOD.";
    }
    std::string statement = candidateSentence(model) + " " + coverageSentence(state);
    if (model.findings.empty()) {
        statement += " No finding does not mean that no FOD is there: see what was not observed and the limits.";
    }
    return statement;
}

std::vector<ReportField> inspectionFields(const InspectionState& state) {
    const InspectionHeader& header = state.header;
    std::vector<ReportField> fields{{"Title", orNotRecorded(header.title)},
                                    {"Inspection", orNotRecorded(header.id)},
                                    {"Ship", orNotRecorded(header.ship)},
                                    {"Tank", orNotRecorded(header.tank)},
                                    {"Work order", orNotRecorded(header.workOrder)},
                                    {"Inspector", orNotRecorded(header.inspector)},
                                    {"Robot", orNotRecorded(header.robot)},
                                    {"Begun", timeText(header.created)},
                                    {"Fodscope", orNotRecorded(header.softwareVersion)}};
    if (!state.reports.empty()) {
        const ReportRecord& last = state.reports.back();
        fields.push_back({"Last report issued", timeText(last.issued) + " by " + orNotRecorded(last.issuedBy)});
    }
    return fields;
}

void addSource(std::vector<ReportField>& fields, const std::string& name, const std::optional<SourceFile>& source) {
    fields.push_back({name, source ? orNotRecorded(source->path) : kNotRecorded});
    fields.push_back({name + ", points", source ? std::to_string(source->points) : kNotRecorded});
    fields.push_back({name + ", SHA-256", source ? orNotRecorded(source->sha256) : kNotRecorded});
}

std::vector<ReportField> sourceFields(const InspectionState& state) {
    std::vector<ReportField> fields;
    addSource(fields, "Reference map", state.referenceSource);
    if (state.reference) {
        fields.push_back({"Reference map, made", orNotRecorded(joined(state.reference->provenance, "; "))});
        fields.push_back({"Reference map, covariances", state.reference->hasCovariance() ? "yes" : "none"});
    }
    addSource(fields, "Map", state.mapSource);
    return fields;
}

std::vector<ReportField> alignmentFields(const InspectionState& state) {
    if (!state.detection) return {{"Alignment", kNotRecorded}};
    const RegistrationResult& registration = state.detection->registration;
    const auto quality = [&]() -> std::string {
        switch (registration.quality) {
            case RegistrationQuality::Given:
                return "given by the user, not searched";
            case RegistrationQuality::Good:
                return "good";
            case RegistrationQuality::Ambiguous:
                return "ambiguous, several poses fit: no candidates are claimed";
            case RegistrationQuality::Bad:
                return "bad: no candidates are claimed";
        }
        return kNotRecorded;
    };
    std::string converged = "not searched";
    if (registration.converged) converged = *registration.converged ? "yes" : "no";
    return {{"Alignment", quality()},
            {"Converged", converged},
            {"Residual (root mean square)", length(registration.rms_m)},
            {"Overlap", percent(registration.overlap)},
            {"In words", orNotRecorded(registration.summary)}};
}

std::vector<ReportField> coverageFields(const InspectionState& state) {
    if (!state.detection || !state.detection->coverage) return {{"Observed", kNotRecorded}};
    const Coverage& coverage = *state.detection->coverage;
    const auto observed = static_cast<std::size_t>(std::ranges::count(coverage.observed, std::uint8_t{1}));
    const std::size_t judged = coverage.observed.size() - std::min(coverage.leftOut, coverage.observed.size());
    return {{"Observed", percent(coverage.observedShare) + " of the reference surface"},
            {"Observed means", observedMeans(state.detection->parameters.coverage)},
            {"Reference points observed", std::to_string(observed) + " of " + std::to_string(judged)},
            {"Reference points left out above the crop height", std::to_string(coverage.leftOut)}};
}

std::string labellers(const InspectionState& state) {
    std::vector<std::string> names;
    for (const Decision& decision : state.decisions) {
        if (std::ranges::find(names, decision.labeller) == names.end()) names.push_back(decision.labeller);
    }
    return names.empty() ? "none yet" : joined(names, ", ");
}

std::vector<ReportField> countFields(const InspectionState& state, const std::vector<ReportCandidate>& candidates) {
    // Nothing was detected, so nothing was counted: a zero would read as a clear tank.
    if (!state.detection || !state.detection->candidates) {
        return {{"Candidates", "not known"}, {"Findings", "not known"}};
    }
    const auto done = std::ranges::count(state.visits, VisitState::Done, &Visit::state);
    return {{"Candidates", std::to_string(candidates.size())},
            {"Findings", std::to_string(countOf(candidates, Verdict::Finding))},
            {"Decided no FOD", std::to_string(countOf(candidates, Verdict::NoFod))},
            {"Open: not sure or readers disagree", std::to_string(countOf(candidates, Verdict::Open))},
            {"Open: photos wait for a decision", std::to_string(countOf(candidates, Verdict::Undecided))},
            {"Open: no photo", std::to_string(countOf(candidates, Verdict::NotPhotographed))},
            {"Visits done", std::to_string(done) + " of " + std::to_string(state.visits.size())},
            {"Photos", std::to_string(state.photos.size())},
            {"Labellers", labellers(state)}};
}

std::vector<ReportField> parameterFields(const Parameters& parameters) {
    std::vector<ReportField> fields;
    for (const ParameterField& field : parameterTable()) {
        if (field.section == kReferenceSection) continue;
        const std::string value = toString(field.get(parameters));
        fields.push_back({field.section + "." + field.key,
                          field.unit.empty() || value == "none" ? value : value + " " + field.unit});
    }
    return fields;
}

}  // namespace

ReportModel makeReportModel(const InspectionState& state) {
    ReportModel model;
    model.title = state.header.title.empty() ? "FOD inspection" : state.header.title;
    const std::vector<ReportCandidate> candidates = reportCandidates(state);
    for (const ReportCandidate& candidate : candidates) {
        auto& section = candidate.verdict == Verdict::Finding ? model.findings
                        : candidate.verdict == Verdict::NoFod ? model.rejected
                                                              : model.open;
        section.push_back(candidate);
    }
    model.statement = statementOf(state, model);
    model.inspection = inspectionFields(state);
    model.sources = sourceFields(state);
    model.alignment = alignmentFields(state);
    model.coverage = coverageFields(state);
    model.counts = countFields(state, candidates);
    model.parameters = parameterFields(state.parameters);
    model.method = methodOf(state.detection ? state.detection->parameters : state.parameters);
    model.missing = missingForIssue(state);
    model.limits = limitsOf(state);
    return model;
}

}  // namespace fodscope
