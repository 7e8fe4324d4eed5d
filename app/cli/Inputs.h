// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/Context.h"
#include "core/cloud/PointCloud.h"
#include "core/common/Geometry.h"
#include "core/inspection/InspectionState.h"
#include "core/reference/ReferenceMap.h"

namespace fodscope::cli {

struct LoadedMap {
    SourceFile source;
    std::shared_ptr<PointCloud> cloud;
};

struct LoadedReferenceMap {
    SourceFile source;
    std::shared_ptr<const ReferenceMap> reference;
};

/// The remarks tell when points were dropped because they were not finite.
/// @throws Error naming the file; Cancelled
LoadedMap loadMap(const std::filesystem::path& file, Context& context);
LoadedReferenceMap loadReference(const std::filesystem::path& file);

/// Four bare rows of four numbers, divided by commas or blanks.
/// @throws Error naming the file
Transform readTransform(const std::filesystem::path& file);

/// CSV with the header m00…m33 and a row of 16 a map.
/// @throws Error naming the file
std::vector<Transform> readTransforms(const std::filesystem::path& file);

/// "X,Y,YAW_DEG"
/// @throws UsageError
Pose2 parsePose(const std::string& text);

/// @return the numbers in a line, divided by commas or blanks
/// @throws Error naming the file and the line
std::vector<double> numbersIn(const std::string& line, const std::string& subject, std::size_t lineNumber);

/// Runs a step; an error about a role ("map") is told about the file that plays it.
template <typename Step>
auto namingFiles(const std::vector<std::pair<std::string, std::filesystem::path>>& roles, const Step& step) {
    try {
        return step();
    } catch (const Error& error) {
        for (const auto& [role, file] : roles) {
            if (error.subject() == role) throw Error(file.string(), error.problem(), error.remedy());
        }
        throw;
    }
}

}  // namespace fodscope::cli
