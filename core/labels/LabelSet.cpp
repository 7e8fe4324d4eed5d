// SPDX-License-Identifier: MIT
#include "core/labels/LabelSet.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>

#include "core/common/Error.h"
#include "core/common/Files.h"

namespace fodscope {
namespace {

constexpr char kNoFodKey = '0';
constexpr char kNotSureKey = 'U';
constexpr const char* kRemedy = "give `name` and `labels: [{name: hammer, key: 1}, ...]`";

std::string normalised(std::string_view text) {
    std::string result;
    for (const char c : text) {
        result += c == '_' || c == '-' ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

const Label* findByKey(const LabelSet& set, char key) {
    const auto found = std::ranges::find(set.labels, key, &Label::key);
    return found == set.labels.end() ? nullptr : &*found;
}

char readKey(const std::string& text, const std::string& labelName, const std::string& subject) {
    const char key = text.size() == 1 ? static_cast<char>(std::toupper(static_cast<unsigned char>(text[0]))) : '\0';
    if (key == kNoFodKey || key == kNotSureKey) {
        throw Error(subject, "the key " + text + " of the label \"" + labelName + "\" is taken",
                    "choose another: 0 is always `no FOD`, U always `not sure`");
    }
    const bool valid = (key >= '1' && key <= '9') || (key >= 'A' && key <= 'Z');
    if (!valid) {
        throw Error(subject, "the key \"" + text + "\" of the label \"" + labelName + "\" is no key",
                    "give one digit 1 to 9 or one letter");
    }
    return key;
}

std::string scalar(const YAML::Node& node) {
    return node && node.IsScalar() ? trimmed(node.Scalar()) : std::string();
}

Label readLabel(const YAML::Node& node, const std::string& subject) {
    Label label;
    label.name = node.IsScalar() ? scalar(node) : node.IsMap() ? scalar(node["name"]) : std::string();
    if (label.name.empty()) throw Error(subject, "a label has no name", kRemedy);
    if (node.IsMap()) {
        for (const auto& entry : node) {
            const std::string key = scalar(entry.first);
            if (key != "name" && key != "key") {
                throw Error(subject, "the label \"" + label.name + "\" has the unknown entry \"" + key + "\"", kRemedy);
            }
        }
        if (node["key"]) label.key = readKey(scalar(node["key"]), label.name, subject);
    }
    return label;
}

void add(LabelSet& set, const Label& label, const std::string& subject) {
    const std::string name = normalised(label.name);
    if (name == normalised(kNoFod) || name == normalised(kNotSure)) {
        throw Error(subject, "the name \"" + label.name + "\" is taken", "leave it out: it is always there");
    }
    if (findByType(set, label.name) != nullptr) {
        throw Error(subject, "the label \"" + label.name + "\" is there twice", "give each label once");
    }
    if (label.key != 0 && findByKey(set, label.key) != nullptr) {
        throw Error(subject, std::string("the key ") + label.key + " is given twice", "give each label its own key");
    }
    set.labels.push_back(label);
}

void giveMissingKeys(LabelSet& set, const std::string& subject) {
    for (Label& label : set.labels) {
        if (label.key != 0) continue;
        for (char key = '1'; key <= '9' && label.key == 0; ++key) {
            if (findByKey(set, key) == nullptr) label.key = key;
        }
        if (label.key == 0) {
            throw Error(subject, "no digit is left for the label \"" + label.name + "\"", "give it a letter as key");
        }
    }
}

}  // namespace

const Label* LabelSet::find(const std::string& labelName) const {
    const auto found = std::ranges::find(labels, labelName, &Label::name);
    return found == labels.end() ? nullptr : &*found;
}

const Label* findByType(const LabelSet& labels, std::string_view type) {
    const std::string wanted = normalised(type);
    const auto found =
        std::ranges::find_if(labels.labels, [&](const Label& l) { return normalised(l.name) == wanted; });
    return found == labels.labels.end() ? nullptr : &*found;
}

LabelKind kindOf(const LabelSet& labels, const std::string& labelName) {
    if (const Label* label = labels.find(labelName)) return label->kind;
    if (labelName == kNoFod) return LabelKind::NoFod;
    return labelName == kNotSure ? LabelKind::NotSure : LabelKind::Fod;
}

LabelSet parseLabelSet(const std::string& yaml, const std::string& subject) {
    YAML::Node root;
    try {
        root = YAML::Load(yaml);
    } catch (const YAML::Exception& exception) {
        throw Error(subject,
                    "line " + std::to_string(exception.mark.line + 1) + " is not valid YAML (" + exception.msg + ")",
                    kRemedy);
    }
    if (!root.IsMap() || !root["labels"] || !root["labels"].IsSequence() || root["labels"].size() == 0) {
        throw Error(subject, "has no labels", kRemedy);
    }
    LabelSet set;
    set.name = scalar(root["name"]);
    if (set.name.empty()) throw Error(subject, "the label set has no name", kRemedy);
    for (const YAML::Node& node : root["labels"]) {
        add(set, readLabel(node, subject), subject);
    }
    giveMissingKeys(set, subject);
    set.labels.push_back({kNoFod, kNoFodKey, LabelKind::NoFod});
    set.labels.push_back({kNotSure, kNotSureKey, LabelKind::NotSure});
    return set;
}

LabelSet readLabelSet(const std::filesystem::path& file) {
    return parseLabelSet(readTextFile(file), file.string());
}

}  // namespace fodscope
