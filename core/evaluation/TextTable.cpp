// SPDX-License-Identifier: MIT
#include "core/evaluation/TextTable.h"

#include <algorithm>
#include <sstream>

namespace fodscope {
namespace {

/// Characters that take a column: UTF-8's continuation bytes do not.
std::size_t widthOf(const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool toTheLeft) {
    const std::string blanks(width - std::min(width, widthOf(text)), ' ');
    return toTheLeft ? text + blanks : blanks + text;
}

}  // namespace

std::string textTable(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()), 0);
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], widthOf(row[i]));
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i)
            line += "  " + padded(row[i], widths[i], i == 0);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string wrapped(const std::string& text, std::size_t width) {
    std::istringstream words(text);
    std::string result, line, word;
    while (words >> word) {
        if (!line.empty() && widthOf(line) + 1 + widthOf(word) > width) {
            result += line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return result + line + (line.empty() ? "" : "\n");
}

}  // namespace fodscope
