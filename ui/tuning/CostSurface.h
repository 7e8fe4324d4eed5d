// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QWidget>
#include <optional>

#include "ui/tuning/CostGrid.h"

namespace fodscope {

/// How an axis writes its values.
struct AxisStyle {
    QString title;
    QString unit;
    double displayFactor = 1.0;
    int decimals = 2;
};

/// The cost over cutoff and threshold as a picture: legend, the best cell marked, the chosen one framed, the settings
/// in effect as a cross. A click or the arrow keys choose a cell; the pointer reads values.
class CostSurface : public QWidget {
    Q_OBJECT

  public:
    explicit CostSurface(QWidget* parent = nullptr);

    /// Colours over a range that stays while the slider of least points moves.
    void setGrid(const CostGrid& grid, const CostRange& range);
    void setAxes(const AxisStyle& cutoff, const AxisStyle& threshold);
    void setBest(std::optional<CostCell> best);
    void setChosen(std::optional<CostCell> chosen);
    std::optional<CostCell> chosen() const { return chosen_; }
    /// Where the settings in effect lie, in the axes' values; may be outside.
    void setCurrent(double cutoff_m, double threshold);

    std::optional<CostCell> cellAt(const QPointF& position) const;
    QPointF centreOf(const CostCell& cell) const;
    QSize sizeHint() const override { return {620, 400}; }
    QSize minimumSizeHint() const override { return {360, 240}; }

  signals:
    void cellHovered(const std::optional<fodscope::CostCell>& cell);
    void cellChosen(const fodscope::CostCell& cell);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QRectF plotArea() const;
    QRectF cellArea(const CostCell& cell) const;
    void paintAxes(QPainter& painter, const QRectF& area) const;
    void paintMarks(QPainter& painter, const QRectF& area) const;
    void paintLegend(QPainter& painter, const QRectF& area) const;
    void hover(std::optional<CostCell> cell);

    CostGrid grid_;
    CostRange range_;
    QImage image_;
    AxisStyle cutoffAxis_;
    AxisStyle thresholdAxis_;
    std::optional<CostCell> best_;
    std::optional<CostCell> chosen_;
    std::optional<CostCell> hovered_;
    std::optional<QPointF> current_;
};

}  // namespace fodscope
