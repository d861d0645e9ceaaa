// Answers by mouse, keys and dragging in the participant's view, and what it shows.

#include "app/gui/participant/participant_view.h"

#include <QtCore/QRegularExpression>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QPlainTextEdit>
#include <gtest/gtest.h>

#include "app/gui/participant/picture_shelf.h"
#include "app/gui/participant/type_size.h"
#include "device/monotonic_clock.h"
#include "tests/gui/participant/participant_seat.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

using Item = ParticipantItem;
using Kind = ParticipantInput::Kind;

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

}  // namespace
}  // namespace asperity
