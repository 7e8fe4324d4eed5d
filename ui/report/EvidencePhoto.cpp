// SPDX-License-Identifier: MIT
#include "ui/report/EvidencePhoto.h"

#include <QBuffer>
#include <QObject>
#include <QPainter>
#include <algorithm>

#include "ui/labelling/CandidateOutline.h"
#include "ui/labelling/PhotoDecoder.h"
#include "ui/report/ReportStyle.h"
#include "ui/theme/Colours.h"

namespace fodscope::report {

namespace {

QByteArray bytesOf(const Photo& photo) {
    return {reinterpret_cast<const char*>(photo.bytes.data()), static_cast<int>(photo.bytes.size())};
}

double areaOf(const QPolygonF& polygon) {
    double twice = 0.0;
    for (int index = 0; index < polygon.size(); ++index) {
        const QPointF& a = polygon[index];
        const QPointF& b = polygon[(index + 1) % polygon.size()];
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return 0.5 * std::abs(twice);
}

/// Each reader's decision that counts on a photo.
std::vector<const Decision*> countingOn(const InspectionState& state, const std::string& photoId) {
    std::vector<const Decision*> counting;
    for (const Decision& decision : state.decisions) {
        if (lastDecision(state.decisions, photoId, decision.labeller) == &decision) counting.push_back(&decision);
    }
    return counting;
}

struct Judged {
    EvidencePhoto evidence;
    bool namesFod = false;
    bool hasBox = false;
    double outlineArea = 0.0;

    auto rank() const { return std::make_tuple(namesFod, hasBox, outlineArea); }
};

Judged judge(const InspectionState& state, const Photo& photo, const std::string& candidateId) {
    Judged judged;
    judged.evidence.photo = &photo;
    judged.evidence.size_px = QSizeF(photo.intrinsics.width_px, photo.intrinsics.height_px);
    if (state.detection) {
        for (const CandidateOutline& outline : candidateOutlines(*state.detection, photo)) {
            if (outline.candidateId != candidateId) continue;
            judged.outlineArea = areaOf(outline.polygon_px);
            judged.evidence.marks.push_back({outline.polygon_px, QString::fromStdString(candidateId), false});
        }
    }
    for (const Decision* decision : countingOn(state, photo.id)) {
        for (const PhotoLabel& label : decision->labels) {
            judged.namesFod = judged.namesFod || kindOf(state.labelSet, label.label) == LabelKind::Fod;
            if (!label.box) continue;
            judged.hasBox = true;
            const QRectF box(label.box->left_px, label.box->top_px, label.box->width_px, label.box->height_px);
            judged.evidence.marks.push_back({QPolygonF(box), QString::fromStdString(label.label), true});
        }
    }
    return judged;
}

/// @param top upper edge of the photo: words stay on it
void paintMark(QPainter& painter, const EvidenceMark& mark, const QPolygonF& polygon, double top) {
    const QColor colour = mark.isBox ? colours().finding : candidateColour(mark.text);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, 9.0));
    painter.drawPolygon(polygon);
    painter.setPen(QPen(colour, 5.0, mark.isBox ? Qt::SolidLine : Qt::DashLine));
    painter.drawPolygon(polygon);
    painter.setFont(font(Face::Small));
    const QFontMetricsF metrics(painter.font());
    const QRectF box = polygon.boundingRect();
    const QSizeF size(metrics.horizontalAdvance(mark.text) + 16.0, metrics.height() + 4.0);
    // Words of boxes stand at the left corner, ids of outlines at the right one, so that the two keep apart.
    const double left = mark.isBox ? box.left() : box.right() - size.width();
    const QPointF corner(left, std::max(box.top() - size.height() - 4.0, top));
    painter.fillRect(QRectF(corner, size), QColor(255, 255, 255, 225));
    painter.setPen(mark.isBox ? colours().finding : colours().text);
    painter.drawText(QRectF(corner, size), Qt::AlignCenter, mark.text);
}

}  // namespace

EvidencePhoto evidenceOf(const InspectionState& state, const std::string& candidateId) {
    Judged best;
    for (const Photo& photo : state.photos) {
        const auto& ids = photo.candidateIds;
        if (std::find(ids.begin(), ids.end(), candidateId) == ids.end()) continue;
        Judged judged = judge(state, photo, candidateId);
        if (!best.evidence.photo || judged.rank() > best.rank()) best = std::move(judged);
    }
    return best.evidence;
}

QImage evidenceImage(const EvidencePhoto& evidence) {
    if (!evidence.photo) return {};
    const QImage photo = decodePhoto(bytesOf(*evidence.photo));
    if (std::max(photo.width(), photo.height()) <= kLongestEdge_px) return photo;
    return photo.scaled(kLongestEdge_px, kLongestEdge_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

EncodedPhoto encodedEvidence(const EvidencePhoto& evidence) {
    if (!evidence.photo) return {};
    const QImage image = evidenceImage(evidence);
    if (image.isNull()) return {};
    const QByteArray received = bytesOf(*evidence.photo);
    const bool isJpeg = evidence.photo->mediaType == "image/jpeg";
    const bool isSmall = image.size() == decodePhoto(received).size();
    if (isJpeg && isSmall) return {received, QStringLiteral("image/jpeg")};
    QByteArray jpeg;
    QBuffer buffer(&jpeg);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "JPEG", 85);
    return {jpeg, QStringLiteral("image/jpeg")};
}

QRectF paintEvidence(QPainter& painter, const QRectF& area, const EvidencePhoto& evidence) {
    const QImage image = evidenceImage(evidence);
    if (image.isNull()) {
        paintHatch(painter, area, colours().line);
        painter.setFont(font(Face::Body));
        painter.setPen(colours().muted);
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap,
                         evidence.photo ? QObject::tr("The photo that arrived is not a readable picture.")
                                        : QObject::tr("No photo"));
        return area;
    }
    const QSizeF fitted = QSizeF(image.size()).scaled(area.size(), Qt::KeepAspectRatio);
    const QRectF place(area.topLeft(), fitted);
    painter.drawImage(place, image);
    const QSizeF size_px = evidence.size_px.isEmpty() ? QSizeF(image.size()) : evidence.size_px;
    painter.save();
    painter.setClipRect(place, Qt::IntersectClip);
    for (const EvidenceMark& mark : evidence.marks) {
        QPolygonF polygon;
        for (const QPointF& corner : mark.polygon_px) {
            polygon << place.topLeft() + QPointF(corner.x() * place.width() / size_px.width(),
                                                 corner.y() * place.height() / size_px.height());
        }
        paintMark(painter, mark, polygon, place.top());
    }
    painter.restore();
    return place;
}

}  // namespace fodscope::report
