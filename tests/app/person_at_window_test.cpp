// The rules by which a person answers, without any window.

#include "app/session/respondents/person_at_window.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <thread>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/replies.h"
#include "tests/support/scripted_sound.h"

namespace asperity {
namespace {

using Kind = ParticipantInput::Kind;

std::int64_t nanoseconds(double time_s) {
  return static_cast<std::int64_t>(std::llround(1e9 * time_s));
}

/// A selection of three surfaces, "cannot tell" allowed.
Trial selection() {
  Trial trial{};
  trial.ordinal = 1;
  trial.questions.resize(1);
  for (int position = 1; position <= 3; ++position) {
    PlannedPresentation planned{};
    planned.position = position;
    planned.code = std::string(1, static_cast<char>('A' + position - 1));
    trial.presentations.push_back(planned);
    trial.questions.front().options.push_back({"item", planned.code, std::nullopt});
  }
  trial.questions.front().options.push_back({"cannot_tell", "I cannot tell", std::nullopt});
  trial.questions.front().prompt = "Which one?";
  return trial;
}

/// Three surfaces to as many pictures; nothing is felt again.
Trial matching() {
  Trial trial = selection();
  trial.questions.front().form = AssignmentForm{};
  trial.questions.front().options.clear();
  for (int place = 1; place <= 3; ++place) {
    trial.questions.front().options.push_back(
        {"texture", std::to_string(place), "stimuli/picture.png"});
  }
  trial.arrangement.maximum_visits = 1;
  trial.pictures_after_feeling = true;
  return trial;
}

/// A person with a script: what is pressed when, on a clock that only waiting moves.
class PersonAtWindowTest : public testing::Test {
 protected:
  static constexpr double kBegin_s = 100.0;
  PersonAtWindowTest() {
    monitor_.update([this](SessionSnapshot& snapshot) { snapshot.now_ns = now_ns_; });
  }

  /// `after_s` counts from now.
  void press(double after_s, ParticipantInput input) {
    input.time_ns = now_ns_ + nanoseconds(after_s);
    script_.emplace(input.time_ns, std::move(input));
  }
  void press(double after_s, Kind kind, int number = 0, int surface = 0) {
    press(after_s, {.kind = kind, .number = number, .surface = surface});
  }
  void type(double after_s, const std::string& text) {
    press(after_s, {.kind = Kind::text, .text = text});
  }
  /// A device button, down for `held_s`.
  void hold_button(double after_s, int button, double held_s) {
    buttons_.emplace(now_ns_ + nanoseconds(after_s),
                     ButtonChange{button, true, now_ns_ + nanoseconds(after_s)});
    buttons_.emplace(now_ns_ + nanoseconds(after_s + held_s),
                     ButtonChange{button, false, now_ns_ + nanoseconds(after_s + held_s)});
  }

  void pass(double duration_s) {
    now_ns_ += nanoseconds(duration_s);
    if (now_ns_ > nanoseconds(kBegin_s + 600.0)) throw std::runtime_error("waits for ever");
    monitor_.update([this](SessionSnapshot& snapshot) { snapshot.now_ns = now_ns_; });
    while (!script_.empty() && script_.begin()->first <= now_ns_) {
      person_.post(script_.begin()->second);
      script_.erase(script_.begin());
    }
    while (!buttons_.empty() && buttons_.begin()->first <= now_ns_) {
      person_.button_changed(buttons_.begin()->second);
      buttons_.erase(buttons_.begin());
    }
  }

  /// Goes through all surfaces as a conductor does.
  void feel_all(const Trial& trial) {
    person_.begin_attempt(trial.ordinal, ++attempt_);
    for (const PlannedPresentation& surface : trial.presentations) feel(trial, surface.position);
  }
  void feel(const Trial& trial, int position) {
    monitor_.show(scene_of_surface(trial, {}, position));
    person_.announce(trial, trial.presentations.at(static_cast<std::size_t>(position - 1)));
    pass(1.0);
    monitor_.show({});
  }
  Reply ask(const Trial& trial, std::optional<double> deadline_s = {}) {
    ParticipantScene scene = scene_of_question(trial, trial.questions, {1, 2, 3});
    scene.block = 3;
    scene.blocks = 6;
    monitor_.show(std::move(scene));
    return person_.ask(trial, trial.questions, {}, deadline_s, wait_);
  }
  Reply feel_all_and_ask(const Trial& trial, std::optional<double> deadline_s = {}) {
    feel_all(trial);
    return ask(trial, deadline_s);
  }
  /// What was seen while waiting, at `after_s` from now.
  void look(double after_s, std::function<void(const ParticipantScene&)> see) {
    looks_.emplace(now_ns_ + nanoseconds(after_s), std::move(see));
  }

  std::shared_ptr<const ParticipantScene> scene() const { return monitor_.snapshot().scene; }
  std::vector<EventRow> events(const std::string& kind) {
    for (EventRow& event : person_.take_events()) events_.push_back(std::move(event));
    std::vector<EventRow> found{};
    std::copy_if(events_.begin(), events_.end(), std::back_inserter(found),
                 [&kind](const EventRow& event) { return event.kind == kind; });
    return found;
  }

  std::int64_t now_ns_ = nanoseconds(kBegin_s);
  SessionMonitor monitor_{};
  SoundLog sound_{};
  ScriptedSound loudspeakers_{sound_};
  PersonAtWindow person_{monitor_, &loudspeakers_};
  std::multimap<std::int64_t, ParticipantInput> script_{};
  std::multimap<std::int64_t, ButtonChange> buttons_{};
  std::multimap<std::int64_t, std::function<void(const ParticipantScene&)>> looks_{};
  std::vector<EventRow> events_{};
  int attempt_ = 0;
  Wait wait_ = [this](double duration_s) {
    pass(duration_s);
    while (!looks_.empty() && looks_.begin()->first <= now_ns_) {
      looks_.begin()->second(*scene());
      looks_.erase(looks_.begin());
    }
  };
};

using Options = std::vector<std::size_t>;

// --- a number ------------------------------------------------------------------------------------

class ANumber : public PersonAtWindowTest {
 protected:
  ANumber() {
    trial_.presentations.resize(1);
    trial_.questions = {{}};
    trial_.questions.front().form = NumberForm{};
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
  hold_button(1.0, 1, 0.2);
  type(2.0, "3");
  EXPECT_EQ(ask(trial_).number(), 3.0);
  const std::vector<EventRow> refused = events("refused");
  ASSERT_EQ(refused.size(), 3U);
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
    EXPECT_EQ(scene.cue_saying.what, Saying::What::choose_first);
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

// --- what nobody can have perceived --------------------------------------------------------------

class PressedTwice : public PersonAtWindowTest {
 protected:
  static Question optional_text() {
    Question question{};
    question.form = Question::Form::text;
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
    EXPECT_EQ(person_.answer(optional_text(), wait_), FormAnswer{});
    EXPECT_EQ(now_ns_, began_ns + nanoseconds(1.0));
    EXPECT_EQ(person_.answer(optional_text(), wait_), FormAnswer{});
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
  hold_button(1.0, 2, 0.4);  // let go 0.4 s after the next screen was shown
  hold_button(1.405, 2, 0.003);
  hold_button(1.412, 2, 0.002);
  press(4.0, Kind::confirm);
  person_.answer(optional_text(), wait_);
  EXPECT_EQ(now_ns_, began_ns + nanoseconds(1.0));
  person_.answer(optional_text(), wait_);
  EXPECT_EQ(now_ns_, began_ns + nanoseconds(4.0));
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
    EXPECT_EQ(scene.cue_saying.code, "C");
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
    EXPECT_EQ(scene.cue_saying.number, 18);
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
    EXPECT_EQ(scene.text_saying.what, Saying::What::put_mask_on);
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

/// Down in one state and let go in the next: what it answers is decided where it went down.
class HeldAcross : public PersonAtWindowTest {};

TEST_F(HeldAcross, TheDeadlineItAnswersNothingThatComesAfter) {
  feel_all(selection());
  press(0.5, Kind::option, 2);
  hold_button(3.5, 1, 1.0);  // a confirmation, let go 0.5 s too late
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

// Held, it gives the last picture when it is let go: pressed again at once it confirms nothing.
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

// --- forms ---------------------------------------------------------------------------------------

class AForm : public PersonAtWindowTest {
 protected:
  static Question number(double minimum, double maximum) {
    Question question{};
    question.prompt = "How old are you?";
    question.form = Question::Form::number;
    question.minimum = minimum;
    question.maximum = maximum;
    return question;
  }
  static Question choice() {
    Question question{};
    question.form = Question::Form::choice;
    question.options = {"good", "tired", "5"};
    return question;
  }
};

TEST_F(AForm, TakesANumberWithinItsLimits) {
  type(1.0, "old");
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.kind, ParticipantScene::Kind::form);
    EXPECT_EQ(scene.cue, "Please enter a number from 18 to 120.");
    EXPECT_EQ(scene.cue_saying.minimum, 18.0);
  });
  type(2.0, "17");
  type(2.1, "121");
  type(2.2, "");
  look(2.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Please answer this question.");
    EXPECT_EQ(scene.cue_number, 4U);
  });
  type(3.0, " 42 ");
  EXPECT_EQ(person_.answer(number(18, 120), wait_), FormAnswer{"42"});
  EXPECT_EQ(sound_.count(Cue::refused), 4);
}

TEST_F(AForm, TakesAnOptionByItsWordsOrItsNumber) {
  type(1.0, "awful");
  type(2.0, "tired");
  EXPECT_EQ(person_.answer(choice(), wait_), FormAnswer{"tired"});
  press(1.0, Kind::option, 9);
  press(2.0, Kind::option, 1);
  EXPECT_EQ(person_.answer(choice(), wait_), FormAnswer{"good"});
  type(1.0, "5");
  EXPECT_EQ(person_.answer(choice(), wait_), FormAnswer{"5"});
  EXPECT_EQ(events("refused").size(), 1U);
}

TEST_F(AForm, TakesSeveralOptionsInTheirOrder) {
  Question question = choice();
  question.form = Question::Form::multiple_choice;
  type(1.0, "3 1");
  EXPECT_EQ(person_.answer(question, wait_), (FormAnswer{"good", "5"}));
  type(1.0, "2, 2");
  EXPECT_EQ(person_.answer(question, wait_), FormAnswer{"tired"});
  type(1.0, "1 4");
  type(2.0, "");
  type(3.0, "good");
  EXPECT_EQ(person_.answer(question, wait_), FormAnswer{"good"});
  EXPECT_EQ(events("refused").size(), 2U);
}

TEST_F(AForm, TakesOnlyThePointsOfAScale) {
  Question question{};
  question.form = Question::Form::scale;
  question.scale = {.minimum = 1.0, .maximum = 7.0, .points = 7};
  type(1.0, "2.5");
  look(1.5, [](const ParticipantScene& scene) {
    EXPECT_EQ(scene.cue, "Please enter a number from 1 to 7.");
  });
  type(2.0, "8");
  type(3.0, "5");
  EXPECT_EQ(person_.answer(question, wait_), FormAnswer{"5"});
  EXPECT_EQ(events("refused").size(), 2U);
}

TEST_F(AForm, MayBeLeftEmptyWhereItIsOptional) {
  Question question{};
  question.form = Question::Form::text;
  question.optional = true;
  press(1.0, Kind::confirm);
  EXPECT_EQ(person_.answer(question, wait_), FormAnswer{});
  question.optional = false;
  press(1.0, Kind::confirm);
  type(2.0, "yes");
  EXPECT_EQ(person_.answer(question, wait_), FormAnswer{"yes"});
  EXPECT_EQ(events("refused").size(), 1U);
}

TEST_F(AForm, IsAnsweredAtTheStampOfTheKeyNotWhenItIsHeard) {
  EXPECT_FALSE(person_.answered_ns());
  const std::int64_t pressed_ns = now_ns_ + nanoseconds(1.0);
  script_.emplace(now_ns_ + nanoseconds(1.4),
                  ParticipantInput{.kind = Kind::text, .text = "tired", .time_ns = pressed_ns});
  person_.answer(choice(), wait_);
  EXPECT_EQ(now_ns_, pressed_ns + nanoseconds(0.4));
  EXPECT_EQ(person_.answered_ns(), pressed_ns);
}

TEST_F(AForm, KeepsWhatWasTypedOutOfTheEvents) {
  Question question{};
  question.form = Question::Form::text;
  type(1.0, "numbness in the left hand");
  EXPECT_EQ(person_.answer(question, wait_), FormAnswer{"numbness in the left hand"});
  for (const EventRow& event : events("input")) {
    EXPECT_EQ((event.text + event.data_json).find("numbness"), std::string::npos);
  }
}

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
  EXPECT_EQ(felt_again(reply), 2) << "it goes round the surfaces";
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
    EXPECT_EQ(scene.cue_saying.what, Saying::What::feel_again);
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
  question.form = Question::Form::choice;
  question.options = {"good", "tired"};
  hold_button(1.0, 2, 0.1);
  hold_button(2.0, 1, 0.1);
  hold_button(3.0, 1, 0.1);
  hold_button(4.0, 2, 0.1);
  EXPECT_EQ(person_.answer(question, wait_), FormAnswer{"tired"});
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

// A window posts from its own thread while the conductor listens.
TEST(PersonAtWindowThreads, HearWhatIsPostedFromAnother) {
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
