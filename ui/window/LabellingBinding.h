// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>

#include "ui/labelling/LabellingView.h"
#include "ui/session/InspectionController.h"

namespace fodscope {

/// Connects the labelling view with the inspection: photos in, decisions out and back when they are safe.
class LabellingBinding : public QObject {
    Q_OBJECT

  public:
    LabellingBinding(InspectionController& controller, LabellingView& view, QObject* parent);

  private:
    void showAll();
    void keep(const QString& photoId, const std::vector<PhotoLabel>& labels, const QString& comment);

    InspectionController& controller_;
    LabellingView& view_;
};

}  // namespace fodscope
