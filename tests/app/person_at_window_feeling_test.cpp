// What a participant can do while a surface is felt, how one is felt again, and how texts are read.

#include <gtest/gtest.h>

#include "tests/app/scripted_person.h"

namespace asperity {
namespace {

// --- while a surface is felt ---------------------------------------------------------------------

class WhileFeeling : public PersonAtWindowTest {
 protected:
  void announce(const Trial& trial, int position) {
    monitor_.show(scene_of_surface(trial, {}, position));
    person_.announce(trial, trial.presentations.at(static_cast<std::size_t>(position - 1)));
    pass(PersonAtWindow::kTooSoon_s);  // it is perceived
  }
};

TEST_F(WhileFeeling, AnAnswerIsRefusedUntilAllWasFelt) {
  const Trial trial = selection();
  person_.begin_attempt(1, 1);
  announce(trial, 1);
  press(0.1, Kind::option, 1);
  pass(0.2);
  EXPECT_FALSE(person_.wants_next(true));
  EXPECT_EQ(scene()->cue, "Please feel surface B first.");
  announce(trial, 2);
  press(0.1, Kind::confirm);
  pass(0.2);
  EXPECT_FALSE(person_.wants_next(true));
  EXPECT_EQ(scene()->cue, "Please feel surface C first.");
  EXPECT_EQ(scene()->cue_number, 2U);
  announce(trial, 3);
  press(0.1, Kind::assign, 1, 1);
  pass(0.2);
  EXPECT_FALSE(person_.wants_next(true));
  EXPECT_EQ(scene()->cue, "Please feel surface C first.");
  EXPECT_EQ(sound_.count(Cue::refused), 3);
  // None of it is the answer.
  EXPECT_TRUE(options_of(ask(trial, 1.0)).empty());
}

TEST_F(WhileFeeling, NextContinuesOnceTheSurfaceWasFeltLongEnough) {
  person_.begin_attempt(1, 1);
  announce(selection(), 1);
  EXPECT_FALSE(person_.wants_next(true)) << "nothing was pressed";
  press(0.1, Kind::next);
  pass(0.2);
  EXPECT_FALSE(person_.wants_next(false));
  EXPECT_EQ(scene()->cue, "Please feel surface A a little longer.");
  pass(0.2);
  EXPECT_FALSE(person_.wants_next(true)) << "a refused wish is gone";
  press(0.1, Kind::next);
  pass(0.2);
  EXPECT_TRUE(person_.wants_next(true));
}

TEST_F(WhileFeeling, TheSurfaceThatComesNextMayBeNamed) {
  person_.begin_attempt(1, 1);
  announce(selection(), 1);
  press(0.1, Kind::surface, 3);
  press(0.2, Kind::surface, 1);  // the letter of an answer, too early
  pass(0.3);
  EXPECT_FALSE(person_.wants_next(true));
  EXPECT_EQ(scene()->cue, "Please feel surface B first.");
  EXPECT_EQ(sound_.count(Cue::refused), 2);
  press(0.1, Kind::surface, 2);
  pass(0.2);
  EXPECT_TRUE(person_.wants_next(true));
}

TEST_F(WhileFeeling, TheFirstDeviceButtonContinuesAndTheSecondIsAnAnswerTooEarly) {
  person_.begin_attempt(1, 1);
  announce(selection(), 1);
  hold_button(0.1, 2, 0.1);
  pass(0.3);
  EXPECT_FALSE(person_.wants_next(true));
  EXPECT_EQ(scene()->cue, "Please feel surface B first.");
  hold_button(0.1, 1, 0.1);
  pass(0.3);
  EXPECT_TRUE(person_.wants_next(true));
}

TEST_F(WhileFeeling, AnAnswerIsRefusedAlsoWhenASurfaceIsFeltAgain) {
  feel_all(selection());
  ask(selection(), 1.0);
  announce(selection(), 2);
  press(0.1, Kind::confirm);
  pass(0.2);
  EXPECT_FALSE(person_.wants_next(true));
  EXPECT_EQ(scene()->cue, "Please wait for the question.");
}

TEST_F(WhileFeeling, AnAnswerIsRefusedOnceWhileTheHandLifts) {
  const Trial trial = selection();
  person_.begin_attempt(1, 1);
  announce(trial, 1);
  press(0.1, Kind::next);
  pass(0.2);
  ASSERT_TRUE(person_.wants_next(true));
  press(0.1, Kind::next);  // twice does no harm
  press(0.1, Kind::surface, 2);
  hold_button(0.1, 1, 0.05);
  pass(0.2);
  person_.refuse_answers();
  EXPECT_EQ(sound_.count(Cue::refused), 0);
  press(0.1, Kind::option, 1);
  pass(0.2);
  person_.refuse_answers();
  person_.refuse_answers();
  EXPECT_EQ(sound_.count(Cue::refused), 1);
  EXPECT_EQ(scene()->cue, "Please feel surface B first.");
  monitor_.show({});  // nothing but a tone where the screen is empty
  hold_button(0.1, 2, 0.05);
  pass(0.2);
  person_.refuse_answers();
  EXPECT_EQ(sound_.count(Cue::refused), 2);
  EXPECT_EQ(scene()->cue, "");
  announce(trial, 2);
  announce(trial, 3);
  for (const Kind answer : {Kind::option, Kind::assign, Kind::surface, Kind::confirm}) {
    press(0.1, answer, 1, 1);
  }
  pass(0.2);
  person_.refuse_answers();
  EXPECT_EQ(sound_.count(Cue::refused), 6);
  EXPECT_EQ(scene()->cue, "Please wait for the question.");
  EXPECT_TRUE(options_of(ask(trial, 1.0)).empty()) << "none of it is the answer";
  EXPECT_EQ(events("refused").size(), 6U);
}

TEST_F(WhileFeeling, AWishFromBeforeTheSurfaceIsNone) {
  person_.begin_attempt(1, 1);
  press(0.1, Kind::next);
  pass(0.2);
  announce(selection(), 1);
  EXPECT_FALSE(person_.wants_next(true));
  EXPECT_EQ(scene()->cue, "");
}

// --- feeling again -------------------------------------------------------------------------------

class FeelingAgain : public PersonAtWindowTest {};

TEST_F(FeelingAgain, GoesRoundTheSurfaces) {
  const Trial trial = selection();
  feel_all(trial);
  for (const int expected : {1, 2, 3, 1}) {
    press(1.0, Kind::next);
    const Reply reply = ask(trial);
    EXPECT_TRUE(options_of(reply).empty());
    ASSERT_EQ(felt_again(reply), expected);
    feel(trial, felt_again(reply));
  }
}

TEST_F(FeelingAgain, ReportsAVisitWithoutContactAndDoesNotCountIt) {
  Trial trial = selection();
  trial.arrangement.maximum_visits = 2;
  feel_all(trial);
  press(1.0, Kind::surface, 2);
  ASSERT_EQ(felt_again(ask(trial)), 2);
  feel(trial, 2);
  person_.visit_was_without_contact(2);
  look(0.5,
       [](const ParticipantScene& scene) { EXPECT_EQ(scene.cue, "Surface B was not touched."); });
  press(1.0, Kind::surface, 2);
  EXPECT_EQ(felt_again(ask(trial)), 2) << "its second visit is still possible";
}

TEST_F(FeelingAgain, MayNameTheSurface) {
  feel_all(selection());
  press(0.5, Kind::surface, 7);
  press(1.0, Kind::surface, 2);
  const std::int64_t wished_ns = now_ns_ + nanoseconds(1.0);
  const Reply reply = ask(selection());
  EXPECT_EQ(felt_again(reply), 2);
  EXPECT_EQ(reply.answered_ns, wished_ns);
}

TEST_F(FeelingAgain, LeavesTheChoiceAsItWas) {
  const Trial trial = selection();
  feel_all(trial);
  press(1.0, Kind::option, 2);
  press(2.0, Kind::next);
  ASSERT_EQ(felt_again(ask(trial)), 1);
  feel(trial, 1);
  look(0.5, [](const ParticipantScene& scene) { EXPECT_TRUE(scene.choices.at(1).chosen); });
  press(1.0, Kind::confirm);
  EXPECT_EQ(options_of(ask(trial)), Options{1});
}

TEST_F(FeelingAgain, IsRefusedWhereTheProtocolDoesNotAllowIt) {
  Trial trial = selection();
  trial.arrangement.maximum_visits = 1;
  feel_all(trial);
  press(1.0, Kind::next);
  press(1.1, Kind::surface, 2);
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "The surfaces cannot be felt again. Please answer without feeling them.");
    EXPECT_EQ(scene.cue_number, 2U);
  });
  const Reply reply = ask(trial, 2.0);
  EXPECT_EQ(reply.feel_again(), nullptr);
  EXPECT_EQ(events("refused").size(), 2U);
}

TEST_F(FeelingAgain, StartsAnewWithEveryAttempt) {
  const Trial trial = selection();
  feel_all(trial);
  press(1.0, Kind::option, 2);
  EXPECT_TRUE(options_of(ask(trial, 2.0)).empty());
  feel_all(trial);
  press(1.0, Kind::confirm);
  EXPECT_TRUE(options_of(ask(trial, 2.0)).empty()) << "the choice is that of the attempt before";
}

// --- reading, masks, feedback --------------------------------------------------------------------

class Reading : public PersonAtWindowTest {};

TEST_F(Reading, ContinuesWithAConfirmation) {
  press(1.0, Kind::option, 1);
  press(1.1, Kind::next);
  press(2.0, Kind::confirm);
  const std::int64_t began_ns = now_ns_;
  look(0.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.kind, ParticipantScene::Kind::text);
    EXPECT_EQ(scene.text, "Welcome.");
    EXPECT_TRUE(scene.can_confirm);
  });
  person_.read("Welcome.", 0.0, wait_);
  EXPECT_EQ(now_ns_, began_ns + nanoseconds(2.0));
}

TEST_F(Reading, LastsAsLongAsABreakHasTo) {
  ParticipantScene rest = scene_to_read("Please rest.");
  rest.kind = ParticipantScene::Kind::rest;
  rest.rest_until_ns = now_ns_ + nanoseconds(60.0);
  monitor_.show(rest);
  press(42.5, Kind::confirm);
  look(43.0, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.kind, ParticipantScene::Kind::rest);
    EXPECT_TRUE(scene.rest_until_ns);
    EXPECT_FALSE(scene.can_confirm);
    EXPECT_EQ(scene.cue, "Please wait 18 more seconds.");
    EXPECT_EQ(scene.cue_message.number, 18);
  });
  look(60.5, [](const ParticipantScene& scene) { EXPECT_TRUE(scene.can_confirm); });
  hold_button(61.0, 1, 0.2);
  const std::int64_t began_ns = now_ns_;
  person_.read("Please rest.", 60.0, wait_);
  EXPECT_NEAR(1e-9 * static_cast<double>(now_ns_ - began_ns), 61.2, 0.011);
}

TEST_F(Reading, ContinuesWhenTheCountdownOfABreakIsAtItsEnd) {
  ParticipantScene rest = scene_to_read("Please rest.");
  rest.kind = ParticipantScene::Kind::rest;
  rest.rest_until_ns = now_ns_ + nanoseconds(60.0);
  monitor_.show(rest);
  press(60.05, Kind::confirm);
  const std::int64_t began_ns = now_ns_;
  wait_ = [this](double duration_s) { pass(duration_s + 0.001); };
  person_.read("Please rest.", 60.0, wait_);
  EXPECT_LT(now_ns_, began_ns + nanoseconds(60.1));
  EXPECT_TRUE(events("refused").empty());
}

TEST_F(Reading, IsNotOverByAKeyFromBefore) {
  press(0.1, Kind::confirm);
  pass(0.2);
  press(1.0, Kind::confirm);
  const std::int64_t began_ns = now_ns_;
  person_.read("Welcome.", 0.0, wait_);
  EXPECT_EQ(now_ns_, began_ns + nanoseconds(1.0));
}

TEST_F(Reading, MeansTheMaskTooAndHasATone) {
  EXPECT_TRUE(person_.wears_mask());
  look(0.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.kind, ParticipantScene::Kind::mask_on);
    EXPECT_EQ(scene.text_message.what, ParticipantMessage::What::put_mask_on);
  });
  press(1.0, Kind::confirm);
  person_.put_mask(true, wait_);
  EXPECT_EQ(sound_.count(Cue::mask_on), 1);
  hold_button(1.0, 2, 0.1);
  person_.put_mask(false, wait_);
  EXPECT_EQ(scene()->kind, ParticipantScene::Kind::mask_off);
  EXPECT_EQ(sound_.count(Cue::mask_off), 1);
}

TEST_F(Reading, OfFeedbackIsOverByItself) {
  const std::int64_t began_ns = now_ns_;
  person_.tell("Correct.", wait_);
  EXPECT_EQ(scene()->text, "Correct.");
  EXPECT_NEAR(1e-9 * static_cast<double>(now_ns_ - began_ns), 1.5, 1e-6);
}

// --- a button that is held -----------------------------------------------------------------------

}  // namespace
}  // namespace asperity
