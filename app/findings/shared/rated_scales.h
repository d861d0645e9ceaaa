// Collects the ratings of a study by scale.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/numbers/finding.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// The ratings on one scale: means of each participant for each item.
struct RatedScale {
  std::string name{};
  /// By name. Where all surfaces count as one item, the levels of the factors that determine them, by value.
  std::vector<std::string> items{};
  std::map<std::pair<std::uint32_t, std::string>, double> means{};  ///< by participant and item
  std::optional<double> points{};  ///< nothing for a line without points
  double minimum = 0.0;
  double maximum = 0.0;
  std::string low_label{};   ///< of the minimum; empty: none
  std::string high_label{};  ///< of the maximum
  struct Response {
    std::uint32_t person = 0;
    std::string item{};
    int repetition = 1;
    double score = 0.0;
  };
  std::vector<Response> responses{};  ///< all of them, not averaged

  /// The largest number of points that are analysed as ordered categories; more are a continuous scale.
  static constexpr double kMostCategories = 11.0;
  bool has_categories() const noexcept { return points && *points <= kMostCategories; }
};

/// In the order of the protocol. A scale that accompanies another question is about the trial, not an attribute of its
/// item: it is absent, unless the family names a test of ratings that can only be one of accompanying scales.
std::vector<RatedScale> rated_scales(const GatheredAnswers& gathered);

/// The findings of a family with keys that begin with the name of the scale.
std::vector<Finding> findings_of(const char* analysis, const char* family, const RatedScale& scale,
                                 TidyInput input);

}  // namespace asperity
