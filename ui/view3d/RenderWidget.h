// SPDX-License-Identifier: MIT
#pragma once

#include <QColor>
#include <memory>

#include "ui/view3d/OrbitCamera.h"

class QWidget;
class vtkRenderer;

namespace fodscope {

/// The OpenGL surface with one renderer. Mouse and keys are not its business.
class RenderWidget {
  public:
    explicit RenderWidget(QWidget* parent);
    ~RenderWidget();
    RenderWidget(const RenderWidget&) = delete;
    RenderWidget& operator=(const RenderWidget&) = delete;

    /// Owned by the parent given to the constructor.
    QWidget* widget() const;
    vtkRenderer* renderer() const;
    /// Drawn over the other, so that no wall and no cloud hides it: candidates, waypoints, robot.
    vtkRenderer* topRenderer() const;
    void setBackground(const QColor& colour);
    void render(const OrbitCamera& camera);

  private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace fodscope
