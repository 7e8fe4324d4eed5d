// SPDX-License-Identifier: MIT
#pragma once

#include <QtGlobal>
#include <memory>

QT_BEGIN_NAMESPACE
class QGuiApplication;
QT_END_NAMESPACE

namespace fodscope {

/// What Qt needs to lay out text and paint images in a program without a window: uses the QGuiApplication that runs, or
/// starts one on the offscreen platform for as long as this object lives.
class ReportApplication {
  public:
    /// @throws Error when a Qt application without graphics already runs
    ReportApplication();
    ~ReportApplication();
    ReportApplication(const ReportApplication&) = delete;
    ReportApplication& operator=(const ReportApplication&) = delete;

  private:
    std::unique_ptr<QGuiApplication> application_;
};

}  // namespace fodscope
