// Protocols are tried with the mouse, and the study has the same bytes afterwards.

#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialog>
#include <gtest/gtest.h>

#include "app/gui/session/reason_form.h"
#include "protocols/file/library_protocols.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/sessions/mouse_trial_room.h"
#include "tests/gui/support/screenshot.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

class MouseTrials : public MouseTrialRoom {};

TEST_F(MouseTrials, LeaveTheStudyAsItIs) {
  make_study();
  add_protocol({.trials = 3, .blocks = 2, .flow = R"({"run": "main"}, {"run": "second"})"});
  try_by_mouse("small", 0.6, chooses_a());
}

TEST_F(MouseTrials, ListTheTrialsThatAreRun) {
  make_study();
  add_protocol({.trials = 3, .blocks = 2, .flow = R"({"run": "main"}, {"run": "second"})"});
  begin_by_mouse("small");
  EXPECT_EQ(rows_of_plan(), 3) << "a heading and two trials";
  take_screenshot(experimenter(), "mouse-trial", QSize(1366, 900));
}

TEST_F(MouseTrials, EndWithoutAQuestion) {
  make_study();
  add_protocol({.trials = 3});
  const auto before = hashes();
  const auto expect_end = [&] {
    EXPECT_TRUE(experimenter().findChildren<QDialog*>().isEmpty());
    wait_for("the end", [&] { return desk->runner() == nullptr; });
    EXPECT_EQ(window->banner().text(),
              "The trial with the mouse has ended. Nothing was stored in the study.");
  };
  begin_by_mouse("small");
  experimenter().refresh();
  EXPECT_TRUE(child<QPushButton>(experimenter(), "abort").text().startsWith("End"));
  const auto& skip = child<QPushButton>(experimenter(), "skip");
  wait_for("a trial", [&] {
    const bool is_text = view().scene().kind == Scene::Kind::text;
    if (is_text && view().waits() && can_be_perceived()) key(Qt::Key_Return);
    experimenter().refresh();
    return skip.isEnabled();
  });
  EXPECT_TRUE(skip.text().startsWith("Skip") && !skip.text().contains("…"));
  click(experimenter(), "skip");
  EXPECT_FALSE(child<ReasonForm>(experimenter(), "reason_form").isVisible());
  wait_for("the second trial", [&] {
    experimenter().refresh();
    return skip.isEnabled() && monitor().snapshot().trial == 2;
  });
  click(experimenter(), "abort");
  expect_end();
  begin_by_mouse("small");
  experimenter().close();
  expect_end();
  // While it is being prepared.
  window->show_page("protocols");
  click(*window, "protocol_by_mouse");
  wait_for("the preparation", [&] { return desk->runner() != nullptr; });
  experimenter().close();
  expect_end();
  close_windows();
  EXPECT_EQ(hashes(), before);
}

TEST_F(MouseTrials, AreOfTheChosenGroup) {
  make_study();
  add_protocol({.trials = 3});
  const std::filesystem::path file = folder() / "protocols" / "small.json";
  write_file(
      file,
      replaced(
          read_file(file), R"("factors": {)",
          R"("groups": {"factor": "ground"}, "factors": {"ground": {"levels": ["dawn", "dusk"]}, )"),
      Overwrite::allow);
  add_protocol({.name = "without"});
  open();
  window->show_page("protocols");
  click_row(*window, "protocols_table", "without");
  auto& groups = child<QComboBox>(*window, "protocol_mouse_group");
  EXPECT_FALSE(groups.isVisible());
  click_row(*window, "protocols_table", "small");
  EXPECT_TRUE(groups.isVisible());
  EXPECT_EQ(groups.currentText(), "as group dawn");
  take_screenshot(*window, "mouse-trial-group", QSize(1366, 900));
  groups.setCurrentIndex(1);
  click(*window, "protocol_by_mouse");
  wait_for("the session",
           [&] { return desk->runner() != nullptr && monitor().facts() != nullptr; });
  EXPECT_EQ(monitor().facts()->row.group_level, "dusk");
}

TEST_F(MouseTrials, StateWhyTheyEndedEarly) {
  make_study();
  add_protocol({.trials = 3});
  begin_by_mouse("small");
  desk->runner()->requests().abort(Phrase("The participant is unwell"));
  wait_for("the end", [&] { return desk->runner() == nullptr; });
  EXPECT_EQ(window->banner().text(),
            "The trial with the mouse has ended: The participant is unwell. Nothing was stored in "
            "the study.");
}

// The participant's texts, questions and pictures of two protocols of the library.
TEST_F(MouseTrials, ShowProtocolsOfTheLibrary) {
  std::filesystem::create_directories(folder().parent_path());
  std::filesystem::copy(small_demo_study(), folder(), std::filesystem::copy_options::recursive);
  for (const LibraryProtocol& protocol : library_protocols()) {
    if (protocol.name != "amplitude_jnd") continue;
    write_file(folder() / "protocols" / "amplitude_jnd.json", protocol.text, Overwrite::refuse);
  }
  try_by_mouse("amplitude_jnd", 1.8, chooses_a());
  try_by_mouse("chapter_recognition", 2.2, [this](const Scene&) { choose(Qt::Key_2); });
}

}  // namespace
}  // namespace asperity
