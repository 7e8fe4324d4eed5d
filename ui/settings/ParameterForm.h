// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "core/inspection/ParameterTable.h"

class QFormLayout;
class QLabel;

namespace fodscope {

class InspectionController;
class ParameterEditor;

/// A few parameters of one section on a panel. What is entered takes effect at once and can be undone; a value that is
/// wrong is marked, told, and left out.
class ParameterForm : public QWidget {
    Q_OBJECT

  public:
    /// Whether a parameter matters with the others as they are; the others are hidden.
    using Relevance = std::function<bool(const ParameterField&, const Parameters&)>;

    ParameterForm(InspectionController& controller, const std::string& section, const std::vector<std::string>& keys,
                  Relevance matters, QWidget* parent = nullptr);

    void refresh();

  private:
    struct Row {
        const ParameterField* field = nullptr;
        QLabel* name = nullptr;
        ParameterEditor* editor = nullptr;
    };
    void enter(const ParameterField& field, const QString& text);

    InspectionController& controller_;
    Relevance matters_;
    std::vector<Row> rows_;
    QLabel* problem_ = nullptr;
};

}  // namespace fodscope
