// Replays the up-down rule trial by trial, clamping levels; averages reversals on the scale of the levels.

#include "analysis/psychometric/staircase.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/summary.h"

namespace asperity {
namespace {

void refuse_invalid(const Staircase& staircase) {
  if (staircase.steps.empty()) throw std::invalid_argument("step is empty; give at least one size");
  for (const double step : staircase.steps) {
    if (!(step_length(staircase.scale, step) > 0.0)) {
      throw std::invalid_argument("step contains " + number_text(step) +
                                  "; every step must be above 0, and above 1 on the ratio scale");
    }
  }
  if (!(staircase.up_over_down > 0.0))
    throw std::invalid_argument("step_up_ratio (up_over_down) is " +
                                number_text(staircase.up_over_down) + "; it must be above 0");
  if (!(staircase.start >= staircase.lowest && staircase.start <= staircase.highest)) {
    throw std::invalid_argument("start is " + number_text(staircase.start) +
                                "; it must lie between the bounds, min and max");
  }
  if (staircase.scale != LevelScale::linear && !(staircase.start > 0.0)) {
    throw std::invalid_argument("start is " + number_text(staircase.start) +
                                "; it must be above 0 on this scale");
  }
}

}  // namespace

StaircaseTrack replay_staircase(const Staircase& staircase, const std::vector<bool>& is_correct) {
  refuse_invalid(staircase);
  StaircaseTrack track{.next_level = staircase.start};
  UpDownRun run(staircase.rule);
  for (const bool correct : is_correct) {
    StaircaseTrial trial{.level = track.next_level};
    const UpDownRun::Outcome outcome = run.respond(correct);
    trial.is_reversal = outcome.is_reversal;
    if (outcome.move != UpDownMove::none) {
      const double step = staircase.steps[std::min(run.reversals(), staircase.steps.size() - 1)];
      const double steps = outcome.move == UpDownMove::up ? staircase.up_over_down : -1.0;
      const double level =
          moved_level(staircase.scale, trial.level, {.size = step, .steps = steps});
      track.next_level = std::clamp(level, staircase.lowest, staircase.highest);
      trial.is_clipped = track.next_level != level;
    }
    track.trials.push_back(trial);
  }
  return track;
}

std::optional<ReversalMean> mean_of_reversals(const StaircaseTrack& track,
                                              const ReversalQuestion& question) {
  std::vector<double> places{};
  for (const StaircaseTrial& trial : track.trials) {
    if (trial.is_reversal) places.push_back(place_on(question.scale, trial.level));
  }
  if (places.size() <= question.discard) return std::nullopt;
  std::size_t first = question.discard;
  if (question.even_number && (places.size() - first) % 2 == 1) ++first;
  places.erase(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(first));
  if (places.empty()) return std::nullopt;

  const Summary summary = *summary_of(places);
  ReversalMean result{.used = summary.n,
                      .mean = level_at(question.scale, summary.mean),
                      .median = level_at(question.scale, summary.p50)};
  if (summary.n > 1) result.sd = summary.sd;
  if (summary.n % 2 == 0) {
    std::vector<double> midpoints{};
    for (std::size_t i = 0; i < places.size(); i += 2) {
      midpoints.push_back(0.5 * (places[i] + places[i + 1]));
    }
    result.midpoint_error =
        midpoints.size() > 1
            ? summary_of(midpoints)->sd / std::sqrt(static_cast<double>(midpoints.size()))
            : std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

}  // namespace asperity
