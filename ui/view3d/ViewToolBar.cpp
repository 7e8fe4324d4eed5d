// SPDX-License-Identifier: MIT
#include "ui/view3d/ViewToolBar.h"

#include <QCheckBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidgetAction>

#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

constexpr int kPeelSteps = 200;

}  // namespace

ViewToolBar::ViewToolBar(QWidget* parent) : QWidget(parent) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(3, 3, 3, 3);
    layout->setSpacing(1);

    QToolButton* layers = addButton(Icon::Layers, tr("Layers"), tr("What is shown, and how transparent"));
    layersMenu_ = new QMenu(layers);
    layers->setMenu(layersMenu_);
    layers->setPopupMode(QToolButton::InstantPopup);
    layers->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    layers->setText(tr("Layers"));
    layers->setProperty("popupMode", QStringLiteral("2"));
    connect(layersMenu_, &QMenu::aboutToShow, this, &ViewToolBar::fillLayersMenu);
    addSeparator();

    const auto addView = [this](Icon picture, StandardView view, const QString& name) {
        QToolButton* button = addButton(picture, name, name);
        connect(button, &QToolButton::clicked, this, [this, view] { emit viewChosen(view); });
    };
    addView(Icon::ViewTop, StandardView::Top, tr("From above"));
    addView(Icon::ViewFront, StandardView::Front, tr("From the front"));
    addView(Icon::ViewSide, StandardView::Side, tr("From the side"));
    addView(Icon::ViewIso, StandardView::Isometric, tr("From a corner"));
    QToolButton* fit = addButton(Icon::Fit, tr("Show all"), tr("Show all (Home)"));
    connect(fit, &QToolButton::clicked, this, &ViewToolBar::fitChosen);
    addSeparator();

    peel_ = addButton(Icon::Peel, tr("Peel"), tr("Hide what is above a height, to look into the tank"));
    peel_->setCheckable(true);
    peelSlider_ = new QSlider(Qt::Horizontal, this);
    peelSlider_->setRange(0, kPeelSteps);
    peelSlider_->setValue(kPeelSteps);
    peelSlider_->setFixedWidth(110);
    peelSlider_->setAccessibleName(tr("Peel height"));
    peelHeight_ = new QLabel(this);
    peelHeight_->setMinimumWidth(52);
    peelHeight_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    layout->addWidget(peelSlider_);
    layout->addWidget(peelHeight_);
    peelSlider_->hide();
    peelHeight_->hide();
    connect(peel_, &QToolButton::toggled, this, &ViewToolBar::choosePeel);
    connect(peelSlider_, &QSlider::valueChanged, this, &ViewToolBar::choosePeel);
    addSeparator();

    measure_ = addButton(Icon::Ruler, tr("Measure"), tr("Measure between two points (click both; Esc ends)"));
    measure_->setCheckable(true);
    connect(measure_, &QToolButton::toggled, this, &ViewToolBar::measureChosen);
    QToolButton* picture = addButton(Icon::Camera, tr("Save a picture"), tr("Save a picture of this view"));
    connect(picture, &QToolButton::clicked, this, &ViewToolBar::pictureChosen);
}

QToolButton* ViewToolBar::addButton(Icon picture, const QString& name, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setIcon(icon(picture));
    button->setIconSize({18, 18});
    button->setAccessibleName(name);
    button->setToolTip(tip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    layout()->addWidget(button);
    return button;
}

void ViewToolBar::addSeparator() {
    auto* line = new QFrame(this);
    line->setFrameShape(QFrame::VLine);
    line->setFixedWidth(1);
    layout()->addWidget(line);
}

void ViewToolBar::setHeights(double lowest_m, double highest_m) {
    lowest_m_ = lowest_m;
    highest_m_ = std::max(highest_m, lowest_m + 0.01);
    if (peel_->isChecked()) showHeight(heightOf(peelSlider_->value()));
}

void ViewToolBar::setPeelHeight(std::optional<double> height_m) {
    const QSignalBlocker buttonBlocker(peel_);
    const QSignalBlocker sliderBlocker(peelSlider_);
    peel_->setChecked(height_m.has_value());
    peelSlider_->setVisible(height_m.has_value());
    peelHeight_->setVisible(height_m.has_value());
    if (height_m) {
        peelSlider_->setValue(qRound((*height_m - lowest_m_) / (highest_m_ - lowest_m_) * kPeelSteps));
        showHeight(*height_m);
    }
    adjustSize();
}

void ViewToolBar::setMeasuring(bool measuring) {
    const QSignalBlocker blocker(measure_);
    measure_->setChecked(measuring);
}

double ViewToolBar::heightOf(int position) const {
    return lowest_m_ + (highest_m_ - lowest_m_) * position / kPeelSteps;
}

void ViewToolBar::showHeight(double height_m) {
    peelHeight_->setText(tr("%1 m").arg(QLocale().toString(height_m, 'f', 2)));
}

void ViewToolBar::choosePeel() {
    const bool on = peel_->isChecked();
    if (on && !peelSlider_->isVisible() && peelSlider_->value() == kPeelSteps) {
        // The first use shows at once what it does: the top fifth, the deckhead, goes.
        const QSignalBlocker blocker(peelSlider_);
        peelSlider_->setValue(kPeelSteps * 4 / 5);
    }
    peelSlider_->setVisible(on);
    peelHeight_->setVisible(on);
    if (on) showHeight(heightOf(peelSlider_->value()));
    adjustSize();
    emit peelChosen(on ? std::optional<double>(heightOf(peelSlider_->value())) : std::nullopt);
}

void ViewToolBar::fillLayersMenu() {
    emit layersAsked();
    layersMenu_->clear();
    auto* panel = new QWidget(layersMenu_);
    auto* column = new QVBoxLayout(panel);
    column->setContentsMargins(8, 4, 8, 4);
    column->setSpacing(0);
    if (rows_.empty()) column->addWidget(new QLabel(tr("Nothing is loaded yet"), panel));
    for (const LayerRow& row : rows_)
        column->addWidget(layerRowWidget(row));
    auto* action = new QWidgetAction(layersMenu_);
    action->setDefaultWidget(panel);
    layersMenu_->addAction(action);
}

QWidget* ViewToolBar::layerRowWidget(const LayerRow& row) {
    auto* widget = new QWidget;
    auto* layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3 * metrics::kStep_px);
    auto* box = new QCheckBox(toString(row.layer), widget);
    box->setChecked(row.visible);
    auto* opacity = new QSlider(Qt::Horizontal, widget);
    opacity->setRange(5, 100);
    opacity->setValue(qRound(row.opacity * 100.0));
    opacity->setFixedWidth(96);
    opacity->setToolTip(tr("How opaque"));
    opacity->setAccessibleName(tr("Opacity of %1").arg(toString(row.layer)));
    opacity->setEnabled(row.visible);
    layout->addWidget(box, 1);
    layout->addWidget(opacity);
    const ViewLayer layer = row.layer;
    connect(box, &QCheckBox::toggled, this, [this, layer, opacity](bool on) {
        opacity->setEnabled(on);
        emit layerVisible(layer, on);
    });
    connect(opacity, &QSlider::valueChanged, this,
            [this, layer](int percent) { emit layerOpacity(layer, percent / 100.0); });
    return widget;
}

void ViewToolBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme theme = currentTheme();
    QColor ground = theme.surface1;
    ground.setAlphaF(0.92);
    painter.setBrush(ground);
    painter.setPen(QPen(theme.line, 1.0));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius_px, metrics::kRadius_px);
}

}  // namespace fodscope
