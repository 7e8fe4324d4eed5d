// SPDX-License-Identifier: MIT
#include "ui/panels/StartPoseDialog.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "ui/panels/PanelParts.h"
#include "ui/session/FileDialogs.h"
#include "ui/session/InspectionController.h"

namespace fodscope {
namespace {

std::optional<double> numberIn(QString text) {
    bool isNumber = false;
    const double value = text.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

std::optional<Pose2> typedPose(const QString& x, const QString& y, const QString& yaw_deg) {
    const auto xNumber = numberIn(x);
    const auto yNumber = numberIn(y);
    const auto yawNumber = numberIn(yaw_deg);
    if (!xNumber || !yNumber || !yawNumber) return std::nullopt;
    return Pose2{*xNumber, *yNumber, wrapAngle(radiansFromDegrees(*yawNumber))};
}

StartPoseDialog::StartPoseDialog(InspectionController& controller, FileDialogs& files, QWidget* parent)
    : QDialog(parent), controller_(controller), files_(files) {
    setObjectName(QStringLiteral("startPose"));
    setWindowTitle(tr("Known start pose"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 16, 16, 16);
    column->setSpacing(12);
    auto* explanation =
        new QLabel(tr("Where the map begins in the reference: the place and heading of the robot's first "
                      "pose. A few decimetres and ten degrees off are good enough."),
                   this);
    explanation->setWordWrap(true);
    column->addWidget(explanation);
    auto* form = new QFormLayout;
    const auto line = [&](const QString& name, const char* id, const QString& help) {
        auto* edit = new QLineEdit(this);
        edit->setObjectName(QString::fromLatin1(id));
        edit->setAlignment(Qt::AlignRight);
        edit->setToolTip(help);
        form->addRow(name, edit);
        connect(edit, &QLineEdit::textEdited, this, &StartPoseDialog::refresh);
        return edit;
    };
    x_ = line(tr("x (m)"), "startPose.x", tr("In the reference frame"));
    y_ = line(tr("y (m)"), "startPose.y", tr("In the reference frame"));
    yaw_ = line(tr("yaw (°)"), "startPose.yaw", tr("Heading, counter-clockwise from the reference's x axis"));
    column->addLayout(form);
    auto* buttons = new QHBoxLayout;
    auto* file = new QPushButton(tr("From a file…"), this);
    file->setObjectName(QStringLiteral("startPose.file"));
    file->setAutoDefault(false);
    file->setToolTip(tr("A CSV of 4 rows of 4 numbers, reference from map"));
    use_ = new QPushButton(tr("Align from here"), this);
    use_->setObjectName(QStringLiteral("startPose.use"));
    setButtonRole(use_, ButtonRole::Primary);
    buttons->addWidget(file);
    buttons->addStretch();
    buttons->addWidget(use_);
    column->addLayout(buttons);
    connect(file, &QPushButton::clicked, this, [this] {
        const QString chosen =
            files_.openFile(this, tr("Start pose, reference from map"), tr("Transforms (*.csv);;All files (*)"));
        if (chosen.isEmpty()) return;
        controller_.loadStartPose(chosen);
        accept();
    });
    connect(use_, &QPushButton::clicked, this, [this] {
        if (const auto pose = typedPose(x_->text(), y_->text(), yaw_->text())) {
            controller_.setStartPose(*pose);
            accept();
        }
    });
    refresh();
}

void StartPoseDialog::open() {
    const auto& detection = controller_.state().detection;
    const Pose2 pose = detection ? poseFromTransform(detection->registration.T_reference_from_map) : Pose2{};
    x_->setText(QString::number(pose.x_m, 'f', 2));
    y_->setText(QString::number(pose.y_m, 'f', 2));
    yaw_->setText(QString::number(degreesFromRadians(pose.yaw_rad), 'f', 1));
    refresh();
    show();
    raise();
    activateWindow();
    x_->selectAll();
    x_->setFocus();
}

void StartPoseDialog::refresh() {
    const bool ready = typedPose(x_->text(), y_->text(), yaw_->text()).has_value();
    use_->setEnabled(ready);
    use_->setToolTip(ready ? tr("Aligns the map from this pose and detects")
                           : tr("Not now: x, y and yaw must be numbers"));
}

}  // namespace fodscope
