// Derives the steps up from the target, and those after "cannot tell" from the alternatives.

#include "protocols/procedures/weighted_up_down.h"

#include <cmath>
#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"
#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

const WeightedUpDown& settings_in(const ProcedureSettings& settings) {
  return std::get<WeightedUpDown>(settings);
}

bool is_proportion(double target) { return target > 0.0 && target < 1.0; }

/// The step that is `times` as long on the scale.
double lengthened(LevelScale scale, double step, double times) {
  return scale == LevelScale::ratio ? std::pow(step, times) : step * times;
}

double weight_of(double target) { return target / (1.0 - target); }

/// The step up after "cannot tell", in steps down (WeightedUpDown).
double unsure_weight_of(double target, std::size_t alternatives) {
  const double chance = 1.0 / static_cast<double>(alternatives);
  return (target - chance) / (1.0 - target);
}

/// The target of a track whose other settings have no problem.
void check_unsure_steps(const WeightedUpDown& method, ProcedureProblems& problems) {
  const std::size_t alternatives = *method.unforced_alternatives;
  const double weight = unsure_weight_of(method.target, alternatives);
  if (!(weight > 0.0)) {
    problems.report("target", phrase("Protocols",
                                     "the target %1 is not above 1/%2, the proportion of correct "
                                     "guesses, so that the response \"cannot tell\" would not lead "
                                     "to a higher level; use a higher target, such as 0.75")
                                  .with(number_text(method.target), std::to_string(alternatives)));
    return;
  }
  problems.report(
      "target",
      phrase("Protocols",
             "the step up after the response \"cannot tell\" is %1 times the step down for the "
             "target %2 and %3 alternatives, the mean step of a guess, which is not a whole number "
             "of steps of the grid; use a larger step down or a finer grid%4")
          .with(rounded_text(weight), number_text(method.target), std::to_string(alternatives),
                alternatives == 2 ? phrase("Protocols", ", or the target 0.75 (ratio 1)")
                                  : Phrase()));
}

void check_weighted(const ProcedureSettings& settings, ProcedureProblems& problems) {
  const WeightedUpDown& method = settings_in(settings);
  UpDownTrack track{.grid = method.grid,
                    .start = method.start,
                    .steps_up = method.steps_down,  // checked below
                    .steps_down = method.steps_down,
                    .stop = method.stop};
  ProcedureProblems of_track{};
  check_track(track, of_track);
  for (const ProcedureProblem& problem : of_track.all()) {
    if (problem.setting != "steps_up") problems.report(problem.setting, problem.message);
  }
  if (!is_proportion(method.target)) {
    problems.report("target", phrase("Protocols",
                                     "the target %1 is not a proportion between 0 and 1; state "
                                     "one, such as 0.75 for two alternatives")
                                  .with(number_text(method.target)));
    return;
  }
  if (!of_track.empty() || track_of(method)) return;
  WeightedUpDown forced = method;
  forced.unforced_alternatives.reset();
  if (track_of(forced)) return check_unsure_steps(method, problems);
  const double weight = weight_of(method.target);
  problems.report("target",
                  phrase("Protocols",
                         "a step up is %1 times the step down for the target %2, which is not a "
                         "whole number of steps of the grid; use a target whose ratio is a whole "
                         "number, such as 0.75 (ratio 3), a larger step down, or a finer grid")
                      .with(rounded_text(weight), number_text(method.target)));
}

LevelRule weighted_rule(const ProcedureSettings& settings) {
  return
      [track = *track_of(settings_in(settings))](std::span<const LevelAnswer> answers,
                                                 const Random&) { return next_of(track, answers); };
}

constexpr Procedure kWeightedUpDown{
    .id = "weighted_up_down",
    .meaning = "down after a correct response, up by a larger step after an incorrect one",
    .check = check_weighted,
    .levels =
        [](const ProcedureSettings& settings) { return levels_of(settings_in(settings).grid); },
    .rule = weighted_rule,
    .most_trials =
        [](const ProcedureSettings& settings) { return settings_in(settings).stop.trials; },
    .has_fixed_length =
        [](const ProcedureSettings& settings) {
          return has_fixed_length(settings_in(settings).stop);
        },
    .target = [](const ProcedureSettings& settings) -> std::optional<double> {
      return settings_in(settings).target;
    }};

}  // namespace

std::optional<UpDownTrack> track_of(const WeightedUpDown& method) {
  if (!is_proportion(method.target)) return std::nullopt;
  UpDownTrack track{.grid = method.grid,
                    .start = method.start,
                    .steps_down = method.steps_down,
                    .stop = method.stop};
  for (const double step : method.steps_down) {
    const double up = lengthened(method.grid.scale, step, weight_of(method.target));
    if (grid_steps(method.grid, up) == 0) return std::nullopt;
    track.steps_up.push_back(up);
    if (!method.unforced_alternatives) continue;
    const double weight = unsure_weight_of(method.target, *method.unforced_alternatives);
    if (!(weight > 0.0)) return std::nullopt;
    const double unsure = lengthened(method.grid.scale, step, weight);
    if (grid_steps(method.grid, unsure) == 0) return std::nullopt;
    track.steps_unsure.push_back(unsure);
  }
  return track;
}

const Procedure& weighted_up_down() { return kWeightedUpDown; }

}  // namespace asperity
