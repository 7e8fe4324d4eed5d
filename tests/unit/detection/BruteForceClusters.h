// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/detection/HierarchicalClustering.h"

namespace fodscope {

using Labels = std::vector<std::uint32_t>;

/// The definition step by step, in O(n³): of all pairs of clusters merge the closest; of equally close ones that with
/// the lowest first points. The centroid moves as the header says, so that ties are the same ties.
class BruteForceClusters {
  public:
    BruteForceClusters(std::span<const Eigen::Vector3d> points, Linkage linkage) : linkage_(linkage) {
        for (std::uint32_t i = 0; i < points.size(); ++i)
            clusters_.push_back({{i}, {points[i]}, points[i]});
    }

    Labels at(double cutoff_m) {
        while (mergeClosest(cutoff_m)) {
        }
        std::size_t count = 0;
        for (const Cluster& cluster : clusters_)
            count += cluster.members.size();
        Labels labels(count);
        for (std::uint32_t label = 0; label < clusters_.size(); ++label)
            for (const std::uint32_t member : clusters_[label].members)
                labels[member] = label;
        return labels;
    }

  private:
    /// In the order of their first points, which are the lowest ones.
    struct Cluster {
        std::vector<std::uint32_t> members;
        std::vector<Eigen::Vector3d> points;
        Eigen::Vector3d centroid;
    };

    static double square(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        const double x = a.x() - b.x();
        const double y = a.y() - b.y();
        const double z = a.z() - b.z();
        return x * x + y * y + z * z;
    }

    double squaredDistance(const Cluster& a, const Cluster& b) const {
        if (linkage_ == Linkage::Centroid) return square(a.centroid, b.centroid);
        double least = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& one : a.points)
            for (const Eigen::Vector3d& other : b.points)
                least = std::min(least, square(one, other));
        return least;
    }

    bool mergeClosest(double cutoff_m) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t first = 0;
        std::size_t second = 0;
        for (std::size_t i = 0; i < clusters_.size(); ++i) {
            for (std::size_t j = i + 1; j < clusters_.size(); ++j) {
                const double distance = squaredDistance(clusters_[i], clusters_[j]);
                if (!(distance < least)) continue;
                least = distance;
                first = i;
                second = j;
            }
        }
        if (!(std::sqrt(least) <= cutoff_m)) return false;
        Cluster& a = clusters_[first];
        const Cluster& b = clusters_[second];
        const auto na = static_cast<double>(a.points.size());
        const auto nb = static_cast<double>(b.points.size());
        a.centroid += (b.centroid - a.centroid) * (nb / (na + nb));
        a.members.insert(a.members.end(), b.members.begin(), b.members.end());
        a.points.insert(a.points.end(), b.points.begin(), b.points.end());
        clusters_.erase(clusters_.begin() + static_cast<std::ptrdiff_t>(second));
        return true;
    }

    Linkage linkage_;
    std::vector<Cluster> clusters_;
};

}  // namespace fodscope
