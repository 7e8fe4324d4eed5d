// SPDX-License-Identifier: MIT
#include "ui/report/FindingCard.h"

#include <QObject>
#include <QPainter>
#include <algorithm>

#include "ui/report/EvidencePhoto.h"
#include "ui/report/ReportBlocks.h"
#include "ui/widgets/StatusChip.h"

namespace fodscope::report {

namespace {

constexpr double kGap = 30.0;
/// The heading of the findings and two cards fill a page.
constexpr double kHeadingHeight = 90.0;
constexpr double kCardHeight = 0.5 * (kContentHeight - kHeadingHeight - 4.0 * kGap);
constexpr double kPhotoWidth = 1130.0;
constexpr double kPhotoHeight = kPhotoWidth * 9.0 / 16.0;

QString photoCaption(const ReportCandidate& finding, const EvidencePhoto& evidence) {
    if (!evidence.photo) return QString::fromStdString(finding.noPhotoReason);
    QString caption =
        QObject::tr("Photo %1 from %2, taken %3. Dashed: where the candidate lies, with doubt.")
            .arg(QString::fromStdString(evidence.photo->id), QString::fromStdString(evidence.photo->waypointId),
                 QString::fromStdString(toIso8601(evidence.photo->taken)).left(16).replace('T', ' ') +
                     QStringLiteral(" UTC"));
    QStringList others;
    for (const std::string& id : finding.photoIds) {
        if (id != evidence.photo->id) others << QString::fromStdString(id);
    }
    if (!others.isEmpty()) caption += QObject::tr(" Also on %1.").arg(others.join(QStringLiteral(", ")));
    return caption;
}

void paintPlace(QPainter& painter, const QRectF& area, const ReportContent& content, const std::string& candidateId) {
    painter.save();
    painter.translate(area.topLeft());
    painter.scale(kUnitsPerScreenPixel, kUnitsPerScreenPixel);
    const QRectF screen(QPointF(0, 0), area.size() / kUnitsPerScreenPixel);
    PlanScene scene;
    scene.costMap = content.plan.costMap;
    scene.pointsFromAbove_map = content.plan.pointsFromAbove_map;
    // Only the candidate itself carries its id here; the whole plan names all of them.
    for (const PlanCandidate& candidate : content.plan.candidates) {
        if (candidate.id == candidateId) scene.candidates.push_back(candidate);
    }
    PlanLook look;
    look.theme = colours();
    look.selectedCandidate = candidateId;
    look.showVisits = false;
    look.fontPixels = 9.0;
    paintPlan(painter, screen, scene, content.planImages, fittedPlan(planExtent(content.plan), screen), look);
    painter.setPen(QPen(colours().line, 0.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(screen);
    painter.restore();
}

struct CardText {
    std::vector<std::pair<TextBlock, TextBlock>> fields;
    std::vector<TextBlock> decisions;
};

}  // namespace

Flow findingCard(const std::shared_ptr<const ReportContent>& content, const ReportCandidate& finding) {
    const auto words = [](const std::string& text) { return QString::fromStdString(text); };
    const auto evidence = std::make_shared<EvidencePhoto>(evidenceOf(content->state, finding.id));
    const TextBlock title(words(finding.id + " · " + finding.verdictText), Face::Heading, kContentWidth - 60.0,
                          colours().text);
    const TextBlock caption(photoCaption(finding, *evidence), Face::Small, kPhotoWidth, colours().muted);
    constexpr double kHalf = 0.5 * (kContentWidth - kGap);
    constexpr double kNameWidth = 430.0;
    const auto text = std::make_shared<CardText>();
    for (const ReportField& field : finding.fields) {
        text->fields.emplace_back(TextBlock(words(field.name), Face::Small, kNameWidth - 16.0, colours().muted),
                                  TextBlock(words(field.value), Face::Small, kHalf - kNameWidth, colours().text));
    }
    const double textTop = title.height() + 16.0 + kPhotoHeight + 8.0 + caption.height() + 20.0;
    double room = kCardHeight - textTop - 2.0 * kGap;
    std::vector<std::string> left;
    for (const std::string& line : finding.decisions) {
        TextBlock block(words(line), Face::Small, kHalf, colours().text);
        if (left.empty() && block.height() + 6.0 <= room) {
            room -= block.height() + 6.0;
            text->decisions.push_back(std::move(block));
        } else {
            left.push_back(line);
        }
    }

    FlowItem card;
    card.height = kCardHeight;
    card.spaceBefore = 2.0 * kGap;
    card.keepWithNext = !left.empty();
    card.paint = [=, id = finding.id](QPainter& painter, const QPointF& corner) {
        paintStatusShape(painter, QRectF(corner + QPointF(0.0, 6.0), QSizeF(38.0, 38.0)), StatusKind::Finding,
                         colours());
        title.paint(painter, corner + QPointF(54.0, 0.0));
        const QPointF pictures = corner + QPointF(0.0, title.height() + 16.0);
        paintEvidence(painter, QRectF(pictures, QSizeF(kPhotoWidth, kPhotoHeight)), *evidence);
        paintPlace(painter,
                   QRectF(pictures + QPointF(kPhotoWidth + kGap, 0.0),
                          QSizeF(kContentWidth - kPhotoWidth - kGap, kPhotoHeight)),
                   *content, id);
        caption.paint(painter, pictures + QPointF(0.0, kPhotoHeight + 8.0));
        double top = corner.y() + textTop;
        for (const auto& [name, value] : text->fields) {
            name.paint(painter, {corner.x(), top});
            value.paint(painter, {corner.x() + kNameWidth, top});
            top += std::max(name.height(), value.height()) + 6.0;
        }
        top = corner.y() + textTop;
        const double right = corner.x() + kHalf + kGap;
        TextBlock(QObject::tr("Decisions"), Face::Small, kHalf, colours().muted).paint(painter, {right, top});
        top += 36.0;
        for (const TextBlock& line : text->decisions) {
            line.paint(painter, {right, top});
            top += line.height() + 6.0;
        }
    };
    Flow flow{std::move(card)};
    for (const std::string& line : left)
        flow.push_back(paragraph(line, Face::Small));
    return flow;
}

}  // namespace fodscope::report
