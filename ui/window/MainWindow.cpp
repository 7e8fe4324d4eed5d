// SPDX-License-Identifier: MIT
#include "ui/window/MainWindow.h"
#include "core/common/Error.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenuBar>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>

#include "ui/commands/CommandSet.h"
#include "ui/commands/WindowCommands.h"
#include "ui/labelling/LabellingView.h"
#include "ui/panels/CandidateTable.h"
#include "ui/panels/CandidatesPanel.h"
#include "ui/panels/EvidencePanel.h"
#include "ui/panels/LabelPanel.h"
#include "ui/panels/MapPanel.h"
#include "ui/panels/MessageBanner.h"
#include "ui/panels/ReferencePanel.h"
#include "ui/panels/ReportPanel.h"
#include "ui/panels/StartPage.h"
#include "ui/panels/StartPoseDialog.h"
#include "ui/panels/StatusStrip.h"
#include "ui/panels/VisitPanel.h"
#include "ui/session/RecentSessions.h"
#include "ui/settings/SettingsDialog.h"
#include "ui/tuning/TuningDialog.h"
#include "ui/widgets/Toast.h"
#include "ui/window/Centre.h"
#include "ui/window/FileDrop.h"
#include "ui/window/ManualWindow.h"
#include "ui/window/Overlay.h"
#include "ui/window/TitleRow.h"

namespace fodscope {
namespace {

constexpr const char* kGeometry = "window/geometry";
constexpr const char* kTheme = "window/theme";

/// Whether a dock is open at a step, until the operator opens or closes it there.
bool isOpenAt(const QString& dock, Step step) {
    if (dock == QStringLiteral("evidence"))
        return step == Step::Candidates || step == Step::Visit || step == Step::Label;
    if (dock == QStringLiteral("table")) return step == Step::Map || step == Step::Candidates || step == Step::Visit;
    return true;
}

QString dockKey(const QString& dock, Step step) {
    return QStringLiteral("window/docks/%1/%2").arg(dock).arg(static_cast<int>(step));
}

/// Widgets that need Tab and Space for themselves.
bool wantsKey(const QWidget* widget, int key) {
    const bool isText = qobject_cast<const QLineEdit*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
                        qobject_cast<const QPlainTextEdit*>(widget) || qobject_cast<const QComboBox*>(widget);
    if (key == Qt::Key_Tab || key == Qt::Key_Backtab) return isText;
    return isText || qobject_cast<const QAbstractButton*>(widget);
}

}  // namespace

MainWindow::MainWindow(InspectionController& controller, FileDialogs& files, QWidget* parent)
    : QMainWindow(parent), controller_(controller), files_(files) {
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(QStringLiteral("Fodscope"));
    setWindowIcon(applicationIcon());
    setAcceptDrops(true);
    setDockNestingEnabled(false);
    setMinimumSize(1024, 640);
    commands_ = std::make_unique<CommandSet>(CommandContext{controller, files, *this, *this});
    for (Command* command : commands_->all())
        addAction(command);
    commands_->find(QStringLiteral("robot.stop"))->setShortcutContext(Qt::ApplicationShortcut);
    commands_->fillMenuBar(*menuBar());
    // Before the panels hear of it: what they choose on opening a session must not move the step it was left at.
    connect(&controller_, &InspectionController::sessionChanged, this, [this] { followsPhotos_ = false; });
    centre_ = new Centre(controller, *commands_, this);
    setCentralWidget(centre_);
    placeTitle();
    placeDocks();
    placeStatus();
    toast_ = new Toast(this);
    shortcuts_ = new ShortcutsOverlay(*commands_, this);
    palette_ = new CommandPalette(*commands_, this);
    followController();
    qApp->installEventFilter(this);
    restorePlaces();
    takeSession();
}

MainWindow::~MainWindow() {
    qApp->removeEventFilter(this);
    delete settings_;
    delete tuning_;
    delete startPose_;
    // What is hidden while it goes must not be remembered as closed by the operator.
    for (QDockWidget* dock : {stepDock_, evidenceDock_, tableDock_})
        dock->disconnect(this);
    controller_.disconnect(this);
    delete takeCentralWidget();
}

void MainWindow::placeTitle() {
    title_ = new TitleRow(controller_, this);
    auto* bar = addToolBar(tr("Steps"));
    bar->setObjectName(QStringLiteral("titleBar"));
    bar->setMovable(false);
    bar->setFloatable(false);
    bar->toggleViewAction()->setVisible(false);
    bar->addWidget(title_);
    title_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    connect(title_, &TitleRow::stepRequested, this, &MainWindow::showStep);
}

QDockWidget* MainWindow::makeDock(const QString& name, const QString& title, QWidget* content,
                                  Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(QStringLiteral("dock.") + name);
    dock->setWidget(content);
    dock->setFeatures(QDockWidget::DockWidgetClosable);
    dock->setAllowedAreas(area);
    addDockWidget(area, dock);
    connect(dock, &QDockWidget::visibilityChanged, this, [this, name](bool visible) {
        if (!placingDocks_ && isVisible() && !isMinimized() && controller_.isOpen())
            QSettings().setValue(dockKey(name, step_), visible);
    });
    return dock;
}

void MainWindow::placeDocks() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    stepPanels_ = new QStackedWidget(this);
    candidatesPanel_ = new CandidatesPanel(controller_, *commands_, stepPanels_);
    auto* report = new ReportPanel(controller_, *commands_, stepPanels_);
    connect(report, &ReportPanel::stepRequested, this, &MainWindow::showStep);
    for (QWidget* panel :
         {static_cast<QWidget*>(new ReferencePanel(controller_, *commands_, stepPanels_)),
          static_cast<QWidget*>(new MapPanel(controller_, *commands_, stepPanels_)),
          static_cast<QWidget*>(candidatesPanel_),
          static_cast<QWidget*>(new VisitPanel(controller_, *commands_, stepPanels_)),
          static_cast<QWidget*>(new LabelPanel(controller_, *commands_, stepPanels_)), static_cast<QWidget*>(report)})
        stepPanels_->addWidget(panel);
    stepDock_ = makeDock(QStringLiteral("step"), tr("Step"), stepPanels_, Qt::LeftDockWidgetArea);
    evidenceDock_ = makeDock(QStringLiteral("evidence"), tr("Evidence"),
                             new EvidencePanel(controller_, *commands_, this), Qt::RightDockWidgetArea);
    tableDock_ = makeDock(QStringLiteral("table"), tr("Candidates"), new CandidateTable(controller_, this),
                          Qt::BottomDockWidgetArea);
    tableDock_->widget()->setMinimumHeight(110);
    auto* view = menuBar()->actions().at(2)->menu();
    view->addSeparator();
    for (QDockWidget* dock : {stepDock_, evidenceDock_, tableDock_})
        view->addAction(dock->toggleViewAction());
}

void MainWindow::placeStatus() {
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addWidget(new StatusStrip(controller_, *commands_, this), 1);
}

void MainWindow::followController() {
    connect(&controller_, &InspectionController::sessionChanged, this, &MainWindow::takeSession);
    connect(&controller_, &InspectionController::noticeRaised, this,
            [this](const QString& sentence) { toast_->showMessage(StatusKind::Neutral, sentence); });
    connect(&controller_, &InspectionController::reportIssued, this, [this](const QString& folder) {
        toast_->showMessage(StatusKind::Clear,
                            tr("The report was issued into the folder %1").arg(QDir(folder).dirName()));
    });
    connect(&controller_, &InspectionController::builtinTankReady, this, [this] { showStep(Step::Candidates); });
    connect(&controller_, &InspectionController::photoSelectionChanged, this, [this](const QString& photo) {
        // A thumbnail was chosen somewhere else: show the photo large. While driving, photos only arrive.
        if (followsPhotos_ && !photo.isEmpty() && step_ != Step::Visit && step_ != Step::Report) showStep(Step::Label);
    });
    connect(&centre_->startPage(), &StartPage::sessionChosen, &controller_, &InspectionController::openSession);
}

void MainWindow::takeSession() {
    const InspectionState& state = controller_.state();
    setWindowTitle(controller_.isOpen() ? tr("%1 – Fodscope").arg(QString::fromStdString(state.header.title))
                                        : QStringLiteral("Fodscope"));
    showStep(controller_.isOpen() ? RecentSessions().stepOf(state.header.id).value_or(firstOpenStep(state))
                                  : Step::Reference);
    followsPhotos_ = true;
}

void MainWindow::showStep(Step step) {
    step_ = step;
    title_->setCurrent(step);
    stepPanels_->setCurrentIndex(static_cast<int>(step));
    stepDock_->setWindowTitle(stepName(step));
    centre_->setStep(step);
    showDocks();
    if (controller_.isOpen()) RecentSessions().rememberStep(controller_.state().header.id, step);
}

void MainWindow::showDocks() {
    placingDocks_ = true;
    const bool open = controller_.isOpen();
    for (const auto& [dock, name] : {std::pair{stepDock_, QStringLiteral("step")},
                                     {evidenceDock_, QStringLiteral("evidence")},
                                     {tableDock_, QStringLiteral("table")}}) {
        dock->setVisible(open && QSettings().value(dockKey(name, step_), isOpenAt(name, step_)).toBool());
        dock->toggleViewAction()->setEnabled(open);
    }
    placingDocks_ = false;
}

void MainWindow::restorePlaces() {
    const QByteArray geometry = QSettings().value(kGeometry).toByteArray();
    if (geometry.isEmpty() || !restoreGeometry(geometry)) resize(1600, 960);
    resizeDocks(
        {stepDock_, evidenceDock_},
        {QSettings().value("window/stepWidth", 304).toInt(), QSettings().value("window/evidenceWidth", 264).toInt()},
        Qt::Horizontal);
    resizeDocks({tableDock_}, {QSettings().value("window/tableHeight", 190).toInt()}, Qt::Vertical);
}

void MainWindow::rememberDocks() {
    QSettings settings;
    settings.setValue(kGeometry, saveGeometry());
    if (stepDock_->isVisible()) settings.setValue("window/stepWidth", stepDock_->width());
    if (evidenceDock_->isVisible()) settings.setValue("window/evidenceWidth", evidenceDock_->width());
    if (tableDock_->isVisible()) settings.setValue("window/tableHeight", tableDock_->height());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    rememberDocks();
    placingDocks_ = true;
    controller_.tasks().cancel();
    if (controller_.visits().runnerState() == RunnerState::Running) controller_.visits().stop();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) files << url.toLocalFile();
    event->acceptProposedAction();
    takeDroppedFiles(controller_, files);
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const bool isOurs = key == Qt::Key_Tab || key == Qt::Key_Backtab || key == Qt::Key_Space;
        if (isOurs && wantsKey(qobject_cast<QWidget*>(watched), key)) event->accept();
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::stepThreshold(int steps, bool coarse) {
    candidatesPanel_->stepThreshold(steps, coarse);
}

void MainWindow::askStartPose() {
    if (!startPose_) startPose_ = new StartPoseDialog(controller_, files_, this);
    startPose_->open();
}

void MainWindow::showResiduals(bool shown) {
    if (shown) showStep(Step::Map);
    centre_->setResiduals(shown);
}

void MainWindow::showTuning() {
    if (!tuning_) tuning_ = new TuningDialog(controller_, files_, this);
    tuning_->show();
    tuning_->raise();
    tuning_->activateWindow();
}

void MainWindow::showSettings() {
    if (!settings_) settings_ = new SettingsDialog(controller_, files_, this);
    settings_->show();
    settings_->raise();
    settings_->activateWindow();
}

void MainWindow::toggleShortcuts() {
    shortcuts_->isVisible() ? shortcuts_->hide() : shortcuts_->open();
}

void MainWindow::showManual() {
    try {
        if (!manual_) manual_ = new ManualWindow(this);
        manual_->show();
        manual_->raise();
        manual_->showStep(controller_.isOpen() ? std::optional(step_) : std::nullopt);
    } catch (const Error& error) {
        controller_.raiseError(QString::fromUtf8(error.what()));
    }
}

void MainWindow::togglePalette() {
    palette_->isVisible() ? palette_->hide() : palette_->open();
}

void MainWindow::toggleTheme() {
    const ThemeKind kind = currentTheme().kind == ThemeKind::Dark ? ThemeKind::Light : ThemeKind::Dark;
    QSettings().setValue(kTheme, kind == ThemeKind::Light ? QStringLiteral("light") : QStringLiteral("dark"));
    applyTheme(*qApp, kind);
}

void MainWindow::fitViews() {
    centre_->fitViews();
}

void MainWindow::showReferenceHeatMap(bool shown) {
    if (shown) showStep(Step::Reference);
    centre_->setHeatMap(shown);
}

void MainWindow::nextUndecidedPhoto() {
    centre_->labelling().goToNextUndecided();
}

void MainWindow::leave() {
    if (shortcuts_->isVisible()) {
        shortcuts_->hide();
    } else if (palette_->isVisible()) {
        palette_->hide();
    } else if (centre_->banner().isVisible()) {
        centre_->banner().dismiss();
    } else if (!controller_.probe().empty()) {
        controller_.setProbe({});
    } else {
        controller_.selectCandidate(QString());
    }
}

void MainWindow::quit() {
    close();
}

}  // namespace fodscope
