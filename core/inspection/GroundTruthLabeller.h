// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/labels/Decision.h"
#include "core/labels/LabelSet.h"
#include "core/robot/Photo.h"
#include "core/simulation/PhotoCamera.h"
#include "core/simulation/Raycaster.h"
#include "core/simulation/World.h"

namespace fodscope {

/// What a labeller says about one photo.
struct PhotoAnswer {
    std::vector<PhotoLabel> labels;
    std::string comment;
};

/// A FOD that a photo shows.
struct VisibleFod {
    /// Index into the world's objects.
    std::size_t object = 0;
    VisibleObject seen;
};

/// Labels photos of a simulated world from what lies in it: every FOD that covers enough pixels, with a box round it,
/// else `no FOD`. It stands in for people in demonstrations and tests, and is called what it is wherever its decisions
/// show.
class GroundTruthLabeller {
  public:
    /// FOD that covers fewer pixels does not count as seen.
    static constexpr std::size_t kLeastPixels = 200;

    /// @param builtin whether the world is the built-in tank, for the labeller's name
    GroundTruthLabeller(std::shared_ptr<const World> world, bool builtin);

    /// "built-in world's ground truth" or "world's ground truth"
    static std::string nameFor(bool builtin);
    const std::string& name() const { return name_; }

    /// @return the FOD that the photo's camera sees from where it stood, in the world's order
    std::vector<VisibleFod> fodOn(const Photo& photo) const;

    /// FOD of a type that the set has no label for is labelled `other FOD`, or `not sure` where the set lacks that too,
    /// and the comment names the type.
    PhotoAnswer answer(const Photo& photo, const LabelSet& labels) const;

  private:
    std::shared_ptr<const World> world_;
    Raycaster raycaster_;
    std::string name_;
};

}  // namespace fodscope
