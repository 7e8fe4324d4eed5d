// SPDX-License-Identifier: MIT
#include "ui/panels/StartPage.h"

#include <QAbstractButton>
#include <QDateTime>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/commands/CommandSet.h"
#include "ui/session/RecentSessions.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

constexpr int kChoiceWidth_px = 280;
constexpr int kChoiceHeight_px = 148;
constexpr int kRecentShown = 6;

/// A large choice: picture, name, what it is.
class Choice : public QAbstractButton {
  public:
    Choice(Icon picture, const QString& title, const QString& what, bool primary, QWidget* parent)
        : QAbstractButton(parent), picture_(picture), title_(title), what_(what), primary_(primary) {
        setFixedSize(kChoiceWidth_px, kChoiceHeight_px);
        setAccessibleName(title);
        setCursor(Qt::PointingHandCursor);
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        const Theme theme = currentTheme();
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const bool active = underMouse() || hasFocus();
        painter.setPen(QPen(active || primary_ ? theme.accent : theme.line, active ? 2 : 1));
        painter.setBrush(active ? theme.hover : theme.surface1);
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), metrics::kRadius_px, metrics::kRadius_px);
        const QColor ink = primary_ ? theme.accent : theme.text;
        painter.drawPixmap(20, 20, iconPixmap(picture_, ink, metrics::kLargeIcon_px, devicePixelRatioF()));
        painter.setPen(theme.text);
        painter.setFont(fontFor(TextRole::Heading));
        painter.drawText(QRect(20, 52, width() - 40, 24), Qt::AlignLeft | Qt::AlignVCenter, title_);
        painter.setPen(theme.muted);
        painter.setFont(fontFor(TextRole::Body));
        painter.drawText(QRect(20, 78, width() - 40, height() - 90), Qt::AlignLeft | Qt::TextWordWrap, what_);
    }

  private:
    Icon picture_;
    QString title_;
    QString what_;
    bool primary_;
};

}  // namespace

StartPage::StartPage(const CommandSet& commands, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("startPage"));
    setSurface(this, SurfaceRole::Surface0);
    auto* title = new QLabel(tr("What would you like to inspect?"), this);
    setTextRole(title, TextRole::Number);
    auto* hint = new QLabel(tr("Drop a session, a reference or a map anywhere on this window to open it."), this);
    setTextRole(hint, TextRole::Muted);

    auto* choices = new QHBoxLayout;
    choices->setSpacing(16);
    const auto choice = [&](const char* name, Icon picture, const QString& text, const QString& what,
                            const QString& command, bool primary) {
        auto* button = new Choice(picture, text, what, primary, this);
        button->setObjectName(QString::fromLatin1(name));
        connect(button, &QAbstractButton::clicked, commands.find(command), &QAction::trigger);
        choices->addWidget(button);
    };
    choice("start.new", Icon::New, tr("New inspection"),
           tr("A reference and a map from files: CAD mesh, reference map or nominal maps; PCD or PLY."),
           QStringLiteral("session.new"), true);
    choice("start.builtin", Icon::Cube, tr("Built-in tank"),
           tr("A simulated tank with debris and a simulated robot, to learn and to try on."),
           QStringLiteral("session.builtin"), false);
    choice("start.open", Icon::Open, tr("Open session"), tr("Goes on where an inspection was left."),
           QStringLiteral("session.open"), false);
    choices->addStretch();

    auto* body = new QWidget(this);
    body->setFixedWidth(3 * kChoiceWidth_px + 2 * 16);
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    column->addWidget(title);
    column->addWidget(hint);
    column->addSpacing(12);
    column->addLayout(choices);
    column->addSpacing(20);
    recent_ = new QVBoxLayout;
    recent_->setSpacing(2);
    column->addLayout(recent_);

    auto* outer = new QVBoxLayout(this);
    outer->addStretch(2);
    outer->addWidget(body, 0, Qt::AlignHCenter);
    outer->addStretch(3);
}

void StartPage::showEvent(QShowEvent* event) {
    listRecent();
    QWidget::showEvent(event);
}

void StartPage::listRecent() {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    auto* heading = new QLabel(tr("Recent sessions"), this);
    setTextRole(heading, TextRole::Heading);
    recent_->addWidget(heading);
    const QStringList files = RecentSessions().files().mid(0, kRecentShown);
    if (files.isEmpty()) {
        auto* none = new QLabel(tr("None yet. Sessions you open are listed here."), this);
        setTextRole(none, TextRole::Muted);
        recent_->addWidget(none);
    }
    for (const QString& file : files) {
        const QFileInfo info(file);
        auto* button = new QPushButton(this);
        button->setObjectName(QStringLiteral("start.recent"));
        setButtonRole(button, ButtonRole::Quiet);
        button->setStyleSheet(QStringLiteral("text-align: left;"));
        button->setText(QStringLiteral("%1    %2    %3")
                            .arg(info.completeBaseName(),
                                 info.lastModified().toString(QStringLiteral("yyyy-MM-dd HH:mm")),
                                 info.absolutePath()));
        button->setToolTip(file);
        connect(button, &QPushButton::clicked, this, [this, file] { emit sessionChosen(file); });
        recent_->addWidget(button);
    }
}

}  // namespace fodscope
