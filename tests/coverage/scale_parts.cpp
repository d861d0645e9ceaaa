// Scales of compared items, curves of estimated magnitudes, analysis of variance.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>

#include "analysis/choices/bradley_terry.h"
#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/study_findings.h"
#include "app/findings/shared/estimates.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

// --- comparisons of two ------------------------------------------------------------------------------

constexpr std::array<std::string_view, 4> kCompared{"A", "B", "C", "D"};
constexpr std::array kSteps{0.0, 0.4, 0.8};
constexpr std::array kUtilitySpreads{0.0, 0.8};

double mean_utility(const CoverageSetting& setting, std::size_t item) {
  return setting.effect * static_cast<double>(item);
}

TidyInput draw_pairs(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,first,second,winner");
  constexpr std::array<std::array<std::size_t, 2>, 6> kPairs{
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};
  std::size_t pair = 0;  // goes on with the next participant: all pairs are equally frequent
  for (std::size_t i = 0; i < setting.participants; ++i) {
    std::array<double, 4> own{};
    for (std::size_t j = 0; j < own.size(); ++j) {
      own[j] = mean_utility(setting, j) + setting.spread * random.normal();
    }
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      auto [first, second] = kPairs[pair++ % kPairs.size()];
      if (random.below(2) == 1) std::swap(first, second);
      const double of_first = 1.0 / (1.0 + std::exp(own[second] - own[first]));
      const std::size_t winner = random.uniform() < of_first ? first : second;
      table.add({participant_label(i), kCompared[first], kCompared[second], kCompared[winner]});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("items", "A,B,C,D");
  return input;
}

/// What the fit tends to with ever more participants: differences between these make the pairs' probabilities less
/// extreme than those of a participant whose utilities are the mean ones.
Eigen::VectorXd limit_of_abilities(const CoverageSetting& setting) {
  std::vector<Comparison> expected{};
  constexpr double kMany = 1e7;
  for (std::size_t i = 0; i < kCompared.size(); ++i) {
    for (std::size_t j = i + 1; j < kCompared.size(); ++j) {
      const double p = mean_of_logistic(mean_utility(setting, i) - mean_utility(setting, j),
                                        std::sqrt(2.0) * setting.spread);
      const auto wins = static_cast<std::size_t>(std::llround(kMany * p));
      const auto losses = static_cast<std::size_t>(kMany) - wins;
      expected.push_back({.first = i, .second = j, .winner = i, .times = wins});
      expected.push_back({.first = i, .second = j, .winner = j, .times = losses});
    }
  }
  return bradley_terry(expected, kCompared.size())->abilities.about_mean().value;
}

std::vector<CheckedInterval> pair_intervals(const CoverageSetting& setting) {
  const Eigen::VectorXd limit = limit_of_abilities(setting);
  std::vector<CheckedInterval> intervals{};
  for (const char* const quantity : {"bt.ability.sumzero.cluster", "bt.ability.sumzero"}) {
    for (const std::size_t item : {std::size_t{0}, std::size_t{3}}) {
      intervals.push_back({.quantity = quantity,
                           .key = std::string(kCompared[item]),
                           .truth = limit(static_cast<Eigen::Index>(item))});
    }
  }
  return intervals;
}

std::vector<CheckedTest> pair_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0 || setting.spread > 0.0) return {};
  return {{.quantity = "bt.lr.equal.p"}};
}

// --- the best of three ---------------------------------------------------------------------------------

/// Of A, B and C.
ThreeItems offered_utilities(const CoverageSetting& setting) {
  return {mean_utility(setting, 0), mean_utility(setting, 1), mean_utility(setting, 2)};
}

TidyInput draw_best_of_three(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,trial,item,rank");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const ThreeItems own = own_weights(offered_utilities(setting), setting.spread, random);
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const std::size_t best = drawn_by_weight(own, random);
      const std::string number = std::to_string(trial + 1);
      for (std::size_t j = 0; j < own.size(); ++j) {
        table.add({participant_label(i), number, kCompared[j], j == best ? "1" : ""});
      }
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("items", "A,B,C");
  return input;
}

/// Worths of first choices are their probabilities, here of any participant; centred.
ThreeItems log_worths(const CoverageSetting& setting) {
  ThreeItems worths = mean_choices(offered_utilities(setting), setting.spread);
  double mean = 0.0;
  for (double& one : worths) {
    one = std::log(one);
    mean += one / static_cast<double>(worths.size());
  }
  for (double& one : worths) one -= mean;
  return worths;
}

std::vector<CheckedInterval> best_of_three_intervals(const CoverageSetting& setting) {
  const ThreeItems truth = log_worths(setting);
  std::vector<CheckedInterval> intervals{};
  for (const char* const quantity : {"pl.logworth.sumzero.cluster", "pl.logworth.sumzero"}) {
    for (const std::size_t item : {std::size_t{0}, std::size_t{2}}) {
      intervals.push_back(
          {.quantity = quantity, .key = std::string(kCompared[item]), .truth = truth[item]});
    }
  }
  return intervals;
}

std::vector<CheckedTest> best_of_three_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0 || setting.spread > 0.0) return {};
  return {{.quantity = "pl.lr.p"}};
}

// --- estimated magnitudes ------------------------------------------------------------------------------

constexpr std::array kSpacings{0.25, 0.4, 0.63, 1.0, 1.6, 2.5, 4.0};
constexpr std::array kBends{0.0, -0.4, -0.8};
constexpr std::array kCurveSpreads{0.1, 0.3};
constexpr double kSlope = 0.2;      // of the mean curve at spacing 1
constexpr double kOwnScale = 0.3;   // SD of the participants' levels
constexpr double kOwnNoise = 0.15;  // SD of a single estimate

/// log₁₀ of an estimate = a + b·x + c·x², x = log₁₀ of the spacing, with the participant's own a, b and c.
TidyInput draw_estimates(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,probe,spacing,estimate,rep");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double a = kOwnScale * random.normal();
    const double b = kSlope + setting.spread * random.normal();
    const double c = setting.effect + setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      for (const double spacing : kSpacings) {
        const double x = std::log10(spacing);
        const double y = a + b * x + c * x * x + kOwnNoise * random.normal();
        table.add({participant_label(i), "P", number_text(spacing), number_text(std::pow(10.0, y)),
                   std::to_string(trial + 1)});
      }
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("zero_rule", "exclude");
  input.options.add("normalisation", "geomean");
  return input;
}

std::vector<CheckedInterval> estimate_intervals(const CoverageSetting& setting) {
  // The slope of a straight line through a parabola, which is b where the x lie symmetrically.
  double sum_x = 0.0;
  double sum_xx = 0.0;
  double sum_y = 0.0;
  double sum_xy = 0.0;
  for (const double spacing : kSpacings) {
    const double x = std::log10(spacing);
    const double y = kSlope * x + setting.effect * x * x;
    sum_x += x;
    sum_xx += x * x;
    sum_y += y;
    sum_xy += x * y;
  }
  const auto n = static_cast<double>(kSpacings.size());
  std::vector<CheckedInterval> intervals{
      {.quantity = "exponent.mean",
       .key = "P",
       .truth = (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x)}};
  if (setting.effect < 0.0) {
    const double peak = std::pow(10.0, -kSlope / (2.0 * setting.effect));
    intervals.push_back({.quantity = "peak", .key = "P", .truth = peak});
    intervals.push_back({.quantity = "peak.fieller",
                         .key = "P",
                         .truth = peak,
                         .lower = "peak.fieller.lower",
                         .upper = "peak.fieller.upper"});
  }
  return intervals;
}

std::vector<CheckedTest> estimate_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "quad.c.p", .key = "P"}};
}

// --- estimates of any stimulus, with a modulus -------------------------------------------------------

constexpr std::array kExponents{0.0, 0.5};
constexpr std::array kExponentSpreads{0.0, 0.3};
constexpr std::array kPredictors{0.25, 0.5, 1.0, 2.0, 4.0};
constexpr const char* kGreatestStimulus = "4";

/// log₁₀ of an estimate = a + b·x, x = log₁₀ of the predictor, with the participant's own a and b.
TidyInput draw_estimates_of_stimuli(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,stimulus,estimate");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double a = kOwnScale * random.normal();
    const double b = setting.effect + setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      for (const double predictor : kPredictors) {
        const double y = a + b * std::log10(predictor) + kOwnNoise * random.normal();
        table.add({participant_label(i), number_text(predictor), number_text(std::pow(10.0, y))});
      }
    }
  }
  return std::move(table).as_input();
}

/// What the analysis of a study gives of such estimates.
std::vector<Finding> findings_of_stimuli(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn stimuli = table.all_labels("stimulus");
  const std::vector<double> numbers = table.all_numbers("estimate");
  GatheredAnswers gathered{};
  gathered.estimation.stated_normalisation = EstimateNormalisation::none;
  for (const std::string& name : participants.names) gathered.people.push_back({.label = name});
  std::map<std::string, double> predictor{};
  for (const double one : kPredictors) predictor.emplace(number_text(one), one);
  std::vector<Estimated> estimates{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    estimates.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                         .condition = "P",
                         .spacing = stimuli.names[stimuli.codes[row]],
                         .estimate = numbers[row]});
  }
  return analysis_of("stimulus_estimates", "magnitude",
                     items_table(gathered, estimates, predictor));
}

std::vector<CheckedInterval> exponent_intervals(const CoverageSetting& setting) {
  return {{.quantity = "exponent.mean", .key = "P", .truth = setting.effect},
          {.quantity = "geomean",
           .key = FindingKey{"P", kGreatestStimulus}.text(),
           .truth = std::pow(kPredictors.back(), setting.effect)}};
}

std::vector<CheckedTest> exponent_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "exponent.p", .key = "P"}};
}

// --- analysis of variance ------------------------------------------------------------------------------

constexpr std::array<std::string_view, 5> kLevels{"1", "2", "3", "4", "5"};
constexpr std::array kCorrelations{0.0, 0.8};

/// Measurements without an effect; those of neighbouring levels correlate by the setting's effect.
TidyInput draw_measurements(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,spacing,y");
  const double rho = setting.effect;
  for (std::size_t i = 0; i < setting.participants; ++i) {
    std::array<double, kLevels.size()> sums{};
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      double z = random.normal();
      for (double& sum : sums) {
        sum += z;
        z = rho * z + std::sqrt(1.0 - rho * rho) * random.normal();
      }
    }
    for (std::size_t level = 0; level < kLevels.size(); ++level) {
      table.add({participant_label(i), kLevels[level],
                 number_text(sums[level] / static_cast<double>(setting.trials))});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("within", R"({"spacing": [1, 2, 3, 4, 5]})");
  return input;
}

std::vector<CheckedTest> variance_tests(const CoverageSetting&) {
  return {{.quantity = "p", .key = "spacing"}, {.quantity = "p.GG", .key = "spacing"}};
}

}  // namespace

std::span<const CoveragePart> scale_parts() {
  static const auto kOfUtilities = all_designs(kSteps, kUtilitySpreads);
  static const auto kOfCurves = all_designs(kBends, kCurveSpreads);
  static const auto kOfExponents = all_designs(kExponents, kExponentSpreads);
  static const auto kOfCorrelations = all_designs(kCorrelations, std::array{0.0});
  static const std::array kParts{
      CoveragePart{.name = "pairs",
                   .model = "comparisons of two of four items; a participant's utilities are "
                            "normal, and the choice is logistic in their difference",
                   .effect = "difference of neighbouring mean utilities",
                   .spread = "SD of the utilities",
                   .settings = kOfUtilities,
                   .draw = draw_pairs,
                   .findings = paired_findings,
                   .intervals = pair_intervals,
                   .tests = pair_tests,
                   .tables = 10000},
      CoveragePart{.name = "worths",
                   .model = "the best of three items; a participant's utilities are normal, and "
                            "the choice follows Luce's rule",
                   .effect = "difference of neighbouring mean utilities",
                   .spread = "SD of the utilities",
                   .settings = kOfUtilities,
                   .draw = draw_best_of_three,
                   .findings = ranking_findings,
                   .intervals = best_of_three_intervals,
                   .tests = best_of_three_tests,
                   .tables = 10000},
      CoveragePart{
          .name = "magnitudes",
          .model = "seven spacings; the logarithm of an estimate is a quadratic function of the "
                   "logarithm of the spacing, with each participant's own coefficients",
          .effect = "mean quadratic coefficient",
          .spread = "SD of the coefficients",
          .settings = kOfCurves,
          .draw = draw_estimates,
          .findings = magnitude_findings,
          .intervals = estimate_intervals,
          .tests = estimate_tests,
          .tables = 10000},
      CoveragePart{.name = "exponents",
                   .model = "five stimuli and a standard with a modulus; the logarithm of an "
                            "estimate is linear in that of the predictor, with each participant's "
                            "own level and exponent; analysed as the estimates of a study "
                            "(`items_table`)",
                   .effect = "mean exponent",
                   .spread = "SD of the exponents; levels always differ",
                   .settings = kOfExponents,
                   .draw = draw_estimates_of_stimuli,
                   .findings = findings_of_stimuli,
                   .intervals = exponent_intervals,
                   .tests = exponent_tests,
                   .tables = 10000},
      CoveragePart{.name = "variance",
                   .model = "five levels without an effect, normal",
                   .effect = "correlation of neighbouring levels",
                   .spread = "always 0",
                   .settings = kOfCorrelations,
                   .draw = draw_measurements,
                   .findings = rmanova_findings,
                   .intervals = no_intervals,
                   .tests = variance_tests}};
  return kParts;
}

}  // namespace asperity
