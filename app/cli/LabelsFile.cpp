// SPDX-License-Identifier: MIT
#include "app/cli/LabelsFile.h"

#include <algorithm>
#include <sstream>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope::cli {
namespace {

constexpr const char* kRemedy = "give rows of candidate,label[,comment]";

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// The fields of one line; a field in double quotes may hold commas, and quotes as pairs of them (RFC 4180).
std::vector<std::string> fieldsOf(const std::string& line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[++i];
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
        }
    }
    for (std::string& field : fields)
        field = trimmed(field);
    return fields;
}

std::string namesOf(const LabelSet& set) {
    std::string names;
    for (const Label& label : set.labels)
        names += (names.empty() ? "" : ", ") + label.name;
    return names;
}

void addLabel(PhotoAnswer& answer, const std::string& label, const std::string& comment) {
    if (std::ranges::find(answer.labels, label, &PhotoLabel::label) == answer.labels.end()) {
        answer.labels.push_back({label, std::nullopt});
    }
    if (!comment.empty()) answer.comment += (answer.comment.empty() ? "" : "; ") + comment;
}

}  // namespace

std::map<std::string, PhotoAnswer> readLabels(const std::filesystem::path& file, const LabelSet& labelSet) {
    std::map<std::string, PhotoAnswer> answers;
    std::istringstream stream(readTextFile(file));
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        const std::vector<std::string> fields = fieldsOf(line);
        if (fields.size() == 1 && fields[0].empty()) continue;
        if (number == 1 && fields[0] == "candidate") continue;
        const std::string where = "line " + std::to_string(number);
        if (fields.size() < 2 || fields.size() > 3 || fields[0].empty()) {
            throw Error(file.string(), where + " is not candidate,label[,comment]", kRemedy);
        }
        const Label* label = findByType(labelSet, fields[1]);
        if (label == nullptr) {
            throw Error(file.string(), where + ": the label set has no label '" + fields[1] + "'",
                        "use one of: " + namesOf(labelSet));
        }
        addLabel(answers[fields[0]], label->name, fields.size() == 3 ? fields[2] : "");
    }
    if (answers.empty()) throw Error(file.string(), "holds no labels", kRemedy);
    for (const auto& [candidate, answer] : answers) {
        const bool hasNoFod = std::ranges::find(answer.labels, kNoFod, &PhotoLabel::label) != answer.labels.end();
        if (hasNoFod && answer.labels.size() > 1) {
            throw Error(file.string(), candidate + " is labelled 'no FOD' and something else", "decide for one");
        }
    }
    return answers;
}

PhotoAnswer answerFor(const Photo& photo, const std::map<std::string, PhotoAnswer>& answers) {
    PhotoAnswer combined;
    for (const std::string& candidate : photo.candidateIds) {
        const auto found = answers.find(candidate);
        if (found == answers.end()) continue;
        for (const PhotoLabel& label : found->second.labels)
            addLabel(combined, label.label, "");
        if (!found->second.comment.empty()) {
            combined.comment += (combined.comment.empty() ? "" : "; ") + found->second.comment;
        }
    }
    if (combined.labels.size() > 1) {
        std::erase_if(combined.labels, [](const PhotoLabel& label) { return label.label == kNoFod; });
    }
    return combined;
}

void requireKnownCandidates(const std::map<std::string, PhotoAnswer>& answers, const CandidateSet& candidates,
                            const std::filesystem::path& file) {
    for (const auto& [id, answer] : answers) {
        if (std::ranges::find(candidates.candidates, id, &Candidate::id) != candidates.candidates.end()) continue;
        throw Error(file.string(), "speaks of " + id + ", which is no candidate of this map",
                    "use the ids that detect gives with the same parameters");
    }
}

}  // namespace fodscope::cli
