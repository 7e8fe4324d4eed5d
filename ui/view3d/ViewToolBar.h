// SPDX-License-Identifier: MIT
#pragma once

#include <QString>
#include <QWidget>
#include <optional>
#include <vector>

#include "ui/theme/Icons.h"
#include "ui/view3d/View3D.h"

class QLabel;
class QMenu;
class QSlider;
class QToolButton;

namespace fodscope {

/// The slim bar over the 3D view: layers, standard views, fit, peel, measure, picture.
class ViewToolBar : public QWidget {
    Q_OBJECT

  public:
    struct LayerRow {
        ViewLayer layer;
        bool visible;
        double opacity;
    };

    explicit ViewToolBar(QWidget* parent);

    /// Those that have data.
    void setLayers(std::vector<LayerRow> rows) { rows_ = std::move(rows); }
    void setHeights(double lowest_m, double highest_m);
    void setPeelHeight(std::optional<double> height_m);
    void setMeasuring(bool measuring);

  signals:
    /// Before the layers are shown: setLayers() is due.
    void layersAsked();
    void layerVisible(fodscope::ViewLayer layer, bool visible);
    void layerOpacity(fodscope::ViewLayer layer, double opacity);
    void viewChosen(fodscope::StandardView view);
    void fitChosen();
    void peelChosen(std::optional<double> height_m);
    void measureChosen(bool measuring);
    void pictureChosen();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QToolButton* addButton(Icon icon, const QString& name, const QString& tip);
    void addSeparator();
    void fillLayersMenu();
    QWidget* layerRowWidget(const LayerRow& row);
    void choosePeel();
    double heightOf(int position) const;
    void showHeight(double height_m);

    std::vector<LayerRow> rows_;
    double lowest_m_ = 0.0;
    double highest_m_ = 3.0;
    QMenu* layersMenu_ = nullptr;
    QToolButton* peel_ = nullptr;
    QSlider* peelSlider_ = nullptr;
    QLabel* peelHeight_ = nullptr;
    QToolButton* measure_ = nullptr;
};

}  // namespace fodscope
