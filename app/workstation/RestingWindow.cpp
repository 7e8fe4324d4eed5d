// SPDX-License-Identifier: MIT
#include "app/workstation/RestingWindow.h"

#include <QApplication>
#include <QEvent>
#include <QWidget>
#include <utility>

namespace fodscope {
namespace {

constexpr int kLookEvery_ms = 30;
constexpr qint64 kRest_ms = 180;
constexpr qint64 kLongEnough_ms = 2500;

}  // namespace

RestingWindow::RestingWindow(QWidget& window) : QObject(&window), window_(window) {
    qApp->installEventFilter(this);
    timer_.setInterval(kLookEvery_ms);
    connect(&timer_, &QTimer::timeout, this, &RestingWindow::look);
}

void RestingWindow::then(std::function<void()> action) {
    action_ = std::move(action);
    sinceAsked_.start();
    sincePainted_.start();
    timer_.start();
}

bool RestingWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Paint && timer_.isActive()) {
        const auto* widget = qobject_cast<QWidget*>(watched);
        if (widget != nullptr && widget->window() == &window_) sincePainted_.start();
    }
    return false;
}

void RestingWindow::look() {
    if (sincePainted_.elapsed() < kRest_ms && sinceAsked_.elapsed() < kLongEnough_ms) return;
    timer_.stop();
    std::exchange(action_, nullptr)();
}

}  // namespace fodscope
