// SPDX-License-Identifier: MIT
#include "app/cli/LabelsFile.h"

#include <algorithm>
#include <sstream>

#include "core/common/Error.h"
#include "core/common/Files.h"
#include "core/inspection/PhotoProjection.h"

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

/// The rectangle round a candidate in a photo; empty where the photo does not show it.
std::optional<PixelBox> boxOf(const std::string& candidateId, const Photo& photo, const DetectionRecord& detection) {
    const auto& candidates = detection.candidates->candidates;
    const auto candidate = std::ranges::find(candidates, candidateId, &Candidate::id);
    if (candidate == candidates.end()) return std::nullopt;
    const auto hull_px = projectVoxels(voxelsInMap(*candidate, detection), detection.parameters.discrepancy.voxelSize_m,
                                       photo.T_map_from_camera, photo.intrinsics)
                             .hull_px;
    if (hull_px.empty()) return std::nullopt;
    Eigen::Vector2d low = hull_px.front(), high = hull_px.front();
    for (const Eigen::Vector2d& corner : hull_px) {
        low = low.cwiseMin(corner);
        high = high.cwiseMax(corner);
    }
    low = low.cwiseMax(0.0);
    high = high.cwiseMin(Eigen::Vector2d(photo.intrinsics.width_px, photo.intrinsics.height_px));
    if (!(low.x() < high.x() && low.y() < high.y())) return std::nullopt;
    return PixelBox{low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
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

PhotoAnswer answerFor(const Photo& photo, const std::map<std::string, PhotoAnswer>& answers,
                      const DetectionRecord& detection) {
    PhotoAnswer combined;
    const auto isAnswered = [&](const std::string& id) { return answers.contains(id); };
    if (std::ranges::none_of(photo.candidateIds, isAnswered)) return combined;
    const bool isShared = photo.candidateIds.size() > 1;
    const PhotoAnswer unanswered{{{kNotSure, std::nullopt}}, ""};
    for (const std::string& candidate : photo.candidateIds) {
        const PhotoAnswer& answer = isAnswered(candidate) ? answers.at(candidate) : unanswered;
        for (PhotoLabel label : answer.labels) {
            if (isShared && label.label != kNoFod) label.box = boxOf(candidate, photo, detection);
            combined.labels.push_back(label);
        }
        if (!answer.comment.empty()) combined.comment += (combined.comment.empty() ? "" : "; ") + answer.comment;
    }
    // What is boxed speaks of its own candidate, and is no FOD for the others.
    if (std::ranges::any_of(combined.labels, [](const PhotoLabel& label) { return label.label != kNoFod; }))
        std::erase_if(combined.labels, [](const PhotoLabel& label) { return label.label == kNoFod; });
    else
        combined.labels.resize(1);
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
