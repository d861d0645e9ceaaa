// Reliability over repetitions, and agreement between participants.

#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/shared/repetition_reliability.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

// --- reliability of ratings --------------------------------------------------------------------------

constexpr std::array kCorrelationsOfRatings{0.0, 0.3, 0.6, 0.9};
constexpr std::array kRaterSpreads{0.0, 0.7};

TidyInput draw_ratings(const CoverageSetting& setting, Random& random) {
  DrawnTable table("target,rater,score");
  std::vector<double> shifts(setting.trials);
  for (double& shift : shifts) shift = setting.spread * random.normal();
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = std::sqrt(setting.effect) * random.normal();
    for (std::size_t rater = 0; rater < setting.trials; ++rater) {
      const double score = own + shifts[rater] + std::sqrt(1.0 - setting.effect) * random.normal();
      table.add({participant_label(i), std::to_string(rater + 1), number_text(score)});
    }
  }
  return std::move(table).as_input();
}

std::vector<CheckedInterval> rating_intervals(const CoverageSetting& setting) {
  const double own = setting.effect;
  const double error = 1.0 - setting.effect;
  const double shift = setting.spread * setting.spread;
  const auto k = static_cast<double>(setting.trials);
  std::vector<CheckedInterval> intervals{
      {.quantity = "icc", .key = "ICC2", .truth = own / (own + shift + error)},
      {.quantity = "icc", .key = "ICC3", .truth = own / (own + error)},
      {.quantity = "icc", .key = "ICC2k", .truth = own / (own + (shift + error) / k)},
      {.quantity = "icc", .key = "ICC3k", .truth = own / (own + error / k)}};
  if (setting.spread == 0.0) {  // the one-way model
    intervals.push_back({.quantity = "icc", .key = "ICC1", .truth = own / (own + error)});
    intervals.push_back({.quantity = "icc", .key = "ICC1k", .truth = own / (own + error / k)});
  }
  return intervals;
}

std::vector<CheckedTest> rating_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  std::vector<CheckedTest> tests{{.quantity = "icc.p", .key = "ICC3"}};
  if (setting.spread == 0.0) tests.push_back({.quantity = "icc.p", .key = "ICC1"});
  return tests;
}

// --- reliability of proportions ----------------------------------------------------------------------

constexpr std::array kRepeatedProportions{0.25, 0.5, 0.71, 0.87, 0.95};
constexpr std::array kRepeatedSpreads{0.0, 1.0, 2.0};

/// 20 trials are 4 repetitions of 5, other numbers are 3.
std::size_t repetitions_of(const CoverageSetting& setting) {
  return setting.trials % 3 == 0 ? 3 : 4;
}

TidyInput draw_repetitions(const CoverageSetting& setting, Random& random) {
  DrawnTable table("target,rater,score");
  const double mu = mu_of_mean(setting.effect, setting.spread);
  const std::size_t repetitions = repetitions_of(setting);
  const std::size_t trials = setting.trials / repetitions;
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double p = 1.0 / (1.0 + std::exp(-(mu + setting.spread * random.normal())));
    for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
      std::size_t correct = 0;
      for (std::size_t trial = 0; trial < trials; ++trial) correct += random.uniform() < p ? 1 : 0;
      table.add({participant_label(i), std::to_string(repetition + 1),
                 number_text(static_cast<double>(correct) / static_cast<double>(trials))});
    }
  }
  return std::move(table).as_input();
}

std::vector<CheckedInterval> repetition_intervals(const CoverageSetting& setting) {
  const double mu = mu_of_mean(setting.effect, setting.spread);
  const double square = mean_over_normal([&](double z) {
    const double p = 1.0 / (1.0 + std::exp(-(mu + setting.spread * z)));
    return p * p;
  });
  const double between = square - setting.effect * setting.effect;
  const auto repetitions = static_cast<double>(repetitions_of(setting));
  const double within =
      (setting.effect - square) * repetitions / static_cast<double>(setting.trials);
  return {{.quantity = "icc", .key = "ICC2", .truth = between / (between + within)},
          {.quantity = "icc", .key = "ICC3", .truth = between / (between + within)},
          {.quantity = "icc", .key = "ICC3k", .truth = between / (between + within / repetitions)}};
}

std::vector<CheckedTest> repetition_tests(const CoverageSetting& setting) {
  if (setting.spread > 0.0) return {};
  return {{.quantity = "icc.p", .key = "ICC3"}};
}

// --- reliability of estimates within participants ----------------------------------------------------

constexpr std::array kRepeatedSpacings{0.25, 0.4, 0.63, 1.0, 1.6, 2.5, 4.0};
constexpr std::array kRepeatedSlopes{0.1, 0.2, 0.5};
constexpr std::array kRepeatedSlopeSpreads{0.0, 0.2};
constexpr double kEstimateNoise = 0.15;

TidyInput draw_repeated_estimates(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,surface,repetition,logarithm");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double level = random.normal();
    const double slope = setting.effect + setting.spread * random.normal();
    for (const double spacing : kRepeatedSpacings) {
      for (std::size_t repetition = 1; repetition <= setting.trials; ++repetition) {
        const double logarithm =
            level + slope * std::log10(spacing) + kEstimateNoise * random.normal();
        table.add({participant_label(i), number_text(spacing), std::to_string(repetition),
                   number_text(logarithm)});
      }
    }
  }
  return std::move(table).as_input();
}

/// What the analysis of a study of magnitudes gives of such estimates.
std::vector<Finding> reliability_of_estimates(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn surfaces = table.all_labels("surface");
  const std::vector<std::uint64_t> repetitions = table.counts("repetition");
  const std::vector<double> logarithms = table.all_numbers("logarithm");
  GatheredAnswers gathered{};
  gathered.people.resize(participants.names.size());
  std::vector<RepeatedEstimate> estimates{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    estimates.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                         .surface = surfaces.names[surfaces.codes[row]],
                         .repetition = static_cast<int>(repetitions[row]),
                         .value = logarithms[row]});
  }
  AnalysisOutcome outcome{};
  ask_reliability_of_estimates(gathered, estimates, outcome);
  return outcome.findings;
}

std::vector<CheckedInterval> repeated_estimate_intervals(const CoverageSetting& setting) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double spacing : kRepeatedSpacings) {
    sum += std::log10(spacing);
    squares += std::pow(std::log10(spacing), 2);
  }
  const auto n = static_cast<double>(kRepeatedSpacings.size());
  const double variance = (squares - sum * sum / n) / (n - 1.0);
  return {{.quantity = "icc.mean", .key = "ICC3", .truth = mean_over_normal([&](double z) {
                                                    const double slope =
                                                        setting.effect + setting.spread * z;
                                                    const double between = slope * slope * variance;
                                                    return between / (between + kEstimateNoise *
                                                                                    kEstimateNoise);
                                                  })}};
}

// --- agreement in an order ---------------------------------------------------------------------------

constexpr std::array<std::string_view, 4> kScored{"A", "B", "C", "D"};
constexpr std::array kScoreSteps{0.0, 0.2, 0.5, 1.0};
constexpr std::array kScoreSpreads{0.0, 1.0};

double mean_score(const CoverageSetting& setting, std::size_t item) {
  return setting.effect * static_cast<double>(item);
}
/// Of a participant's score of an item, the mean over the trials.
double sd_of_score(const CoverageSetting& setting) {
  return std::sqrt(setting.spread * setting.spread + 1.0 / static_cast<double>(setting.trials));
}

TidyInput draw_scores(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,item,score");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    for (std::size_t item = 0; item < kScored.size(); ++item) {
      const double score = mean_score(setting, item) + sd_of_score(setting) * random.normal();
      table.add({participant_label(i), kScored[item], number_text(score)});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("items", "A,B,C,D");
  return input;
}

/// W of rows whose mean rank correlation is that of two participants' expected ranks. Item i is above j with
/// probability Φ, and its expected rank is 1 more than the sum of these.
double true_concordance(const CoverageSetting& setting) {
  const double middle = 0.5 * static_cast<double>(kScored.size() + 1);
  double of_means = 0.0;
  double of_ranks = 0.0;
  for (std::size_t i = 0; i < kScored.size(); ++i) {
    double rank = 1.0;
    for (std::size_t j = 0; j < kScored.size(); ++j) {
      if (j == i) continue;
      rank += normal_below((mean_score(setting, i) - mean_score(setting, j)) /
                           (std::sqrt(2.0) * sd_of_score(setting)));
    }
    of_means += std::pow(rank - middle, 2);
    of_ranks += std::pow(static_cast<double>(i + 1) - middle, 2);
  }
  const auto n = static_cast<double>(setting.participants);
  return (1.0 + (n - 1.0) * of_means / of_ranks) / n;
}

std::vector<CheckedInterval> score_intervals(const CoverageSetting& setting) {
  return {{.quantity = "kendall.W", .truth = true_concordance(setting)},
          {.quantity = "mean.score", .key = "D", .truth = mean_score(setting, 3)}};
}

std::vector<CheckedTest> score_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "friedman.p"},
          {.quantity = "iman.davenport.p"},
          {.quantity = "wilcoxon.exact.p.two", .key = "A|B"}};
}

}  // namespace

std::span<const CoveragePart> agreement_parts() {
  static const auto kOfCorrelations = all_designs(kCorrelationsOfRatings, kRaterSpreads);
  static const auto kOfProportions = all_designs(kRepeatedProportions, kRepeatedSpreads);
  static const auto kOfSlopes = all_designs(kRepeatedSlopes, kRepeatedSlopeSpreads);
  static const auto kOfScores = all_designs(kScoreSteps, kScoreSpreads);
  static const std::array kParts{
      CoveragePart{.name = "ratings",
                   .model = "a normal score of each participant in each trial, the trials being "
                            "raters or repetitions; total variance 1 within a rater",
                   .effect = "intraclass correlation within a rater",
                   .spread = "SD of the raters' shifts; participants always differ",
                   .settings = kOfCorrelations,
                   .draw = draw_ratings,
                   .findings = icc_findings,
                   .intervals = rating_intervals,
                   .tests = rating_tests,
                   .tables = 10000},
      CoveragePart{.name = "repetitions",
                   .model = "proportions correct in 3 repetitions (of 20 trials: 4); a "
                            "participant's logit is normal and the same in all of them",
                   .effect = "mean proportion correct",
                   .spread = "SD of the logits",
                   .settings = kOfProportions,
                   .draw = draw_repetitions,
                   .findings = icc_findings,
                   .intervals = repetition_intervals,
                   .tests = repetition_tests},
      CoveragePart{.name = "repeated_estimates",
                   .model =
                       "as many estimates of each of seven spacings as there are trials; the "
                       "logarithm of an estimate is linear in that of the spacing by a "
                       "participant's normal slope; analysed by the function that the analysis of "
                       "a magnitude estimation calls (`ask_reliability_of_estimates`)",
                   .effect = "mean slope",
                   .spread = "SD of the slopes",
                   .settings = kOfSlopes,
                   .draw = draw_repeated_estimates,
                   .findings = reliability_of_estimates,
                   .intervals = repeated_estimate_intervals,
                   .tests = no_tests,
                   .tables = 2000},
      CoveragePart{.name = "scores",
                   .model = "a score of each of four items, the mean over the trials; utilities "
                            "and scores are normal",
                   .effect = "difference of neighbouring mean utilities",
                   .spread = "SD of the utilities",
                   .settings = kOfScores,
                   .draw = draw_scores,
                   .findings = rating_findings,
                   .intervals = score_intervals,
                   .tests = score_tests}};
  return kParts;
}

}  // namespace asperity
