// Sorts levels as declared, then numbers by value, then words, and codes every row in this order.

#include "app/findings/gathering/trial_factors.h"

#include <algorithm>
#include <unordered_map>

#include "results_schema/tables/table.h"

namespace asperity {

void sort_levels(std::vector<std::string>& levels, const std::vector<std::string>& declared) {
  std::sort(levels.begin(), levels.end(), [&declared](const std::string& a, const std::string& b) {
    const auto place = [&declared](const std::string& level) {
      return std::find(declared.begin(), declared.end(), level);
    };
    if (place(a) != place(b)) return place(a) < place(b);
    const auto first = number_in(a);
    const auto second = number_in(b);
    if (first.has_value() != second.has_value()) return first.has_value();
    return first && second && *first != *second ? *first < *second : a < b;
  });
}

TrialFactor trial_factor(const std::string& name, const std::vector<std::string>& by_row,
                         const std::vector<std::string>& declared) {
  std::unordered_map<std::string, std::size_t> code_of{};
  TrialFactor factor{.name = name};
  for (const std::string& level : by_row) {
    if (!level.empty() && code_of.emplace(level, 0).second) factor.levels.names.push_back(level);
  }
  sort_levels(factor.levels.names, declared);
  for (std::size_t code = 0; code < factor.levels.names.size(); ++code) {
    code_of[factor.levels.names[code]] = code;
  }
  factor.levels.codes.reserve(by_row.size());
  for (const std::string& level : by_row) {
    factor.levels.codes.push_back(level.empty() ? LabelColumn::kMissing : code_of.at(level));
  }
  return factor;
}

}  // namespace asperity
