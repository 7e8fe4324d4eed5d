// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "core/cloud/TriangleMesh.h"

namespace fodscope {

/// @throws Error when the text is truncated or malformed
TriangleMesh parseAsciiStl(std::string_view text, const std::string& subject);

/// Vertices and faces; everything else is passed over. Indices are checked.
/// @throws Error when a vertex or face is malformed
TriangleMesh parseObj(std::string_view text, const std::string& subject);

std::string objText(const TriangleMesh& mesh);

}  // namespace fodscope
