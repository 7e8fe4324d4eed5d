// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/cloud/TriangleMesh.h"

namespace fodscope {

/// STL repeats a vertex for every triangle; this gives equal ones the same index.
class StlVertices {
  public:
    std::uint32_t indexOf(const Eigen::Vector3d& vertex);
    std::vector<Eigen::Vector3d> take() && { return std::move(vertices_); }

  private:
    std::map<std::array<std::uint64_t, 3>, std::uint32_t> known_;
    std::vector<Eigen::Vector3d> vertices_;
};

/// @return whether the size is the one that a binary STL's triangle count asks for
bool isBinaryStl(std::span<const std::byte> bytes);

/// @throws Error when the file is shorter than its header says
TriangleMesh parseBinaryStl(std::span<const std::byte> bytes, const std::string& subject);

std::string binaryStlBytes(const TriangleMesh& mesh);

}  // namespace fodscope
