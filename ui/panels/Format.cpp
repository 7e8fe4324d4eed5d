// SPDX-License-Identifier: MIT
#include "ui/panels/Format.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace fodscope {
namespace {

QString words(const char* text) {
    return QCoreApplication::translate("fodscope", text);
}

QString number(double value, int decimals) {
    const QString digits = QLocale::c().toString(value, 'f', decimals);
    // What rounds to nothing has no sign.
    const bool isZero = value < 0.0 && digits.indexOf(QRegularExpression(QStringLiteral("[1-9]"))) < 0;
    return isZero ? digits.mid(1) : digits;
}

const QString kUnknown = QStringLiteral("–");

}  // namespace

QString centimetres(double metres, int decimals) {
    return std::isfinite(metres) ? number(metres * 100.0, decimals) + QStringLiteral(" cm") : kUnknown;
}

QString millimetres(double metres, int decimals) {
    return std::isfinite(metres) ? number(metres * 1000.0, decimals) + QStringLiteral(" mm") : kUnknown;
}

QString percent(double share, int decimals) {
    if (!std::isfinite(share)) return kUnknown;
    // Rounded down, as in the report: 100 % is said of the whole only.
    const double unit = std::pow(10.0, decimals);
    return number(std::floor(share * 100.0 * unit + 1e-9) / unit, decimals) + QStringLiteral(" %");
}

QString observedText(double share) {
    return percent(std::floor(share * 100.0 + 1e-9) / 100.0);
}

QString count(std::size_t number) {
    QString digits = QString::number(number);
    for (int i = digits.size() - 3; i > 0; i -= 3)
        digits.insert(i, QChar(0x2009));
    return digits;
}

QString sizeText(const Eigen::Vector3d& size_m) {
    return QStringLiteral("%1 × %2 × %3 cm")
        .arg(number(size_m.x() * 100.0, 0), number(size_m.y() * 100.0, 0), number(size_m.z() * 100.0, 0));
}

QString placeText(const Eigen::Vector3d& point) {
    return QStringLiteral("%1, %2, %3 m").arg(number(point.x(), 2), number(point.y(), 2), number(point.z(), 2));
}

QString spreadText(double logDeterminant) {
    return millimetres(std::exp(logDeterminant / 6.0), 1);
}

QString originText(const Pose2& pose) {
    return QStringLiteral("x %1 m, y %2 m, yaw %3°")
        .arg(number(pose.x_m, 2), number(pose.y_m, 2), number(degreesFromRadians(pose.yaw_rad), 0));
}

QString deviationText(const Eigen::Vector3d& deviation, double displayFactor, const QString& unit, int decimals) {
    return QStringLiteral("± %1, %2, %3 %4")
        .arg(number(deviation.x() * displayFactor, decimals), number(deviation.y() * displayFactor, decimals),
             number(deviation.z() * displayFactor, decimals), unit);
}

QString discrepancyText(double value, Metric metric) {
    if (!std::isfinite(value)) return words("not known");
    return metric == Metric::Euclidean ? millimetres(value, 1) : number(value, 2);
}

QString counted(std::size_t number, const QString& one, const QString& several) {
    return QStringLiteral("%1 %2").arg(count(number), number == 1 ? one : several);
}

QString fileNameOf(const SourceFile& source) {
    const QString path = QString::fromStdString(source.path);
    return path.mid(path.lastIndexOf(QLatin1Char('/')) + 1);
}

StateText stateText(StepState state) {
    switch (state) {
        case StepState::ToDo:
            return {StatusKind::ToDo, words("to do")};
        case StepState::Running:
            return {StatusKind::Running, words("running")};
        case StepState::NeedsLook:
            return {StatusKind::Attention, words("needs a look")};
        case StepState::Done:
            return {StatusKind::Clear, words("done")};
    }
    return {};
}

StateText stateText(const Visit& visit) {
    switch (visit.state) {
        case VisitState::Draft:
            if (visit.reason != VisitReason::None) return {StatusKind::Attention, words("to be visited again")};
            return {StatusKind::ToDo, words("to be visited")};
        case VisitState::Sent:
            return {StatusKind::Running, words("sent")};
        case VisitState::Accepted:
            return {StatusKind::Running, words("accepted")};
        case VisitState::Driving:
            return {StatusKind::Running, words("driving")};
        case VisitState::Arrived:
            return {StatusKind::Running, words("arrived")};
        case VisitState::Photo:
            return {StatusKind::Running, words("taking the photo")};
        case VisitState::Done:
            return {StatusKind::Clear, words("photographed")};
        case VisitState::Failed:
            return {StatusKind::Finding, words("failed")};
        case VisitState::Skipped:
            return {StatusKind::Attention, words("skipped")};
    }
    return {};
}

StateText stateText(Verdict verdict) {
    switch (verdict) {
        case Verdict::NotPhotographed:
            return {StatusKind::ToDo, words("not photographed")};
        case Verdict::Undecided:
            return {StatusKind::Attention, words("to be labelled")};
        case Verdict::Open:
            return {StatusKind::Attention, words("open: not sure")};
        case Verdict::NoFod:
            return {StatusKind::Clear, words("no FOD")};
        case Verdict::Finding:
            return {StatusKind::Finding, words("FOD")};
    }
    return {};
}

StateText candidateState(const InspectionState& state, const CandidateVerdict& verdict) {
    if (verdict.verdict == Verdict::Finding) {
        QStringList labels;
        for (const std::string& label : verdict.fodLabels)
            labels << QString::fromStdString(label);
        return {StatusKind::Finding, words("FOD: %1").arg(labels.join(QStringLiteral(", ")))};
    }
    if (verdict.verdict != Verdict::NotPhotographed) return stateText(verdict.verdict);
    const Waypoint* waypoint = waypointOf(state, verdict.candidateId);
    if (waypoint == nullptr) return {StatusKind::ToDo, words("not planned")};
    if (!waypoint->pose_map)
        return {StatusKind::NotObserved,
                words("no waypoint: %1").arg(QString::fromStdString(toString(waypoint->status)))};
    const Visit* visit = visitOf(state, waypoint->id);
    return visit == nullptr ? stateText(verdict.verdict) : stateText(*visit);
}

const Waypoint* waypointOf(const InspectionState& state, const std::string& candidateId) {
    if (!state.plan) return nullptr;
    for (const Waypoint& waypoint : state.plan->waypoints)
        if (std::ranges::find(waypoint.candidateIds, candidateId) != waypoint.candidateIds.end()) return &waypoint;
    return nullptr;
}

const Visit* visitOf(const InspectionState& state, const std::string& waypointId) {
    const auto visit = std::ranges::find(state.visits, waypointId, &Visit::waypointId);
    return visit == state.visits.end() ? nullptr : &*visit;
}

}  // namespace fodscope
