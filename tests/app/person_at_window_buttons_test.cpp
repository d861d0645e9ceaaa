// The buttons of the device as answers, and the events that are stored of a participant at a window.

#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scripted_person.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

// --- device buttons ------------------------------------------------------------------------------

class DeviceButtons : public PersonAtWindowTest {};

TEST_F(DeviceButtons, StepThroughTheOptionsByToneAndConfirmWithTheSecond) {
  feel_all(selection());
  hold_button(1.0, 1, 0.1);
  hold_button(2.0, 1, 0.1);
  hold_button(3.0, 2, 0.1);
  const std::int64_t confirmed_ns = now_ns_ + nanoseconds(3.0);
  const Reply reply = ask(selection());
  EXPECT_EQ(options_of(reply), Options{1});
  EXPECT_EQ(reply.answered_ns, confirmed_ns);
  EXPECT_EQ(person_.source(), "device_button");
  EXPECT_THAT(sound_.cues(), testing::ElementsAre("option 1", "option 2"));
}

TEST_F(DeviceButtons, ConfirmWithTheFirstWhenItIsHeld) {
  feel_all(selection());
  hold_button(1.0, 1, 0.79);
  hold_button(3.0, 1, 0.8);
  EXPECT_EQ(options_of(ask(selection())), Options{0});
}

TEST_F(DeviceButtons, BeginAnewAfterTheLastOption) {
  Trial trial = selection();
  trial.arrangement.maximum_visits = 1;
  feel_all(trial);
  for (int step = 0; step < 5; ++step) hold_button(1.0 + step, 1, 0.1);
  hold_button(7.0, 2, 0.1);
  EXPECT_EQ(options_of(ask(trial)), Options{0});
}

TEST_F(DeviceButtons, AskForASurfaceAgainBehindTheLastOption) {
  const Trial trial = selection();
  feel_all(trial);
  for (int step = 0; step < 5; ++step) hold_button(1.0 + step, 1, 0.1);
  look(5.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Confirm to feel surface A again.");
    EXPECT_TRUE(scene.can_confirm);
    for (const auto& choice : scene.choices) EXPECT_FALSE(choice.chosen);
  });
  hold_button(7.0, 1, 0.9);
  const std::int64_t wished_ns = now_ns_ + nanoseconds(7.0);
  Reply reply = ask(trial);
  EXPECT_TRUE(options_of(reply).empty());
  EXPECT_EQ(felt_again(reply), 1);
  EXPECT_EQ(reply.answered_ns, wished_ns);
  EXPECT_THAT(sound_.cues(),
              testing::ElementsAre("option 1", "option 2", "option 3", "option 4", "surface 1"));
  EXPECT_TRUE(events("refused").empty());
  feel(trial, 1);
  hold_button(1.0, 2, 0.1);  // the wish is fulfilled, and nothing is chosen
  for (int step = 0; step < 5; ++step) hold_button(2.0 + step, 1, 0.1);
  hold_button(8.0, 2, 0.1);
  reply = ask(trial);
  EXPECT_EQ(felt_again(reply), 2) << "the surfaces follow each other in a circle";
  EXPECT_EQ(events("refused").size(), 1U);
  feel(trial, 2);
  for (int step = 0; step < 6; ++step) hold_button(1.0 + step, 1, 0.1);
  hold_button(8.0, 2, 0.1);
  EXPECT_EQ(options_of(ask(trial)), Options{0}) << "one step further is the first option";
}

TEST_F(DeviceButtons, AskForASurfaceAgainAmongPicturesToo) {
  Trial trial = matching();
  trial.arrangement.maximum_visits.reset();
  feel_all(trial);
  hold_button(1.0, 1, 0.1);
  hold_button(2.0, 2, 0.1);  // A gets 1
  for (int step = 0; step < 4; ++step) hold_button(3.0 + step, 1, 0.1);
  hold_button(8.0, 2, 0.1);
  EXPECT_EQ(felt_again(ask(trial)), 1);
  feel(trial, 1);
  look(0.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.choices.at(0).assigned_to, "A") << "what is given stays";
  });
  EXPECT_TRUE(options_of(ask(trial, 1.0)).empty());
}

TEST_F(DeviceButtons, AskForNoSurfaceOnceAPictureIsTakenBack) {
  Trial trial = matching();
  trial.arrangement.maximum_visits.reset();
  feel_all(trial);
  press(1.0, Kind::option, 1);  // A gets 1
  for (int step = 0; step < 4; ++step) hold_button(2.0 + step, 1, 0.1);
  look(5.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue_message.what, ParticipantMessage::What::feel_again);
    EXPECT_TRUE(scene.can_confirm);
  });
  press(6.0, Kind::assign, 1, 0);
  look(6.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "") << "the wish is said no more";
    EXPECT_FALSE(scene.can_confirm);
  });
  press(7.0, Kind::confirm);
  const Reply reply = ask(trial, 8.0);
  EXPECT_EQ(reply.feel_again(), nullptr);
  ASSERT_EQ(events("refused").size(), 1U);
}

TEST_F(DeviceButtons, GivePicturesToOneSurfaceAfterTheOther) {
  feel_all(matching());
  double at_s = 0.0;
  const auto step = [&](int times) {
    for (int i = 0; i < times; ++i) hold_button(at_s += 1.0, 1, 0.1);
  };
  const auto confirm = [&] { hold_button(at_s += 1.0, 2, 0.1); };
  step(2);
  look(at_s + 0.5, [](const ParticipantScene& scene) {
    EXPECT_TRUE(scene.choices.at(1).chosen);
    EXPECT_EQ(scene.choices.at(1).assigned_to, "") << "only pointed at";
  });
  confirm();  // A gets 2
  step(1);
  confirm();  // B gets 1
  step(3);
  confirm();  // C gets 3
  confirm();  // and that is the answer
  EXPECT_EQ(options_of(ask(matching())), (Options{1, 0, 2}));
  EXPECT_THAT(sound_.cues(),
              testing::ElementsAre("option 1", "option 2", "surface 2", "option 1", "surface 3",
                                   "option 1", "option 2", "option 3", "question"));
}

TEST_F(DeviceButtons, AnswerTheChoicesOfAForm) {
  Question question{};
  question.form = ChoiceForm{};
  question.options = in_words({"good", "tired"});
  hold_button(1.0, 2, 0.1);
  hold_button(2.0, 1, 0.1);
  hold_button(3.0, 1, 0.1);
  hold_button(4.0, 2, 0.1);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{"tired"});
  EXPECT_EQ(events("refused").size(), 1U) << "nothing was chosen yet";
}

TEST_F(DeviceButtons, DoNothingWhenTheyWereDownBefore) {
  feel_all(selection());
  person_.button_changed({1, false, now_ns_ + nanoseconds(0.1)});
  hold_button(1.0, 2, 0.1);
  EXPECT_TRUE(options_of(ask(selection(), 2.0)).empty());
  EXPECT_EQ(events("refused").front().text, "Please choose first.");
}

// --- what is stored ------------------------------------------------------------------------------

class StoredEvents : public PersonAtWindowTest {};

TEST_F(StoredEvents, HaveTheTimesOfPressAndRelease) {
  feel_all(selection());
  const std::int64_t asked_ns = now_ns_;
  press(1.0, Kind::option, 2);
  script_.emplace(asked_ns + nanoseconds(1.2),
                  ParticipantInput{.kind = Kind::released,
                                   .text = "option 2",
                                   .time_ns = asked_ns + nanoseconds(1.0),
                                   .held_s = 0.15});
  hold_button(2.0, 2, 0.3);
  ask(selection());
  pass(1.0);
  person_.wants_next(false);  // hears what is left
  const auto inputs = events("input");
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_EQ(inputs[0].text, "option 2");
  EXPECT_EQ(inputs[0].time_ns, asked_ns + nanoseconds(1.0));
  EXPECT_NE(inputs[0].data_json.find("keyboard"), std::string::npos);
  EXPECT_EQ(inputs[1].text, "device button 2");
  const auto releases = events("input_released");
  ASSERT_EQ(releases.size(), 2U);
  EXPECT_EQ(releases[0].time_ns, asked_ns + nanoseconds(1.15));
  EXPECT_EQ(releases[1].time_ns, asked_ns + nanoseconds(2.3));
  EXPECT_EQ(releases[1].text, "device button 2");
}

TEST_F(StoredEvents, AreGivenOnce) {
  feel_all(selection());
  press(1.0, Kind::option, 2);
  ask(selection(), 2.0);
  EXPECT_EQ(person_.take_events().size(), 1U);
  EXPECT_TRUE(person_.take_events().empty());
}

TEST_F(StoredEvents, DoNotGrowWithoutEndWhenAKeyIsStuck) {
  for (int i = 0; i < 5000; ++i) person_.post({.kind = Kind::next, .time_ns = now_ns_});
  feel_all(selection());
  ask(selection(), 1.0);
  EXPECT_EQ(events("input").size(), 1000U);
}

class PersonAtWindowThreads : public PersonAtWindowTest {};

// A window posts from its own thread while the conductor listens.
TEST_F(PersonAtWindowThreads, HearWhatIsPostedFromAnother) {
  SessionMonitor monitor{};
  PersonAtWindow person(monitor, nullptr);
  Trial trial = selection();
  std::jthread window([&person] {
    for (int i = 0; i < 200; ++i) {
      person.post({.kind = Kind::option, .number = 1 + i % 4, .time_ns = nanoseconds(1.0)});
    }
    person.post({.kind = Kind::option, .number = 3, .time_ns = nanoseconds(2.0)});
    person.post({.kind = Kind::confirm, .time_ns = nanoseconds(3.0)});
  });
  const Reply reply =
      person.ask(trial, trial.questions, {}, {}, [](double) { std::this_thread::yield(); });
  EXPECT_EQ(options_of(reply), Options{2});
  EXPECT_EQ(reply.answered_ns, nanoseconds(3.0));
}

}  // namespace
}  // namespace asperity
