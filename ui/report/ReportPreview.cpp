// SPDX-License-Identifier: MIT
#include "ui/report/ReportPreview.h"

#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/report/PageStack.h"
#include "ui/report/ReportDocument.h"
#include "ui/theme/Theme.h"
#include "ui/widgets/EmptyState.h"

namespace fodscope {

struct ReportPreview::Parts {
    report::PageStack* pages = nullptr;
    EmptyState* empty = nullptr;
};

ReportPreview::ReportPreview(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
    setObjectName(QStringLiteral("reportPreview"));
    setSurface(this, SurfaceRole::Surface0);
    parts_->pages = new report::PageStack(this);
    parts_->empty = new EmptyState(this);
    parts_->empty->showEmpty(Icon::Report, tr("The report needs an inspection: open one, or begin a new one."));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(parts_->pages);
    column->addWidget(parts_->empty);
    clear();
}

ReportPreview::~ReportPreview() = default;

void ReportPreview::setReport(const InspectionState& state, const std::string& headHash) {
    parts_->pages->setDocument(std::make_shared<report::ReportDocument>(report::reportContent(state, headHash)));
    parts_->pages->show();
    parts_->empty->hide();
}

void ReportPreview::clear() {
    parts_->pages->setDocument(nullptr);
    parts_->pages->hide();
    parts_->empty->show();
}

int ReportPreview::pageCount() const {
    return parts_->pages->pageCount();
}

void ReportPreview::goToPage(int page) {
    parts_->pages->goToPage(page);
}

}  // namespace fodscope
