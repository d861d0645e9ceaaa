// Makes columns of tidy tables from what varies between trials or surfaces: factors with their levels in order.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// A factor with the level of each row, none where it has no level.
struct TrialFactor {
  std::string name{};
  LabelColumn levels{};
};

/// `by_row`: the level of each row, an empty text where it has none. Levels are in the order of `declared`; then
/// numbers in ascending order, then names.
TrialFactor trial_factor(const std::string& name, const std::vector<std::string>& by_row,
                         const std::vector<std::string>& declared = {});

/// Puts levels into this order.
void sort_levels(std::vector<std::string>& levels, const std::vector<std::string>& declared = {});

}  // namespace asperity
