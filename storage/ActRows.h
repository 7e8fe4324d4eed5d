// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace fodscope {

/// What a column holds: null, a whole number, a number or text.
using CellValue = std::variant<std::monostate, std::int64_t, double, std::string>;

/// One row of one of the tables that repeat what the acts say.
struct ActRow {
    std::string table;
    std::vector<std::pair<std::string, CellValue>> columns;
};

/// The tables that repeat what the acts say.
const std::vector<std::string>& actRowTables();

/// The rows that follow from an act. Writing and checking a session use the same function, so that rows and acts can
/// only differ when somebody altered one of them.
std::vector<ActRow> rowsOf(std::int64_t sequence, const std::string& kind, const nlohmann::ordered_json& payload);

}  // namespace fodscope
