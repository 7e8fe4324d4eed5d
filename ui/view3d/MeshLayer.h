// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "ui/theme/Theme.h"
#include "ui/view3d/OrbitCamera.h"

class vtkRenderer;

namespace fodscope {

/// A mesh as a shaded skin with its sharp edges as lines, so that its form is seen even when it is nearly transparent.
class MeshLayer {
  public:
    explicit MeshLayer(vtkRenderer* renderer);
    ~MeshLayer();
    MeshLayer(const MeshLayer&) = delete;
    MeshLayer& operator=(const MeshLayer&) = delete;

    void setMesh(std::span<const Eigen::Vector3d> vertices, std::span<const std::array<std::uint32_t, 3>> triangles);
    void setTheme(const Theme& theme);
    void setVisible(bool visible);
    void setOpacity(double opacity);
    void setPeelHeight(std::optional<double> height_m);

    bool empty() const { return bounds_.empty(); }
    const Bounds& bounds() const { return bounds_; }

  private:
    class Actors;
    std::unique_ptr<Actors> actors_;
    Bounds bounds_;
};

}  // namespace fodscope
