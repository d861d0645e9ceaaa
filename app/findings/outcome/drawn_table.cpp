// Chooses the prefix of metres and pascals by the greatest number, and finds tables by their names.

#include "app/findings/outcome/drawn_table.h"

#include <algorithm>
#include <cctype>

namespace asperity {

DrawnUnit drawn_unit(const std::string& unit, double greatest) {
  if (unit == "Pa" && greatest >= 1e3) {
    return greatest < 1e6 ? DrawnUnit{"kPa", 1e3} : DrawnUnit{"MPa", 1e6};
  }
  if (unit != "m") return {unit, 1.0};
  if (greatest < 1e-3) return {"µm", 1e-6};
  return greatest < 1.0 ? DrawnUnit{"mm", 1e-3} : DrawnUnit{unit, 1.0};
}

const ResultTable* table_named(const AnalysisOutcome& outcome, const char* name) {
  const auto found = std::find_if(outcome.tables.begin(), outcome.tables.end(),
                                  [name](const ResultTable& each) { return each.name == name; });
  return found == outcome.tables.end() ? nullptr : &*found;
}

std::string figure_file_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return text;
}

}  // namespace asperity
