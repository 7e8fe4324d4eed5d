// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "core/evaluation/Evaluation.h"
#include "core/inspection/InspectionState.h"

namespace fodscope {

/// In sentences, how each figure of an evaluation was counted, and which maps and trials it leaves out.
std::vector<std::string> howCounted(const Evaluation& evaluation);

/// `evaluation.json` of the file contract: equal evaluations give an equal text. What does not exist is null.
/// @param reference file and fingerprint of the reference map, for the record
std::string evaluationJson(const Evaluation& evaluation, const SourceFile& reference);

/// The paper's tables as text, and a paragraph on how they were counted.
std::string evaluationText(const Evaluation& evaluation);

}  // namespace fodscope
