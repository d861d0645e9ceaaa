// What a JSON file next to a table states of its columns, as BIDS defines it.

#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/exports/columns/export_column.h"

namespace asperity {

/// Description, Units, Levels with their meanings, HED tags of levels that have any.
nlohmann::ordered_json sidecar_of(const ExportColumn& column);

/// As BIDS spells units: a product with a point, a power with a caret.
std::string bids_unit(const std::string& unit);

std::string indented_text(const nlohmann::ordered_json& json);

}  // namespace asperity
