// SPDX-License-Identifier: MIT
#include "core/inspection/Parameters.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/inspection/ParameterTable.h"

namespace fodscope {
namespace {

constexpr const char* kPaperPhysical = "paper-physical";
constexpr const char* kPaperSimulation = "paper-simulation";

Parameters paperPhysical() {
    Parameters parameters;
    parameters.candidates = paperPhysicalCandidateSettings(Metric::Mahalanobis);
    return parameters;
}

Parameters paperSimulation() {
    Parameters parameters;
    parameters.denoise.enabled = false;
    parameters.candidates = paperPhysicalCandidateSettings(Metric::Mahalanobis);
    parameters.candidates.threshold = 1.75;
    parameters.candidates.clusterCutoff_m = 0.275;
    for (SmoothingSettings* smoothing :
         {&parameters.reference.covariance.smoothing, &parameters.discrepancy.smoothing}) {
        smoothing->neighbourhood = SmoothingNeighbourhood::Ball;
        smoothing->radius_m = 0.2;
        smoothing->weights = SmoothingWeights::Gaussian;
        smoothing->sigma_m = 0.05;
    }
    parameters.discrepancy.downSampling = DownSampling::Random;
    parameters.discrepancy.randomRatio = 0.1;
    return parameters;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

std::string nearestOf(const std::string& word, const std::vector<std::string>& known) {
    return *std::ranges::min_element(known, {}, [&](const std::string& one) { return editDistance(word, one); });
}

std::string joined(const std::vector<std::string>& words, const std::string& between) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : between) + word;
    return text;
}

std::vector<std::string> sectionNames() {
    std::vector<std::string> names;
    for (const ParameterField& field : parameterTable()) {
        if (names.empty() || names.back() != field.section) names.push_back(field.section);
    }
    return names;
}

std::vector<std::string> keysOf(const std::string& section) {
    std::vector<std::string> keys;
    for (const ParameterField& field : parameterTable()) {
        if (field.section == section) keys.push_back(field.key);
    }
    return keys;
}

std::optional<double> numberIn(const std::string& text) {
    double number = 0.0;
    const char* first = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto end = std::from_chars(first, text.data() + text.size(), number);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
    return number;
}

bool isNone(const YAML::Node& node) {
    return node.IsNull() || (node.IsScalar() && node.Scalar() == "none");
}

std::string expectation(const ParameterField& field) {
    const auto range = [&] {
        return toString(ParameterValue(field.minimum)) + " to " + toString(ParameterValue(field.maximum)) +
               (field.unit.empty() ? "" : " " + field.unit);
    };
    switch (field.kind) {
        case ParameterKind::Switch:
            return "true or false";
        case ParameterKind::Whole:
            return "a whole number from " + range();
        case ParameterKind::Number:
            return "a number from " + range();
        case ParameterKind::OptionalNumber:
            return "none or a number from " + range();
        case ParameterKind::Choice:
            return joined(field.choices, " or ");
    }
    return {};
}

/// @return the value of a node, or empty when it is none that the field allows
std::optional<ParameterValue> valueIn(const YAML::Node& node, const ParameterField& field) {
    if (field.kind == ParameterKind::OptionalNumber && isNone(node)) return ParameterValue();
    if (!node.IsScalar()) return std::nullopt;
    const std::string& text = node.Scalar();
    if (field.kind == ParameterKind::Switch) {
        if (text == "true") return ParameterValue(true);
        if (text == "false") return ParameterValue(false);
        return std::nullopt;
    }
    if (field.kind == ParameterKind::Choice) {
        if (std::ranges::find(field.choices, text) == field.choices.end()) return std::nullopt;
        return ParameterValue(text);
    }
    const std::optional<double> number = numberIn(text);
    if (!number || *number < field.minimum || *number > field.maximum) return std::nullopt;
    if (field.kind != ParameterKind::Whole) return ParameterValue(*number);
    if (*number != std::floor(*number)) return std::nullopt;
    return ParameterValue(static_cast<int>(*number));
}

/// Reads a document over a record, and gathers what is wrong with it.
class ParameterReader {
  public:
    explicit ParameterReader(const Parameters& base) : parameters_(base) {}

    void read(const YAML::Node& root) {
        if (root.IsNull()) return;
        if (!root.IsMap()) {
            problems_.push_back("holds no sections");
            return;
        }
        const std::vector<std::string> sections = sectionNames();
        std::set<std::string> seen;
        for (const auto& entry : root) {
            const std::string name = entry.first.IsScalar() ? entry.first.Scalar() : "";
            if (std::ranges::find(sections, name) == sections.end()) {
                add(entry.first, "unknown section '" + name + "' (nearest known: '" + nearestOf(name, sections) + "')");
            } else if (!seen.insert(name).second) {
                add(entry.first, "section '" + name + "' is there twice");
            }
        }
        // In the table's order, not the file's: the chi-square test brings its usual threshold, and another goes over
        // it.
        for (const std::string& name : sections) {
            if (seen.contains(name)) readSection(name, root[name]);
        }
        if (!problems_.empty()) return;
        for (const std::string& problem : parameterProblems(parameters_))
            problems_.push_back(problem);
    }

    const Parameters& parameters() const { return parameters_; }
    const std::vector<std::string>& problems() const { return problems_; }

  private:
    void readSection(const std::string& section, const YAML::Node& node) {
        if (node.IsNull()) return;
        if (!node.IsMap()) {
            add(node, "section '" + section + "' holds no keys");
            return;
        }
        std::set<std::string> seen;
        for (const auto& entry : node) {
            const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
            if (findParameter(section, key) == nullptr) {
                add(entry.first,
                    "unknown key '" + section + "." + key + "' (nearest known: '" + nearestKey(section, key) + "')");
            } else if (!seen.insert(key).second) {
                add(entry.first, "'" + section + "." + key + "' is there twice");
            }
        }
        // In the table's order, not the file's: a metric brings its usual values, and the others go over them.
        for (const ParameterField& field : parameterTable()) {
            if (field.section != section) continue;
            const YAML::Node value = node[field.key];
            if (value.IsDefined()) readValue(field, value);
        }
    }

    void readValue(const ParameterField& field, const YAML::Node& node) {
        if (const std::optional<ParameterValue> value = valueIn(node, field)) {
            field.set(parameters_, *value);
            return;
        }
        const std::string text = node.IsScalar() ? "'" + node.Scalar() + "'" : "no single value";
        add(node, "'" + field.section + "." + field.key + "' is " + text + " (allowed: " + expectation(field) + ")");
    }

    /// A key that another section has is most likely in the wrong place; else the nearest spelling here.
    static std::string nearestKey(const std::string& section, const std::string& key) {
        for (const ParameterField& field : parameterTable()) {
            if (field.key == key) return field.section + "." + key;
        }
        return section + "." + nearestOf(key, keysOf(section));
    }

    void add(const YAML::Node& where, const std::string& problem) {
        problems_.push_back("line " + std::to_string(where.Mark().line + 1) + ": " + problem);
    }

    Parameters parameters_;
    std::vector<std::string> problems_;
};

std::string commentOf(const ParameterField& field) {
    return field.unit.empty() ? field.help : field.help + " [" + field.unit + "]";
}

}  // namespace

MeanReferenceSettings meanReferenceSettings(const Parameters& parameters) {
    MeanReferenceSettings settings;
    settings.denoise = parameters.denoise;
    settings.voxelSize_m = parameters.reference.voxelSize_m;
    settings.occupancyQuantile = parameters.reference.occupancyQuantile;
    settings.covariance = parameters.reference.covariance;
    return settings;
}

std::vector<std::string> presetNames() {
    return {kPaperPhysical, kPaperSimulation};
}

Parameters presetParameters(const std::string& name) {
    if (name == kPaperPhysical) return paperPhysical();
    if (name == kPaperSimulation) return paperSimulation();
    throw Error("preset '" + name + "'", "is not known", "use one of: " + joined(presetNames(), ", "));
}

CandidateSettings usualCandidateSettings(Metric metric, const Parameters& parameters) {
    CandidateSettings settings = paperPhysicalCandidateSettings(metric);
    if (metric == Metric::ChiSquare) settings.threshold = testThreshold(parameters.chiSquare);
    return settings;
}

Parameters parseParameters(const std::string& yaml, const std::string& subject, const Parameters& base) {
    ParameterReader reader(base);
    try {
        reader.read(YAML::Load(yaml));
    } catch (const YAML::Exception& exception) {
        throw Error(subject, "is no YAML (line " + std::to_string(exception.mark.line + 1) + ": " + exception.msg + ")",
                    "mend it, or start from the output of 'fodscope-cli params --print-default'");
    }
    if (!reader.problems().empty()) {
        throw Error(subject, joined(reader.problems(), ", "),
                    "mend it, or start from the output of 'fodscope-cli params --print-default'");
    }
    return reader.parameters();
}

Parameters readParameters(const std::filesystem::path& file, const Parameters& base) {
    return parseParameters(readTextFile(file), file.string(), base);
}

std::string parametersYaml(const Parameters& parameters) {
    std::string text = "# Parameters of Fodscope: one section per stage. Lengths in metres, angles in degrees.\n";
    std::string section;
    for (const ParameterField& field : parameterTable()) {
        if (field.section != section) {
            section = field.section;
            text += "\n" + section + ":\n";
        }
        std::string line = "  " + field.key + ": " + toString(field.get(parameters));
        constexpr std::size_t kCommentColumn = 42;
        line.resize(std::max(line.size() + 1, kCommentColumn), ' ');
        text += line + "# " + commentOf(field) + "\n";
    }
    return text;
}

}  // namespace fodscope
