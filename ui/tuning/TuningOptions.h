// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <optional>

#include "core/detection/Candidates.h"

class QComboBox;
class QFormLayout;
class QLineEdit;
class QPushButton;

namespace fodscope {

class FileDialogs;

/// What is searched for, and with what.
class TuningOptions : public QWidget {
    Q_OBJECT

  public:
    enum class Objective { Cost, Photos };

    /// @param files must outlive it
    explicit TuningOptions(FileDialogs& files, QWidget* parent = nullptr);

    Objective objective() const;
    void chooseObjective(Objective objective);
    Metric metric() const;
    /// Mahalanobis needs covariances.
    /// @param usual chosen where nothing was before
    void offerMetrics(bool hasCovariance, Metric usual);
    /// Empty while what was typed is none.
    std::optional<double> lambda_m() const;
    std::optional<double> recall() const;
    QString worlds() const { return worlds_; }
    void chooseWorlds(const QString& folder);

    /// Why no search can begin with them; empty: one can.
    QString obstacle() const;

  signals:
    void changed();

  private:
    void refresh();

    FileDialogs& files_;
    QString worlds_;
    QFormLayout* form_ = nullptr;
    QComboBox* objective_ = nullptr;
    QComboBox* metric_ = nullptr;
    QLineEdit* lambda_ = nullptr;
    QLineEdit* recall_ = nullptr;
    QPushButton* worldsButton_ = nullptr;
};

}  // namespace fodscope
