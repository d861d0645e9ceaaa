// What the participant of a session does: answers and when they count, buttons, the eye mask.

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/respondents/person_at_window.h"
#include "tests/app/watched_session.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;

/// The real rules of answering, in a session: the first answer comes while the hand lifts.
TEST_F(WatchedSession, RefusesAnAnswerBetweenTheLastSurfaceAndItsQuestion) {
  play_sound();
  begin(one_trial());
  PersonAtWindow person(monitor_, &loudspeakers_);
  const auto press = [&](ParticipantInput::Kind kind, int number = 0) {
    person.post({.kind = kind, .number = number, .time_ns = rig_->clock().now_ns()});
  };
  int lifts = 0;
  std::int64_t answered_scene_ns = -1;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    const int heard = sound_.count(Cue::next);
    if (now.scene->kind == ParticipantScene::Kind::feel && heard > lifts) {
      lifts = heard;
      press(ParticipantInput::Kind::option, 1);
    }
    const bool waits = now.scene->kind == ParticipantScene::Kind::text ||
                       now.scene->kind == ParticipantScene::Kind::question ||
                       now.scene->kind == ParticipantScene::Kind::form;
    if (!waits || now.scene->shown_ns == answered_scene_ns ||
        now.now_ns - now.scene->shown_ns < 300'000'000) {
      return;
    }
    answered_scene_ns = now.scene->shown_ns;
    if (now.scene->kind != ParticipantScene::Kind::text) press(ParticipantInput::Kind::option, 2);
    press(ParticipantInput::Kind::confirm);
  };
  Conductor conductor(*study_, protocol_, *builder_, *rig_, person, {.links = links_});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  EXPECT_EQ(lifts, 2);
  EXPECT_EQ(sound_.count(Cue::refused), 2);
  const AttemptRow row = attempts().front();
  std::vector<std::string> refusals{};
  for (const EventRow& event : row.events) {
    if (event.kind == "refused") refusals.push_back(event.text);
  }
  EXPECT_THAT(refusals,
              ElementsAre("Please feel surface B first.", "Please wait for the question."));
  EXPECT_EQ(row.responses.at(0).answer, row.presentations[1].item);
}

/// On the empty ground between two surfaces keys, clicks and buttons are refused alike.
TEST_F(WatchedSession, RefusesAnAnswerBetweenTwoSurfaces) {
  play_sound();
  begin(one_trial(small_protocol(R"(, "pause_between_surfaces_s": 0.5)")));
  PersonAtWindow person(monitor_, &loudspeakers_);
  const auto press = [&](ParticipantInput::Kind kind, int number = 0) {
    person.post({.kind = kind, .number = number, .time_ns = rig_->clock().now_ns()});
  };
  bool pressed = false;
  std::string cue{};
  std::int64_t answered_scene_ns = -1;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (now.scene->kind == ParticipantScene::Kind::blank && !now.scene->surfaces.empty()) {
      if (!pressed) {
        pressed = true;
        press(ParticipantInput::Kind::option, 1);
        press(ParticipantInput::Kind::click);
        press(ParticipantInput::Kind::next);  // they go on already
      }
      cue = now.scene->cue;
    }
    const bool waits = now.scene->kind == ParticipantScene::Kind::text ||
                       now.scene->kind == ParticipantScene::Kind::question ||
                       now.scene->kind == ParticipantScene::Kind::form;
    if (!waits || now.scene->shown_ns == answered_scene_ns ||
        now.now_ns - now.scene->shown_ns < 300'000'000) {
      return;
    }
    answered_scene_ns = now.scene->shown_ns;
    if (now.scene->kind != ParticipantScene::Kind::text) press(ParticipantInput::Kind::option, 2);
    press(ParticipantInput::Kind::confirm);
  };
  Conductor conductor(*study_, protocol_, *builder_, *rig_, person, {.links = links_});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  EXPECT_EQ(sound_.count(Cue::refused), 2);
  EXPECT_EQ(cue, "Please feel surface B first.");
}

/// A person with more to say: enough of a surface, when an answer was given, buttons, a mask.
class TalkativeSession : public WatchedSession {
 protected:
  TalkativeSession() {
    person_.is_at_window = true;
    person_.at_ask = [this](const Wait& wait) -> Reply {
      const std::int64_t cue_ns = rig_->clock().now_ns();
      wait(0.5);
      person_.events.push_back({cue_ns + 150'000'000, "input", "option 1", "null"});
      return {only_answer(ChosenOption{0}), cue_ns + 200'000'000};
    };
    person_.at_form = [this](const Question& question, const Wait& wait) {
      person_.form_answered_ns = rig_->clock().now_ns() + 300'000'000;
      wait(0.5);
      return question.options.empty() ? FormAnswer{} : FormAnswer{question.options.front().value};
    };
  }
};

TEST_F(TalkativeSession, LetsGoOfASurfaceOnceItWasFeltLongEnoughAndThePersonWantsSo) {
  begin(one_trial());
  person_.has_had_enough = true;
  run();
  const AttemptRow row = attempts().front();
  for (const PresentationRow& surface : row.presentations) {
    EXPECT_GE(surface.contact_s, 0.5);
    EXPECT_LT(surface.contact_s, 0.7);  // the hand needs 0.15 s to lift
  }
  EXPECT_FALSE(row.flagged);
}

TEST_F(TalkativeSession, TakesReactionTimesFromTheStampOfTheAnswer) {
  begin(one_trial());
  run();
  const AttemptRow row = attempts().front();
  const ResponseRow response = row.responses.at(0);
  EXPECT_NEAR(*response.from_cue_s, 0.2, 1e-9);  // `ask` itself took 0.5 s
  EXPECT_NEAR(static_cast<double>(row.offset_ns - response.time_ns) * 1e-9, 0.3, 1e-3);
  EXPECT_NEAR(*response.from_contact_s,
              static_cast<double>(response.time_ns - *row.presentations[0].contact_ns) * 1e-9,
              1e-9);
}

TEST_F(TalkativeSession, TakesTheTimeOfAQuestionnairesAnswerFromItsStamp) {
  begin(one_trial());
  run();
  const auto answers = study_->session_answers(session_.row.id);
  ASSERT_EQ(answers.size(), 2U);                   // the second one was left empty
  EXPECT_NEAR(*answers[0].from_cue_s, 0.3, 1e-9);  // it was heard after 0.5 s
}

TEST_F(TalkativeSession, StoresWhatThePersonDidWithTheAttempt) {
  begin(one_trial());
  person_.events.push_back({1, "input", "confirm", "null"});  // before the first attempt
  run();
  ASSERT_EQ(events_of("input").size(), 1U);
  EXPECT_EQ(events_of("input")[0].text, "confirm");
  std::vector<std::string> kinds{};
  const AttemptRow row = attempts().front();
  for (const EventRow& event : row.events) {
    kinds.push_back(event.kind == "phase" ? event.text : event.kind);
  }
  EXPECT_THAT(kinds, ElementsAre("fore", "contact", "fore", "contact", "response", "input"));
}

TEST_F(TalkativeSession, HandsOnTheButtonsOfTheDevice) {
  begin(one_trial());
  std::int64_t pressed_ns = 0;
  once_in(SessionPhase::response, [&] {
    pressed_ns = rig_->clock().now_ns();
    rig_->hand().press(2);
  });
  run();
  ASSERT_FALSE(person_.buttons.empty());
  EXPECT_EQ(person_.buttons[0].button, 2);
  EXPECT_TRUE(person_.buttons[0].down);
  EXPECT_EQ(person_.buttons[0].time_ns, pressed_ns + 1'000'000);  // the next tick
}

TEST_F(TalkativeSession, HasTheMaskOnWhileFeelingAndOffToLookAtPictures) {
  std::string text = with(practised_protocol("continue_flagged"), "\"textures\"",
                          R"("environment": {"vision": "blindfold"}, )");
  for (std::size_t at = text.find("\"pictures\""); at != std::string::npos;
       at = text.find("\"pictures\"", at + 80)) {
    text.insert(at, R"("pictures_after_feeling": true, "allow_revisit": false, )");
  }
  begin(with(text, R"({"run": "practice"})", R"({"screen": "Welcome."}, )"));
  run();
  ASSERT_GT(person_.calls.size(), 8U);
  person_.calls.resize(8);
  EXPECT_THAT(person_.calls, ElementsAre("read", "mask on", "surface 1", "mask off", "ask", "tell",
                                         "mask on", "surface 1"));
  std::vector<std::string> kinds{};
  const AttemptRow row = attempts().front();
  for (const EventRow& event : row.events) kinds.push_back(event.kind);
  EXPECT_THAT(kinds, testing::IsSupersetOf({"mask_on", "mask_off"}));
}

TEST_F(TalkativeSession, LeavesNobodyBehindTheMask) {
  std::string text =
      with(one_trial(), "\"textures\"", R"("environment": {"vision": "blindfold"}, )");
  text.replace(text.find("\"photograph\""), 12, "\"memory\"");
  const std::string ending = R"(, {"ask": ["comfort", "remarks"]}, {"screen": "Thank you."})";
  text.erase(text.find(ending), ending.size());  // nothing else takes it off
  begin(text);
  run();
  ASSERT_FALSE(person_.calls.empty());
  EXPECT_EQ(person_.calls.back(), "mask off");
}

TEST_F(TalkativeSession, HasTheExperimenterConfirmWhatOnlyTheyAreToDo) {
  begin(with(one_trial(), "\"name\": \"best\"",
             R"("experimenter_prompt": "Place sample {code}.", )"));
  std::string asked{};
  ParticipantScene seen{};
  int looks = 0;
  rig_->at_pass = [&] {
    const SessionSnapshot now = monitor_.snapshot();
    if (!now.trouble || now.trouble->remedy != SessionTrouble::Remedy::confirm) return;
    asked = now.trouble->what.english();
    seen = *now.scene;
    EXPECT_EQ(rig_->loop().status().presentation, 0U);  // nothing is rendered
    if (++looks == 10) requests_.confirm();
  };
  requests_.confirm();  // before anybody asked: means nothing
  run();
  EXPECT_GE(looks, 10);
  EXPECT_THAT(asked, testing::StartsWith("Place sample "));
  EXPECT_EQ(seen.kind, ParticipantScene::Kind::blank);
  EXPECT_EQ(seen.text, "");
  // The participant reads the two screens of the flow and nothing else.
  EXPECT_EQ(std::count(person_.calls.begin(), person_.calls.end(), "read"), 2);
  EXPECT_FALSE(monitor_.snapshot().trouble);
  std::vector<std::string> kinds{};
  const AttemptRow row = attempts().front();
  for (const EventRow& event : row.events) kinds.push_back(event.kind);
  EXPECT_THAT(kinds, Contains("experimenter_ready"));
}

TEST_F(TalkativeSession, AsksNobodyToPutOnAMaskWhereTheProtocolDoesNot) {
  begin(one_trial());
  run();
  EXPECT_THAT(person_.calls, testing::Not(Contains("mask on")));
}

}  // namespace
}  // namespace asperity
