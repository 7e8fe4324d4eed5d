// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fodscope {

/// Numbers by column. A table without a header line has the columns "0", "1", ….
class CsvTable {
  public:
    CsvTable(const std::filesystem::path& file, bool hasHeader);

    std::size_t rows() const { return columns_.begin()->second.size(); }
    /// @throws std::out_of_range when there is no such column
    const std::vector<double>& operator[](const std::string& column) const { return columns_.at(column); }

  private:
    std::map<std::string, std::vector<double>> columns_;
};

}  // namespace fodscope
