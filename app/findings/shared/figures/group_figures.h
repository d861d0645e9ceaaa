// Makes the figures of two groups and their difference.

#pragma once

#include <string>
#include <vector>

#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/words/phrase.h"

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

}  // namespace asperity
