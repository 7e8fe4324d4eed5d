// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <QString>
#include <QStringList>
#include <memory>
#include <string>
#include <vector>

#include "core/inspection/ReportModel.h"
#include "ui/report/PageFlow.h"
#include "ui/report/ReportStyle.h"

QT_BEGIN_NAMESPACE
class QTextLayout;
QT_END_NAMESPACE

namespace fodscope::report {

/// Text broken into lines of a width; can be painted any number of times.
class TextBlock {
  public:
    TextBlock(const QString& text, Face face, double width, const QColor& colour);

    double height() const { return height_; }
    /// Width of the longest line.
    double usedWidth() const;
    void paint(QPainter& painter, const QPointF& corner) const;

  private:
    std::shared_ptr<QTextLayout> layout_;
    QColor colour_;
    double height_ = 0.0;
};

FlowItem heading(const std::string& text);
FlowItem paragraph(const std::string& text, Face face = Face::Body);
/// Sentences with a dot before each.
Flow bullets(const std::vector<std::string>& sentences);

/// Names in a muted column, values beside them; one item a row.
Flow fieldTable(const std::vector<ReportField>& fields, double nameWidth = 480.0);

/// Two field tables side by side, as one item.
FlowItem twoFieldTables(const std::string& leftTitle, const std::vector<ReportField>& left,
                        const std::string& rightTitle, const std::vector<ReportField>& right);

struct TableColumn {
    QString title;
    /// Share of the content's width.
    double share = 1.0;
};

/// A table whose header comes again on every page.
Flow table(const std::vector<TableColumn>& columns, const std::vector<QStringList>& rows);

}  // namespace fodscope::report
