// Collects the counted answers of each track, and estimates thresholds by reversals or by the posterior.

#include "app/session/running_track.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/numbers/level_scale.h"
#include "analysis/psychometric/threshold_prior.h"
#include "analysis/psychometric/up_down.h"
#include "protocols/design/block_factors.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

namespace {

constexpr double kCredibility = 0.95;

std::string unit_of_levels(const Dimension& dimension) {
  switch (dimension.measure) {
    case LevelMeasure::value:
    case LevelMeasure::difference:
      return dimension.unit;
    case LevelMeasure::percent:
      return "%";
    case LevelMeasure::decibels:
      return "dB";
    case LevelMeasure::ratio:
      break;
  }
  return {};
}

/// The rule and the grid of an up-down method.
std::optional<UpDownTrack> up_down_of(const ProcedureSettings& settings) {
  if (const auto* const transformed = std::get_if<TransformedUpDown>(&settings)) {
    return transformed->track;
  }
  const auto* const weighted = std::get_if<WeightedUpDown>(&settings);
  return weighted == nullptr ? std::nullopt : track_of(*weighted);
}

/// The last attempt at each trial that counts.
std::map<int, const AttemptSummary*> counted_attempts(std::span<const AttemptSummary> attempts) {
  std::map<int, const AttemptSummary*> counted{};
  for (const AttemptSummary& attempt : attempts) {
    if (attempt.purpose == AttemptPurpose::trial && attempt.valid) {
      counted[attempt.trial] = &attempt;
    }
  }
  return counted;
}

std::string other_levels(const Trial& trial, const std::string& varied) {
  std::string text{};
  for (const auto& [factor, level] : trial.factors) {
    if (factor != varied) text += (text.empty() ? "" : ", ") + text_of(level);
  }
  return text;
}

void estimate_by_reversals(const UpDownTrack& settings, RunningTrack& track) {
  UpDownRun run(settings.rule);
  double sum = 0.0;
  for (const RunningTrial& trial : track.trials) {
    if (!run.respond(trial.outcome == LevelOutcome::correct).is_reversal) continue;
    sum += place_on(settings.grid.scale, trial.level);
    ++track.reversals;
  }
  if (track.reversals == 0) return;
  track.estimate = {.level =
                        level_at(settings.grid.scale, sum / static_cast<double>(track.reversals))};
}

void estimate_by_posterior(const PosteriorTrack& settings, RunningTrack& track) {
  double sum = 0.0;
  std::map<double, PsychometricBlock> by_difference{};
  for (const RunningTrial& trial : track.trials) {
    sum += trial.level - settings.origin;
    const double difference = std::abs(trial.level - settings.origin);
    PsychometricBlock& block = by_difference[difference];
    block.x = difference;
    ++block.trials;
    if (trial.outcome == LevelOutcome::correct) ++block.hits;
    if (trial.outcome == LevelOutcome::unsure) block.guessed_hits += settings.prior.guess_rate;
  }
  std::vector<PsychometricBlock> blocks{};
  for (const auto& [difference, block] : by_difference) blocks.push_back(block);
  const std::vector<PsychometricFunction> functions = functions_of(settings.prior, {});
  const std::vector<double> weights = posterior_of(functions, blocks);
  const auto threshold = [&](double confidence) {
    return credible_threshold(
        settings.prior, functions, weights,
        {.performance = settings.prior.performance, .confidence = confidence});
  };
  // The interval of no width about the median.
  constexpr double kNone = 1e-9;
  const double side = sum < 0.0 ? -1.0 : 1.0;
  const ConfidenceInterval interval = threshold(kCredibility).interval;
  track.estimate = {.level = settings.origin + side * threshold(kNone).interval.low,
                    .low = settings.origin + side * (side < 0.0 ? interval.high : interval.low),
                    .high = settings.origin + side * (side < 0.0 ? interval.low : interval.high)};
}

void estimate(const ProcedureSettings& settings, RunningTrack& track) {
  if (track.trials.empty()) return;
  if (const std::optional<UpDownTrack> up_down = up_down_of(settings)) {
    estimate_by_reversals(*up_down, track);
  } else if (const PosteriorTrack* const posterior = posterior_track_of(settings)) {
    try {
      estimate_by_posterior(*posterior, track);
    } catch (const std::invalid_argument&) {
      track.estimate.reset();
    }
  }
}

bool has_tracks(const Protocol::Block& block) noexcept {
  return block.vary && chooses_levels_from_answers(block);
}

}  // namespace

bool has_running_tracks(const Protocol& protocol) noexcept {
  return std::any_of(protocol.blocks.begin(), protocol.blocks.end(),
                     [](const auto& named) { return has_tracks(named.second); });
}

std::optional<RunningTracks> running_tracks(const Protocol& protocol, const Plan& plan,
                                            std::span<const AttemptSummary> attempts,
                                            int block_ordinal) {
  const std::map<int, const AttemptSummary*> counted = counted_attempts(attempts);
  std::optional<RunningTracks> running{};
  std::map<int, RunningTrack> tracks{};
  const Protocol::Block* block = nullptr;
  for (const Trial& trial : plan.trials) {
    if (trial.block_ordinal != block_ordinal || !trial.track) continue;
    const auto named = protocol.blocks.find(trial.block);
    if (named == protocol.blocks.end() || !has_tracks(named->second)) return {};
    block = &named->second;
    const Dimension& dimension = *block->vary;
    if (!running) {
      running = RunningTracks{.quantity = dimension.parameter, .unit = unit_of_levels(dimension)};
    }
    const auto attempt = counted.find(trial.ordinal);
    if (attempt == counted.end() || !attempt->second->answer_of_track) continue;
    const LevelAnswer& answer = *attempt->second->answer_of_track;
    RunningTrack& track = tracks[trial.track->track];
    track.track = trial.track->track;
    track.condition = other_levels(trial, dimension.factor);
    track.trials.push_back(
        {.step = trial.track->step, .level = answer.level, .outcome = answer.outcome});
  }
  if (!running) return {};
  // Every combination of the other factors has every track of the procedure, in this order.
  const std::vector<ProcedureSettings>& settings = block->procedure->tracks;
  for (auto& [number, track] : tracks) {
    estimate(settings[static_cast<std::size_t>(number - 1) % settings.size()], track);
    running->tracks.push_back(std::move(track));
  }
  return running;
}

}  // namespace asperity
