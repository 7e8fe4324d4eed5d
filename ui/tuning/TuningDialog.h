// SPDX-License-Identifier: MIT
#pragma once

#include <QDialog>
#include <memory>
#include <optional>

#include "ui/tuning/TuningSearch.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace fodscope {

class CostSurface;
class FileDialogs;
class InspectionController;
class TuningValues;
class ValueSlider;
struct TaskReport;

/// Finds threshold, cutoff and least points from trials with known FOD, and shows what every choice costs. Nothing
/// changes until "Use these". Blocks nothing: the window and STOP stay at hand.
class TuningDialog : public QDialog {
    Q_OBJECT

  public:
    /// @param controller, files must outlive the dialog
    TuningDialog(InspectionController& controller, FileDialogs& files, QWidget* parent = nullptr);
    ~TuningDialog() override;

    void chooseFolder(const QString& folder);
    void showOutcome(const TuningOutcome& outcome);

  private:
    QWidget* makeLeft();
    QWidget* makeRight();
    QWidget* makeBottom();
    void takeInspection();
    void search();
    void showTask(const TaskReport& report);
    void endTask(const QString& sentence, bool isProblem);
    void showLeastPoints();
    void choose(const CostCell& cell);
    void read(const std::optional<CostCell>& cell);
    void use();
    void refresh();
    QString searchObstacle() const;
    QString useObstacle() const;
    std::optional<double> lambda_m() const;
    std::size_t leastIndex() const;

    InspectionController& controller_;
    FileDialogs& files_;
    QString folder_;
    std::size_t trials_ = 0;
    bool searching_ = false;
    std::optional<TuningOutcome> outcome_;
    GridPoint chosen_;
    /// What the measured trials rest on.
    QString measuredFolder_;
    std::shared_ptr<const ReferenceMap> measuredReference_;
    Parameters measuredParameters_;

    QLabel* trialsText_ = nullptr;
    QComboBox* metric_ = nullptr;
    QLineEdit* lambda_ = nullptr;
    QPushButton* search_ = nullptr;
    QPushButton* cancel_ = nullptr;
    QProgressBar* progress_ = nullptr;
    QLabel* stage_ = nullptr;
    TuningValues* values_ = nullptr;
    CostSurface* surface_ = nullptr;
    ValueSlider* leastPoints_ = nullptr;
    QLabel* reading_ = nullptr;
    QPushButton* best_ = nullptr;
    QPushButton* use_ = nullptr;
};

}  // namespace fodscope
