// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace fodscope {

/// Rows of cells as text in columns: the first column to the left, the others to the right.
/// @param rows the first is the heading; rows may be shorter than it
std::string textTable(const std::vector<std::vector<std::string>>& rows);

/// @return text broken at blanks into lines of at most `width` characters; a longer word stands alone
std::string wrapped(const std::string& text, std::size_t width);

}  // namespace fodscope
