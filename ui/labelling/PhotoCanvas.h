// SPDX-License-Identifier: MIT
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/labelling/LabellingModel.h"
#include "ui/labelling/PhotoViewport.h"

namespace fodscope {

/// A photo with candidate outlines and boxes. Wheel zooms at the cursor, right or middle drag pans, left drag draws a
/// box, double click switches between fit and 1:1.
class PhotoCanvas : public QWidget {
    Q_OBJECT

  public:
    explicit PhotoCanvas(QWidget* parent = nullptr);

    /// Null: the sentence is shown instead.
    void showPhoto(const QImage& photo, const std::vector<CandidateOutline>& outlines);
    void showSentence(const QString& heading, const QString& sentence, bool isError);
    /// Boxes of the decision that counts, of the draft, and the one that waits for its label.
    void setBoxes(std::vector<PhotoLabel> decided, const LabelDraft& draft);
    void setOutlineShown(bool shown);
    void setContrast(bool on);
    void setBoxDrawing(bool allowed);

    bool outlineShown() const { return outlineShown_; }
    bool contrast() const { return contrast_; }
    const PhotoViewport& viewport() const { return viewport_; }

    void fit();
    /// Fit, 1:1, 2:1, and round again; at the middle of the view.
    void cycleZoom();
    void zoom(double factor);
    void pan(const QPointF& step);
    /// "fit", "100 %"
    QString zoomInWords() const;

  signals:
    void boxDrawn(const fodscope::PixelBox& box);
    void zoomChanged();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

  private:
    QSizeF imageSize() const { return photo_.size(); }
    const QImage& shown();
    void setViewport(const PhotoViewport& viewport, bool fitted);
    void scaleTo(double scale, const QPointF& anchor);
    void paintOutlines(QPainter& painter) const;
    void paintBoxes(QPainter& painter) const;
    void paintSentence(QPainter& painter) const;

    QImage photo_;
    QImage stretched_;
    std::vector<CandidateOutline> outlines_;
    std::vector<PhotoLabel> decided_;
    LabelDraft draft_;
    QString heading_;
    QString sentence_;
    bool isError_ = false;
    bool outlineShown_ = true;
    bool contrast_ = false;
    bool boxDrawing_ = true;
    PhotoViewport viewport_;
    bool fitted_ = true;
    std::optional<QPointF> boxStart_px_;
    QPointF boxEnd_px_;
    std::optional<QPointF> panFrom_;
};

}  // namespace fodscope
