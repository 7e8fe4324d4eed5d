// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QThreadPool>
#include <memory>
#include <optional>

#include "ui/session/CandidateFinder.h"

namespace fodscope {

/// What a preview of candidates is made from.
struct PreviewRequest {
    /// Its candidates' ids are carried over.
    DetectionRecord detection;
    CandidateSettings settings;
    int highestCandidateNumber = 0;
};

/// Finds candidates while a slider is dragged: on a worker thread, at most one run at a time, and of the requests that
/// came meanwhile only the last is worked on.
class CandidatePreview : public QObject {
    Q_OBJECT

  public:
    explicit CandidatePreview(std::shared_ptr<CandidateFinder> finder, QObject* parent = nullptr);
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

    std::shared_ptr<CandidateFinder> finder_;
    QThreadPool thread_;
    std::optional<PreviewRequest> next_;
    std::shared_ptr<Progress> progress_;
    bool running_ = false;
    int wanted_ = 0;
};

}  // namespace fodscope
