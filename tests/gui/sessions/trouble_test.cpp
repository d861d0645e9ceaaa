// Pauses, stops, lost noise, closed windows: what is done stays, and the session goes on.

#include <algorithm>
#include <cmath>

#include <QtGui/QGuiApplication>
#include <QtGui/QScreen>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QPushButton>

#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/session/fault_panel.h"
#include "app/gui/start/start_page.h"
#include "renderers/servo/tick_record.h"
#include "results_schema/recording.h"
#include "tests/gui/sessions/session_room.h"

namespace asperity {
namespace {

using Outcomes = std::vector<std::string>;

class SessionInTrouble : public SessionRoom {
 protected:
  std::vector<std::string> planned() const {
    std::vector<std::string> plan{};
    const Study study = Study::open(folder(), Access::read_only);
    for (const PlannedTrialRow& trial : study.plan(stored_session().id)) {
      plan.push_back(trial.plan_json);
    }
    return plan;
  }
  /// From the Sessions page, for the session that is not finished.
  void go_on() {
    window->show_page("sessions");
    click_row(*window, "sessions_table", "small");
    click(*window, "sessions_resume");
    press_start();
  }
};

const std::vector<float>& column(const Recording& recording, const std::string& name) {
  const auto& columns = recording.header.columns;
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const RecordingColumn& each) { return each.name == name; });
  return recording.columns.at(static_cast<std::size_t>(found - columns.begin()));
}

TEST_F(SessionInTrouble, TheEmergencyKeyZeroesTheForceAndTheSameTrialIsAskedAgain) {
  make_study();
  add_protocol({.minimum_contact_s = 0.6});
  open();
  start("small");
  wait_for("a force", [&] { return is_pushed(1); });
  key(Qt::Key_F12);
  wait_for("the fault", [&] { return is_in(SessionPhase::fault); });
  auto& panel = child<FaultPanel>(experimenter(), "fault_panel");
  wait_for("the panel", [&] { return panel.isVisible(); });
  auto& clear = child<QPushButton>(panel, "fault_clear");
  EXPECT_FALSE(clear.isEnabled());
  const std::uint64_t version = monitor().snapshot().version;
  key(Qt::Key_F5);
  key(Qt::Key_Return);
  wait_for("the conductor", [&] { return monitor().snapshot().version > version + 20; });
  EXPECT_TRUE(is_in(SessionPhase::fault));  // it waits
  EXPECT_EQ(monitor().snapshot().fault, Fault::emergency_stop);
  click(panel, "fault_safe");
  click(clear);
  take_part(chooses_a());

  EXPECT_EQ(stored_outcomes(),
            (Outcomes{"1/1 emergency_stop, not valid", "1/2 answered", "2/1 answered"}));
  EXPECT_EQ(stored_session().state, SessionState::completed);
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 3U);
  for (std::size_t surface = 0; surface < 2; ++surface) {
    EXPECT_EQ(attempts[0].presentations.at(surface).model,
              attempts[1].presentations.at(surface).model);
  }
  EXPECT_TRUE(attempts[0].responses.empty());
  EXPECT_EQ(stored_events("fault").at(0).text, "emergency_stop");
  EXPECT_EQ(stored_events("fault_cleared").size(), 1U);
  window->show_page("sessions");
  click_row(*window, "sessions_table", "small");
  click(*window, "sessions_open");
  auto& trials = child<StudyTable>(*window, "trials_table");
  wait_for("the trials", [&] { return trials.shown_rows() == 3; });
  EXPECT_EQ(trials.text_at(0, 4), "emergency stop");

  ASSERT_TRUE(attempts[0].recording);
  const Recording recording = read_recording(folder() / attempts[0].recording->path);
  const std::vector<float>& flags = column(recording, "flags");
  const std::vector<float>& depth_m = column(recording, "penetration_m");
  std::size_t latched = 0;
  while (latched < flags.size() && (static_cast<unsigned>(flags[latched]) &
                                    static_cast<unsigned>(TickFlag::fault_latched)) == 0) {
    ++latched;
  }
  ASSERT_GT(latched, 1U);
  ASSERT_LT(latched, flags.size());
  const auto force_N = [&](std::size_t tick) {
    double square = 0.0;
    for (const char* name : {"sent_fx_N", "sent_fy_N", "sent_fz_N"}) {
      square += std::pow(static_cast<double>(column(recording, name)[tick]), 2);
    }
    return std::sqrt(square);
  };
  EXPECT_GT(force_N(latched - 1), 0.05);
  EXPECT_GT(depth_m[latched - 1], 0.0F);
  for (std::size_t tick = latched; tick < flags.size(); ++tick) {
    ASSERT_EQ(force_N(tick), 0.0) << "tick " << tick << ", stopped in tick " << latched;
  }
}

TEST_F(SessionInTrouble, LostMaskingNoisePausesWithABannerThatResumes) {
  make_study();
  add_protocol({.trials = 1,
                .minimum_contact_s = 0.6,
                .head = R"(, "environment": {"vision": "hand_occluded",
                           "masking_noise": {"kind": "pink", "level_dBA": 60}})"});
  open();
  start("small");
  wait_for("a force", [&] { return is_pushed(1); });
  EXPECT_TRUE(sound.is_masking());
  sound.is_running = false;
  wait_for("the pause", [&] { return is_in(SessionPhase::paused); });
  auto& banner = child<Banner>(experimenter(), "trouble");
  wait_for("the banner", [&] { return banner.isVisible(); });
  EXPECT_TRUE(banner.text().contains("masking noise has stopped")) << banner.text().toStdString();
  sound.is_running = true;
  QPushButton* resume = nullptr;
  for (QPushButton* button : banner.findChildren<QPushButton*>()) {
    if (button->text() == "Resume") resume = button;
  }
  ASSERT_NE(resume, nullptr);
  click(*resume);
  take_part(chooses_a());
  EXPECT_EQ(stored_outcomes(), (Outcomes{"1/1 aborted, not valid", "1/2 answered"}));
  EXPECT_EQ(stored_events("masking_noise_lost").size(), 1U);
  EXPECT_EQ(stored_session().state, SessionState::completed);
  EXPECT_FALSE(sound.is_masking());
}

TEST_F(SessionInTrouble, ALostDeviceZeroesTheForceAndTheSessionContinuesOnceItAnswersAgain) {
  make_study();
  add_protocol({.trials = 1, .minimum_contact_s = 0.6});
  open();
  window->show_page("protocols");
  click_row(*window, "protocols_table", "small");
  click(*window, "protocol_start");
  click(*window, "mode_pilot");
  agree();
  SessionOrder order = qobject_cast<StartPage*>(window->page("start"))->order();
  order.inputs.faults = {{.kind = ScriptedFault::Kind::lost, .at_s = 0.8, .duration_s = 0.5}};
  desk->begin(order);
  auto& panel = child<FaultPanel>(experimenter(), "fault_panel");
  wait_for("the panel", [&] { return panel.isVisible(); });
  EXPECT_TRUE(panel.text().contains("the force is held at zero")) << panel.text().toStdString();
  wait_for("no force", [&] {
    std::vector<LiveBin> bins{};
    monitor().bins_from(0, bins);
    return !bins.empty() && bins.back().force_maximum_N == 0.0F;
  });
  // The panel comes with the device's silence, before the session has gone into its phase.
  wait_for("the fault", [&] { return is_in(SessionPhase::fault); });
  auto& safe = child<QCheckBox>(panel, "fault_safe");
  auto& clear = child<QPushButton>(panel, "fault_clear");
  // As long as it does not answer it is not fit, and the panel comes back.
  wait_for("a device that answers", [&] {
    if (!is_in(SessionPhase::fault)) return true;
    if (!safe.isChecked() && safe.isVisible()) click(safe);
    if (clear.isVisible() && clear.isEnabled()) click(clear);
    return false;
  });
  take_part(chooses_a());
  EXPECT_EQ(stored_session().state, SessionState::completed);
  EXPECT_EQ(stored_events("fault").at(0).text, "device_lost");
  EXPECT_EQ(stored_events("fault_cleared").size(), 1U);
}

TEST_F(SessionInTrouble, AnUnpluggedScreenZeroesTheForceAndTheTrialIsAskedAgain) {
  make_study();
  add_protocol({.trials = 1, .minimum_contact_s = 0.6});
  open();
  start("small");
  wait_for("a force", [&] { return is_pushed(1); });
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  wait_for("the fault", [&] { return is_in(SessionPhase::fault); });
  auto& news = child<Banner>(experimenter(), "news");
  wait_for("the news",
           [&] { return news.isVisible() && news.text().contains("The participant's screen"); });
  EXPECT_TRUE(news.text().contains("the force is zero")) << news.text().toStdString();
  EXPECT_TRUE(desk->participant_window()->isVisible());
  for (QPushButton* button : news.findChildren<QPushButton*>()) {
    if (button->text() == "Restore window") click(*button);
  }
  EXPECT_FALSE(news.isVisible()) << "it is back";
  auto& panel = child<FaultPanel>(experimenter(), "fault_panel");
  click(panel, "fault_safe");
  click(panel, "fault_clear");
  take_part(chooses_a());
  EXPECT_EQ(stored_outcomes(), (Outcomes{"1/1 emergency_stop, not valid", "1/2 answered"}));
  EXPECT_EQ(stored_events("screen_lost").size(), 1U);
  EXPECT_EQ(stored_session().state, SessionState::completed);
}

TEST_F(SessionInTrouble, AScreenThatIsUnpluggedWhileTheQuestionIsOpenLeavesTheAnswerAlone) {
  make_study();
  add_protocol({});
  open();
  start("small");
  take_part([](const Scene&) {}, [&] { return is_in(SessionPhase::response); });
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  auto& news = child<Banner>(experimenter(), "news");
  wait_for("the news",
           [&] { return news.isVisible() && news.text().contains("The participant's screen"); });
  EXPECT_EQ(monitor().snapshot().fault, Fault::none);
  take_part(chooses_a(), [&] { return is_in(SessionPhase::paused); });
  key(Qt::Key_F5);
  take_part(chooses_a());
  EXPECT_EQ(stored_outcomes(), (Outcomes{"1/1 answered", "2/1 answered"}));
}

TEST_F(SessionInTrouble, AScreenThatIsUnpluggedWhileSomethingIsReadOnlyPauses) {
  make_study();
  add_protocol({.flow = R"({"screen": "Read this."}, {"run": "main"})"});
  open();
  start("small");
  wait_for("the text", [&] { return view().scene().kind == Scene::Kind::text; });
  emit qGuiApp->screenRemoved(QGuiApplication::primaryScreen());
  auto& news = child<Banner>(experimenter(), "news");
  wait_for("the news",
           [&] { return news.isVisible() && news.text().contains("The participant's screen"); });
  EXPECT_TRUE(news.text().contains("the session pauses")) << news.text().toStdString();
  EXPECT_TRUE(runner().requests().pending().pause);
  EXPECT_EQ(monitor().snapshot().fault, Fault::none);
}

TEST_F(SessionInTrouble, AbortedByItsClosedWindowItLeavesNoForce) {
  make_study();
  add_protocol({.minimum_contact_s = 0.6});
  open();
  start("small");
  wait_for("a force", [&] { return is_pushed(1); });
  experimenter().close();
  auto& question = child<QDialog>(experimenter(), "close_dialog");
  wait_for("the question", [&] { return question.isVisible(); });
  click(question, "close_abort");
  wait_for("the end", [&] { return desk->runner() == nullptr; });
  EXPECT_EQ(stored_outcomes(), (Outcomes{"1/1 aborted, not valid"}));
  const AttemptRow attempt = stored_attempts().at(0);
  ASSERT_TRUE(attempt.recording);
  const Recording recording = read_recording(folder() / attempt.recording->path);
  for (const char* name : {"sent_fx_N", "sent_fy_N", "sent_fz_N"}) {
    EXPECT_EQ(column(recording, name).back(), 0.0F) << name;
  }
}

TEST_F(SessionInTrouble, ClosedAndKilledInMidSessionItContinuesInTheSameOrder) {
  make_study();
  add_protocol({.kind = "recognition"});
  open();
  start("small");
  const auto answer = [&](const Scene&) { choose(Qt::Key_2); };
  take_part(answer, [&] { return is_in(SessionPhase::contact, 2); });
  const std::vector<std::string> plan = planned();
  ASSERT_EQ(plan.size(), 3U);
  experimenter().close();
  EXPECT_TRUE(experimenter().isVisible());
  window->close();
  EXPECT_TRUE(window->isVisible());
  auto& question = child<QDialog>(experimenter(), "close_dialog");
  wait_for("the question", [&] { return question.isVisible(); });
  click(question, "close_stop");
  take_part(answer, [&] { return desk->runner() == nullptr; });
  EXPECT_EQ(stored_outcomes(), (Outcomes{"1/1 answered", "2/1 answered"}));
  EXPECT_EQ(stored_session().state, SessionState::stopped);
  EXPECT_EQ(desk->session_window(), nullptr);

  go_on();
  take_part(answer, [&] { return is_pushed(3); });
  close_windows();  // whatever happens to the program: the session's thread ends with it
  EXPECT_EQ(stored_outcomes(),
            (Outcomes{"1/1 answered", "2/1 answered", "3/1 aborted, not valid"}));
  EXPECT_EQ(stored_session().state, SessionState::stopped);

  open();
  go_on();
  take_part(answer);
  EXPECT_EQ(stored_outcomes(),
            (Outcomes{"1/1 answered", "2/1 answered", "3/1 aborted, not valid", "3/2 answered"}));
  EXPECT_EQ(stored_session().state, SessionState::completed);
  EXPECT_EQ(planned(), plan);
  EXPECT_EQ(Study::open(folder(), Access::read_only).sessions().size(), 1U);
  EXPECT_EQ(stored_events("session_resumed").size(), 2U);
  const std::vector<AttemptRow> attempts = stored_attempts();
  ASSERT_EQ(attempts.size(), 4U);
  EXPECT_EQ(attempts[2].presentations.at(0).texture, attempts[3].presentations.at(0).texture);
}

}  // namespace
}  // namespace asperity
