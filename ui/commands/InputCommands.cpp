// SPDX-License-Identifier: MIT
#include "ui/commands/InputCommands.h"

namespace fodscope {
namespace {

QString meshFilter() {
    return QObject::tr("Meshes (*.stl *.ply *.obj *.STL *.PLY *.OBJ);;All files (*)");
}

QString cloudFilter() {
    return QObject::tr("Point clouds (*.pcd *.ply *.PCD *.PLY);;All files (*)");
}

}  // namespace

LoadMeshCommand::LoadMeshCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("reference.mesh"), QObject::tr("From a CAD mesh…")) {
    setPicture(Icon::Cube);
    setToolTip(QObject::tr("Samples the surface of an STL, PLY or OBJ mesh; such a reference has no covariances"));
}

void LoadMeshCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("Mesh of the tank without debris"), meshFilter());
    if (file.isEmpty()) return;
    ReferenceRequest request;
    request.kind = ReferenceKind::Cad;
    request.files = {file.toStdString()};
    request.meshScale = controller().meshScale();
    controller().loadReference(request);
}

LoadReferenceCommand::LoadReferenceCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("reference.load"), QObject::tr("From a reference map…")) {
    setPicture(Icon::Cloud);
    setToolTip(QObject::tr("A PLY made earlier, with covariances, or any cloud of the space without debris"));
}

void LoadReferenceCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("Reference map"), cloudFilter());
    if (file.isEmpty()) return;
    ReferenceRequest request;
    request.kind = ReferenceKind::Ready;
    request.files = {file.toStdString()};
    controller().loadReference(request);
}

LoadNominalMapsCommand::LoadNominalMapsCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("reference.nominal"), QObject::tr("From nominal maps…")) {
    setPicture(Icon::Layers);
    setToolTip(QObject::tr("Several maps of the space without debris; their mean and how much they vary"));
}

void LoadNominalMapsCommand::run() {
    const QStringList chosen =
        files().openFiles(window(), QObject::tr("Nominal maps: maps without debris"), cloudFilter());
    if (chosen.isEmpty()) return;
    ReferenceRequest request;
    request.kind = ReferenceKind::NominalMaps;
    for (const QString& file : chosen)
        request.files.push_back(file.toStdString());
    controller().loadReference(request);
}

LoadMapCommand::LoadMapCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("map.load"), QObject::tr("Load map…")) {
    setPicture(Icon::Open);
    setToolTip(QObject::tr("The map under inspection, PCD or PLY, in metres"));
}

void LoadMapCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("Map under inspection"), cloudFilter());
    if (!file.isEmpty()) controller().loadMap(file);
}

LoadTransformCommand::LoadTransformCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("map.transform"), QObject::tr("Use a known transform…")) {
    setPicture(Icon::Target);
    setToolTip(QObject::tr("A CSV of 4 rows of 4 numbers, reference from map, instead of the search"));
}

void LoadTransformCommand::run() {
    const QString file = files().openFile(window(), QObject::tr("Transform, reference from map"),
                                          QObject::tr("Transforms (*.csv);;All files (*)"));
    if (!file.isEmpty()) controller().loadGivenTransform(file);
}

ForgetTransformCommand::ForgetTransformCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("map.register"), QObject::tr("Align by search again")) {
    setPicture(Icon::Retry);
}

void ForgetTransformCommand::run() {
    controller().clearGivenTransform();
}

bool ForgetTransformCommand::isAvailable() const {
    return InputCommand::isAvailable() && controller().hasGivenTransform();
}

DetectCommand::DetectCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("map.detect"), QObject::tr("Detect")) {
    setPicture(Icon::Search);
    setKeys({QKeySequence(QStringLiteral("Ctrl+D"))});
    setToolTip(QObject::tr("Aligns the map with the reference, measures the discrepancy and finds candidates"));
}

void DetectCommand::run() {
    controller().detect();
}

HeatMapCommand::HeatMapCommand(CommandContext& context)
    : Command(context, QStringLiteral("reference.heatmap"), QObject::tr("Colour by covariance")) {
    setCheckable(true);
    setToolTip(QObject::tr("How much the nominal maps vary at each point of the reference"));
}

void HeatMapCommand::run() {
    navigation().showReferenceHeatMap(isChecked());
}

bool HeatMapCommand::isAvailable() const {
    return controller().state().reference && controller().state().reference->hasCovariance();
}

}  // namespace fodscope
