// The sounds of a session: masking noise, guiding tones, cues.

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/watched_session.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(WatchedSession, PlaysItsNoiseFromBeforeTheContactUntilAfterIt) {
  play_sound();
  begin(one_trial(with_noise(small_protocol(R"(, "pause_before_trial_s": 0.5)"))));
  run();
  const std::vector<SoundLog::MaskingSwitch> masking = sound_.masking();
  ASSERT_EQ(masking.size(), 2U);
  const AttemptRow attempt = attempts().front();
  EXPECT_TRUE(masking[0].on);
  EXPECT_LT(masking[0].time_ns, *attempt.presentations[0].contact_ns);
  EXPECT_FALSE(masking[1].on);
  EXPECT_GT(masking[1].time_ns, *attempt.presentations[1].offset_ns);
  ASSERT_EQ(events_of("masking_noise").size(), 1U);
  EXPECT_EQ(events_of("masking_noise")[0].data_json, R"({"kind":"pink"})");
}

TEST_F(WatchedSession, LetsTheNoiseFadeInWhereThereIsNoPauseBeforeTheTrial) {
  play_sound();
  begin(one_trial(with_noise(small_protocol(R"(, "pause_before_trial_s": 0)"))));
  run();
  EXPECT_GE(*attempts().front().presentations[0].onset_ns - sound_.masking().at(0).time_ns,
            200'000'000);
}

TEST_F(WatchedSession, TellsTheHandByTonesUntilItHasEnoughOfTheSurface) {
  play_sound();
  begin(small_protocol("", R"(, "guidance": "tones", "normal_force_N": {"minimum": 0.5})"));
  rig_->at_pass = [this] {
    const bool is_told = sound_.guide() != GuideTone::none;
    EXPECT_TRUE(!is_told || monitor_.snapshot().hand.force_N.samples > 0);
  };
  person_.at_question = [this](int, const Trial&) -> Reply {
    EXPECT_EQ(sound_.guide(), GuideTone::none);
    return chooses(0);
  };
  run();
  // The force rises on each of six surfaces, and is then enough.
  const std::vector<GuideTone> guides = sound_.guides();
  EXPECT_EQ(std::count(guides.begin(), guides.end(), GuideTone::press_more), 6);
  EXPECT_EQ(std::count(guides.begin(), guides.end(), GuideTone::none), 7);
}

TEST_F(WatchedSession, TellsTheHandNothingByTonesWhereTheProtocolDoesNot) {
  play_sound();
  begin(small_protocol("", R"(, "normal_force_N": {"minimum": 3})"));
  run();
  EXPECT_THAT(sound_.guides(), testing::Each(GuideTone::none));
}

/// A hand that is told to press more from its first touch on, until whatever `act` does.
class TonedSession : public WatchedSession {
 protected:
  void begin_told_to_press_more() {
    play_sound();
    begin(small_protocol("", R"(, "guidance": "tones", "normal_force_N": {"minimum": 3})"));
  }
  bool tone_sounds() const { return sound_.guide() != GuideTone::none; }
};

TEST_F(TonedSession, IsSilentOnceItHasEnded) {
  begin_told_to_press_more();
  run();
  EXPECT_THAT(sound_.guides(), Contains(GuideTone::press_more));
  EXPECT_EQ(sound_.guide(), GuideTone::none);
}

TEST_F(TonedSession, IsSilentAfterAFailureInTheMiddleOfATone) {
  begin_told_to_press_more();
  rig_->at_pass = [this] {
    if (tone_sounds()) throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_THAT(sound_.guides(), Contains(GuideTone::press_more));
  EXPECT_EQ(sound_.guide(), GuideTone::none);
}

TEST_F(TonedSession, AsksNothingOfAHandWhileItsSurfaceIsTakenAway) {
  begin_told_to_press_more();
  bool aborted = false;
  int passes_after = 0;
  rig_->at_pass = [&] {
    if (aborted) {
      ++passes_after;
      EXPECT_EQ(sound_.guide(), GuideTone::none);
    }
    if (!tone_sounds() || aborted) return;
    requests_.abort("enough");
    aborted = true;
  };
  EXPECT_EQ(run().state, SessionState::stopped);
  EXPECT_TRUE(aborted);
  EXPECT_GT(passes_after, 1);
  EXPECT_EQ(sound_.guide(), GuideTone::none);
}

TEST_F(TonedSession, StoresWhetherAnybodyIsGuided) {
  begin_told_to_press_more();
  run();
  ASSERT_EQ(events_of("guidance").size(), 1U);
  EXPECT_EQ(events_of("guidance")[0].text, "given");
  sound_.is_heard = false;
  SessionConditions conditions{};
  conditions.seed = 8;
  conditions.pacing = rig_->pacing();
  conditions.started_utc = rig_->clock().utc();
  conditions.device = rig_->capability();
  study_->add_participant({.label = "p2", .created_utc = "2026-01-01T00:00:00.000Z"});
  session_ = begin_session(*study_, protocol_, "p2", conditions, this_program());
  run();
  ASSERT_EQ(events_of("guidance").size(), 1U);
  EXPECT_EQ(events_of("guidance")[0].text, "not_given");
}

TEST_F(WatchedSession, PlaysNoNoiseThatTheProtocolDoesNotWant) {
  play_sound();
  begin(one_trial());
  run();
  EXPECT_TRUE(sound_.masking().empty());
}

TEST_F(WatchedSession, SoundsTheCuesOfATrial) {
  play_sound();
  begin(one_trial());
  run();
  EXPECT_THAT(sound_.cues(), ElementsAre("surface 1", "next", "surface 2", "next", "question",
                                         "accepted", "finished"));
}

TEST_F(WatchedSession, SaysWhetherItsNoiseSoundsAndNothingOfItOnceItHasEnded) {
  play_sound();
  begin(one_trial(with_noise(small_protocol())));
  std::set<MaskingState> in_contact{};
  std::set<MaskingState> in_reading{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase == SessionPhase::contact) in_contact.insert(now.masking);
    if (now.phase == SessionPhase::ready) in_reading.insert(now.masking);
  };
  run();
  EXPECT_THAT(in_contact, ElementsAre(MaskingState::on));
  EXPECT_THAT(in_reading, ElementsAre(MaskingState::off));
  EXPECT_EQ(monitor_.snapshot().masking, MaskingState::none);
}

// What counts the samples of a card that is not there may be late: nobody hears the difference.
TEST_F(WatchedSession, ContinuesWithoutASoundCardAndSaysThatNobodyHearsItsNoise) {
  play_sound();
  sound_.is_heard = false;
  begin(one_trial(with_noise(small_protocol())));
  std::set<MaskingState> in_contact{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase != SessionPhase::contact) return;
    in_contact.insert(now.masking);
    sound_.is_running = false;
  };
  run();
  EXPECT_THAT(in_contact, ElementsAre(MaskingState::no_card));
  ASSERT_EQ(attempts().size(), 1U);
  EXPECT_TRUE(attempts()[0].valid);
}

TEST_F(WatchedSession, TakesNoiseFromElsewhereAsHeardOnceItIsAttested) {
  play_sound();
  sound_.is_heard = false;
  sound_.is_attested = true;
  begin(one_trial(with_noise(small_protocol())));
  std::set<MaskingState> seen{};
  rig_->at_pass = [&] { seen.insert(monitor_.snapshot().masking); };
  run();
  EXPECT_THAT(seen, Contains(MaskingState::elsewhere));
  EXPECT_THAT(seen, testing::Not(Contains(MaskingState::no_card)));
}

TEST_F(WatchedSession, SaysNothingOfNoiseThatTheProtocolDoesNotWant) {
  play_sound();
  sound_.is_heard = false;
  begin(one_trial());
  std::set<MaskingState> seen{};
  rig_->at_pass = [&] { seen.insert(monitor_.snapshot().masking); };
  run();
  EXPECT_THAT(seen, ElementsAre(MaskingState::none));
}

TEST_F(WatchedSession, SaysThatTheNoiseCannotBeginWhereItNeverSounded) {
  play_sound();
  sound_.is_running = false;
  begin(one_trial(with_noise(small_protocol())));
  std::string said{};
  once_in(SessionPhase::paused, [&] {
    const SessionSnapshot now = monitor_.snapshot();
    said = now.trouble->what.english();
    EXPECT_EQ(now.masking, MaskingState::silent);
    sound_.is_running = true;
    requests_.resume();
  });
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(said, HasSubstr("cannot start"));
  EXPECT_TRUE(events_of("masking_noise_lost").empty());
  EXPECT_EQ(events_of("masking_noise_missing").size(), 1U);
  EXPECT_EQ(attempts().size(), 1U);
}

TEST_F(WatchedSession, PausesWhenTheNoiseStopsAndAsksTheTrialAgain) {
  play_sound();
  begin(one_trial(with_noise(small_protocol())));
  bool lost = false;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase == SessionPhase::contact && !lost) {
      lost = true;
      sound_.is_running = false;
    }
    if (now.phase == SessionPhase::paused && now.trouble) {
      EXPECT_EQ(now.trouble->remedy, SessionTrouble::Remedy::resume);
      EXPECT_THAT(now.trouble->what.english(), HasSubstr("masking noise"));
      EXPECT_TRUE(now.trouble->what.can_be_translated());
      EXPECT_EQ(rig_->loop().status().presentation, 0U);  // nothing is under the hand
      sound_.is_running = true;
      requests_.resume();
    }
  };
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::aborted);
  EXPECT_EQ(rows[0].invalid_reason.value().text, "the masking noise stopped");
  EXPECT_TRUE(rows[1].valid);
  EXPECT_FALSE(monitor_.snapshot().trouble);
}

TEST_F(WatchedSession, PausesWhenTheNoiseStoppedAlsoIfItIsBackAtOnce) {
  play_sound();
  begin(one_trial(with_noise(small_protocol())));
  bool lost = false;
  bool paused = false;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    sound_.is_running = lost || now.phase != SessionPhase::contact;
    lost = lost || !sound_.is_running;
    if (now.phase == SessionPhase::paused) {
      paused = true;
      requests_.resume();
    }
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_TRUE(paused);
  EXPECT_EQ(events_of("masking_noise_lost").size(), 1U);
}

TEST_F(WatchedSession, EndsWhenTheNoiseStopsAndNobodyIsThere) {
  play_sound();
  links_.experimenter_is_there = false;
  begin(one_trial(with_noise(small_protocol())));
  once_in(SessionPhase::contact, [&] { sound_.is_running = false; });
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "the masking noise stopped");
}

}  // namespace
}  // namespace asperity
