// A simulated session, looked at afterwards: its numbers, its recordings, and what is decided.

#include "app/gui/data/attempt_page.h"

#include <fstream>

#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QTabWidget>
#include <qcustomplot.h>

#include "app/gui/base/study_table.h"
#include "app/gui/data/analysis_page.h"
#include "app/gui/data/attempt_words.h"
#include "app/gui/data/time_plots.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/study/trials_page.h"
#include "app/gui/window/study_window.h"
#include "app/tasks/simulation/simulation.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"
#include "tests/app/small_study.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class DataView : public QuietHome {
 protected:
  DataView() {
    make_small_study(folder());
    std::string protocol =
        small_protocol("", R"(, "normal_force_N": {"minimum": 0.5, "maximum": 1.5},
      "speed_m_per_s": {"minimum": 0.02, "maximum": 0.2})");
    if (!qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) {
      // As long as a person feels a surface; half a second is enough for a test.
      const std::string short_contact = R"("minimum_contact_s": 0.5, "maximum_contact_s": 2)";
      protocol.replace(protocol.find(short_contact), short_contact.size(),
                       R"("minimum_contact_s": 6, "maximum_contact_s": 12)");
    }
    write_file(folder() / "protocols" / "small.json", protocol, Overwrite::refuse);
    SimulationInputs inputs{};
    inputs.protocols = {folder() / "protocols" / "small.json"};
    inputs.study = folder();
    inputs.recordings = Recordings::all;
    (void)simulate(inputs, built_in_models(), {}, {}, {});
    study_.emplace(folder());
    const std::vector<SessionRow> sessions = study_->study().sessions();
    session_id_ = sessions.at(0).id;
  }

  std::filesystem::path folder() const { return temporary_.path() / "study"; }
  std::vector<AttemptRow> attempts() const { return study_->study().attempts(session_id_); }
  AttemptRow attempt(std::size_t index) const { return attempts().at(index); }

  static QString text(QWidget& page, const char* label) {
    return child<QLabel>(page, label).text();
  }
  static void click(QWidget& page, const char* button) {
    QTest::mouseClick(&child<QPushButton>(page, button), Qt::LeftButton);
  }
  static void give_reason(QWidget& page, const QString& reason) {
    child<QComboBox>(page, "decision_reason").setEditText(reason);
  }
  /// Shows the attempt and waits for all of it.
  void show_attempt(AttemptPage& page, const AttemptRow& attempt) {
    page.resize(1366, 768);
    page.show();
    page.show_attempt(attempt.id);
    const QString place = QString("Trial %1, attempt %2").arg(attempt.trial).arg(attempt.attempt);
    ASSERT_TRUE(eventually([&] {
      for (const QLabel* label : page.findChildren<QLabel*>()) {
        if (label->text().startsWith(place)) return true;
      }
      return false;
    }));
  }
  static bool shows_recording(AttemptPage& page) {
    return child<QComboBox>(page, "recording_choice").isVisible();
  }

  TemporaryFolder temporary_{};
  std::optional<OpenStudy> study_{};
  std::int64_t session_id_ = 0;
};

TEST_F(DataView, ShowsTheNumbersOfTheStore) {
  AttemptPage page(*study_);
  const AttemptRow stored = attempt(1);
  show_attempt(page, stored);
  EXPECT_EQ(text(page, "attempt_place"), "2 of 3");
  EXPECT_FALSE(child<QLabel>(page, "attempt_names").isVisible());  // the session is over
  const auto& answers = child<StudyTable>(page, "attempt_answers");
  ASSERT_EQ(answers.shown_rows(), 1);
  EXPECT_EQ(answers.text_at(0, 2), QString::fromStdString(stored.responses.at(0).answer));
  EXPECT_EQ(answers.text_at(0, 5), QString::number(*stored.responses.at(0).from_contact_s, 'f', 2));
  const auto& surfaces = child<StudyTable>(page, "attempt_surfaces");
  ASSERT_EQ(surfaces.shown_rows(), 2);
  EXPECT_TRUE(
      surfaces.text_at(0, 3).startsWith(QString::fromStdString(stored.presentations.at(0).model)));
  const auto& compliance = child<StudyTable>(page, "attempt_compliance");
  ASSERT_EQ(compliance.shown_rows(), static_cast<int>(stored.compliance.size()));
  const ComplianceRow& force = stored.compliance.at(0);
  ASSERT_EQ(force.quantity, "normal_force_N");
  EXPECT_EQ(compliance.text_at(0, 2), "0.5 to 1.5");
  EXPECT_EQ(compliance.text_at(0, 3), QString::number(force.p50, 'f', 2));
  EXPECT_EQ(compliance.text_at(0, 7), *force.passed ? "✓ met" : "✕ not met");
  const auto& loop = child<StudyTable>(page, "attempt_loop");
  EXPECT_EQ(loop.text_at(0, 1), QString::number(stored.servo->ticks));
  ASSERT_GT(loop.shown_rows(), 10) << "more than one digit: sorted by number, not as text";
  EXPECT_EQ(loop.text_at(loop.shown_rows() - 1, 0), "fault");
}

// In a small window, with the parameters of a model that has many.
TEST_F(DataView, CutsNothingOfTheMeasures) {
  StudyWindow window;
  window.resize(1280, 720);
  window.show();
  ASSERT_TRUE(window.open_study(folder()));
  auto& page = *qobject_cast<AttemptPage*>(window.page("attempt"));
  page.show_attempt(attempt(1).id);
  window.show_page("attempt");
  ASSERT_TRUE(eventually([&] { return shows_recording(page); }));
  child<QTabWidget>(page, "attempt_tabs").setCurrentIndex(1);
  for (const char* name : {"attempt_answers", "attempt_surfaces", "attempt_compliance",
                           "attempt_instability", "attempt_loop"}) {
    const auto& table = child<StudyTable>(page, name);
    EXPECT_TRUE(eventually([&] { return cut_cells(table).isEmpty(); }))
        << name << ": " << cut_cells(table).join(" | ").toStdString();
    EXPECT_GE(table.viewport()->height(), table.verticalHeader()->length()) << name;
  }
}

TEST_F(DataView, DrawsTheRecordingOfEverySurfaceOverOneTime) {
  AttemptPage page(*study_);
  const AttemptRow stored = attempt(0);
  show_attempt(page, stored);
  ASSERT_TRUE(eventually([&] { return shows_recording(page); }));
  auto& choice = child<QComboBox>(page, "recording_choice");
  EXPECT_EQ(choice.count(), 3);  // whole, and two surfaces
  auto& plots = child<TimePlots>(page, "time_plots");
  const TimeStretch whole = plots.seen();
  EXPECT_NEAR(whole.duration_s(), static_cast<double>(stored.recording->records - 1) * 1e-3, 1e-6);
  choice.setCurrentIndex(2);
  const TimeStretch second = plots.seen();
  EXPECT_NEAR(second.begin_s,
              static_cast<double>(*stored.presentations[1].onset_ns - stored.onset_ns) * 1e-9,
              2e-3);
  QTest::keyClick(&plots, Qt::Key_Plus);
  EXPECT_NEAR(plots.seen().duration_s(), second.duration_s() / 1.5, 1e-9);
  for (const char* name :
       {"force_over_time", "penetration_over_time", "speed_over_time", "position_over_time"}) {
    const QCPRange range = child<QCustomPlot>(page, name).xAxis->range();
    EXPECT_EQ(range.lower, plots.seen().begin_s) << name;
    EXPECT_EQ(range.upper, plots.seen().end_s) << name;
  }
  QTest::keyClick(&plots, Qt::Key_Home);
  EXPECT_EQ(plots.seen().duration_s(), whole.duration_s());
}

TEST_F(DataView, ZoomsAllPlotsWithTheAxisOfOne) {
  AttemptPage page(*study_);
  show_attempt(page, attempt(0));
  ASSERT_TRUE(eventually([&] { return shows_recording(page); }));
  auto& plots = child<TimePlots>(page, "time_plots");
  const double begin_s = plots.seen().begin_s;
  child<QCustomPlot>(page, "speed_over_time").xAxis->setRange(begin_s + 0.1, begin_s + 0.3);
  const QCPRange range = child<QCustomPlot>(page, "force_over_time").xAxis->range();
  EXPECT_NEAR(range.lower, begin_s + 0.1, 1e-9);
  EXPECT_NEAR(range.upper, begin_s + 0.3, 1e-9);
}

TEST(AttemptWords, SayThatPracticeIsNotAnalysedAndPilotsAreApart) {
  AttemptDetail detail{};
  detail.attempt.valid = true;
  detail.attempt.responses.emplace_back();
  detail.planned.phase = "main";
  EXPECT_EQ(AttemptWords::standing(detail), "Counted in the analyses");
  detail.session.mode = SessionMode::pilot;
  EXPECT_EQ(AttemptWords::standing(detail), "Counted in the analyses of pilot sessions");
  detail.planned.phase = "practice";
  EXPECT_EQ(AttemptWords::standing(detail), "Practice: not included in analyses");
  EXPECT_EQ(AttemptWords::state(detail), State::unknown);
  detail.attempt.flagged = true;
  detail.attempt.flag_reason = "late";
  EXPECT_TRUE(AttemptWords::standing(detail).startsWith("Practice: not included in analyses; "));
}

TEST(AttemptWords, StateThatAnAnchorIsNotAnalysed) {
  AttemptDetail detail{};
  detail.attempt.valid = true;
  detail.attempt.responses.emplace_back();
  detail.planned.phase = "main";
  detail.planned.repetition = 0;
  EXPECT_EQ(AttemptWords::standing(detail), "Anchor: not included in analyses");
  EXPECT_EQ(AttemptWords::state(detail), State::unknown);
  detail.attempt.flagged = true;
  detail.attempt.flag_reason = "late";
  EXPECT_EQ(AttemptWords::standing(detail), "Anchor: not included in analyses; flagged: late");
}

TEST(AttemptWords, StateThatAnUnansweredAttemptIsNotAnalysed) {
  AttemptDetail detail{};
  detail.attempt.valid = true;
  detail.attempt.outcome = AttemptOutcome::timed_out;
  detail.planned.phase = "main";
  EXPECT_EQ(AttemptWords::standing(detail), "Not counted: no response");
  EXPECT_EQ(AttemptWords::state(detail), State::unknown);
}

TEST_F(DataView, ExcludesWithAReasonAndIncludesAgain) {
  AnalysisPage analysis(*study_);
  QSignalSpy counted(&analysis, &AnalysisPage::refreshed);
  analysis.show();
  ASSERT_TRUE(counted.wait(kPatience_ms));
  ASSERT_EQ(analysis.outcomes().at(0).answers, 3U);
  AttemptPage page(*study_);
  show_attempt(page, attempt(1));
  EXPECT_TRUE(text(page, "attempt_standing").contains("Counted in the analyses"));

  click(page, "attempt_exclude");
  give_reason(page, "interrupted by a fire alarm");
  child<QLineEdit>(page, "decision_by").setText("A. Keller");
  click(page, "decision_write");
  ASSERT_TRUE(eventually([&] {
    return text(page, "attempt_standing").contains("Excluded: interrupted by a fire alarm");
  })) << text(page, "attempt_standing").toStdString();
  const std::vector<DecisionRow> stored = study_->study().decisions(session_id_);
  ASSERT_EQ(stored.size(), 1U);
  EXPECT_EQ(stored[0].verdict, Verdict::exclude);
  EXPECT_EQ(stored[0].trial, 2);
  EXPECT_EQ(stored[0].reason.text, "interrupted by a fire alarm");
  EXPECT_EQ(stored[0].decided_by, "A. Keller");
  ASSERT_TRUE(eventually([&] { return analysis.outcomes().at(0).answers == 2; }));

  EXPECT_EQ(child<QPushButton>(page, "attempt_exclude").text(), "Include again…");
  click(page, "attempt_exclude");
  give_reason(page, "the alarm was after the answer");
  click(page, "decision_write");
  ASSERT_TRUE(eventually(
      [&] { return text(page, "attempt_standing").contains("Counted in the analyses"); }));
  ASSERT_TRUE(eventually([&] { return analysis.outcomes().at(0).answers == 3; }));
  // Nothing is forgotten.
  const auto& history = child<StudyTable>(page, "attempt_decisions");
  ASSERT_EQ(history.shown_rows(), 2);
  EXPECT_EQ(history.text_at(0, 4), "interrupted by a fire alarm");
  EXPECT_EQ(history.text_at(0, 5), "A. Keller");
  EXPECT_EQ(history.text_at(1, 3), "included again");
}

TEST_F(DataView, FlagsWithAReasonAndContinuesCounting) {
  AttemptPage page(*study_);
  show_attempt(page, attempt(0));
  click(page, "attempt_flag");
  give_reason(page, "hesitated for long");
  QTest::keyClick(&child<QLineEdit>(page, "decision_by"), Qt::Key_Return);
  ASSERT_TRUE(eventually([&] {
    return text(page, "attempt_standing").contains("Counted but flagged: hesitated for long");
  })) << text(page, "attempt_standing").toStdString();
  EXPECT_TRUE(attempt(0).flagged);
  EXPECT_TRUE(attempt(0).valid);
  EXPECT_FALSE(attempt(0).excluded);
}

TEST_F(DataView, DecidesNothingWithoutAReason) {
  AttemptPage page(*study_);
  show_attempt(page, attempt(0));
  click(page, "attempt_exclude");
  const auto& write = child<QPushButton>(page, "decision_write");
  EXPECT_FALSE(write.isEnabled());
  EXPECT_TRUE(text(page, "decision_note").contains("Choose or enter a reason"));
  give_reason(page, "   ");
  EXPECT_FALSE(write.isEnabled());
  QTest::keyClick(&child<QLineEdit>(page, "decision_by"), Qt::Key_Return);
  QTest::keyClick(&child<QLineEdit>(page, "decision_by"), Qt::Key_Escape);
  EXPECT_FALSE(child<QWidget>(page, "decision_form").isVisible());
  EXPECT_TRUE(study_->study().decisions(session_id_).empty());
}

TEST_F(DataView, SaysWhatIsWrongWithABrokenRecordingAndShowsTheRest) {
  const AttemptRow stored = attempt(0);
  const std::filesystem::path file = folder() / stored.recording->path;
  std::string bytes = read_file(file);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  std::ofstream(file, std::ios::binary) << bytes;
  AttemptPage page(*study_);
  show_attempt(page, stored);
  ASSERT_TRUE(
      eventually([&] { return text(page, "recording_reason").contains("cannot be shown"); }));
  EXPECT_TRUE(text(page, "recording_reason").contains(QString::fromStdString(file.string())))
      << text(page, "recording_reason").toStdString();
  EXPECT_TRUE(text(page, "recording_reason").contains("chunk"))
      << text(page, "recording_reason").toStdString();
  EXPECT_EQ(child<StudyTable>(page, "attempt_answers").shown_rows(), 1);

  std::filesystem::remove(folder() / attempt(1).recording->path);
  click(page, "attempt_next");
  EXPECT_TRUE(eventually([&] {
    return text(page, "recording_reason")
        .contains(QString::fromStdString(attempt(1).recording->path));
  })) << text(page, "recording_reason").toStdString();
  click(page, "attempt_next");
  EXPECT_TRUE(eventually([&] { return shows_recording(page); }));
}

/// An answered attempt that nobody recorded, in a session that was stopped.
AttemptRow unrecorded_attempt(MadeUpStudy& made, std::vector<ModelLimitRow> limits = {}) {
  made.add_person("P001", "F");
  SessionRow session{};
  session.participant = "P001";
  session.protocol_id = made.add_protocol("made_up", "recognition");
  session.seed = "1";
  session.device_json = "{}";
  session.pacing = "stepped";
  session.rate_Hz = 1000.0;
  session.started_utc = "2026-03-02T09:00:00Z";
  PlannedTrialRow planned{};
  planned.trial = 1;
  planned.block = "main";
  planned.block_ordinal = 1;
  planned.phase = "main";
  Study& study = made.study();
  const std::int64_t id = study.add_session(session, {planned});
  AttemptRow attempt{};
  attempt.trial = 1;
  attempt.attempt = 1;
  attempt.segment = study.begin_segment(id, 0);
  attempt.offset_ns = 1'000'000'000;
  attempt.presentations = {surface_of("A", "height_map", "brick")};
  attempt.presentations[0].position = 1;
  attempt.presentations[0].limits = std::move(limits);
  ResponseRow answer{};
  answer.question = "recognised";
  answer.answer = "A";
  answer.source = "keyboard";
  attempt.responses = {answer};
  study.add_attempt(id, attempt);
  study.end_segment(id, attempt.segment, attempt.offset_ns, "stopped");
  study.end_session(id, SessionState::stopped, "2026-03-02T10:00:00Z");
  return study.attempts(id).at(0);
}

TEST_F(DataView, ShowsWhatTheForceModelCountedWhereItDoes) {
  MadeUpStudy made;
  const AttemptRow stored =
      unrecorded_attempt(made, {{"contact", 900}, {"fast", 12}, {"folded", 0}});
  OpenStudy study(made.folder());
  AttemptPage page(study);
  show_attempt(page, stored);
  const auto& limits = child<StudyTable>(page, "attempt_limits");
  ASSERT_EQ(limits.shown_rows(), 3);
  EXPECT_EQ(limits.text_at(0, 2), "900");
  EXPECT_EQ(limits.text_at(0, 3), "");  // how long it was touched is no limit
  EXPECT_TRUE(limits.text_at(1, 1).contains("shortest wavelength"))
      << limits.text_at(1, 1).toStdString();
  EXPECT_EQ(limits.text_at(1, 2), "12");
  EXPECT_TRUE(limits.text_at(1, 3).contains("check"));
  EXPECT_TRUE(limits.text_at(2, 3).contains("fine"));
  EXPECT_FALSE(limits.isHidden());

  AttemptPage other(*study_);
  show_attempt(other, attempt(0));
  EXPECT_TRUE(child<StudyTable>(other, "attempt_limits").isHidden());
}

TEST_F(DataView, ShowsAnAttemptThatWasNotRecorded) {
  MadeUpStudy made;
  const AttemptRow stored = unrecorded_attempt(made);
  OpenStudy study(made.folder());
  AttemptPage page(study);
  show_attempt(page, stored);
  EXPECT_TRUE(text(page, "recording_reason").contains("has no recording"));
  EXPECT_EQ(child<StudyTable>(page, "attempt_answers").text_at(0, 2), "A");
  EXPECT_FALSE(child<QPushButton>(page, "attempt_next").isEnabled());
  EXPECT_EQ(text(page, "attempt_place"), "1 of 1");
}

TEST_F(DataView, WarnsOfNamesWhileASessionCanGoOn) {
  MadeUpStudy made;
  const AttemptRow stored = unrecorded_attempt(made);
  OpenStudy study(made.folder());
  AttemptPage page(study);
  show_attempt(page, stored);
  EXPECT_TRUE(child<QLabel>(page, "attempt_names").isVisible());
  EXPECT_TRUE(text(page, "attempt_names").contains("no longer blind"));
}

TEST_F(DataView, RefusesARecordingOfAnotherAttempt) {
  const AttemptRow stored = attempt(0);
  std::filesystem::copy_file(folder() / attempt(1).recording->path,
                             folder() / stored.recording->path,
                             std::filesystem::copy_options::overwrite_existing);
  AttemptPage page(*study_);
  show_attempt(page, stored);
  EXPECT_TRUE(eventually([&] { return text(page, "recording_reason").contains("SHA-256"); }))
      << text(page, "recording_reason").toStdString();
}

TEST_F(DataView, ExportsARecordingTickByTick) {
  AttemptPage page(*study_);
  const AttemptRow stored = attempt(0);
  show_attempt(page, stored);
  ASSERT_TRUE(eventually([&] { return shows_recording(page); }));
  click(page, "recording_export");
  const std::filesystem::path file = temporary_.path() / "recording.tsv";
  emit child<QFileDialog>(page, "recording_dialog")
      .fileSelected(QString::fromStdString(file.string()));
  ASSERT_TRUE(eventually([&] { return page.findChild<Banner*>()->isVisible(); }));
  EXPECT_TRUE(page.findChild<Banner*>()->text().contains("recording.tsv"));
  const Table table = read_tsv(read_file(file), "recording.tsv");
  EXPECT_EQ(static_cast<std::int64_t>(table.rows.size()), stored.recording->records);
  const Recording recording = read_recording(folder() / stored.recording->path);
  ASSERT_EQ(table.columns.size(), recording.header.columns.size() + 1);
  EXPECT_EQ(table.columns[0], "time_ns");
  EXPECT_EQ(table.columns[3], "z_m");
  const auto z_m = number_in(std::get<std::string>(table.rows.at(100).at(3)));
  EXPECT_EQ(static_cast<float>(z_m.value()), recording.columns.at(2).at(100));
}

TEST_F(DataView, WritesATableWholeOrNotAtAllWhenItIsCancelled) {
  AttemptPage page(*study_);
  show_attempt(page, attempt(0));
  ASSERT_TRUE(eventually([&] { return shows_recording(page); }));
  click(page, "recording_export");
  const std::filesystem::path file = temporary_.path() / "recording.tsv";
  emit child<QFileDialog>(page, "recording_dialog")
      .fileSelected(QString::fromStdString(file.string()));
  child<TaskLine>(page, "recording_writing").findChild<QPushButton*>("task_cancel")->click();
  ASSERT_TRUE(eventually([&] { return page.findChild<Banner*>()->isVisible(); }));
  // A machine that is busy elsewhere may notice too late.
  const bool in_time = page.findChild<Banner*>()->text().contains("was cancelled");
  EXPECT_EQ(std::filesystem::exists(file), !in_time);
}

TEST_F(DataView, OpensFromTheTrialsWhichMarkWhatIsExcluded) {
  StudyWindow window;
  window.resize(1366, 768);
  window.show();
  ASSERT_TRUE(window.open_study(folder()));
  window.show_page("sessions");
  auto& sessions = child<StudyTable>(window, "sessions_table");
  ASSERT_TRUE(eventually([&] { return sessions.shown_rows() == 1; }));
  sessions.selectRow(0);
  click(window, "sessions_open");
  auto& trials = child<StudyTable>(window, "trials_table");
  ASSERT_TRUE(eventually([&] { return trials.shown_rows() == 3; }));
  trials.selectRow(1);
  click(window, "trials_open");
  EXPECT_EQ(window.shown_page(), "attempt");
  auto& page = child<AttemptPage>(window, "attempt_page");
  ASSERT_TRUE(eventually([&] { return shows_recording(page); }));
  EXPECT_EQ(text(page, "attempt_place"), "2 of 3");
  click(page, "attempt_exclude");
  give_reason(page, "Interrupted");
  click(page, "decision_write");
  ASSERT_TRUE(
      eventually([&] { return text(page, "attempt_standing").contains("Excluded: Interrupted"); }));
  click(page, "attempt_back");
  EXPECT_EQ(window.shown_page(), "trials");
  ASSERT_TRUE(eventually([&] { return trials.text_at(1, 11) == "excluded: Interrupted"; }));
  const auto is_struck = [&trials](int row) {
    return trials.model()->index(row, 3).data(Qt::FontRole).value<QFont>().strikeOut();
  };
  EXPECT_FALSE(is_struck(0));
  EXPECT_TRUE(is_struck(1));
}

TEST_F(DataView, ExcludesAWholeSessionAndIncludesItAgain) {
  StudyWindow window;
  window.resize(1366, 768);
  window.show();
  ASSERT_TRUE(window.open_study(folder()));
  auto& page = child<TrialsPage>(window, "trials_page");
  page.show_session(session_id_);
  window.show_page("trials");
  auto& trials = child<StudyTable>(window, "trials_table");
  ASSERT_TRUE(eventually([&] { return trials.shown_rows() == 3; }));
  click(page, "trials_exclude");
  give_reason(page, "It was a test run");
  click(page, "decision_write");
  ASSERT_TRUE(eventually([&] { return child<QLabel>(page, "trials_standing").isVisible(); }));
  EXPECT_EQ(trials.text_at(2, 11), "excluded: It was a test run");
  EXPECT_EQ(study_->study().session(session_id_).excluded.value().text, "It was a test run");
  EXPECT_EQ(study_->study().session(session_id_).excluded->json, R"({"code":"test_run"})");
  window.show_page("sessions");
  const auto& sessions = child<StudyTable>(window, "sessions_table");
  EXPECT_TRUE(eventually([&] { return sessions.text_at(0, 4) == "✕ excluded"; }));
  // One of its attempts cannot be included without it, and the page says where it can.
  auto& attempt_page = *qobject_cast<AttemptPage*>(window.page("attempt"));
  attempt_page.show_attempt(attempt(0).id);
  window.show_page("attempt");
  ASSERT_TRUE(eventually([&] {
    return text(attempt_page, "attempt_standing").contains("Excluded with its whole session");
  }));
  EXPECT_FALSE(child<QPushButton>(attempt_page, "attempt_exclude").isEnabled());
  EXPECT_EQ(text(attempt_page, "attempt_why_not"),
            "The whole session is excluded; it can be included again on its page.");
  window.show_page("trials");
  click(page, "trials_exclude");
  give_reason(page, "Excluded by mistake");
  click(page, "decision_write");
  ASSERT_TRUE(eventually([&] { return !child<QLabel>(page, "trials_standing").isVisible(); }));
  EXPECT_FALSE(study_->study().session(session_id_).excluded);
}

class TrialsOfAMatching : public QuietHome {};

TEST_F(TrialsOfAMatching, ShowEveryAnswerOnASmallScreen) {
  MadeUpStudy made;
  made.add_person("P001", "F");
  MadeUpTrial trial{};
  for (const std::string name : {"metal", "stone", "wood", "brick", "sandpaper", "pebbles"}) {
    trial.surfaces.push_back(surface_of("item", "height_map", name));
    trial.answers.push_back(name);
    trial.options.push_back(name);
  }
  trial.right = trial.answers;
  std::swap(trial.right[1], trial.right[2]);
  const std::int64_t session =
      made.add_session("P001", made.add_protocol("made_up", "matching"), {trial, trial, trial});
  StudyWindow window;
  window.resize(1366, 768);
  window.show();
  ASSERT_TRUE(window.open_study(made.folder()));
  child<TrialsPage>(window, "trials_page").show_session(session);
  window.show_page("trials");
  auto& trials = child<StudyTable>(window, "trials_table");
  ASSERT_TRUE(eventually([&] { return trials.shown_rows() == 3; }));
  QCoreApplication::processEvents();
  const QString answers = "1 metal, 2 stone, 3 wood, 4 brick, 5 sandpaper, 6 pebbles";
  ASSERT_EQ(trials.text_at(0, 5), answers);
  const QRect cell = trials.visualRect(trials.model()->index(0, 5));
  constexpr int kPadding = 24;  // of a cell: that of the style sheet, and of the text in it
  const QRect room(0, 0, cell.width() - kPadding, 1000);
  const QRect needed = QFontMetrics(trials.font()).boundingRect(room, Qt::TextWordWrap, answers);
  EXPECT_LE(needed.height() + 8, cell.height()) << cell.width() << " × " << cell.height();
  EXPECT_LE(needed.width(), room.width());
  const QRect remarks = trials.visualRect(trials.model()->index(0, 11));
  EXPECT_GE(remarks.width(), 160);
  EXPECT_LE(remarks.right(), trials.viewport()->width());
  const auto header = [&trials](int column, int role) {
    return trials.model()->headerData(column, Qt::Horizontal, role).toString();
  };
  EXPECT_EQ(header(7, Qt::DisplayRole), "After contact, s");
  EXPECT_TRUE(header(7, Qt::ToolTipRole).contains("from the first contact"));
  EXPECT_EQ(header(8, Qt::DisplayRole), "After cue, s");
  EXPECT_TRUE(header(8, Qt::ToolTipRole).contains("the question was first asked"));
  take_screenshot(window, "data-trials-matching", {1366, 768});
}

TEST_F(DataView, LooksAsItShould) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) GTEST_SKIP() << "nobody looks";
  Study writer = Study::open(folder(), Access::read_write);
  writer.add_decision(session_id_, {.trial = 2,
                                    .attempt = 1,
                                    .verdict = Verdict::exclude,
                                    .reason = "Interrupted by a fire alarm",
                                    .decided_by = "A. Keller"});
  writer.add_decision(session_id_, {.trial = 3,
                                    .attempt = 1,
                                    .verdict = Verdict::flag,
                                    .reason = "The hand slipped",
                                    .decided_by = "A. Keller"});
  for (const ThemeChoice choice : {ThemeChoice::light, ThemeChoice::dark}) {
    apply_theme(*qobject_cast<QApplication*>(QCoreApplication::instance()), choice);
    const QString theme_name = choice == ThemeChoice::dark ? "-dark" : "";
    StudyWindow window;
    window.show();
    ASSERT_TRUE(window.open_study(folder()));
    child<TrialsPage>(window, "trials_page").show_session(session_id_);
    window.show_page("sessions");
    window.show_page("trials");
    auto& trials = child<StudyTable>(window, "trials_table");
    ASSERT_TRUE(eventually([&] { return trials.shown_rows() == 3; }));
    trials.selectRow(1);
    take_screenshot(window, "data-trials" + theme_name);
    auto& page = *qobject_cast<AttemptPage*>(window.page("attempt"));
    page.show_attempt(attempt(1).id);
    window.show_page("attempt");
    ASSERT_TRUE(eventually([&] { return shows_recording(page); }));
    take_screenshot(window, "data-attempt" + theme_name);
    child<QComboBox>(page, "recording_choice").setCurrentIndex(1);
    click(page, "attempt_exclude");
    take_screenshot(window, "data-attempt-surface" + theme_name);
    child<QTabWidget>(page, "attempt_tabs").setCurrentIndex(1);
    click(page, "decision_cancel");
    take_screenshot(window, "data-attempt-measures" + theme_name);
    child<QTabWidget>(page, "attempt_tabs").setCurrentIndex(2);
    take_screenshot(window, "data-attempt-history" + theme_name);
  }
  apply_theme(*qobject_cast<QApplication*>(QCoreApplication::instance()), ThemeChoice::light);
}

}  // namespace
}  // namespace asperity
