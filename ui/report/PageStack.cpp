// SPDX-License-Identifier: MIT
#include "ui/report/PageStack.h"

#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "ui/report/ReportStyle.h"

namespace fodscope::report {

namespace {

constexpr int kGap_px = 20;
constexpr int kWidest_px = 900;
constexpr std::size_t kKept = 6;

}  // namespace

PageStack::PageStack(QWidget* parent) : QAbstractScrollArea(parent) {
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Pages of the report"));
    verticalScrollBar()->setSingleStep(40);
}

void PageStack::setDocument(std::shared_ptr<const ReportDocument> document) {
    document_ = std::move(document);
    images_.clear();
    updateScrollBar();
    viewport()->update();
}

int PageStack::pageWidth() const {
    return std::clamp(viewport()->width() - 2 * kGap_px, 200, kWidest_px);
}

int PageStack::pageHeight() const {
    return static_cast<int>(std::lround(pageWidth() * kPageHeight / kPageWidth));
}

int PageStack::pageTop(int page) const {
    return kGap_px + page * (pageHeight() + kGap_px);
}

void PageStack::goToPage(int page) {
    verticalScrollBar()->setValue(pageTop(std::clamp(page, 0, std::max(0, pageCount() - 1))) - kGap_px);
}

int PageStack::currentPage() const {
    const int middle = verticalScrollBar()->value() + viewport()->height() / 2;
    return std::clamp((middle - kGap_px) / (pageHeight() + kGap_px), 0, std::max(0, pageCount() - 1));
}

void PageStack::updateScrollBar() {
    verticalScrollBar()->setPageStep(viewport()->height());
    verticalScrollBar()->setRange(0, std::max(0, pageTop(pageCount()) - viewport()->height()));
}

const QImage& PageStack::imageOf(int page) {
    const auto known = images_.find(page);
    if (known != images_.end()) return known->second;
    if (images_.size() >= kKept) {
        // The page farthest away is the last to be looked at again.
        const auto farthest = std::max_element(images_.begin(), images_.end(), [page](const auto& a, const auto& b) {
            return std::abs(a.first - page) < std::abs(b.first - page);
        });
        images_.erase(farthest);
    }
    const double ratio = devicePixelRatioF();
    QImage image(QSize(pageWidth(), pageHeight()) * ratio, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.scale(image.width() / kPageWidth, image.width() / kPageWidth);
    document_->paintPage(painter, page);
    painter.end();
    image.setDevicePixelRatio(ratio);
    return images_.emplace(page, std::move(image)).first->second;
}

void PageStack::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    const Theme theme = currentTheme();
    painter.fillRect(viewport()->rect(), theme.surface0);
    const int left = (viewport()->width() - pageWidth()) / 2;
    for (int page = 0; page < pageCount(); ++page) {
        const QRect place(left, pageTop(page) - verticalScrollBar()->value(), pageWidth(), pageHeight());
        if (!place.intersects(viewport()->rect())) continue;
        painter.drawImage(place, imageOf(page));
        painter.setPen(theme.line);
        painter.drawRect(place.adjusted(0, 0, -1, -1));
    }
}

void PageStack::resizeEvent(QResizeEvent*) {
    const int page = currentPage();
    const bool rescaled =
        images_.empty() || images_.begin()->second.width() != static_cast<int>(pageWidth() * devicePixelRatioF());
    if (rescaled) images_.clear();
    updateScrollBar();
    if (rescaled && page > 0) goToPage(page);
}

void PageStack::scrollContentsBy(int, int) {
    viewport()->update();
}

void PageStack::keyPressEvent(QKeyEvent* event) {
    QScrollBar* bar = verticalScrollBar();
    switch (event->key()) {
        case Qt::Key_Home:
            bar->setValue(0);
            break;
        case Qt::Key_End:
            bar->setValue(bar->maximum());
            break;
        case Qt::Key_PageDown:
            goToPage(currentPage() + 1);
            break;
        case Qt::Key_PageUp:
            goToPage(currentPage() - 1);
            break;
        default:
            QAbstractScrollArea::keyPressEvent(event);
    }
}

}  // namespace fodscope::report
