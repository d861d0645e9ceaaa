// The levels that procedures choose.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/psychometric/function_table.h"
#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

const LevelGrid kOneToTwenty{
    .scale = LevelScale::linear, .lowest = 1.0, .highest = 20.0, .step = 1.0};

/// The levels of a track with these responses, each presented as proposed, with the level after the last one; shorter
/// if the track ends.
std::vector<double> levels_along(const ProcedureSettings& settings,
                                 const std::vector<bool>& responses,
                                 const Random& of_track = Random(1)) {
  std::vector<double> levels{};
  std::vector<LevelAnswer> answers{};
  for (std::size_t trial = 0;; ++trial) {
    const NextStep step = next_step(settings, answers, of_track);
    const NextLevel* const next = std::get_if<NextLevel>(&step);
    if (next == nullptr) return levels;
    levels.push_back(next->level);
    if (trial == responses.size()) return levels;
    answers.push_back({.level = next->level, .outcome = forced_outcome(responses[trial])});
  }
}

/// Answers at the level that is given, whatever was proposed.
std::vector<LevelAnswer> answers_at(double level, const std::vector<bool>& responses) {
  std::vector<LevelAnswer> answers{};
  for (const bool correct : responses)
    answers.push_back({.level = level, .outcome = forced_outcome(correct)});
  return answers;
}

TransformedUpDown two_down() {
  return {.track = {.grid = kOneToTwenty,
                    .start = 10.0,
                    .rule = {.up = 1, .down = 2},
                    .steps_up = {4.0, 2.0, 1.0},
                    .steps_down = {3.0, 1.0},
                    .stop = {.trials = 50}}};
}

// Responses by hand: two correct, 10 → 7 (step down of no reversal); correct, incorrect: reversal 1 at 7, up by 2 → 9;
// two correct: reversal 2 at 9, down by 1 (the last of its list) → 8; incorrect: reversal 3 at 8, up by 1 → 9;
// incorrect → 10.
TEST(TransformedUpDown, FollowsATrackByHand) {
  const std::vector<bool> responses{true, true, true, false, true, true, false, false};
  EXPECT_THAT(levels_along(two_down(), responses),
              testing::ElementsAre(10, 10, 7, 7, 9, 9, 8, 9, 10));
}

// Three down, two up on a grid of ratio 2: three correct: 8 → 4; two incorrect → 8; incorrect, correct, incorrect,
// incorrect → 16.
TEST(TransformedUpDown, FollowsARuleWithTwoUpOnAGridOfRatios) {
  const TransformedUpDown method{
      .track = {.grid = {.scale = LevelScale::ratio, .lowest = 1.0, .highest = 64.0, .step = 2.0},
                .start = 8.0,
                .rule = {.up = 2, .down = 3},
                .steps_up = {2.0},
                .steps_down = {2.0},
                .stop = {.trials = 50}}};
  const std::vector<bool> responses{true, true, true, false, false, false, true, false, false};
  EXPECT_THAT(levels_along(method, responses), testing::ElementsAre(8, 8, 8, 4, 4, 8, 8, 8, 8, 16));
}

TEST(WeightedUpDown, MovesUpByThreeStepsFor75Percent) {
  const WeightedUpDown method{.grid = kOneToTwenty,
                              .start = 10.0,
                              .target = 0.75,
                              .steps_down = {2.0, 1.0},
                              .stop = {.trials = 50}};
  // Down by 2; incorrect: reversal 1, up by 3·1; correct: reversal 2, down by 1; incorrect: up by 3.
  EXPECT_THAT(levels_along(method, {true, false, true, false}),
              testing::ElementsAre(10, 8, 11, 10, 13));
}

// 1 dB down and 3 dB up: 10^{1/20} and 10^{3/20}.
TEST(WeightedUpDown, MovesInDecibels) {
  const WeightedUpDown method{
      .grid = {.scale = LevelScale::decibel, .lowest = 0.01, .highest = 1.0, .step = 1.0},
      .start = 0.1,
      .target = 0.75,
      .steps_down = {1.0},
      .stop = {.trials = 50}};
  const std::vector<double> levels = levels_along(method, {true, false});
  EXPECT_NEAR(levels.at(1), 0.1 / 1.122018454, 1e-9);
  EXPECT_NEAR(levels.at(2), 0.1 / 1.122018454 * 1.412537545, 1e-9);
}

TEST(ConstantStimuli, PresentsEveryLevelOnceInEveryRepetition) {
  const ConstantStimuli method{.levels = {1.0, 2.0, 4.0, 8.0}, .repetitions = 3};
  const std::vector<double> levels = levels_along(method, std::vector<bool>(12, true));
  ASSERT_EQ(levels.size(), 12U);
  for (std::size_t first = 0; first < 12; first += 4) {
    EXPECT_THAT(std::vector(levels.begin() + static_cast<std::ptrdiff_t>(first),
                            levels.begin() + static_cast<std::ptrdiff_t>(first + 4)),
                testing::UnorderedElementsAre(1, 2, 4, 8));
  }
  EXPECT_NE(levels, levels_along(method, std::vector<bool>(12, true), Random(2)));
  EXPECT_EQ(levels, levels_along(method, std::vector<bool>(12, false)));
}

PosteriorTrack posterior_track() {
  return {
      .grid = kOneToTwenty,
      .prior = {.performance = 0.75, .thresholds = {.lowest = 1.0, .highest = 20.0, .count = 14}},
      .stop = {.trials = 40}};
}

// The trial of psi serves the threshold; QUEST+ also spends trials on the lapse rate, at the highest level, where a threshold
// cannot be learnt: its levels are therefore others.
TEST(Psi, BeginsAtTheLevelOfThePriorAndMovesTowardsTheThreshold) {
  const Psi method{.track = posterior_track()};
  const std::vector<double> levels = levels_along(method, std::vector<bool>(12, true));
  // Every correct response makes lower thresholds more probable.
  EXPECT_TRUE(std::is_sorted(levels.rbegin(), levels.rend()));
  EXPECT_LT(levels.back(), levels.front());
  const std::vector<double> after_errors = levels_along(method, {false, false, false});
  EXPECT_EQ(after_errors.front(), levels.front());
  EXPECT_GT(after_errors.back(), levels.front());
  EXPECT_NE(levels_along(QuestPlus{.track = posterior_track()}, std::vector<bool>(12, true)),
            levels);
}

// The choice of the first level by the definition, from the prior alone.
TEST(Psi, ChoosesTheLevelWithTheLeastExpectedEntropyOfTheParametersOfInterest) {
  for (const std::vector<NuisanceParameter>& nuisances :
       {std::vector<NuisanceParameter>{}, std::vector{NuisanceParameter::slope},
        std::vector{NuisanceParameter::slope, NuisanceParameter::lapse}}) {
    const PosteriorTrack track = posterior_track();
    const FunctionTable table(functions_of(track.prior, nuisances),
                              functions_of_group(track.prior, nuisances), levels_of(track.grid));
    const std::vector<double> expected = table.expected_entropies(table.uniform());
    const double least = *std::min_element(expected.begin(), expected.end());
    const double chosen = levels_along(Psi{.track = track, .marginalised = nuisances}, {}).front();
    EXPECT_NEAR(expected[nearest_index(track.grid, chosen)], least, 1e-9);
  }
}

TEST(QuestPlus, IsPsiWithoutNuisanceParameters) {
  const std::vector<bool> responses{true, true, false, true, true, true, false, true, true, false};
  EXPECT_EQ(levels_along(QuestPlus{.track = posterior_track()}, responses),
            levels_along(Psi{.track = posterior_track(), .marginalised = {}}, responses));
}

// A delivered level is used as it is: an error at 19.4 is evidence for a higher threshold than one at 6.4.
TEST(Psi, LearnsFromTheDeliveredLevel) {
  const Psi method{.track = posterior_track()};
  const auto next = [&](double delivered) {
    const NextStep step =
        next_step(method, answers_at(delivered, {false, false, false}), Random(1));
    return std::get<NextLevel>(step).level;
  };
  EXPECT_GT(next(14.4), next(3.4));
  // On the other side of the standard the difference is the same.
  Psi shifted = method;
  shifted.track.origin = 100.0;
  shifted.track.grid = {.scale = LevelScale::linear, .lowest = 80.0, .highest = 99.0, .step = 1.0};
  const auto below = next_step(shifted, answers_at(100.0 - 14.4, {false, false, false}), Random(1));
  EXPECT_EQ(100.0 - std::get<NextLevel>(below).level, next(14.4));
}

TEST(Psi, EndsWithAPreciseThresholdAfterEnoughResponsesOfEachKind) {
  Psi method{.track = posterior_track()};
  method.track.stop.trials = 200;
  method.track.stop.interval =
      IntervalRule{.ratio = 2.0, .minimum_trials = 10, .minimum_of_each = 8};
  const auto observer = [](double level) { return level < 6.0 ? 0.55 : 0.97; };
  const std::vector<LevelAnswer> track = simulated_track(method, observer, Random(7));
  EXPECT_GE(track.size(), 16U);
  EXPECT_LT(track.size(), 200U);
  EXPECT_EQ(next_step(method, track, Random(7)), NextStep(TrackEnd::interval));
  const auto incorrect = static_cast<std::size_t>(std::count_if(
      track.begin(), track.end(),
      [](const LevelAnswer& answer) { return answer.outcome != LevelOutcome::correct; }));
  EXPECT_GE(incorrect, 8U);
  // The interval at the end, by its definition.
  const auto functions = functions_of(method.track.prior, {});
  std::vector<PsychometricBlock> blocks{};
  for (const LevelAnswer& answer : track) {
    blocks.push_back({.x = answer.level,
                      .trials = 1,
                      .hits = answer.outcome == LevelOutcome::correct ? 1U : 0U});
  }
  const auto ratio = [&] {
    const CredibleThreshold threshold = credible_threshold(
        method.track.prior, functions, posterior_of(functions, blocks), {.performance = 0.75});
    return threshold.interval.high / threshold.interval.low;
  };
  EXPECT_LE(ratio(), 2.0);
  const bool had_enough = incorrect > 8 || track.back().outcome == LevelOutcome::correct;
  blocks.pop_back();
  EXPECT_TRUE(ratio() > 2.0 || !had_enough || track.size() == 16U);
  method.track.stop.interval->minimum_of_each = 0;
  method.track.stop.interval->minimum_trials = track.size() + 5;
  EXPECT_GE(simulated_track(method, observer, Random(7)).size(), track.size() + 5);
}

Psi precise_psi() {
  Psi psi{.track = posterior_track()};
  psi.track.stop.interval = IntervalRule{.ratio = 3.0, .minimum_trials = 10, .minimum_of_each = 3};
  return psi;
}

/// One of each procedure, with all stop rules.
std::vector<ProcedureSettings> one_of_each() {
  TransformedUpDown transformed = two_down();
  transformed.track.stop = {.trials = 40, .reversals = 10, .clipped_moves = 3};
  return {ConstantStimuli{.levels = {1.0, 2.0, 3.0}, .repetitions = 10}, transformed,
          WeightedUpDown{.grid = kOneToTwenty,
                         .start = 12.0,
                         .target = 0.75,
                         .steps_down = {2.0, 1.0},
                         .stop = {.trials = 40, .reversals = 12}},
          precise_psi(), QuestPlus{.track = posterior_track()}};
}

TEST(Procedures, GiveTheSameLevelsForEveryPrefixOfTheAnswers) {
  for (const ProcedureSettings& settings : one_of_each()) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      const Random of_track = Random(seed).split("track");
      const std::vector<LevelAnswer> whole = simulated_track(
          settings, [](double level) { return level > 4.0 ? 0.9 : 0.5; }, of_track);
      ASSERT_GT(whole.size(), 5U);
      for (std::size_t answered = 0; answered < whole.size(); ++answered) {
        const NextStep step = next_step(settings, std::span(whole).first(answered), of_track);
        ASSERT_TRUE(std::holds_alternative<NextLevel>(step));
        EXPECT_EQ(std::get<NextLevel>(step).level, whole[answered].level);
      }
      EXPECT_TRUE(std::holds_alternative<TrackEnd>(next_step(settings, whole, of_track)));
    }
  }
}

TEST(Procedures, PresentOnlyTheLevelsThatTheyDeclare) {
  for (const ProcedureSettings& settings : one_of_each()) {
    const std::vector<double> declared = procedure_of(settings).levels(settings);
    EXPECT_TRUE(std::is_sorted(declared.begin(), declared.end()));
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      for (const LevelAnswer& answer : simulated_track(
               settings, [](double) { return 0.7; }, Random(seed))) {
        EXPECT_THAT(declared, testing::Contains(answer.level));
      }
    }
  }
}

TEST(Procedures, StayFinishedWithFurtherAnswers) {
  for (const ProcedureSettings& settings : one_of_each()) {
    std::vector<LevelAnswer> answers = simulated_track(
        settings, [](double) { return 0.6; }, Random(4));
    for (int further = 0; further < 5; ++further) {
      EXPECT_TRUE(std::holds_alternative<TrackEnd>(next_step(settings, answers, Random(4))));
      answers.push_back({.level = 3.0, .outcome = forced_outcome(further % 2 == 0)});
    }
  }
}

TEST(UpDownTracks, EndByTheRuleThatAppliesFirst) {
  TransformedUpDown method = two_down();
  method.track.stop = {.trials = 4, .reversals = 2, .clipped_moves = 2};
  const auto end = [&method](const std::vector<LevelAnswer>& answers) {
    return next_step(method, answers, Random(1));
  };
  EXPECT_EQ(end(answers_at(10.0, {true, true, true})), NextStep(NextLevel{10.0}));
  EXPECT_EQ(end(answers_at(10.0, {true, true, true, true})), NextStep(TrackEnd::trials));
  method.track.stop.trials = 40;
  // Down, up, down: two reversals.
  EXPECT_EQ(end(answers_at(10.0, {true, true, false})), NextStep(NextLevel{12.0}));
  EXPECT_EQ(end(answers_at(10.0, {true, true, false, true, true})), NextStep(TrackEnd::reversals));
  // Up from 19 by 4 is shortened, from 20 prevented.
  EXPECT_EQ(end(answers_at(19.0, {false})), NextStep(NextLevel{20.0}));
  EXPECT_EQ(end(answers_at(20.0, {false, false})), NextStep(TrackEnd::bound));
}

TEST(UpDownTracks, StayAtABoundUntilAMoveLeadsAway) {
  const std::vector<bool> responses{false, false, false, false, false, true, true, true, true};
  // 10, 14, 18, 20, 20, 20; the first down move is a reversal: down by 1, then 1.
  EXPECT_THAT(levels_along(two_down(), responses),
              testing::ElementsAre(10, 14, 18, 20, 20, 20, 20, 19, 19, 18));
}

TEST(UpDownTracks, CountMovesBeyondABoundAgainAfterAnotherMove) {
  TransformedUpDown method = two_down();
  method.track.stop = {.trials = 40, .clipped_moves = 2};
  std::vector<LevelAnswer> answers = answers_at(20.0, {false, true, true, false});
  EXPECT_TRUE(std::holds_alternative<NextLevel>(next_step(method, answers, Random(1))));
  answers.push_back({.level = 20.0, .outcome = LevelOutcome::incorrect});
  EXPECT_EQ(next_step(method, answers, Random(1)), NextStep(TrackEnd::bound));
}

TEST(UpDownTracks, ContinueFromTheDeliveredLevel) {
  const TransformedUpDown method = two_down();
  // Delivered 12.3 where 10 was proposed: nearest 12, up by the first step of 4.
  EXPECT_EQ(next_step(method, answers_at(12.3, {false}), Random(1)), NextStep(NextLevel{16.0}));
  EXPECT_EQ(next_step(method, answers_at(10.4, {false}), Random(1)), NextStep(NextLevel{14.0}));
  EXPECT_EQ(next_step(method, answers_at(12.3, {true}), Random(1)), NextStep(NextLevel{12.0}));
  EXPECT_EQ(next_step(method, answers_at(500.0, {true, true}), Random(1)),
            NextStep(NextLevel{17.0}));
}

// --- the levels that a track approaches ----------------------------------------------------------

/// An observer of two alternatives on the linear grid.
double chance_of_correct(double level) {
  return 0.5 + 0.48 / (1.0 + std::exp(-0.25 * (level - 40.0)));
}

/// The long-run proportions of visits of the levels 1 to `count` of a track with steps of whole levels, and of correct
/// responses, exactly: the stationary distribution of the Markov chain whose state is the level with the number of
/// correct responses since the last move (a rule with 1 up).
struct LongRun {
  std::vector<double> visits{};
  double correct = 0.0;
};
LongRun long_run(std::size_t count, std::size_t down, std::size_t step_up, std::size_t step_down) {
  std::vector<double> now(count * down, 1.0 / static_cast<double>(count * down));
  for (int round = 0; round < 20000; ++round) {
    std::vector<double> after(now.size(), 0.0);
    for (std::size_t level = 0; level < count; ++level) {
      const double p = chance_of_correct(static_cast<double>(level + 1));
      for (std::size_t run = 0; run < down; ++run) {
        const double here = now[level * down + run];
        const std::size_t up_to = std::min(level + step_up, count - 1);
        const std::size_t down_to = level - std::min(level, step_down);
        after[up_to * down] += here * (1.0 - p);
        after[run + 1 < down ? level * down + run + 1 : down_to * down] += here * p;
      }
    }
    // A chain of period 2 does not settle; half of each step stays.
    for (std::size_t i = 0; i < now.size(); ++i) now[i] = 0.5 * (now[i] + after[i]);
  }
  LongRun result{.visits = std::vector<double>(count, 0.0)};
  for (std::size_t level = 0; level < count; ++level) {
    for (std::size_t run = 0; run < down; ++run) result.visits[level] += now[level * down + run];
    result.correct += result.visits[level] * chance_of_correct(static_cast<double>(level + 1));
  }
  return result;
}

struct Approach {
  ProcedureSettings settings{};
  std::size_t down = 1;
  std::size_t step_up = 1;
  double target = 0.5;
};

std::vector<Approach> approaches() {
  const LevelGrid grid{.scale = LevelScale::linear, .lowest = 1.0, .highest = 80.0, .step = 1.0};
  const StopRules stop{.trials = 1000};
  std::vector<Approach> all{};
  for (const auto& [down, target] : {std::pair{std::size_t{2}, 0.7071}, {std::size_t{3}, 0.7937}}) {
    all.push_back({.settings = TransformedUpDown{.track = {.grid = grid,
                                                           .start = 40.0,
                                                           .rule = {.up = 1, .down = down},
                                                           .steps_up = {1.0},
                                                           .steps_down = {1.0},
                                                           .stop = stop}},
                   .down = down,
                   .target = target});
  }
  all.push_back(
      {.settings =
           WeightedUpDown{
               .grid = grid, .start = 40.0, .target = 0.75, .steps_down = {1.0}, .stop = stop},
       .step_up = 3,
       .target = 0.75});
  return all;
}

/// The mean over tracks, and its standard error.
struct MeanOfTracks {
  double mean = 0.0;
  double error = 0.0;
};
MeanOfTracks mean_of_tracks(const std::vector<double>& of_tracks) {
  const double n = static_cast<double>(of_tracks.size());
  const double mean = std::accumulate(of_tracks.begin(), of_tracks.end(), 0.0) / n;
  double sum = 0.0;
  for (const double value : of_tracks) sum += (value - mean) * (value - mean);
  return {.mean = mean, .error = std::sqrt(sum / (n - 1.0) / n)};
}

/// 1-up/1-down to 75 % with steps of 3 down and 9 up, among `alternatives` with the option "cannot tell".
WeightedUpDown unforced(std::size_t alternatives) {
  return {.grid = {.scale = LevelScale::linear, .lowest = 1.0, .highest = 100.0, .step = 1.0},
          .start = 40.0,
          .steps_down = {3.0},
          .stop = {.trials = 400},
          .unforced_alternatives = alternatives};
}

double level_after(const ProcedureSettings& settings, LevelOutcome outcome) {
  const std::vector<LevelAnswer> answers{{.level = 40.0, .outcome = outcome}};
  return std::get<NextLevel>(next_step(settings, answers, Random(1))).level;
}

// [Kaernbach 2001]: with two alternatives one step down for a correct response, one up for "cannot tell", three up for an
// incorrect one. With three alternatives a guess is correct in a third of the trials: (−3 + 9 + 9)/3 = 5.
TEST(UnforcedWeightedUpDown, MovesUpByTheMeanStepOfAGuessAfterCannotTell) {
  for (const std::size_t alternatives : {2U, 3U}) {
    const ProcedureSettings settings = unforced(alternatives);
    EXPECT_EQ(level_after(settings, LevelOutcome::correct), 37.0);
    EXPECT_EQ(level_after(settings, LevelOutcome::incorrect), 49.0);
    EXPECT_EQ(level_after(settings, LevelOutcome::unsure), alternatives == 2 ? 43.0 : 45.0);
  }
}

TEST(UnforcedWeightedUpDown, CountsCannotTellAsAMoveUpInReversals) {
  WeightedUpDown method = unforced(2);
  method.stop.reversals = 2;
  std::vector<LevelAnswer> answers{{40.0, LevelOutcome::correct}, {37.0, LevelOutcome::unsure}};
  EXPECT_EQ(std::get<NextLevel>(next_step(method, answers, Random(1))).level, 40.0);
  answers.push_back({40.0, LevelOutcome::incorrect});
  EXPECT_EQ(std::get<NextLevel>(next_step(method, answers, Random(1))).level, 49.0);
  answers.push_back({49.0, LevelOutcome::correct});
  EXPECT_EQ(std::get<TrackEnd>(next_step(method, answers, Random(1))), TrackEnd::reversals);
}

TEST(UnforcedWeightedUpDown, RefusesATargetWithoutAStepAfterCannotTell) {
  WeightedUpDown method = unforced(2);
  method.target = 0.5;
  ASSERT_EQ(problems_of(method).size(), 1U);
  EXPECT_THAT(problems_of(method).front().message.english(),
              testing::HasSubstr("is not above 1/2"));
  method.unforced_alternatives.reset();
  EXPECT_TRUE(problems_of(method).empty());
  method = unforced(3);
  method.steps_down = {1.0};  // 5/3 of it is no level
  ASSERT_EQ(problems_of(method).size(), 1U);
  EXPECT_EQ(problems_of(method).front().setting, "target");
  EXPECT_THAT(problems_of(method).front().message.english(), testing::HasSubstr("a finer grid"));
}

// ψ = D + (1 − D)/2, where D is the probability of perceiving the difference; half of the observer's guesses are replaced by
// "cannot tell". The proportion correct in which such a response counts 1/2 is then that of an observer who guesses, and
// tracks approach its target.
TEST(UnforcedWeightedUpDown, ApproachesTheTargetOfTheForcedProcedure) {
  WeightedUpDown method = unforced(2);
  method.steps_down = {1.0};
  const OutcomeOfObserver observer = [](double level, Random& random) {
    const double perceives = 1.0 / (1.0 + std::exp(-(level - 50.0) / 8.0));
    if (random.uniform() < perceives) return LevelOutcome::correct;
    if (random.uniform() < 0.5) return LevelOutcome::unsure;
    return forced_outcome(random.uniform() < 0.5);
  };
  const LevelRule rule = level_rule(method);
  std::vector<double> proportions{};
  std::vector<double> levels{};
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const std::vector<LevelAnswer> track = simulated_track(rule, observer, Random(seed));
    const auto late = std::span(track).subspan(100);
    double hits = 0.0;
    double level = 0.0;
    for (const LevelAnswer& answer : late) {
      hits += answer.outcome == LevelOutcome::correct  ? 1.0
              : answer.outcome == LevelOutcome::unsure ? 0.5
                                                       : 0.0;
      level += answer.level;
    }
    proportions.push_back(hits / static_cast<double>(late.size()));
    levels.push_back(level / static_cast<double>(late.size()));
  }
  const MeanOfTracks proportion = mean_of_tracks(proportions);
  const MeanOfTracks level = mean_of_tracks(levels);
  EXPECT_NEAR(proportion.mean, 0.75, 4.0 * proportion.error + 0.003);  // the ends of the tracks
  EXPECT_NEAR(level.mean, 50.0, 4.0 * level.error + 1.0);              // ψ(50) = 75 %
  EXPECT_LT(level.error, 1.0);
}

// In the rule for the end of psi "cannot tell" counts with the incorrect responses.
TEST(Psi, TakesCannotTellAsTheMeanOfAGuess) {
  const LevelGrid grid{.lowest = 1.0, .highest = 20.0, .step = 1.0};
  const Psi method{
      .track = {.grid = grid,
                .prior = {.thresholds = thresholds_within(grid, 0.0)},
                .stop = {.trials = 20,
                         .interval = IntervalRule{
                             .ratio = 1e6, .minimum_trials = 1, .minimum_of_each = 1}}}};
  std::vector<LevelAnswer> answers{{10.0, LevelOutcome::unsure}, {10.0, LevelOutcome::unsure}};
  const auto after_unsure = next_step(method, answers, Random(1));
  ASSERT_TRUE(std::holds_alternative<NextLevel>(after_unsure));
  // A correct and an incorrect response have the same likelihood as two split ones.
  Psi without_rule = method;
  without_rule.track.stop.interval.reset();
  const std::vector<LevelAnswer> both{{10.0, LevelOutcome::correct},
                                      {10.0, LevelOutcome::incorrect}};
  EXPECT_EQ(std::get<NextLevel>(after_unsure),
            std::get<NextLevel>(next_step(without_rule, both, Random(1))));
  answers.push_back({10.0, LevelOutcome::correct});
  EXPECT_EQ(std::get<TrackEnd>(next_step(method, answers, Random(1))), TrackEnd::interval);
}

// Trials of a track are correlated; tracks are independent, so that their spread gives the standard error.
TEST(UpDownTracks, VisitLevelsAsOftenAsTheirMarkovChain) {
  for (const Approach& approach : approaches()) {
    const LongRun exact = long_run(80, approach.down, approach.step_up, 1);
    constexpr std::size_t kBefore = 200;  // the start is forgotten
    std::vector<double> levels{};
    std::vector<double> squares{};
    std::vector<double> correct{};
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const std::vector<LevelAnswer> track =
          simulated_track(approach.settings, chance_of_correct, Random(seed));
      const auto late = std::span(track).subspan(kBefore);
      const auto mean_over = [&late](const auto& value) {
        double sum = 0.0;
        for (const LevelAnswer& answer : late) sum += value(answer);
        return sum / static_cast<double>(late.size());
      };
      levels.push_back(mean_over([](const LevelAnswer& answer) { return answer.level; }));
      squares.push_back(
          mean_over([](const LevelAnswer& answer) { return answer.level * answer.level; }));
      correct.push_back(mean_over([](const LevelAnswer& answer) {
        return answer.outcome == LevelOutcome::correct ? 1.0 : 0.0;
      }));
    }
    double exact_level = 0.0;
    double exact_square = 0.0;
    for (std::size_t i = 0; i < exact.visits.size(); ++i) {
      const double level = static_cast<double>(i + 1);
      exact_level += level * exact.visits[i];
      exact_square += level * level * exact.visits[i];
    }
    constexpr double kErrors = 4.0;
    const MeanOfTracks level = mean_of_tracks(levels);
    EXPECT_NEAR(level.mean, exact_level, kErrors * level.error);
    EXPECT_LT(level.error, 0.5);
    const MeanOfTracks square = mean_of_tracks(squares);
    EXPECT_NEAR(square.mean, exact_square, kErrors * square.error);
    const MeanOfTracks proportion = mean_of_tracks(correct);
    EXPECT_NEAR(proportion.mean, exact.correct, kErrors * proportion.error);
    EXPECT_LT(proportion.error, 0.005);
  }
}

TEST(UpDownTracks, ApproachTheirTargetWithSmallSteps) {
  for (const Approach& approach : approaches()) {
    const Procedure& procedure = procedure_of(approach.settings);
    EXPECT_NEAR(*procedure.target(approach.settings), approach.target, 5e-5);
    // Exactly the target for 1 down, but for the bounds: then every response is a move. With more down, a trial more
    // is spent at the level where a run is not finished, and p varies between levels.
    const double margin = approach.down == 1 ? 1e-3 : 0.012;
    EXPECT_NEAR(long_run(80, approach.down, approach.step_up, 1).correct, approach.target, margin);
  }
}

// --- lengths -------------------------------------------------------------------------------------

TEST(Procedures, ExpectTheirFixedNumberOfTrials) {
  const auto guessing = [](double) { return 0.5; };
  EXPECT_EQ(expected_trials(ConstantStimuli{.levels = {1.0, 2.0}, .repetitions = 30}, guessing),
            60.0);
  EXPECT_EQ(expected_trials(two_down(), guessing), 50.0);
}

// 1-up/1-down at p = ½: every response after the first reverses with probability ½, so that r reversals need 1 + 2r
// trials on average, with a variance of 2r: 21 for 10, with a standard error of √20/√400 = 0.22.
TEST(Procedures, ExpectTheTrialsThatTheirReversalsNeed) {
  TransformedUpDown method = two_down();
  method.track.grid.highest = 1000.0;
  method.track.start = 500.0;
  method.track.rule = {.up = 1, .down = 1};
  method.track.stop = {.trials = 500, .reversals = 10};
  EXPECT_NEAR(expected_trials(method, [](double) { return 0.5; }), 21.0, 0.9);
  method.track.stop.trials = 15;
  const double limited = expected_trials(method, [](double) { return 0.5; });
  EXPECT_LT(limited, 15.0);
  EXPECT_GT(limited, 11.0);  // 10 reversals need at least 11 trials
}

TEST(Procedures, AreFoundByTheirNames) {
  for (const Procedure* procedure : procedures()) {
    EXPECT_EQ(find_procedure(procedure->id), procedure);
    EXPECT_FALSE(procedure->meaning.empty());
  }
  EXPECT_EQ(find_procedure("telepathy"), nullptr);
  EXPECT_EQ(procedure_of(two_down()).id, "transformed_up_down");
  EXPECT_EQ(procedure_of(WeightedUpDown{}).id, "weighted_up_down");
  EXPECT_EQ(procedure_of(ConstantStimuli{}).id, "constant_stimuli");
}

}  // namespace
}  // namespace asperity
