// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "ui/session/InspectionController.h"
#include "ui/view3d/View3D.h"

namespace fodscope {

/// Keeps the 3D view showing what the inspection holds, in the layers that the step needs, and carries clicks back.
class SceneBinding : public QObject {
    Q_OBJECT

  public:
    SceneBinding(InspectionController& controller, View3D& view, QObject* parent);

    void setStep(Step step);
    /// Colours the reference by how much its covariances allow.
    void setHeatMap(bool shown);
    /// Colours the reference by how far off the map has its regions, in the step of the map.
    void setResiduals(bool shown);

  private:
    void refreshAll();
    void showReference();
    void colourReference();
    bool showsResiduals() const;
    void showMap();
    void showDetection();
    void showCandidates();
    void showPlan();
    void showRobot();
    void showLayers();
    void tellPoint(const PickedPoint& point);
    Transform T_reference_from_map() const;
    double floorHeight_m() const;
    Pose2 inReference(const Pose2& pose_map) const;

    InspectionController& controller_;
    View3D& view_;
    Step step_ = Step::Reference;
    bool heatMap_ = false;
    bool residuals_ = false;
    /// What the reference's colours were made from; null: it is plain.
    std::shared_ptr<const void> colouredBy_;
    const ReferenceMap* shownReference_ = nullptr;
    const PointCloud* shownMap_ = nullptr;
    const DiscrepancyField* shownField_ = nullptr;
    std::optional<Metric> shownMetric_;
    bool fitted_ = false;
};

/// How a metric's values are coloured: an absolute range, so that one colour means one value all day.
ScalarStyle discrepancyStyle(const CandidateSettings& settings);

}  // namespace fodscope
