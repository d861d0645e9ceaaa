// Choices among three surfaces, and thresholds of split counts.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/thresholds/choices_by_place.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/outcome/study_findings.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

// --- the position of the chosen one of three ---------------------------------------------------------

constexpr std::array kSensitivitiesOfPlaces{0.0, 1.0};
constexpr std::array kSpreadsOfPlaces{0.0, 0.5};

/// The correct surface takes the places in turn. The participant chooses the greatest impression, after adding the own
/// preferences for the places, which are as often for one place as for another.
TidyInput draw_places(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,correct,chosen");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    std::array<double, kPlacesOfChoice> preferences{};
    for (double& one : preferences) one = setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const std::size_t correct = trial % kPlacesOfChoice;
      std::array<double, kPlacesOfChoice> impressions{};
      for (std::size_t place = 0; place < kPlacesOfChoice; ++place) {
        impressions[place] =
            preferences[place] + random.normal() + (place == correct ? setting.effect : 0.0);
      }
      const auto chosen = std::max_element(impressions.begin(), impressions.end());
      table.add({participant_label(i), std::to_string(correct),
                 std::to_string(chosen - impressions.begin())});
    }
  }
  return std::move(table).as_input();
}

GatheredAnswers gathered_people(const LabelColumn& participants) {
  GatheredAnswers gathered{};
  for (const std::string& name : participants.names) gathered.people.push_back({.label = name});
  return gathered;
}

/// What the analysis of a study gives of such choices: the proportions, and the scores whose order Friedman's test compares.
std::vector<Finding> findings_of_places(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<std::uint64_t> correct = table.counts("correct");
  const std::vector<std::uint64_t> chosen = table.counts("chosen");
  DiscriminationStudy study{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    study.trials.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                            .correct_place = correct[row],
                            .chosen_place = chosen[row]});
  }
  const std::vector<PlacesOfPerson> places = places_of(study);
  std::vector<Finding> findings = place_findings(places, "");
  ScoreRows scores(gathered_people(participants));
  for (const PlacesOfPerson& own : places) {
    for (std::size_t place = 0; place < kPlacesOfChoice; ++place) {
      scores.add(own.person, kCodesOfPlaces[place], own.proportion_of(place));
    }
  }
  TidyInput compared = std::move(scores).take("subject", "item", "the choices");
  compared.options.set("items",
                       std::vector<std::string>{kCodesOfPlaces.begin(), kCodesOfPlaces.end()});
  const std::vector<Finding> tests = analysis_of("order_test", "rating", std::move(compared));
  findings.insert(findings.end(), tests.begin(), tests.end());
  return findings;
}

std::vector<CheckedInterval> place_intervals(const CoverageSetting&) {
  return {{.quantity = "place.proportion", .key = "A", .truth = 1.0 / 3.0}};
}

std::vector<CheckedTest> place_tests(const CoverageSetting&) {
  return {{.quantity = "friedman.p"}};
}

// --- thresholds of constant stimuli ------------------------------------------------------------------

constexpr std::array kDifferences{0.4, 0.63, 1.0, 1.6, 2.5};
constexpr double kLapseRate = 0.02;
constexpr double kSteepnessOfDifferences = 2.0;
/// Trials for one of the design, as in the part `sensitivity`.
constexpr std::size_t kTrialsForOne = 10;

/// γ + (1 − γ − λ)·(1 − exp(−(x/α)^β))
double weibull(double x, double alpha, double guess) {
  return guess +
         (1.0 - guess - kLapseRate) * -std::expm1(-std::pow(x / alpha, kSteepnessOfDifferences));
}
/// The difference at which that is p, with α = 1.
double difference_at(double p, double guess) {
  return std::pow(-std::log1p(-(p - guess) / (1.0 - guess - kLapseRate)),
                  1.0 / kSteepnessOfDifferences);
}

Dimension from_zero() {
  Dimension varied{};
  varied.standard = 0.0;
  return varied;
}

constexpr double kGuessOfThree = 1.0 / 3.0;
constexpr std::array kNoEffect{0.0};
constexpr std::array kSpreadsOfThresholds{0.0, 0.3};

TidyInput draw_three_surfaces(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,x,n,k");
  const std::size_t trials = kTrialsForOne * setting.trials / kDifferences.size();
  const std::string number = std::to_string(trials);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double alpha = std::exp(setting.spread * random.normal());
    for (const double x : kDifferences) {
      std::size_t hits = 0;
      for (std::size_t trial = 0; trial < trials; ++trial) {
        hits += random.uniform() < weibull(x, alpha, kGuessOfThree) ? 1 : 0;
      }
      table.add({participant_label(i), number_text(x), number, std::to_string(hits)});
    }
  }
  return std::move(table).as_input();
}

/// What the analysis of a study gives of such responses as choices of the strongest; and the first participant's as choices
/// of the odd one.
std::vector<Finding> findings_of_three_surfaces(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<double> differences = table.all_numbers("x");
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<std::uint64_t> hits = table.counts("k");
  DiscriminationStudy study{.task = {.design = &three_alternatives(), .varied = from_zero()},
                            .conditions = {"all"}};
  DiscriminationData first{.key = "oddity"};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t trial = 0; trial < trials[row]; ++trial) {
      study.trials.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                              .value = differences[row],
                              .chose_comparison = trial < hits[row]});
    }
    if (participants.codes[row] == 0) first.hits[differences[row]] = {hits[row], trials[row]};
  }
  const DiscriminationResults results(gathered_people(participants), study, false);
  std::vector<Finding> findings = results.fit.thresholds;
  findings.insert(findings.end(), results.means.begin(), results.means.end());
  DiscriminationTask oddity = study.task;
  oddity.design = &oddity_task();
  const std::vector<Finding> of_oddity =
      fit_discrimination(oddity, std::span(&first, 1)).thresholds;
  findings.insert(findings.end(), of_oddity.begin(), of_oddity.end());
  return findings;
}

/// The proportion correct of three alternatives with d′ = 1: the signal is greater than both others.
double three_alternatives_at_one() {
  return mean_over_normal([](double z) { return std::pow(normal_below(z + 1.0), 2); });
}
/// Of oddity by the differencing rule, 2·∫₀^∞ (Φ(−√3·z + √⅔·d′) + Φ(−√3·z − √⅔·d′))·φ(z) dz by the trapezium rule with 20 000
/// steps.
constexpr double kOddityAtOne = 0.418047;

std::vector<CheckedInterval> three_surface_intervals(const CoverageSetting& setting) {
  const double jnd = difference_at(2.0 / 3.0, kGuessOfThree);
  const double at_one = difference_at(three_alternatives_at_one(), kGuessOfThree);
  const double arithmetic = std::exp(0.5 * setting.spread * setting.spread);
  std::vector<CheckedInterval> intervals{
      {.quantity = "geomean.jnd", .key = "all", .truth = jnd},
      {.quantity = "mean.jnd", .key = "all", .truth = arithmetic * jnd},
      {.quantity = "geomean.jnd.dprime1", .key = "all", .truth = at_one}};
  if (setting.spread > 0.0) return intervals;
  const std::string first = participant_label(0) + "|all";
  intervals.push_back({.quantity = "jnd", .key = first, .truth = jnd});
  intervals.push_back({.quantity = "jnd.dprime1", .key = first, .truth = at_one});
  intervals.push_back({.quantity = "jnd.dprime1",
                       .key = "oddity",
                       .truth = difference_at(kOddityAtOne, kGuessOfThree)});
  return intervals;
}

// --- two conditions of a judgement of performance, and thresholds outside the levels ------------------

/// ln of the ratio of the thresholds of the second condition and the first.
constexpr std::array kLogRatios{0.0, 0.5};

/// The stronger of two, at the levels of `draw_three_surfaces`, in two conditions.
TidyInput draw_two_conditions(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,condition,x,n,k");
  const std::size_t trials = kTrialsForOne * setting.trials / kDifferences.size();
  const std::string number = std::to_string(trials);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = setting.spread * random.normal();
    for (const std::size_t condition : {0U, 1U}) {
      const double alpha = std::exp(own + (condition == 1 ? setting.effect : 0.0) +
                                    0.5 * setting.spread * random.normal());
      for (const double x : kDifferences) {
        std::size_t hits = 0;
        for (std::size_t trial = 0; trial < trials; ++trial) {
          hits += random.uniform() < weibull(x, alpha, 0.5) ? 1 : 0;
        }
        table.add({participant_label(i), std::to_string(condition), number_text(x), number,
                   std::to_string(hits)});
      }
    }
  }
  return std::move(table).as_input();
}

/// What the analysis of a study gives of such choices.
std::vector<Finding> findings_of_two_conditions(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<std::uint64_t> conditions = table.counts("condition");
  const std::vector<double> differences = table.all_numbers("x");
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<std::uint64_t> hits = table.counts("k");
  DiscriminationStudy study{.task = {.is_performance = true, .varied = from_zero()},
                            .conditions = {"first", "second"}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t trial = 0; trial < trials[row]; ++trial) {
      study.trials.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                              .condition = static_cast<std::size_t>(conditions[row]),
                              .value = differences[row],
                              .chose_comparison = trial < hits[row]});
    }
  }
  const DiscriminationResults results(gathered_people(participants), study, false);
  std::vector<Finding> findings = results.means;
  for (const Finding& finding : results.compared) {
    if (finding.quantity.starts_with("ratio.")) findings.push_back(finding);
  }
  return findings;
}

std::vector<CheckedInterval> condition_intervals(const CoverageSetting& setting) {
  return {{.quantity = "ratio.jnd", .key = "second|first", .truth = std::exp(setting.effect)},
          {.quantity = "geomean.jnd", .key = "first", .truth = difference_at(0.75, 0.5)}};
}

// --- comparisons with a standard, with and without lapses --------------------------------------------

constexpr std::array kRatesOfLapses{0.0, 0.02};
constexpr std::array kSixValues{-2.5, -1.5, -0.5, 0.5, 1.5, 2.5};
constexpr double kEqualityOfMean = 0.3;

/// Normal functions with an SD of 1 times that of the participant; ten trials per trial of the design.
TidyInput draw_comparisons(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,x,n,k");
  const std::size_t trials = kTrialsForOne * setting.trials / kSixValues.size();
  const std::string number = std::to_string(trials);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double deviation = std::exp(setting.spread * random.normal());
    for (const double x : kSixValues) {
      const double p = setting.effect + (1.0 - 2.0 * setting.effect) *
                                            normal_below((x - kEqualityOfMean) / deviation);
      std::size_t chosen = 0;
      for (std::size_t trial = 0; trial < trials; ++trial) {
        chosen += random.uniform() < p ? 1 : 0;
      }
      table.add({participant_label(i), number_text(x), number, std::to_string(chosen)});
    }
  }
  return std::move(table).as_input();
}

std::vector<Finding> findings_of_comparisons(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<double> values = table.all_numbers("x");
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<std::uint64_t> chosen = table.counts("k");
  DiscriminationStudy study{.task = {.is_performance = false, .varied = from_zero()},
                            .conditions = {"all"}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t trial = 0; trial < trials[row]; ++trial) {
      study.trials.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                              .value = values[row],
                              .chose_comparison = trial < chosen[row]});
    }
  }
  return DiscriminationResults(gathered_people(participants), study, false).means;
}

std::vector<CheckedInterval> comparison_intervals(const CoverageSetting&) {
  return {{.quantity = "geomean.jnd", .key = "all", .truth = 0.6744897501960817},
          {.quantity = "mean.pse", .key = "all", .truth = kEqualityOfMean}};
}

// --- split counts ------------------------------------------------------------------------------------

constexpr double kGuessOfTwo = 0.5;
constexpr std::array kReplaced{0.5, 1.0};
constexpr std::array kOneParticipant{0.0};
constexpr std::array kComparedValues{-2.0, -1.0, 0.0, 1.0, 2.0};
constexpr double kEquality = 0.3;
constexpr double kQuartile = 0.6744897501960817;

/// Of the responses that would be guesses, 2·min(p, 1 − p), the `replaced` ones are "cannot tell"; half of them would be
/// hits.
ChoiceCount drawn_choices(double p, std::size_t trials, double replaced, Random& random) {
  const double half_unsure = replaced * std::min(p, 1.0 - p);
  ChoiceCount count{.trials = trials};
  for (std::size_t trial = 0; trial < trials; ++trial) {
    const double drawn = random.uniform();
    if (drawn < p - half_unsure) {
      ++count.hits;
    } else if (drawn < p + half_unsure) {
      ++count.unsure;
    }
  }
  return count;
}

void add_split_row(DrawnTable& table, std::string_view judgement, double x,
                   const ChoiceCount& count) {
  table.add({judgement, number_text(x), std::to_string(count.trials), std::to_string(count.hits),
             std::to_string(count.unsure)});
}

TidyInput draw_unforced(const CoverageSetting& setting, Random& random) {
  DrawnTable table("judgement,x,n,k,unsure");
  const std::size_t trials = setting.participants * setting.trials / kDifferences.size();
  for (const double x : kDifferences) {
    const double p = weibull(x, 1.0, kGuessOfTwo);
    add_split_row(table, "performance", x, drawn_choices(p, trials, setting.effect, random));
  }
  for (const double x : kComparedValues) {
    const double p = kLapseRate + (1.0 - 2.0 * kLapseRate) * normal_below(x - kEquality);
    add_split_row(table, "comparison", x, drawn_choices(p, trials, setting.effect, random));
  }
  return std::move(table).as_input();
}

/// What the analysis of a study gives of the counts of a participant, one task for each judgement.
std::vector<Finding> findings_of_unforced(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn judgements = table.all_labels("judgement");
  const std::vector<double> levels = table.all_numbers("x");
  const std::vector<std::uint64_t> trials = table.counts("n");
  const std::vector<std::uint64_t> hits = table.counts("k");
  const std::vector<std::uint64_t> unsure = table.counts("unsure");
  std::vector<Finding> findings{};
  for (std::size_t judgement = 0; judgement < judgements.names.size(); ++judgement) {
    DiscriminationData data{.key = judgements.names[judgement]};
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (judgements.codes[row] != judgement) continue;
      data.hits[levels[row]] = {.hits = hits[row], .trials = trials[row], .unsure = unsure[row]};
    }
    const DiscriminationTask task{.is_performance = data.key == "performance",
                                  .varied = from_zero()};
    const std::vector<Finding> of_task = fit_discrimination(task, std::span(&data, 1)).thresholds;
    findings.insert(findings.end(), of_task.begin(), of_task.end());
  }
  return findings;
}

std::vector<CheckedInterval> unforced_intervals(const CoverageSetting&) {
  return {{.quantity = "jnd",
           .key = "performance",
           .truth = difference_at(kProportionAtThreshold, kGuessOfTwo)},
          {.quantity = "jnd.dprime1",
           .key = "performance",
           .truth = difference_at(normal_below(std::sqrt(0.5)), kGuessOfTwo)},
          {.quantity = "pse", .key = "comparison", .truth = kEquality},
          {.quantity = "jnd", .key = "comparison", .truth = kQuartile}};
}

/// Numbers of trials that differ: 60, 144, 120, 48 and 36.
std::vector<CoverageSetting> unforced_settings() {
  std::vector<CoverageSetting> settings = all_designs(kReplaced, kOneParticipant);
  std::erase_if(settings, [](const CoverageSetting& one) {
    return one.participants == 5 || one.participants == 2;
  });
  return settings;
}

}  // namespace

std::span<const CoveragePart> discrimination_parts() {
  static const auto kOfPlaces = all_designs(kSensitivitiesOfPlaces, kSpreadsOfPlaces);
  static const auto kOfThresholds = all_designs(kNoEffect, kSpreadsOfThresholds);
  static const auto kOfConditions = all_designs(kLogRatios, kSpreadsOfThresholds);
  static const auto kOfComparisons = all_designs(kRatesOfLapses, kSpreadsOfThresholds);
  static const auto kUnforced = unforced_settings();
  static const std::array kParts{
      CoveragePart{.name = "choices_by_place",
                   .model = "the strongest of three (3AFC), which is in each place equally often; "
                            "a participant's preferences for the places are normal",
                   .effect = "d′",
                   .spread = "SD of the preferences",
                   .settings = kOfPlaces,
                   .draw = draw_places,
                   .findings = findings_of_places,
                   .intervals = place_intervals,
                   .tests = place_tests,
                   .tables = 10000},
      CoveragePart{.name = "thresholds_of_three",
                   .model = "3AFC and oddity at five levels, ten trials per trial of the design; "
                            "Weibull function with β = 2 and a lapse rate of 2 %, the logarithm "
                            "of a participant's α is normal; analysed as the choices of a study "
                            "(`fit_discrimination`)",
                   .effect = "always 0",
                   .spread = "SD of ln α",
                   .settings = kOfThresholds,
                   .draw = draw_three_surfaces,
                   .findings = findings_of_three_surfaces,
                   .intervals = three_surface_intervals,
                   .tests = no_tests,
                   .tables = 2000},
      CoveragePart{.name = "compared_thresholds",
                   .model = "two alternatives at five levels in two conditions, ten trials per "
                            "trial of the design in each; Weibull functions with β = 2 and a lapse "
                            "rate of 2 %, the logarithm of a participant's α is normal, with half "
                            "that SD between the conditions; a mean has an interval where no "
                            "threshold is left out",
                   .effect = "ln of the ratio of the conditions",
                   .spread = "SD of ln α",
                   .settings = kOfConditions,
                   .draw = draw_two_conditions,
                   .findings = findings_of_two_conditions,
                   .intervals = condition_intervals,
                   .tests = no_tests,
                   .tables = 2000},
      CoveragePart{.name = "comparison_thresholds",
                   .model = "comparison with a standard at six levels, ten trials per trial of the "
                            "design; normal function with an SD of 1 times that of the "
                            "participant; fitted with lapse rates of 2 %",
                   .effect = "lapse rate of each of the two responses",
                   .spread = "SD of ln of the participants' SDs",
                   .settings = kOfComparisons,
                   .draw = draw_comparisons,
                   .findings = findings_of_comparisons,
                   .intervals = comparison_intervals,
                   .tests = no_tests,
                   .tables = 2000},
      CoveragePart{.name = "unforced_thresholds",
                   .model = "one participant with as many trials as the design has in all, at five "
                            "levels: the stronger of two (Weibull function as in "
                            "`thresholds_of_three`) and a comparison with a standard (cumulative "
                            "normal function); \"cannot tell\" replaces guesses; analysed by "
                            "`fit_discrimination`, 400 resamples for each interval",
                   .effect = "proportion of guesses that are replaced",
                   .spread = "one participant",
                   .settings = kUnforced,
                   .draw = draw_unforced,
                   .findings = findings_of_unforced,
                   .intervals = unforced_intervals,
                   .tests = no_tests,
                   .tables = 2000}};
  return kParts;
}

}  // namespace asperity
