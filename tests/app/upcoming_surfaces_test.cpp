// Surfaces that are made while the trial before is carried out: they are those that would be made between the trials.

#include "app/session/upcoming_surfaces.h"

#include <chrono>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ::testing::UnorderedElementsAre;

/// One track; a correct response lowers the level by a step, an incorrect one raises it.
constexpr const char* kOneTrack = R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "one_track",
  "version": "1.0.0", "title": "One track",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
  "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2}},
  "blocks": {"track": {
    "exploration": "short",
    "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
             "levels_percent": {"lowest": 10, "highest": 100, "step": 10}},
    "procedure": {"method": "transformed_up_down", "down": 1, "up": 1, "steps": [10], "stop": {"trials": 6},
                  "tracks": [{"start": 50}]},
    "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
    "positions": "balanced", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
    "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
  "flow": [{"run": "track"}]})";

class UpcomingSurfacesTest : public SessionTest {
 protected:
  /// `sinusoid`, which reports the amplitude of every renderer that it makes, and where.
  void SetUp() override {
    ForceModel sinusoid = *models_.find("sinusoid");
    sinusoid.make = [this, make = sinusoid.make](const RendererInputs& inputs) {
      const double amplitude_m = std::get<double>(inputs.parameters.at("amplitude_m"));
      {
        const std::lock_guard lock(mutex_);
        (std::this_thread::get_id() == own_thread_ ? made_here_m_ : made_ahead_m_)
            .push_back(amplitude_m);
      }
      if (std::this_thread::get_id() != own_thread_) {
        std::this_thread::sleep_for(pause_);
        if (fails_ahead_) throw std::runtime_error("no memory");
      }
      return make(inputs);
    };
    models_ = {};
    models_.add(std::move(sinusoid));
    begin(kOneTrack);
  }

  std::size_t made_ahead() {
    const std::lock_guard lock(mutex_);
    return made_ahead_m_.size();
  }
  void wait_until_made_ahead(std::size_t renderers) {
    constexpr std::chrono::minutes kMost{2};
    const auto last = std::chrono::steady_clock::now() + kMost;
    while (made_ahead() < renderers) {
      if (std::chrono::steady_clock::now() > last) throw std::runtime_error("nothing was made");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  /// The first attempts at the trials that can follow the first one.
  std::vector<NextTrial> possible_next() const {
    std::vector<NextTrial> next{};
    for (const Trial& trial : session_.course->possible_next()) next.push_back({.trial = trial});
    return next;
  }

  std::mutex mutex_{};
  std::vector<double> made_ahead_m_{};
  std::vector<double> made_here_m_{};
  std::thread::id own_thread_ = std::this_thread::get_id();
  bool fails_ahead_ = false;
  std::chrono::milliseconds pause_{0};  ///< of every renderer that is made ahead
};

TEST_F(UpcomingSurfacesTest, AreMadeForEveryOutcomeBeforeTheResponse) {
  UpcomingSurfaces upcoming(*builder_, *study_);
  upcoming.begin(session_.row);
  const std::vector<NextTrial> next = possible_next();
  ASSERT_EQ(next.size(), 3U) << "correct, incorrect, none";
  upcoming.make_ahead(next);
  wait_until_made_ahead(6);
  EXPECT_THAT(made_ahead_m_,
              UnorderedElementsAre(5e-5, 5e-5, 5e-5, testing::DoubleEq(7e-5),
                                   testing::DoubleEq(8e-5), testing::DoubleEq(7.5e-5)));
  const TrialSurfaces surfaces = upcoming.take(next[1].trial, 1);
  EXPECT_EQ(surfaces.size(), 2U);
  EXPECT_TRUE(made_here_m_.empty()) << "nothing is made after the response";
}

TEST_F(UpcomingSurfacesTest, AreThoseThatAreMadeBetweenTheTrials) {
  UpcomingSurfaces ahead(*builder_, *study_);
  ahead.begin(session_.row);
  ahead.make_ahead(possible_next());
  wait_until_made_ahead(6);
  UpcomingSurfaces between(*builder_, *study_);
  between.begin(session_.row);
  for (const NextTrial& next : possible_next()) {
    TrialSurfaces made = ahead.take(next.trial, 1);
    TrialSurfaces same = between.take(next.trial, 1);
    for (std::size_t i = 0; i < made.size(); ++i) {
      EXPECT_EQ(made.seed(i), same.seed(i));
      EXPECT_EQ(made.stimulus(i).inputs.parameters, same.stimulus(i).inputs.parameters);
    }
  }
}

TEST_F(UpcomingSurfacesTest, OfOtherTrialsAndAttemptsAreNotTaken) {
  UpcomingSurfaces upcoming(*builder_, *study_);
  upcoming.begin(session_.row);
  upcoming.make_ahead(possible_next());
  wait_until_made_ahead(6);
  upcoming.take(session_.course->plan().trials.front(), 1);
  EXPECT_EQ(made_here_m_.size(), 2U);
  upcoming.take(possible_next().front().trial, 2);
  EXPECT_EQ(made_here_m_.size(), 4U);
}

// The session reports the error of the attempt, as if nothing had been made ahead.
TEST_F(UpcomingSurfacesTest, ThatCouldNotBeMadeAheadAreMadeWhenTheyAreNeeded) {
  fails_ahead_ = true;
  UpcomingSurfaces upcoming(*builder_, *study_);
  upcoming.begin(session_.row);
  const std::vector<NextTrial> next = possible_next();
  upcoming.make_ahead(next);
  wait_until_made_ahead(1);
  EXPECT_EQ(upcoming.take(next.front().trial, 1).size(), 2U);
  EXPECT_EQ(made_here_m_.size(), 2U);
}

TEST_F(UpcomingSurfacesTest, AreKeptWhereTheSameTrialsCanFollowAgain) {
  UpcomingSurfaces upcoming(*builder_, *study_);
  upcoming.begin(session_.row);
  upcoming.make_ahead(possible_next());
  wait_until_made_ahead(6);
  upcoming.make_ahead(possible_next());
  upcoming.take(possible_next().back().trial, 1);
  EXPECT_EQ(made_ahead(), 6U);
  EXPECT_TRUE(made_here_m_.empty());
}

// A session that ends does not wait for what is not needed: here eight seconds.
TEST_F(UpcomingSurfacesTest, ThatAreNotBegunAreNotMadeAtTheEnd) {
  pause_ = std::chrono::milliseconds(20);
  std::vector<NextTrial> many{};
  for (int attempt = 1; attempt <= 200; ++attempt) {
    many.push_back({.trial = session_.course->plan().trials.front(), .attempt = attempt});
  }
  {
    UpcomingSurfaces upcoming(*builder_, *study_);
    upcoming.begin(session_.row);
    upcoming.make_ahead(std::move(many));
    wait_until_made_ahead(1);
  }
  EXPECT_LT(made_ahead(), 400U);
}

TEST_F(UpcomingSurfacesTest, DoNotChangeASession) {
  const auto attempts_with = [this](bool makes_ahead) {
    start(makes_ahead ? "ahead" : "between", 5);
    person_.at_question = [this, makes_ahead](int, const Trial& trial) {
      if (makes_ahead) wait_until_made_ahead(1);
      return reply_that_is(trial, trial.ordinal % 3 != 0);
    };
    Conductor conductor(*study_, protocol_, *builder_, *rig_, person_,
                        {.makes_ahead = makes_ahead});
    EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
    std::vector<std::string> rendered{};
    for (const AttemptRow& attempt : attempts()) {
      for (const PresentationRow& surface : attempt.presentations) {
        rendered.push_back(surface.seed + ' ' + surface.parameters_json);
      }
    }
    return std::pair(stored_plan(), rendered);
  };
  const auto between = attempts_with(false);
  // Attempts are judged for perceived instability on another thread in both.
  const std::size_t judged = made_ahead();
  EXPECT_EQ(attempts_with(true), between);
  EXPECT_GT(made_ahead(), 2 * judged);
}

}  // namespace
}  // namespace asperity
