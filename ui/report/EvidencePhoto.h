// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <QImage>
#include <QPolygonF>
#include <QRectF>
#include <QSizeF>
#include <QString>
#include <string>
#include <vector>

#include "core/inspection/InspectionState.h"

QT_BEGIN_NAMESPACE
class QPainter;
QT_END_NAMESPACE

namespace fodscope::report {

/// Photos are no larger than this in a report, on the longer edge; the session keeps them as received.
inline constexpr int kLongestEdge_px = 1600;

struct EvidenceMark {
    QPolygonF polygon_px;
    QString text;
    /// A reader's box, not the candidate's outline.
    bool isBox = false;
};

/// A photo of a candidate with what is drawn on it, in pixels of the photo as received.
struct EvidencePhoto {
    const Photo* photo = nullptr;
    QSizeF size_px;
    std::vector<EvidenceMark> marks;
};

/// The photo that shows a candidate best: where readers named FOD, drew a box, or the outline is largest.
/// @return a null photo when none shows it
EvidencePhoto evidenceOf(const InspectionState& state, const std::string& candidateId);

/// The photo's pixels, down-scaled where needed; null when the bytes are no picture.
QImage evidenceImage(const EvidencePhoto& evidence);

/// The same as JPEG: the bytes as received when they are small enough, empty when they are no picture.
struct EncodedPhoto {
    QByteArray bytes;
    QString mediaType;
};
EncodedPhoto encodedEvidence(const EvidencePhoto& evidence);

/// Paints photo and marks into an area, keeping the photo's shape; says so when it is no picture.
/// @return the rectangle that the photo takes
QRectF paintEvidence(QPainter& painter, const QRectF& area, const EvidencePhoto& evidence);

}  // namespace fodscope::report
