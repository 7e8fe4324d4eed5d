// SPDX-License-Identifier: MIT
#include "ui/report/ReportHtml.h"

#include <QBuffer>
#include <QObject>
#include <QPainter>

#include "ui/report/EvidencePhoto.h"
#include "ui/report/HtmlText.h"
#include "ui/report/ReportStyle.h"
#include "ui/theme/Colours.h"

namespace fodscope::report {

namespace {

QString words(const std::string& text) {
    return QString::fromStdString(text);
}

QString pngUri(const QImage& image) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return dataUri(png, QStringLiteral("image/png"));
}

/// Outline and boxes are drawn over the photo, not into it.
QString marksSvg(const EvidencePhoto& evidence) {
    QString svg;
    for (const EvidenceMark& mark : evidence.marks) {
        QStringList corners;
        for (const QPointF& corner : mark.polygon_px) {
            corners << QStringLiteral("%1,%2").arg(corner.x(), 0, 'f', 1).arg(corner.y(), 0, 'f', 1);
        }
        const QString points = corners.join(QLatin1Char(' '));
        const QString colour = mark.isBox ? colours().finding.name() : candidateColour(mark.text).name();
        const QRectF box = mark.polygon_px.boundingRect();
        svg += QStringLiteral("<polygon points=\"%1\" fill=\"none\" stroke=\"#ffffff\" stroke-width=\"7\"/>\n")
                   .arg(points);
        svg += QStringLiteral("<polygon points=\"%1\" fill=\"none\" stroke=\"%2\" stroke-width=\"4\"%3/>\n")
                   .arg(points, colour, mark.isBox ? QString() : QStringLiteral(" stroke-dasharray=\"16 9\""));
        const double left = mark.isBox ? box.left() : box.right() - 76.0;
        svg += QStringLiteral(
                   "<text x=\"%1\" y=\"%2\" font-size=\"26\" font-family=\"sans-serif\" fill=\"#000000\" "
                   "stroke=\"#ffffff\" stroke-width=\"5\" paint-order=\"stroke\">%3</text>\n")
                   .arg(left, 0, 'f', 1)
                   .arg(std::max(26.0, box.top() - 12.0), 0, 'f', 1)
                   .arg(escaped(mark.text));
    }
    return svg;
}

QString photoFigure(const ReportCandidate& finding, const EvidencePhoto& evidence) {
    if (!evidence.photo) return QStringLiteral("<div class=\"nophoto\">%1</div>\n").arg(escaped(finding.noPhotoReason));
    const QString id = words(evidence.photo->id);
    const EncodedPhoto photo = encodedEvidence(evidence);
    if (photo.bytes.isEmpty()) {
        return QStringLiteral("<div class=\"nophoto\">%1</div>\n")
            .arg(escaped(QObject::tr("Photo %1 is not a readable picture.").arg(id)));
    }
    QStringList others;
    for (const std::string& other : finding.photoIds) {
        if (other != evidence.photo->id) others << words(other);
    }
    QString caption = QObject::tr("Photo %1 from %2, taken %3. Dashed: where the candidate lies, with doubt.")
                          .arg(id, words(evidence.photo->waypointId), words(toIso8601(evidence.photo->taken)));
    if (!others.isEmpty()) caption += QObject::tr(" Also on %1.").arg(others.join(QStringLiteral(", ")));
    return QStringLiteral(
               "<figure><svg viewBox=\"0 0 %1 %2\" role=\"img\" aria-label=\"%3\">\n"
               "<image width=\"%1\" height=\"%2\" href=\"%4\"/>\n%5</svg>\n<figcaption>%6</figcaption></figure>\n")
        .arg(QString::number(evidence.size_px.width()), QString::number(evidence.size_px.height()),
             escaped(QObject::tr("Photo %1 of %2").arg(id, words(finding.id))), dataUri(photo.bytes, photo.mediaType),
             marksSvg(evidence), escaped(caption));
}

QString placeFigure(const ReportContent& content, const std::string& candidateId) {
    constexpr int kWidth_px = 420;
    constexpr int kHeight_px = 440;
    PlanScene scene = content.plan;
    scene.candidates.clear();
    for (const PlanCandidate& candidate : content.plan.candidates) {
        if (candidate.id == candidateId) scene.candidates.push_back(candidate);
    }
    QImage image(kWidth_px, kHeight_px, QImage::Format_RGB32);
    QPainter painter(&image);
    PlanLook look;
    look.theme = colours();
    look.selectedCandidate = candidateId;
    look.showVisits = false;
    paintPlan(painter, image.rect(), scene, content.planImages,
              fittedPlan(planExtent(content.plan), QRectF(image.rect())), look);
    painter.end();
    return QStringLiteral("<figure>") + htmlImage(pngUri(image), QObject::tr("Place of %1").arg(words(candidateId))) +
           QStringLiteral("</figure>\n");
}

QString decisionList(const ReportCandidate& candidate) {
    return candidate.decisions.empty() ? htmlParagraph(candidate.noPhotoReason) : htmlList(candidate.decisions);
}

QString findingHtml(const ReportContent& content, const ReportCandidate& finding) {
    QString html = QStringLiteral("<section class=\"finding\" id=\"%1\">\n").arg(escaped(finding.id));
    html += htmlHeading(3, words(finding.id + " · " + finding.verdictText));
    html += QStringLiteral("<div class=\"pictures\">\n") + photoFigure(finding, evidenceOf(content.state, finding.id)) +
            placeFigure(content, finding.id) + QStringLiteral("</div>\n");
    html += QStringLiteral("<div class=\"pair\"><div>\n") + htmlFields(finding.fields) +
            QStringLiteral("</div><div>\n<p class=\"muted\">Decisions</p>\n") + decisionList(finding) +
            QStringLiteral("</div></div>\n</section>\n");
    return html;
}

QString candidateTable(const std::vector<ReportCandidate>& candidates, const std::string& whenNone) {
    if (candidates.empty()) return htmlParagraph(whenNone);
    QString html = QStringLiteral("<div class=\"scroll\"><table>\n<thead><tr><th>Id</th><th>State</th>");
    for (const ReportField& field : candidates.front().fields) {
        html += QStringLiteral("<th>%1</th>").arg(escaped(field.name));
    }
    html += QStringLiteral("<th>Decisions, or why there is none</th></tr></thead>\n<tbody>\n");
    for (const ReportCandidate& candidate : candidates) {
        html += QStringLiteral("<tr><td>%1</td><td>%2</td>").arg(escaped(candidate.id), escaped(candidate.verdictText));
        for (const ReportField& field : candidate.fields) {
            html += QStringLiteral("<td>%1</td>").arg(escaped(field.value));
        }
        QStringList lines;
        for (const std::string& line : candidate.decisions)
            lines << escaped(line);
        if (lines.isEmpty()) lines << escaped(candidate.noPhotoReason);
        html += QStringLiteral("<td>%1</td></tr>\n").arg(lines.join(QStringLiteral("<br>")));
    }
    return html + QStringLiteral("</tbody>\n</table></div>\n");
}

QString head(const ReportContent& content) {
    return QStringLiteral(
               "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
               "<title>%1</title>\n<style>%2</style>\n</head>\n<body>\n")
        .arg(escaped(content.model.title), htmlStyle());
}

QString summary(const ReportContent& content) {
    const ReportModel& model = content.model;
    QString html = QStringLiteral("<p class=\"muted\">Inspection for foreign object debris (FOD)</p>\n") +
                   htmlHeading(1, words(model.title));
    if (!model.missing.empty()) {
        html += QStringLiteral("<div class=\"draft\"><strong>Draft – not issued.</strong> What is missing:\n") +
                htmlList(model.missing) + QStringLiteral("</div>\n");
    }
    html += htmlParagraph(model.statement, QStringLiteral("statement"));
    html += QStringLiteral("<div class=\"pair\"><div>\n") + htmlHeading(3, QObject::tr("Inspection")) +
            htmlFields(model.inspection) + QStringLiteral("</div><div>\n") + htmlHeading(3, QObject::tr("Result")) +
            htmlFields(model.counts) + QStringLiteral("</div></div>\n");
    html += htmlHeading(2, QObject::tr("Coverage")) + htmlFields(model.coverage);
    html += htmlHeading(2, QObject::tr("Limits")) + htmlList(model.limits);
    html += htmlHeading(2, QObject::tr("Plan"));
    if (planExtent(content.plan).empty) return html + htmlParagraph("There is no map to draw a plan from.");
    return html + QStringLiteral("<figure>") +
           htmlImage(pngUri(planImage(content.plan, {1400, 1000}, ThemeKind::Light)),
                     QObject::tr("The candidates seen from above")) +
           QStringLiteral("<figcaption>Seen from above, map frame.</figcaption></figure>\n");
}

QString grounds(const ReportContent& content) {
    const ReportModel& model = content.model;
    QString html = htmlHeading(2, QObject::tr("Method")) + htmlParagraph(model.method);
    html += htmlHeading(2, QObject::tr("Alignment")) + htmlFields(model.alignment);
    html += htmlHeading(2, QObject::tr("What the inspection rests on")) + htmlFields(model.sources);
    html += htmlHeading(2, QObject::tr("Appendix: parameters")) + htmlFields(model.parameters);
    html +=
        QStringLiteral(
            "<footer>Inspection <span class=\"mono\">%1</span><br>Head hash <span class=\"mono\">%2</span></footer>\n")
            .arg(escaped(content.state.header.id.empty() ? std::string("not recorded") : content.state.header.id),
                 escaped(content.headHash));
    return html;
}

}  // namespace

QByteArray reportHtml(const ReportContent& content) {
    const ReportModel& model = content.model;
    QString html = head(content) + summary(content) + htmlHeading(2, QObject::tr("Findings"));
    if (model.findings.empty()) html += htmlParagraph("No candidate was decided to be FOD.");
    for (const ReportCandidate& finding : model.findings)
        html += findingHtml(content, finding);
    html += htmlHeading(2, QObject::tr("Open candidates")) + candidateTable(model.open, "Every candidate was decided.");
    html += htmlHeading(2, QObject::tr("Candidates decided no FOD")) + candidateTable(model.rejected, "None.");
    html += grounds(content) + QStringLiteral("</body>\n</html>\n");
    return html.toUtf8();
}

}  // namespace fodscope::report
