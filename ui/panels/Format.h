// SPDX-License-Identifier: MIT
#pragma once

#include <QString>

#include "core/detection/Candidates.h"
#include "core/inspection/InspectionState.h"
#include "ui/session/Steps.h"
#include "ui/theme/Theme.h"

namespace fodscope {

/// Numbers with their units, as all panels write them.
QString centimetres(double metres, int decimals = 1);
QString millimetres(double metres, int decimals = 0);
/// Never rounded up, as in the report: 99.98 % is not all.
QString observedText(double share);
QString percent(double share, int decimals = 0);
/// 1 234 567 with thin spaces.
QString count(std::size_t number);
/// "12 × 8 × 5 cm"
QString sizeText(const Eigen::Vector3d& size_m);
/// "1.23, 0.40, 0.06 m"
QString placeText(const Eigen::Vector3d& point);
/// The standard deviation that a covariance with this log determinant has in the (geometric) mean over directions:
/// exp(log det / 6), as "8.2 mm".
QString spreadText(double logDeterminant);
/// "x 1.23 m, y 0.40 m, yaw 87°"
QString originText(const Pose2& pose);
/// "± 3, 2, 1 mm" for a deviation along x, y and z
QString deviationText(const Eigen::Vector3d& deviation, double displayFactor, const QString& unit, int decimals);
/// A discrepancy in the metric's own unit: "4.2" or "45 mm".
QString discrepancyText(double value, Metric metric);
/// "1 photo", "4 photos"
QString counted(std::size_t number, const QString& one, const QString& several);
QString fileNameOf(const SourceFile& source);

/// A state as word and kind.
struct StateText {
    StatusKind kind = StatusKind::Neutral;
    QString word;
};
StateText stateText(StepState state);
StateText stateText(const Visit& visit);
StateText stateText(Verdict verdict);
/// Of a candidate: its verdict, or where its visit is while no photo shows it.
StateText candidateState(const InspectionState& state, const CandidateVerdict& verdict);

/// The waypoint that photographs a candidate; null without one.
const Waypoint* waypointOf(const InspectionState& state, const std::string& candidateId);
const Visit* visitOf(const InspectionState& state, const std::string& waypointId);

}  // namespace fodscope
