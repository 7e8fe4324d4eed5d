// SPDX-License-Identifier: MIT
#include "ui/report/ReportPdf.h"

#include <QBuffer>
#include <QPageLayout>
#include <QPainter>
#include <QPdfWriter>

#include "core/common/Error.h"
#include "ui/report/ReportStyle.h"

namespace fodscope::report {

QByteArray reportPdf(const std::shared_ptr<const ReportContent>& content) {
    const ReportDocument document(content);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_1_6);
    writer.setResolution(kUnitsPerInch);
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(0, 0, 0, 0)));
    writer.setTitle(QString::fromStdString(content->model.title));
    writer.setCreator(QStringLiteral("Fodscope ") + QString::fromStdString(content->state.header.softwareVersion));
    QPainter painter;
    if (!painter.begin(&writer)) {
        throw Error("report", "the PDF could not be begun", "write the report as HTML, and report this as a fault");
    }
    for (int page = 0; page < document.pageCount(); ++page) {
        if (page > 0) writer.newPage();
        document.paintPage(painter, page);
    }
    painter.end();
    return bytes;
}

}  // namespace fodscope::report
