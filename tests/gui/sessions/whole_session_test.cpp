// Sessions of each kind from the first page to the exported table: what was pressed is what stands
// there.

#include <QtCore/QTimer>
#include <QtGui/QGuiApplication>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "app/gui/look/controls.h"
#include "tests/app/punctual_trial.h"
#include "tests/gui/sessions/session_room.h"
#include "tests/gui/support/screenshot.h"
#include "tests/support/patient_servo.h"

namespace asperity {
namespace {

using Item = ParticipantItem;
using Row = std::map<std::string, std::string>;

class WholeSession : public SessionRoom {
 protected:
  /// From the end of a session by the analysis page into a new folder.
  std::filesystem::path export_tables() {
    click(experimenter(), "see_table");
    const std::filesystem::path tables = home() / "tables";
    wait_for("the analysis page", [&] { return window->shown_page() == "analysis"; });
    QWidget& page = *window->page("analysis");
    click(page, "export_tables");
    auto& dialog = child<QFileDialog>(page, "export_dialog");
    child<QLineEdit>(dialog, "fileNameEdit").setText(QString::fromStdString(tables.string()));
    QTest::keyClick(&child<QLineEdit>(dialog, "fileNameEdit"), Qt::Key_Return);
    wait_for("the tables", [&] { return std::filesystem::exists(tables / "MANIFEST.tsv"); });
    return tables;
  }

  static void expect_reaction_times(const Row& row) {
    const double from_cue_s = std::stod(row.at("from_cue_s"));
    const double from_contact_s = std::stod(row.at("from_contact_s"));
    EXPECT_GT(from_cue_s, 0.0);
    // Contact came before the question, by as long as the surface was felt at least.
    EXPECT_GT(from_contact_s, from_cue_s + 0.3);
    EXPECT_LT(from_contact_s, 60.0);
    EXPECT_EQ(row.at("source"), "keyboard");
  }

  /// The texture whose photograph stands under this key.
  static std::string texture_of(const Scene& scene, std::size_t choice) {
    const std::string picture = scene.choices.at(choice).picture.value_or("");
    const std::size_t from = picture.find('/') + 1;
    return picture.substr(from, picture.find("_photo") - from);
  }
};

TEST_F(WholeSession, SelectsFromTheWelcomePageToTheExportedTable) {
  make_study();
  add_protocol({.flow = R"({"screen": "Welcome."}, {"run": "main"}, {"ask": ["comfort"]},
                           {"screen": "Thank you."})"});
  make_windows();
  click(*window, "welcome_open");
  auto* chooser = window->findChild<QFileDialog*>();
  ASSERT_NE(chooser, nullptr);
  auto& name = child<QLineEdit>(*chooser, "fileNameEdit");
  name.setText(QString::fromStdString(folder().string()));
  QTest::keyClick(&name, Qt::Key_Return);
  wait_for("the study", [&] { return window->study() != nullptr; });
  window->study()->set_device_trial(punctual_trial);
  window->study()->set_servo(patient_servo());

  click_row(*window, "protocols_table", "small");
  click(*window, "protocol_start");
  click(*window, "mode_pilot");  // on the simulated device
  agree();
  press_start();
  std::vector<std::size_t> pressed{};
  take_part([&](const Scene& scene) {
    ASSERT_EQ(scene.choices.size(), 2U);
    pressed.push_back(pressed.size() % 2 == 0 ? 1U : 0U);
    choose(pressed.back() == 1U ? Qt::Key_B : Qt::Key_A);
  });
  ASSERT_EQ(pressed.size(), 2U);
  EXPECT_EQ(stored_session().state, SessionState::completed);
  const std::vector<EventRow> seen = stored_events("consent_seen");
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen.front().text, "consent witnessed by AB");

  const std::filesystem::path tables = export_tables();
  const std::vector<Row> felt = read_exported(tables / "presentations.tsv");
  std::vector<Row> answers = read_exported(tables / "responses.tsv");
  ASSERT_EQ(answers.size(), 3U);
  const auto comfort = std::find_if(answers.begin(), answers.end(),
                                    [](const Row& row) { return row.at("question") == "comfort"; });
  ASSERT_NE(comfort, answers.end());
  EXPECT_EQ(comfort->at("answer"), "well");
  answers.erase(comfort);
  for (std::size_t i = 0; i < pressed.size(); ++i) {
    const std::string trial = std::to_string(i + 1);
    EXPECT_EQ(answers[i].at("trial"), trial);
    expect_reaction_times(answers[i]);
    for (const Row& surface : felt) {
      if (surface.at("trial") != trial) continue;
      if (surface.at("position") != std::to_string(pressed[i] + 1)) continue;
      EXPECT_EQ(answers[i].at("answer"), surface.at("model")) << "trial " << trial;
    }
  }
}

TEST_F(WholeSession, LeavesNothingOfTheParticipantsWindowAndGivesTheFocusBack) {
  make_study();
  add_protocol({.trials = 1});
  open();
  start("small");
  take_part(chooses_a());
  auto* thanks = desk->participant_window()->findChild<QTimer*>("thanks");
  wait_for("the thanks", [&] { return thanks->isActive(); });
  EXPECT_TRUE(desk->participant_window()->isVisible());
  desk->participant_window()->activateWindow();
  wait_for("the focus", [&] {
    return QGuiApplication::focusWindow() == desk->participant_window()->windowHandle();
  });
  thanks->start(1);
  wait_for("its end", [&] { return !desk->participant_window()->isVisible(); });
  wait_for("the experimenter's focus",
           [&] { return QGuiApplication::focusWindow() == experimenter().windowHandle(); });
  for (const Qt::Key late : {Qt::Key_Space, Qt::Key_Return, Qt::Key_A, Qt::Key_F12}) key(late);
  EXPECT_TRUE(child<QLabel>(experimenter(), "end_title").isVisible()) << "no key means anything";
  click(experimenter(), "close");
  EXPECT_EQ(desk->runner(), nullptr);
  EXPECT_EQ(desk->participant_window(), nullptr);
  wait_for("the study's focus",
           [&] { return QGuiApplication::focusWindow() == window->windowHandle(); });
  EXPECT_EQ(stored_session().state, SessionState::completed);
  // What is written beside the store tells no more than the codes do.
  for (const AttemptRow& attempt : stored_attempts()) {
    ASSERT_TRUE(attempt.recording);
    for (const char* const name : {"slate", "cork", "linen", "height_map", "stochastic"}) {
      EXPECT_EQ(attempt.recording->path.find(name), std::string::npos) << attempt.recording->path;
    }
  }
}

TEST_F(WholeSession, MatchesByKeysByClicksAndByDragging) {
  make_study();
  add_protocol({.kind = "matching"});
  open();
  start("small");
  std::vector<std::vector<std::string>> given{};
  const auto wait_until_given = [&](std::size_t picture, const std::string& surface) {
    wait_for("a picture for " + surface,
             [&] { return view().scene().choices.at(picture).assigned_to == surface; });
  };
  take_part([&](const Scene& scene) {
    ASSERT_EQ(scene.choices.size(), 3U);
    wait_for("the pictures", [&] { return view().pictures_are_there(); });
    if (given.empty()) {
      // By keys: A gets 2, B gets 3, C gets 1; then A changes its mind and takes 1, C gets 2.
      key(Qt::Key_2);
      wait_until_given(1, "A");
      key(Qt::Key_3);
      wait_until_given(2, "B");
      key(Qt::Key_1);
      wait_until_given(0, "C");
      key(Qt::Key_A);
      key(Qt::Key_1);
      wait_until_given(0, "A");
      key(Qt::Key_C);
      key(Qt::Key_2);
      wait_until_given(1, "C");
      wait_for("a complete answer", [&] { return view().scene().can_confirm; });
      given.push_back({texture_of(scene, 0), texture_of(scene, 2), texture_of(scene, 1)});
      key(Qt::Key_Return);
      return;
    }
    // By mouse: B is picked and gets 1, C is dragged onto 3, A gets what is left.
    click_item(Item::Kind::chip, "B");
    click_item(Item::Kind::picture, "1");
    wait_until_given(0, "B");
    const QPoint from = place_of(Item::Kind::chip, "C");
    const QPoint onto = place_of(Item::Kind::picture, "3");
    QTest::mousePress(&view(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&view(), (from + onto) / 2);
    QTest::mouseMove(&view(), onto);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, onto);
    wait_until_given(2, "C");
    take_screenshot(experimenter(), "session-live", {1366, 768});
    click_item(Item::Kind::picture, "2");
    wait_until_given(1, "A");
    wait_for("a complete answer", [&] { return view().scene().can_confirm; });
    given.push_back({texture_of(scene, 1), texture_of(scene, 0), texture_of(scene, 2)});
    click_item(Item::Kind::control, "Return");
  });
  ASSERT_EQ(given.size(), 2U);

  const std::vector<Row> answers = read_exported(export_tables() / "responses.tsv");
  ASSERT_EQ(answers.size(), 6U);
  for (const Row& row : answers) {
    const auto trial = std::stoul(row.at("trial")) - 1;
    EXPECT_EQ(row.at("answer"), given.at(trial).at(std::stoul(row.at("item")) - 1));
    EXPECT_EQ(row.at("source"), trial == 0 ? "keyboard" : "mouse");
    EXPECT_GT(std::stod(row.at("from_contact_s")), std::stod(row.at("from_cue_s")));
  }
}

TEST_F(WholeSession, RecognisesAndSaysWhatWasRight) {
  make_study();
  add_protocol({.kind = "recognition"});
  open();
  start("small");
  std::vector<std::string> chosen{};
  take_part([&](const Scene& scene) {
    ASSERT_EQ(scene.choices.size(), 3U);
    chosen.push_back(texture_of(scene, 1));
    choose(Qt::Key_2);
  });
  ASSERT_EQ(chosen.size(), 3U);

  const std::filesystem::path tables = export_tables();
  const std::vector<Row> answers = read_exported(tables / "responses.tsv");
  const std::vector<Row> felt = read_exported(tables / "presentations.tsv");
  ASSERT_EQ(answers.size(), 3U);
  ASSERT_EQ(felt.size(), 3U);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    EXPECT_EQ(answers[i].at("answer"), chosen[i]);
    EXPECT_EQ(answers[i].at("correct"), felt[i].at("texture") == chosen[i] ? "1" : "0");
    expect_reaction_times(answers[i]);
  }
}

}  // namespace
}  // namespace asperity
