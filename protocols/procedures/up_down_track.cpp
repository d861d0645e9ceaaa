// Moves the index of a track by its steps, counts reversals, and applies the stop rules.

#include "protocols/procedures/up_down_track.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/rounded_text.h"

namespace asperity {
namespace {

/// The index after a move of a track, and whether a bound shortened the move.
struct MovedIndex {
  std::size_t index = 0;
  bool is_clipped = false;
};

const StepList& steps_of_move(const UpDownTrack& track, UpDownMove move, LevelOutcome outcome) {
  if (move == UpDownMove::down) return track.steps_down;
  const bool is_unsure = outcome == LevelOutcome::unsure && !track.steps_unsure.empty();
  return is_unsure ? track.steps_unsure : track.steps_up;
}

MovedIndex moved(const UpDownTrack& track, const LevelAnswer& answer, UpDownMove move,
                 std::size_t reversals) {
  const std::size_t from = nearest_index(track.grid, answer.level);
  if (move == UpDownMove::none) return {.index = from};
  const StepList& steps = steps_of_move(track, move, answer.outcome);
  const std::size_t by = grid_steps(track.grid, steps[std::min(reversals, steps.size() - 1)]);
  const std::size_t room = move == UpDownMove::up ? size_of(track.grid) - 1 - from : from;
  const std::size_t way = std::min(by, room);
  return {.index = move == UpDownMove::up ? from + way : from - way, .is_clipped = way < by};
}

void check_start(const LevelGrid& grid, double start, ProcedureProblems& problems) {
  if (!(start >= grid.lowest && start <= grid.highest) && !is_on(grid, start)) {
    problems.report("start", phrase("Protocols",
                                    "the start %1 is outside the bounds %2 and %3; choose a level "
                                    "between them, or widen them")
                                 .with(number_text(start), number_text(grid.lowest),
                                       number_text(grid.highest)));
    return;
  }
  if (is_on(grid, start)) return;
  if (size_of(grid) == 1) {
    problems.report(
        "start",
        phrase("Protocols", "the grid has only one level, %1; reduce its step, or widen its bounds")
            .with(number_text(grid.lowest)));
    return;
  }
  const double nearest = level_of(grid, nearest_index(grid, start));
  problems.report(
      "start",
      phrase("Protocols", "the start %1 is not a level of the grid; use the nearest level, %2")
          .with(number_text(start), rounded_text(nearest)));
}

void check_steps(const LevelGrid& grid, const StepList& steps, const std::string& setting,
                 ProcedureProblems& problems) {
  if (steps.empty()) {
    problems.report(setting, phrase("Protocols", "there is no step; state at least one"));
    return;
  }
  for (const double step : steps) {
    if (!std::isfinite(step) || !(step_length(grid.scale, step) > 0.0)) {
      problems.report(
          setting,
          phrase("Protocols",
                 "the step %1 does not change the level; on the scale %2 it must be above %3")
              .with(number_text(step), std::string(name_of(grid.scale)),
                    grid.scale == LevelScale::ratio ? "1" : "0"));
    } else if (grid_steps(grid, step) == 0) {
      problems.report(setting, phrase("Protocols",
                                      "the step %1 is not a whole number of steps of the grid "
                                      "(%2); change the step or the grid")
                                   .with(number_text(step), number_text(grid.step)));
    }
  }
}

void check_stop(const StopRules& stop, ProcedureProblems& problems) {
  if (stop.trials == 0 && !stop.reversals && !stop.clipped_moves) {
    problems.report("stop", phrase("Protocols",
                                   "there is no stopping rule; state a maximum number of trials, "
                                   "with or without a number of reversals"));
  } else if (stop.trials == 0) {
    problems.report("stop.trials",
                    phrase("Protocols",
                           "the number of trials has no limit, and a track that stays at a bound "
                           "never reverses; state a maximum number of trials"));
  } else if (stop.trials > kMostTrials) {
    problems.report("stop.trials",
                    phrase("Protocols", "the maximum number of trials is above %1; lower it")
                        .with(std::to_string(kMostTrials)));
  }
  if (stop.reversals == std::size_t{0}) {
    problems.report("stop.reversals", phrase("Protocols",
                                             "a track with 0 reversals has no trial; state a "
                                             "number above 0, or leave the rule out"));
  }
  if (stop.clipped_moves == std::size_t{0}) {
    problems.report("stop.clipped_moves",
                    phrase("Protocols",
                           "a track that ends after 0 moves beyond a bound has no trial; state a "
                           "number above 0, or leave the rule out"));
  }
}

}  // namespace

void check_track(const UpDownTrack& track, ProcedureProblems& problems) {
  if (track.rule.up == 0) {
    problems.report(
        "up", phrase("Protocols", "the rule moves up after 0 responses; state a number above 0"));
  }
  if (track.rule.down == 0) {
    problems.report(
        "down",
        phrase("Protocols", "the rule moves down after 0 responses; state a number above 0"));
  }
  check_stop(track.stop, problems);
  const std::size_t before = problems.all().size();
  check_grid(track.grid, "grid", problems);
  if (problems.all().size() > before) return;  // the start and the steps refer to the grid
  check_start(track.grid, track.start, problems);
  check_steps(track.grid, track.steps_up, "steps_up", problems);
  check_steps(track.grid, track.steps_down, "steps_down", problems);
}

NextStep next_of(const UpDownTrack& track, std::span<const LevelAnswer> answers) {
  UpDownRun run(track.rule);
  std::size_t clipped = 0;
  bool is_at_bound = false;
  UpDownMove last = UpDownMove::none;
  for (const LevelAnswer& answer : answers) {
    last = run.respond(answer.outcome == LevelOutcome::correct).move;
    if (last == UpDownMove::none || !track.stop.clipped_moves) continue;
    clipped = moved(track, answer, last, run.reversals()).is_clipped ? clipped + 1 : 0;
    is_at_bound = is_at_bound || clipped >= *track.stop.clipped_moves;
  }
  if (answers.size() >= track.stop.trials) return TrackEnd::trials;
  if (track.stop.reversals && run.reversals() >= *track.stop.reversals) return TrackEnd::reversals;
  if (is_at_bound) return TrackEnd::bound;
  const std::size_t index = answers.empty()
                                ? nearest_index(track.grid, track.start)
                                : moved(track, answers.back(), last, run.reversals()).index;
  return NextLevel{.level = level_of(track.grid, index)};
}

double target_of(const UpDownTrack& track) {
  return balanced_performance(track.rule,
                              step_length(track.grid.scale, track.steps_up.back()) /
                                  step_length(track.grid.scale, track.steps_down.back()));
}

bool has_fixed_length(const StopRules& stop) noexcept {
  return !stop.reversals && !stop.clipped_moves;
}

}  // namespace asperity
