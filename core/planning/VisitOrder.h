// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/common/Progress.h"
#include "core/planning/CostMap.h"

namespace fodscope {

/// The drives between places, the first being the robot's. A drive is as long one way as the other.
class VisitLegs {
  public:
    /// @param places_map the robot's place, then those to visit
    /// @throws Cancelled
    VisitLegs(const CostMap& collision, std::span<const Eigen::Vector2d> places_map, Progress& progress);

    /// @return the drive between two places; infinitely long and without points where none leads there
    DrivePath drive(std::size_t from, std::size_t to) const;

    /// Symmetric, metres; infinite where no drive leads.
    const Eigen::MatrixXd& lengths_m() const { return lengths_m_; }

  private:
    Eigen::MatrixXd lengths_m_;
    /// From the lower to the higher index, row by row.
    std::vector<DrivePath> drives_;
};

/// Orders of all places but the first, from which they start. There is no way back in them.

/// The paper's: each time the nearest that is left; of equally near ones the first.
std::vector<std::size_t> nearestNextOrder(const Eigen::MatrixXd& lengths_m);

/// The shortest tour: exact up to 12 places, else the nearest-next one and one by cheapest insertion, each shortened
/// by turning stretches round and moving up to three visits elsewhere until neither helps. Never longer than
/// nearest-next, and the same each time.
std::vector<std::size_t> shortestOrder(const Eigen::MatrixXd& lengths_m);

double lengthOf(std::span<const std::size_t> order, const Eigen::MatrixXd& lengths_m);

}  // namespace fodscope
