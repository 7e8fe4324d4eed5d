// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QThreadPool>
#include <memory>
#include <optional>

#include "core/detection/Candidates.h"

namespace fodscope {

/// What a preview of candidates is made from.
struct PreviewRequest {
    std::shared_ptr<const DiscrepancyField> field;
    CandidateSettings settings;
    double voxelSize_m = 0.02;
    double floorHeight_m = 0.0;
    Transform T_reference_from_map = Transform::Identity();
    /// The candidates whose ids are carried over.
    std::shared_ptr<const CandidateSet> earlier;
    int highestCandidateNumber = 0;
};

/// Finds candidates while a slider is dragged: on a worker thread, at most one run at a time, and of the requests that
/// came meanwhile only the last is worked on.
class CandidatePreview : public QObject {
    Q_OBJECT

  public:
    explicit CandidatePreview(QObject* parent = nullptr);
    ~CandidatePreview() override;

    void request(PreviewRequest request);
    /// Forgets what is under way.
    void drop();
    bool isBusy() const { return running_; }

  signals:
    void ready(const std::shared_ptr<const fodscope::CandidateSet>& candidates,
               const fodscope::CandidateSettings& settings);
    void failed(const QString& sentence);

  private:
    void start(PreviewRequest request);
    void finish(int number, std::shared_ptr<const CandidateSet> candidates, const CandidateSettings& settings,
                const QString& error);

    QThreadPool thread_;
    std::optional<PreviewRequest> next_;
    std::shared_ptr<Progress> progress_;
    bool running_ = false;
    int wanted_ = 0;
};

}  // namespace fodscope
