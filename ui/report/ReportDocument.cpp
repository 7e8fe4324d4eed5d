// SPDX-License-Identifier: MIT
#include "ui/report/ReportDocument.h"

#include <QObject>
#include <QPainter>
#include <iterator>

#include "ui/report/ReportBlocks.h"
#include "ui/report/ReportSections.h"

namespace fodscope::report {

namespace {

void append(Flow& flow, Flow more) {
    flow.insert(flow.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void paintWatermark(QPainter& painter) {
    painter.save();
    painter.translate(0.5 * kPageWidth, 0.5 * kPageHeight);
    painter.rotate(-52.0);
    QFont large = font(Face::Title);
    large.setPixelSize(430);
    painter.setFont(large);
    painter.setPen(QColor(0, 0, 0, 16));
    painter.drawText(QRectF(-1600.0, -400.0, 3200.0, 800.0), Qt::AlignCenter, QObject::tr("DRAFT"));
    painter.restore();
}

}  // namespace

std::shared_ptr<const ReportContent> reportContent(const InspectionState& state, const std::string& headHash) {
    auto content = std::make_shared<ReportContent>();
    content->state = state;
    content->model = makeReportModel(state);
    content->headHash = headHash.empty() ? "not recorded" : headHash;
    content->plan = planScene(state);
    content->planImages = forPrint(planImages(content->plan, colours()));
    return content;
}

ReportDocument::ReportDocument(std::shared_ptr<const ReportContent> content) : content_(std::move(content)) {
    append(flow_, titleSection(*content_));
    append(flow_, limitsSection(*content_));
    append(flow_, planSection(content_));
    append(flow_, findingsSection(content_));
    append(flow_, otherCandidatesSection(*content_));
    append(flow_, groundsSection(*content_));
    pages_ = paginate(flow_, kContentHeight);
}

void ReportDocument::paintPage(QPainter& painter, int page) const {
    if (page < 0 || page >= pageCount()) return;
    painter.save();
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing | QPainter::SmoothPixmapTransform);
    for (const PlacedItem& placed : pages_[static_cast<std::size_t>(page)]) {
        painter.save();
        placed.item->paint(painter, {kSideMargin, kTop + placed.top});
        painter.restore();
    }
    if (!content_->model.missing.empty()) paintWatermark(painter);
    paintHeaderAndFooter(painter, page);
    painter.restore();
}

void ReportDocument::paintHeaderAndFooter(QPainter& painter, int page) const {
    const ReportModel& model = content_->model;
    const bool isDraft = !model.missing.empty();
    const auto line = [&](double y) { painter.fillRect(QRectF(kSideMargin, y, kContentWidth, 2.0), colours().line); };
    const auto put = [&](double top, Qt::Alignment side, Face face, const QColor& colour, const QString& text) {
        painter.setFont(font(face));
        painter.setPen(colour);
        const QFontMetricsF metrics(painter.font());
        painter.drawText(QRectF(kSideMargin, top, kContentWidth, 40.0), side | Qt::AlignVCenter,
                         metrics.elidedText(text, Qt::ElideRight, kContentWidth));
    };
    const QString title = QString::fromStdString(model.title);
    const QFontMetricsF small(font(Face::Small));
    put(130.0, Qt::AlignLeft, Face::Small, colours().muted,
        small.elidedText(title, Qt::ElideRight, 0.5 * kContentWidth));
    const QString id = content_->state.header.id.empty() ? QObject::tr("not recorded")
                                                         : QString::fromStdString(content_->state.header.id);
    put(130.0, Qt::AlignRight, Face::Small, colours().muted, QObject::tr("inspection %1").arg(id));
    if (isDraft) put(86.0, Qt::AlignHCenter, Face::Bold, colours().finding, QObject::tr("draft – not issued"));
    line(176.0);

    line(2826.0);
    put(2838.0, Qt::AlignLeft, Face::Mono, colours().muted,
        QObject::tr("head hash %1").arg(QString::fromStdString(content_->headHash)));
    put(2838.0, Qt::AlignRight, Face::Small, colours().muted,
        QObject::tr("page %1 of %2").arg(page + 1).arg(pageCount()));
}

}  // namespace fodscope::report
