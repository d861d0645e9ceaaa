// Faults of a session: what is stored and shown, and how it continues or ends.

#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/study_overview.h"
#include "app/tasks/unfinished_session.h"
#include "tests/app/watched_session.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

TEST_F(WatchedSession, WaitsInAFaultUntilItIsClearedAndAsksTheTrialAgain) {
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  once_in(SessionPhase::fault, [&] {
    const SessionSnapshot now = monitor_.snapshot();
    ASSERT_TRUE(now.trouble);
    EXPECT_EQ(now.trouble->remedy, SessionTrouble::Remedy::clear_fault);
    EXPECT_TRUE(now.trouble->what.can_be_translated());
    EXPECT_EQ(now.trouble->what.english(),
              "The emergency stop was pressed in trial 1. The force is zero until the stop is "
              "cleared.");
    EXPECT_EQ(now.fault, Fault::emergency_stop);
    EXPECT_EQ(now.scene->kind, ParticipantScene::Kind::paused);
    ASSERT_EQ(attempts().size(), 1U);  // stored before anybody is told
    requests_.clear_fault();
  });
  EXPECT_EQ(run().state, SessionState::completed);
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::emergency_stop);
  EXPECT_EQ(rows[0].servo->fault, "emergency_stop");
  EXPECT_EQ(rows[1].trial, 1);
  EXPECT_TRUE(rows[1].valid);
  EXPECT_FALSE(monitor_.snapshot().trouble);
  EXPECT_THAT(phases(), ElementsAre("ready", "iti", "fore", "contact", "fore", "contact",
                                    "response", "fore", "fault", "iti", "fore", "contact", "fore",
                                    "contact", "response", "questions", "ready", "ended"));
  ASSERT_EQ(events_of("fault").size(), 1U);
  EXPECT_EQ(events_of("fault").front().data_json, "null");
  EXPECT_EQ(events_of("fault_cleared").size(), 1U);
}

/// Fails in its first contact, as a plug-in does.
class FailingRenderer final : public ForceRenderer {
 public:
  explicit FailingRenderer(std::unique_ptr<ForceRenderer> sound) : sound_(std::move(sound)) {}
  void reset(const ProbeState& first) noexcept override { sound_->reset(first); }
  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    RenderedTick result = sound_->tick(probe, dt_s);
    has_failed_ = has_failed_ || result.penetration_m > 0.0;
    if (has_failed_) result.wrench.force_N.z = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  std::string_view error() const noexcept override {
    return has_failed_ ? "the ridge is too steep" : "";
  }

 private:
  std::unique_ptr<ForceRenderer> sound_{};
  bool has_failed_ = false;
};

TEST_F(WatchedSession, StoresTheMessageOfAPluginWithItsFault) {
  ModelRegistry models{};
  for (ForceModel model : models_.models()) {
    if (model.declaration.id == "height_map") {
      model.make = [sound = model.make, has_failed = std::make_shared<bool>(false)](
                       const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
        if (std::exchange(*has_failed, true)) return sound(inputs);
        return std::make_unique<FailingRenderer>(sound(inputs));
      };
    }
    models.add(std::move(model));
  }
  models_ = std::move(models);
  begin(one_trial());
  once_in(SessionPhase::fault, [&] { requests_.clear_fault(); });
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<EventRow> faults = events_of("fault");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults.front().text, "not_finite");
  EXPECT_EQ(faults.front().data_json,
            R"({"reason":"the plug-in of the force model height_map failed: the ridge is too )"
            R"(steep"})");
}

TEST_F(WatchedSession, ContinuesAfterAFaultWhenWhoeverAnswersSaysThatItIsMended) {
  begin(one_trial());
  links_.monitor = nullptr;  // as on a terminal
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  int asked = 0;
  person_.at_fault = [&] {
    return ++asked < 20 ? Respondent::AfterFault::nothing : Respondent::AfterFault::go_on;
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(asked, 20);
  EXPECT_THAT(person_.faults_heard,
              ElementsAre("The emergency stop was pressed in trial 1. The force is zero until the "
                          "stop is cleared."));
  const auto rows = attempts();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].outcome, AttemptOutcome::emergency_stop);
  EXPECT_TRUE(rows[1].valid);
  EXPECT_EQ(events_of("fault_cleared").size(), 1U);
}

TEST_F(WatchedSession, EndsAfterAFaultWhenWhoeverAnswersWantsThat) {
  begin(one_trial(), {{.kind = ScriptedFault::Kind::lost, .at_s = 1.0}});
  person_.at_fault = [] { return Respondent::AfterFault::end; };
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(), HasSubstr("the device does not respond"));
  EXPECT_EQ(attempts().size(), 1U);
}

TEST_F(WatchedSession, TellsWhatTheDeviceComplainsOfUntilItIsWell) {
  begin(small_protocol());
  std::vector<std::string> lines{};
  links_.tell = [&lines](const std::string& line) { lines.push_back(line); };
  std::vector<std::string> shown{};
  int slices = 0;
  rig_->at_pass = [&] {
    ++slices;
    if (slices == 20) rig_->complains = "Its motors gave less than was asked for 1 times.";
    // Its words change in every slice: shown as they are, and told and stored now and then.
    if (slices > 20 && slices < 120) {
      rig_->complains =
          "Its motors gave less than was asked for " + std::to_string(slices) + " times.";
    }
    if (slices == 120) rig_->complains.clear();
    const SessionSnapshot now = monitor_.snapshot();
    if (shown.empty() || shown.back() != now.device_complaint)
      shown.push_back(now.device_complaint);
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_GT(slices, 140);
  EXPECT_GT(shown.size(), 6U);
  EXPECT_EQ(shown.back(), "");
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_THAT(lines[0], HasSubstr("Its motors gave less"));
  EXPECT_EQ(lines[1], "The device no longer reports a problem.");
  std::vector<std::string> kinds{};
  std::vector<EventRow> events = study_->events(session_.row.id);
  for (const AttemptRow& attempt : attempts()) {
    events.insert(events.end(), attempt.events.begin(), attempt.events.end());
  }
  for (const EventRow& event : events) {
    if (event.kind.rfind("device_", 0) == 0) kinds.push_back(event.kind);
  }
  EXPECT_THAT(kinds, testing::UnorderedElementsAre("device_trouble", "device_well"));
}

TEST_F(WatchedSession, AnEmergencyStopIsNotLiftedByWhatWasAskedForBeforeIt) {
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  int slices = 0;
  once_in(SessionPhase::fault, [&] {
    requests_.clear_fault();
    requests_.emergency_stop();  // in the same hundredths of a second
    rig_->at_pass = [&] {
      if (monitor_.snapshot().phase == SessionPhase::fault) ++slices;
      if (slices == 50) requests_.abort("stopped twice");
    };
  });
  EXPECT_EQ(run().reason, "stopped twice");
  EXPECT_EQ(slices, 50);
  EXPECT_EQ(attempts().size(), 1U);
  EXPECT_TRUE(events_of("fault_cleared").empty());
}

TEST_F(WatchedSession, ShowsThePauseAgainAfterAFaultInIt) {
  begin(small_protocol());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.pause();
    return chooses(0);
  };
  enum class Step { pause, fault, pause_again } step = Step::pause;
  std::vector<ParticipantScene::Kind> kinds{};
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (step == Step::pause && now.phase == SessionPhase::paused) {
      requests_.emergency_stop();
      step = Step::fault;
    } else if (step == Step::fault && now.phase == SessionPhase::fault) {
      requests_.clear_fault();
      step = Step::pause_again;
    } else if (step == Step::pause_again && now.phase == SessionPhase::paused) {
      kinds.push_back(now.scene->kind);
      requests_.resume();
    }
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_FALSE(kinds.empty());
  EXPECT_EQ(kinds.front(), ParticipantScene::Kind::paused);
}

// Nobody who wears an eye mask sees the screen.
TEST_F(WatchedSession, IsHeardToPauseInAFault) {
  play_sound();
  begin(one_trial());
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question > 1) return chooses(0);
    requests_.emergency_stop();
    return feels_again(1);
  };
  once_in(SessionPhase::fault, [&] { requests_.clear_fault(); });
  run();
  EXPECT_THAT(sound_.cues(), Contains("paused"));
}

TEST_F(WatchedSession, KeepsNotesOfASessionThatFails) {
  begin(small_protocol());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.note("it smells of smoke");
    throw std::runtime_error("the recording cannot be written");
  };
  EXPECT_THROW(run(), std::runtime_error);
  ASSERT_EQ(events_of("note").size(), 1U);
  EXPECT_EQ(events_of("session_failed").size(), 1U);
}

TEST_F(WatchedSession, SaysFeedbackInWordsThatCanBeTranslated) {
  begin(practised_protocol("continue_flagged"));
  std::vector<ParticipantMessage::What> said{};
  person_.at_tell = [&] { said.push_back(monitor_.snapshot().scene->text_message.what); };
  person_.at_question = [](int question, const Trial& trial) {
    return question == 1 ? incorrect_reply(trial) : correct_reply(trial);
  };
  run();
  EXPECT_THAT(
      said, ElementsAre(ParticipantMessage::What::was_wrong, ParticipantMessage::What::was_right,
                        ParticipantMessage::What::was_right, ParticipantMessage::What::was_right));
}

TEST_F(WatchedSession, StaysInTheFaultWhileTheDeviceIsNotFit) {
  begin(one_trial(), {{.kind = ScriptedFault::Kind::lost, .at_s = 1.0}});
  bool told = false;
  bool cleared = false;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase != SessionPhase::fault || !now.trouble) return;
    if (!cleared) {
      cleared = true;
      requests_.clear_fault();
    } else if (!told && now.trouble->what.english().find("not ready") != std::string::npos) {
      told = true;
      requests_.abort("it is broken");
    }
  };
  const SessionEnd end = run();
  EXPECT_TRUE(told);
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "it is broken");
  EXPECT_EQ(attempts().size(), 1U);
}

TEST_F(WatchedSession, SaysThatTheEmergencyStopWasPressedWhileTheDeviceWasChecked) {
  begin(one_trial());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.emergency_stop();
    return feels_again(1);
  };
  enum class Step { stopped, checked, told } step = Step::stopped;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.phase != SessionPhase::fault || !now.trouble) return;
    if (step == Step::stopped) {
      requests_.clear_fault();
      step = Step::checked;
    } else if (step == Step::checked && now.fault == Fault::none) {
      requests_.emergency_stop();
      step = Step::told;
    } else if (now.trouble->what.english().ends_with(
                   " The emergency stop was pressed in the meantime.")) {
      requests_.abort("enough");
    }
  };
  EXPECT_EQ(run().reason, "enough");
}

TEST_F(WatchedSession, EndsFromAFaultWhenAskedToStop) {
  begin(one_trial());
  person_.at_question = [&](int, const Trial&) -> Reply {
    requests_.emergency_stop();
    return feels_again(1);
  };
  once_in(SessionPhase::fault, [&] { requests_.stop_after(StopAfter::block); });
  const SessionEnd end = run();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_EQ(end.reason, "the emergency stop was pressed in trial 1");
}

TEST_F(WatchedSession, BeginsAScreenAgainThatAFaultInterrupted) {
  begin(one_trial());
  bool stopped = false;
  rig_->at_pass = [&] {
    const SessionPhase phase = monitor_.snapshot().phase;
    if (phase == SessionPhase::ready && !stopped) {
      stopped = true;
      requests_.emergency_stop();
    }
    if (phase == SessionPhase::fault) requests_.clear_fault();
  };
  EXPECT_EQ(run().state, SessionState::completed);
  ASSERT_GE(person_.texts.size(), 2U);
  EXPECT_EQ(person_.texts[0], "Welcome.");
  EXPECT_EQ(person_.texts[1], "Welcome.");
}

TEST_F(WatchedSession, AnEmergencyStopFromAPauseIsAFaultAtOnce) {
  begin(small_protocol());
  bool stopped = false;
  person_.at_question = [&](int question, const Trial&) -> Reply {
    if (question == 1) requests_.pause();
    return chooses(0);
  };
  rig_->at_pass = [&] {
    const SessionPhase phase = monitor_.snapshot().phase;
    if (phase == SessionPhase::paused && !stopped) {
      stopped = true;
      requests_.emergency_stop();
    } else if (phase == SessionPhase::paused) {
      requests_.resume();
    }
    if (phase == SessionPhase::fault) requests_.clear_fault();
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(attempts().size(), 3U);  // none was lost to the stop
  EXPECT_THAT(phases(), Contains("fault"));
}

TEST_F(WatchedSession, IsNotGoneOnWithAfterItEndedAsTheProtocolSays) {
  begin(practised_protocol("end_session"));
  person_.at_question = [](int, const Trial& trial) { return incorrect_reply(trial); };
  EXPECT_TRUE(run().as_the_protocol_says);
  EXPECT_FALSE(monitor_.snapshot().trouble);
  EXPECT_TRUE(has_ended_by_rule(*study_, protocol_, study_->session(session_.row.id)));
  EXPECT_THROW(find_unfinished(*study_, protocol_, "p1", {}), std::runtime_error);
  const SessionOverview overview = session_overviews(*study_, {})[0];
  EXPECT_TRUE(overview.ended_by_rule);
  EXPECT_FALSE(overview.is_unfinished());
}

}  // namespace
}  // namespace asperity
