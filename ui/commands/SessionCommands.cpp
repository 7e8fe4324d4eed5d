// SPDX-License-Identifier: MIT
#include "ui/commands/SessionCommands.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

namespace fodscope {
namespace {

QString sessionFilter() {
    return QObject::tr("Fodscope sessions (*.fodscope)");
}

/// ~/Documents/Fodscope/NAME 2026-11-21 1015.fodscope
QString proposedFile(const QString& name) {
    const QString folder =
        QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + QStringLiteral("/Fodscope");
    QDir().mkpath(folder);
    const QString time = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HHmm"));
    return QStringLiteral("%1/%2 %3.fodscope").arg(folder, name, time);
}

QString withExtension(const QString& file) {
    return file.isEmpty() || file.endsWith(QStringLiteral(".fodscope")) ? file : file + QStringLiteral(".fodscope");
}

}  // namespace

NewInspectionCommand::NewInspectionCommand(CommandContext& context)
    : Command(context, QStringLiteral("session.new"), QObject::tr("New inspection…")) {
    setPicture(Icon::New);
    setKeys({QKeySequence::New});
    setToolTip(QObject::tr("Starts an inspection from a reference and a map; asks where its session file goes"));
}

void NewInspectionCommand::run() {
    const QString file = withExtension(files().saveFile(window(), QObject::tr("Where the new session goes"),
                                                        proposedFile(QObject::tr("Inspection")), sessionFilter()));
    if (file.isEmpty()) return;
    InspectionHeader header = newInspectionHeader();
    header.title = QFileInfo(file).completeBaseName().toStdString();
    if (controller().createSession(file, header)) navigation().showStep(Step::Reference);
}

OpenSessionCommand::OpenSessionCommand(CommandContext& context)
    : Command(context, QStringLiteral("session.open"), QObject::tr("Open session…")) {
    setPicture(Icon::Open);
    setKeys({QKeySequence::Open});
}

void OpenSessionCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("Open a session"), sessionFilter());
    if (!file.isEmpty()) controller().openSession(file);
}

BuiltinTankCommand::BuiltinTankCommand(CommandContext& context)
    : Command(context, QStringLiteral("session.builtin"), QObject::tr("Built-in tank")) {
    setPicture(Icon::Cube);
    setToolTip(QObject::tr("A simulated tank with a simulated robot, to learn and to try on"));
}

void BuiltinTankCommand::run() {
    const QString file = proposedFile(QObject::tr("Built-in tank"));
    controller().createBuiltinTank(
        QFileInfo::exists(file)
            ? QString(file).replace(QStringLiteral(".fodscope"),
                                    QDateTime::currentDateTime().toString(QStringLiteral("ss_zzz'.fodscope'")))
            : file);
}

CloseInspectionCommand::CloseInspectionCommand(CommandContext& context)
    : Command(context, QStringLiteral("session.close"), QObject::tr("Close inspection")) {
    setPicture(Icon::Close);
    setKeys({QKeySequence::Close});
    setToolTip(QObject::tr("Back to the start page; everything is already in the session file"));
}

void CloseInspectionCommand::run() {
    controller().tasks().cancel();
    controller().closeSession();
}

bool CloseInspectionCommand::isAvailable() const {
    return controller().isOpen();
}

QuitCommand::QuitCommand(CommandContext& context)
    : Command(context, QStringLiteral("session.quit"), QObject::tr("Quit")) {
    setKeys({QKeySequence(QStringLiteral("Ctrl+Q"))});
}

void QuitCommand::run() {
    navigation().quit();
}

UndoCommand::UndoCommand(CommandContext& context) : Command(context, QStringLiteral("edit.undo"), QObject::tr("Undo")) {
    setPicture(Icon::Undo);
    setKeys({QKeySequence(QStringLiteral("Ctrl+Z"))});
}

void UndoCommand::run() {
    controller().undo();
}

bool UndoCommand::isAvailable() const {
    return controller().canUndo();
}

void UndoCommand::refresh() {
    Command::refresh();
    const QString name = controller().history().undoName();
    setText(name.isEmpty() ? QObject::tr("Undo") : QObject::tr("Undo %1").arg(name));
}

RedoCommand::RedoCommand(CommandContext& context) : Command(context, QStringLiteral("edit.redo"), QObject::tr("Redo")) {
    setPicture(Icon::Redo);
    setKeys({QKeySequence(QStringLiteral("Ctrl+Shift+Z"))});
}

void RedoCommand::run() {
    controller().redo();
}

bool RedoCommand::isAvailable() const {
    return controller().history().canRedo();
}

void RedoCommand::refresh() {
    Command::refresh();
    const QString name = controller().history().redoName();
    setText(name.isEmpty() ? QObject::tr("Redo") : QObject::tr("Redo %1").arg(name));
}

CancelTaskCommand::CancelTaskCommand(CommandContext& context)
    : Command(context, QStringLiteral("task.cancel"), QObject::tr("Cancel the running task")) {
    setPicture(Icon::Close);
}

void CancelTaskCommand::run() {
    controller().tasks().cancel();
}

bool CancelTaskCommand::isAvailable() const {
    return controller().tasks().isBusy();
}

}  // namespace fodscope
