// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractScrollArea>
#include <QImage>
#include <map>
#include <memory>

#include "ui/report/ReportDocument.h"

namespace fodscope::report {

/// Pages of paper under each other, as wide as the view but not wider than paper looks at arm's length. Only pages in
/// sight are painted, and the last few are kept.
class PageStack : public QAbstractScrollArea {
    Q_OBJECT

  public:
    explicit PageStack(QWidget* parent = nullptr);

    /// Keeps the place of the view. Null: nothing.
    void setDocument(std::shared_ptr<const ReportDocument> document);
    int pageCount() const { return document_ ? document_->pageCount() : 0; }
    void goToPage(int page);
    /// The page in the middle of the view.
    int currentPage() const;

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    int pageWidth() const;
    int pageHeight() const;
    int pageTop(int page) const;
    void updateScrollBar();
    const QImage& imageOf(int page);

    std::shared_ptr<const ReportDocument> document_;
    std::map<int, QImage> images_;
};

}  // namespace fodscope::report
