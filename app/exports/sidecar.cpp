// Spells units as BIDS does, and adds the meanings and HED tags of levels.

#include "app/exports/sidecar.h"

#include <cctype>
#include <utility>

#include <nlohmann/json.hpp>

namespace asperity {

using Json = nlohmann::ordered_json;

std::string bids_unit(const std::string& unit) {
  std::string spelt{};
  for (const char letter : unit) {
    const bool is_power = std::isdigit(static_cast<unsigned char>(letter)) != 0 && !spelt.empty() &&
                          std::isalpha(static_cast<unsigned char>(spelt.back())) != 0;
    if (is_power) spelt += '^';
    spelt += letter == ' ' ? '.' : letter;
  }
  return spelt;
}

Json sidecar_of(const ExportColumn& column) {
  Json json{};
  json["Description"] = column.description;
  if (!column.unit.empty() && column.unit != "1") json["Units"] = bids_unit(column.unit);
  Json levels = Json::object();
  Json hed = Json::object();
  for (const std::string& level : column.levels) {
    const auto meaning = column.level_meanings.find(level);
    const bool is_known = meaning != column.level_meanings.end();
    levels[level] =
        is_known && !meaning->second.description.empty() ? meaning->second.description : level;
    if (is_known && !meaning->second.hed.empty()) hed[level] = meaning->second.hed;
  }
  if (column.type == "boolean") {
    json["Levels"] = Json{{"0", "no"}, {"1", "yes"}};
  } else if (!levels.empty() && (column.type == "text" || !hed.empty())) {
    json["Levels"] = std::move(levels);
  }
  if (!column.hed.empty()) {
    json["HED"] = column.hed;
  } else if (!hed.empty()) {
    json["HED"] = std::move(hed);
  }
  if (column.minimum) json["Minimum"] = *column.minimum;
  if (column.maximum) json["Maximum"] = *column.maximum;
  if (column.missing != "never") json["MissingWhen"] = column.missing;
  return json;
}

std::string indented_text(const Json& json) { return json.dump(2) + "\n"; }

}  // namespace asperity
