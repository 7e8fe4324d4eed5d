// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <memory>
#include <optional>

#include "core/inspection/Parameters.h"
#include "ui/tuning/PhotoTuning.h"
#include "ui/tuning/TuningSearch.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace fodscope {

class CostPage;
class FileDialogs;
class InspectionController;
class PhotoPage;
class TuningOptions;
class TuningPage;
struct TaskReport;

/// Finds threshold, cutoff and least points from trials with known FOD: those of least cost as in the paper, or those
/// with the fewest photos at a wanted recall, and shows what every choice comes to. Nothing changes until "Use these".
/// Blocks nothing: the window and STOP stay at hand.
class TuningDialog : public QDialog {
    Q_OBJECT

  public:
    /// @param controller, files must outlive the dialog
    TuningDialog(InspectionController& controller, FileDialogs& files, QWidget* parent = nullptr);
    ~TuningDialog() override;

    void chooseFolder(const QString& folder);
    void showOutcome(const TuningOutcome& outcome);
    void showOutcome(const PhotoTuningOutcome& outcome);

  private:
    /// What trials were measured with, so that the next search need not measure them again.
    struct Measured {
        QString folder;
        QString worlds;
        std::shared_ptr<const ReferenceMap> reference;
        Parameters parameters;
        /// The local statistical test is made only where it is asked for.
        bool hasChiSquare = false;
    };

    QWidget* makeLeft();
    QWidget* makeTrialsCard(QWidget* parent);
    QWidget* makeSearchCard(QWidget* parent);
    QWidget* makeRight();
    QWidget* makeBottom();
    void takeInspection();
    void search();
    void searchForCost();
    void searchForPhotos();
    CandidateSettings searchedMethod() const;
    bool isMeasured(const Measured& measured) const;
    Measured measuredNow() const;
    void showTask(const TaskReport& report);
    void endTask(const QString& sentence, bool isProblem);
    void tell(const QString& searched, const std::map<std::string, std::string>& failures, const QString& counts);
    void use();
    void refresh();
    QString searchObstacle() const;
    QString whatASearchDoes() const;
    QString useObstacle() const;
    bool isForPhotos() const;
    TuningPage& page() const;

    InspectionController& controller_;
    FileDialogs& files_;
    QString folder_;
    std::size_t trials_ = 0;
    bool searching_ = false;
    Measured costMeasured_;
    Measured photosMeasured_;

    QLabel* trialsText_ = nullptr;
    TuningOptions* options_ = nullptr;
    QPushButton* search_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* stage_ = nullptr;
    CostPage* costPage_ = nullptr;
    PhotoPage* photoPage_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    QStackedWidget* values_ = nullptr;
    QPushButton* best_ = nullptr;
    QPushButton* use_ = nullptr;
};

}  // namespace fodscope
