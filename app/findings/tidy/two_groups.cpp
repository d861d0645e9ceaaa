// Implements the reading of two groups.

#include "app/findings/tidy/two_groups.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/findings/tidy/finding_list.h"

namespace asperity {

LabelColumn two_groups(const TidyInput& input) {
  const std::vector<std::string> names = input.options.texts("groups");
  if (names.size() != 2) {
    throw std::runtime_error("the option \"groups\" must name two groups, not " +
                             std::to_string(names.size()) + "; name the two groups to compare");
  }
  const TidyTable& table = input.table();
  LabelColumn groups = table.labels("group", names);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (groups.codes[row] == LabelColumn::kMissing) {
      table.refuse(row, "group", "the group is missing; enter " + names[0] + " or " + names[1]);
    }
  }
  return groups;
}

std::vector<std::size_t> blocks_in(const TidyTable& table) {
  return table.has("block") ? table.labels("block").codes : std::vector<std::size_t>{};
}

std::vector<std::size_t> joined(std::vector<std::size_t> first,
                                const std::vector<std::size_t>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::string way_of_splits(const SplitTest& splits, const std::vector<std::size_t>& blocks) {
  return (blocks.empty() ? "" : "exchanged within the blocks of the assignment, ") +
         way_of_counting(splits.exact ? 0 : kRandomSplits);
}

}  // namespace asperity
