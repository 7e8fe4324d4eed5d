// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"
#include "core/inspection/ReportModel.h"
#include "ui/plan/PlanPainter.h"
#include "ui/report/PageFlow.h"

QT_BEGIN_NAMESPACE
class QPainter;
QT_END_NAMESPACE

namespace fodscope::report {

/// What all forms of a report are made from.
struct ReportContent {
    InspectionState state;
    ReportModel model;
    std::string headHash;
    PlanScene plan;
    PlanImages planImages;
};

std::shared_ptr<const ReportContent> reportContent(const InspectionState& state, const std::string& headHash);

/// The pages of a report, laid out once and painted on paper or on the screen. Photos are decoded when their page is
/// painted.
class ReportDocument {
  public:
    explicit ReportDocument(std::shared_ptr<const ReportContent> content);

    int pageCount() const { return static_cast<int>(pages_.size()); }
    /// Paints a page in tenths of a millimetre, from the upper left corner of the paper.
    void paintPage(QPainter& painter, int page) const;

  private:
    void paintHeaderAndFooter(QPainter& painter, int page) const;

    std::shared_ptr<const ReportContent> content_;
    Flow flow_;
    std::vector<PlacedPage> pages_;
};

}  // namespace fodscope::report
