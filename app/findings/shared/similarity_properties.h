// Physical properties of rated items, as far as a study measures them.

#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// The second table of the family "similarity", with the columns item, property and value: how an item was explored, its
/// texture force, and its level where all items are numbers. A property that was measured for some items only has no row for
/// the others.
TidyTable properties_of_items(const GatheredAnswers& gathered,
                              const std::vector<std::string>& items);

/// One of these properties, by item; an item for which it was not measured is absent.
std::map<std::string, double> property_of_items(const GatheredAnswers& gathered,
                                                const std::vector<std::string>& items,
                                                const std::string& property);

}  // namespace asperity
