// SPDX-License-Identifier: MIT
#pragma once

#include <QByteArray>
#include <array>
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
    // A QGuiApplication keeps references to its arguments for as long as it lives.
    std::array<QByteArray, 3> words_{"fodscope", "-platform", "offscreen"};
    std::array<char*, 4> arguments_{};
    int argumentCount_ = 3;
    std::unique_ptr<QGuiApplication> application_;
};

}  // namespace fodscope
