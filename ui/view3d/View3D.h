// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <QColor>
#include <QImage>
#include <QMetaType>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/common/Geometry.h"
#include "ui/theme/Theme.h"

namespace fodscope {

/// What the 3D view can show. Each can be hidden and made transparent.
enum class ViewLayer {
    Reference,
    ReferenceMesh,
    Map,
    Discrepancy,
    Candidates,
    Waypoints,
    Route,
    Trajectory,
    Robot,
    Grid
};
QString toString(ViewLayer layer);

enum class StandardView { Top, Front, Side, Isometric };

/// Viridis for amounts, Diverging for signed deviations from zero.
enum class ColourScale { Viridis, Diverging };

/// How a number at each point is coloured and what the legend says. Values, range and threshold in the same unit;
/// the legend shows them times `displayFactor`, followed by `unit` (metres as mm: 1000).
struct ScalarStyle {
    QString title;
    QString unit;
    double displayFactor = 1.0;
    int decimals = 2;
    /// The range is absolute: it does not change with the data, so that one colour means one value all day.
    double minimum = 0.0;
    double maximum = 1.0;
    ColourScale scale = ColourScale::Viridis;
    /// Values also lie under the minimum: the legend then says "≤" there, as it always says "≥" at the maximum.
    bool reachesBelow = false;
    /// What the legend calls points without a value; empty: "not known".
    QString unknownWord;
    /// What the pointer reads of a value; empty: the number with its unit.
    std::function<QString(double)> describe;
    /// Draws points without a value in full, in stripes, instead of faintly: where nothing is known matters as much.
    bool stripesUnknown = false;
    /// Values strictly greater are drawn larger and in full colour, others dimmed. Empty: all alike.
    std::optional<double> threshold;
};

struct ViewCandidate {
    QString id;
    std::vector<Eigen::Vector3d> points;
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    /// Invalid: the colour of the id, candidateColour(id).
    QColor colour;
    bool selected = false;
    /// Set aside or not decided by the operator's filter: drawn faintly, without label.
    bool faint = false;
    StatusKind state = StatusKind::Attention;
};

struct ViewWaypoint {
    QString id;
    Pose2 pose;
    /// The cone ends here; empty: no cone.
    std::optional<Eigen::Vector3d> target;
    StatusKind state = StatusKind::ToDo;
    bool selected = false;
};

struct ViewRobot {
    Pose2 pose;
    /// Old poses are drawn hollow.
    bool stale = false;
};

struct PickedPoint {
    ViewLayer layer = ViewLayer::Reference;
    /// Into the points given to that layer; for candidates into their list.
    std::size_t index = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    /// When it belongs to a candidate.
    QString candidateId;
};

/// The 3D view with its tool bar and legend. It takes plain data, all of it in the reference frame and in metres, and
/// knows nothing of inspections. Data is copied; NaN values are drawn as "not known", never as zero.
class View3D : public QWidget {
    Q_OBJECT

  public:
    explicit View3D(QWidget* parent = nullptr);
    ~View3D() override;

    // What is shown ---------------------------------------------------------------------------------------------
    void setReference(std::span<const Eigen::Vector3d> points);
    /// Colours the reference by a value at each point (log det of its covariance) and shows its legend while the
    /// discrepancy is hidden. An empty span: plain again.
    void setReferenceValues(std::span<const double> values, const ScalarStyle& style);
    void setReferenceMesh(std::span<const Eigen::Vector3d> vertices,
                          std::span<const std::array<std::uint32_t, 3>> triangles);
    /// The map before it is compared.
    void setMap(std::span<const Eigen::Vector3d> points);
    /// Moves the map without copying it again (alignment by hand).
    void setMapTransform(const Transform& T_reference_from_map);
    void setDiscrepancy(std::span<const Eigen::Vector3d> points, std::span<const double> values,
                        const ScalarStyle& style);
    /// Fast enough to follow a slider.
    void setDiscrepancyThreshold(std::optional<double> threshold);
    void setCandidates(std::vector<ViewCandidate> candidates);
    /// Only changes which one is highlighted; empty: none.
    void setSelectedCandidate(const QString& id);
    /// Drawn at this height, which is the floor's.
    void setFloorHeight(double height_m);
    void setWaypoints(std::vector<ViewWaypoint> waypoints);
    void setRoute(std::span<const Eigen::Vector3d> points);
    void setTrajectory(std::span<const Eigen::Vector3d> points);
    void setRobot(const std::optional<ViewRobot>& robot);
    void clear();

    // Layers ----------------------------------------------------------------------------------------------------
    bool hasLayer(ViewLayer layer) const;
    bool isLayerVisible(ViewLayer layer) const;
    void setLayerVisible(ViewLayer layer, bool visible);
    double layerOpacity(ViewLayer layer) const;
    void setLayerOpacity(ViewLayer layer, double opacity);

    // Camera ----------------------------------------------------------------------------------------------------
    void setStandardView(StandardView view);
    void fit();
    /// 250 ms, interrupted by any touch of the view.
    void flyTo(const Eigen::Vector3d& centroid, double radius_m);
    void flyToCandidate(const QString& id);
    /// Clouds and mesh above this height are hidden, candidates never; empty: nothing is. Until it is set here or by
    /// the operator, a reference with a deck is opened below the deck.
    void setPeelHeight(std::optional<double> height_m);
    std::optional<double> peelHeight() const;

    // Picking ---------------------------------------------------------------------------------------------------
    /// While on, a click reports the point under the pointer and two clicks measure a distance.
    void setMeasuring(bool measuring);
    bool isMeasuring() const;
    /// @param position in this widget's coordinates
    std::optional<PickedPoint> pickAt(const QPoint& position) const;
    /// @return where a point is drawn, in this widget's coordinates; empty behind the camera
    std::optional<QPointF> positionOnScreen(const Eigen::Vector3d& point) const;

    // The rest --------------------------------------------------------------------------------------------------
    /// Shown in the middle while there is nothing to draw; empty: the picture only.
    void setEmptyMessage(const QString& message);
    void setToolBarVisible(bool visible);
    /// The view with legend and labels, as it is on the screen; renders first.
    QImage grabImage();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    void picked(const fodscope::PickedPoint& point);
    void hovered(const std::optional<fodscope::PickedPoint>& point);
    /// One click on a candidate or its label; an empty id when the background was clicked.
    void candidateSelected(const QString& id);
    /// Double click.
    void candidateActivated(const QString& id);
    void waypointSelected(const QString& id);
    void layerVisibilityChanged(fodscope::ViewLayer layer, bool visible);
    void peelHeightChanged();
    void distanceMeasured(double distance_m);
    void snapshotTaken(const QImage& image);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fodscope

Q_DECLARE_METATYPE(fodscope::ViewLayer)
Q_DECLARE_METATYPE(fodscope::PickedPoint)
Q_DECLARE_METATYPE(std::optional<fodscope::PickedPoint>)
