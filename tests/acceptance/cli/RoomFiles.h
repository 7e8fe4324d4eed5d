// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/acceptance/cli/Program.h"

namespace fodscope::test {

/// Files of a synthetic room that the commands are run on: three nominal maps, a reference made of them by the program
/// itself, the room's points as a reference without covariances, and a map with a box on the floor.
class RoomFiles {
  public:
    RoomFiles();

    std::string reference() const { return (folder_ / "reference.ply").string(); }
    std::string bareReference() const { return (folder_ / "bare.ply").string(); }
    std::string map() const { return (folder_ / "map.pcd").string(); }
    std::vector<std::string> nominalMaps() const;
    std::string file(const std::string& name) const { return (folder_ / name).string(); }

  private:
    TestFolder folder_;
};

/// Made once for all tests of the program.
const RoomFiles& roomFiles();

}  // namespace fodscope::test
