#include "app/gui/participant/participant_view.h"

#include <QtCore/QLocale>
#include <QtCore/QRegularExpression>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QPlainTextEdit>
#include <gtest/gtest.h>

#include "app/gui/participant/live_guide.h"
#include "app/gui/participant/pages/guide_rows.h"
#include "app/gui/participant/picture_shelf.h"
#include "app/gui/participant/response_keys.h"
#include "app/gui/participant/type_size.h"
#include "renderers/servo/servo_thread.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

using Item = ParticipantItem;
using Kind = ParticipantInput::Kind;

/// A view on a monitor that the test fills, and what was done to it.
struct Seat {
  scenes::PictureFolder pictures{};
  SessionMonitor monitor{};
  ParticipantView view{monitor, pictures.path(), ParticipantView::Role::participant};
  ResponseKeys keys{view};
  std::vector<ParticipantInput> inputs{};

  Seat() {
    QObject::connect(&view, &ParticipantView::acted, [this](const ParticipantInput& input) {
      if (input.kind != Kind::released) inputs.push_back(input);
    });
    view.resize(1366, 768);
    view.show();
  }
  explicit Seat(const ParticipantScene& scene) : Seat() { show(scene); }
  void show(const ParticipantScene& scene) {
    monitor.show(scene);
    const std::shared_ptr<const ParticipantScene> shown = monitor.snapshot().scene;
    ASSERT_TRUE(eventually([&] { return &view.scene() == shown.get(); }));
  }
  QPoint place_of(Item::Kind kind, const QString& text_or_key) const {
    for (const Item& item : view.items()) {
      if (item.kind == kind && (item.text == text_or_key || item.key == text_or_key)) {
        return item.rect.center().toPoint();
      }
    }
    ADD_FAILURE() << "nothing says " << text_or_key.toStdString();
    return {};
  }
  void click(Item::Kind kind, const QString& text_or_key) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, place_of(kind, text_or_key));
  }
  void key(Qt::Key key) { QTest::keyClick(&view, key); }
  ParticipantInput last() const { return inputs.empty() ? ParticipantInput{} : inputs.back(); }
};

TEST(ParticipantView, TellsChoicesByMouseAndByKeyAlike) {
  Seat seat(scenes::recognition(6));
  seat.click(Item::Kind::picture, "4");
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 4);
  EXPECT_EQ(seat.last().source, "mouse");
  seat.key(Qt::Key_2);
  ASSERT_EQ(seat.inputs.size(), 2U);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 2);
  EXPECT_EQ(seat.last().source, "keyboard");
  seat.key(Qt::Key_0);
  EXPECT_EQ(seat.last().number, 7);  // "I cannot tell" stands last
  seat.key(Qt::Key_Space);
  EXPECT_EQ(seat.last().kind, Kind::next);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().kind, Kind::confirm);
  seat.click(Item::Kind::control, "Feel again");
  EXPECT_EQ(seat.last().kind, Kind::next);
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().kind, Kind::confirm);
  EXPECT_EQ(seat.inputs.size(), 7U);
}

TEST(ParticipantView, TakesKeysOfTwoDigits) {
  Seat seat(scenes::recognition(12));
  seat.key(Qt::Key_1);
  EXPECT_EQ(seat.last().number, 1);
  seat.key(Qt::Key_2);
  EXPECT_EQ(seat.last().number, 12);
}

TEST(ParticipantView, TakesTheDigitsOfAFrenchKeyboard) {
  Seat seat(scenes::recognition(6));
  // The key with the 2 on it types "é" without shift.
  QKeyEvent event(QEvent::KeyPress, Qt::Key_Eacute, Qt::NoModifier, 11, 0, 0, QString(QChar(0xE9)));
  QApplication::sendEvent(&seat.view, &event);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 2);
}

TEST(ParticipantView, AnswersASelectionByLetter) {
  Seat seat(scenes::selection(3));
  seat.key(Qt::Key_B);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 2);
  seat.click(Item::Kind::option, "C");
  EXPECT_EQ(seat.last().number, 3);
  seat.click(Item::Kind::option, "I cannot tell");
  EXPECT_EQ(seat.last().number, 4);
}

TEST(ParticipantView, MarksAScaleWhereItIsPressedAndWhileItIsDragged) {
  Seat seat(scenes::scales(5));
  const std::vector<Item> items = seat.view.items();
  const auto scale = std::find_if(items.begin(), items.end(), [](const Item& item) {
    return item.kind == Item::Kind::scale && item.action->number == 4;
  });
  ASSERT_NE(scale, items.end());
  const QPoint middle = scale->rect.center().toPoint();
  QTest::mousePress(&seat.view, Qt::LeftButton, {}, middle);
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().kind, Kind::mark);
  EXPECT_EQ(seat.last().number, 4);
  EXPECT_DOUBLE_EQ(seat.last().position, 0.5);
  QTest::mouseMove(&seat.view, middle + QPoint(1, 0));  // the same point
  EXPECT_EQ(seat.inputs.size(), 1U);
  const QPoint beyond(static_cast<int>(scale->rect.right()) + 40, middle.y());
  QTest::mouseMove(&seat.view, beyond);
  EXPECT_DOUBLE_EQ(seat.last().position, 1.0);
  QTest::mouseRelease(&seat.view, Qt::LeftButton, {}, beyond);
  EXPECT_EQ(seat.inputs.size(), 2U) << "its marks have been told";
}

TEST(ParticipantView, MovesTheMarkOfAScaleByArrows) {
  Seat seat(scenes::scales(5));
  seat.key(Qt::Key_Right);
  EXPECT_EQ(seat.last().kind, Kind::step);
  EXPECT_EQ(seat.last().number, 1);
  seat.key(Qt::Key_Left);
  EXPECT_EQ(seat.last().number, -1);
  seat.key(Qt::Key_Down);
  EXPECT_EQ(seat.last().kind, Kind::select);
  EXPECT_EQ(seat.last().number, 1);
  seat.key(Qt::Key_6);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 6);
}

TEST(ParticipantView, DrawsALineThatIsAProportionOfTheScreen) {
  Seat seat(scenes::drawn_line());
  const std::vector<Item> items = seat.view.items();
  const auto line = std::find_if(items.begin(), items.end(),
                                 [](const Item& item) { return item.kind == Item::Kind::line; });
  ASSERT_NE(line, items.end());
  EXPECT_EQ(line->line_step, 350);
  const double longest = line->rect.width() - 2.0 * line->side;
  EXPECT_NEAR(longest, 0.8 * seat.view.width(), 1e-6);
  EXPECT_TRUE(line->text.isEmpty()) << "no number is shown";
  const QPoint quarter(static_cast<int>(line->rect.left() + line->side + 0.25 * longest),
                       line->rect.center().toPoint().y());
  QTest::mousePress(&seat.view, Qt::LeftButton, {}, quarter);
  EXPECT_EQ(seat.last().kind, Kind::mark);
  EXPECT_EQ(seat.last().number, 1);
  EXPECT_NEAR(seat.last().position, 0.25, 0.002);
  const QPoint before(static_cast<int>(line->rect.left()), quarter.y());
  QTest::mouseMove(&seat.view, before);
  EXPECT_DOUBLE_EQ(seat.last().position, 1.0 / LineForm::kSteps) << "no line without a length";
  QTest::mouseRelease(&seat.view, Qt::LeftButton, {}, before);
}

TEST(ParticipantView, ExtendsALineByArrowsAndConfirmsItByReturn) {
  Seat seat(scenes::drawn_line());
  seat.key(Qt::Key_Right);
  EXPECT_EQ(seat.last().kind, Kind::step);
  EXPECT_EQ(seat.last().number, 1);
  seat.key(Qt::Key_Left);
  EXPECT_EQ(seat.last().number, -1);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().kind, Kind::confirm);
}

TEST(ParticipantView, ListsTheLabelledPointsOfAScale) {
  Seat seat(scenes::scale_with_labels());
  seat.click(Item::Kind::option, "agree");
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 4);
}

TEST(ParticipantView, AssignsByClickOnASurfaceAndThenAPicture) {
  Seat seat(scenes::matching(4));
  seat.click(Item::Kind::chip, "C");
  EXPECT_TRUE(seat.inputs.empty());
  seat.click(Item::Kind::picture, "2");
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().kind, Kind::assign);
  EXPECT_EQ(seat.last().surface, 3);
  EXPECT_EQ(seat.last().number, 2);
}

TEST(ParticipantView, AssignsByDraggingASurfaceOntoAPicture) {
  Seat seat(scenes::matching(4));
  const QPoint from = seat.place_of(Item::Kind::chip, "D");
  const QPoint onto = seat.place_of(Item::Kind::picture, "1");
  QTest::mousePress(&seat.view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&seat.view, (from + onto) / 2);
  QTest::mouseMove(&seat.view, onto);
  QTest::mouseRelease(&seat.view, Qt::LeftButton, {}, onto);
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().kind, Kind::assign);
  EXPECT_EQ(seat.last().surface, 4);
  EXPECT_EQ(seat.last().number, 1);
}

TEST(ParticipantView, DropsASurfaceBesideThePicturesWithoutEffect) {
  Seat seat(scenes::matching(4));
  const QPoint from = seat.place_of(Item::Kind::chip, "D");
  QTest::mousePress(&seat.view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&seat.view, from + QPoint(60, 0));
  QTest::mouseMove(&seat.view, QPoint(10, 10));
  QTest::mouseRelease(&seat.view, Qt::LeftButton, {}, QPoint(10, 10));
  EXPECT_TRUE(seat.inputs.empty());
  seat.click(Item::Kind::picture, "1");
  EXPECT_EQ(seat.last().kind, Kind::option);  // nor was it picked
}

TEST(ParticipantView, TakesASurfaceBackThatIsDraggedOffItsPicture) {
  ParticipantScene scene = scenes::matching(4);
  scene.choices[1].assigned_to = "C";
  Seat seat(scene);
  const QPoint from = seat.place_of(Item::Kind::picture, "2");
  const auto drag_to = [&](QPoint to) {
    QTest::mousePress(&seat.view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&seat.view, from + QPoint(30, 30));
    QTest::mouseMove(&seat.view, to);
    QTest::mouseRelease(&seat.view, Qt::LeftButton, {}, to);
  };
  drag_to(seat.place_of(Item::Kind::picture, "4"));
  EXPECT_EQ(seat.last().kind, Kind::assign);
  EXPECT_EQ(seat.last().number, 4);
  EXPECT_EQ(seat.last().surface, 3);
  drag_to(QPoint(683, 40));
  EXPECT_EQ(seat.last().kind, Kind::assign);
  EXPECT_EQ(seat.last().number, 2);
  EXPECT_EQ(seat.last().surface, 0);
}

// A cue is one more thing in the picture, and goes by itself after some seconds.
TEST(ParticipantView, KeepsWhatIsUnderTheHandWhenACueComesOrGoes) {
  for (const bool first_with_cue : {true, false}) {
    Seat seat{};
    ParticipantScene quiet = scenes::matching(4);
    quiet.cue.clear();
    quiet.choices[3].assigned_to = "C";
    ParticipantScene with_cue = quiet;
    with_cue.cue = "Please assign a picture to surface D first.";
    with_cue.cue_number = 7;
    seat.show(first_with_cue ? with_cue : quiet);
    const QPoint from = seat.place_of(Item::Kind::picture, "4");
    const std::size_t things = seat.view.items().size();
    QTest::mousePress(&seat.view, Qt::LeftButton, {}, from);
    QTest::mouseMove(&seat.view, from + QPoint(30, 30));
    seat.show(first_with_cue ? quiet : with_cue);
    ASSERT_NE(seat.view.items().size(), things);
    QTest::mouseMove(&seat.view, QPoint(683, 40));
    QTest::mouseRelease(&seat.view, Qt::LeftButton, {}, QPoint(683, 40));
    EXPECT_EQ(seat.last().kind, Kind::assign);
    EXPECT_EQ(seat.last().number, 4);
    EXPECT_EQ(seat.last().surface, 0);
    QTest::mousePress(&seat.view, Qt::LeftButton, {}, from);
    seat.show(first_with_cue ? with_cue : quiet);
    QTest::mouseRelease(&seat.view, Qt::LeftButton, {}, from);
    EXPECT_EQ(seat.last().kind, Kind::option);
    EXPECT_EQ(seat.last().number, 4);
  }
}

TEST(ParticipantView, AssignsByKeysAlone) {
  ParticipantScene scene = scenes::matching(3);
  scene.can_switch = true;
  Seat seat(scene);
  seat.key(Qt::Key_2);  // for the surface that is next
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.last().number, 2);
  seat.key(Qt::Key_C);
  seat.key(Qt::Key_1);
  EXPECT_EQ(seat.last().kind, Kind::assign);
  EXPECT_EQ(seat.last().surface, 3);
  EXPECT_EQ(seat.last().number, 1);
  seat.key(Qt::Key_Space);  // C is still picked: it is the one to be felt again
  EXPECT_EQ(seat.last().kind, Kind::surface);
  EXPECT_EQ(seat.last().number, 3);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().kind, Kind::confirm);
}

TEST(ParticipantView, ForgetsThePickedSurfaceOnceItHasItsPicture) {
  ParticipantScene scene = scenes::matching(3);
  Seat seat(scene);
  seat.key(Qt::Key_C);
  seat.key(Qt::Key_1);
  scene.choices[0].assigned_to = "C";
  seat.show(scene);
  seat.key(Qt::Key_2);
  EXPECT_EQ(seat.last().kind, Kind::option);
}

TEST(ParticipantView, AsksForMoreOrLessOfASurfaceWhileItIsFelt) {
  ParticipantScene scene = scenes::feel(3);
  scene.surfaces[0].can_go = true;
  Seat seat(scene);
  seat.key(Qt::Key_Space);
  EXPECT_EQ(seat.last().kind, Kind::next);
  seat.key(Qt::Key_A);
  EXPECT_EQ(seat.last().kind, Kind::surface);
  EXPECT_EQ(seat.last().number, 1);
  seat.click(Item::Kind::chip, "A");
  EXPECT_EQ(seat.last().kind, Kind::surface);
  seat.click(Item::Kind::control, "Space");
  EXPECT_EQ(seat.last().kind, Kind::next);
  // An answer before all was felt is told too: the session refuses it with a cue.
  seat.key(Qt::Key_3);
  EXPECT_EQ(seat.last().kind, Kind::option);
  EXPECT_EQ(seat.inputs.size(), 5U);
}

TEST(ParticipantView, ContinuesByReturnOrClick) {
  Seat seat{};
  for (const ParticipantScene& scene :
       {scenes::to_read(), scenes::mask(true), scenes::mask(false), scenes::rest(0)}) {
    seat.inputs.clear();
    seat.show(scene);
    seat.key(Qt::Key_Return);
    seat.key(Qt::Key_Enter);
    seat.click(Item::Kind::control, "Return");
    seat.key(Qt::Key_X);
    seat.key(Qt::Key_Space);
    ASSERT_EQ(seat.inputs.size(), 3U);
    for (const ParticipantInput& input : seat.inputs) EXPECT_EQ(input.kind, Kind::confirm);
  }
}

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
  Seat seat(scenes::form_choices());
  seat.key(Qt::Key_3);
  seat.key(Qt::Key_1);
  seat.key(Qt::Key_4);
  seat.key(Qt::Key_4);
  EXPECT_TRUE(seat.inputs.empty()) << "nothing is told before it is confirmed";
  seat.key(Qt::Key_Return);
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().kind, Kind::text);
  EXPECT_EQ(seat.last().text, "1 3");
}

TEST(ParticipantView, LeavesOutAMultipleChoiceOfWhichNothingIsChosenAnyMore) {
  Seat seat(scenes::form_choices());
  seat.key(Qt::Key_2);
  seat.key(Qt::Key_2);
  seat.click(Item::Kind::control, "Skip");
  EXPECT_EQ(seat.last().text, "");
}

TEST(ParticipantView, TakesAPointOfAScaleOfTheQuestionnaireByArrowsOrPointer) {
  Seat seat(scenes::form_scale(11));
  seat.key(Qt::Key_Right);  // shows the mark in the middle, which is not an answer yet
  seat.click(Item::Kind::control, "Skip");
  EXPECT_EQ(seat.last().text, "");
  seat.show(ParticipantScene{});
  seat.show(scenes::form_scale(11));
  seat.key(Qt::Key_Right);
  seat.key(Qt::Key_Right);
  seat.key(Qt::Key_Right);
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().text, "7");
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
  scene.question->minimum.reset();
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
    scene.question = Question{.name = typed};  // another one: the field is empty again
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
  doubted.text_saying = {.what = Saying::What::check_estimate, .code = "500"};
  doubted.text = text_of(doubted.text_saying);
  seat.show(doubted);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "500");
}

TEST(ParticipantView, TakesAChoiceOfAFormAfterConfirmation) {
  Seat seat(scenes::form_choice());
  seat.key(Qt::Key_3);
  seat.click(Item::Kind::option, "yes");
  EXPECT_TRUE(seat.inputs.empty());
  seat.click(Item::Kind::control, "Confirm");
  EXPECT_EQ(seat.last().kind, Kind::text);
  EXPECT_EQ(seat.last().text, "yes");
}

TEST(ParticipantView, ShowsTheTextOfAnOptionAndGivesItsValue) {
  ParticipantScene scene = scenes::form_choice();
  scene.question->options = {"right", "left"};
  scene.question->option_texts = {"rechts", "links"};
  Seat seat(scene);
  seat.click(Item::Kind::option, "links");
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().text, "left");
}

TEST(ParticipantView, LeavesOutWhatMayBeLeftOut) {
  ParticipantScene scene = scenes::form_choice();
  scene.question->optional = true;
  Seat seat(scene);
  seat.key(Qt::Key_1);
  seat.key(Qt::Key_1);  // taken back
  seat.click(Item::Kind::control, "Skip");
  EXPECT_EQ(seat.last().kind, Kind::text);
  EXPECT_EQ(seat.last().text, "");
}

TEST(ParticipantView, TakesATextAndItsReturn) {
  Seat seat(scenes::form_text());
  auto* field = seat.view.findChild<QPlainTextEdit*>("participant_text");
  ASSERT_TRUE(field->isVisible());
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
  another.question->name = "years_of_practice";
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
  EXPECT_EQ(releases.size(), 1U);
}

TEST(ParticipantView, IgnoresAutoRepeat) {
  Seat seat(scenes::recognition(6));
  for (const bool repeat : {false, true, true, true}) {
    QKeyEvent press(QEvent::KeyPress, Qt::Key_1, Qt::NoModifier, "1", repeat);
    QApplication::sendEvent(&seat.view, &press);
  }
  EXPECT_EQ(seat.inputs.size(), 1U);
}

TEST(ParticipantView, StampsWithTheTimeOfTheEventOnTheSessionsClock) {
  constexpr std::int64_t kAhead_ns = 7'000'000'000'000;
  Seat seat{};
  seat.monitor.set_facts({.clock_ahead_ns = kAhead_ns});
  seat.show(scenes::recognition(6));
  seat.view.event_clock() = EventClock(EventClock::Stamps::of_window_system);
  const auto press = [&seat](std::uint64_t stamp_ms) {
    QKeyEvent event(QEvent::KeyPress, Qt::Key_1, Qt::NoModifier, "1");
    event.setTimestamp(stamp_ms);
    QApplication::sendEvent(&seat.view, &event);
    return seat.last().time_ns;
  };
  const std::int64_t before_ns = monotonic_now_ns();
  const std::int64_t prompt_ns = press(50'000);
  const std::int64_t after_ns = monotonic_now_ns();
  EXPECT_GE(prompt_ns, before_ns + kAhead_ns);
  EXPECT_LE(prompt_ns, after_ns + kAhead_ns);
  // Heard now, but its stamp is of 400 ms before the first.
  EXPECT_EQ(press(49'600), prompt_ns - 400'000'000);
}

TEST(ParticipantView, ShowsACueForAWhile) {
  ParticipantScene scene = scenes::recognition(6);
  scene.cue = "Please choose first.";
  scene.cue_number = 4;
  Seat seat(scene);
  seat.view.grab();
  EXPECT_TRUE(seat.view.drawn_texts().contains("Please choose first."));
  // The same cue in the next scene is not a new one, and its time goes on.
  scene.cue.clear();
  seat.show(scene);
  seat.view.grab();
  EXPECT_FALSE(seat.view.drawn_texts().contains("Please choose first."));
}

TEST(ParticipantView, DrawsTheAssignedLetterOnItsPicture) {
  ParticipantScene scene = scenes::matching(3);
  scene.choices[1].assigned_to = "C";
  Seat seat(scene);
  seat.view.grab();
  // Once on its chip, once on the picture.
  EXPECT_EQ(seat.view.drawn_texts().count("C"), 2);
  EXPECT_EQ(seat.view.drawn_texts().count("A"), 1);
}

TEST(ParticipantView, ShowsPicturesTogetherOnceAllAreThere) {
  ParticipantScene scene = scenes::recognition(3);
  Seat seat(scene);
  ASSERT_TRUE(eventually([&] {
    seat.view.grab();
    return seat.view.pictures_are_there();
  }));
  const QImage drawn = seat.view.grab().toImage();
  for (const Item& item : seat.view.items()) {
    if (item.kind != Item::Kind::picture) continue;
    const int number = item.key.toInt();
    const QPoint inside(static_cast<int>(item.rect.right() - item.side / 2.0),
                        static_cast<int>(item.rect.top() + item.side / 2.0));
    EXPECT_EQ(drawn.pixelColor(inside).rgb(), QColor::fromHsv(22 * number, 120, 160).rgb())
        << number;
  }
}

TEST(PictureShelf, ShowsColoursUnlessTheProtocolWantsGrey) {
  const QTemporaryDir study{};
  QImage red(8, 8, QImage::Format_RGB32);
  red.fill(qRgb(200, 20, 40));
  ASSERT_TRUE(red.save(study.filePath("red.png")));
  PictureShelf shelf(study.path().toStdString());
  const auto pixel = [&] {
    shelf.picture("red.png", 4);
    EXPECT_TRUE(eventually([&] { return !shelf.picture("red.png", 4).isNull(); }));
    return shelf.picture("red.png", 4).toImage().pixel(1, 1);
  };
  EXPECT_EQ(pixel(), qRgb(200, 20, 40));
  shelf.show_in_grey();
  const QRgb grey = pixel();
  EXPECT_EQ(qRed(grey), qBlue(grey));
  EXPECT_EQ(qRed(grey), qGreen(grey));
}

TEST(ParticipantView, SaysWhichPictureCannotBeReadAndShowsTheOthers) {
  Seat seat{};
  QStringList unreadable{};
  QObject::connect(&seat.view, &ParticipantView::remarked,
                   [&](const QString& kind, const QString& text) {
                     if (kind == "picture_unreadable") unreadable.append(text);
                   });
  ParticipantScene scene = scenes::recognition(3);
  scene.choices[1].picture = "pictures/none.png";
  seat.show(scene);
  ASSERT_TRUE(eventually([&] {
    seat.view.grab();
    return seat.view.pictures_are_there();
  }));
  EXPECT_EQ(unreadable, QStringList("pictures/none.png"));
}

TEST(ParticipantView, ShowsNoFileNames) {
  Seat seat{};
  for (const auto& [name, scene] : scenes::all()) {
    seat.show(scene);
    seat.view.grab();
    for (const QString& text : seat.view.drawn_texts()) {
      EXPECT_FALSE(text.contains("pictures/") || text.contains(".png")) << name;
    }
  }
}

// Their places are the same for all, so nothing tells a photograph by its shape.
TEST(ParticipantView, FillsTheSquaresOfVeryWideAndVeryTallPictures) {
  Seat seat(scenes::recognition(3));
  ASSERT_TRUE(eventually([&] {
    seat.view.grab();
    return seat.view.pictures_are_there();
  }));
  const QImage drawn = seat.view.grab().toImage();
  for (const Item& item : seat.view.items()) {
    if (item.kind != Item::Kind::picture) continue;
    const QRectF square(item.rect.right() - item.side, item.rect.top(), item.side, item.side);
    const QRgb color = QColor::fromHsv(22 * item.key.toInt(), 120, 160).rgb();
    for (const QPointF corner :
         {square.topLeft(), square.topRight(), square.bottomLeft(), square.bottomRight()}) {
      const QPointF inside = corner + 0.02 * (square.center() - corner);
      EXPECT_EQ(drawn.pixelColor(inside.toPoint()).rgb(), color) << item.key.toStdString();
    }
  }
}

TEST(ParticipantView, TakesItsSmallestLettersFromTheScreenThatItIsOn) {
  Seat seat{};
  const double px = smallest_text_px(measures_of(*seat.view.screen()));
  EXPECT_GT(px, 33.0);  // off screen a screen says that it has 100 pixels per inch
  seat.show(scenes::recognition(6));
  for (const Item& item : seat.view.items()) EXPECT_GE(item.size_px, px) << item.text.toStdString();
}

TEST(ParticipantView, TurnsThePagesOfALongTextAndContinuesFromTheLast) {
  ParticipantScene scene = scenes::to_read();
  scene.text = scenes::sentences(25);
  Seat seat(scene);
  const auto page = [&] {
    seat.view.grab();
    const QStringList pages = seat.view.drawn_texts().filter(QRegularExpression("^Page . of .$"));
    return pages.isEmpty() ? QString() : pages.first();
  };
  EXPECT_EQ(page(), "Page 1 of 3");
  seat.key(Qt::Key_Return);
  EXPECT_EQ(page(), "Page 2 of 3");
  seat.key(Qt::Key_Left);
  EXPECT_EQ(page(), "Page 1 of 3");
  seat.key(Qt::Key_PageUp);  // there is none before it
  EXPECT_EQ(page(), "Page 1 of 3");
  seat.key(Qt::Key_PageDown);
  seat.key(Qt::Key_Right);
  EXPECT_EQ(page(), "Page 3 of 3");
  seat.key(Qt::Key_Right);
  seat.key(Qt::Key_PageDown);
  EXPECT_EQ(page(), "Page 3 of 3");
  seat.click(Item::Kind::control, "Back");
  EXPECT_EQ(page(), "Page 2 of 3");
  seat.click(Item::Kind::control, "Continue");
  EXPECT_EQ(page(), "Page 3 of 3");
  EXPECT_TRUE(seat.inputs.empty());
  seat.key(Qt::Key_Return);
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().kind, Kind::confirm);
  // Another text begins at its beginning.
  scene.text = scenes::sentences(24);
  seat.show(scene);
  EXPECT_EQ(page(), "Page 1 of 3");
}

TEST(ParticipantView, TakesAnAnswerThatIsPressedWhileTheQuestionIsStillBeingRead) {
  ParticipantScene scene = scenes::recognition(6);
  scene.text = scenes::sentences(6);
  Seat seat(scene);
  const auto pictures = [&] {
    const std::vector<Item> items = seat.view.items();
    return std::count_if(items.begin(), items.end(),
                         [](const Item& item) { return item.kind == Item::Kind::picture; });
  };
  EXPECT_EQ(pictures(), 0);
  seat.key(Qt::Key_4);
  ASSERT_EQ(seat.inputs.size(), 1U);
  EXPECT_EQ(seat.last().number, 4);
  scene.choices[3].chosen = true;
  seat.show(scene);
  EXPECT_EQ(pictures(), 6);
  seat.key(Qt::Key_Return);
  EXPECT_EQ(seat.last().kind, Kind::confirm);
  // So is what is typed: its place is shown at once.
  ParticipantScene text = scenes::form_text();
  text.text = scenes::sentences(16);
  seat.show(text);
  auto* field = seat.view.findChild<QPlainTextEdit*>("participant_text");
  EXPECT_FALSE(field->isVisible());
  seat.key(Qt::Key_X);
  EXPECT_TRUE(field->isVisible());
  EXPECT_EQ(field->toPlainText(), "x");
  QTest::keyClick(field, Qt::Key_PageUp);
  EXPECT_FALSE(field->isVisible());
  seat.key(Qt::Key_Y);
  EXPECT_EQ(field->toPlainText(), "xy");
}

TEST(ParticipantView, MirrorsThePageThatIsRead) {
  Seat seat{};
  ParticipantView mirror(seat.monitor, seat.pictures.path(), ParticipantView::Role::mirror);
  mirror.follow(seat.view);
  mirror.resize(683, 400);
  mirror.show();
  ParticipantScene scene = scenes::to_read();
  scene.text = scenes::sentences(25);
  seat.show(scene);
  seat.key(Qt::Key_Return);
  ASSERT_TRUE(eventually([&] {
    mirror.grab();
    return mirror.drawn_texts().contains("Page 2 of 3");
  }));
  seat.view.grab();
  EXPECT_EQ(seat.view.drawn_texts(), mirror.drawn_texts());
}

TEST(ParticipantView, LooksTheSameInItsMirrorAndTakesNothingThere) {
  Seat seat{};
  ParticipantView mirror(seat.monitor, seat.pictures.path(), ParticipantView::Role::mirror);
  std::vector<ParticipantInput> mirrored{};
  QObject::connect(&mirror, &ParticipantView::acted,
                   [&](const ParticipantInput& input) { mirrored.push_back(input); });
  mirror.follow(seat.view);
  mirror.resize(683, 400);
  mirror.show();
  seat.show(scenes::recognition(6));
  ASSERT_TRUE(eventually([&] { return mirror.scene().kind == ParticipantScene::Kind::question; }));
  const std::vector<Item> large = seat.view.items();
  const std::vector<Item> small = mirror.items();
  ASSERT_EQ(large.size(), small.size());
  for (std::size_t i = 0; i < large.size(); ++i) {
    EXPECT_EQ(large[i].text, small[i].text);
    EXPECT_NEAR(large[i].rect.left() / 2.0, small[i].rect.left(), 0.51);
    EXPECT_NEAR(large[i].rect.top() / 2.0 + 8.0, small[i].rect.top(), 0.51);  // centred
    EXPECT_NEAR(large[i].rect.width() / 2.0, small[i].rect.width(), 0.51);
  }
  seat.view.grab();
  mirror.grab();
  EXPECT_EQ(seat.view.drawn_texts(), mirror.drawn_texts());
  // What is begun is seen too.
  seat.show(scenes::form_number());
  seat.key(Qt::Key_4);
  ASSERT_TRUE(eventually([&] {
    mirror.grab();
    return mirror.drawn_texts().contains("How old are you, in years?");
  }));
  seat.view.grab();
  EXPECT_EQ(seat.view.drawn_texts(), mirror.drawn_texts());
  seat.show(scenes::form_text());
  QTest::keyClicks(seat.view.findChild<QPlainTextEdit*>("participant_text"), "rough");
  ASSERT_TRUE(eventually([&] {
    mirror.grab();
    return mirror.drawn_texts().contains("rough");
  }));
  EXPECT_TRUE(mirror.testAttribute(Qt::WA_TransparentForMouseEvents));
  EXPECT_EQ(mirror.focusPolicy(), Qt::NoFocus);
}

TEST(ParticipantView, GivesTheWorkspaceItsPlaceWhileASurfaceIsFelt) {
  Seat seat{};
  auto* workspace = new QWidget();
  seat.view.set_workspace(workspace);
  ParticipantScene scene = scenes::feel(3);
  scene.show_workspace = true;
  seat.show(scene);
  EXPECT_TRUE(workspace->isVisible());
  EXPECT_GT(workspace->width(), 800);
  EXPECT_TRUE(seat.view.rect().contains(workspace->geometry()));
  seat.show(scenes::selection(3));
  EXPECT_FALSE(workspace->isVisible());
}

// --- what guides the hand ---

/// What the guide shows of a hand that does this.
QImage guide_with(Seat& seat, double pressing_N, std::optional<double> speed_m_per_s) {
  LiveBin bin{};
  bin.touching = true;
  bin.is_felt = true;
  bin.pressing_N = pressing_N;
  bin.stroking_m_per_s = speed_m_per_s;
  seat.monitor.add_bin(bin);
  auto* guide = seat.view.findChild<LiveGuide*>();
  EXPECT_TRUE(eventually([&] {
    return guide->shown().pressing_N == pressing_N &&
           guide->shown().stroking_m_per_s == speed_m_per_s;
  }));
  return guide->grab().toImage();
}

int pixels_of(const QImage& image, const QColor& color, const QRect& where) {
  int count = 0;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) {
      if (image.pixelColor(x, y) == color) ++count;
    }
  }
  return count;
}

TEST(ParticipantView, MarksTheHandInsideAndOutsideOfItsBands) {
  Seat seat(scenes::guided(Exploration::Guidance::bars));
  const auto* guide = seat.view.findChild<LiveGuide*>();
  ASSERT_TRUE(guide->isVisible());
  EXPECT_TRUE(seat.view.rect().contains(guide->geometry()));
  const QColor outside("#D55E00");
  QImage seen = guide_with(seat, 0.9, 0.09);  // the force in its band, too fast
  QRect force = seen.rect();
  force.setBottom(seen.height() / 2 - 1);
  QRect speed = seen.rect();
  speed.setTop(seen.height() / 2);
  EXPECT_EQ(pixels_of(seen, outside, force), 0);
  EXPECT_GT(pixels_of(seen, outside, speed), 200);
  seen = guide_with(seat, 1.5, 0.054);
  EXPECT_GT(pixels_of(seen, outside, force), 200);
  EXPECT_EQ(pixels_of(seen, outside, speed), 0);
  // Too much stands on the right of the band, too little on its left.
  const QRect left(0, 0, seen.width() / 3, seen.height() / 2);
  EXPECT_EQ(pixels_of(seen, outside, left), 0);
  EXPECT_GT(pixels_of(guide_with(seat, 0.3, 0.054), outside, left), 200);
  // A hand that has not stroked far enough yet is not asked for speed; one that rests is.
  EXPECT_EQ(pixels_of(guide_with(seat, 0.9, {}), outside, seen.rect()), 0);
  EXPECT_GT(pixels_of(guide_with(seat, 0.9, 0.0), outside, speed), 200);
}

/// From its left to its right edge, in pixels.
std::pair<int, int> band_in(const QImage& image) {
  const QColor ground("#BFDDF2");
  std::pair<int, int> edges{image.width(), 0};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixelColor(x, y) != ground) continue;
      edges.first = std::min(edges.first, x);
      edges.second = std::max(edges.second, x);
    }
  }
  return edges;
}

TEST(ParticipantView, ShowsTheBandsOfAllExplorationsOnOneScale) {
  Protocol protocol{};
  std::vector<ParticipantScene> pressed{};
  for (const double force_N : {0.5, 1.0, 2.0}) {
    ParticipantScene scene = scenes::guided(Exploration::Guidance::bars);
    scene.guide->speed_m_per_s = {};
    scene.guide->normal_force_N = {
        .minimum = 0.7 * force_N, .target = force_N, .maximum = 1.3 * force_N};
    protocol.explorations[std::to_string(pressed.size())] = *scene.guide;
    pressed.push_back(scene);
  }
  // The experimenter's alone: no bar shows it, and none makes room for it.
  Exploration unseen = *pressed.front().guide;
  unseen.guidance = Exploration::Guidance::experimenter;
  unseen.normal_force_N.maximum = 40.0;
  protocol.explorations["unseen"] = unseen;
  EXPECT_DOUBLE_EQ(guide_scale_of(protocol).force_N, 1.25 * 2.6);
  EXPECT_DOUBLE_EQ(guide_scale_of(protocol).speed_m_per_s, 0.0);

  Seat seat{};
  auto* guide = seat.view.findChild<LiveGuide*>();
  std::vector<std::pair<int, int>> bands{};
  for (ParticipantScene& scene : pressed) {
    scene.guide_scale = guide_scale_of(protocol);
    seat.show(scene);
    const double asked_N = *scene.guide->normal_force_N.target;
    LiveBin bin{};
    bin.is_felt = true;
    bin.pressing_N = asked_N;
    seat.monitor.add_bin(bin);
    ASSERT_TRUE(eventually([&] { return guide->shown().pressing_N == asked_N; }));
    bands.push_back(band_in(guide->grab().toImage()));
  }
  EXPECT_GT(bands[1].first, bands[0].second) << "1 N is asked for beyond where 0.5 N was";
  EXPECT_GT(bands[2].first, bands[1].second);
  const auto width = [](const std::pair<int, int>& band) { return band.second - band.first; };
  EXPECT_NEAR(static_cast<double>(width(bands[2])) / width(bands[0]), 4.0, 0.3);
}

TEST(ParticipantView, PutsRoundNumbersUnderItsBars) {
  EXPECT_EQ(guide_ticks(3.25), (std::vector<double>{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(guide_ticks(162.5), (std::vector<double>{0.0, 50.0, 100.0, 150.0}));
  EXPECT_EQ(guide_ticks(0.5).size(), 6U);
  EXPECT_TRUE(guide_ticks(0.0).empty());
  Seat seat(scenes::guided(Exploration::Guidance::bars));
  const auto names = [&seat] {
    QStringList texts{};
    for (const Item& item : seat.view.items()) texts.push_back(item.text);
    return texts;
  };
  EXPECT_TRUE(names().contains("Force, N"));
  EXPECT_TRUE(names().contains("Speed, mm/s"));
}

/// The guide of a scene in this language, in windows of that one.
QImage guide_in(const std::string& language, const char* of_windows) {
  QLocale::setDefault(QLocale(of_windows));
  ParticipantScene scene = scenes::guided(Exploration::Guidance::bars);
  scene.language = language;
  scene.guide->normal_force_N = {.minimum = 0.3, .target = 0.4, .maximum = 0.5};
  scene.guide_scale = {};
  Seat seat(scene);
  const QImage guide = guide_with(seat, 0.4, {});
  QLocale::setDefault(QLocale("en"));
  return guide;
}

TEST(ParticipantView, WritesTheNumbersUnderItsBarsInTheLanguageOfTheProtocol) {
  const QImage english = guide_in("en", "en");
  EXPECT_EQ(guide_in("en", "de"), english);
  const QImage german = guide_in("de", "en");
  EXPECT_NE(german, english) << "0,1 instead of 0.1";
  EXPECT_EQ(guide_in("de", "de"), german);
}

TEST(ParticipantView, AsksAHandThatIsToLiftForNothing) {
  ParticipantScene scene = scenes::guided(Exploration::Guidance::bars);
  Seat seat(scene);
  const QColor outside("#D55E00");
  const QImage pressed_little = guide_with(seat, 0.3, 0.01);
  EXPECT_GT(pixels_of(pressed_little, outside, pressed_little.rect()), 200);
  scene.text_saying = {.what = Saying::What::lift, .code = "B"};
  seat.show(scene);
  auto* guide = seat.view.findChild<LiveGuide*>();
  EXPECT_TRUE(eventually([&] { return !guide->shown().pressing_N; }));
  EXPECT_FALSE(guide->shown().stroking_m_per_s);
  EXPECT_EQ(pixels_of(guide->grab().toImage(), outside, pressed_little.rect()), 0);
}

TEST(ParticipantView, LeadsTheHandByATargetUntilItIsToLift) {
  // 60 mm at 40 mm/s: forth in 1.5 s and back in as many.
  EXPECT_NEAR(target_along_m(0.0, 0.06, 0.04), -0.03, 1e-12);
  EXPECT_NEAR(target_along_m(0.75, 0.06, 0.04), 0.0, 1e-12);
  EXPECT_NEAR(target_along_m(1.5, 0.06, 0.04), 0.03, 1e-12);
  EXPECT_NEAR(target_along_m(2.0, 0.06, 0.04), 0.01, 1e-12);
  EXPECT_NEAR(target_along_m(3.75, 0.06, 0.04), 0.0, 1e-12);

  ParticipantScene scene = scenes::guided(Exploration::Guidance::moving_target);
  scene.shown_ns = monotonic_now_ns();
  Seat seat(scene);
  const auto* guide = seat.view.findChild<LiveGuide*>();
  ASSERT_TRUE(guide->isVisible());
  const std::optional<double> before = guide->shown().target_along_m;
  ASSERT_TRUE(before);
  EXPECT_LE(std::abs(*before), 0.03);
  EXPECT_TRUE(eventually([&] { return guide->shown().target_along_m != before; }));
  scene.text_saying = {.what = Saying::What::lift, .code = "B"};
  seat.show(scene);
  EXPECT_TRUE(eventually([&] { return !guide->shown().target_along_m; }));
}

TEST(ParticipantView, ShowsNothingOfTheHandWhereTheProtocolDoesNotSaySo) {
  Seat seat{};
  const auto* guide = seat.view.findChild<LiveGuide*>();
  seat.show(scenes::feel(3));
  EXPECT_FALSE(guide->isVisible());
  seat.show(scenes::guided(Exploration::Guidance::bars));
  EXPECT_TRUE(guide->isVisible());
  seat.show(scenes::selection(3));
  EXPECT_FALSE(guide->isVisible());
}

}  // namespace
}  // namespace asperity
