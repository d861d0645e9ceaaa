// Implements the estimate from the reversals of up-down tracks.

#include "protocols/plan/roughness_matching.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "analysis/psychometric/up_down.h"

namespace asperity {

namespace {

/// What the answers of one track show.
struct TrackResult {
  double mean_of_logarithms = 0.0;  ///< of the reversals
  int reversals = 0;
  std::optional<double> end{};  ///< of the range, if the last answer leads beyond it
};

TrackResult result_of(const Dimension& vary, const AnsweredTrack& answered) {
  TrackResult result{};
  const std::optional<UpDownTrack> track = equality_track(answered.settings);
  if (!track || answered.answers.empty()) return result;
  UpDownRun run(track->rule);
  double sum = 0.0;
  for (const LevelAnswer& answer : answered.answers) {
    if (!run.respond(answer.outcome == LevelOutcome::correct).is_reversal) continue;
    sum += std::log(vary.value_of(answer.level));
    ++result.reversals;
  }
  if (result.reversals > 0) result.mean_of_logarithms = sum / result.reversals;
  const LevelAnswer& last = answered.answers.back();
  const std::size_t index = nearest_index(track->grid, last.level);
  const std::size_t end = last.outcome == LevelOutcome::correct ? 0 : size_of(track->grid) - 1;
  if (index == end) result.end = vary.value_of(level_of(track->grid, end));
  return result;
}

/// The match of the tracks of one stimulus.
void estimate(const Dimension& vary, const std::vector<TrackResult>& tracks,
              RoughnessMatch& match) {
  double sum = 0.0;
  std::optional<double> end{};
  for (const TrackResult& track : tracks) {
    match.reversals += track.reversals;
    if (track.reversals >= kFewestReversals) {
      sum += track.mean_of_logarithms;
      continue;
    }
    if (!track.end || (end && *end != *track.end)) return;  // unmatched
    end = track.end;
  }
  if (end) {
    const bool is_lowest = *end == vary.values().front();
    match.status = is_lowest ? MatchStatus::below_range : MatchStatus::above_range;
    match.relative_amplitude = *end;
    return;
  }
  match.status = MatchStatus::matched;
  // The measure "ratio" rounds as every level of a plan is rounded.
  match.relative_amplitude =
      value_at(LevelMeasure::ratio, std::exp(sum / static_cast<double>(tracks.size())), 1.0);
}

bool is_of(const RoughnessMatch& match, const std::string& stimulus, const std::string& model,
           const std::string& texture) {
  return match.stimulus == stimulus && match.model == model && match.texture == texture;
}

}  // namespace

std::optional<UpDownTrack> equality_track(const ProcedureSettings& settings) {
  std::optional<UpDownTrack> track{};
  if (const auto* const transformed = std::get_if<TransformedUpDown>(&settings)) {
    track = transformed->track;
  } else if (const auto* const weighted = std::get_if<WeightedUpDown>(&settings)) {
    track = track_of(*weighted);
  }
  if (!track || track->steps_up != track->steps_down || track->rule != UpDownRule{}) return {};
  return track;
}

bool matches_roughness(const Protocol& protocol, const Protocol::Block& block) {
  return std::any_of(protocol.blocks.begin(), protocol.blocks.end(), [&block](const auto& each) {
    const auto& equal = each.second.equal_roughness;
    return equal && equal->matched_in == block.name;
  });
}

std::vector<RoughnessMatch> roughness_matches(const Dimension& vary,
                                              const std::vector<AnsweredTrack>& tracks) {
  std::vector<RoughnessMatch> matches{};
  std::vector<std::vector<TrackResult>> results{};
  for (const AnsweredTrack& track : tracks) {
    auto match = std::find_if(matches.begin(), matches.end(), [&track](const auto& each) {
      return is_of(each, track.stimulus, track.model, track.texture);
    });
    if (match == matches.end()) {
      match = matches.insert(matches.end(), RoughnessMatch{.stimulus = track.stimulus,
                                                           .model = track.model,
                                                           .texture = track.texture});
      results.emplace_back();
    }
    match->answers += static_cast<int>(track.answers.size());
    results[static_cast<std::size_t>(match - matches.begin())].push_back(result_of(vary, track));
  }
  for (std::size_t i = 0; i < matches.size(); ++i) estimate(vary, results[i], matches[i]);
  return matches;
}

void apply_match(const std::vector<RoughnessMatch>& matches, PlannedPresentation& planned) {
  const auto match = std::find_if(matches.begin(), matches.end(), [&planned](const auto& each) {
    return is_of(each, planned.stimulus_template, planned.stimulus.model, planned.stimulus.texture);
  });
  planned.roughness_match = match == matches.end() ? MatchStatus::reference : match->status;
  planned.stimulus.relative_amplitude = match == matches.end() ? 1.0 : match->relative_amplitude;
}

bool are_of_same_stimulus(const PlannedPresentation& one, const PlannedPresentation& other) {
  const auto body = [](const std::optional<BodyDescription>& each) {
    return each ? each->name : std::string();
  };
  const auto parts = [&body](const PlannedPresentation& planned) {
    const StimulusDescription& stimulus = planned.stimulus;
    return std::tuple(stimulus.model, stimulus.texture, body(stimulus.surface), body(stimulus.tool),
                      stimulus.parameters, stimulus.material.stiffness_N_per_m,
                      stimulus.material.friction);
  };
  return parts(one) == parts(other) && one.equal_force == other.equal_force;
}

}  // namespace asperity
