// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "ui/view3d/Shapes.h"

class vtkRenderer;

namespace fodscope {

/// Draws Shapes: unlit, each line and triangle in its own colour.
class ShapeLayer {
  public:
    ShapeLayer(vtkRenderer* renderer, double lineWidth_px);
    ~ShapeLayer();
    ShapeLayer(const ShapeLayer&) = delete;
    ShapeLayer& operator=(const ShapeLayer&) = delete;

    void setShapes(const Shapes& shapes);
    void setVisible(bool visible);
    void setOpacity(double opacity);

    bool empty() const { return bounds_.empty(); }
    const Bounds& bounds() const { return bounds_; }

  private:
    class Actors;
    std::unique_ptr<Actors> actors_;
    Bounds bounds_;
};

}  // namespace fodscope
