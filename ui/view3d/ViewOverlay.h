// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/theme/Theme.h"
#include "ui/view3d/LabelPlacement.h"
#include "ui/view3d/OrbitCamera.h"
#include "ui/view3d/View3D.h"

namespace fodscope {

/// The flat drawing over the 3D picture: labels with leader lines, legend, scale bar, axes, measurement, hints. It
/// lets the mouse through.
class ViewOverlay : public QWidget {
    Q_OBJECT

  public:
    enum class LabelKind { Candidate, Waypoint };
    struct Label {
        LabelKind kind = LabelKind::Candidate;
        QString id;
        QPointF anchor;
        QColor colour;
        bool selected = false;
        StatusKind state = StatusKind::Neutral;
    };
    struct Legend {
        ScalarStyle style;
        bool anyUnknown = false;
    };
    struct Measurement {
        std::optional<QPointF> from;
        std::optional<QPointF> to;
        QString text;
    };

    explicit ViewOverlay(QWidget* parent);

    void setLabels(std::vector<Label> labels);
    void setLegend(std::optional<Legend> legend);
    void setCamera(const OrbitCamera& camera);
    void setMeasurement(const Measurement& measurement);
    void setHint(const QPointF& position, const QString& text);
    void setMessage(const QString& message);
    /// Kept free of labels.
    void setToolBarArea(const QRectF& area);
    /// Empty without a legend.
    QRectF legendArea() const;
    const Label* labelAt(const QPointF& position) const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void place();
    void paintLabels(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    double scaleLength_m() const;
    void paintCorner(QPainter& painter) const;
    void paintAxes(QPainter& painter) const;
    void paintScaleBar(QPainter& painter) const;
    void paintMeasurement(QPainter& painter) const;
    void paintHint(QPainter& painter) const;
    void paintMessage(QPainter& painter) const;

    std::vector<Label> labels_;
    std::vector<PlacedLabel> places_;
    std::optional<Legend> legend_;
    OrbitCamera camera_;
    Measurement measurement_;
    QPointF hintPosition_;
    QString hint_;
    QString message_;
    QRectF toolBar_;
};

}  // namespace fodscope
