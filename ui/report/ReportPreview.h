// SPDX-License-Identifier: MIT
#pragma once

#include <QWidget>
#include <memory>
#include <string>

#include "core/inspection/InspectionState.h"

namespace fodscope {

/// The pages of the PDF to be, under each other. Pages are painted when they come into sight.
class ReportPreview : public QWidget {
    Q_OBJECT

  public:
    explicit ReportPreview(QWidget* parent = nullptr);
    ~ReportPreview() override;

    /// Lays the report out anew. The page in sight stays in sight.
    void setReport(const InspectionState& state, const std::string& headHash);
    /// Nothing to show: says in a sentence what is needed.
    void clear();

    int pageCount() const;

  public slots:
    void goToPage(int page);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace fodscope
