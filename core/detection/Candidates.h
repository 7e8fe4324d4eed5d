// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "core/common/Geometry.h"
#include "core/common/Progress.h"
#include "core/detection/Discrepancy.h"
#include "core/detection/HierarchicalClustering.h"

namespace fodscope {

enum class CentroidKind {
    Plain,               ///< the paper: mean of the cluster's voxels
    DiscrepancyWeighted  ///< the authors' published code: weighted by the smoothed discrepancy
};

struct CandidateSettings {
    Metric metric = Metric::Mahalanobis;
    /// A voxel is discrepant when its smoothed discrepancy is strictly greater. Unitless for Mahalanobis, metres for
    /// Euclidean. Paper's physical trials: 2.75, and 0.030 m. Chi-square: see testThreshold().
    double threshold = 2.75;
    /// Paper's clustering cutoff: 0.345 m (Mahalanobis), 0.279 m (Euclidean).
    double clusterCutoff_m = 0.345;
    Linkage linkage = Linkage::Centroid;
    /// Clusters with fewer voxels are dropped. Paper: 0 (Mahalanobis), 4 (Euclidean).
    int minimumPoints = 0;
    CentroidKind centroid = CentroidKind::Plain;

    bool operator==(const CandidateSettings&) const = default;
};

/// @return the paper's physical-trial values for a metric. The paper gives none for chi-square: the threshold of the
///         test's default settings, with the values that it gives for the Euclidean discrepancy, which is tested
CandidateSettings paperPhysicalCandidateSettings(Metric metric);

/// A cluster of discrepant voxels.
struct Candidate {
    /// "C-001"; never changes and is never used twice within an inspection.
    std::string id;
    /// Indices into the discrepancy field, ascending.
    std::vector<std::uint32_t> voxels;
    Eigen::Vector3d centroid_reference = Eigen::Vector3d::Zero();
    Eigen::Vector3d centroid_map = Eigen::Vector3d::Zero();
    /// Oriented size: length ≥ width in the plane of the floor (least-area rectangle), height vertical; metres. A voxel
    /// has its own edge, so a single one measures one voxel.
    Eigen::Vector3d size_m = Eigen::Vector3d::Zero();
    /// Direction of the length in the reference frame, in (−π/2, π/2].
    double lengthDirection_rad = 0.0;
    /// Height of the centroid over the reference's floor, metres.
    double heightAboveFloor_m = 0.0;
    double discrepancyMax = 0.0;
    double discrepancyMean = 0.0;
    /// Sum of the discrepancy over its voxels: the order of suspicion.
    double discrepancySum = 0.0;
};

struct CandidateSet {
    /// Most suspicious first.
    std::vector<Candidate> candidates;
    /// Per voxel of the field: index into `candidates`, or −1.
    std::vector<std::int32_t> candidateOfVoxel;
    /// Voxels above the threshold, before clustering.
    std::size_t pointsAboveThreshold = 0;
};

/// Threshold, clusters, least points, measures. Ids are C-001, C-002, … in order of suspicion; ties go to the first
/// voxel. Paper: "Discrepancy Query", last paragraph.
/// @param floorHeight_m height of the reference's floor, see floorHeight()
/// @throws Error for a threshold, cutoff or least count out of range, or Mahalanobis without covariances; Cancelled
CandidateSet findCandidates(const DiscrepancyField& field, const CandidateSettings& settings, double voxelSize_m,
                            double floorHeight_m, const Transform& T_reference_from_map, Progress& progress);

/// @return z of the reference's floor: the lowest well-supported horizontal layer (histogram of z in 1 cm steps)
double floorHeight(const ReferenceMap& reference);

}  // namespace fodscope
