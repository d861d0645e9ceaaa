// Reads which of two groups each row of a table belongs to.

#pragma once

#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// The column `group` of the first table, with the two names of the option `groups` as its names. Errors: std::runtime_error where
/// the option does not name two groups; ResultsError for a row without a group, or with another one.
LabelColumn two_groups(const TidyInput& input);

}  // namespace asperity
