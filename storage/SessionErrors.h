// SPDX-License-Identifier: MIT
#pragma once

#include <SQLiteCpp/Exception.h>

#include <filesystem>

#include "core/common/Error.h"

namespace fodscope {

/// What a failure of SQLite means to the user, in one sentence.
Error sessionError(const std::filesystem::path& file, const SQLite::Exception& exception);

Error notASession(const std::filesystem::path& file);
Error damagedSession(const std::filesystem::path& file, const std::string& detail);

}  // namespace fodscope
