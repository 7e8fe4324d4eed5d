// SPDX-License-Identifier: MIT
#include "ui/window/TitleRow.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/panels/StepTabs.h"
#include "ui/session/InspectionController.h"
#include "ui/theme/Icons.h"
#include "ui/theme/Theme.h"

namespace fodscope {

TitleRow::TitleRow(const InspectionController& controller, QWidget* parent) : QWidget(parent), controller_(controller) {
    setSurface(this, SurfaceRole::Surface1);
    auto* picture = new QLabel(this);
    picture->setPixmap(applicationIcon().pixmap(metrics::kLargeIcon_px));
    title_ = new QLabel(this);
    title_->setObjectName(QStringLiteral("title"));
    title_->setMinimumWidth(60);
    title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    setTextRole(title_, TextRole::Heading);
    detail_ = new QLabel(this);
    detail_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    setTextRole(detail_, TextRole::Caption);
    tabs_ = new StepTabs(controller, this);
    auto* names = new QVBoxLayout;
    names->setContentsMargins(0, 4, 0, 4);
    names->setSpacing(0);
    names->addWidget(title_);
    names->addWidget(detail_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 0, 0, 0);
    row->setSpacing(10);
    row->addWidget(picture);
    row->addLayout(names, 1);
    row->addWidget(tabs_);
    connect(tabs_, &StepTabs::stepRequested, this, &TitleRow::stepRequested);
    connect(&controller, &InspectionController::sessionChanged, this, &TitleRow::refresh);
    connect(&controller, &InspectionController::headerChanged, this, &TitleRow::refresh);
    refresh();
}

void TitleRow::setCurrent(Step step) {
    tabs_->setCurrent(step);
}

void TitleRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    refresh();
}

void TitleRow::refresh() {
    QString title = QStringLiteral("Fodscope");
    QString detail = tr("No inspection is open");
    if (controller_.isOpen()) {
        const InspectionHeader& header = controller_.state().header;
        title = QString::fromStdString(header.title.empty() ? header.tank : header.title);
        const QFileInfo file(controller_.sessionPath());
        if (title.isEmpty()) title = file.completeBaseName();
        detail = tr("%1 · saved as you go").arg(file.fileName());
        detail_->setToolTip(file.absoluteFilePath());
    }
    title_->setToolTip(title);
    title_->setText(QFontMetrics(title_->font()).elidedText(title, Qt::ElideRight, title_->width()));
    detail_->setText(QFontMetrics(detail_->font()).elidedText(detail, Qt::ElideMiddle, detail_->width()));
}

}  // namespace fodscope
