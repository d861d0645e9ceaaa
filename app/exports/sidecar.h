// Makes the JSON file that describes the columns of a table, as defined by BIDS.

#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/exports/columns/export_column.h"

namespace asperity {

/// Description, Units, Levels with their meanings, and HED tags of levels that have any.
nlohmann::ordered_json sidecar_of(const ExportColumn& column);

/// In BIDS notation: a product with a point, a power with a caret.
std::string bids_unit(const std::string& unit);

std::string indented_text(const nlohmann::ordered_json& json);

}  // namespace asperity
