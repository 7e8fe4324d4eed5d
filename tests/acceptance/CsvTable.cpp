// SPDX-License-Identifier: MIT
#include "tests/acceptance/CsvTable.h"

#include <sstream>

#include "core/common/Files.h"

namespace fodscope {
namespace {

std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');)
        words.push_back(word);
    return words;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file, bool hasHeader) {
    std::istringstream lines(readTextFile(file));
    std::string line;
    std::vector<std::string> names;
    while (std::getline(lines, line)) {
        const std::vector<std::string> words = cells(line);
        if (names.empty() && hasHeader) {
            names = words;
            continue;
        }
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (i == names.size()) names.push_back(std::to_string(i));
            columns_[names[i]].push_back(std::stod(words[i]));
        }
    }
}

}  // namespace fodscope
