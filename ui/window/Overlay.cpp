// SPDX-License-Identifier: MIT
#include "ui/window/Overlay.h"

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>

#include "ui/commands/CommandSet.h"
#include "ui/theme/Theme.h"

namespace fodscope {
namespace {

struct KeyLine {
    QString keys;
    QString what;
};

/// Keys that are no commands of the window: the labelling view's own.
std::vector<KeyLine> labellingKeys() {
    return {{QStringLiteral("1 … 9"), QObject::tr("Label the photo and go on")},
            {QStringLiteral("0"), QObject::tr("No FOD, and go on")},
            {QStringLiteral("U"), QObject::tr("Not sure, and go on")},
            {QStringLiteral("Shift+1 … 9"), QObject::tr("One label of several")},
            {QStringLiteral("← →"), QObject::tr("Previous and next photo")},
            {QStringLiteral("O"), QObject::tr("Outline of the candidate")},
            {QStringLiteral("C"), QObject::tr("Contrast")}};
}

std::vector<KeyLine> commandKeys(const CommandSet& commands) {
    std::vector<KeyLine> lines;
    for (const Command* command : commands.all()) {
        if (command->shortcut().isEmpty()) continue;
        const QString keys = command->shortcut().toString(QKeySequence::NativeText);
        lines.push_back({QString(keys).replace(QStringLiteral("Backtab"), QStringLiteral("Tab")), command->text()});
    }
    return lines;
}

}  // namespace

Overlay::Overlay(QWidget* window) : QWidget(window) {
    sheet_ = new QWidget(this);
    setSurface(sheet_, SurfaceRole::Surface1);
    window->installEventFilter(this);
    hide();
}

void Overlay::open() {
    setGeometry(parentWidget()->rect());
    placeSheet(size_);
    show();
    raise();
    setFocus();
}

void Overlay::placeSheet(const QSize& size) {
    size_ = size;
    const QSize fitting = size.boundedTo(parentWidget()->size() - QSize(48, 48));
    sheet_->resize(fitting);
    sheet_->move((parentWidget()->width() - fitting.width()) / 2,
                 std::max(24, (parentWidget()->height() - fitting.height()) / 3));
}

void Overlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0, 0, 0, 150));
}

void Overlay::mousePressEvent(QMouseEvent* event) {
    if (!sheet_->geometry().contains(event->pos())) hide();
}

bool Overlay::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible()) {
        setGeometry(parentWidget()->rect());
        placeSheet(size_);
    }
    return QWidget::eventFilter(watched, event);
}

ShortcutsOverlay::ShortcutsOverlay(const CommandSet& commands, QWidget* window) : Overlay(window) {
    setObjectName(QStringLiteral("shortcuts"));
    auto* column = new QVBoxLayout(sheet());
    column->setContentsMargins(24, 20, 24, 20);
    column->setSpacing(12);
    auto* title = new QLabel(tr("All keys"), sheet());
    setTextRole(title, TextRole::Heading);
    column->addWidget(title);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(6);
    std::vector<KeyLine> lines = commandKeys(commands);
    for (const KeyLine& line : labellingKeys())
        lines.push_back(line);
    const int rows = (static_cast<int>(lines.size()) + 1) / 2;
    for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
        auto* keys = new QLabel(lines[static_cast<std::size_t>(i)].keys, sheet());
        setTextRole(keys, TextRole::Emphasis);
        auto* what = new QLabel(lines[static_cast<std::size_t>(i)].what, sheet());
        setTextRole(what, TextRole::Body);
        grid->addWidget(keys, i % rows, i / rows * 3);
        grid->addWidget(what, i % rows, i / rows * 3 + 1);
    }
    grid->setColumnMinimumWidth(2, 24);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(4, 1);
    column->addLayout(grid);
    column->addStretch();
    auto* hint = new QLabel(tr("Esc closes this sheet."), sheet());
    setTextRole(hint, TextRole::Muted);
    column->addWidget(hint);
    placeSheet(QSize(760, rows * 26 + 130));
}

CommandPalette::CommandPalette(const CommandSet& commands, QWidget* window) : Overlay(window), commands_(commands) {
    setObjectName(QStringLiteral("palette"));
    line_ = new QLineEdit(sheet());
    line_->setObjectName(QStringLiteral("palette.line"));
    line_->setPlaceholderText(tr("Find a command by name"));
    list_ = new QListWidget(sheet());
    list_->setObjectName(QStringLiteral("palette.list"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setFocusPolicy(Qt::NoFocus);
    auto* column = new QVBoxLayout(sheet());
    column->setContentsMargins(12, 12, 12, 12);
    column->addWidget(line_);
    column->addWidget(list_, 1);
    placeSheet(QSize(560, 380));
    connect(line_, &QLineEdit::textChanged, this, &CommandPalette::filter);
    connect(line_, &QLineEdit::returnPressed, this, &CommandPalette::runCurrent);
    connect(list_, &QListWidget::itemActivated, this, &CommandPalette::runCurrent);
    connect(list_, &QListWidget::itemClicked, this, &CommandPalette::runCurrent);
    line_->installEventFilter(this);
}

void CommandPalette::open() {
    Overlay::open();
    line_->clear();
    filter({});
    line_->setFocus();
}

void CommandPalette::filter(const QString& text) {
    list_->clear();
    for (Command* command : commands_.all()) {
        if (!command->isEnabled() || !command->text().contains(text, Qt::CaseInsensitive)) continue;
        if (command->objectName() == QStringLiteral("help.palette")) continue;
        const QString key = command->shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(
            command->icon(), key.isEmpty() ? command->text() : tr("%1    %2").arg(command->text(), key), list_);
        item->setData(Qt::UserRole, command->objectName());
    }
    list_->setCurrentRow(0);
}

void CommandPalette::runCurrent() {
    const QListWidgetItem* item = list_->currentItem();
    if (item == nullptr) return;
    Command* command = commands_.find(item->data(Qt::UserRole).toString());
    hide();
    command->trigger();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (watched == line_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step != 0) {
            list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, std::max(0, list_->count() - 1)));
            return true;
        }
    }
    return Overlay::eventFilter(watched, event);
}

}  // namespace fodscope
