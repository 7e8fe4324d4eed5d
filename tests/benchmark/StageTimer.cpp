// SPDX-License-Identifier: MIT
// Times one stage on points from a file, so that the same file can be given to a peer: see versus_peers.py. The file is
// read before the clock starts, unless that is the work (read, detect). Prints one line of JSON: seconds of each round,
// peak memory of the process and what the stage adds to the memory held before it, and a figure of the result that the
// peer's must agree with.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/cloud/NeighbourIndex.h"
#include "core/cloud/OutlierRemoval.h"
#include "core/cloud/PointCloudIo.h"
#include "core/cloud/VoxelGrid.h"
#include "core/common/Error.h"
#include "core/detection/HierarchicalClustering.h"
#include "core/detection/LiveCandidates.h"
#include "tests/benchmark/DragPath.h"
#include "tests/benchmark/FileStages.h"
#include "tests/benchmark/ProcessMemory.h"

namespace fodscope {
namespace {

struct Input {
    std::string cloudFile;
    std::string referenceFile;
    /// For detect: the cloud lies where it belongs in the reference.
    bool isAligned = false;
    std::vector<Eigen::Vector3d> cloud;
    std::vector<Eigen::Vector3d> reference;
    double length_m = 0.0;
    /// Voxels above the dragged threshold.
    std::size_t fewestAbove = 100;
    std::size_t mostAbove = 20'000;
};

double meanNearestDistance(const Input& input) {
    if (input.reference.empty()) throw Error("--reference", "is needed for this stage", "give a second cloud");
    Progress progress;
    const NeighbourIndex index(input.reference);
    double sum_m = 0.0;
    for (const Neighbour& neighbour : index.nearestOfEach(input.cloud, progress))
        sum_m += std::sqrt(neighbour.squaredDistance_m2);
    return sum_m / static_cast<double>(input.cloud.size());
}

double keptPoints(const Input& input) {
    Progress progress;
    return static_cast<double>(keptByOutlierRemoval(input.cloud, {}, progress).size());
}

double voxelCount(const Input& input) {
    const Eigen::Vector3d origin = minimumCorner(input.cloud).array() - 0.5 * input.length_m;
    return static_cast<double>(voxelGrid(input.cloud, origin, {input.length_m}).size());
}

/// A discrepancy smoothed over 50 voxels: the height stands for it.
double smoothedSum(const Input& input) {
    Progress progress;
    const NeighbourIndex index(input.cloud);
    std::vector<double> smoothed(input.cloud.size());
    index.forEachKNearest(
        input.cloud, 50,
        [&](std::size_t i, std::span<const Neighbour> near) {
            double sum = 0.0;
            for (const Neighbour& neighbour : near)
                sum += input.cloud[neighbour.index].z();
            smoothed[i] = sum / static_cast<double>(near.size());
        },
        progress);
    return std::accumulate(smoothed.begin(), smoothed.end(), 0.0);
}

double clusterCount(const Input& input) {
    Progress progress;
    const MergeSequence sequence = mergeSequence(input.cloud, Linkage::Centroid, input.length_m, progress);
    const std::vector<std::uint32_t> labels = clustersAt(sequence, input.length_m);
    return 1.0 + *std::ranges::max_element(labels);
}

double readInput(const Input& input) {
    return readPoints(input.cloudFile);
}

double detectInput(const Input& input) {
    if (input.referenceFile.empty()) throw Error("--reference", "is needed for this stage", "give a reference map");
    return discrepantVoxels(input.cloudFile, input.referenceFile, input.isAligned);
}

/// Their work begins with the file.
bool readsItself(const std::string& stage) {
    return stage == "read" || stage == "detect";
}

const std::map<std::string, std::function<double(const Input&)>>& stages() {
    static const std::map<std::string, std::function<double(const Input&)>> all{
        {"nearest", meanNearestDistance}, {"outliers", keptPoints}, {"voxels", voxelCount}, {"smoothing", smoothedSum},
        {"clusters", clusterCount},       {"read", readInput},      {"detect", detectInput}};
    return all;
}

double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Drags threshold and cutoff over discrepancies drawn on the cloud.
nlohmann::json draggedThreshold(const Input& input, int rounds) {
    const auto field = drawnField(input.cloud, 1);
    std::vector<double> milliseconds;
    for (int round = 0; round < rounds; ++round) {
        LiveCandidates live(field, 0.02, 0.0, Transform::Identity());
        for (const CandidateSettings& settings :
             dragPath(*field, 300, input.fewestAbove, input.mostAbove, static_cast<std::uint64_t>(round))) {
            Progress progress;
            const auto begin = std::chrono::steady_clock::now();
            live.find(settings, progress);
            milliseconds.push_back(1000.0 * secondsSince(begin));
        }
    }
    return {{"stage", "threshold-drag"},
            {"points", input.cloud.size()},
            {"moves", milliseconds.size()},
            {"median_ms", quantileOf(milliseconds, 0.5)},
            {"p95_ms", quantileOf(milliseconds, 0.95)},
            {"greatest_ms", quantileOf(milliseconds, 1.0)}};
}

nlohmann::json timed(const std::string& stage, const Input& input, int rounds) {
    const std::size_t readingPeak = peakMemory();
    const std::size_t before = restartPeakMemory();
    nlohmann::json result{{"stage", stage}};
    if (!readsItself(stage)) result["points"] = input.cloud.size();
    for (int round = 0; round < rounds; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        result["result"] = stages().at(stage)(input);
        result["seconds"].push_back(secondsSince(begin));
    }
    result["peak_memory_bytes"] = std::max(readingPeak, peakMemory());
    result["stage_memory_bytes"] = peakMemory() - before;
    return result;
}

}  // namespace
}  // namespace fodscope

int main(int argc, char** argv) {
    CLI::App app("Times one stage of Fodscope's core");
    std::string stage;
    int rounds = 1;
    fodscope::Input input;
    std::vector<std::string> names;
    for (const auto& [name, run] : fodscope::stages())
        names.push_back(name);
    names.push_back("threshold-drag");
    app.add_option("stage", stage, "what to time")->required()->check(CLI::IsMember(names));
    app.add_option("--cloud", input.cloudFile, "PCD or PLY")->required()->check(CLI::ExistingFile);
    app.add_option("--reference", input.referenceFile, "PCD or PLY; for nearest and detect")->check(CLI::ExistingFile);
    app.add_flag("--aligned", input.isAligned, "detect: the cloud is in the reference's frame, do not register it");
    app.add_option("--length", input.length_m, "voxel size or cutoff, metres")->check(CLI::PositiveNumber);
    app.add_option("--rounds", rounds, "how often")->check(CLI::Range(1, 1000));
    app.add_option("--fewest", input.fewestAbove, "threshold-drag: fewest voxels above the threshold")
        ->check(CLI::PositiveNumber);
    app.add_option("--most", input.mostAbove, "threshold-drag: most voxels above it")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    try {
        if (!fodscope::readsItself(stage)) {
            input.cloud = fodscope::readPointCloud(input.cloudFile).points;
            if (!input.referenceFile.empty()) input.reference = fodscope::readPointCloud(input.referenceFile).points;
        }
        std::cout << (stage == "threshold-drag" ? fodscope::draggedThreshold(input, rounds)
                                                : fodscope::timed(stage, input, rounds))
                  << "\n";
    } catch (const std::exception& problem) {
        std::cerr << "error: " << problem.what() << "\n";
        return 1;
    }
    return 0;
}
