// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>
#include <span>

#include "ui/widgets/Histogram.h"

namespace fodscope {

/// How many values there are of each size (logarithmic counts), with a threshold line to drag. The values are binned
/// once; dragging only counts. Keyboard: left/right one fine step, with Shift a coarse one, Home/End the ends.
class ThresholdHistogram : public QWidget {
    Q_OBJECT

  public:
    explicit ThresholdHistogram(QWidget* parent = nullptr);

    /// NaN are counted apart and never drawn as a value.
    void setValues(std::span<const double> values);
    void clear();

    /// Values are shown times `displayFactor` with `unit`: metres as mm with factor 1000. Steps are in the values'
    /// unit.
    void setDisplay(const QString& unit, double displayFactor, int decimals);
    void setSteps(double fine, double coarse);

    /// No signal is sent.
    void setThreshold(double threshold);
    double threshold() const { return threshold_; }
    /// Moves as a key press would: sends both signals. For window-wide `[` and `]`.
    void stepThreshold(int steps, bool coarse);

    /// Strictly greater than the threshold.
    std::size_t countAbove() const;
    double shareAbove() const;
    std::size_t countUnknown() const { return histogram_.unknown(); }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    void thresholdDragged(double threshold);
    void thresholdReleased(double threshold);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    QRectF plotArea() const;
    double xOf(double value) const;
    double valueAt(double x) const;
    void moveThreshold(double value);
    void paintBars(QPainter& painter, const QRectF& area) const;
    void paintAxis(QPainter& painter, const QRectF& area) const;
    void paintThreshold(QPainter& painter, const QRectF& area) const;
    QString text(double value) const;

    Histogram histogram_;
    QString unit_;
    double displayFactor_ = 1.0;
    int decimals_ = 2;
    double fineStep_ = 0.05;
    double coarseStep_ = 0.5;
    double threshold_ = 0.0;
    bool dragging_ = false;
    bool hovered_ = false;
};

}  // namespace fodscope
