// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "core/cloud/ByteWindow.h"
#include "core/cloud/PcdHeader.h"
#include "core/cloud/PointCloud.h"
#include "core/common/Error.h"

namespace fodscope {

/// The fields of a PCD file that Fodscope uses.
struct PcdUsedFields {
    std::array<const PcdField*, 3> axes{};
    /// Null: no colour.
    const PcdField* colour = nullptr;
};

Error truncatedPcd(const std::string& subject, const PcdHeader& header);

/// Room for all points of the header.
PointCloud roomFor(const PcdHeader& header, const PcdUsedFields& used);

/// Reads the data of a binary_compressed file. It is compressed as a whole and holds one field after the other, each
/// for all points.
PointCloud readCompressedPcd(ByteWindow& window, const PcdHeader& header, const PcdUsedFields& used,
                             const std::string& subject);

}  // namespace fodscope
