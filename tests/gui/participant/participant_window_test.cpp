// The participant's window on one and on two screens, its colours and its end.

#include "app/gui/participant/participant_window.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QFile>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "app/gui/participant/pages/participant_brush.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

TEST(ParticipantWindow, CannotBeClosedByAnybodyButItsOwner) {
  SessionMonitor monitor{};
  ParticipantWindow window(monitor, {});
  EXPECT_TRUE(window.windowFlags() & Qt::FramelessWindowHint);
  window.show();
  EXPECT_FALSE(window.close());
  EXPECT_TRUE(window.isVisible());
  QSignalSpy closed(&window, &ParticipantWindow::closed);
  window.allow_close();
  EXPECT_TRUE(window.close());
  EXPECT_EQ(closed.count(), 1);
}

TEST(ParticipantWindow, StandsOnTheRightHalfOfTheOnlyScreen) {
  SessionMonitor monitor{};
  ParticipantWindow window(monitor, {});
  const QScreen& screen = *QGuiApplication::primaryScreen();
  window.open_on(screen.name());
  EXPECT_FALSE(window.is_full_screen());
  const QRect room = screen.availableGeometry();
  EXPECT_EQ(window.geometry().left(), room.left() + room.width() / 2);
  EXPECT_EQ(window.geometry().right(), room.right());
}

TEST(ParticipantWindow, SaysWhenTheScreenThatWasChosenIsNotThere) {
  SessionMonitor monitor{};
  ParticipantWindow window(monitor, {});
  QSignalSpy lost(&window, &ParticipantWindow::screen_lost);
  window.open_on("");
  EXPECT_EQ(lost.count(), 0);
  window.open_on("DP-7");
  ASSERT_EQ(lost.count(), 1);
  EXPECT_EQ(lost.first().first().toString(), "DP-7");
  EXPECT_TRUE(window.isVisible());
}

TEST(ParticipantWindow, SaysWhenItsScreenIsGoneAndStaysVisible) {
  SessionMonitor monitor{};
  ParticipantWindow window(monitor, {});
  QScreen* screen = QGuiApplication::primaryScreen();
  window.open_on(screen->name());
  QSignalSpy lost(&window, &ParticipantWindow::screen_lost);
  emit qGuiApp->screenRemoved(screen);
  ASSERT_EQ(lost.count(), 1);
  EXPECT_EQ(lost.first().first().toString(), screen->name());
  EXPECT_TRUE(window.isVisible());
  EXPECT_FALSE(window.is_full_screen());
}

// A screen more than there is off screen: in a program of its own.
TEST(ParticipantWindow, CoversTheSecondScreenAndLeavesItWhenItIsUnplugged) {
  if (QGuiApplication::screens().size() < 2) {
    QTemporaryDir folder{};
    QFile screens(folder.filePath("screens.json"));
    ASSERT_TRUE(screens.open(QIODevice::WriteOnly));
    screens.write(R"({"screens": [
        {"name": "left", "x": 0, "y": 0, "width": 1366, "height": 768},
        {"name": "right", "x": 1366, "y": 0, "width": 1920, "height": 1080}]})");
    screens.close();
    QProcess program{};
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("QT_QPA_PLATFORM", "offscreen:configfile=" + screens.fileName());
    environment.remove("GTEST_OUTPUT");
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::MergedChannels);
    program.start(
        QCoreApplication::applicationFilePath(),
        {"--gtest_filter=ParticipantWindow.CoversTheSecondScreenAndLeavesItWhenItIsUnplugged"});
    ASSERT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitCode(), 0) << program.readAll().toStdString();
    return;
  }
  SessionMonitor monitor{};
  ParticipantWindow window(monitor, {});
  window.open_on("right");
  EXPECT_TRUE(window.is_full_screen());
  EXPECT_EQ(window.geometry(), QRect(1366, 0, 1920, 1080));
  emit qGuiApp->screenRemoved(QGuiApplication::screens().last());
  EXPECT_FALSE(window.is_full_screen());
  EXPECT_EQ(window.geometry().left(), 683);
}

TEST(ParticipantWindow, ClosesByItselfAfterTheThanks) {
  SessionMonitor monitor{};
  ParticipantWindow window(monitor, {});
  window.show();
  QSignalSpy closed(&window, &ParticipantWindow::closed);
  auto* thanks = window.findChild<QTimer*>("thanks");
  EXPECT_FALSE(thanks->isActive());
  ParticipantScene ended{};
  ended.kind = ParticipantScene::Kind::ended;
  monitor.show(ended);
  ASSERT_TRUE(eventually([&] { return thanks->isActive(); }));
  EXPECT_EQ(thanks->interval(), 10'000);
  thanks->start(1);
  ASSERT_TRUE(eventually([&] { return closed.count() == 1; }));
  EXPECT_FALSE(window.isVisible());
}

TEST(ParticipantWindow, OpensNoDialogAndStaysWhateverIsShownAndPressed) {
  SessionMonitor monitor{};
  const scenes::PictureFolder pictures{};
  ParticipantWindow window(monitor, pictures.path());
  window.show();
  const qsizetype windows = QApplication::topLevelWidgets().size();
  for (const auto& [name, scene] : scenes::all()) {
    monitor.show(scene);
    const auto shown = monitor.snapshot().scene;
    ASSERT_TRUE(eventually([&] { return &window.view().scene() == shown.get(); }));
    for (const Qt::Key key : {Qt::Key_Escape, Qt::Key_F1, Qt::Key_Menu, Qt::Key_Return}) {
      QTest::keyClick(&window.view(), key);
    }
    QTest::keyClick(&window.view(), Qt::Key_F4, Qt::AltModifier);
    QTest::keyClick(&window.view(), Qt::Key_Q, Qt::ControlModifier);
    QTest::mouseClick(&window.view(), Qt::RightButton, {}, QPoint(40, 40));
    EXPECT_TRUE(window.isVisible()) << name;
    EXPECT_EQ(QApplication::topLevelWidgets().size(), windows) << name;
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr) << name;
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr) << name;
  }
}

// Of luminances as WCAG 2 defines them: 7 : 1 is what it asks of text for people who see badly.
TEST(ParticipantColors, KeepEveryTextSevenTimesAsLightOrDarkAsItsGround) {
  const auto luminance = [](const QColor& color) {
    const auto linear = [](double part) {
      return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
           0.0722 * linear(color.blueF());
  };
  const auto contrast = [&](const QColor& one, const QColor& other) {
    const double a = luminance(one) + 0.05;
    const double b = luminance(other) + 0.05;
    return std::max(a, b) / std::min(a, b);
  };
  const ParticipantColors colors{};
  for (const QColor& ground : {colors.ground, colors.panel, colors.cue_ground}) {
    EXPECT_GE(contrast(colors.text, ground), 7.0) << ground.name().toStdString();
  }
  EXPECT_GE(contrast(colors.muted, colors.ground), 7.0);
  EXPECT_GE(contrast(colors.on_press, colors.press), 7.0);
}

TEST(ParticipantWindow, CarriesTheBandOfAPilot) {
  SessionMonitor monitor{};
  SessionFacts facts{};
  facts.row.mode = SessionMode::pilot;
  monitor.set_facts(facts);
  ParticipantWindow window(monitor, {});
  window.resize(800, 600);
  window.show();
  const auto* band = window.findChild<ModeBand*>();
  EXPECT_TRUE(band->isVisible());
  EXPECT_EQ(band->geometry().top(), 0);
}

TEST(ParticipantWindow, CarriesNoBandInARun) {
  SessionMonitor monitor{};
  monitor.set_facts({});
  ParticipantWindow window(monitor, {});
  window.show();
  EXPECT_FALSE(window.findChild<ModeBand*>()->isVisible());
}

}  // namespace
}  // namespace asperity
