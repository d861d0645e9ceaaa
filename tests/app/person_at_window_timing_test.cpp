// What a participant presses twice, too early, too late, or holds across two screens.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scripted_person.h"
#include "tests/support/questions.h"

namespace asperity {
namespace {

// --- before the screen can be perceived -----------------------------------------------------------

class PressedTwice : public PersonAtWindowTest {
 protected:
  static Question optional_choice() {
    return {.name = "hand", .options = in_words({"right", "left"}), .optional = true};
  }
  static Question optional_text() {
    Question question{};
    question.form = TextForm{};
    question.optional = true;
    return question;
  }
};

TEST_F(PressedTwice, AKeyDoesNotAnswerTheQuestionThatTheFirstPressBrought) {
  for (const double gap_s : {0.02, 0.05, 0.1, 0.19}) {
    const std::int64_t began_ns = now_ns_;
    press(1.0, Kind::confirm);
    press(1.0 + gap_s, Kind::confirm);
    press(4.0, Kind::confirm);
    EXPECT_EQ(stored(optional_text(), person_.answer(optional_text(), wait_)), FormAnswer{});
    EXPECT_EQ(now_ns_, began_ns + nanoseconds(1.0));
    EXPECT_EQ(stored(optional_text(), person_.answer(optional_text(), wait_)), FormAnswer{});
    EXPECT_EQ(now_ns_, began_ns + nanoseconds(4.0)) << "pressed again after " << gap_s << " s";
  }
  EXPECT_TRUE(events("refused").empty()) << "it is no mistake";
  EXPECT_EQ(sound_.count(Cue::refused), 0);
  int too_soon = 0;
  for (const EventRow& input : events("input")) {
    if (input.data_json.find("too_soon") != std::string::npos) ++too_soon;
  }
  EXPECT_EQ(too_soon, 4) << "it is stored as what it was";
}

TEST_F(PressedTwice, AKeyAnswersOnceItsScreenCanHaveBeenPerceived) {
  press(PersonAtWindow::kTooSoon_s, Kind::confirm);
  const std::int64_t began_ns = now_ns_;
  person_.answer(optional_text(), wait_);
  EXPECT_EQ(now_ns_, began_ns + nanoseconds(0.2));
}

TEST_F(PressedTwice, SpaceDoesNotAskForASurfaceAgain) {
  const Trial trial = selection();
  person_.begin_attempt(1, 1);
  feel(trial, 1);
  feel(trial, 2);
  person_.announce(trial, trial.presentations[2]);
  press(1.0, Kind::next);
  press(1.15, Kind::next);
  pass(1.0);
  EXPECT_TRUE(person_.wants_next(true));
  EXPECT_EQ(ask(trial, 2.0).feel_again(), nullptr);
}

// Feeling has ended by itself while a finger was on its way to say that it is enough.
TEST_F(PressedTwice, SpaceThatComesALittleTooLateAsksForNothing) {
  const Trial trial = selection();
  feel_all(trial);
  monitor_.show(scene_of_lifting(trial, {1, 2}, 3));
  press(0.1, Kind::next);  // the hand lifts
  press(0.3, Kind::next);  // the question is there
  pass(0.2);
  person_.refuse_answers();
  EXPECT_EQ(ask(trial, 2.0).feel_again(), nullptr);
  EXPECT_TRUE(events("refused").empty());
}

// The surface was removed while a finger was on its way to "Finish": at the same place there is then "Feel again".
TEST_F(PressedTwice, FinishingThatComesTooLateDoesNotMeanFeelingAgain) {
  const Trial trial = selection();
  feel_all(trial);
  press(0.33, Kind::next);
  press(PersonAtWindow::kUnexpected_s - 0.01, Kind::next);
  EXPECT_EQ(ask(trial, 2.0).feel_again(), nullptr);
  ASSERT_EQ(events("input").size(), 2U);
  for (const EventRow& event : events("input")) {
    EXPECT_THAT(event.data_json, testing::HasSubstr(R"("too_soon":true)"));
  }
  feel(trial, 1);
  press(PersonAtWindow::kUnexpected_s, Kind::next);
  EXPECT_NE(ask(trial, 2.0).feel_again(), nullptr) << "by then the screen has been read";
}

// Who has finished expects the question.
TEST_F(PressedTwice, FeelingAgainWaitsOnlyWhereFeelingEndedByItself) {
  const Trial trial = selection();
  person_.begin_attempt(1, 1);
  feel(trial, 1);
  feel(trial, 2);
  monitor_.show(scene_of_surface(trial, {1, 2}, 3));
  person_.announce(trial, trial.presentations[2]);
  press(1.0, Kind::next);
  pass(1.0);
  ASSERT_TRUE(person_.wants_next(true));
  press(0.33, Kind::next);
  EXPECT_NE(ask(trial, 2.0).feel_again(), nullptr);
}

// The keys of the response have no other meaning before.
TEST_F(PressedTwice, ResponsesDoNotWaitWhereFeelingEndedByItself) {
  const Trial trial = selection();
  feel_all(trial);
  press(0.3, Kind::option, 2);
  press(0.4, Kind::confirm);
  EXPECT_EQ(options_of(ask(trial, 2.0)), Options{1});
}

TEST_F(PressedTwice, KeysOfOneQuestionFollowAsFastAsFingersAre) {
  feel_all(selection());
  press(1.0, Kind::option, 2);
  press(1.04, Kind::confirm);
  EXPECT_EQ(options_of(ask(selection())), Options{1});
}

TEST_F(PressedTwice, TheSecondButtonDoesNotConfirmTheWholeWithItsLastSurface) {
  feel_all(matching());
  double at_s = 0.0;
  for (int surface = 1; surface <= 3; ++surface) {
    for (int step = 1; step <= surface; ++step) hold_button(at_s += 1.0, 1, 0.1);
    hold_button(at_s += 1.0, 2, 0.05);
  }
  hold_button(at_s + 0.15, 2, 0.05);
  hold_button(at_s + 0.4, 2, 0.05);
  const std::int64_t answered_ns = now_ns_ + nanoseconds(at_s + 0.4);
  const Reply reply = ask(matching());
  EXPECT_EQ(options_of(reply), (Options{0, 1, 2}));
  EXPECT_EQ(reply.answered_ns, answered_ns);
}

TEST_F(PressedTwice, AButtonThatBouncesWhenItIsLetGoIsNotPressedAgain) {
  const std::int64_t began_ns = now_ns_;
  hold_button(1.0, 2, 0.4);  // released 0.4 s after the next screen was shown
  hold_button(1.405, 2, 0.003);
  hold_button(1.412, 2, 0.002);
  press(4.0, Kind::confirm);
  person_.answer(optional_choice(), wait_);
  EXPECT_EQ(now_ns_, began_ns + nanoseconds(1.0));
  person_.answer(optional_choice(), wait_);
  EXPECT_EQ(now_ns_, began_ns + nanoseconds(4.0));
}

/// Down in one state and released in the next: what it answers is decided where it was pressed.
class HeldAcross : public PersonAtWindowTest {};

TEST_F(HeldAcross, TheDeadlineItAnswersNothingThatComesAfter) {
  feel_all(selection());
  press(0.5, Kind::option, 2);
  hold_button(3.5, 1, 1.0);  // a confirmation, released 0.5 s too late
  EXPECT_TRUE(options_of(ask(selection(), 4.0)).empty());
  const std::int64_t told_ns = now_ns_;
  monitor_.show(scene_of_feedback(false, ""));
  person_.tell("Incorrect.", wait_);
  EXPECT_GE(now_ns_, told_ns + nanoseconds(1.5)) << "the feedback stays";
  hold_button(0.5, 1, 0.1);
  const std::int64_t began_ns = now_ns_;
  person_.read("Welcome.", 0.0, wait_);
  EXPECT_NEAR(1e-9 * static_cast<double>(now_ns_ - began_ns), 0.6, 0.011);
}

TEST_F(HeldAcross, TheDeadlineItAnswersNotTheNextQuestion) {
  feel_all(selection());
  press(0.5, Kind::option, 2);
  hold_button(3.5, 1, 1.0);
  EXPECT_TRUE(options_of(ask(selection(), 4.0)).empty());
  feel_all(selection());
  press(0.5, Kind::option, 2);
  EXPECT_TRUE(options_of(ask(selection(), 2.0)).empty());
}

TEST_F(HeldAcross, TheOpeningOfTheQuestionItAnswersNothing) {
  feel_all(selection());
  hold_button(0.0, 1, 1.5);
  pass(0.0);  // down, then the question is shown
  pass(0.3);
  press(1.0, Kind::option, 2);
  EXPECT_TRUE(options_of(ask(selection(), 3.0)).empty());
}

TEST_F(HeldAcross, TheEndOfTheShortestBreakItDoesNotGoOn) {
  ParticipantScene rest = scene_to_read("Please rest.");
  rest.kind = ParticipantScene::Kind::rest;
  rest.rest_until_ns = now_ns_ + nanoseconds(10.0);
  monitor_.show(rest);
  hold_button(9.5, 1, 1.0);
  press(12.0, Kind::confirm);
  const std::int64_t began_ns = now_ns_;
  person_.read("Please rest.", 10.0, wait_);
  EXPECT_GE(now_ns_, began_ns + nanoseconds(12.0));
}

// Held, it gives the last picture when it is released: pressed again at once it confirms nothing.
TEST_F(HeldAcross, TheLastPictureItsNextPressIsNotTheConfirmationOfTheWhole) {
  feel_all(matching());
  double at_s = 0.0;
  for (int surface = 1; surface <= 3; ++surface) {
    for (int step = 1; step <= surface; ++step) hold_button(at_s += 1.0, 1, 0.1);
    hold_button(at_s += 1.0, 1, 0.9);
    at_s += 1.0;
  }
  at_s -= 1.0;
  hold_button(at_s + 0.9 + 0.05, 2, 0.05);
  hold_button(at_s + 3.0, 2, 0.05);
  const std::int64_t answered_ns = now_ns_ + nanoseconds(at_s + 3.0);
  const Reply reply = ask(matching());
  EXPECT_EQ(options_of(reply), (Options{0, 1, 2}));
  EXPECT_EQ(reply.answered_ns, answered_ns);
}

}  // namespace
}  // namespace asperity
