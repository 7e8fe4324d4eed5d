// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <cstddef>
#include <optional>
#include <vector>

namespace fodscope {

struct PhotoSearchResult;
struct PhotoOutcome;

/// What the photos at one setting are worth.
struct RecallPoint {
    /// Share of the FOD that are on a photo.
    double recall = 0.0;
    /// Share of the photos that show FOD.
    double precision = 0.0;
    std::size_t photos = 0;

    bool operator==(const RecallPoint&) const = default;
};

/// What a search over photos came to, as it is drawn.
struct RecallPoints {
    /// Every setting with photos, each place once.
    std::vector<RecallPoint> all;
    /// The fewest photos at each recall, recall ascending.
    std::vector<RecallPoint> curve;
    double wantedRecall = 0.0;
};
RecallPoints recallPointsOf(const PhotoSearchResult& result);
/// @return empty without photos: there is no precision then
std::optional<RecallPoint> recallPointOf(const PhotoSearchResult& result, const PhotoOutcome& outcome);

/// Precision of the photos over the recall of FOD: all settings as dots, the fewest photos at each recall as a curve,
/// the settings in effect (the operating point) as a cross. A click or the arrow keys choose a point of the curve.
class RecallPlot : public QWidget {
    Q_OBJECT

  public:
    explicit RecallPlot(QWidget* parent = nullptr);

    void setPoints(const RecallPoints& points);
    /// The point of the curve with the wanted recall.
    void setBest(std::optional<std::size_t> best);
    void setChosen(std::optional<std::size_t> chosen);
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Where the settings in effect lie; empty: not known.
    void setInEffect(const std::optional<RecallPoint>& point);
    const std::optional<RecallPoint>& inEffect() const { return inEffect_; }

    /// The point of the curve that is nearest to a position.
    std::optional<std::size_t> pointAt(const QPointF& position) const;
    QPointF placeOf(const RecallPoint& point) const;
    QSize sizeHint() const override { return {620, 400}; }
    QSize minimumSizeHint() const override { return {360, 240}; }

  signals:
    void pointHovered(const std::optional<std::size_t>& point);
    void pointChosen(std::size_t point);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    QRectF plotArea() const;
    void paintAxes(QPainter& painter, const QRectF& area) const;
    void paintCurve(QPainter& painter) const;
    void paintMarks(QPainter& painter, const QRectF& area) const;
    void paintLegend(QPainter& painter, const QRectF& area) const;
    void hover(std::optional<std::size_t> point);

    RecallPoints points_;
    std::optional<std::size_t> best_;
    std::optional<std::size_t> chosen_;
    std::optional<std::size_t> hovered_;
    std::optional<RecallPoint> inEffect_;
};

}  // namespace fodscope
