// SPDX-License-Identifier: MIT
#include "ui/commands/WindowCommands.h"

#include <QFileInfo>

namespace fodscope {

QString stepName(Step step) {
    switch (step) {
        case Step::Reference:
            return QObject::tr("Reference");
        case Step::Map:
            return QObject::tr("Map");
        case Step::Candidates:
            return QObject::tr("Candidates");
        case Step::Visit:
            return QObject::tr("Visit");
        case Step::Label:
            return QObject::tr("Label");
        case Step::Report:
            return QObject::tr("Report");
    }
    return {};
}

GoToStepCommand::GoToStepCommand(CommandContext& context, Step step)
    : Command(context, QStringLiteral("step.%1").arg(static_cast<int>(step) + 1),
              QObject::tr("Step %1: %2").arg(static_cast<int>(step) + 1).arg(stepName(step))),
      step_(step) {
    setKeys({QKeySequence(QStringLiteral("Ctrl+%1").arg(static_cast<int>(step) + 1))});
}

void GoToStepCommand::run() {
    navigation().showStep(step_);
}

bool GoToStepCommand::isAvailable() const {
    return controller().isOpen();
}

FitViewsCommand::FitViewsCommand(CommandContext& context)
    : Command(context, QStringLiteral("view.fit"), QObject::tr("Show everything")) {
    setPicture(Icon::Fit);
    setKeys({QKeySequence(Qt::Key_Home)});
}

void FitViewsCommand::run() {
    navigation().fitViews();
}

bool FitViewsCommand::isAvailable() const {
    return controller().isOpen();
}

ToggleThemeCommand::ToggleThemeCommand(CommandContext& context)
    : Command(context, QStringLiteral("view.theme"), QObject::tr("Light or dark")) {
    setPicture(Icon::Sun);
    setKeys({QKeySequence(QStringLiteral("Ctrl+T"))});
}

void ToggleThemeCommand::run() {
    navigation().toggleTheme();
}

SettingsCommand::SettingsCommand(CommandContext& context)
    : Command(context, QStringLiteral("settings.all"), QObject::tr("All settings…")) {
    setPicture(Icon::Settings);
    setKeys({QKeySequence(QStringLiteral("Ctrl+,"))});
    setToolTip(QObject::tr("Every parameter of every stage, with presets and parameter files"));
}

void SettingsCommand::run() {
    navigation().showSettings();
}

bool SettingsCommand::isAvailable() const {
    return controller().isOpen();
}

QString SettingsCommand::obstacle() const {
    return QObject::tr("open an inspection first");
}

ShortcutsCommand::ShortcutsCommand(CommandContext& context)
    : Command(context, QStringLiteral("help.keys"), QObject::tr("All keys")) {
    setPicture(Icon::Keyboard);
    setKeys({QKeySequence(Qt::Key_Question), QKeySequence(QStringLiteral("Shift+?"))});
}

void ShortcutsCommand::run() {
    navigation().toggleShortcuts();
}

ManualCommand::ManualCommand(CommandContext& context)
    : Command(context, QStringLiteral("help.manual"), QObject::tr("Manual")) {
    setPicture(Icon::Help);
    setKeys({QKeySequence(Qt::Key_F1)});
    setToolTip(QObject::tr("Opens the manual at the current step"));
}

void ManualCommand::run() {
    navigation().showManual();
}

PaletteCommand::PaletteCommand(CommandContext& context)
    : Command(context, QStringLiteral("help.palette"), QObject::tr("Find a command…")) {
    setPicture(Icon::Search);
    setKeys({QKeySequence(QStringLiteral("Ctrl+K"))});
}

void PaletteCommand::run() {
    navigation().togglePalette();
}

LeaveCommand::LeaveCommand(CommandContext& context)
    : Command(context, QStringLiteral("view.leave"), QObject::tr("Step back")) {
    setKeys({QKeySequence(Qt::Key_Escape)});
    setToolTip(QObject::tr("Closes what is open on top, then drops the selection"));
}

void LeaveCommand::run() {
    navigation().leave();
}

NextUndecidedCommand::NextUndecidedCommand(CommandContext& context)
    : Command(context, QStringLiteral("label.next"), QObject::tr("Next undecided photo")) {
    setPicture(Icon::ChevronRight);
    setKeys({QKeySequence(Qt::Key_N)});
}

void NextUndecidedCommand::run() {
    navigation().showStep(Step::Label);
    navigation().nextUndecidedPhoto();
}

bool NextUndecidedCommand::isAvailable() const {
    return !controller().state().photos.empty();
}

LoadLabelSetCommand::LoadLabelSetCommand(CommandContext& context)
    : Command(context, QStringLiteral("label.set"), QObject::tr("Use another label set…")) {
    setPicture(Icon::Label);
    setToolTip(QObject::tr("A YAML file with the names and keys of the labels"));
}

void LoadLabelSetCommand::run() {
    const QString file =
        files().openFile(window(), QObject::tr("Label set"), QObject::tr("Label sets (*.yaml *.yml);;All files (*)"));
    if (!file.isEmpty()) controller().loadLabelSet(file);
}

bool LoadLabelSetCommand::isAvailable() const {
    return controller().isOpen() && controller().state().decisions.empty();
}

IssueReportCommand::IssueReportCommand(CommandContext& context)
    : Command(context, QStringLiteral("report.issue"), QObject::tr("Issue report…")) {
    setPicture(Icon::Export);
    setToolTip(QObject::tr("Writes report.pdf, report.html, report.csv and report.json into a folder"));
}

void IssueReportCommand::run() {
    const QString folder = files().chooseFolder(window(), QObject::tr("Folder for the report"),
                                                QFileInfo(controller().sessionPath()).absolutePath());
    if (!folder.isEmpty()) controller().issueReport(folder);
}

bool IssueReportCommand::isAvailable() const {
    return controller().state().detection.has_value() && !controller().tasks().isBusy();
}

}  // namespace fodscope
