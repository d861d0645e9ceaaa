// The participants and sessions of a study, and the trials of a session.

#include <cstdint>
#include <filesystem>

#include <QtCore/QRegularExpression>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTabWidget>

#include "app/gui/base/open_study.h"
#include "app/gui/base/study_table.h"
#include "app/gui/data/attempt_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/study/trials_page.h"
#include "app/gui/window/study_window.h"
#include "results_schema/study.h"
#include "tests/gui/study/pages_of_a_window.h"
#include "tests/gui/support/screenshot.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

// A simulated clock begins in 2026 whatever the calendar says.
TEST_F(PagesToRead, ShowNoDateOfASimulatedClock) {
  StudyTable& sessions = table_of("sessions", "sessions_table", 15);
  EXPECT_EQ(column(sessions, 5).filter("simulated clock").size(), 2);
  EXPECT_TRUE(column(sessions, 5).filter("2026-03-03").isEmpty());
  EXPECT_EQ(sessions.text_at(14, 5), "simulated clock") << "sorted as the latest of all";
  child<QLineEdit>(window_, "sessions_filter").setText("virtual0001");
  ASSERT_TRUE(eventually([&] { return sessions.shown_rows() == 1; }));
  sessions.selectRow(0);
  click("sessions_open");
  const auto& summary = child<QLabel>(window_, "trials_summary");
  ASSERT_TRUE(eventually([&] { return summary.text().contains("on a simulated clock"); }));
  EXPECT_FALSE(summary.text().contains("2026-03-03"));

  window_.show_page("participants");
  click("participants_virtual");
  const StudyTable& people = table_of("participants", "participants_table", 2);
  EXPECT_EQ(people.text_at(0, 6), "simulated clock");
  select_protocol("chapter_selection.json");
  EXPECT_TRUE(child<QLabel>(window_, "protocol_last_run").text().contains("P002"))
      << "a made-up date counts as later than the pilot's";
}

TEST_F(StudyPages, TellNothingOfTheTrialsOfABlindSessionThatRuns) {
  const std::filesystem::path folder = lively_study();
  const StudyLock running(folder, Study::session_lock_name("P012"));
  {
    Study study = Study::open(folder, Access::read_write);
    for (const SessionRow& session : study.sessions()) {
      if (session.participant == "P012") study.reopen_session(session.id);
    }
  }
  ASSERT_TRUE(window_.open_study(folder));
  StudyTable& table = table_of("sessions", "sessions_table", 15);
  child<QLineEdit>(window_, "sessions_filter").setText("P012");
  table.setFocus();
  table.selectRow(0);
  EXPECT_EQ(table.text_at(0, 4), "· running now");
  EXPECT_FALSE(child<QPushButton>(window_, "sessions_open").isEnabled());
  QTest::keyClick(&table, Qt::Key_Return);
  EXPECT_EQ(window_.shown_page(), "sessions");
}

TEST_F(PagesToRead, LeaveRoomForTheProtocolOfASession) {
  const StudyTable& table = table_of("sessions", "sessions_table", 15);
  const int wanted = QFontMetrics(table.font()).horizontalAdvance("chapter_recognition 1.1.0");
  for (const int width : {1180, 1264, 1366, 1920}) {
    window_.resize(width, 768);
    QCoreApplication::processEvents();
    QStringList widths{};
    for (int each = 0; each < 9; ++each) widths << QString::number(table.columnWidth(each));
    EXPECT_GT(table.columnWidth(2), wanted) << width << ": " << widths.join(' ').toStdString();
  }
}

TEST_F(PagesToRead, KeepVirtualParticipantsApart) {
  StudyTable& table = table_of("participants", "participants_table", 12);
  EXPECT_EQ(child<QPushButton>(window_, "participants_people").text(), "Human 12");
  click("participants_virtual");
  EXPECT_EQ(table.shown_rows(), 2);
  EXPECT_EQ(table.text_at(0, 0), "virtual0001");
  EXPECT_EQ(child<QLabel>(window_, "participants_next_label").text(),
            "Next suggested participant label: P013.");
}

TEST_F(PagesToRead, SortNumbersByTheirValue) {
  StudyTable& table = table_of("sessions", "sessions_table", 15);
  table.sortByColumn(7, Qt::AscendingOrder);  // as texts, "12 of 12" is before "3 of 12"
  EXPECT_EQ(table.text_at(0, 7), "3 of 12");
  EXPECT_EQ(table.text_at(1, 7), "7 of 12");
  EXPECT_EQ(table.text_at(14, 7), "12 of 12");
}

TEST_F(PagesToRead, FilterSessionsByEveryWord) {
  const StudyTable& table = table_of("sessions", "sessions_table", 15);
  QTest::keyClicks(&child<QLineEdit>(window_, "sessions_filter"), "p002 pilot");
  ASSERT_EQ(table.shown_rows(), 1);
  EXPECT_EQ(table.text_at(0, 3), "Pilot");
}

TEST_F(PagesToRead, GoOnWithAnUnfinishedSessionOnly) {
  StudyTable& table = table_of("sessions", "sessions_table", 15);
  auto& resume = child<QPushButton>(window_, "sessions_resume");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  child<QLineEdit>(window_, "sessions_filter").setText("P011");  // complete
  table.selectRow(0);
  EXPECT_FALSE(resume.isEnabled());
  child<QLineEdit>(window_, "sessions_filter").setText("P004");
  table.selectRow(0);
  ASSERT_TRUE(resume.isEnabled());
  EXPECT_EQ(child<QLabel>(window_, "sessions_reason").text(),
            "Trials completed and stored: 7 of 12.");
  click("sessions_resume");
  ASSERT_EQ(wanted.count(), 1);
  const auto wish = wanted[0][0].value<SessionWish>();
  EXPECT_TRUE(wish.session);
  EXPECT_EQ(wish.participant, "P004");
  EXPECT_EQ(wish.protocol.filename(), "chapter_recognition.json");
}

TEST_F(StudyPages, CallTrialsOfACompleteSessionWithoutAttemptNotNeeded) {
  const TemporaryFolder folder{};
  copy(lively_study(), folder.path(), std::filesystem::copy_options::recursive);
  {
    // P004, who was stopped after 7 of 12 trials, as if a criterion had been reached.
    Study study = Study::open(folder.path(), Access::read_write);
    for (const SessionRow& session : study.sessions()) {
      if (session.participant != "P004") continue;
      study.reopen_session(session.id);
      study.end_session(session.id, SessionState::completed, "2026-03-02T10:00:00Z");
    }
  }
  ASSERT_TRUE(window_.open_study(folder.path()));
  StudyTable& table = table_of("sessions", "sessions_table", 15);
  child<QLineEdit>(window_, "sessions_filter").setText("P004");
  table.selectRow(0);
  EXPECT_EQ(table.text_at(0, 7), "7");
  EXPECT_TRUE(
      child<QLabel>(window_, "sessions_reason")
          .text()
          .startsWith(
              "Trials completed and stored: 7. Further trials in the plan: 5, not needed,"));
  table.setFocus();
  QTest::keyClick(&table, Qt::Key_Return);
  const auto& trials = child<StudyTable>(window_, "trials_table");
  ASSERT_TRUE(eventually([&] { return trials.shown_rows() == 12; }));
  EXPECT_TRUE(child<QLabel>(window_, "trials_summary").text().contains("trials: 7 (5 not needed)"))
      << child<QLabel>(window_, "trials_summary").text().toStdString();
  EXPECT_EQ(trials.text_at(6, 4), "answered");
  EXPECT_EQ(trials.text_at(7, 4), "not needed");
}

TEST_F(PagesToRead, OpenTheTrialsOfASessionWithItsNotes) {
  StudyTable& table = table_of("sessions", "sessions_table", 15);
  child<QLineEdit>(window_, "sessions_filter").setText("P004");
  table.setFocus();
  table.selectRow(0);
  QTest::keyClick(&table, Qt::Key_Return);
  EXPECT_EQ(window_.shown_page(), "trials");
  const auto& trials = child<StudyTable>(window_, "trials_table");
  ASSERT_TRUE(eventually(
      [&] { return child<QLabel>(window_, "trials_summary").text().contains("7 of 12"); }));
  ASSERT_EQ(trials.shown_rows(), 12);
  EXPECT_EQ(trials.model()->headerData(3, Qt::Horizontal).toString(), "Condition");
  EXPECT_EQ(trials.text_at(0, 3), "column 1, texture stone");
  EXPECT_EQ(trials.text_at(7, 3), "column 1, texture metal") << "of what is to come too";
  EXPECT_EQ(trials.text_at(0, 4), "answered");
  EXPECT_EQ(trials.text_at(4, 11), "flagged: speed outside its band for 62 % of the contact");
  EXPECT_EQ(trials.text_at(7, 4), "pending");
  child<StudyTable>(window_, "trials_table").selectRow(4);
  EXPECT_EQ(child<QLabel>(window_, "trials_selected").text(),
            "Trial 5, attempt 1: answered; stone; flagged: speed outside its band for 62 % of the "
            "contact");
  const auto& events = child<StudyTable>(window_, "trials_events");
  EXPECT_TRUE(column(events, 1).contains("note"));
  window_.resize(1280, 720);
  QTest::qWait(100);  // rows follow the columns
  for (const int shown : {3, 11}) expect_whole(trials, shown);
  EXPECT_GE(trials.columnWidth(11), 160) << "remarks are sentences";
  take_screenshot(window_, "study-trials");
  click("trials_back");
  EXPECT_EQ(window_.shown_page(), "sessions");
}

TEST_F(StudyPages, HideWhatWasFeltAndAnsweredWhileARunIsUnderWay) {
  open_lively();
  const std::filesystem::path folder = window_.study()->folder();
  std::int64_t session = 0;
  std::int64_t first = 0;
  {
    Study own = Study::open(folder, Access::read_write);
    for (const SessionRow& row : own.sessions()) {
      if (row.participant == "P012") session = row.id;
    }
    own.reopen_session(session);
    first = own.attempts(session).at(0).id;
  }
  auto& trials = *qobject_cast<TrialsPage*>(window_.page("trials"));
  auto& attempt = *qobject_cast<AttemptPage*>(window_.page("attempt"));
  const auto told = [&trials] {
    QStringList texts{child<QLabel>(trials, "trials_selected").text()};
    for (const char* const name : {"trials_table", "trials_events"}) {
      const QAbstractItemModel& model = *child<StudyTable>(trials, name).model();
      for (int row = 0; row < model.rowCount(); ++row) {
        for (int column = 0; column < model.columnCount(); ++column) {
          for (const int role : {0, 3, 256}) {  // text, tool tip, what it is sorted by
            texts << model.index(row, column).data(role).toString();
          }
        }
      }
    }
    return texts.filter(QRegularExpression("\\b(metal|stone|wood|brick|yes|no)\\b"));
  };
  {
    const StudyLock run(folder, Study::session_lock_name("P012"));
    window_.show_page("trials");
    trials.show_session(session);
    auto& table = child<StudyTable>(trials, "trials_table");
    ASSERT_TRUE(eventually([&] { return table.shown_rows() == 12; }));
    table.selectRow(0);
    EXPECT_EQ(told().join("; ").toStdString(), "");
    EXPECT_EQ(table.text_at(0, 4), "answered") << "how far it is may be known";
    EXPECT_FALSE(child<QPushButton>(trials, "trials_open").isEnabled());
    EXPECT_TRUE(child<QLabel>(trials, "trials_standing").isVisible());
    QSignalSpy opened(&trials, &TrialsPage::attempt_opened);
    QTest::keyClick(&table, Qt::Key_Return);
    EXPECT_EQ(opened.count(), 0);
    window_.show_page("attempt");
    attempt.show_attempt(first);
    ASSERT_TRUE(eventually(
        [&] { return child<QLabel>(attempt, "attempt_standing").text().contains("blind"); }));
    EXPECT_FALSE(child<QTabWidget>(attempt, "attempt_tabs").isVisible());
    EXPECT_EQ(child<QLabel>(attempt, "attempt_summary").text(), "");
  }
  window_.study()->announce_change();
  EXPECT_TRUE(eventually([&] { return !told().isEmpty(); })) << "it is over";
  EXPECT_TRUE(eventually([&] { return child<QTabWidget>(attempt, "attempt_tabs").isVisible(); }));
}

}  // namespace
}  // namespace asperity
