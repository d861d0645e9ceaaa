// Sensitivity from counted responses, and the ROC of ratings.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/choices/rating_roc.h"
#include "analysis/tests/participant_bootstrap.h"
#include "app/findings/outcome/found_numbers.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

// --- sensitivity -------------------------------------------------------------------------------------

constexpr std::array kSensitivities{1.0, 2.0};
constexpr std::array kSensitivitySpreads{0.0, 0.3};
/// Presentations of each kind for one trial of the design: d′ from fewer is corrected more than it is measured.
constexpr std::size_t kTenfold = 10;

double observation(double mean, Random& random) { return mean + random.normal(); }

/// Whether the observer gives the response that the design counts, in one presentation: simulated from the observations,
/// not from the formulas that the analysis inverts.
struct SimulatedDesign {
  const char* name = "";
  bool (*signal)(double dprime, Random& random) = nullptr;
  bool (*noise)(double dprime, Random& random) = nullptr;
};

bool yes_to_signal(double dprime, Random& random) {
  return observation(dprime, random) > 0.5 * dprime;
}
bool yes_to_noise(double dprime, Random& random) { return observation(0.0, random) > 0.5 * dprime; }

bool first_for_first(double dprime, Random& random) {
  return observation(dprime, random) > observation(0.0, random);
}
bool first_for_second(double dprime, Random& random) {
  return observation(0.0, random) > observation(dprime, random);
}

/// The differencing rule: "different" where the two observations are further apart than a criterion.
constexpr double kFurtherApart = 1.5;
bool different(double first, double second) { return std::abs(first - second) > kFurtherApart; }
bool different_of_different(double dprime, Random& random) {
  return different(observation(dprime, random), observation(0.0, random));
}
bool different_of_same(double dprime, Random& random) {
  const double mean = random.uniform() < 0.5 ? dprime : 0.0;
  return different(observation(mean, random), observation(mean, random));
}

/// The differencing rule: X is the reference that its observation is closer to.
bool closer_to_first(double first, double second, double x) {
  return std::abs(x - first) < std::abs(x - second);
}
bool first_of_abx_first(double dprime, Random& random) {
  const double first = observation(dprime, random);
  const double second = observation(0.0, random);
  return closer_to_first(first, second, observation(dprime, random));
}
bool first_of_abx_second(double dprime, Random& random) {
  const double first = observation(dprime, random);
  const double second = observation(0.0, random);
  return closer_to_first(first, second, observation(0.0, random));
}

constexpr std::array kSimulatedDesigns{
    SimulatedDesign{"yesno", yes_to_signal, yes_to_noise},
    SimulatedDesign{"2afc", first_for_first, first_for_second},
    SimulatedDesign{"samediff", different_of_different, different_of_same},
    SimulatedDesign{"abx", first_of_abx_first, first_of_abx_second}};

std::string counted(bool (*response)(double, Random&), double dprime, std::size_t presentations,
                    Random& random) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < presentations; ++i) count += response(dprime, random) ? 1 : 0;
  return std::to_string(count);
}

TidyInput draw_sensitivities(const CoverageSetting& setting, Random& random) {
  DrawnTable table("id,subject,design,signal_yes,signal_n,noise_yes,noise_n");
  const std::size_t presentations = kTenfold * setting.trials;
  const std::string number = std::to_string(presentations);
  for (const SimulatedDesign& design : kSimulatedDesigns) {
    for (std::size_t i = 0; i < setting.participants; ++i) {
      const double own = setting.effect + setting.spread * random.normal();
      const std::string yes = counted(design.signal, own, presentations, random);
      table.add({design.name, participant_label(i), design.name, yes, number,
                 counted(design.noise, own, presentations, random), number});
    }
  }
  return std::move(table).as_input();
}

/// The mean over participants; and, where they are equal, d′ of the first of them.
std::vector<CheckedInterval> sensitivity_intervals(const CoverageSetting& setting) {
  std::vector<CheckedInterval> intervals{};
  for (const SimulatedDesign& design : kSimulatedDesigns) {
    const std::string name = design.name;
    intervals.push_back({.quantity = "dprime.mean", .key = name, .truth = setting.effect});
    if (setting.spread > 0.0) continue;
    const bool has_rules = name == "samediff" || name == "abx";
    intervals.push_back({.quantity = has_rules ? "dprime.diff.loglinear" : "dprime.loglinear",
                         .key = name + '|' + participant_label(0),
                         .truth = setting.effect});
  }
  return intervals;
}

// --- choices among three -----------------------------------------------------------------------------

bool finds_strongest(double dprime, Random& random) {
  const double signal = observation(dprime, random);
  return signal > std::max(observation(0.0, random), observation(0.0, random));
}

/// The differencing rule: the two closest observations are of equal stimuli. The different stimulus is as often the
/// stronger one as the weaker one, which has the same probabilities.
bool finds_odd(double dprime, Random& random) {
  const double odd = observation(dprime, random);
  const double one = observation(0.0, random);
  const double other = observation(0.0, random);
  const double apart = std::abs(one - other);
  return apart < std::abs(odd - one) && apart < std::abs(odd - other);
}

TidyInput draw_choices_of_three(const CoverageSetting& setting, Random& random) {
  DrawnTable table("id,design,signal_yes,signal_n,m");
  const std::size_t trials = setting.participants * setting.trials;
  const std::string number = std::to_string(trials);
  table.add(
      {"mafc", "mafc", counted(finds_strongest, setting.effect, trials, random), number, "3"});
  table.add({"oddity", "oddity", counted(finds_odd, setting.effect, trials, random), number, ""});
  return std::move(table).as_input();
}

std::vector<CheckedInterval> choice_intervals(const CoverageSetting& setting) {
  return {{.quantity = "dprime", .key = "mafc", .truth = setting.effect},
          {.quantity = "dprime", .key = "oddity", .truth = setting.effect}};
}

// --- ROC of ratings ----------------------------------------------------------------------------------

constexpr std::array kOnlyOne{0.0};
/// Distances of the criteria from the middle between noise and signal: five ratings.
constexpr std::array kCriteria{-1.0, -0.3, 0.3, 1.0};

std::size_t rating_of(double observed, double dprime) {
  return static_cast<std::size_t>(
      std::count_if(kCriteria.begin(), kCriteria.end(),
                    [&](double criterion) { return observed > criterion + 0.5 * dprime; }));
}

TidyInput draw_ratings_of_signal(const CoverageSetting& setting, Random& random) {
  constexpr std::size_t kRatings = kCriteria.size() + 1;
  std::array<std::array<std::size_t, 2>, kRatings> counts{};
  for (std::size_t i = 0; i < setting.participants * setting.trials; ++i) {
    ++counts[rating_of(observation(0.0, random), setting.effect)][0];
    ++counts[rating_of(observation(setting.effect, random), setting.effect)][1];
  }
  DrawnTable table("condition,rating,noise,signal");
  for (std::size_t rating = 0; rating < kRatings; ++rating) {
    table.add({"a", std::to_string(rating + 1), std::to_string(counts[rating][0]),
               std::to_string(counts[rating][1])});
  }
  return std::move(table).as_input();
}

double below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

/// P(signal rated higher) + ½·P(equal ratings), from the probabilities of the ratings by criteria that are shifted.
double area_of_ratings(double dprime, double shift = 0.0) {
  double area = 0.0;
  double noise_before = 0.0;  // P(rating of noise is lower)
  double signal_before = 0.0;
  for (std::size_t i = 0; i <= kCriteria.size(); ++i) {
    const bool is_last = i == kCriteria.size();
    const double noise = is_last ? 1.0 : below(kCriteria[i] + shift + 0.5 * dprime);
    const double signal = is_last ? 1.0 : below(kCriteria[i] + shift - 0.5 * dprime);
    area += (signal - signal_before) * 0.5 * (noise + noise_before);
    noise_before = noise;
    signal_before = signal;
  }
  return area;
}

std::vector<CheckedInterval> roc_intervals(const CoverageSetting& setting) {
  return {{.quantity = "auc",
           .key = "a",
           .truth = area_of_ratings(setting.effect),
           .lower = "auc.lower",
           .upper = "auc.upper"}};
}

std::vector<CheckedTest> roc_tests(const CoverageSetting&) {
  return {{.quantity = "lr.equal.variance.p", .key = "a"}};
}

// --- areas of participants whose criteria differ -------------------------------------------------------

constexpr std::array kSpreadsOfCriteria{0.0, 0.7};

/// Ten presentations of each kind for one trial of the design; all criteria of a participant are shifted by the same amount.
TidyInput draw_areas(const CoverageSetting& setting, Random& random) {
  constexpr std::size_t kRatings = kCriteria.size() + 1;
  DrawnTable table("condition,subject,rating,noise,signal");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double shift = setting.spread * random.normal();
    std::array<std::array<std::size_t, 2>, kRatings> counts{};
    for (std::size_t trial = 0; trial < kTenfold * setting.trials; ++trial) {
      ++counts[rating_of(observation(0.0, random) - shift, setting.effect)][0];
      ++counts[rating_of(observation(setting.effect, random) - shift, setting.effect)][1];
    }
    for (std::size_t rating = 0; rating < kRatings; ++rating) {
      table.add({"a", participant_label(i), std::to_string(rating + 1),
                 std::to_string(counts[rating][0]), std::to_string(counts[rating][1])});
    }
  }
  return std::move(table).as_input();
}

using RatingsOfParticipants = std::vector<std::vector<RatingCount>>;

RatingsOfParticipants ratings_of_participants(const TidyTable& table) {
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<std::uint64_t> noise = table.counts("noise");
  const std::vector<std::uint64_t> signal = table.counts("signal");
  RatingsOfParticipants ratings(participants.names.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    ratings[participants.codes[row]].push_back({.noise = noise[row], .signal = signal[row]});
  }
  return ratings;
}

std::vector<RatingCount> sum_of_ratings(const RatingsOfParticipants& ratings,
                                        std::span<const std::size_t> participants) {
  std::vector<RatingCount> sum(kCriteria.size() + 1);
  for (const std::size_t participant : participants) {
    for (std::size_t rating = 0; rating < sum.size(); ++rating) {
      sum[rating].noise += ratings[participant][rating].noise;
      sum[rating].signal += ratings[participant][rating].signal;
    }
  }
  return sum;
}

/// Expanded percentiles of a bootstrap over the participants, of the fitted area of their ratings together.
std::optional<ConfidenceInterval> bootstrapped_area(const RatingsOfParticipants& ratings) {
  const auto area_of = [&](std::span<const std::size_t> participants) -> std::optional<double> {
    const std::optional<NormalRoc> fit =
        fit_roc(sum_of_ratings(ratings, participants), RocVariance::free);
    return fit ? std::optional<double>(fit->area()) : std::nullopt;
  };
  return bootstrap_participants({.participants = ratings.size()}, area_of).interval;
}

/// DeLong's, of the ratings of all participants as if they were those of one.
std::optional<ConfidenceInterval> area_of_all(const RatingsOfParticipants& ratings) {
  std::vector<std::size_t> all(ratings.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::vector<RatingCount> sum = sum_of_ratings(ratings, all);
  DrawnTable table("condition,rating,noise,signal");
  for (std::size_t rating = 0; rating < sum.size(); ++rating) {
    table.add({"a", std::to_string(rating + 1), std::to_string(sum[rating].noise),
               std::to_string(sum[rating].signal)});
  }
  const std::vector<Finding> findings = roc_findings(std::move(table).as_input());
  const Finding* const area = FoundNumbers(findings).find("auc", "a");
  if (area == nullptr || !area->low || !area->high) return std::nullopt;
  return ConfidenceInterval{.low = *area->low, .high = *area->high};
}

/// The family gives the areas of all participants together no interval, and states the coverage that these have.
std::vector<Finding> findings_of_areas(const TidyInput& input) {
  const RatingsOfParticipants ratings = ratings_of_participants(input.table());
  std::vector<Finding> findings = roc_findings(input);
  for (Finding& finding : findings) {
    std::optional<ConfidenceInterval> interval{};
    if (finding.quantity == "uv.az") interval = bootstrapped_area(ratings);
    if (finding.quantity == "auc") interval = area_of_all(ratings);
    if (!interval) continue;
    finding.low = interval->low;
    finding.high = interval->high;
  }
  return findings;
}

/// The mean over the shifts of the criteria.
double mean_area_of_ratings(const CoverageSetting& setting) {
  return mean_over_normal(
      [&setting](double z) { return area_of_ratings(setting.effect, setting.spread * z); });
}

std::vector<CheckedInterval> area_intervals(const CoverageSetting& setting) {
  const double fitted = below(setting.effect / std::sqrt(2.0));
  const double of_ratings = mean_area_of_ratings(setting);
  return {{.quantity = "uv.az.mean", .key = "a", .truth = fitted},
          {.quantity = "uv.az", .key = "a", .truth = fitted},
          {.quantity = "auc.mean", .key = "a", .truth = of_ratings},
          {.quantity = "auc", .key = "a", .truth = of_ratings}};
}

}  // namespace

std::span<const CoveragePart> detection_parts() {
  static const auto kOfCriteria = all_designs(kSensitivities, kSpreadsOfCriteria);
  static const auto kOfSensitivities = all_designs(kSensitivities, kSensitivitySpreads);
  static const auto kOfOne = all_designs(kSensitivities, kOnlyOne);
  static const std::array kParts{
      CoveragePart{.name = "sensitivity",
                   .model = "yes/no, 2AFC, same–different and ABX (both by the differencing rule), "
                            "ten presentations of each of the two kinds per trial of the design; "
                            "a participant's d′ is normal, and there is no bias",
                   .effect = "mean d′",
                   .spread = "SD of d′",
                   .settings = kOfSensitivities,
                   .draw = draw_sensitivities,
                   .findings = dprime_findings,
                   .intervals = sensitivity_intervals,
                   .tests = no_tests,
                   .tables = 10000},
      CoveragePart{.name = "choices_of_three",
                   .model = "one participant with as many trials as the design has in all: the "
                            "strongest of three (3AFC), and the different one of three (oddity, "
                            "differencing rule)",
                   .effect = "d′",
                   .spread = "one participant",
                   .settings = kOfOne,
                   .draw = draw_choices_of_three,
                   .findings = dprime_findings,
                   .intervals = choice_intervals,
                   .tests = no_tests,
                   .tables = 10000},
      CoveragePart{.name = "ratings_of_signal",
                   .model = "one participant rates as many signals, and as many presentations of "
                            "noise, as the design has trials in all, with five ratings; both "
                            "distributions are normal with a variance of 1",
                   .effect = "d′",
                   .spread = "one participant",
                   .settings = kOfOne,
                   .draw = draw_ratings_of_signal,
                   .findings = roc_findings,
                   .intervals = roc_intervals,
                   .tests = roc_tests,
                   .tables = 10000},
      CoveragePart{.name = "areas_of_participants",
                   .model = "each participant rates ten signals, and ten presentations of noise, "
                            "for one trial of the design, with five ratings; both distributions "
                            "are normal with a variance of 1, and the criteria of a participant "
                            "are shifted together",
                   .effect = "d′",
                   .spread = "SD of the shifts",
                   .settings = kOfCriteria,
                   .draw = draw_areas,
                   .findings = findings_of_areas,
                   .intervals = area_intervals,
                   .tests = no_tests,
                   .tables = 1000}};
  return kParts;
}

}  // namespace asperity
