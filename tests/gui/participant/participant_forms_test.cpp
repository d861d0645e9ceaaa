// Numbers, texts and choices that are given on the pages of a participant.

#include <algorithm>
#include <vector>

#include <QtTest/QTest>
#include <QtWidgets/QPlainTextEdit>
#include <gtest/gtest.h>

#include "app/gui/participant/participant_view.h"
#include "tests/gui/participant/participant_seat.h"
#include "tests/gui/participant/scenes.h"

namespace asperity {
namespace {

using Item = ParticipantItem;
using Kind = ParticipantInput::Kind;

TEST(ParticipantView, TakesANumberByDigitsOrPad) {
  Seat seat(scenes::form_number());
  seat.key(Qt::Key_4);
  seat.key(Qt::Key_7);
  seat.key(Qt::Key_Backspace);
  seat.click(Item::Kind::pad, "2");
  EXPECT_TRUE(seat.inputs.empty());
  seat.key(Qt::Key_Return);
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().kind, Kind::text);
  EXPECT_EQ(seat.last().text, "42");
}

TEST(ParticipantView, TakesSeveralOptionsOfAMultipleChoice) {
  ParticipantScene scene = scenes::form_choices();
  Seat seat(scene);
  seat.key(Qt::Key_3);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 3);
  scene.choices.at(0).chosen = scene.choices.at(2).chosen = true;
  seat.show(scene);
  const std::vector<Item>& items = seat.view.items();
  EXPECT_EQ(std::count_if(items.begin(), items.end(), [](const Item& item) { return item.chosen; }),
            2);
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().kind, Kind::confirm);
}

TEST(ParticipantView, SkipsAMultipleChoiceWhileNothingIsChosen) {
  Seat seat(scenes::form_choices());
  seat.click(Item::Kind::control, "Skip");
  EXPECT_EQ(seat.last().kind, Kind::confirm);
}

TEST(ParticipantView, KeepsWhatWasWrittenWhileASurfaceIsFeltAgain) {
  ParticipantScene question = scenes::form_text();
  question.kind = ParticipantScene::Kind::question;
  Seat seat(question);
  auto* field = seat.view.findChild<QPlainTextEdit*>("participant_text");
  QTest::keyClicks(field, "like sand");
  seat.show(scenes::feel(1));
  EXPECT_FALSE(field->isVisible());
  seat.show(question);
  EXPECT_EQ(field->toPlainText(), "like sand");
  question.question = "another";
  seat.show(question);
  EXPECT_EQ(field->toPlainText(), "");
}

TEST(ParticipantView, TakesAPointOfAScaleOfTheQuestionnaireByArrowsOrPointer) {
  Seat seat(scenes::form_scale(11));
  seat.key(Qt::Key_Right);
  EXPECT_EQ(seat.last().kind, Kind::step);
  EXPECT_EQ(seat.last().number, 1);
  ParticipantScene begun = scenes::form_scale(11);
  begun.scales.front().step = 5;  // the mark in the middle, which is not an answer yet
  seat.show(begun);
  seat.click(Item::Kind::control, "Skip");
  EXPECT_EQ(seat.last().kind, Kind::confirm);
  begun.scales.front().counts = true;
  begun.can_confirm = true;
  seat.show(begun);
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().kind, Kind::confirm);
}

TEST(ParticipantView, ShowsTheUnitOfANumberAndTellsOnlyTheNumber) {
  Seat seat(scenes::form_unit());
  seat.key(Qt::Key_2);
  seat.key(Qt::Key_0);
  bool shows_unit = false;
  for (const Item& item : seat.view.items()) {
    shows_unit = shows_unit || (item.kind == Item::Kind::number && item.text == "20 min");
  }
  EXPECT_TRUE(shows_unit);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "20");
}

TEST(ParticipantView, WritesNumbersWithAPointWhateverKeyWasPressed) {
  ParticipantScene scene = scenes::form_number();
  scene.form = NumberForm{};
  Seat seat(scene);
  seat.key(Qt::Key_1);
  seat.key(Qt::Key_Comma);
  seat.key(Qt::Key_5);
  seat.key(Qt::Key_Minus);
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().text, "-1.5");
}

TEST(ParticipantView, WritesTheNumberOfATrialByKeyAndByPad) {
  Seat seat(scenes::magnitude());
  seat.key(Qt::Key_1);
  seat.click(Item::Kind::pad, "2");
  seat.key(Qt::Key_Comma);
  seat.key(Qt::Key_5);
  EXPECT_TRUE(seat.inputs.empty());
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().kind, Kind::text);
  EXPECT_EQ(seat.last().text, "12.5");
}

// Left out without a word, the signs would leave another number: 12 of 1/2.
TEST(ParticipantView, TellsAtOnceOfWhatIsNoNumberAndTakesNothingUntilItIsCorrected) {
  Seat seat{};
  const auto shows = [&seat](const QString& text) {
    const std::vector<Item> items = seat.view.items();
    return std::any_of(items.begin(), items.end(),
                       [&text](const Item& item) { return item.text == text; });
  };
  const QString of_trial = "This is not a number above 0. Please correct it.";
  for (const auto& [typed, corrected] :
       {std::pair{"1/2", "1"}, std::pair{"-5", ""}, std::pair{"1.2.3", "1.2"}, std::pair{"x", ""},
        std::pair{"1234567890123456", "123456789012345"}}) {
    seat.inputs.clear();
    ParticipantScene scene = scenes::magnitude();
    scene.question = typed;  // another one: the field is empty again
    seat.show(scene);
    QTest::keyClicks(&seat.view, typed);
    EXPECT_TRUE(shows(typed)) << "it is seen as it was typed";
    EXPECT_TRUE(shows(of_trial)) << typed;
    seat.key(Qt::Key_Return);
    seat.click(Item::Kind::control, "Confirm");
    EXPECT_TRUE(seat.inputs.empty()) << typed;
    for (std::size_t i = 0; i < 2 && shows(of_trial); ++i) seat.key(Qt::Key_Backspace);
    EXPECT_FALSE(shows(of_trial)) << typed;
    if (*corrected == 0) continue;
    seat.key(Qt::Key_Return);
    EXPECT_EQ(seat.last().text, corrected);
  }
  seat.show(scenes::form_number());
  QTest::keyClicks(&seat.view, "2z");
  EXPECT_TRUE(shows("This is not a number. Please correct it."));
  seat.key(Qt::Key_Return);
  seat.key(Qt::Key_Backspace);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "2");
}

TEST(ParticipantView, UnderstandsPowersOfTen) {
  Seat seat(scenes::magnitude());
  QTest::keyClicks(&seat.view, "1e-3");
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "1e-3");
}

// On the row of digits "/" is Shift and 7: no 7, and without Shift a French "è" is one.
TEST(ParticipantView, TakesNoSignOfTheRowOfDigitsForADigitOfANumber) {
  Seat seat(scenes::magnitude());
  const auto press = [&seat](Qt::KeyboardModifiers held, const QString& text) {
    constexpr quint32 kScanCodeOf7 = 16;
    QKeyEvent event(QEvent::KeyPress, Qt::Key_unknown, held, kScanCodeOf7, 0, 0, text);
    EXPECT_TRUE(seat.view.press(event, 1));
  };
  press(Qt::NoModifier, QString::fromUtf8("è"));
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "7");
  press(Qt::ShiftModifier, "/");
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.inputs.size(), 1U);
}

// What is to be checked stays in its field: a confirmation gives it once more.
TEST(ParticipantView, KeepsANumberThatIsToBeChecked) {
  Seat seat(scenes::magnitude());
  for (const Qt::Key key : {Qt::Key_5, Qt::Key_0, Qt::Key_0}) seat.key(key);
  ParticipantScene doubted = scenes::magnitude();
  doubted.text_message = {.what = ParticipantMessage::What::check_estimate, .code = "500"};
  doubted.text = text_of(doubted.text_message);
  seat.show(doubted);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "500");
}

TEST(ParticipantView, TakesAChoiceOfAFormByKeyAndPointer) {
  Seat seat(scenes::form_choice());
  seat.key(Qt::Key_3);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 3);
  seat.click(Item::Kind::option, "yes");
  EXPECT_EQ(seat.last().number, 2);
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().kind, Kind::confirm);
}

TEST(ParticipantView, SkipsAnOptionalChoiceWhileNothingIsChosen) {
  ParticipantScene scene = scenes::form_choice();
  scene.optional = true;
  Seat seat(scene);
  seat.click(Item::Kind::control, "Skip");
  EXPECT_EQ(seat.last().kind, Kind::confirm);
  scene.choices.at(1).chosen = true;
  seat.show(scene);
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.inputs.size(), 2U);
}

TEST(ParticipantView, TakesATextAndItsReturn) {
  Seat seat(scenes::form_text());
  auto* field = seat.view.findChild<QPlainTextEdit*>("participant_text");
  ASSERT_TRUE(field->isVisible());
  const std::vector<Item>& items = seat.view.items();
  const auto place = std::find_if(items.begin(), items.end(),
                                  [](const Item& item) { return item.kind == Item::Kind::field; });
  ASSERT_NE(place, items.end());
  EXPECT_EQ(field->font().pixelSize(), place->size_px) << "large enough to be read";
  QTest::keyClicks(field, "by 2 feels");
  EXPECT_EQ(field->toPlainText(), "by 2 feels");
  EXPECT_TRUE(seat.inputs.empty());
  QTest::keyClick(field, Qt::Key_Return);
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().text, "by 2 feels");
  seat.show(scenes::form_number());
  EXPECT_FALSE(field->isVisible());
}

TEST(ParticipantView, KeepsWhatWasBegunThroughARefusalAndForgetsItAfter) {
  ParticipantScene scene = scenes::form_number();
  Seat seat(scene);
  seat.key(Qt::Key_9);
  scene.cue = "Please enter a number from 18 to 120.";
  scene.cue_number = 1;
  seat.show(scene);
  seat.key(Qt::Key_0);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "90");
  ParticipantScene another = scenes::form_number();
  another.question = "years_of_practice";
  seat.show(another);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "");
}

TEST(ParticipantView, TellsHowLongTheMouseWasHeldAndNothingOfWhatIsTypedIntoAForm) {
  Seat seat{};
  std::vector<ParticipantInput> releases{};
  QObject::connect(&seat.view, &ParticipantView::acted, [&](const ParticipantInput& input) {
    if (input.kind == Kind::released) releases.push_back(input);
  });
  seat.show(scenes::recognition(6));
  seat.click(Item::Kind::picture, "4");
  ASSERT_EQ(releases.size(), 1U);
  EXPECT_EQ(releases[0].text, "mouse button");
  EXPECT_EQ(releases[0].source, "mouse");
  EXPECT_EQ(releases[0].time_ns, seat.last().time_ns);
  EXPECT_GE(releases[0].held_s, 0.0);
  seat.show(scenes::form_number());
  seat.key(Qt::Key_4);
  seat.click(Item::Kind::pad, "2");
  seat.show(scenes::form_choice());
  seat.click(Item::Kind::option, "yes");
  EXPECT_EQ(releases.size(), 1U);
}

}  // namespace
}  // namespace asperity
