// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/simulation/BuiltinTank.h"
#include "core/simulation/MeshShapes.h"
#include "core/simulation/Random.h"

namespace fodscope {

/// The tank's measures that several parts share, and how far the yard was off.
class TankPlan {
  public:
    /// @param deviation_m 0 for the tank as drawn
    TankPlan(const BuiltinTankSettings& settings, double deviation_m)
        : length(settings.length_m),
          width(settings.width_m),
          height(settings.height_m),
          asBuilt(deviation_m > 0.0),
          deviation_(deviation_m),
          random_(streamSeed(settings.seed, 77)) {}

    const double length;
    const double width;
    const double height;
    const bool asBuilt;

    /// Where the curved side shell stands; a bilge rounds it into the floor.
    double shellY(double x, double z) const;
    double bilgeRadius() const { return 0.35 * height; }
    /// Heights that follow the shell's curvature closely enough to draw it.
    std::vector<double> shellHeights() const;

    /// How far a part stands from where it was drawn: half to all of the deviation, in the plane of the floor.
    Eigen::Vector3d misplacement();
    /// The same along one axis.
    double slip();

  private:
    double deviation_;
    Random random_;
};

/// Floor, curved shell, bulkheads and the deck with the access hole and its coaming.
TriangleMesh tankHull(const TankPlan& plan);
/// The access hole: an ellipse in the deck.
Eigen::Vector2d accessHoleCentre(const TankPlan& plan);
Eigen::Vector2d accessHoleRadii(const TankPlan& plan);

/// Web frames, deck beams, floor strips, bulkhead and shell stiffeners.
TriangleMesh tankFraming(TankPlan& plan);
/// I-beam, column, pipes with their brackets and valve, suction, ladder.
TriangleMesh tankFittings(TankPlan& plan);
/// What the drawing does not have: a hose, a cable and a junction box.
TriangleMesh tankAdditions(const TankPlan& plan);

}  // namespace fodscope
