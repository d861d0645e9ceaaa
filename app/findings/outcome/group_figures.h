// Makes the figures of two groups and their difference, and those of the comparisons in the table of tests.

#pragma once

#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// The means of two groups and their difference, a figure each. `axis`: contains a placeholder for
/// the confidence, in percent.
struct GroupChoice {
  QuantityName means{};
  QuantityName difference{};
  QuantityName pooled_difference{};  ///< empty: none
  Phrase axis{};
  bool are_shares = false;  ///< from 0 to 1
  std::string unit{};       ///< of the axis; empty for pure numbers
};
std::vector<Figure> group_figures(const GroupChoice& choice, const FoundNumbers& found);

/// The choice for the family `group`.
GroupChoice shares_of_groups();

/// Women and men, and the groups to which the protocol assigns participants, pair by pair, where they were compared. `tests`:
/// the table of the tests.
std::vector<Figure> figures_of_comparisons(const ResultTable& tests,
                                           const AnalysisOutcome& outcome);

}  // namespace asperity
