// What has to hold of a gate's counts, each with its figures in the message.

#pragma once

#include <iostream>

#include <gtest/gtest.h>

#include "analysis/choices/matching_null.h"
#include "analysis/numbers/proportion.h"
#include "tests/gates/simulated_study.h"

namespace asperity {

inline constexpr double kGateConfidence = 0.999;
/// How far from chance a deaf observer's interval may reach.
inline constexpr double kGateMargin = 0.05;

inline std::string text_of(const ConfidenceInterval& interval) {
  return "[" + std::to_string(interval.low) + ", " + std::to_string(interval.high) + "]";
}

/// The exact interval of a share holds chance; with `margin`, it also lies within chance ± margin.
inline void expect_by_chance(const std::string& what, const HitCount& hits, double chance,
                             double margin) {
  const ConfidenceInterval interval = clopper_pearson_interval(hits, kGateConfidence);
  const std::string figures = what + ": " + std::to_string(hits.hits) + " of " +
                              std::to_string(hits.trials) + ", " + text_of(interval) + ", chance " +
                              std::to_string(chance);
  EXPECT_LE(interval.low, chance) << figures;
  EXPECT_GE(interval.high, chance) << figures;
  EXPECT_GE(interval.low, chance - margin) << figures;
  EXPECT_LE(interval.high, chance + margin) << figures;
  std::cout << figures << '\n';
}

/// The items of one assignment depend on each other: their count is held to random permutations.
/// The interval around the share is as wide as what those give around chance.
inline void expect_items_by_chance(const GateCounts& counts, std::size_t items, double margin) {
  const CountInterval by_chance =
      MatchingNull({items, counts.trials}).central_interval(kGateConfidence);
  const double of = static_cast<double>(counts.items);
  const double share = static_cast<double>(counts.right) / of;
  const double chance = item_chance(items);
  const ConfidenceInterval interval{share - (chance - static_cast<double>(by_chance.low) / of),
                                    share + (static_cast<double>(by_chance.high) / of - chance)};
  const std::string figures = "matched items: " + std::to_string(counts.right) + " of " +
                              std::to_string(counts.items) + ", " + text_of(interval) +
                              ", random permutations give " + std::to_string(by_chance.low) +
                              " to " + std::to_string(by_chance.high);
  EXPECT_GE(counts.right, by_chance.low) << figures;
  EXPECT_LE(counts.right, by_chance.high) << figures;
  EXPECT_GE(interval.low, chance - margin) << figures;
  EXPECT_LE(interval.high, chance + margin) << figures;
  std::cout << figures << '\n';
}

inline void expect_every_item_right(const std::string& what, const GateCounts& counts) {
  EXPECT_EQ(counts.right, counts.items) << what;
  EXPECT_EQ(counts.guess_sources, 0U) << "answers that were judged are not marked as guesses";
}

inline void expect_most_items_right(const std::string& what, const GateCounts& counts) {
  const double share = static_cast<double>(counts.right) / static_cast<double>(counts.items);
  const std::string figures = what + ": " + std::to_string(counts.right) + " of " +
                              std::to_string(counts.items) + " items right";
  EXPECT_GE(share, 0.9) << figures;
  EXPECT_EQ(counts.guess_sources, 0U) << "answers that were judged are not marked as guesses";
  std::cout << figures << '\n';
}

inline void expect_all_marked_as_guesses(const GateCounts& counts) {
  EXPECT_EQ(counts.guess_sources, counts.trials) << "trials with virtual_guess as the source";
}

/// No model is preferred: the share of each.
inline void expect_no_model_preferred(const GateCounts& counts, double margin) {
  ASSERT_EQ(counts.chosen.size(), 3U);
  for (const auto& [model, times] : counts.chosen) {
    expect_by_chance("selected " + model, {times, counts.trials}, 1.0 / 3.0, margin);
  }
}

/// Pearson's statistic of counts that should all be alike, in `cells` classes.
template <class Counts>
double chi_square_of_equal(const Counts& counts, std::size_t cells) {
  double total = 0.0;
  for (const auto& [which, times] : counts) total += static_cast<double>(times);
  const double expected = total / static_cast<double>(cells);
  double sum = static_cast<double>(cells - counts.size()) * expected;  // those that never came
  for (const auto& [which, times] : counts) {
    const double apart = static_cast<double>(times) - expected;
    sum += apart * apart / expected;
  }
  return sum;
}

}  // namespace asperity
