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

QString InputCommand::obstacle() const {
    return controller().isOpen() ? tr("the visits have begun, so the candidates are frozen")
                                 : tr("open an inspection first");
}

LoadMeshAndMapsCommand::LoadMeshAndMapsCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("reference.meshmaps"), QObject::tr("From a CAD mesh and maps…")) {
    setPicture(Icon::Cube);
    setToolTip(
        QObject::tr("Samples the surface of a mesh, and gives the samples covariances from maps without debris"));
}

void LoadMeshAndMapsCommand::run() {
    const QString mesh = files().openFile(window(), QObject::tr("Mesh of the tank without debris"), meshFilter());
    if (mesh.isEmpty()) return;
    const QStringList maps =
        files().openFiles(window(), QObject::tr("Nominal maps that give the mesh covariances"), cloudFilter());
    if (maps.isEmpty()) return;
    ReferenceRequest request;
    request.kind = ReferenceKind::CadAndMaps;
    request.files = {mesh.toStdString()};
    request.meshScale = controller().meshScale();
    for (const QString& map : maps)
        request.covarianceMaps.push_back(map.toStdString());
    controller().loadReference(request);
}

RemakeReferenceCommand::RemakeReferenceCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("reference.again"), QObject::tr("Make the reference again")) {
    setPicture(Icon::Retry);
    setToolTip(QObject::tr("From the same files, with the settings as they are now"));
}

void RemakeReferenceCommand::run() {
    controller().remakeReference();
}

bool RemakeReferenceCommand::isAvailable() const {
    return InputCommand::isAvailable() && controller().canRemakeReference();
}

QString RemakeReferenceCommand::obstacle() const {
    return InputCommand::isAvailable() ? tr("no reference was made from maps since the program started")
                                       : InputCommand::obstacle();
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
    setToolTip(QObject::tr("Forgets the given transform or start pose and searches all poses"));
}

void ForgetTransformCommand::run() {
    controller().alignBySearch();
}

bool ForgetTransformCommand::isAvailable() const {
    return InputCommand::isAvailable() && (controller().hasGivenTransform() || controller().hasStartPose());
}

StartPoseCommand::StartPoseCommand(CommandContext& context)
    : InputCommand(context, QStringLiteral("map.start"), QObject::tr("Known start pose…")) {
    setPicture(Icon::Pin);
    setToolTip(QObject::tr("Aligns from where the robot is known to have started, typed or from a file"));
}

void StartPoseCommand::run() {
    navigation().askStartPose();
}

bool StartPoseCommand::isAvailable() const {
    return InputCommand::isAvailable() && controller().state().reference && controller().state().mapSource;
}

QString StartPoseCommand::obstacle() const {
    return controller().candidatesAreFrozen() ? QObject::tr("the visits have begun")
                                              : QObject::tr("load a reference and a map first");
}

ResidualsCommand::ResidualsCommand(CommandContext& context)
    : Command(context, QStringLiteral("map.residuals"), QObject::tr("Colour by residual")) {
    setCheckable(true);
    setPicture(Icon::Contrast);
    setKeys({QKeySequence(QStringLiteral("Ctrl+Shift+R"))});
    setToolTip(
        QObject::tr("How far off the map has each region of the reference, in millimetres: red lies inwards, blue "
                    "outwards, striped was not observed"));
}

void ResidualsCommand::run() {
    navigation().showResiduals(isChecked());
}

bool ResidualsCommand::isAvailable() const {
    return controller().residuals() != nullptr;
}

QString ResidualsCommand::obstacle() const {
    return QObject::tr("align a map with the reference first");
}

void ResidualsCommand::refresh() {
    Command::refresh();
    if (isAvailable() || !isChecked()) return;
    setChecked(false);
    run();
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
    setPicture(Icon::Contrast);
    setKeys({QKeySequence(QStringLiteral("Ctrl+H"))});
    setToolTip(
        QObject::tr("How much the nominal maps vary at each point: log determinant of its covariance, from its "
                    "10th to its 90th percentile; points without training are striped"));
}

void HeatMapCommand::run() {
    navigation().showReferenceHeatMap(isChecked());
}

bool HeatMapCommand::isAvailable() const {
    return controller().state().reference && controller().state().reference->hasCovariance();
}

QString HeatMapCommand::obstacle() const {
    return controller().state().reference ? QObject::tr("this reference has no covariances")
                                          : QObject::tr("there is no reference yet");
}

void HeatMapCommand::refresh() {
    Command::refresh();
    // What is shown is plain again when the inspection is closed or its reference has nothing to colour by.
    if (isAvailable() || !isChecked()) return;
    setChecked(false);
    run();
}

}  // namespace fodscope
