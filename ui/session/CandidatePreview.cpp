// SPDX-License-Identifier: MIT
#include "ui/session/CandidatePreview.h"

#include <QMetaObject>
#include <QRunnable>
#include <utility>

#include "core/common/Error.h"
#include "core/inspection/CandidateIds.h"
#include "ui/session/TaskRunner.h"

namespace fodscope {
namespace {

class Job : public QRunnable {
  public:
    explicit Job(std::function<void()> work) : work_(std::move(work)) {}
    void run() override { work_(); }

  private:
    std::function<void()> work_;
};

std::shared_ptr<const CandidateSet> find(const PreviewRequest& request, CandidateFinder& finder, Progress& progress) {
    const DetectionRecord& detection = request.detection;
    auto candidates =
        std::make_shared<CandidateSet>(*finder.find(detection, detection.field, request.settings, progress));
    int highest = request.highestCandidateNumber;
    if (detection.candidates) carryOverIds(*detection.candidates, *candidates, highest);
    return candidates;
}

}  // namespace

CandidatePreview::CandidatePreview(std::shared_ptr<CandidateFinder> finder, QObject* parent)
    : QObject(parent), finder_(std::move(finder)) {
    thread_.setMaxThreadCount(1);
    thread_.setExpiryTimeout(-1);
}

CandidatePreview::~CandidatePreview() {
    if (progress_) progress_->cancel();
    thread_.waitForDone();
}

void CandidatePreview::request(PreviewRequest request) {
    // A run under way is let finish, so that something shows even while the slider never rests.
    if (running_) {
        next_ = std::move(request);
        return;
    }
    start(std::move(request));
}

void CandidatePreview::drop() {
    next_.reset();
    ++wanted_;
    if (progress_) progress_->cancel();
}

void CandidatePreview::start(PreviewRequest request) {
    running_ = true;
    progress_ = std::make_shared<Progress>();
    const int number = ++wanted_;
    thread_.start(new Job([this, number, request = std::move(request), finder = finder_, progress = progress_] {
        std::shared_ptr<const CandidateSet> candidates;
        QString error;
        try {
            candidates = find(request, *finder, *progress);
        } catch (const Cancelled&) {
        } catch (const std::exception& failure) {
            error = sentenceOf(failure);
        }
        QMetaObject::invokeMethod(
            this,
            [this, number, candidates, settings = request.settings, error] {
                finish(number, candidates, settings, error);
            },
            Qt::QueuedConnection);
    }));
}

void CandidatePreview::finish(int number, std::shared_ptr<const CandidateSet> candidates,
                              const CandidateSettings& settings, const QString& error) {
    running_ = false;
    progress_.reset();
    const bool isWanted = number == wanted_;
    if (next_) {
        PreviewRequest following = std::move(*next_);
        next_.reset();
        start(std::move(following));
    }
    if (!isWanted) return;
    if (!error.isEmpty())
        emit failed(error);
    else if (candidates)
        emit ready(candidates, settings);
}

}  // namespace fodscope
