// SPDX-License-Identifier: MIT
#pragma once

#include <QRgb>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ui/theme/Theme.h"
#include "ui/view3d/MeshLayer.h"
#include "ui/view3d/Picking.h"
#include "ui/view3d/PointLayer.h"
#include "ui/view3d/ShapeLayer.h"
#include "ui/view3d/View3D.h"

namespace fodscope {

inline constexpr std::array kViewLayers = {ViewLayer::Reference,   ViewLayer::ReferenceMesh, ViewLayer::Map,
                                           ViewLayer::Discrepancy, ViewLayer::Candidates,    ViewLayer::Waypoints,
                                           ViewLayer::Route,       ViewLayer::Trajectory,    ViewLayer::Robot,
                                           ViewLayer::Grid};

/// Points above the threshold are that much larger.
inline constexpr double kAboveEmphasis = 1.7;

/// Values at the points of a cloud and how they are shown.
struct PointValues {
    std::vector<double> values;
    ScalarStyle style;
    bool anyUnknown = false;

    bool empty() const { return values.empty(); }
};

/// What the 3D view shows: the layers, their data and their state.
class ViewScene {
  public:
    /// @param top draws over what `renderer` draws
    ViewScene(vtkRenderer* renderer, vtkRenderer* top);

    void setTheme(const Theme& theme);
    void setReference(std::span<const Eigen::Vector3d> points);
    void setReferenceValues(std::span<const double> values, const ScalarStyle& style);
    void setReferenceMesh(std::span<const Eigen::Vector3d> vertices,
                          std::span<const std::array<std::uint32_t, 3>> triangles);
    void setMap(std::span<const Eigen::Vector3d> points);
    void setMapTransform(const Transform& T_reference_from_map);
    void setDiscrepancy(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                        const ScalarStyle& style);
    void setDiscrepancyThreshold(std::optional<double> threshold);
    void setCandidates(std::vector<ViewCandidate> candidates);
    void setSelectedCandidate(const QString& id);
    void setFloorHeight(double height_m);
    void setWaypoints(std::vector<ViewWaypoint> waypoints);
    void setRoute(std::span<const Eigen::Vector3d> points);
    void setTrajectory(std::span<const Eigen::Vector3d> points);
    void setRobot(const std::optional<ViewRobot>& robot);
    void clear();

    bool has(ViewLayer layer) const;
    bool isVisible(ViewLayer layer) const { return state(layer).visible; }
    void setVisible(ViewLayer layer, bool visible);
    double opacity(ViewLayer layer) const { return state(layer).opacity; }
    void setOpacity(ViewLayer layer, double opacity);
    void setPeelHeight(std::optional<double> height_m);
    std::optional<double> peelHeight() const { return peel_m_; }

    /// Of clouds and mesh, whether visible or not, so that hiding a layer does not move the camera.
    Bounds bounds() const;
    bool empty() const { return bounds().empty(); }
    void setPixelsPerMetre(double pixelsPerMetre);
    void setCoarse(bool coarse);
    std::optional<PickedPoint> pick(const ScreenProjection& projection, double x_px, double y_px) const;
    /// @return the values of what the legend explains, or null
    const PointValues* legend() const;
    /// @return the value shown at a picked point; empty when the layer has none
    std::optional<double> valueAt(const PickedPoint& point) const;

    const std::vector<ViewCandidate>& candidates() const { return candidates_; }
    const std::vector<ViewWaypoint>& waypoints() const { return waypoints_; }
    const std::optional<ViewRobot>& robot() const { return robot_; }
    double floorHeight_m() const { return floor_m_; }

  private:
    struct LayerState {
        bool visible = true;
        double opacity = 1.0;
    };

    LayerState& state(ViewLayer layer) { return states_[static_cast<std::size_t>(layer)]; }
    const LayerState& state(ViewLayer layer) const { return states_[static_cast<std::size_t>(layer)]; }
    PointLayer* pointLayer(ViewLayer layer);
    const PointLayer* pointLayer(ViewLayer layer) const;
    ShapeLayer* shapeLayer(ViewLayer layer);
    void apply(ViewLayer layer);
    void colourReference();
    void colourMap();
    void colourDiscrepancy();
    void drawDiscrepant();
    void buildCandidates();
    void markSelection();
    void buildShapes();

    Theme theme_;
    std::array<LayerState, kViewLayers.size()> states_;
    std::optional<double> peel_m_;
    double floor_m_ = 0.0;

    PointLayer reference_;
    PointLayer map_;
    /// With a threshold: all of its points as those that are not above it look. Where they are, the layer after it
    /// draws the ones above, larger. So a moved threshold changes only those.
    PointLayer discrepancy_;
    PointLayer discrepant_;
    PointLayer candidatePoints_;
    MeshLayer mesh_;
    ShapeLayer grid_;
    ShapeLayer waypointMarks_;
    ShapeLayer routeLine_;
    ShapeLayer trajectoryLine_;
    ShapeLayer robotMark_;
    ShapeLayer selection_;

    Transform T_reference_from_map_ = Transform::Identity();
    PointValues referenceValues_;
    PointValues discrepancyValues_;
    /// The points whose discrepancy is known, greatest first.
    std::vector<std::uint32_t> byDiscrepancy_;
    std::vector<ViewCandidate> candidates_;
    std::vector<std::uint32_t> candidateOfPoint_;
    std::vector<ViewWaypoint> waypoints_;
    std::vector<Eigen::Vector3d> route_;
    std::vector<Eigen::Vector3d> trajectory_;
    std::optional<ViewRobot> robot_;
};

}  // namespace fodscope
