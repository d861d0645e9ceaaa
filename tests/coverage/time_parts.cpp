// Response times by condition, and the change of times and of proportions correct over the trials.

#include <array>
#include <cmath>

#include "analysis/numbers/number_text.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

constexpr double kLogTime = 1.0;    // mean of the normal part of ln t, t in seconds
constexpr double kTimeNoise = 0.3;  // SD of that part within a participant

/// The part of ln t that makes its distribution skewed: exponential with this mean.
double skewed_part(double mean, Random& random) { return -mean * std::log(1.0 - random.uniform()); }

// --- response times by condition ---------------------------------------------------------------------

constexpr std::array kSkews{0.0, 0.3, 1.0};
constexpr std::array kTimeSpreads{0.0, 0.4};
constexpr double kDelay = 0.2;  // of the second texture, on average

/// Every other trial has the second texture; one in twenty has no time.
TidyInput draw_times(const CoverageSetting& setting, Random& random) {
  constexpr double kUntimed = 0.05;
  DrawnTable table("subject,texture,time_s");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double level = kLogTime + setting.spread * random.normal();
    const double delay = kDelay + 0.5 * setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const bool is_second = (trial + i) % 2 == 1;
      const double logarithm = level + (is_second ? delay : 0.0) + kTimeNoise * random.normal() +
                               skewed_part(setting.effect, random);
      const bool is_timed = random.uniform() >= kUntimed;
      table.add({participant_label(i), is_second ? "cloth" : "wood",
                 is_timed ? number_text(std::exp(logarithm)) : ""});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.add("factors", R"({"texture": ["wood", "cloth"]})");
  return input;
}

std::vector<CheckedInterval> time_intervals(const CoverageSetting& setting) {
  // Half of all trials have each texture, also where a participant has one more of one.
  const double logarithm = kLogTime + setting.effect;
  return {{.quantity = "geomean", .truth = std::exp(logarithm + 0.5 * kDelay)},
          {.quantity = "geomean", .key = "texture=wood", .truth = std::exp(logarithm)},
          {.quantity = "geomean", .key = "texture=cloth", .truth = std::exp(logarithm + kDelay)}};
}

// --- response times over the trials ------------------------------------------------------------------

constexpr std::array kPractice{0.0, 0.1, 0.3};
constexpr std::array kPracticeSpreads{0.0, 0.1};
constexpr double kLevelSpread = 0.3;  // SD of the participants' levels
constexpr double kSkew = 0.3;

/// The power law of practice: ln t falls with the logarithm of the number of the trial.
TidyInput draw_practice(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,trial,time_s");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double level = kLogTime + kLevelSpread * random.normal();
    const double exponent = setting.effect + setting.spread * random.normal();
    for (std::size_t trial = 1; trial <= setting.trials; ++trial) {
      const double logarithm = level - exponent * std::log(static_cast<double>(trial)) +
                               kTimeNoise * random.normal() + skewed_part(kSkew, random);
      table.add({participant_label(i), std::to_string(trial), number_text(std::exp(logarithm))});
    }
  }
  return std::move(table).as_input();
}

/// The mean of ln t over the trials `first` to `last`.
double mean_log_time(const CoverageSetting& setting, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t trial = first; trial <= last; ++trial) {
    sum += std::log(static_cast<double>(trial));
  }
  return kLogTime + kSkew - setting.effect * sum / static_cast<double>(last - first + 1);
}

std::vector<CheckedInterval> practice_intervals(const CoverageSetting& setting) {
  const std::size_t half = setting.trials / 2;
  const double first = mean_log_time(setting, 1, half);
  const double second = mean_log_time(setting, setting.trials - half + 1, setting.trials);
  // The line through the expected logarithms; Σ(i − (n + 1)/2)² = n(n² − 1)/12.
  const auto n = static_cast<double>(setting.trials);
  double products = 0.0;
  for (std::size_t trial = 1; trial <= setting.trials; ++trial) {
    products +=
        (static_cast<double>(trial) - 0.5 * (n + 1.0)) * mean_log_time(setting, trial, trial);
  }
  const double slope = 12.0 * products / (n * (n * n - 1.0));
  constexpr std::size_t kMostBlocks = 12;
  const bool has_pairs = setting.trials > kMostBlocks;
  return {{.quantity = "half.first", .truth = std::exp(first)},
          {.quantity = "half.second", .truth = std::exp(second)},
          {.quantity = "half.ratio", .truth = std::exp(second - first)},
          {.quantity = "slope.ratio", .truth = std::exp(10.0 * slope)},
          {.quantity = "block",
           .key = has_pairs ? "1-2" : "1",
           .truth = std::exp(mean_log_time(setting, 1, has_pairs ? 2 : 1))}};
}

// --- proportions correct over the trials -------------------------------------------------------------

constexpr std::array kFirstProportions{0.05, 0.25, 0.5, 0.71, 0.87, 0.95, 0.98};
constexpr std::array kLogitSpreads{0.0, 1.0};
constexpr double kGain = 1.0;  // of the logit, from the first trial to the last

double gain_at(const CoverageSetting& setting, std::size_t trial) {
  return kGain * static_cast<double>(trial) / static_cast<double>(setting.trials - 1);
}

TidyInput draw_learning(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,trial,correct,items");
  const double mu = mu_of_mean(setting.effect, setting.spread);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = mu + setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const double p = 1.0 / (1.0 + std::exp(-own - gain_at(setting, trial)));
      table.add(
          {participant_label(i), std::to_string(trial + 1), random.uniform() < p ? "1" : "0", "1"});
    }
  }
  return std::move(table).as_input();
}

std::vector<CheckedInterval> learning_intervals(const CoverageSetting& setting) {
  const double mu = mu_of_mean(setting.effect, setting.spread);
  const std::size_t half = setting.trials / 2;
  double first = 0.0;
  double second = 0.0;
  for (std::size_t i = 0; i < half; ++i) {
    const std::size_t later = setting.trials - 1 - i;
    first += mean_of_logistic(mu + gain_at(setting, i), setting.spread);
    second += mean_of_logistic(mu + gain_at(setting, later), setting.spread);
  }
  first /= static_cast<double>(half);
  second /= static_cast<double>(half);
  return {{.quantity = "half.first", .truth = first},
          {.quantity = "half.second", .truth = second},
          {.quantity = "half.difference", .truth = second - first}};
}

}  // namespace

std::span<const CoveragePart> time_parts() {
  static const auto kOfSkews = all_designs(kSkews, kTimeSpreads);
  static const auto kOfPractice = all_designs(kPractice, kPracticeSpreads);
  static const auto kOfFirstProportions = all_designs(kFirstProportions, kLogitSpreads);
  static const std::array kParts{
      CoveragePart{.name = "response_times",
                   .model =
                       "two textures in turn, one trial in twenty without a response time; the "
                       "logarithm of a response time is the sum of the participant's level, the "
                       "participant's delay for one texture (both normal), and an ex-Gaussian "
                       "residual",
                   .effect = "mean of the exponential component",
                   .spread = "SD of the levels, twice that of the delays",
                   .settings = kOfSkews,
                   .draw = draw_times,
                   .findings = response_times_findings,
                   .intervals = time_intervals,
                   .tests = no_tests},
      CoveragePart{.name = "learning_times",
                   .model = "the power law of practice: the logarithm of a response time falls "
                            "with that of the trial number by a participant's normal exponent, "
                            "with an ex-Gaussian residual; the participants' levels always "
                            "differ",
                   .effect = "mean exponent",
                   .spread = "SD of the exponents",
                   .settings = kOfPractice,
                   .draw = draw_practice,
                   .findings = learning_findings,
                   .intervals = practice_intervals,
                   .tests = no_tests},
      CoveragePart{.name = "learning_correct",
                   .model = "correct or incorrect responses; a participant's logit is normal and "
                            "rises by 1 from the first trial to the last",
                   .effect = "mean proportion correct in the first trial",
                   .spread = "SD of the logits",
                   .settings = kOfFirstProportions,
                   .draw = draw_learning,
                   .findings = learning_findings,
                   .intervals = learning_intervals,
                   .tests = no_tests}};
  return kParts;
}

}  // namespace asperity
