// Rebuilds the tracks from the stored settings, and simulates their responses with a given psychometric function.

#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "analysis/numbers/seed_of_tests.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"

namespace asperity {

namespace {

constexpr double kQuartileOfStandardNormal = 0.6744897501960817;
constexpr double kSteepestRise =
    4.65;  // standard deviations from 1 % to 99 % of a normal distribution

double x_of_value(const DiscriminationTask& task, double value) {
  return task.is_performance ? std::abs(value - task.standard()) : value;
}

/// With at most this number of trials; a rule that needs more does not apply.
void shorten(PosteriorStop& stop, std::size_t trials) {
  stop.trials = std::min(stop.trials, trials);
  const bool is_out_of_reach = stop.interval && (stop.interval->minimum_trials > stop.trials ||
                                                 stop.interval->minimum_of_each > stop.trials / 2);
  if (is_out_of_reach) stop.interval.reset();
}

/// The settings with at most this number of trials.
ProcedureSettings shortened(ProcedureSettings settings, std::size_t trials) {
  if (auto* const transformed = std::get_if<TransformedUpDown>(&settings)) {
    transformed->track.stop.trials = std::min(transformed->track.stop.trials, trials);
  } else if (auto* const weighted = std::get_if<WeightedUpDown>(&settings)) {
    weighted->stop.trials = std::min(weighted->stop.trials, trials);
  } else if (auto* const psi = std::get_if<Psi>(&settings)) {
    shorten(psi->track.stop, trials);
  } else if (auto* const quest = std::get_if<QuestPlus>(&settings)) {
    shorten(quest->track.stop, trials);
  }
  return settings;
}

/// Every x that a run can present, ascending.
std::set<double> possible_x(const DiscriminationTask& task, const PlacedTrials& placed) {
  std::set<double> all{};
  for (const auto& [value, trials] : placed.fixed) all.insert(x_of_value(task, value));
  for (const PlacedTrials::Track& track : placed.tracks) {
    for (const double level : procedure_of(track.settings).levels(track.settings)) {
      all.insert(x_of_value(task, track.levels.value_of(level)));
    }
  }
  return all;
}

CurveFamily family_of(const DiscriminationTask& task, const std::set<double>& levels,
                      double proportion_of_hits) {
  if (task.is_performance) {
    constexpr double kBeyond = 3.0;
    const double lowest = levels.upper_bound(0.0) == levels.end() ? 0.0 : *levels.upper_bound(0.0);
    return {.shape = PsychometricShape::weibull,
            .gamma = task.design->guess_rate(),
            .lambda = {.low = 0.0, .high = kGreatestLapseRate},
            .performance = proportion_of_hits,
            .thresholds = {.low = lowest / kBeyond, .high = *levels.rbegin() * kBeyond},
            .slopes = kSlopesOfProcedures};
  }
  const double range = *levels.rbegin() - *levels.begin();
  double gap = range;
  for (auto level = std::next(levels.begin()); level != levels.end(); ++level) {
    gap = std::min(gap, *level - *std::prev(level));
  }
  return {
      .shape = PsychometricShape::normal,
      .gamma = std::nullopt,
      .lambda = {.low = kSymmetricLapseRate, .high = kSymmetricLapseRate},
      .performance = proportion_of_hits,
      .thresholds = {.low = *levels.begin() - 0.5 * range, .high = *levels.rbegin() + 0.5 * range},
      .slopes = {.least = kQuartileOfStandardNormal / range, .greatest = kSteepestRise / gap}};
}

std::vector<LevelRule> rules_of_tracks(const PlacedTrials& placed) {
  std::vector<LevelRule> rules{};
  for (const PlacedTrials::Track& track : placed.tracks) {
    rules.push_back(level_rule(track.settings));
  }
  return rules;
}

/// `hit`: the probability of a hit, with split responses "cannot tell".
LevelOutcome unforced_outcome(const PlacedTrials& placed, double hit, Random& random) {
  const auto m = static_cast<double>(placed.alternatives);
  const double unsure = placed.unsure_share * (1.0 - hit) * m / (m - 1.0);
  const double drawn = random.uniform();
  if (drawn < unsure) return LevelOutcome::unsure;
  return forced_outcome(drawn < hit + unsure * (1.0 - 1.0 / m));
}

/// `rules`: of the tracks.
std::vector<PsychometricBlock> run_by_rules(const DiscriminationTask& task,
                                            const PlacedTrials& placed,
                                            std::span<const LevelRule> rules,
                                            const PsychometricFunction& observer,
                                            const Random& of_run) {
  std::map<double, PsychometricBlock> by_x{};
  const auto add = [&by_x](double x, bool is_hit) {
    PsychometricBlock& block = by_x[x];
    block.x = x;
    ++block.trials;
    block.hits += is_hit ? 1 : 0;
  };
  const double part_of_hit =
      placed.alternatives > 0 ? 1.0 / static_cast<double>(placed.alternatives) : 0.0;
  const auto add_answer = [&](double x, LevelOutcome outcome) {
    if (outcome == LevelOutcome::unsure) {
      add(x, false);
      by_x[x].guessed_hits += part_of_hit;
    } else {
      add(x, (outcome == LevelOutcome::correct) != placed.counts_standard);
    }
  };
  for (std::size_t i = 0; i < placed.tracks.size(); ++i) {
    const PlacedTrials::Track& track = placed.tracks[i];
    const auto x_of_level = [&](double level) {
      return x_of_value(task, track.levels.value_of(level));
    };
    const ChanceOfCorrect chance_of_comparison = [&](double level) {
      const double hit = observer.value(x_of_level(level));
      return placed.counts_standard ? 1.0 - hit : hit;
    };
    const Random of_track = of_run.split("track").split(static_cast<std::uint64_t>(i));
    const std::vector<LevelAnswer> answers =
        placed.unsure_share > 0.0
            ? simulated_track(
                  rules[i],
                  [&](double level, Random& random) {
                    return unforced_outcome(placed, chance_of_comparison(level), random);
                  },
                  of_track)
            : simulated_track(rules[i], chance_of_comparison, of_track);
    for (const LevelAnswer& answer : answers) add_answer(x_of_level(answer.level), answer.outcome);
  }
  Random fixed = of_run.split("fixed");
  for (const auto& [value, trials] : placed.fixed) {
    const double x = x_of_value(task, value);
    for (std::uint64_t i = 0; i < trials; ++i) {
      if (placed.unsure_share > 0.0) {
        add_answer(x, unforced_outcome(placed, observer.value(x), fixed));
      } else {
        add(x, fixed.uniform() < observer.value(x));
      }
    }
  }
  std::vector<PsychometricBlock> blocks{};
  for (const auto& [x, block] : by_x) blocks.push_back(block);
  return blocks;
}

}  // namespace

std::size_t PlacedTrials::unfinished_tracks() const {
  return static_cast<std::size_t>(std::count_if(
      tracks.begin(), tracks.end(), [](const Track& one) { return one.is_unfinished; }));
}

double unsure_share_of_errors(const ChoiceCount& count, std::size_t alternatives) {
  if (count.unsure == 0) return 0.0;
  const double split =
      static_cast<double>(count.unsure) * (1.0 - 1.0 / static_cast<double>(alternatives));
  return split / (static_cast<double>(count.trials - count.hits - count.unsure) + split);
}

PlacedTrials::Track placed_track(std::vector<const DiscriminationTrial*> trials,
                                 std::span<const ProcedureSettings> of_block,
                                 const Dimension& levels) {
  std::stable_sort(trials.begin(), trials.end(),
                   [](const DiscriminationTrial* one, const DiscriminationTrial* other) {
                     return one->step < other->step;
                   });
  const auto number = static_cast<std::size_t>(trials.front()->track - 1);
  PlacedTrials::Track track{.settings = of_block[number % of_block.size()], .levels = levels};
  std::vector<LevelAnswer> answers{};
  for (const DiscriminationTrial* const trial : trials) {
    answers.push_back({.level = track.levels.level_of(trial->value),
                       .outcome = trial->is_unsure ? LevelOutcome::unsure
                                                   : forced_outcome(trial->chose_comparison)});
  }
  const Random unused(kSeedOfTests);
  const bool has_next =
      std::holds_alternative<NextLevel>(next_step(track.settings, answers, unused));
  if (has_next) track.settings = shortened(std::move(track.settings), answers.size());
  // In a completed session an attempt that does not count has the same effect.
  track.is_unfinished = has_next && trials.back()->session_is_unfinished;
  return track;
}

std::optional<PlacedTrials> placed_trials(const GatheredAnswers& gathered,
                                          const DiscriminationStudy& study,
                                          std::span<const DiscriminationTrial* const> trials) {
  // A procedure that knows the direction of the question moves by the hits.
  PlacedTrials placed{.counts_standard = study.counts_standard && !study.task.asks_for};
  using Place = std::tuple<std::uint32_t, int, int, int>;
  std::map<Place, std::vector<const DiscriminationTrial*>> tracks{};
  ChoiceCount all{};
  for (const DiscriminationTrial* const trial : trials) {
    study.count(*trial, all);
    if (!trial->by_procedure) {
      ++placed.fixed[trial->value];
      continue;
    }
    tracks[{trial->block, trial->session, trial->block_ordinal, trial->track}].push_back(trial);
  }
  for (auto& [place, of_track] : tracks) {
    const auto block = gathered.blocks.find(gathered.word(std::get<0>(place)));
    if (block == gathered.blocks.end() || !block->second.procedure || !block->second.vary) {
      return std::nullopt;
    }
    const std::vector<ProcedureSettings>& settings = block->second.procedure->tracks;
    // The levels that a program would state after other responses are unknown.
    if (settings.empty() || std::holds_alternative<External>(settings.front())) return std::nullopt;
    placed.tracks.push_back(placed_track(std::move(of_track), settings, *block->second.vary));
  }
  if (placed.tracks.empty()) return std::nullopt;
  if (all.unsure > 0) {
    placed.alternatives = study.task.design->alternatives();
    placed.unsure_share = unsure_share_of_errors(all, placed.alternatives);
  }
  return placed;
}

std::vector<PsychometricBlock> run_again(const DiscriminationTask& task, const PlacedTrials& placed,
                                         const PsychometricFunction& observer,
                                         const Random& of_run) {
  return run_by_rules(task, placed, rules_of_tracks(placed), observer, of_run);
}

std::optional<ProcedureBootstrap> procedure_interval(const DiscriminationTask& task,
                                                     std::span<const PsychometricBlock> blocks,
                                                     const PlacedTrials& placed,
                                                     double proportion_of_hits) {
  const std::set<double> levels = possible_x(task, placed);
  const CurveFamily family = family_of(task, levels, proportion_of_hits);
  const auto is_known = [&](const PsychometricBlock& block) { return block.trials > 0; };
  if (levels.size() < 2 || std::count_if(blocks.begin(), blocks.end(), is_known) < 2) {
    return std::nullopt;
  }
  const std::vector<LevelRule> rules = rules_of_tracks(placed);
  return bootstrap_procedure(
      blocks, {.family = family, .repetitions = kRepetitionsOfProcedures},
      [&](const PsychometricFunction& observer, const Random& of_run) {
        return run_by_rules(task, placed, rules, observer, of_run);
      },
      Random(kSeedOfTests).split("procedure bootstrap"));
}

}  // namespace asperity
