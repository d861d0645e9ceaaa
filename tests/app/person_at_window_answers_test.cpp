// The answers that a participant gives at a window: numbers, choices, assignments and forms.

#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/scripted_person.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

// --- a number ------------------------------------------------------------------------------------

class ANumber : public PersonAtWindowTest {
 protected:
  ANumber() {
    trial_.presentations.resize(1);
    trial_.questions = {{}};
    trial_.questions.front().form = NumberForm{.is_estimate = true};
    trial_.questions.front().prompt = "How rough did it feel?";
    trial_.arrangement.maximum_visits = 1;
  }
  Trial trial_ = one_surface();

 private:
  static Trial one_surface() {
    Trial trial{};
    trial.ordinal = 1;
    PlannedPresentation planned{};
    planned.position = 1;
    planned.code = "A";
    trial.presentations.push_back(planned);
    return trial;
  }
};

TEST_F(ANumber, IsTakenWithAPointAndWithAComma) {
  feel_all(trial_);
  type(0.5, "12,5");
  const Reply reply = ask(trial_);
  EXPECT_EQ(reply.number(), 12.5);
  EXPECT_TRUE(options_of(reply).empty());
  EXPECT_NE(reply.answer(), nullptr);
  EXPECT_EQ(reply.answered_ns, nanoseconds(kBegin_s + 1.5));
}

TEST_F(ANumber, IsRefusedInWordsUntilItIsAboveZero) {
  feel_all(trial_);
  type(0.5, "0");
  press(0.8, Kind::confirm);
  hold_button(1.0, 1, 0.2);  // nothing is typed by a button
  type(2.0, "3");
  EXPECT_EQ(ask(trial_).number(), 3.0);
  const std::vector<EventRow> refused = events("refused");
  ASSERT_EQ(refused.size(), 2U);
  for (const EventRow& event : refused) {
    EXPECT_EQ(event.text, "Please enter a number above 0, such as 7 or 0.5.");
  }
}

TEST_F(ANumber, AsksToFeelTheSurfaceAgainWhereThatIsAllowed) {
  trial_.arrangement.maximum_visits.reset();
  feel_all(trial_);
  press(1.0, Kind::next);
  EXPECT_EQ(felt_again(ask(trial_)), 1);
}

TEST_F(ANumber, IsLeftOutWhenTheTimeIsOver) {
  EXPECT_EQ(feel_all_and_ask(trial_, 2.0).answer(), nullptr);
}

// --- a choice ------------------------------------------------------------------------------------

class AChoice : public PersonAtWindowTest {};

TEST_F(AChoice, IsMadeByNumberAndAnsweredByAConfirmation) {
  feel_all(selection());
  press(1.0, Kind::option, 2);
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_FALSE(scene.choices.at(0).chosen);
    EXPECT_TRUE(scene.choices.at(1).chosen);
    EXPECT_TRUE(scene.can_confirm);
    EXPECT_EQ(scene.block, 3) << "the marks change nothing else";
  });
  press(2.0, Kind::confirm);
  const std::int64_t confirmed_ns = now_ns_ + nanoseconds(2.0);
  const Reply reply = ask(selection());
  EXPECT_EQ(options_of(reply), Options{1});
  EXPECT_EQ(reply.answered_ns, confirmed_ns);
  EXPECT_EQ(person_.source(), "keyboard");
}

TEST_F(AChoice, ChangesWithAnotherNumberUntilItIsConfirmed) {
  feel_all(selection());
  press(1.0, Kind::option, 2);
  press(1.1, Kind::option, 3);
  press(1.2, Kind::confirm);
  EXPECT_EQ(options_of(ask(selection())), Options{2});
}

TEST_F(AChoice, IsNotConfirmedBeforeItIsMade) {
  feel_all(selection());
  look(0.5, [](const ParticipantScene& scene) { EXPECT_FALSE(scene.can_confirm); });
  press(1.0, Kind::confirm);
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Please choose first.");
    EXPECT_EQ(scene.cue_message.what, ParticipantMessage::What::choose_first);
    EXPECT_EQ(scene.cue_number, 1U);
  });
  press(2.0, Kind::option, 1);
  look(2.5, [](const ParticipantScene& scene) { EXPECT_EQ(scene.cue, ""); });
  press(3.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(selection())), Options{0});
  EXPECT_EQ(sound_.count(Cue::refused), 1);
  ASSERT_EQ(events("refused").size(), 1U);
  EXPECT_EQ(events("refused").front().text, "Please choose first.");
}

TEST_F(AChoice, MayBeThatOneCannotTell) {
  feel_all(selection());
  press(1.0, Kind::option, 4);
  press(2.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(selection())), Options{3});
}

TEST_F(AChoice, HasNoUseForNumbersThatAreNoOption) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  press(1.1, Kind::option, 5);
  press(1.2, Kind::option, 0);
  press(1.3, Kind::option, -1);
  press(1.4, Kind::assign, 2, 1);
  type(1.5, "2");
  press(2.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(selection())), Options{0});
  EXPECT_TRUE(events("refused").empty());
}

TEST_F(AChoice, SaysWhereTheAnswerCameFrom) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  press(2.0, {.kind = Kind::confirm, .source = "experimenter"});
  ask(selection());
  EXPECT_EQ(person_.source(), "experimenter");
}

TEST_F(AChoice, IsLeftWithoutAnAnswerWhenTheTimeIsOver) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  const std::int64_t asked_ns = now_ns_;
  const Reply reply = ask(selection(), 4.0);
  EXPECT_TRUE(options_of(reply).empty());
  EXPECT_EQ(reply.feel_again(), nullptr);
  EXPECT_EQ(now_ns_, asked_ns + nanoseconds(4.05)) << "a window may hand on what came in time";
}

TEST_F(AChoice, CountsWhenItIsConfirmedJustInTime) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  press(3.995, Kind::confirm);
  EXPECT_EQ(options_of(ask(selection(), 4.0)), Options{0});
}

// On a real clock every wait takes a little longer than was asked for.
TEST_F(AChoice, IsOverAtTheDeadlineHoweverLongTheWaitsTake) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  press(4.05, Kind::confirm);
  const std::int64_t asked_ns = now_ns_;
  wait_ = [this](double duration_s) { pass(duration_s + 0.002); };
  EXPECT_TRUE(options_of(ask(selection(), 4.0)).empty());
  EXPECT_LT(now_ns_, asked_ns + nanoseconds(4.05 + 0.01));
}

// A window that draws hands on what was pressed when it has drawn.
TEST_F(AChoice, CountsWhenItWasConfirmedInTimeAndIsHeardALittleLater) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  const std::int64_t confirmed_ns = now_ns_ + nanoseconds(3.99);
  script_.emplace(now_ns_ + nanoseconds(4.045),
                  ParticipantInput{.kind = Kind::confirm, .time_ns = confirmed_ns});
  const Reply reply = ask(selection(), 4.0);
  EXPECT_EQ(options_of(reply), Options{0});
  EXPECT_EQ(reply.answered_ns, confirmed_ns);
}

TEST_F(AChoice, IsNotConfirmedAfterTheDeadlineBetweenTwoLooks) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  press(4.001, Kind::confirm);
  wait_ = [this](double duration_s) { pass(duration_s + 0.007); };
  EXPECT_TRUE(options_of(ask(selection(), 4.0)).empty());
  EXPECT_NE(events("input").back().data_json.find("after_the_deadline"), std::string::npos);
}

TEST_F(AChoice, IsNotMadeByWhatWasPressedBeforeTheQuestion) {
  feel_all(selection());
  // Pressed 0.2 s before the question, heard 0.5 s after it was shown.
  ParticipantInput late{.kind = Kind::option, .number = 1, .time_ns = now_ns_ - nanoseconds(0.2)};
  script_.emplace(now_ns_ + nanoseconds(0.5), late);
  press(1.0, Kind::confirm);
  EXPECT_TRUE(options_of(ask(selection(), 2.0)).empty());
  const auto inputs = events("input");
  ASSERT_EQ(inputs.size(), 2U);
  EXPECT_NE(inputs[0].data_json.find("meant_for_an_earlier_scene"), std::string::npos);
  EXPECT_EQ(inputs[1].data_json.find("meant_for_an_earlier_scene"), std::string::npos);
}

TEST_F(AChoice, GoesByTheTimeThatTheSceneSaysItWasShownAt) {
  feel_all(selection());
  const std::int64_t pressed_ns = now_ns_ - nanoseconds(0.2);
  person_.post({.kind = Kind::option, .number = 1, .time_ns = pressed_ns});
  const Trial trial = selection();
  ParticipantScene scene = scene_of_question(trial, trial.questions, {1, 2, 3});
  scene.shown_ns = pressed_ns - nanoseconds(PersonAtWindow::kTooSoon_s);
  monitor_.show(std::move(scene));
  press(1.0, Kind::confirm);
  EXPECT_EQ(options_of(person_.ask(trial, trial.questions, {}, 2.0, wait_)), Options{0});
}

// A pause or a fault is shown in the middle of a question.
TEST_F(AChoice, LeavesNoMarksOnAnotherScene) {
  feel_all(selection());
  look(0.5, [this](const ParticipantScene& scene) {
    ParticipantScene paused = scene;
    paused.kind = ParticipantScene::Kind::paused;
    monitor_.show(std::move(paused));
  });
  press(1.0, Kind::confirm);
  press(1.5, Kind::option, 2);
  EXPECT_TRUE(options_of(ask(selection(), 2.0)).empty());
  EXPECT_EQ(scene()->cue, "");
  EXPECT_FALSE(scene()->choices.at(1).chosen);
}

TEST_F(AChoice, TakesOneAnswerPerKey) {
  feel_all(selection());
  press(1.0, Kind::option, 1);
  press(2.0, Kind::confirm);
  press(2.001, Kind::confirm);  // bounces: heard together with the first
  press(2.002, Kind::option, 3);
  EXPECT_EQ(options_of(ask(selection())), Options{0});
  feel_all(selection());
  EXPECT_TRUE(options_of(ask(selection(), 3.0)).empty());
  EXPECT_TRUE(events("refused").empty());
}

// --- an assignment -------------------------------------------------------------------------------

class AnAssignment : public PersonAtWindowTest {};

TEST_F(AnAssignment, GivesPicturesToOneSurfaceAfterTheOther) {
  feel_all(matching());
  look(0.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.assigning, std::optional<std::size_t>(0));
  });
  press(1.0, Kind::option, 3);
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.choices.at(2).assigned_to, "A");
    EXPECT_EQ(scene.assigning, std::optional<std::size_t>(1));
    EXPECT_FALSE(scene.can_confirm);
  });
  press(2.0, Kind::option, 1);
  press(3.0, Kind::option, 2);
  look(3.5, [](const ParticipantScene& scene) { EXPECT_TRUE(scene.can_confirm); });
  press(4.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(matching())), (Options{2, 0, 1}));
}

TEST_F(AnAssignment, GivesEachPictureOnce) {
  feel_all(matching());
  press(1.0, Kind::option, 1);
  press(2.0, Kind::option, 1);  // moves from A to B, and A is without one
  look(2.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.choices.at(0).assigned_to, "B");
    EXPECT_EQ(scene.assigning, std::optional<std::size_t>(2));
  });
  press(3.0, Kind::option, 2);  // to C
  look(3.5, [](const ParticipantScene& scene) {
    EXPECT_FALSE(scene.can_confirm);
    EXPECT_EQ(scene.assigning, std::optional<std::size_t>(0));
  });
  press(4.0, Kind::option, 3);  // to A
  press(5.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(matching())), (Options{2, 0, 1}));
}

TEST_F(AnAssignment, IsNotConfirmedBeforeEverySurfaceHasAPicture) {
  feel_all(matching());
  press(1.0, Kind::option, 1);
  press(2.0, Kind::option, 2);
  press(3.0, Kind::confirm);
  look(3.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Please assign a picture to surface C first.");
    EXPECT_EQ(scene.cue_message.code, "C");
  });
  press(4.0, Kind::option, 3);
  press(5.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(matching())), (Options{0, 1, 2}));
}

TEST_F(AnAssignment, ChangesUntilItIsConfirmed) {
  feel_all(matching());
  press(1.0, Kind::option, 1);
  press(1.1, Kind::option, 2);
  press(1.2, Kind::option, 3);
  press(2.0, Kind::option, 2);  // A's turn again; B is without one
  look(2.5, [](const ParticipantScene& scene) {
    EXPECT_FALSE(scene.can_confirm);
    EXPECT_EQ(scene.assigning, std::optional<std::size_t>(1));
  });
  press(3.0, Kind::option, 1);
  press(4.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(matching())), (Options{1, 0, 2}));
}

TEST_F(AnAssignment, IsMadeByDraggingInAnyOrder) {
  feel_all(matching());
  press(1.0, Kind::assign, 1, 3);
  press(1.1, Kind::assign, 2, 1);
  press(1.2, Kind::assign, 3, 3);  // C changes its mind
  press(1.3, Kind::assign, 2, 0);  // dragged away from A
  press(1.4, Kind::assign, 9, 1);
  press(1.5, Kind::assign, 1, 4);
  look(1.8, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.choices.at(0).assigned_to, "");
    EXPECT_EQ(scene.choices.at(1).assigned_to, "");
    EXPECT_EQ(scene.choices.at(2).assigned_to, "C");
  });
  press(2.0, Kind::assign, 1, 2);
  press(2.1, Kind::assign, 2, 1);
  press(3.0, {.kind = Kind::confirm, .source = "mouse"});
  EXPECT_EQ(options_of(ask(matching())), (Options{1, 0, 2}));
  EXPECT_EQ(person_.source(), "mouse");
}

TEST_F(AnAssignment, LetsAnotherSurfaceHaveItsTurn) {
  feel_all(matching());
  press(1.0, Kind::surface, 3);
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.assigning, std::optional<std::size_t>(2));
  });
  press(2.0, Kind::option, 1);
  press(3.0, Kind::option, 2);
  press(4.0, Kind::option, 3);
  press(5.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(matching())), (Options{1, 2, 0}));
}

// --- forms ---------------------------------------------------------------------------------------

class AForm : public PersonAtWindowTest {
 protected:
  static Question number(double minimum, double maximum) {
    Question question{};
    question.prompt = "How old are you?";
    question.form = NumberForm{.minimum = minimum, .maximum = maximum};
    return question;
  }
  static Question choice() {
    Question question{};
    question.form = ChoiceForm{};
    question.options = in_words({"good", "tired", "5"});
    return question;
  }
};

TEST_F(AForm, TakesANumberWithinItsLimits) {
  type(1.0, "old");
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.kind, ParticipantScene::Kind::form);
    EXPECT_EQ(scene.cue, "Please enter a number from 18 to 120.");
    EXPECT_EQ(scene.cue_message.minimum, 18.0);
  });
  type(2.0, "17");
  type(2.1, "121");
  type(2.2, "");
  look(2.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Please answer this question.");
    EXPECT_EQ(scene.cue_number, 4U);
  });
  type(3.0, " 42 ");
  EXPECT_EQ(stored(number(18, 120), person_.answer(number(18, 120), wait_)), FormAnswer{"42"});
  EXPECT_EQ(sound_.count(Cue::refused), 4);
}

TEST_F(AForm, TakesTheOptionThatWasChosenLast) {
  press(1.0, Kind::confirm);
  press(2.0, Kind::option, 9);
  press(3.0, Kind::option, 1);
  press(4.0, Kind::option, 2);
  look(4.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.choices.at(1).text, "tired");
    EXPECT_TRUE(scene.choices.at(1).chosen);
    EXPECT_TRUE(scene.can_confirm);
  });
  press(5.0, Kind::confirm);
  EXPECT_EQ(stored(choice(), person_.answer(choice(), wait_)), FormAnswer{"tired"});
  EXPECT_EQ(events("refused").size(), 1U);
}

TEST_F(AForm, LeavesAnOptionalChoiceEmptyWhenItsOptionIsWithdrawn) {
  Question question = choice();
  question.optional = true;
  press(1.0, Kind::option, 1);
  press(2.0, Kind::option, 1);
  press(3.0, Kind::confirm);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{});
}

TEST_F(AForm, HasNoSurfaceToFeelAgain) {
  press(1.0, Kind::next);
  press(1.5, Kind::surface, 1);
  press(2.0, Kind::option, 3);
  press(3.0, Kind::confirm);
  EXPECT_EQ(stored(choice(), person_.answer(choice(), wait_)), FormAnswer{"5"});
  EXPECT_EQ(events("refused").size(), 0U);
}

TEST_F(AForm, TakesSeveralOptionsInTheirOrder) {
  Question question = choice();
  question.form = MultipleChoiceForm{};
  press(1.0, Kind::option, 3);
  press(1.5, Kind::option, 2);
  press(2.0, Kind::option, 1);
  press(2.5, Kind::option, 2);  // no longer
  look(2.8, [](const ParticipantScene& scene) {
    EXPECT_TRUE(scene.choices.at(0).chosen);
    EXPECT_FALSE(scene.choices.at(1).chosen);
    EXPECT_TRUE(scene.can_confirm);
  });
  press(3.0, Kind::confirm);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), (FormAnswer{"good", "5"}));
  press(1.0, Kind::confirm);
  press(2.0, Kind::option, 4);
  press(3.0, Kind::option, 1);
  press(4.0, Kind::confirm);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{"good"});
  EXPECT_EQ(events("refused").size(), 1U);
}

TEST_F(AForm, TakesSeveralOptionsByOneButton) {
  Question question = choice();
  question.form = MultipleChoiceForm{};
  hold_button(1.0, 1, 0.1);  // good
  look(1.5, [](const ParticipantScene& scene) { EXPECT_TRUE(scene.choices.at(0).pointed_at); });
  hold_button(2.0, 1, 1.0);  // chooses it
  hold_button(4.0, 1, 0.1);  // tired
  hold_button(5.0, 1, 0.1);  // 5
  hold_button(6.0, 1, 1.0);
  hold_button(8.0, 1, 1.0);  // confirms both
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), (FormAnswer{"good", "5"}));
}

TEST_F(AForm, RefusesAButtonForWhatIsTyped) {
  Question question{};
  question.form = TextForm{};
  question.optional = true;
  hold_button(1.0, 1, 0.1);
  hold_button(2.0, 2, 0.1);
  look(3.0, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Please confirm with the keyboard or on the screen.");
  });
  type(4.0, "half a page");
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{"half a page"});
  EXPECT_EQ(events("refused").size(), 1U);
}

TEST_F(AForm, TakesTheMarkOfAScaleAndNoneWhereItIsOptional) {
  Question question{};
  question.form = ScaleForm{.minimum = 1.0, .maximum = 7.0, .points = 7};
  press(0.5, Kind::step, 1);  // shows the mark in the middle, which is not an answer yet
  press(1.0, Kind::confirm);
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Please mark a point on the scale first.");
  });
  press(2.0, Kind::step, 1);
  press(3.0, Kind::confirm);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{"5"});
  EXPECT_EQ(events("refused").size(), 1U);
  question.optional = true;
  press(1.0, Kind::confirm);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{});
}

TEST_F(AForm, TakesTheLengthOfALine) {
  Question question{};
  question.form = LineForm{.longest = 0.5};
  press(1.0, Kind::confirm);
  press(2.0, {.kind = Kind::mark, .number = 1, .position = 0.4, .source = "mouse"});
  press(3.0, Kind::confirm);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{"0.2"});
  EXPECT_EQ(events("refused").size(), 1U);
}

TEST_F(AForm, MayBeLeftEmptyWhereItIsOptional) {
  Question question{};
  question.form = TextForm{};
  question.optional = true;
  press(1.0, Kind::confirm);
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{});
  question.optional = false;
  press(1.0, Kind::confirm);
  type(2.0, "yes");
  EXPECT_EQ(stored(question, person_.answer(question, wait_)), FormAnswer{"yes"});
  EXPECT_EQ(events("refused").size(), 1U);
}

TEST_F(AForm, IsAnsweredAtTheStampOfTheKeyNotWhenItIsHeard) {
  EXPECT_FALSE(person_.answered_ns());
  const std::int64_t pressed_ns = now_ns_ + nanoseconds(1.0);
  press(0.5, Kind::option, 2);
  script_.emplace(now_ns_ + nanoseconds(1.4),
                  ParticipantInput{.kind = Kind::confirm, .time_ns = pressed_ns});
  person_.answer(choice(), wait_);
  EXPECT_EQ(now_ns_, pressed_ns + nanoseconds(0.4));
  EXPECT_EQ(person_.answered_ns(), pressed_ns);
}

TEST_F(AForm, KeepsWhatWasChosenOutOfTheEvents) {
  press(1.0, Kind::option, 2);
  press(2.0, Kind::confirm);
  person_.answer(choice(), wait_);
  for (const EventRow& event : events("input")) EXPECT_EQ(event.text, "answer");
  EXPECT_EQ(events("input").size(), 2U);
}

TEST_F(AForm, KeepsWhatWasTypedOutOfTheEvents) {
  Question question{};
  question.form = TextForm{};
  type(1.0, "numbness in the left hand");
  EXPECT_EQ(stored(question, person_.answer(question, wait_)),
            FormAnswer{"numbness in the left hand"});
  for (const EventRow& event : events("input")) {
    EXPECT_EQ((event.text + event.data_json).find("numbness"), std::string::npos);
  }
}

}  // namespace
}  // namespace asperity
