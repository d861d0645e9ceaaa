// Assignments of pictures to surfaces, of all participants and of two groups.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

// --- matching: four pictures to four surfaces ------------------------------------------------------

constexpr std::array<std::string_view, 4> kMatched{"a", "b", "c", "d"};
constexpr std::size_t kItems = kMatched.size();
constexpr std::array kThetas{0.0, 0.4, 0.8, 1.6, 3.0};
constexpr std::array kThetaSpreads{0.0, 0.5};
/// Of the 24 permutations those with 0, 1, … right items.
constexpr std::array<double, kItems + 1> kPermutations{9.0, 8.0, 6.0, 0.0, 1.0};

using Permutation = std::array<std::size_t, kItems>;

/// With `right` items in their places, all such permutations equally likely.
Permutation permutation_with(std::size_t right, Random& random) {
  Permutation drawn{};
  do {  // 1 in 24 has all items right, and is at hand without drawing
    std::iota(drawn.begin(), drawn.end(), std::size_t{0});
    if (right == kItems) return drawn;
    random.shuffle(std::span<std::size_t>(drawn));
  } while ([&] {
    std::size_t places = 0;
    for (std::size_t i = 0; i < kItems; ++i) places += drawn[i] == i ? 1 : 0;
    return places != right;
  }());
  return drawn;
}

std::array<double, kItems + 1> mallows_weights(double theta) {
  std::array<double, kItems + 1> weights = kPermutations;
  for (std::size_t k = 0; k <= kItems; ++k) weights[k] *= std::exp(theta * static_cast<double>(k));
  return weights;
}

/// The mean over participants of what `of_weights` makes of their probabilities of 0, 1, … right items.
template <class OfWeights>
double mean_over_thetas(const CoverageSetting& setting, OfWeights of_weights) {
  constexpr int kSteps = 160;
  constexpr double kFurthest = 8.0;
  double sum = 0.0;
  double all = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double z = kFurthest * (2.0 * i / kSteps - 1.0);
    const double weight = std::exp(-0.5 * z * z);
    std::array<double, kItems + 1> own = mallows_weights(setting.effect + setting.spread * z);
    const double total = std::accumulate(own.begin(), own.end(), 0.0);
    for (double& one : own) one /= total;
    sum += weight * of_weights(own);
    all += weight;
  }
  return sum / all;
}

void add_assignment(const std::string& subject, std::size_t trial, const Permutation& chosen,
                    DrawnTable& table) {
  const std::string number = std::to_string(trial + 1);
  for (std::size_t i = 0; i < kItems; ++i) {
    table.add({subject, number, kMatched[i], kMatched[chosen[i]]});
  }
}

TidyInput draw_matching(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,trial,stimulus,response");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const auto weights = mallows_weights(setting.effect + setting.spread * random.normal());
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      add_assignment(participant_label(i), trial,
                     permutation_with(drawn_by_weight(weights, random), random), table);
    }
  }
  return std::move(table).as_input();
}

std::vector<CheckedInterval> matching_intervals(const CoverageSetting& setting) {
  std::vector<CheckedInterval> intervals{
      {.quantity = "subj.mean",
       .truth = mean_over_thetas(setting,
                                 [](const auto& own) {
                                   double right = 0.0;
                                   for (std::size_t k = 0; k <= kItems; ++k) {
                                     right += own[k] * static_cast<double>(k);
                                   }
                                   return right / static_cast<double>(kItems);
                                 })},
      {.quantity = "perfect",
       .truth = mean_over_thetas(setting, [](const auto& own) { return own[kItems]; }),
       .lower = "perfect.wilson.lower",
       .upper = "perfect.wilson.upper"}};
  intervals.push_back({.quantity = "perfect.subj.mean", .truth = intervals.back().truth});
  if (setting.spread == 0.0) {
    intervals.push_back({.quantity = "mallows.theta",
                         .truth = setting.effect,
                         .lower = "mallows.ci.lower",
                         .upper = "mallows.ci.upper"});
  }
  return intervals;
}

std::vector<CheckedTest> tests_of_guessing(const CoverageSetting&) {
  return {{.quantity = "relabel.p.greater"},
          {.quantity = "perfect.relabel.p.greater"},
          {.quantity = "texture.relabel.p.greater", .key = "a"},
          // These take trials as independent.
          {.quantity = "exact.p.greater"},
          {.quantity = "perfect.p.greater"},
          {.quantity = "texture.p.greater", .key = "a"}};
}

std::vector<CheckedTest> matching_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0 || setting.spread > 0.0) return {};
  return tests_of_guessing(setting);
}

TidyInput draw_kept_matching(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,trial,stimulus,response");
  const auto weights = mallows_weights(0.0);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const Permutation kept = permutation_with(drawn_by_weight(weights, random), random);
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      add_assignment(participant_label(i), trial, kept, table);
    }
  }
  return std::move(table).as_input();
}

// --- two groups --------------------------------------------------------------------------------------

/// By how much the mean theta of the second group is lower, which is at least 0.
constexpr double kLowerTheta = 0.4;

/// Every other participant is of the second group.
CoverageSetting of_group(const CoverageSetting& setting, bool is_second) {
  CoverageSetting own = setting;
  if (is_second) own.effect = std::max(0.0, setting.effect - kLowerTheta);
  return own;
}

TidyInput draw_matching_groups(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,trial,stimulus,response,group");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const bool is_second = i % 2 == 1;
    const auto weights =
        mallows_weights(of_group(setting, is_second).effect + setting.spread * random.normal());
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const Permutation chosen = permutation_with(drawn_by_weight(weights, random), random);
      for (std::size_t item = 0; item < kItems; ++item) {
        table.add({participant_label(i), std::to_string(trial + 1), kMatched[item],
                   kMatched[chosen[item]], is_second ? "M" : "F"});
      }
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("parts", "summary");
  return input;
}

/// Of the items right in a trial, whose probabilities these are.
double mean_right(const std::array<double, kItems + 1>& own) {
  double sum = 0.0;
  for (std::size_t k = 0; k <= kItems; ++k) sum += own[k] * static_cast<double>(k);
  return sum;
}

/// Of a participant's mean over the trials.
double variance_of_means(const CoverageSetting& setting) {
  const double mean = mean_over_thetas(setting, mean_right);
  const double of_thetas = mean_over_thetas(setting, [mean](const auto& own) {
    return (mean_right(own) - mean) * (mean_right(own) - mean);
  });
  const double within = mean_over_thetas(setting, [](const auto& own) {
    double squares = 0.0;
    for (std::size_t k = 0; k <= kItems; ++k) squares += own[k] * static_cast<double>(k * k);
    return squares - mean_right(own) * mean_right(own);
  });
  return of_thetas + within / static_cast<double>(setting.trials);
}

std::vector<CheckedInterval> matching_group_intervals(const CoverageSetting& setting) {
  const CoverageSetting second = of_group(setting, true);
  const double mean = mean_over_thetas(setting, mean_right);
  const double difference = mean - mean_over_thetas(second, mean_right);
  const auto of_first = static_cast<double>((setting.participants + 1) / 2) - 1.0;
  const auto of_second = static_cast<double>(setting.participants / 2) - 1.0;
  const double pooled =
      (of_first * variance_of_means(setting) + of_second * variance_of_means(second)) /
      (of_first + of_second);
  // J = Γ(ν/2)/(√(ν/2)·Γ((ν − 1)/2)) takes d to g.
  const double half = 0.5 * (of_first + of_second);
  const double bias = std::exp(std::lgamma(half) - std::lgamma(half - 0.5)) / std::sqrt(half);
  return {
      {.quantity = "group.mean", .key = "F", .truth = mean},
      {.quantity = "group.diff", .key = "F-M", .truth = difference},
      {.quantity = "group.hedges.g", .key = "F-M", .truth = bias * difference / std::sqrt(pooled)}};
}

std::vector<CheckedTest> matching_group_tests(const CoverageSetting& setting) {
  if (setting.effect > 0.0) return {};
  return {{.quantity = "group.perm.p.two", .key = "F-M"}};
}

}  // namespace

std::span<const CoveragePart> matching_parts() {
  static const auto kOfThetas = all_designs(kThetas, kThetaSpreads);
  static const auto kOfGuessing = all_designs(std::array{0.0}, std::array{0.0});
  static const auto kOfTwoGroups = [] {  // a group of one participant has no variance
    std::vector<CoverageSetting> settings = all_designs(kThetas, kThetaSpreads);
    std::erase_if(settings, [](const CoverageSetting& one) { return one.participants < 4; });
    return settings;
  }();
  static const std::array kParts{
      CoveragePart{.name = "matching",
                   .model = "four pictures to four surfaces by Mallows' model (Hamming distance); "
                            "a participant's theta is normal",
                   .effect = "mean theta",
                   .spread = "SD of theta",
                   .settings = kOfThetas,
                   .draw = draw_matching,
                   .findings = matching_findings,
                   .intervals = matching_intervals,
                   .tests = matching_tests},
      CoveragePart{.name = "matching_kept",
                   .model = "four pictures to four surfaces; each participant guesses one "
                            "assignment and keeps it in all trials",
                   .effect = "always 0",
                   .spread = "always 0",
                   .settings = kOfGuessing,
                   .draw = draw_kept_matching,
                   .findings = matching_findings,
                   .intervals = no_intervals,
                   .tests = tests_of_guessing},
      CoveragePart{.name = "matching_groups",
                   .model = "as `matching`, in two groups of half the participants each; the mean "
                            "theta of the second group is lower by 0.4, but at least 0",
                   .effect = "mean theta of the first group",
                   .spread = "SD of theta",
                   .settings = kOfTwoGroups,
                   .draw = draw_matching_groups,
                   .findings = matching_findings,
                   .intervals = matching_group_intervals,
                   .tests = matching_group_tests}};
  return kParts;
}

}  // namespace asperity
