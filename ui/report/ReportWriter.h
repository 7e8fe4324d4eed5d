// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// Writes the report of an inspection in the form that the extension names: .pdf, .html, .csv (all candidates) or .json
/// (the session). All forms come from one ReportModel. Needs no display and starts what Qt needs by itself when no Qt
/// application runs (see ReportApplication); may be called from a worker thread of one that does.
/// @param headHash head of the session's chain of acts, printed on every page; empty: "not recorded"
/// @throws Error for another extension, or when the file cannot be written; an older file is then untouched
void writeReport(const InspectionState& state, const std::string& headHash, const std::filesystem::path& file);

}  // namespace fodscope
