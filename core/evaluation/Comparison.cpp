// SPDX-License-Identifier: MIT
#include "core/evaluation/Comparison.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/evaluation/Association.h"
#include "core/evaluation/Summary.h"

namespace fodscope {
namespace {

using nlohmann::json;

/// Reads an evaluation's fields, each with its name for the error.
class EvaluationFields {
  public:
    explicit EvaluationFields(std::string subject) : subject_(std::move(subject)) {}

    [[noreturn]] void fail(const std::string& problem) const {
        throw Error(subject_, problem, "give an evaluation.json as 'fodscope-cli evaluate' writes it");
    }

    const json& member(const json& parent, const std::string& key, const std::string& at) const {
        const auto found = parent.is_object() ? parent.find(key) : parent.end();
        if (found == parent.end()) fail('"' + at + key + "\" is missing");
        return *found;
    }

    const json& list(const json& parent, const std::string& key, const std::string& at) const {
        const json& value = member(parent, key, at);
        if (!value.is_array()) fail('"' + at + key + "\" is not a list");
        return value;
    }

    std::string text(const json& parent, const std::string& key, const std::string& at) const {
        const json& value = member(parent, key, at);
        if (!value.is_string()) fail('"' + at + key + "\" is not a text");
        return value.get<std::string>();
    }

    std::optional<double> number(const json& parent, const std::string& key, const std::string& at) const {
        const json& value = member(parent, key, at);
        if (value.is_null()) return std::nullopt;
        if (!value.is_number() || !std::isfinite(value.get<double>()) || value.get<double>() < 0.0)
            fail('"' + at + key + "\" is neither null nor a number of at least 0");
        return value.get<double>();
    }

  private:
    std::string subject_;
};

RecordedTrial trialFrom(const json& value, const std::string& at, const EvaluationFields& fields) {
    RecordedTrial trial;
    trial.name = fields.text(value, "name", at);
    trial.unassociatedPoints = fields.number(value, "unassociated_points", at);
    trial.unassociatedCandidates = fields.number(value, "unassociated_candidates", at);
    const json& fods = fields.list(value, "fods", at);
    for (std::size_t i = 0; i < fods.size(); ++i) {
        const std::string place = at + "fods[" + std::to_string(i) + "].";
        trial.fods.push_back({fields.text(fods[i], "type", place), fields.number(fods[i], "distance_m", place)});
    }
    return trial;
}

std::string namesMissing(const RecordedEvaluation& from, const RecordedEvaluation& in) {
    std::string names;
    for (const RecordedTrial& trial : from.trials)
        if (std::ranges::find(in.trials, trial.name, &RecordedTrial::name) == in.trials.end())
            names += (names.empty() ? "" : ", ") + trial.name;
    return names;
}

void requireSameTrials(const RecordedEvaluation& a, const RecordedEvaluation& b) {
    const char* remedy = "evaluate both on the same folder of trials";
    const std::string onlyA = namesMissing(a, b), onlyB = namesMissing(b, a);
    if (!onlyA.empty() || !onlyB.empty()) {
        std::string differ = "does not evaluate the same trials as " + a.file + " (";
        if (!onlyA.empty()) differ += "only there: " + onlyA;
        if (!onlyB.empty()) differ += std::string(onlyA.empty() ? "" : ", ") + "only here: " + onlyB;
        throw Error(b.file, differ + ")", remedy);
    }
    std::string other;
    for (std::size_t i = 0; i < a.trials.size(); ++i)
        if (!std::ranges::equal(a.trials[i].fods, b.trials[i].fods, {}, &RecordedFod::type, &RecordedFod::type))
            other += (other.empty() ? "" : ", ") + a.trials[i].name;
    if (!other.empty())
        throw Error(b.file, "evaluates trials of the same names as " + a.file + " with other FOD (" + other + ")",
                    remedy);
    if (a.trials.empty()) throw Error(a.file, "holds no trials", remedy);
}

PairedTest pairedTest(const std::string& quantity, const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i)
        differences.push_back(a[i] - b[i]);
    return {quantity, meanAndDeviation(a).mean, meanAndDeviation(b).mean, wilcoxonSignedRank(differences)};
}

PairedTest testCounts(const std::string& quantity, const RecordedEvaluation& a, const RecordedEvaluation& b,
                      std::optional<double> RecordedTrial::*count) {
    std::vector<double> countsA, countsB;
    for (std::size_t i = 0; i < a.trials.size(); ++i) {
        if (!(a.trials[i].*count) || !(b.trials[i].*count)) continue;
        countsA.push_back(*(a.trials[i].*count));
        countsB.push_back(*(b.trials[i].*count));
    }
    return pairedTest(quantity, countsA, countsB);
}

std::vector<double> distances_m(const RecordedEvaluation& evaluation) {
    std::vector<double> distances;
    for (const RecordedTrial& trial : evaluation.trials)
        for (const RecordedFod& fod : trial.fods)
            distances.push_back(fod.distance_m.value_or(kNoCandidateDistance_m));
    return distances;
}

}  // namespace

RecordedEvaluation readEvaluation(const std::filesystem::path& file) {
    const EvaluationFields fields(file.string());
    const json root = json::parse(readTextFile(file), nullptr, false);
    if (root.is_discarded() || !root.is_object())
        fields.fail("this is no JSON object (damaged, truncated or another kind of file)");
    RecordedEvaluation evaluation;
    evaluation.file = file.string();
    const json& trials = fields.list(root, "trials", "");
    for (std::size_t i = 0; i < trials.size(); ++i)
        evaluation.trials.push_back(trialFrom(trials[i], "trials[" + std::to_string(i) + "].", fields));
    std::ranges::sort(evaluation.trials, {}, &RecordedTrial::name);
    const auto twice = std::ranges::adjacent_find(evaluation.trials, {}, &RecordedTrial::name);
    if (twice != evaluation.trials.end()) fields.fail("the trial " + twice->name + " is there twice");
    return evaluation;
}

Comparison compareEvaluations(const RecordedEvaluation& a, const RecordedEvaluation& b) {
    requireSameTrials(a, b);
    Comparison comparison;
    comparison.fileA = a.file;
    comparison.fileB = b.file;
    comparison.trials = a.trials.size();
    for (std::size_t i = 0; i < a.trials.size(); ++i) {
        comparison.fods += a.trials[i].fods.size();
        if (!a.trials[i].unassociatedPoints || !b.trials[i].unassociatedPoints)
            comparison.failedTrials.push_back(a.trials[i].name);
    }
    comparison.tests = {testCounts("unassociated_points", a, b, &RecordedTrial::unassociatedPoints),
                        testCounts("unassociated_candidates", a, b, &RecordedTrial::unassociatedCandidates),
                        pairedTest("distance_error_m", distances_m(a), distances_m(b))};
    return comparison;
}

}  // namespace fodscope
