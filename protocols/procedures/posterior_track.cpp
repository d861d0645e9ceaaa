// Limits the table of a posterior by its size, prepares it once, and checks ranges and stop rules.

#include "protocols/procedures/posterior_track.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/psychometric/function_table.h"

namespace asperity {
namespace {

constexpr std::size_t kThresholdsOfGrid = 41;
/// A level is chosen within a few milliseconds.
constexpr double kMostTableEntries = 500'000.0;
constexpr std::size_t kMostValues = 1000;

double difference_of(const PosteriorTrack& track, double level) {
  return std::abs(level - track.origin);
}

std::vector<double> differences_of(const PosteriorTrack& track) {
  std::vector<double> differences = levels_of(track.grid);
  for (double& each : differences) each = difference_of(track, each);
  return differences;
}

void check_posterior_stop(const PosteriorStop& stop, ProcedureProblems& problems) {
  if (stop.trials == 0) {
    problems.report(
        "stop.trials",
        phrase("Protocols", "the number of trials has no limit; state a maximum number of trials"));
  } else if (stop.trials > kMostTrials) {
    problems.report("stop.trials",
                    phrase("Protocols", "the maximum number of trials is above %1; lower it")
                        .with(std::to_string(kMostTrials)));
  }
  if (!stop.interval) return;
  const IntervalRule& rule = *stop.interval;
  if (!(std::isfinite(rule.ratio) && rule.ratio > 1.0)) {
    problems.report("stop.interval.ratio",
                    phrase("Protocols",
                           "the ratio %1 of the upper to the lower end of an interval must be "
                           "above 1, such as 1.5; raise it")
                        .with(number_text(rule.ratio)));
  }
  if (rule.minimum_trials > stop.trials) {
    problems.report("stop.interval.minimum_trials",
                    phrase("Protocols",
                           "the interval cannot end a track before trial %1, but the track has at "
                           "most %2; lower the minimum, or allow more trials")
                        .with(std::to_string(rule.minimum_trials), std::to_string(stop.trials)));
  }
  if (rule.minimum_of_each > stop.trials / 2) {
    problems.report("stop.interval.minimum_of_each",
                    phrase("Protocols",
                           "a track of %1 trials cannot have %2 correct and as many incorrect "
                           "responses; lower the number")
                        .with(std::to_string(stop.trials), std::to_string(rule.minimum_of_each)));
  }
}

/// Returns whether the range can be used.
bool check_range(const ValueRange& range, const std::string& setting, bool may_begin_at_0,
                 ProcedureProblems& problems) {
  if (!std::isfinite(range.lowest) || !std::isfinite(range.highest) ||
      !(may_begin_at_0 ? range.lowest >= 0.0 : range.lowest > 0.0)) {
    problems.report(
        setting,
        (may_begin_at_0 ? phrase("Protocols", "the range begins at %1; it must begin at 0 or above")
                        : phrase("Protocols", "the range begins at %1; it must begin above 0"))
            .with(number_text(range.lowest)));
    return false;
  }
  if (range.count == 0 || range.count > kMostValues) {
    problems.report(setting, phrase("Protocols", "the range has %1 values; state 1 to %2")
                                 .with(std::to_string(range.count), std::to_string(kMostValues)));
    return false;
  }
  const bool is_ascending =
      range.count == 1 ? range.lowest == range.highest : range.lowest < range.highest;
  if (!is_ascending) {
    problems.report(setting, phrase("Protocols",
                                    "%1 values from %2 to %3 are not a range; state a highest "
                                    "value above the lowest one, or 1 value with both equal")
                                 .with(std::to_string(range.count), number_text(range.lowest),
                                       number_text(range.highest)));
  }
  return is_ascending;
}

void check_prior(const PosteriorTrack& track, ProcedureProblems& problems) {
  const ThresholdPrior& prior = track.prior;
  bool is_usable = check_range(prior.thresholds, "prior.threshold", false, problems);
  is_usable = check_range(prior.slopes, "prior.slope", false, problems) && is_usable;
  is_usable = check_range(prior.lapses, "prior.lapse", true, problems) && is_usable;
  if (!is_usable) return;
  if (prior.thresholds.count < 2) {
    problems.report(
        "prior.threshold",
        phrase("Protocols",
               "a single threshold leaves nothing to estimate; state at least 2 values"));
  }
  if (!(prior.lapses.highest > 0.0)) {
    problems.report("prior.lapse",
                    phrase("Protocols",
                           "without lapses an incorrect response to an easy level is impossible; "
                           "state a highest lapse rate above 0, such as 0.06"));
  }
  if (!(prior.performance > prior.guess_rate && prior.performance < 1.0 - prior.lapses.highest)) {
    problems.report("target",
                    phrase("Protocols",
                           "the target %1 must be above %2, the proportion of correct guesses, and "
                           "below %3, 1 minus the highest lapse rate; state one, such as 0.75")
                        .with(number_text(prior.performance), number_text(prior.guess_rate),
                              number_text(1.0 - prior.lapses.highest)));
  }
  const double entries =
      static_cast<double>(prior.thresholds.count) * static_cast<double>(prior.slopes.count) *
      static_cast<double>(prior.lapses.count) * static_cast<double>(size_of(track.grid));
  if (entries > kMostTableEntries) {
    problems.report(
        "prior.threshold",
        phrase("Protocols",
               "thresholds, slopes, lapse rates and levels have %1 combinations, which would delay "
               "the trials; reduce their numbers to %2 combinations or less")
            .with(number_text(entries), number_text(kMostTableEntries)));
  }
}

/// The track with its table; immutable.
class PreparedTrack final {
 public:
  PreparedTrack(const PosteriorTrack& track, std::span<const NuisanceParameter> nuisances)
      : track_(track),
        table_(functions_of(track.prior, nuisances), functions_of_group(track.prior, nuisances),
               differences_of(track)) {}

  NextStep next(std::span<const LevelAnswer> answers) const {
    if (answers.size() >= track_.stop.trials) return TrackEnd::trials;
    Eigen::ArrayXd weights = table_.uniform();
    Answered answered{};
    for (const LevelAnswer& answer : answers) {
      respond(weights, answer);
      ++answered.all;
      answered.correct += answer.outcome == LevelOutcome::correct ? 1 : 0;
      // After every answer: an interval that becomes wider again does not continue a finished track.
      if (is_precise(weights, answered)) return TrackEnd::interval;
    }
    const std::size_t index = place_of_least(table_.expected_entropies(weights));
    return NextLevel{.level = level_of(track_.grid, index)};
  }

 private:
  struct Answered {
    std::size_t all = 0;
    std::size_t correct = 0;
  };

  void respond(Eigen::ArrayXd& weights, const LevelAnswer& answer) const {
    const bool is_level = is_on(track_.grid, answer.level);
    const double difference = difference_of(track_, answer.level);
    if (answer.outcome == LevelOutcome::unsure) {
      const double chance = track_.prior.guess_rate;
      if (is_level) {
        table_.guess(weights, nearest_index(track_.grid, answer.level), chance);
      } else {
        table_.guess_at(weights, difference, chance);
      }
      return;
    }
    const bool is_correct = answer.outcome == LevelOutcome::correct;
    if (is_level) {
      table_.respond(weights, nearest_index(track_.grid, answer.level), is_correct);
    } else {
      table_.respond_at(weights, difference, is_correct);
    }
  }

  bool is_precise(const Eigen::ArrayXd& weights, const Answered& answered) const {
    if (!track_.stop.interval) return false;
    const IntervalRule& rule = *track_.stop.interval;
    if (answered.all < rule.minimum_trials || answered.correct < rule.minimum_of_each ||
        // Of these, responses "cannot tell" may be all.
        answered.all - answered.correct < rule.minimum_of_each) {
      return false;
    }
    const CredibleThreshold threshold = credible_threshold(
        track_.prior, table_.functions(),
        {weights.data(), static_cast<std::size_t>(weights.size())},
        {.performance = track_.prior.performance, .confidence = kConfidenceOfIntervalRule});
    return threshold.interval.high <= rule.ratio * threshold.interval.low;
  }

  PosteriorTrack track_{};
  FunctionTable table_;
};

}  // namespace

ValueRange thresholds_within(const LevelGrid& grid, double origin) {
  ProcedureProblems problems{};
  check_grid(grid, "", problems);
  if (!problems.empty()) return {.count = kThresholdsOfGrid};
  ValueRange range{.count = kThresholdsOfGrid};
  for (const double level : levels_of(grid)) {
    const double difference = std::abs(level - origin);
    if (difference <= 0.0) continue;
    range.lowest = range.lowest == 0.0 ? difference : std::min(range.lowest, difference);
    range.highest = std::max(range.highest, difference);
  }
  return range;
}

void check_posterior_track(const PosteriorTrack& track, ProcedureProblems& problems) {
  check_posterior_stop(track.stop, problems);
  const std::size_t before = problems.all().size();
  check_grid(track.grid, "grid", problems);
  if (problems.all().size() > before) return;  // the prior refers to the grid
  if (size_of(track.grid) < 2) {
    problems.report("grid.step", phrase("Protocols",
                                        "the grid has only one level, %1, so that there is nothing "
                                        "to choose; reduce its step, or widen its bounds")
                                     .with(number_text(track.grid.lowest)));
    return;
  }
  check_prior(track, problems);
}

LevelRule posterior_rule(const PosteriorTrack& track,
                         std::span<const NuisanceParameter> nuisances) {
  return
      [prepared = std::make_shared<const PreparedTrack>(track, nuisances)](
          std::span<const LevelAnswer> answers, const Random&) { return prepared->next(answers); };
}

}  // namespace asperity
