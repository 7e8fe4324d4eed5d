// SPDX-License-Identifier: MIT
#include "ui/report/ReportSections.h"

#include <QObject>
#include <QPainter>
#include <algorithm>

#include "ui/report/FindingCard.h"
#include "ui/report/ReportBlocks.h"

namespace fodscope::report {

namespace {

/// Plan and first finding share a page.
constexpr double kPlanHeight = 1040.0;

void append(Flow& flow, Flow more) {
    flow.insert(flow.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

FlowItem titleBlock(const ReportModel& model) {
    const TextBlock kind(QObject::tr("Inspection for foreign object debris (FOD)"), Face::Body, kContentWidth,
                         colours().muted);
    const TextBlock title(words(model.title), Face::Title, kContentWidth, colours().text);
    FlowItem item;
    item.height = kind.height() + title.height() + 10.0;
    item.paint = [=](QPainter& painter, const QPointF& corner) {
        kind.paint(painter, corner);
        title.paint(painter, corner + QPointF(0.0, kind.height() + 4.0));
    };
    return item;
}

/// The statement is what is read first and quoted: set apart by a bar, never by colour alone.
FlowItem statementBlock(const ReportModel& model) {
    constexpr double kInset = 36.0;
    const TextBlock block(words(model.statement), Face::Statement, kContentWidth - 2.0 * kInset, colours().text);
    FlowItem item;
    item.height = block.height() + 2.0 * kInset;
    item.spaceBefore = 30.0;
    item.paint = [=](QPainter& painter, const QPointF& corner) {
        painter.fillRect(QRectF(corner, QSizeF(kContentWidth, item.height)), colours().surface2);
        painter.fillRect(QRectF(corner, QSizeF(10.0, item.height)), colours().text);
        block.paint(painter, corner + QPointF(kInset, kInset));
    };
    return item;
}

QString fieldValue(const ReportCandidate& candidate, std::size_t index) {
    return index < candidate.fields.size() ? words(candidate.fields[index].value) : QString();
}

QString decisionsOf(const ReportCandidate& candidate) {
    QStringList lines;
    for (const std::string& line : candidate.decisions)
        lines << words(line);
    if (lines.isEmpty()) lines << words(candidate.noPhotoReason);
    // The layout of a cell knows one paragraph; a separator of lines starts a new line in it.
    return lines.join(QChar::LineSeparator);
}

/// Columns come from the candidates' own fields, so that the table has what the model has.
Flow candidateTable(const std::vector<ReportCandidate>& candidates) {
    const auto title = [&](std::size_t index) {
        return index < candidates.front().fields.size() ? words(candidates.front().fields[index].name) : QString();
    };
    const std::vector<TableColumn> columns{{QObject::tr("Id"), 0.075},
                                           {QObject::tr("State"), 0.155},
                                           {title(0), 0.14},
                                           {title(1), 0.09},
                                           {title(2), 0.15},
                                           {title(5), 0.11},
                                           {QObject::tr("Decisions, or why there is none"), 0.28}};
    std::vector<QStringList> rows;
    for (const ReportCandidate& candidate : candidates) {
        rows.push_back({words(candidate.id), words(candidate.verdictText), fieldValue(candidate, 0),
                        fieldValue(candidate, 1), fieldValue(candidate, 2), fieldValue(candidate, 5),
                        decisionsOf(candidate)});
    }
    return table(columns, rows);
}

}  // namespace

Flow titleSection(const ReportContent& content) {
    const ReportModel& model = content.model;
    Flow flow{titleBlock(model), statementBlock(model)};
    if (!model.missing.empty()) {
        flow.push_back(heading("Draft: what is missing before this report can be issued"));
        append(flow, bullets(model.missing));
    }
    flow.push_back(twoFieldTables("Inspection", model.inspection, "Result", model.counts));
    flow.push_back(heading("Coverage"));
    append(flow, fieldTable(model.coverage));
    return flow;
}

Flow limitsSection(const ReportContent& content) {
    Flow flow{heading("Limits")};
    append(flow, bullets(content.model.limits));
    return flow;
}

Flow planSection(const std::shared_ptr<const ReportContent>& content) {
    const bool hasPlan = !planExtent(content->plan).empty;
    if (!hasPlan) return {heading("Plan"), paragraph("There is no map to draw a plan from.")};
    FlowItem drawing;
    drawing.height = kPlanHeight;
    drawing.spaceBefore = 10.0;
    drawing.paint = [content](QPainter& painter, const QPointF& corner) {
        painter.save();
        painter.translate(corner);
        painter.scale(kUnitsPerScreenPixel, kUnitsPerScreenPixel);
        const QRectF screen(0, 0, kContentWidth / kUnitsPerScreenPixel, kPlanHeight / kUnitsPerScreenPixel);
        PlanLook look;
        look.theme = colours();
        look.fontPixels = 10.0;
        const double legend = paintPlanLegend(painter, screen, content->plan, look, false);
        const QRectF plan = screen.adjusted(0, 0, 0, -legend);
        paintPlan(painter, plan, content->plan, content->planImages, fittedPlan(planExtent(content->plan), plan), look);
        paintPlanLegend(painter, QRectF(0, plan.bottom(), screen.width(), legend), content->plan, look, true);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colours().line, 0.8));
        painter.drawRect(screen);
        painter.restore();
    };
    const bool isGrid = content->plan.costMap != nullptr;
    return {
        heading("Plan"), drawing,
        paragraph(isGrid ? "Seen from above, map frame: the robot's cost map, the candidates with their ids, and the "
                           "waypoints numbered in the order of the visits."
                         : "Seen from above, map frame: the map and the candidates with their ids.",
                  Face::Small)};
}

Flow findingsSection(const std::shared_ptr<const ReportContent>& content) {
    Flow flow{heading("Findings")};
    if (content->model.findings.empty()) {
        flow.push_back(paragraph("No candidate was decided to be FOD."));
        return flow;
    }
    for (const ReportCandidate& finding : content->model.findings)
        append(flow, findingCard(content, finding));
    return flow;
}

Flow otherCandidatesSection(const ReportContent& content) {
    Flow flow{heading("Open candidates")};
    if (content.model.open.empty()) {
        flow.push_back(paragraph("Every candidate was decided."));
    } else {
        append(flow, candidateTable(content.model.open));
    }
    flow.push_back(heading("Candidates decided no FOD"));
    if (content.model.rejected.empty()) {
        flow.push_back(paragraph("None."));
    } else {
        append(flow, candidateTable(content.model.rejected));
    }
    return flow;
}

Flow groundsSection(const ReportContent& content) {
    const ReportModel& model = content.model;
    Flow flow{heading("Method")};
    flow.push_back(paragraph(model.method));
    flow.push_back(heading("Alignment"));
    append(flow, fieldTable(model.alignment));
    flow.push_back(heading("What the inspection rests on"));
    append(flow, fieldTable(model.sources));
    flow.push_back(heading("Appendix: parameters"));
    append(flow, fieldTable(model.parameters, 900.0));
    return flow;
}

}  // namespace fodscope::report
