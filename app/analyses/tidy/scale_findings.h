// A scale of items as findings.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "analysis/bradley_terry.h"
#include "analysis/friedman.h"
#include "app/analyses/tidy/finding_list.h"

namespace asperity {

/// How a scale is called and what it rests on.
struct ScaleNames {
  std::string value{};
  std::string error{};
  std::string method{};
  std::size_t n = 0;
  double confidence = 0.95;
};

/// The place of each item, with Wald's interval, and its standard error.
void add_scale(std::span<const std::string> items, const Abilities& scale, const ScaleNames& names,
               FindingList& findings);

/// How many rows were judged, with the sentences for none and for a single one, and the interval of W.
struct FriedmanRows {
  std::size_t n = 0;
  std::string none{};
  std::string one{};
  std::optional<ConfidenceInterval> concordance{};
  double confidence = 0.95;
};
/// Friedman's test with Kendall's W and the F of Iman and Davenport; of fewer than two rows the word
/// for why there are none.
void add_friedman(const FriedmanTest& test, const FriedmanRows& rows, FindingList& findings);

}  // namespace asperity
