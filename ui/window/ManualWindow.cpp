// SPDX-License-Identifier: MIT
#include "ui/window/ManualWindow.h"

#include <QScrollBar>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include "core/common/Files.h"
#include "ui/commands/WindowCommands.h"
#include "ui/session/Resources.h"

namespace fodscope {

ManualWindow::ManualWindow(QWidget* parent) : QWidget(parent, Qt::Window), text_(new QTextBrowser(this)) {
    setObjectName(QStringLiteral("manual"));
    setWindowTitle(tr("Fodscope manual"));
    text_->setObjectName(QStringLiteral("manual.text"));
    text_->setFrameShape(QFrame::NoFrame);
    text_->document()->setDocumentMargin(24);
    text_->setMarkdown(QString::fromStdString(readTextFile(resourceFile("manual/manual.md"))));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(text_);
    resize(820, 720);
}

void ManualWindow::showStep(std::optional<Step> step) {
    text_->moveCursor(QTextCursor::Start);
    if (!step) return;
    // The chapters of the steps are headed as the steps are: "3 Candidates".
    const QString heading = QStringLiteral("%1 %2").arg(static_cast<int>(*step) + 1).arg(stepName(*step));
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        if (block.blockFormat().headingLevel() == 0 || block.text() != heading) continue;
        // Going to the end first puts the heading at the top of the window instead of at its lower edge.
        text_->moveCursor(QTextCursor::End);
        text_->setTextCursor(QTextCursor(block));
        return;
    }
}

}  // namespace fodscope
