// Reads which of two groups each row of a table belongs to.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/tests/label_permutations.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// The column `group` of the first table, with the two names of the option `groups` as its names. Errors: std::runtime_error where
/// the option does not name two groups; ResultsError for a row without a group, or with another one.
LabelColumn two_groups(const TidyInput& input);

/// Of each row, its block: the value of the column `block`, in which the program assigned the groups, so that labels are exchanged
/// within it. Rows without a value are one block. Empty without the column.
std::vector<std::size_t> blocks_in(const TidyTable& table);

/// The blocks of the participants of both groups.
std::vector<std::size_t> joined(std::vector<std::size_t> first,
                                const std::vector<std::size_t>& second);

/// As `way_of_counting`, and whether labels were exchanged within blocks.
std::string way_of_splits(const SplitTest& splits, const std::vector<std::size_t>& blocks);

}  // namespace asperity
