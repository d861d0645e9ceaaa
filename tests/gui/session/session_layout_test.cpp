// The parts of the experimenter's window, their sizes, and the screens.

#include <algorithm>
#include <iostream>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QApplication>
#include <QtWidgets/QDialog>
#include <QtWidgets/QLayout>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTableView>
#include <gtest/gtest.h>

#include "app/gui/base/settings.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/fitted_label.h"
#include "app/gui/look/theme.h"
#include "app/gui/session/session_dialogs.h"
#include "tests/gui/session/clipped.h"
#include "tests/gui/session/filled_monitor.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

// A screen of 1280 × 720, of which a frame takes some.
TEST(SessionWindow, HasRoomForPlanPlotsAndPhrasesOnASmallScreen) {
  for (const QSize size : {QSize(1270, 688), QSize(1180, 688), QSize(1180, 800)}) {
    FilledMonitor session{};
    session.answer_up_to(16);
    session.set_phase(SessionPhase::contact);
    const auto window = session.window();
    window->resize(size);
    window->show();
    const std::string at = std::to_string(size.width()) + " × " + std::to_string(size.height());
    EXPECT_TRUE(eventually([&] { return clipped_in(*window).isEmpty(); }))
        << at << clipped_in(*window).join("\n").toStdString();
    const auto& plan = child<QTableView>(*window, "plan");
    EXPECT_GE(plan.viewport()->height(), 5 * plan.rowHeight(1)) << at;
    if (auto* show_notes = window->findChild<QPushButton*>("show_notes");
        show_notes != nullptr && show_notes->isVisible()) {
      show_notes->click();
    }
    const auto& notes = child<QWidget>(*window, "notes");
    const int top = notes.mapTo(window.get(), QPoint(0, 0)).y();
    for (const QPushButton* phrase : window->findChildren<QPushButton*>("phrase")) {
      if (!phrase->isVisible()) continue;
      EXPECT_LE(phrase->mapTo(window.get(), QPoint(0, phrase->height())).y(), top) << at;
    }
  }
}

// The screen of the tests has 800 points, of which Qt gives a dialog two thirds.
TEST(SessionDialogs, HaveRoomForTheirGermanWordsOnASmallScreen) {
  apply_language("de");
  AbortDialog aborting(nullptr, [](const Phrase&) {});
  CloseDialog closing(nullptr, [](Leaving) {});
  apply_language("en");
  for (QDialog* const dialog :
       {static_cast<QDialog*>(&aborting), static_cast<QDialog*>(&closing)}) {
    dialog->setAttribute(Qt::WA_DeleteOnClose, false);
    dialog->show();
    EXPECT_TRUE(eventually([&] { return clipped_in(*dialog).isEmpty(); }))
        << clipped_in(*dialog).join("\n").toStdString();
    EXPECT_GE(dialog->height(), dialog->layout()->totalHeightForWidth(dialog->width()));
  }
}

/// What somebody sees of the parts of the window, by its name.
QStringList parts_shown(const QWidget& window) {
  QStringList shown{};
  for (const char* const name : {"plan", "force_plot", "last_answer", "note", "show_plan"}) {
    if (child<QWidget>(window, name).isVisible()) shown += name;
  }
  return shown;
}

TEST(SessionWindow, ShowsItsPartsSideBySideOrOneAtATimeAsItsSizeAllows) {
  FilledMonitor session{};
  session.answer_up_to(16);
  const auto window = session.window();
  const QStringList all{"plan", "force_plot", "last_answer", "note"};
  for (const QSize size : {QSize(1366, 700), QSize(960, 1016), QSize(960, 700), QSize(683, 700),
                           QSize(960, 1016), QSize(1366, 700), QSize(683, 700)}) {
    window->resize(size);
    const bool narrow = size.width() < 840 || (size.width() < 1264 && size.height() < 780);
    EXPECT_EQ(parts_shown(*window), narrow ? (QStringList{"plan", "show_plan"}) : all)
        << size.width() << " × " << size.height();
  }
  // By mouse, and by Tab and Space.
  QTest::mouseClick(&child<QPushButton>(*window, "show_plots"), Qt::LeftButton);
  EXPECT_EQ(parts_shown(*window), (QStringList{"force_plot", "show_plan"}));
  EXPECT_FALSE(child<QPushButton>(*window, "show_plots").hasFocus())
      << "it would hear the participant's Space";
  auto& notes = child<QPushButton>(*window, "show_notes");
  for (int i = 0; i < 30 && !notes.hasFocus(); ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  ASSERT_TRUE(notes.hasFocus());
  QTest::keyClick(&notes, Qt::Key_Space);
  EXPECT_EQ(parts_shown(*window), (QStringList{"last_answer", "note", "show_plan"}));
  EXPECT_TRUE(eventually([&] { return clipped_in(*window).isEmpty(); }))
      << clipped_in(*window).join("\n").toStdString();
}

TEST(SessionWindow, KeepsItsSizeWhateverStandsInIt) {
  FilledMonitor session{};
  session.answer_up_to(4);
  const auto window = session.window();
  for (const QSize size : {QSize(1366, 704), QSize(960, 1016), QSize(683, 700)}) {
    window->resize(size);
    session.requests.pause();
    session.requests.stop_after(StopAfter::block);
    session.set_phase(SessionPhase::paused);
    session.monitor.update([](SessionSnapshot& s) {
      s.health.missed_deadlines = 1'234'567;
      s.health.lost_records = 7'654'321;
      s.health.lateness_p99_s = 1.0;
      s.rows_stored = 1'000'000;
      s.trouble = SessionTrouble{.what = std::string(400, 'm') + " " + std::string(60, 'm'),
                                 .time_ns = s.now_ns};
    });
    window->refresh();
    window->tell_screen_lost(QString(80, 'W'), ScreenLoss::force_stopped);
    child<QPushButton>(*window, "skip").click();
    QTest::qWait(0);
    EXPECT_EQ(window->size(), size);
    EXPECT_TRUE(window->rect().contains(child<QPushButton>(*window, "emergency_stop").geometry()));
    session.requests.go_on();
  }
  EXPECT_LE(window->minimumWidth(), 683);
  EXPECT_LE(window->minimumHeight(), 700);
}

TEST(SessionWindow, BringsTheParticipantsWindowBackByButtonAndKeyWhereThereIsOne) {
  FilledMonitor session{};
  session.answer_up_to(4);
  const auto window = session.window();
  auto& button = child<QPushButton>(*window, "their_window");
  EXPECT_FALSE(button.isVisible()) << "a virtual participant has none";
  window->set_participant_window(true);
  for (const int width : {1366, 960, 683}) {
    window->resize(width, 700);
    ASSERT_TRUE(button.isVisible());
    QSignalSpy wanted(window.get(), &SessionWindow::participant_window_wanted);
    QTest::mouseClick(&button, Qt::LeftButton);
    QTest::keyClick(window.get(), Qt::Key_F9);
    EXPECT_EQ(wanted.count(), 2) << width;
    EXPECT_EQ(button.focusPolicy(), Qt::TabFocus);
  }
}

TEST(SessionWindow, SaysTheWholeOfALineInItsToolTipWhereItIsCut) {
  FittedLabel label{};
  label.show_state(State::look, "Stopping after this trial");
  label.show();
  label.resize(label.sizeHint());
  EXPECT_FALSE(label.is_cut());
  EXPECT_EQ(label.toolTip(), "");
  label.resize(label.width() - 2, label.height());
  EXPECT_TRUE(label.is_cut());
  EXPECT_EQ(label.toolTip(), "Stopping after this trial");
  label.set_smaller_font(text_font(TextSize::small));
  EXPECT_FALSE(label.is_cut());
  EXPECT_EQ(label.minimumSizeHint().width(), 0);
}

TEST(SessionWindow, SaysWhatWasDoneForALostScreenAndTakesTheWindowBack) {
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  auto& news = child<Banner>(*window, "news");
  window->tell_screen_lost("HDMI-1", ScreenLoss::force_stopped);
  EXPECT_TRUE(news.text().contains("“HDMI-1” was disconnected")) << news.text().toStdString();
  EXPECT_TRUE(news.text().contains("the force is zero"));
  window->tell_screen_lost("HDMI-1", ScreenLoss::pausing);
  EXPECT_TRUE(news.text().contains("the session pauses"));
  const auto buttons = news.findChildren<QPushButton*>();
  const auto back = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text() == "Restore window";
  });
  ASSERT_NE(back, buttons.end());
  QSignalSpy wanted(window.get(), &SessionWindow::participant_screen_back);
  QTest::mouseClick(*back, Qt::LeftButton);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted.first().first().toString(), "HDMI-1");
}

TEST(SessionWindow, SaysThatAScreenWasUnpluggedAndOffersAPause) {
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  auto& banner = child<QWidget>(*window, "news");
  ASSERT_TRUE(banner.isVisible());
  const auto buttons = banner.findChildren<QPushButton*>();
  const auto pause = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text() == "Pause";
  });
  ASSERT_NE(pause, buttons.end());
  (*pause)->click();
  EXPECT_TRUE(session.requests.pending().pause);
}

TEST(SessionWindow, MovesItselfToAScreenThatIsThere) {
  FilledMonitor session{};
  session.answer_up_to(2);
  const auto window = session.window();
  window->move(20000, 20000);
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  EXPECT_TRUE(eventually(
      [&] { return QGuiApplication::screenAt(window->frameGeometry().center()) != nullptr; }));
}

TEST(SessionWindow, FitsTheSmallestScreenWithoutScrollingWhateverIsOpen) {
  FilledMonitor session("chapter_matching", SessionMode::pilot);
  session.answer_up_to(1);
  session.set_phase(SessionPhase::contact);
  session.monitor.update([](SessionSnapshot& s) {
    s.trouble = SessionTrouble{.what = "The disk is nearly full.", .time_ns = s.now_ns};
  });
  const auto window = session.window();
  child<QPushButton>(*window, "skip").click();
  QTest::qWait(1);
  EXPECT_LE(window->minimumSizeHint().width(), 1366);
  EXPECT_LE(window->minimumSizeHint().height(), 768);
  std::cout << "smallest size: " << window->minimumSizeHint().width() << " × "
            << window->minimumSizeHint().height() << '\n';
}

}  // namespace
}  // namespace asperity
