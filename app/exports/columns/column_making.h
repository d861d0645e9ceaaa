// Functions that build the columns of exported tables, and the cells in them.

#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/exports/columns/export_column.h"

namespace asperity::export_columns {

using Columns = std::vector<ExportColumn>;

Cell boolean(bool value);
Cell optional_boolean(const std::optional<bool>& value);
Cell integer(std::int64_t value);
template <class Value>
Cell optional_cell(const std::optional<Value>& value) {
  return value ? Cell{*value} : Cell{};
}
/// Seconds on the clock of the session, whose zero is at started_utc.
Cell seconds_in_session(const ExportPlace& at, std::int64_t time_ns);
Cell seconds_in_session(const ExportPlace& at, const std::optional<std::int64_t>& time_ns);
/// The member with this name, missing if the object has none.
Cell member_of(const nlohmann::json* object, const std::string& name);

ExportColumn column(std::string name, std::string type, std::string unit, std::string description,
                    std::function<Cell(const ExportPlace&)> cell);
ExportColumn with_levels(ExportColumn made, std::vector<std::string> levels);
ExportColumn at_least(double minimum, ExportColumn made);
ExportColumn fraction(ExportColumn made);
ExportColumn missing(std::string when, ExportColumn made);
ExportColumn dropped(ExportColumn made);
/// Of what indicates when, or in which order, the sessions were run, and of what contains the label.
ExportColumn dropped_with_new_labels(ExportColumn made);

enum class Key { participant, session, trial, attempt };

/// The keys down to `last`, then the columns that every table has: `virtual` and `mode`.
Columns keys_to(Key last);

}  // namespace asperity::export_columns
