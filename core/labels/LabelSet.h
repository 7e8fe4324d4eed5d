// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fodscope {

inline constexpr const char* kNoFod = "no FOD";
inline constexpr const char* kNotSure = "not sure";

enum class LabelKind { Fod, NoFod, NotSure };

/// A class that a labeller can give to what a photo shows.
struct Label {
    std::string name;
    /// The key that gives it: one character, '1'…'9', '0' for no FOD and 'U' for not sure.
    char key = 0;
    LabelKind kind = LabelKind::Fod;

    bool operator==(const Label&) const = default;
};

/// Labels in the order of their keys; `no FOD` and `not sure` are always the last two.
struct LabelSet {
    std::string name;
    std::vector<Label> labels;

    const Label* find(const std::string& labelName) const;
    bool operator==(const LabelSet&) const = default;
};

/// Finds the label for an object type of a world or a trial: case does not count, and `_` and `-` are as good as a
/// blank, so that "tape_measure" finds "tape measure".
/// @return null when the set has no such label
const Label* findByType(const LabelSet& labels, std::string_view type);

/// @return FOD for a name that the set does not know: it was decided with another set, which named it
LabelKind kindOf(const LabelSet& labels, const std::string& labelName);

/// Reads YAML: `name`, `labels: [{name, key}]`; adds `no FOD` (0) and `not sure` (U). Keys are 1…9 and letters; a label
/// without one gets the lowest digit that is free.
/// @throws Error for a missing file, no labels, a name or key that is taken
LabelSet readLabelSet(const std::filesystem::path& file);
LabelSet parseLabelSet(const std::string& yaml, const std::string& subject);

}  // namespace fodscope
