// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <filesystem>
#include <functional>

#include "core/inspection/InspectionState.h"
#include "storage/ActChain.h"

namespace fodscope {

/// Calls `use` with every act, oldest first.
void forEachAct(SQLite::Database& database, const std::function<void(const Act&)>& use);

/// Replays the acts into a state.
/// @throws Error when an act or a blob cannot be read; SQLite::Exception
InspectionState readInspection(SQLite::Database& database, const std::filesystem::path& file);

}  // namespace fodscope
