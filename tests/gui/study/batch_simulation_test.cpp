// Virtual participants in the background of the study window: from a click to the analysis of their responses.

#include "app/gui/window/batch_simulation.h"

#include <QtTest/QTest>
#include <QtWidgets/QDialog>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSpinBox>

#include "app/gui/base/study_table.h"
#include "app/gui/data/analysis_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/start/start_page.h"
#include "app/gui/window/session_desk.h"
#include "app/gui/window/study_window.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/app/small_study.h"
#include "tests/gui/study/quiet_home.h"

namespace asperity {
namespace {

class BatchSimulationTest : public QuietHome {
 protected:
  BatchSimulationTest() : desk_(window_, nullptr) {
    window_.resize(1366, 768);
    window_.show();
    make_small_study(folder());
    for (const std::string name : {"first", "second"}) {
      std::string text = small_protocol();
      text.replace(text.find("\"small\""), 7, '"' + name + '"');
      write_file(folder() / "protocols" / (name + ".json"), text, Overwrite::refuse);
    }
    EXPECT_TRUE(window_.open_study(folder()));
    select("second");
  }

  std::filesystem::path folder() const { return home() / "small study"; }
  Study stored() const { return Study::open(folder(), Access::read_only); }
  void select(const std::string& name) {
    window_.show_page("protocols");
    auto& table = child<StudyTable>(window_, "protocols_table");
    require([&] { return table.shown_rows() == 2; }, "protocols");
    table.select(QString::fromStdString((folder() / "protocols" / (name + ".json")).string()));
  }
  void click(const char* button) {
    QTest::mouseClick(&child<QPushButton>(window_, button), Qt::LeftButton);
  }
  void press_banner(const QString& verb) {
    for (auto* button : window_.banner().findChildren<QPushButton*>()) {
      if (button->text() == verb) return QTest::mouseClick(button, Qt::LeftButton);
    }
    ADD_FAILURE() << "no button " << verb.toStdString();
  }
  QWidget& line() { return child<QWidget>(window_, "simulating"); }
  bool has_ended() {
    const auto& simulation = *desk_.findChild<BatchSimulation*>();
    return eventually([&] { return window_.banner().isVisible() && !simulation.is_running(); });
  }
  /// The outcome that the Analysis page shows when the responses have been counted.
  const AnalysisOutcome& shown_outcome() {
    auto& page = *qobject_cast<AnalysisPage*>(window_.page("analysis"));
    const auto& list = child<QListWidget>(page, "outcomes");
    require([&] { return list.currentRow() >= 0; }, "an outcome");
    return page.outcomes().at(static_cast<std::size_t>(list.currentRow()));
  }

  StudyWindow window_{};
  SessionDesk desk_;
};

TEST_F(BatchSimulationTest, ShowsTheResultsOfTwelveVirtualParticipants) {
  click("protocol_simulate_several");
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(window_.shown_page(), "analysis");
  EXPECT_EQ(window_.banner().text(), "12 sessions were simulated. Trials of all blocks: 36.");
  EXPECT_EQ(stored().participants().size(), 12U);
  const AnalysisOutcome& outcome = shown_outcome();
  EXPECT_EQ(outcome.protocol, "second");
  EXPECT_EQ(outcome.group, AnswerGroup::virtual_participants);

  select("first");
  click("protocol_simulate_several");
  window_.show_page("sessions");
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(window_.shown_page(), "sessions") << "another page is in use";
  press_banner("Show the results");
  EXPECT_EQ(window_.shown_page(), "analysis");
  EXPECT_TRUE(eventually([this] { return shown_outcome().protocol == "first"; }));
  EXPECT_EQ(stored().participants().size(), 24U);
}

TEST_F(BatchSimulationTest, LeavesThePageUnderADialog) {
  click("protocol_simulate_several");
  QDialog dialog(&window_);
  dialog.open();
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(window_.shown_page(), "protocols");
  EXPECT_EQ(window_.banner().text(), "12 sessions were simulated. Trials of all blocks: 36.");
  dialog.close();
  press_banner("Show the results");
  EXPECT_EQ(window_.shown_page(), "analysis");
  EXPECT_TRUE(eventually([this] { return shown_outcome().protocol == "second"; }));
}

TEST_F(BatchSimulationTest, ResumesASimulationThatWasCancelled) {
  click("protocol_simulate");
  child<QSpinBox>(window_, "virtual_participants").setValue(40);
  ASSERT_TRUE(eventually([this] { return child<QPushButton>(window_, "start").isEnabled(); }));
  click("start");
  EXPECT_FALSE(child<QPushButton>(window_, "start").isEnabled());
  EXPECT_FALSE(window_.close());
  ASSERT_TRUE(eventually([this] { return stored().sessions().size() > 2; }));
  child<QPushButton>(line(), "task_cancel").click();
  ASSERT_TRUE(has_ended());
  EXPECT_TRUE(window_.banner().text().startsWith(
      "The simulation was cancelled. Trials completed and stored: "))
      << window_.banner().text().toStdString();
  const std::size_t begun = stored().sessions().size();
  EXPECT_LT(begun, 40U);

  press_banner("Resume the simulation");
  ASSERT_TRUE(has_ended());
  EXPECT_TRUE(window_.banner().text().contains("sessions were simulated."))
      << window_.banner().text().toStdString();
  EXPECT_EQ(stored().participants().size(), 40U);
  EXPECT_EQ(stored().sessions().size(), 40U);
  for (const SessionRow& session : stored().sessions()) {
    EXPECT_EQ(session.state, SessionState::completed);
  }
}

TEST_F(BatchSimulationTest, StatesWhyItFailedAndThatNothingIsStored) {
  std::filesystem::remove(folder() / "stimuli" / "grain_photo.png");
  click("protocol_simulate_several");
  ASSERT_TRUE(has_ended());
  EXPECT_EQ(window_.shown_page(), "protocols");
  EXPECT_TRUE(window_.banner().text().contains("grain_photo.png"));
  EXPECT_TRUE(window_.banner().text().endsWith("No trial was completed."))
      << window_.banner().text().toStdString();
  EXPECT_TRUE(stored().participants().empty());
}

TEST_F(BatchSimulationTest, StartsNothingElseMeanwhile) {
  click("protocol_simulate_several");
  click("protocol_start");
  EXPECT_EQ(window_.shown_page(), "protocols");
  EXPECT_TRUE(window_.banner().text().contains("are being simulated. Cancel the simulation first"));
  click("protocol_simulate_several");
  EXPECT_EQ(window_.shown_page(), "protocols");
  ASSERT_TRUE(eventually([this] { return window_.shown_page() == "analysis"; }));
  EXPECT_EQ(stored().participants().size(), 12U);
}

}  // namespace
}  // namespace asperity
