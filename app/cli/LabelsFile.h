// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/detection/Candidates.h"
#include "core/inspection/GroundTruthLabeller.h"
#include "core/inspection/InspectionState.h"

namespace fodscope::cli {

/// Answers for candidates, from a CSV file of `candidate,label[,comment]` (a header line may be there). Several rows of
/// a candidate are several labels.
/// @throws Error naming the file: a label that the set lacks, a row that is none
std::map<std::string, PhotoAnswer> readLabels(const std::filesystem::path& file, const LabelSet& labelSet);

/// What a photo is answered from the answers for the candidates it was taken for; no labels when there is none. On a
/// photo of several candidates each label has the box of its candidate, and one without an answer is `not sure`, since
/// no word on it would clear it.
PhotoAnswer answerFor(const Photo& photo, const std::map<std::string, PhotoAnswer>& answers,
                      const DetectionRecord& detection);

/// @throws Error naming the file when it speaks of a candidate that is not there
void requireKnownCandidates(const std::map<std::string, PhotoAnswer>& answers, const CandidateSet& candidates,
                            const std::filesystem::path& file);

}  // namespace fodscope::cli
