// Implements the reading of two groups.

#include "app/findings/tidy/two_groups.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

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

}  // namespace asperity
