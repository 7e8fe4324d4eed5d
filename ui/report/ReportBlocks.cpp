// SPDX-License-Identifier: MIT
#include "ui/report/ReportBlocks.h"

#include <QPainter>
#include <QTextLayout>
#include <algorithm>

namespace fodscope::report {

namespace {

constexpr double kRowGap = 14.0;
constexpr double kColumnGap = 24.0;

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

void paintRule(QPainter& painter, const QPointF& left, double width, double thickness = 2.0) {
    painter.fillRect(QRectF(left.x(), left.y(), width, thickness), colours().line);
}

FlowItem fieldRow(const ReportField& field, double nameWidth, double width) {
    const auto name =
        std::make_shared<TextBlock>(text(field.name), Face::Body, nameWidth - kColumnGap, colours().muted);
    const auto value = std::make_shared<TextBlock>(text(field.value), Face::Body, width - nameWidth, colours().text);
    FlowItem row;
    row.height = std::max(name->height(), value->height()) + kRowGap;
    row.paint = [=](QPainter& painter, const QPointF& corner) {
        name->paint(painter, corner);
        value->paint(painter, corner + QPointF(nameWidth, 0.0));
        paintRule(painter, corner + QPointF(0.0, row.height - 0.6 * kRowGap), width, 1.5);
    };
    return row;
}

/// Rows under each other as one item.
FlowItem stacked(std::vector<FlowItem> rows) {
    FlowItem item;
    for (const FlowItem& row : rows)
        item.height += row.spaceBefore + row.height;
    item.paint = [rows = std::move(rows)](QPainter& painter, const QPointF& corner) {
        double top = corner.y();
        for (const FlowItem& row : rows) {
            top += row.spaceBefore;
            row.paint(painter, {corner.x(), top});
            top += row.height;
        }
    };
    return item;
}

FlowItem titled(const std::string& title, const std::vector<ReportField>& fields, double nameWidth, double width) {
    const auto name = std::make_shared<TextBlock>(text(title), Face::Bold, width, colours().text);
    FlowItem head;
    head.height = name->height() + kRowGap;
    head.paint = [name](QPainter& painter, const QPointF& corner) { name->paint(painter, corner); };
    std::vector<FlowItem> rows{head};
    for (const ReportField& field : fields)
        rows.push_back(fieldRow(field, nameWidth, width));
    return stacked(std::move(rows));
}

FlowItem tableRow(const std::vector<TableColumn>& columns, const QStringList& cells, Face face, bool isHeader) {
    std::vector<std::pair<double, TextBlock>> blocks;
    double left = 0.0;
    double height = 0.0;
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const double width = columns[column].share * kContentWidth;
        const QColor colour = isHeader ? colours().muted : colours().text;
        blocks.emplace_back(left, TextBlock(cells.value(static_cast<int>(column)), face, width - kColumnGap, colour));
        height = std::max(height, blocks.back().second.height());
        left += width;
    }
    FlowItem row;
    row.height = height + 2.0 * kRowGap;
    row.keepWithNext = isHeader;
    row.paint = [blocks = std::move(blocks), height, isHeader](QPainter& painter, const QPointF& corner) {
        if (isHeader) {
            painter.fillRect(QRectF(corner, QSizeF(kContentWidth, height + 1.4 * kRowGap)), colours().surface2);
        }
        const double indent = isHeader ? 8.0 : 8.0;
        for (const auto& [left, block] : blocks)
            block.paint(painter, corner + QPointF(left + indent, 0.7 * kRowGap));
        paintRule(painter, corner + QPointF(0.0, height + 1.5 * kRowGap), kContentWidth, 1.5);
    };
    return row;
}

}  // namespace

TextBlock::TextBlock(const QString& text, Face face, double width, const QColor& colour)
    : layout_(std::make_shared<QTextLayout>(text, report::font(face))), colour_(colour) {
    QTextOption option;
    // Fingerprints and paths have no blanks to break at.
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout_->setTextOption(option);
    layout_->setCacheEnabled(true);
    layout_->beginLayout();
    for (QTextLine line = layout_->createLine(); line.isValid(); line = layout_->createLine()) {
        line.setLineWidth(std::max(20.0, width));
        line.setPosition({0.0, height_});
        height_ += line.height() * 1.12;
    }
    layout_->endLayout();
}

double TextBlock::usedWidth() const {
    double width = 0.0;
    for (int line = 0; line < layout_->lineCount(); ++line) {
        width = std::max(width, layout_->lineAt(line).naturalTextWidth());
    }
    return width;
}

void TextBlock::paint(QPainter& painter, const QPointF& corner) const {
    painter.setPen(colour_);
    layout_->draw(&painter, corner);
}

FlowItem heading(const std::string& words) {
    const TextBlock block(text(words), Face::Heading, kContentWidth, colours().text);
    FlowItem item;
    item.height = block.height() + 22.0;
    item.spaceBefore = 56.0;
    item.keepWithNext = true;
    item.paint = [block](QPainter& painter, const QPointF& corner) {
        block.paint(painter, corner);
        paintRule(painter, corner + QPointF(0.0, block.height() + 6.0), kContentWidth, 3.0);
    };
    return item;
}

FlowItem paragraph(const std::string& words, Face face) {
    const TextBlock block(text(words), face, kContentWidth, colours().text);
    FlowItem item;
    item.height = block.height();
    item.spaceBefore = 14.0;
    item.paint = [block](QPainter& painter, const QPointF& corner) { block.paint(painter, corner); };
    return item;
}

Flow bullets(const std::vector<std::string>& sentences) {
    constexpr double kIndent = 40.0;
    Flow flow;
    for (const std::string& sentence : sentences) {
        const TextBlock block(text(sentence), Face::Body, kContentWidth - kIndent, colours().text);
        const TextBlock dot(QStringLiteral("•"), Face::Body, kIndent, colours().muted);
        FlowItem item;
        item.height = block.height();
        item.spaceBefore = 10.0;
        item.paint = [block, dot](QPainter& painter, const QPointF& corner) {
            dot.paint(painter, corner + QPointF(8.0, 0.0));
            block.paint(painter, corner + QPointF(kIndent, 0.0));
        };
        flow.push_back(std::move(item));
    }
    return flow;
}

Flow fieldTable(const std::vector<ReportField>& fields, double nameWidth) {
    Flow flow;
    for (const ReportField& field : fields)
        flow.push_back(fieldRow(field, nameWidth, kContentWidth));
    return flow;
}

FlowItem twoFieldTables(const std::string& leftTitle, const std::vector<ReportField>& left,
                        const std::string& rightTitle, const std::vector<ReportField>& right) {
    constexpr double kGap = 60.0;
    const double width = 0.5 * (kContentWidth - kGap);
    const FlowItem first = titled(leftTitle, left, 260.0, width);
    const FlowItem second = titled(rightTitle, right, 500.0, width);
    FlowItem item;
    item.height = std::max(first.height, second.height);
    item.spaceBefore = 36.0;
    item.paint = [=](QPainter& painter, const QPointF& corner) {
        first.paint(painter, corner);
        second.paint(painter, corner + QPointF(width + kGap, 0.0));
    };
    return item;
}

Flow table(const std::vector<TableColumn>& columns, const std::vector<QStringList>& rows) {
    QStringList titles;
    for (const TableColumn& column : columns)
        titles << column.title;
    const auto header = std::make_shared<FlowItem>(tableRow(columns, titles, Face::Small, true));
    Flow flow{*header};
    flow.front().spaceBefore = 10.0;
    for (const QStringList& cells : rows) {
        FlowItem row = tableRow(columns, cells, Face::Small, false);
        row.repeatedHeader = header;
        flow.push_back(std::move(row));
    }
    return flow;
}

}  // namespace fodscope::report
