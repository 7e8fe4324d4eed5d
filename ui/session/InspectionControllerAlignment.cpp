// SPDX-License-Identifier: MIT
// How the map lies on the reference: start poses, poses to choose from, and what is left region by region.
#include "core/detection/Candidates.h"
#include "ui/session/InspectionController.h"

namespace fodscope {
namespace {

double floorOf(std::span<const Eigen::Vector3d> points) {
    ReferenceMap cloud;
    cloud.points.assign(points.begin(), points.end());
    return floorHeight(cloud);
}

}  // namespace

void InspectionController::setStartPose(const Transform& T_reference_from_map) {
    if (!inspection_) return;
    start_ = T_reference_from_map;
    givenTransform_.reset();
    previewPose(std::nullopt);
    emit mapChanged();
    if (state().reference && state().mapSource) detect();
}

void InspectionController::setStartPose(const Pose2& mapOrigin_reference) {
    if (!inspection_) return;
    Transform start = transformFromPose(mapOrigin_reference);
    attempt([&] {
        // Nobody types a height: the two floors lie on each other.
        if (state().reference) start.translation().z() = floorOf(state().reference->points);
        if (map_) start.translation().z() -= floorOf(map_->cloud->points);
    });
    setStartPose(start);
}

void InspectionController::loadStartPose(const QString& csvFile) {
    attempt([&] { setStartPose(readTransformCsv(csvFile.toStdString())); });
}

void InspectionController::alignBySearch() {
    if (!givenTransform_ && !start_) return;
    givenTransform_.reset();
    start_.reset();
    previewPose(std::nullopt);
    emit mapChanged();
    if (state().reference && state().mapSource) detect();
}

void InspectionController::previewPose(const std::optional<Transform>& T_reference_from_map) {
    if (!previewedPose_ && !T_reference_from_map) return;
    previewedPose_ = T_reference_from_map;
    emit posePreviewChanged();
}

void InspectionController::flyToPlace(const Eigen::Vector3d& centre_reference, double radius_m) {
    emit flyToPlaceRequested(centre_reference, radius_m);
}

void InspectionController::refreshResiduals() {
    const auto field = state().detection ? state().detection->field : nullptr;
    if (field == residualsOf_) return;
    residualsOf_ = field;
    residuals_.reset();
    emit residualsChanged();
    if (!field || !state().reference) return;
    runFor(Step::Map, tr("measuring what is left between map and reference"),
           [this, field, reference = state().reference](Progress& progress) -> TaskRunner::Adopt {
               // The field's voxels already lie in the reference frame, and a reopened session has them too.
               const auto residuals = std::make_shared<const RegionResiduals>(measureRegionResiduals(
                   field->points, Transform::Identity(), reference->points, RegionResidualSettings{}, progress));
               return [this, field, residuals] {
                   if (field != residualsOf_) return;
                   residuals_ = residuals;
                   emit residualsChanged();
               };
           });
}

}  // namespace fodscope
