// Running tracks: levels, answers and estimates from the attempts of a session so far.

#include "app/session/running_track.h"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "protocols/file/protocol_reader.h"
#include "protocols/plan/course.h"
#include "renderers/built_in_models.h"

namespace asperity {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

std::string staircase(const std::string& procedure) {
  return R"({
    "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "tracked",
    "version": "1.0.0", "title": "Tracks",
    "consent": {"version": "1.0", "statement": "I take part of my own free will."},
    "stimuli": {"wave": {"model": "sinusoid", "parameters": {"amplitude_m": 0.0001}}},
    "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
    "blocks": {"main": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
               "levels_percent": {"lowest": 10, "highest": 90, "step": 10}},
      "procedure": )" +
         procedure + R"(,
      "presented": [{"role": "standard", "stimulus": "wave"}, {"role": "comparison", "stimulus": "wave"}],
      "positions": "balanced", "exploration": "short",
      "question": {"name": "stronger", "prompt": "Which is stronger?", "judgement": "performance"}}},
    "flow": [{"run": "main"}]})";
}

constexpr const char* kOneUpOneDown =
    R"({"method": "transformed_up_down", "down": 1, "up": 1, "steps": [10], "start": 50, "stop": {"trials": 8}})";

/// A session whose answers are given one by one.
class Tracked {
 public:
  explicit Tracked(const std::string& text)
      : protocol_(read_protocol(text, "tracked.json", declarations())),
        course_(protocol_, {.seed = 7, .counterbalance_row = 0}) {}

  void answer(LevelOutcome outcome) {
    const Trial& trial = *course_.awaited();
    const Dimension& dimension = *protocol_.blocks.at("main").vary;
    const double value = std::get<double>(trial.factors.at(dimension.factor));
    AttemptSummary attempt{};
    attempt.trial = trial.ordinal;
    attempt.attempt = 1;
    attempt.answer_of_track = LevelAnswer{.level = dimension.level_of(value), .outcome = outcome};
    attempts.push_back(attempt);
    course_.advance({.answer = TrialOutcome::Answer{.value = value, .outcome = outcome}});
  }
  void answer(bool is_correct) { answer(forced_outcome(is_correct)); }
  std::optional<RunningTracks> tracks() const {
    return running_tracks(protocol_, course_.plan(), attempts, 1);
  }
  const Trial& awaited() const { return *course_.awaited(); }

  std::vector<AttemptSummary> attempts{};

 private:
  static std::vector<ModelDeclaration> declarations() {
    std::vector<ModelDeclaration> models{};
    const ModelRegistry registry = built_in_models();
    for (const ForceModel& model : registry.models()) models.push_back(model.declaration);
    return models;
  }
  Protocol protocol_{};
  Course course_;
};

std::vector<double> levels_of(const RunningTrack& track) {
  std::vector<double> levels{};
  for (const RunningTrial& trial : track.trials) levels.push_back(std::round(trial.level));
  return levels;
}

// 50 ↓ 40 ↓ 30 ↑ 40 ↓ 30: the moves turn at 30, at 40 and at 30 again.
TEST(RunningTrack, HasTheLevelsAndTheMeanOfTheReversals) {
  Tracked session(staircase(kOneUpOneDown));
  ASSERT_TRUE(session.tracks());
  EXPECT_THAT(session.tracks()->tracks, IsEmpty());
  for (const bool correct : {true, true, false}) session.answer(correct);
  RunningTrack track = session.tracks()->tracks.at(0);
  EXPECT_EQ(levels_of(track), (std::vector<double>{50, 40, 30}));
  EXPECT_EQ(track.reversals, 1U);
  EXPECT_NEAR(track.estimate->level, 30.0, 1e-9);
  for (const bool correct : {true, false}) session.answer(correct);
  track = session.tracks()->tracks.at(0);
  EXPECT_EQ(levels_of(track), (std::vector<double>{50, 40, 30, 40, 30}));
  EXPECT_EQ(track.reversals, 3U);
  EXPECT_NEAR(track.estimate->level, 100.0 / 3.0, 1e-9);
  EXPECT_EQ(session.tracks()->unit, "%");
  EXPECT_EQ(session.tracks()->quantity, "amplitude_m");
  EXPECT_EQ(track.trials[1].outcome, LevelOutcome::correct);
  EXPECT_EQ(track.trials[2].outcome, LevelOutcome::incorrect);
}

TEST(RunningTrack, IsNotMadeOfConstantStimuli) {
  Tracked session(staircase(R"({"method": "constant_stimuli", "repetitions": 2})"));
  session.answer(true);
  EXPECT_FALSE(session.tracks());
}

TEST(RunningTrack, LeavesOutAttemptsThatDoNotCount) {
  Tracked session(staircase(kOneUpOneDown));
  AttemptSummary invalid{};
  invalid.trial = session.awaited().ordinal;
  invalid.attempt = 1;
  invalid.answer_of_track = LevelAnswer{.level = 50.0, .outcome = LevelOutcome::incorrect};
  invalid.valid = false;
  session.attempts.push_back(invalid);
  EXPECT_THAT(session.tracks()->tracks, IsEmpty());
  AttemptSummary skipped{};
  skipped.trial = session.awaited().ordinal;
  skipped.attempt = 2;
  skipped.outcome = AttemptOutcome::skipped;
  session.attempts.push_back(skipped);
  EXPECT_THAT(session.tracks()->tracks, IsEmpty());
  session.answer(true);
  EXPECT_THAT(session.tracks()->tracks.at(0).trials, SizeIs(1));
}

TEST(RunningTrack, HasThePosteriorMedianWithItsInterval) {
  Tracked session(staircase(R"({"method": "psi", "stop": {"trials": 40}})"));
  double width = 0.0;
  for (int i = 0; i < 30; ++i) {
    const double level =
        100.0 * (std::get<double>(session.awaited().factors.begin()->second) / 0.0001 - 1.0);
    session.answer(level > 40.0);
    if (i == 4) {
      const RunningEstimate early = *session.tracks()->tracks.at(0).estimate;
      width = *early.high / *early.low;
    }
  }
  const RunningEstimate late = *session.tracks()->tracks.at(0).estimate;
  EXPECT_LT(*late.low, late.level);
  EXPECT_LT(late.level, *late.high);
  EXPECT_LT(*late.high / *late.low, width);
  EXPECT_GT(late.level, 25.0);
  EXPECT_LT(late.level, 55.0);
}

// A guess of two alternatives is half a correct and half an incorrect response.
TEST(RunningTrack, CountsAnUnsureResponseAsAGuess) {
  const std::string psi = staircase(R"({"method": "psi", "stop": {"trials": 40}})");
  const auto estimate_with = [&psi](LevelOutcome first, LevelOutcome second) {
    Tracked session(psi);
    session.answer(first);
    session.answer(second);
    // At one level, whichever the procedure chose.
    for (AttemptSummary& attempt : session.attempts) attempt.answer_of_track->level = 50.0;
    return session.tracks()->tracks.at(0).estimate->level;
  };
  const double unsure = estimate_with(LevelOutcome::unsure, LevelOutcome::unsure);
  EXPECT_NEAR(unsure, estimate_with(LevelOutcome::correct, LevelOutcome::incorrect), 1e-9);
  EXPECT_LT(unsure, estimate_with(LevelOutcome::incorrect, LevelOutcome::incorrect));
}

}  // namespace
}  // namespace asperity
