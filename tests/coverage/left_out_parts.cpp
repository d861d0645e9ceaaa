// The mean of the thresholds that lie among the levels, where others lie below them and are left out.

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/tests/geometric_mean.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

/// The levels above a standard of 50 µm, in µm, and the threshold of every participant, (1 + x/50) = exp(0.674·SD) with an SD of
/// 0.15·√2.
constexpr double kStandard = 50.0;
constexpr double kSdOfLogarithm = 0.212132034355964;
constexpr double kThreeQuarters = 0.6744897501960817;
constexpr std::array kLowestLevels{6.0, 7.0};
constexpr std::size_t kLevelsOfOne = 4;
using LevelsOfOne = std::array<double, kLevelsOfOne>;

LevelsOfOne levels_from(double lowest) {
  return lowest == kLowestLevels.front() ? LevelsOfOne{6.0, 10.0, 15.0, 22.5}
                                         : LevelsOfOne{7.0, 12.0, 20.0, 30.0};
}

TidyInput draw_near_the_lowest_level(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,x,n,k");
  const std::size_t trials = setting.trials / kLevelsOfOne;
  for (std::size_t i = 0; i < setting.participants; ++i) {
    for (const double x : levels_from(setting.effect)) {
      const double p = normal_below(std::log1p(x / kStandard) / kSdOfLogarithm);
      std::size_t hits = 0;
      for (std::size_t trial = 0; trial < trials; ++trial) hits += random.uniform() < p ? 1 : 0;
      table.add(
          {participant_label(i), number_text(x), std::to_string(trials), std::to_string(hits)});
    }
  }
  return std::move(table).as_input();
}

/// The thresholds that the analysis of a study gives of such choices, and their mean under the key "others", with the t-based
/// interval that it does not give where thresholds are left out.
std::vector<Finding> findings_of_levels(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<double> differences = table.all_numbers("x");
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<std::uint64_t> hits = table.counts("k");
  Dimension varied{};
  varied.standard = 0.0;
  DiscriminationStudy study{.task = {.is_performance = true, .varied = varied},
                            .conditions = {"all"}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t trial = 0; trial < trials[row]; ++trial) {
      study.trials.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                              .value = differences[row],
                              .chose_comparison = trial < hits[row]});
    }
  }
  GatheredAnswers gathered{};
  for (const std::string& name : participants.names) gathered.people.push_back({.label = name});
  const DiscriminationResults results(gathered, study, false);
  std::vector<Finding> findings{};
  std::vector<double> estimated{};
  for (const Finding& threshold : results.fit.thresholds) {
    if (threshold.quantity != "jnd" || !threshold.value) continue;
    estimated.push_back(*threshold.value);
    findings.push_back(threshold);
  }
  if (estimated.empty()) return findings;
  const GeometricMean others = geometric_mean(estimated);
  Finding withdrawn{.quantity = "geomean.jnd", .key = "others", .value = others.mean};
  if (others.interval) {
    withdrawn.low = others.interval->low;
    withdrawn.high = others.interval->high;
  }
  findings.push_back(std::move(withdrawn));
  return findings;
}

std::vector<CheckedInterval> level_intervals(const CoverageSetting&) {
  const double jnd = kStandard * std::expm1(kThreeQuarters * kSdOfLogarithm);
  return {{.quantity = "geomean.jnd", .key = "others", .truth = jnd},
          {.quantity = "jnd", .key = participant_label(0) + "|all", .truth = jnd}};
}

}  // namespace

std::span<const CoveragePart> left_out_parts() {
  static constexpr std::array kSettings{
      CoverageSetting{.participants = 8, .trials = 48, .effect = kLowestLevels[0]},
      CoverageSetting{.participants = 8, .trials = 48, .effect = kLowestLevels[1]}};
  static const std::array kParts{CoveragePart{
      .name = "left_out_thresholds",
      .model = "two alternatives at 6, 10, 15 and 22.5 or at 7, 12, 20 and 30 µm above "
               "a standard of 50 µm, 12 trials at each; the threshold of every "
               "participant is 7.7 µm, and an estimate outside the levels is left out; "
               "`others` is the interval of the mean of the other estimates, which "
               "the analysis of a study does not report",
      .effect = "lowest level in µm",
      .spread = "always 0",
      .settings = kSettings,
      .draw = draw_near_the_lowest_level,
      .findings = findings_of_levels,
      .intervals = level_intervals,
      .tests = no_tests,
                   .tables = 2000}};
  return kParts;
}

}  // namespace asperity
