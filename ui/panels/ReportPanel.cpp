// SPDX-License-Identifier: MIT
#include "ui/panels/ReportPanel.h"

#include <QCoreApplication>
#include <QDir>
#include <QLineEdit>

#include "ui/commands/CommandSet.h"
#include "ui/panels/Format.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope {
namespace {

struct HeaderField {
    const char* name;
    const char* label;
    std::string InspectionHeader::*member;
};

constexpr std::array<HeaderField, 5> kFields = {{
    {"title", QT_TRANSLATE_NOOP("fodscope", "Title"), &InspectionHeader::title},
    {"ship", QT_TRANSLATE_NOOP("fodscope", "Ship"), &InspectionHeader::ship},
    {"tank", QT_TRANSLATE_NOOP("fodscope", "Tank"), &InspectionHeader::tank},
    {"workOrder", QT_TRANSLATE_NOOP("fodscope", "Work order"), &InspectionHeader::workOrder},
    {"inspector", QT_TRANSLATE_NOOP("fodscope", "Inspector"), &InspectionHeader::inspector},
}};

/// Where something that is missing can be given.
Step stepFor(const InspectionState& state) {
    const Step open = firstOpenStep(state);
    return open == Step::Report ? Step::Label : open;
}

}  // namespace

ReportPanel::ReportPanel(InspectionController& controller, const CommandSet& commands, QWidget* parent)
    : PanelColumn(parent), controller_(controller) {
    setObjectName(QStringLiteral("panel.report"));
    auto* front = new Card(tr("Front page"), this);
    auto* form = new QFormLayout;
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(6);
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        fields_[i] = new QLineEdit(front);
        fields_[i]->setObjectName(QStringLiteral("report.") + QString::fromLatin1(kFields[i].name));
        fields_[i]->setPlaceholderText(tr("not recorded"));
        auto* label = new QLabel(QCoreApplication::translate("fodscope", kFields[i].label), front);
        setTextRole(label, TextRole::Muted);
        form->addRow(label, fields_[i]);
        connect(fields_[i], &QLineEdit::editingFinished, this, &ReportPanel::takeHeader);
    }
    front->body()->addLayout(form);
    column()->addWidget(front);

    missing_ = new Card(tr("Still missing"), this);
    chip_ = new StatusChip(missing_);
    missing_->addHeaderWidget(chip_);
    missingList_ = new QVBoxLayout;
    missingList_->setSpacing(4);
    missing_->body()->addLayout(missingList_);
    column()->addWidget(missing_);

    auto* issue = new Card(tr("Issue"), this);
    issue->body()->addWidget(makeText(
        tr("PDF and HTML of the same content, CSV of the candidates, JSON of the session."), TextRole::Muted, issue));
    auto* button = commands.makeButton(QStringLiteral("report.issue"), issue, ButtonRole::Primary);
    issue->body()->addWidget(button);
    issued_ = makeText({}, TextRole::Body, issue);
    issued_->setObjectName(QStringLiteral("report.issued"));
    issued_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    issue->body()->addWidget(issued_);
    column()->addWidget(issue);
    column()->addStretch();

    for (const auto signal : {&InspectionController::sessionChanged, &InspectionController::headerChanged,
                              &InspectionController::detectionChanged, &InspectionController::planChanged,
                              &InspectionController::photosChanged, &InspectionController::decisionsChanged})
        connect(&controller, signal, this, &ReportPanel::refresh);
    connect(&controller, &InspectionController::reportIssued, this, &ReportPanel::tellIssued);
    refresh();
}

void ReportPanel::refresh() {
    refreshHeader();
    refreshMissing();
}

void ReportPanel::refreshHeader() {
    const InspectionHeader& header = controller_.state().header;
    for (std::size_t i = 0; i < kFields.size(); ++i)
        if (!fields_[i]->hasFocus()) {
            fields_[i]->setText(QString::fromStdString(header.*kFields[i].member));
            fields_[i]->setCursorPosition(0);
        }
    const auto& reports = controller_.state().reports;
    issued_->setText(reports.empty() ? tr("Not issued yet.")
                                     : tr("Issued %1.").arg(counted(reports.size(), tr("time"), tr("times"))));
}

void ReportPanel::refreshMissing() {
    while (QLayoutItem* item = missingList_->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    if (!controller_.isOpen()) return;
    const std::vector<std::string> missing = controller_.reportModel().missing;
    chip_->setStatus(missing.empty() ? StatusKind::Clear : StatusKind::Attention,
                     missing.empty() ? tr("complete") : tr("draft"));
    for (const std::string& sentence : missing) {
        auto* line = makeText(QStringLiteral("• ") + QString::fromStdString(sentence), TextRole::Body, missing_);
        line->setObjectName(QStringLiteral("report.missing"));
        missingList_->addWidget(line);
    }
    if (missing.empty()) {
        missingList_->addWidget(makeText(tr("Nothing: the report can be issued."), TextRole::Body, missing_));
        return;
    }
    const Step step = stepFor(controller_.state());
    auto* link =
        makeText(QStringLiteral("<a href='step'>%1</a>").arg(tr("Go to step %1").arg(static_cast<int>(step) + 1)),
                 TextRole::Body, missing_);
    connect(link, &QLabel::linkActivated, this, [this, step] { emit stepRequested(step); });
    missingList_->addWidget(link);
}

void ReportPanel::takeHeader() {
    InspectionHeader header = controller_.state().header;
    for (std::size_t i = 0; i < kFields.size(); ++i)
        header.*kFields[i].member = fields_[i]->text().trimmed().toStdString();
    if (!(header == controller_.state().header)) controller_.setHeader(header);
}

void ReportPanel::tellIssued(const QString& folder) {
    refreshMissing();
    issued_->setText(tr("Issued: report.pdf, report.html, report.csv and report.json are in the folder %1.")
                         .arg(QDir(folder).dirName()));
    issued_->setToolTip(QDir::toNativeSeparators(folder));
}

}  // namespace fodscope
