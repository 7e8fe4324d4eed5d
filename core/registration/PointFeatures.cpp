// SPDX-License-Identifier: MIT
#include "core/registration/PointFeatures.h"

#include <pcl/features/fpfh.h>
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <limits>

#include "core/cloud/NeighbourIndex.h"

namespace fodscope {
namespace {

using PclPoints = pcl::PointCloud<pcl::PointXYZ>;
using PclNormals = pcl::PointCloud<pcl::Normal>;
using Fpfh = pcl::FPFHEstimation<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33>;

constexpr const char* kStage = "describing the surface for a coarse alignment";
constexpr int kBins = 11;

struct Neighbourhood {
    pcl::Indices indices;
    std::vector<float> squaredDistances_m2;
};

Neighbourhood neighbourhood(const NeighbourIndex& index, const Eigen::Vector3d& point, double radius_m) {
    Neighbourhood found;
    for (const Neighbour& neighbour : index.withinRadius(point, radius_m)) {
        found.indices.push_back(static_cast<pcl::index_t>(neighbour.index));
        found.squaredDistances_m2.push_back(static_cast<float>(neighbour.squaredDistance_m2));
    }
    return found;
}

PclPoints pclPoints(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& origin) {
    PclPoints cloud;
    cloud.reserve(points.size());
    for (const Eigen::Vector3d& point : points) {
        // PCL counts in float: near the origin its digits suffice wherever the map lies.
        const Eigen::Vector3f local = (point - origin).cast<float>();
        cloud.emplace_back(local.x(), local.y(), local.z());
    }
    return cloud;
}

PclNormals normalsOf(const PclPoints& cloud, std::span<const Eigen::Vector3d> points, const NeighbourIndex& index,
                     double radius_m, Progress& progress) {
    PclNormals normals;
    normals.resize(cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        if (i % 256 == 0) progress.report(kStage, 0.3 * static_cast<double>(i) / static_cast<double>(cloud.size()));
        pcl::Normal& normal = normals[i];
        Eigen::Vector4f plane;
        const Neighbourhood near = neighbourhood(index, points[i], radius_m);
        if (near.indices.size() < 3 || !pcl::computePointNormal(cloud, near.indices, plane, normal.curvature)) {
            plane = Eigen::Vector4f::UnitZ();
        }
        pcl::flipNormalTowardsViewpoint(cloud[i], 0.0F, 0.0F, 0.0F, plane);
        normal.getNormalVector3fMap() = plane.head<3>();
    }
    return normals;
}

struct Histograms {
    Eigen::MatrixXf first;
    Eigen::MatrixXf second;
    Eigen::MatrixXf third;
};

}  // namespace

std::vector<PointFeature> pointFeatures(std::span<const Eigen::Vector3d> points, double normalRadius_m,
                                        double featureRadius_m, Progress& progress) {
    const NeighbourIndex index(points);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points)
        middle += point;
    middle /= static_cast<double>(points.size());
    const PclPoints cloud = pclPoints(points, middle);
    const PclNormals normals = normalsOf(cloud, points, index, normalRadius_m, progress);

    // The steps of FPFHEstimation::compute point by point, which can be cancelled.
    Fpfh fpfh;
    const auto count = static_cast<Eigen::Index>(points.size());
    Histograms simple{Eigen::MatrixXf::Zero(count, kBins), Eigen::MatrixXf::Zero(count, kBins),
                      Eigen::MatrixXf::Zero(count, kBins)};
    std::vector<Neighbourhood> neighbourhoods(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % 256 == 0) progress.report(kStage, 0.3 + 0.4 * static_cast<double>(i) / static_cast<double>(count));
        neighbourhoods[i] = neighbourhood(index, points[i], featureRadius_m);
        fpfh.computePointSPFHSignature(cloud, normals, static_cast<pcl::index_t>(i), static_cast<int>(i),
                                       neighbourhoods[i].indices, simple.first, simple.second, simple.third);
    }
    std::vector<PointFeature> features(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i % 256 == 0) progress.report(kStage, 0.7 + 0.3 * static_cast<double>(i) / static_cast<double>(count));
        Eigen::VectorXf histogram = Eigen::VectorXf::Zero(3 * kBins);
        fpfh.weightPointSPFHSignature(simple.first, simple.second, simple.third, neighbourhoods[i].indices,
                                      neighbourhoods[i].squaredDistances_m2, histogram);
        std::copy_n(histogram.data(), features[i].size(), features[i].begin());
    }
    return features;
}

}  // namespace fodscope
