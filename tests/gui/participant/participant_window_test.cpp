#include "app/gui/participant/participant_window.h"

#include <QtCore/QFile>
#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtCore/QTimer>
#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "app/gui/look/controls.h"
#include "tests/gui/participant/scenes.h"

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
  ASSERT_TRUE(QTest::qWaitFor([&] { return thanks->isActive(); }));
  EXPECT_EQ(thanks->interval(), 10'000);
  thanks->start(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return closed.count() == 1; }));
  EXPECT_FALSE(window.isVisible());
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
