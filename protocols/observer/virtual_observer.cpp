// Implements judgements by distance between features.

#include "protocols/observer/virtual_observer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>

#include "analysis/choices/decision_rules.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "analysis/signals/roughness.h"

namespace asperity {

namespace {

constexpr double kUnitCompliance_m_per_N = 1e-3;
/// Where nothing was felt: 100 N/mm, firmer than any force-feedback device.
constexpr double kLeastCompliance_m_per_N = 1e-5;

double evidence(const ForceFeatures& felt, const ForceFeatures& expected) {
  return -0.5 * squared_distance(felt, expected);
}

/// To so many significant digits.
double rounded_estimate(double exact, int digits) {
  // Both operands are whole numbers, which yields 0.3 and not 0.30000000000000004.
  const int shift = digits - 1 - static_cast<int>(std::floor(std::log10(exact)));
  const double scale = std::pow(10.0, std::abs(shift));
  return shift >= 0 ? std::round(exact * scale) / scale : std::round(exact / scale) * scale;
}

void require(bool holds, std::string_view what) {
  if (!holds) throw std::invalid_argument(std::string(what));
}

}  // namespace

LineHabit line_habit_of(Random person) {
  constexpr double kSmallest = 0.5;
  constexpr double kRange = 1.0;
  return {.modulus = kSmallest + kRange * person.uniform()};
}

NumberHabit number_habit_of(Random person) {
  constexpr double kSmallest = 10.0;
  constexpr double kLargest = 1000.0;
  NumberHabit habit{};
  habit.modulus = kSmallest * std::pow(kLargest / kSmallest, person.uniform());
  habit.digits = person.below(2) == 0 ? 1 : 2;
  return habit;
}

VirtualObserver::VirtualObserver(const ObserverDeclaration& declaration, Random random)
    : declaration_(declaration), random_(random) {
  require(declaration.feature_noise >= 0.0,
          "feature_noise is " + number_text(declaration.feature_noise) + "; it must be at least 0");
  require(declaration.lapse >= 0.0 && declaration.lapse <= 1.0,
          "lapse is " + number_text(declaration.lapse) + "; it must be from 0 to 1");
}

bool VirtualObserver::lapses() {
  // Drawn also for a deaf observer, so that the subsequent random numbers are the same for both settings.
  const bool by_chance = random_.uniform() < declaration_.lapse;
  return declaration_.deaf || by_chance;
}

ForceFeatures VirtualObserver::perceived(const ForceFeatures& felt) {
  // The distance divides each band by the number of bands; equal noise in every scaled feature therefore corresponds to
  // larger noise in an unscaled band, by the square root of that number.
  const double of_band = std::sqrt(static_cast<double>(kFeatureBands));
  ForceFeatures result = felt;
  for (double& band : result.spectrum) {
    band += of_band * declaration_.feature_noise * random_.normal();
  }
  result.size += declaration_.feature_noise * random_.normal();
  result.roughness += declaration_.feature_noise * random_.normal();
  return result;
}

std::size_t VirtualObserver::best_of(std::span<const double> evidences) {
  const double best = *std::max_element(evidences.begin(), evidences.end());
  const auto ties =
      static_cast<std::uint64_t>(std::count(evidences.begin(), evidences.end(), best));
  std::uint64_t skip = random_.below(ties);
  for (std::size_t i = 0; i < evidences.size(); ++i) {
    if (evidences[i] == best && skip-- == 0) return i;
  }
  return 0;  // not reached: one of the ties is drawn
}

std::size_t VirtualObserver::select(std::span<const ForceFeatures> felt,
                                    const ForceFeatures& expected) {
  require(!felt.empty(), "felt is empty; a selection needs at least one felt surface");
  std::vector<double> evidences{};
  for (const ForceFeatures& each : felt) evidences.push_back(evidence(perceived(each), expected));
  evidences.front() += declaration_.position_bias;
  return lapses() ? guess(felt.size()) : best_of(evidences);
}

std::size_t VirtualObserver::recognise(const ForceFeatures& felt,
                                       std::span<const ForceFeatures> expected) {
  require(!expected.empty(), "expected is empty; a recognition needs at least one expectation");
  const ForceFeatures noisy = perceived(felt);
  std::vector<double> evidences{};
  for (const ForceFeatures& each : expected) evidences.push_back(evidence(noisy, each));
  evidences.front() += declaration_.position_bias;
  return lapses() ? guess(expected.size()) : best_of(evidences);
}

std::vector<std::size_t> VirtualObserver::match(std::span<const ForceFeatures> felt,
                                                std::span<const ForceFeatures> expected) {
  constexpr std::size_t kMost = 8;  // all 8! = 40 320 assignments are evaluated
  require(!felt.empty() && felt.size() == expected.size() && felt.size() <= kMost,
          "the numbers of entries of felt and expected are " + std::to_string(felt.size()) +
              " and " + std::to_string(expected.size()) + "; they must be equal and from 1 to 8");
  const std::size_t n = felt.size();
  std::vector<ForceFeatures> noisy{};
  for (const ForceFeatures& each : felt) noisy.push_back(perceived(each));
  // The first permutation is random, so that ties between assignments are broken at random.
  std::vector<std::size_t> options(n);
  std::iota(options.begin(), options.end(), std::size_t{0});
  random_.shuffle(std::span<std::size_t>(options));
  if (lapses()) return options;
  std::vector<std::size_t> places(n);
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::vector<std::size_t> best = options;
  double best_sum = -std::numeric_limits<double>::infinity();
  do {
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = options[places[i]];
      sum += evidence(noisy[i], expected[j]);
      if (i == 0 && j == 0) sum += declaration_.position_bias;
    }
    if (sum > best_sum) {
      best_sum = sum;
      for (std::size_t i = 0; i < n; ++i) best[i] = options[places[i]];
    }
  } while (std::next_permutation(places.begin(), places.end()));
  return best;
}

std::optional<double> VirtualObserver::difference(const ForceFeatures& first,
                                                  const ForceFeatures& second) {
  const ForceFeatures one = perceived(first);
  const ForceFeatures other = perceived(second);
  if (lapses()) return std::nullopt;
  return std::sqrt(squared_distance(one, other));
}

double judged_magnitude(const ForceFeatures& felt, ObserverDeclaration::MagnitudeOf what) {
  using MagnitudeOf = ObserverDeclaration::MagnitudeOf;
  switch (what) {
    case MagnitudeOf::lateral_force:
      return felt.roughness;
    case MagnitudeOf::normal_force:
      return felt.size;
    case MagnitudeOf::held_tool: {
      const double threshold_m_per_s2 = kHeldTool.acceleration_m_per_s2() / std::numbers::sqrt2;
      return std::log(std::hypot(felt.shaking_m_per_s2, threshold_m_per_s2));
    }
    case MagnitudeOf::compliance:
      return std::log(std::max(felt.compliance_m_per_N, kLeastCompliance_m_per_N) /
                      kUnitCompliance_m_per_N);
  }
  throw std::logic_error(
      "the MagnitudeOf is unknown; it must be lateral_force, normal_force, held_tool or "
      "compliance");
}

double distinguished_proportion(const ObserverDeclaration& observer, double difference) {
  if (observer.deaf || difference == 0.0) return 0.5;
  const double by_judgement =
      observer.feature_noise == 0.0
          ? 1.0
          : normal_below(difference / (std::numbers::sqrt2 * observer.feature_noise));
  return 0.5 * observer.lapse + (1.0 - observer.lapse) * by_judgement;
}

double correct_proportion(const ObserverDeclaration& observer, double difference,
                          const DiscriminationDesign& design) {
  if (!design.is_choice_of_three()) return distinguished_proportion(observer, difference);
  const double guess = design.guess_rate();
  if (observer.deaf || difference == 0.0) return guess;
  double by_judgement = 1.0;
  if (observer.feature_noise > 0.0) {
    const double dprime = difference / observer.feature_noise;
    by_judgement = design.asks_for_odd_one
                       ? Oddity{.rule = DecisionRule::differencing}.proportion(dprime)
                       : ForcedChoice{.alternatives = design.surfaces()}.share(dprime);
  }
  return observer.lapse * guess + (1.0 - observer.lapse) * by_judgement;
}

double VirtualObserver::log_magnitude(const ForceFeatures& felt) {
  using MagnitudeOf = ObserverDeclaration::MagnitudeOf;
  const bool is_of_a_spectrum = declaration_.magnitude_of == MagnitudeOf::lateral_force ||
                                declaration_.magnitude_of == MagnitudeOf::normal_force;
  if (is_of_a_spectrum) {
    return judged_magnitude(perceived(felt), declaration_.magnitude_of);
  }
  return judged_magnitude(felt, declaration_.magnitude_of) +
         declaration_.feature_noise * random_.normal();
}

std::optional<std::size_t> VirtualObserver::compare(const ForceFeatures& first,
                                                    const ForceFeatures& second,
                                                    double least_difference) {
  const double sign = declaration_.discrimination.magnitude_decreases ? -1.0 : 1.0;
  const double of_first = sign * log_magnitude(first) + declaration_.position_bias;
  const double of_second = sign * log_magnitude(second);
  if (lapses_in_decision()) return guess(2);
  decide(std::abs(of_first - of_second), 2);
  if (std::abs(of_first - of_second) < least_difference) return std::nullopt;
  const std::array<double, 2> magnitudes{of_first, of_second};
  return best_of(magnitudes);
}

std::size_t VirtualObserver::most_extreme(std::span<const ForceFeatures> felt, Extreme which) {
  require(!felt.empty(), "felt is empty; a choice needs at least one felt surface");
  const bool is_reversed =
      declaration_.discrimination.magnitude_decreases != (which == Extreme::smallest);
  std::vector<double> evidences{};
  for (const ForceFeatures& each : felt) {
    evidences.push_back((is_reversed ? -1.0 : 1.0) * log_magnitude(each));
  }
  evidences.front() += declaration_.position_bias;
  return lapses() ? guess(felt.size()) : best_of(evidences);
}

std::size_t VirtualObserver::odd_one(std::span<const ForceFeatures> felt) {
  require(felt.size() >= 3, "felt has " + std::to_string(felt.size()) +
                                " surfaces; an odd one needs at least two others");
  std::vector<double> magnitudes{};
  for (const ForceFeatures& each : felt) magnitudes.push_back(log_magnitude(each));
  const double mean = std::accumulate(magnitudes.begin(), magnitudes.end(), 0.0) /
                      static_cast<double>(magnitudes.size());
  std::vector<double> distances{};
  for (const double magnitude : magnitudes) distances.push_back(std::abs(magnitude - mean));
  distances.front() += declaration_.position_bias;
  return lapses() ? guess(felt.size()) : best_of(distances);
}

bool VirtualObserver::exceeds(const ForceFeatures& felt, double log_criterion) {
  const double judged = log_magnitude(felt);
  if (lapses_in_decision()) return guess(2) == 0;
  decide(std::abs(judged - log_criterion), 1);
  return judged > log_criterion;
}

bool VirtualObserver::differ(const ForceFeatures& first, const ForceFeatures& second,
                             double least_difference) {
  const double of_first = log_magnitude(first);
  const double of_second = log_magnitude(second);
  if (lapses_in_decision()) return guess(2) == 0;
  const double difference = std::abs(of_first - of_second);
  decide(std::abs(difference - least_difference), 2);
  return difference >= least_difference;
}

bool VirtualObserver::lapses_in_decision() {
  certainty_.reset();
  return lapses();
}

void VirtualObserver::decide(double distance, int magnitudes) {
  const double deviation = declaration_.feature_noise * std::sqrt(static_cast<double>(magnitudes));
  if (distance == 0.0 || deviation == 0.0) {
    certainty_ = distance == 0.0 ? 0.0 : 1.0;
    return;
  }
  certainty_ = 1.0 - 2.0 * normal_below(-distance / deviation);
}

double VirtualObserver::relative_estimate(double judged) {
  const double guessed = random_.normal();
  return std::exp(lapses() ? guessed : declaration_.magnitude.exponent * judged);
}

double VirtualObserver::estimate(const ForceFeatures& felt, const NumberHabit& habit) {
  return rounded_estimate(habit.modulus * relative_estimate(log_magnitude(felt)), habit.digits);
}

double VirtualObserver::estimate(const ForceFeatures& felt, const ForceFeatures& standard,
                                 const NumberHabit& habit) {
  const double of_standard = log_magnitude(standard);
  return rounded_estimate(habit.modulus * relative_estimate(log_magnitude(felt) - of_standard),
                          habit.digits);
}

int VirtualObserver::draw_line(const ForceFeatures& felt, const LineHabit& habit, int steps) {
  require(steps > 0, "steps is 0; a line needs at least one step");
  const double proportion = habit.modulus * relative_estimate(log_magnitude(felt));
  // Limited first: the estimate may exceed the range of whole numbers.
  return std::max(1, static_cast<int>(std::lround(std::min(proportion, 1.0) * steps)));
}

std::size_t VirtualObserver::guess(std::size_t options) {
  require(options > 0, "options is 0; a guess needs at least one option");
  return static_cast<std::size_t>(random_.below(options));
}

double VirtualObserver::response_time_s() {
  // Half the sum of two squared normal numbers is exponential: a skewed distribution of times without a logarithm.
  constexpr double kFastest_s = 0.6;
  constexpr double kMeanExtra_s = 1.2;
  const double a = random_.normal();
  const double b = random_.normal();
  return kFastest_s + kMeanExtra_s * 0.5 * (a * a + b * b);
}

}  // namespace asperity
