// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <vector>

#include "app/workstation/RestingWindow.h"
#include "core/inspection/GroundTruthLabeller.h"
#include "ui/session/InspectionController.h"

namespace fodscope {

class MainWindow;

/// Carries a whole inspection of the built-in tank out in the window that people use, with the same commands, keys and
/// fields, and keeps a picture of every step. It goes on when the inspection tells that something happened.
class Autopilot : public QObject {
    Q_OBJECT

  public:
    Autopilot(MainWindow& window, InspectionController& controller, const QString& folder);

    void start();

  signals:
    void finished();
    void failed(const QString& sentence);
    /// A picture was saved: the step it shows is done.
    void pictureSaved(const QString& file);

  private:
    struct Stage {
        std::function<void()> begin;
        /// Looked at after every change of the inspection.
        std::function<bool()> isDone;
    };

    void plan();
    void stage(std::function<void()> begin, std::function<bool()> isDone);
    void picture(const QString& name);
    void check();
    void fail(const QString& sentence);

    void moveThreshold();
    void labelNext();
    void pressLabel(const PhotoAnswer& answer);
    void fillFrontPage();
    void savePicture(const QString& name);

    MainWindow& window_;
    InspectionController& controller_;
    QString folder_;
    RestingWindow rest_;
    std::unique_ptr<GroundTruthLabeller> labeller_;
    std::vector<Stage> stages_;
    std::size_t current_ = 0;
    bool begun_ = false;
    bool checking_ = false;
    bool over_ = false;
    bool pictureTaken_ = false;
    bool tankReady_ = false;
    bool reportReady_ = false;
    std::size_t photosAsked_ = 0;
    QTimer stalled_;
};

}  // namespace fodscope
