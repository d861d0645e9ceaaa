// Differences of means, whether they are equivalent, and how large their effects are.

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/tests/effect_size.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

// --- two groups of proportions -----------------------------------------------------------------------

constexpr std::array kGroupProportions{0.25, 0.5, 0.71, 0.87, 0.95};
constexpr std::array kGroupSpreads{0.0, 1.0};
constexpr double kMargin = 0.1;
/// With it the interval next to the tests is one of 95 %; their p do not depend on it.
constexpr std::string_view kAlpha = "0.025";

/// Every other participant is of the first group, whose mean is larger by the margin.
TidyInput draw_two_groups(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,group,value");
  const std::array mus{mu_of_mean(setting.effect, setting.spread),
                       mu_of_mean(setting.effect - kMargin, setting.spread)};
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double p = 1.0 / (1.0 + std::exp(-(mus[i % 2] + setting.spread * random.normal())));
    std::size_t correct = 0;
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      correct += random.uniform() < p ? 1 : 0;
    }
    table.add({participant_label(i), i % 2 == 0 ? "F" : "M",
               number_text(static_cast<double>(correct) / static_cast<double>(setting.trials))});
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("groups", "F,M");
  input.options.add("lower", number_text(-kMargin));
  input.options.add("upper", number_text(kMargin));
  input.options.add("alpha", std::string(kAlpha));
  return input;
}

/// Of a participant's proportion correct.
double variance_of_proportion(double mean, const CoverageSetting& setting) {
  const double mu = mu_of_mean(mean, setting.spread);
  const double square = mean_over_normal([&](double z) {
    const double p = 1.0 / (1.0 + std::exp(-(mu + setting.spread * z)));
    return p * p;
  });
  return square - mean * mean + (mean - square) / static_cast<double>(setting.trials);
}

std::vector<CheckedInterval> two_group_intervals(const CoverageSetting& setting) {
  const auto first = static_cast<double>((setting.participants + 1) / 2);
  const auto second = static_cast<double>(setting.participants / 2);
  const double pooled =
      ((first - 1.0) * variance_of_proportion(setting.effect, setting) +
       (second - 1.0) * variance_of_proportion(setting.effect - kMargin, setting)) /
      (first + second - 2.0);
  // J = Γ(ν/2)/(√(ν/2)·Γ((ν − 1)/2)) takes d to g.
  const double half = 0.5 * (first + second - 2.0);
  const double bias = std::exp(std::lgamma(half) - std::lgamma(half - 0.5)) / std::sqrt(half);
  const double d = kMargin / std::sqrt(pooled);
  return {{.quantity = "diff", .truth = kMargin},
          {.quantity = "cohen.d", .truth = d},
          {.quantity = "hedges.g", .truth = bias * d}};
}

std::vector<CheckedTest> equivalence_tests(const CoverageSetting&) {
  return {{.quantity = "tost.p"}};
}

// --- two groups of numbers and of profiles -----------------------------------------------------------

constexpr std::array kLogRatios{0.0, 0.5};
constexpr std::array<std::string_view, 3> kItemsOfProfile{"wood", "metal", "stone"};
constexpr std::array kLogSpreads{0.0, 0.5};

/// Of the mean of a participant's trials, whose SD is 1.
double sd_of_participant(const CoverageSetting& setting) {
  return std::sqrt(setting.spread * setting.spread + 1.0 / static_cast<double>(setting.trials));
}

TidyInput draw_group_numbers(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,group,value");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double level = i % 2 == 0 ? setting.effect : 0.0;
    table.add({participant_label(i), i % 2 == 0 ? "A" : "B",
               number_text(std::exp(level + sd_of_participant(setting) * random.normal()))});
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("groups", "A,B");
  input.options.add("scale", "ratio");
  return input;
}

std::vector<CheckedInterval> group_number_intervals(const CoverageSetting& setting) {
  const double half = 0.5 * (static_cast<double>(setting.participants) - 2.0);
  std::vector<CheckedInterval> intervals{
      {.quantity = "values.ratio", .truth = std::exp(setting.effect)},
      {.quantity = "values.mean", .key = "B", .truth = 1.0}};
  if (half > 0.5) {
    const double bias = std::exp(std::lgamma(half) - std::lgamma(half - 0.5)) / std::sqrt(half);
    intervals.push_back({.quantity = "values.hedges.g",
                         .truth = bias * setting.effect / sd_of_participant(setting)});
  }
  return intervals;
}

std::vector<CheckedTest> group_number_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "values.log.perm.p.two"}, {.quantity = "values.welch.p.two"}};
}

/// The items of a participant of the first group differ by the effect from one to the next.
TidyInput draw_group_profiles(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,group,item,value");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double level = random.normal();
    for (std::size_t item = 0; item < kItemsOfProfile.size(); ++item) {
      const double step = i % 2 == 0 ? setting.effect * static_cast<double>(item) : 0.0;
      table.add({participant_label(i), i % 2 == 0 ? "A" : "B", kItemsOfProfile[item],
                 number_text(level + step + sd_of_participant(setting) * random.normal())});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("groups", "A,B");
  return input;
}

/// The first of three items lies one step below the mean of a participant's items.
std::vector<CheckedInterval> group_profile_intervals(const CoverageSetting& setting) {
  return {{.quantity = "profile.diff",
           .key = std::string(kItemsOfProfile.front()),
           .truth = -setting.effect}};
}

std::vector<CheckedTest> group_profile_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "profile.perm.p"}};
}

// --- pairs of measurements ---------------------------------------------------------------------------

constexpr std::array kShifts{0.0, 0.3, 1.0};
constexpr std::array kShiftSpreads{0.0, 0.5};

/// The participants' levels do not matter; a measurement is a mean over the trials.
TidyInput draw_measured_pairs(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,a,b");
  const double noise = 1.0 / std::sqrt(static_cast<double>(setting.trials));
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double level = random.normal();
    const double shift = setting.effect + setting.spread * random.normal();
    table.add({participant_label(i), number_text(level + shift + noise * random.normal()),
               number_text(level + noise * random.normal())});
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("alpha", std::string(kAlpha));
  if (setting.effect > 0.0) {
    input.options.add("lower", number_text(-setting.effect));
    input.options.add("upper", number_text(setting.effect));
  }
  return input;
}

std::vector<CheckedInterval> measured_pair_intervals(const CoverageSetting& setting) {
  const double sd =
      std::sqrt(setting.spread * setting.spread + 2.0 / static_cast<double>(setting.trials));
  return {{.quantity = "diff", .truth = setting.effect},
          {.quantity = "dz", .truth = setting.effect / sd}};
}

std::vector<CheckedTest> measured_pair_tests(const CoverageSetting& setting) {
  return {{.quantity = setting.effect > 0.0 ? "tost.p" : "t.p.two"}};
}

// --- effect sizes of the analysis of variance --------------------------------------------------------

constexpr std::array<std::string_view, 3> kMeasured{"1", "2", "3"};
constexpr std::array kLevelSteps{0.0, 0.2, 0.5};
constexpr std::array kOwnLevelSpreads{0.0, 1.0};
constexpr double kOwnDeviation = 0.3;  // SD of a participant's own deviation at a level

/// Of the mean of a participant's trials at a level, about the participant's own level.
double error_variance(const CoverageSetting& setting) {
  return kOwnDeviation * kOwnDeviation + 1.0 / static_cast<double>(setting.trials);
}

TidyInput draw_effects(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,spacing,y");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = setting.spread * random.normal();
    for (std::size_t level = 0; level < kMeasured.size(); ++level) {
      const double y = own + setting.effect * static_cast<double>(level) +
                       std::sqrt(error_variance(setting)) * random.normal();
      table.add({participant_label(i), kMeasured[level], number_text(y)});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("within", R"({"spacing": [1, 2, 3]})");
  return input;
}

/// η² as the noncentrality defines it, and generalised with the expected ratio of the error strata.
std::vector<CheckedInterval> effect_intervals(const CoverageSetting& setting) {
  const auto n = static_cast<double>(setting.participants);
  const auto k = static_cast<double>(kMeasured.size());
  const double squares = setting.effect * setting.effect * k * (k * k - 1.0) / 12.0;
  const double own_error = error_variance(setting);
  const double noncentrality = n * squares / own_error;
  const double between = k * setting.spread * setting.spread + own_error;
  const double all_errors = 1.0 + between / ((k - 1.0) * own_error);
  const double odds = noncentrality / ((k - 1.0) * n + 1.0);
  return {{.quantity = "pes", .key = "spacing", .truth = odds / (odds + 1.0)},
          {.quantity = "ges", .key = "spacing", .truth = odds / (odds + all_errors)},
          {.quantity = "cell.mean", .key = "all|3", .truth = (k - 1.0) * setting.effect},
          {.quantity = "pair.diff", .key = "spacing|1|3", .truth = -(k - 1.0) * setting.effect},
          {.quantity = "pair.dz",
           .key = "spacing|1|3",
           .truth = -(k - 1.0) * setting.effect / std::sqrt(2.0 * own_error)}};
}

std::vector<CheckedTest> effect_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "p", .key = "spacing"},
          {.quantity = "p.GG", .key = "spacing"},
          {.quantity = "pair.p", .key = "spacing|1|3"}};
}

}  // namespace

std::span<const CoveragePart> difference_parts() {
  static const auto kOfProportions = [] {  // a group of one participant has no variance
    std::vector<CoverageSetting> settings = all_designs(kGroupProportions, kGroupSpreads);
    std::erase_if(settings, [](const CoverageSetting& one) { return one.participants < 4; });
    return settings;
  }();
  static const auto kOfGroups = all_designs(kLogRatios, kLogSpreads);
  static const auto kOfShifts = all_designs(kShifts, kShiftSpreads);
  static const auto kOfSteps = all_designs(kLevelSteps, kOwnLevelSpreads);
  static const std::array kParts{
      CoveragePart{.name = "equivalence",
                   .model = "proportions correct of two groups of half the participants each, "
                            "whose means differ by the equivalence margin, .1; a participant's "
                            "logit of a correct response is normal",
                   .effect = "mean proportion correct in the first group",
                   .spread = "SD of the logits",
                   .settings = kOfProportions,
                   .draw = draw_two_groups,
                   .findings = equivalence_findings,
                   .intervals = two_group_intervals,
                   .tests = equivalence_tests},
      CoveragePart{.name = "group_numbers",
                   .model = "a positive number of each participant of two groups of half the "
                            "participants each, compared by the ratio of the geometric means; its "
                            "logarithm is the mean over the trials, normal with an SD of 1",
                   .effect = "ln of the ratio",
                   .spread = "SD of the logarithms between participants",
                   .settings = kOfGroups,
                   .draw = draw_group_numbers,
                   .findings = group_values_findings,
                   .intervals = group_number_intervals,
                   .tests = group_number_tests},
      CoveragePart{.name = "group_profiles",
                   .model = "three numbers of each participant of two groups of half the "
                            "participants each, means over the trials, normal with an SD of 1; "
                            "levels of participants are normal",
                   .effect = "difference of neighbouring items in the first group",
                   .spread = "SD of the participants' own deviations of each item",
                   .settings = kOfGroups,
                   .draw = draw_group_profiles,
                   .findings = group_values_findings,
                   .intervals = group_profile_intervals,
                   .tests = group_profile_tests},
      CoveragePart{.name = "differences",
                   .model = "pairs of measurements, each the mean over the trials; a participant's "
                            "shift is normal, the equivalence margin is its mean",
                   .effect = "mean shift; 0: without a margin",
                   .spread = "SD of the shifts",
                   .settings = kOfShifts,
                   .draw = draw_measured_pairs,
                   .findings = equivalence_findings,
                   .intervals = measured_pair_intervals,
                   .tests = measured_pair_tests},
      CoveragePart{.name = "effects",
                   .model = "three levels, each the mean over the trials, normal; a participant's "
                            "deviation at each level has an SD of 0.3",
                   .effect = "difference of neighbouring levels",
                   .spread = "SD of the participants' levels",
                   .settings = kOfSteps,
                   .draw = draw_effects,
                   .findings = rmanova_findings,
                   .intervals = effect_intervals,
                   .tests = effect_tests}};
  return kParts;
}

}  // namespace asperity
