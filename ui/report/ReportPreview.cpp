// SPDX-License-Identifier: MIT
#include "ui/report/ReportPreview.h"

#include <QStackedLayout>

#include "ui/report/PageStack.h"
#include "ui/report/ReportDocument.h"
#include "ui/theme/Theme.h"
#include "ui/widgets/EmptyState.h"

namespace fodscope {

struct ReportPreview::Parts {
    report::PageStack* pages = nullptr;
    EmptyState* empty = nullptr;
    QStackedLayout* stack = nullptr;
};

ReportPreview::ReportPreview(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>()) {
    setObjectName(QStringLiteral("reportPreview"));
    setSurface(this, SurfaceRole::Surface0);
    parts_->pages = new report::PageStack(this);
    parts_->empty = new EmptyState(this);
    parts_->empty->showEmpty(Icon::Report, tr("The report needs an inspection: open one, or begin a new one."));
    parts_->stack = new QStackedLayout(this);
    parts_->stack->addWidget(parts_->pages);
    parts_->stack->addWidget(parts_->empty);
    clear();
}

ReportPreview::~ReportPreview() = default;

void ReportPreview::setReport(const InspectionState& state, const std::string& headHash) {
    parts_->pages->setDocument(std::make_shared<report::ReportDocument>(report::reportContent(state, headHash)));
    parts_->stack->setCurrentWidget(parts_->pages);
}

void ReportPreview::clear() {
    parts_->pages->setDocument(nullptr);
    parts_->stack->setCurrentWidget(parts_->empty);
}

int ReportPreview::pageCount() const {
    return parts_->pages->pageCount();
}

void ReportPreview::goToPage(int page) {
    parts_->pages->goToPage(page);
}

}  // namespace fodscope
