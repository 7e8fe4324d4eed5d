// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <QRgb>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/common/Geometry.h"
#include "ui/view3d/OrbitCamera.h"

class vtkRenderer;

namespace fodscope {

/// Points of a layer that are drawn alike.
struct PointGroup {
    std::vector<std::int64_t> indices;
    /// Times the layer's point size.
    double sizeFactor = 1.0;
    double opacity = 1.0;
};

/// Median distance to the nearest neighbour, from a few points; 0 for fewer than two.
double typicalSpacing(std::span<const Eigen::Vector3f> points);

/// A cloud as plain vertices, which even a machine without graphics card can draw by the million.
class PointLayer {
  public:
    explicit PointLayer(vtkRenderer* renderer);
    ~PointLayer();
    PointLayer(const PointLayer&) = delete;
    PointLayer& operator=(const PointLayer&) = delete;

    /// Copies; one group of all points in grey until told otherwise.
    void setPoints(std::span<const Eigen::Vector3d> points);
    /// The same in one go, for points that change while a slider is dragged. spacing_m() stays as it was.
    void setPoints(std::span<const Eigen::Vector3d> points, std::span<const QRgb> colours,
                   std::vector<PointGroup> groups);
    void measureSpacing() { spacing_m_ = typicalSpacing(points_); }
    /// One for each point.
    void setColours(std::span<const QRgb> colours);
    void setGroups(std::vector<PointGroup> groups);
    void setOneGroup();
    void setTransform(const Transform& transform);

    void setVisible(bool visible);
    void setOpacity(double opacity);
    void setPeelHeight(std::optional<double> height_m);
    void setPointSize(double size_px);
    /// Draws a part of the points while the camera moves.
    void setCoarse(bool coarse);

    bool empty() const { return points_.empty(); }
    const std::vector<Eigen::Vector3f>& points() const { return points_; }
    const Bounds& bounds() const { return bounds_; }
    /// Typical distance to the nearest neighbour.
    double spacing_m() const { return spacing_m_; }

  private:
    class Actors;
    void copyPoints(std::span<const Eigen::Vector3d> points);
    void rebuild();

    std::unique_ptr<Actors> actors_;
    std::vector<Eigen::Vector3f> points_;
    std::vector<PointGroup> groups_;
    Bounds bounds_;
    double spacing_m_ = 0.02;
    double opacity_ = 1.0;
    double size_px_ = 2.0;
    bool visible_ = true;
    bool coarse_ = false;
    std::optional<double> peel_m_;
};

}  // namespace fodscope
