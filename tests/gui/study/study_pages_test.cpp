// The pages of a study: what they have in common, and the templates of its protocols.

#include <cstdint>

#include <QtCore/QPointer>
#include <QtCore/QRegularExpression>
#include <QtGui/QTextDocumentFragment>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>

#include "app/gui/base/open_study.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/data/attempt_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/participant/participant_view.h"
#include "app/gui/study/trials_page.h"
#include "protocols/file/stored_protocol.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/gui/study/pages_of_a_window.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

void tick_only(QDialog& template_dialog, const QStringList& textures) {
  auto& reliefs = child<QListWidget>(template_dialog, "template_reliefs");
  for (int i = 0; i < reliefs.count(); ++i) {
    const bool is_ticked = textures.contains(reliefs.item(i)->text());
    reliefs.item(i)->setCheckState(is_ticked ? Qt::Checked : Qt::Unchecked);
  }
}

TEST_F(StudyPages, ReportTheProblemsOfATemplateWithTheChosenTextures) {
  open_demo();
  table_of("protocols", "protocols_table", 3);
  child<QPushButton>(window_, "protocols_new").click();
  auto& dialog = child<QDialog>(window_, "template_dialog");
  auto& templates = child<StudyTable>(dialog, "template_table");
  ASSERT_TRUE(eventually([&] { return templates.shown_rows() == 26; }));
  const auto& own = child<QRadioButton>(dialog, "template_own");
  auto& copied = child<QRadioButton>(dialog, "template_copied");
  const auto state = [&] {
    const QString html = child<QLabel>(dialog, "template_state").text();
    return QTextDocumentFragment::fromHtml(html).toPlainText().simplified();
  };
  const auto& create = child<QPushButton>(dialog, "template_create");
  const auto shows = [&](const char* start) {
    return eventually([&] { return state().startsWith(start); });
  };
  constexpr const char* kValid = "✓ With these textures the protocol is valid: ";
  constexpr const char* kProblem = "▲ With these textures the protocol has ";

  templates.select("chapter_selection");
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(own.isChecked());
  tick_only(dialog, {});
  EXPECT_FALSE(child<QLabel>(dialog, "template_state").isVisibleTo(&dialog));
  EXPECT_FALSE(create.isEnabled());

  // A matching needs as many surfaces as pictures, and the template has four.
  templates.select("improved_matching");
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(own.isChecked());
  tick_only(dialog, {"brick"});
  EXPECT_TRUE(shows(kProblem)) << state().toStdString();
  EXPECT_TRUE(state().contains(": Task › ")) << "the page of the form, not /blocks";
  EXPECT_TRUE(create.isEnabled()) << "it can be corrected in the form";
  take_screenshot(dialog, "template-dialog-problem", {1120, 700});

  copied.click();
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(create.isEnabled());

  templates.select("map_of_textures");
  EXPECT_TRUE(shows("▲ With these textures the protocol is valid: ")) << state().toStdString();
  EXPECT_TRUE(state().contains("requires at least 9 surfaces")) << state().toStdString();

  templates.select("roughness_force");
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(own.isChecked());
  child<QComboBox>(dialog, "template_language").setCurrentText("Deutsch");
  EXPECT_FALSE(create.isEnabled()) << "that was about another language";
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(own.isChecked());
  EXPECT_TRUE(state().contains("45 trials, about 14 min.")) << state().toStdString();
  const auto& list = child<QListWidget>(dialog, "template_reliefs");
  const int place = list.mapTo(&dialog, QPoint()).y();
  tick_only(dialog, {"brick"});
  EXPECT_TRUE(shows(kProblem)) << state().toStdString();
  EXPECT_TRUE(create.isEnabled());
  tick_only(dialog, {"brick", "metal"});
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(state().contains("25 trials, about 12 min.")) << state().toStdString();
  EXPECT_EQ(list.mapTo(&dialog, QPoint()).y(), place) << "the next click hits what it aims at";

  // Closing does not wait for the check that runs.
  const QPointer<QDialog> closed(&dialog);
  templates.select("improved_matching");
  dialog.reject();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  ASSERT_FALSE(closed.isNull());
  EXPECT_FALSE(closed->isVisible());
  EXPECT_TRUE(eventually([&] { return closed.isNull(); }));
}

TEST_F(StudyPages, PutATemplateIntoTheStudyUnderAFreeName) {
  open_demo();
  const StudyTable& table = table_of("protocols", "protocols_table", 3);
  child<QPushButton>(window_, "protocols_new").click();
  auto& dialog = child<QDialog>(window_, "template_dialog");
  auto& templates = child<StudyTable>(dialog, "template_table");
  ASSERT_TRUE(eventually([&] { return templates.shown_rows() == 26; }));
  EXPECT_FALSE(child<QPushButton>(dialog, "template_create").isEnabled());
  templates.select("chapter_selection");
  EXPECT_EQ(child<QLabel>(dialog, "template_needs").text(), "This template compares 4 textures.");
  auto& language = child<QComboBox>(dialog, "template_language");
  EXPECT_EQ(language.currentText(), "English") << "that of the windows";
  language.setCurrentText("Deutsch");
  EXPECT_EQ(child<QLabel>(dialog, "template_title").text(),
            "Welche Wiedergabe ist die realistischste?");
  auto& title = child<QLineEdit>(dialog, "template_own_title");
  EXPECT_EQ(title.text(), "Welche Wiedergabe ist die realistischste?");
  using Scene = ParticipantScene::Kind;
  const auto& screen = child<ParticipantView>(dialog, "screen_view");
  ASSERT_TRUE(eventually([&] { return screen.scene().kind == Scene::feel; }))
      << "the first trial, not the welcome";
  const auto& words = child<QLabel>(dialog, "screen_words");
  const QRegularExpression last_of_trial("screen (\\d+) of \\1$");
  for (int i = 0; i < 10 && !words.text().contains(last_of_trial); ++i) {
    child<QPushButton>(dialog, "screen_next").click();
  }
  ASSERT_TRUE(eventually([&] { return screen.scene().kind == Scene::question; }));
  EXPECT_EQ(screen.scene().text,
            "Welche Oberfläche hat sich am ehesten wie das Material auf dem Bild angefühlt?");
  take_screenshot(dialog, "template-dialog", {1120, 700});
  take_screenshot(dialog, "template-dialog-small", {910, 512});
  child<QRadioButton>(dialog, "template_own").click();
  tick_only(dialog, {});
  tick_only(dialog, {"brick", "metal", "stone", "wood"});
  EXPECT_FALSE(child<QPushButton>(dialog, "template_create").isEnabled()) << "not checked yet";
  title.selectAll();
  QTest::keyClicks(&title, " ");
  EXPECT_EQ(child<QLabel>(dialog, "template_what_follows").text(), "Write a title.");
  QTest::keyClicks(&title, "Meine Texturen");
  templates.select("roughness_force");
  EXPECT_NE(title.text(), " Meine Texturen");
  templates.select("chapter_selection");
  EXPECT_EQ(title.text(), " Meine Texturen") << "that of this template";
  ASSERT_TRUE(
      eventually([&] { return child<QPushButton>(dialog, "template_create").isEnabled(); }));
  language.setCurrentText("English");
  language.setCurrentText("Deutsch");
  ASSERT_TRUE(
      eventually([&] { return child<QPushButton>(dialog, "template_create").isEnabled(); }));
  child<QPushButton>(dialog, "template_create").click();
  ASSERT_TRUE(eventually([&] { return table.shown_rows() == 4; }));
  const std::filesystem::path made = table.selected_key().toStdString();
  EXPECT_EQ(made.filename(), "chapter_selection_2.json");
  const std::string written = read_file(made, kProtocolFile);
  EXPECT_EQ(language_of(written), "de");
  EXPECT_EQ(stored_protocol(written).protocol.title, "Meine Texturen")
      << "also in another language";
  EXPECT_EQ(column(table, 5).filter("valid").size(), 4);
  EXPECT_TRUE(column(table, 1).contains("chapter_selection_2"));
}

/// In German, whose words are longer, the details are not wider than the smallest window leaves them.
TEST_F(StudyPages, ShowATemplateInASmallWindow) {
  apply_language("de");
  open_demo();
  table_of("protocols", "protocols_table", 3);
  child<QPushButton>(window_, "protocols_new").click();
  auto& dialog = child<QDialog>(window_, "template_dialog");
  dialog.resize(910, 512);
  auto& templates = child<StudyTable>(dialog, "template_table");
  ASSERT_TRUE(eventually([&] { return templates.shown_rows() == 26; }));
  const auto& details = child<QScrollArea>(dialog, "template_details");
  for (int row = 0; row < templates.shown_rows(); ++row) {
    templates.selectRow(row);
    QCoreApplication::processEvents();
    EXPECT_EQ(details.horizontalScrollBar()->maximum(), 0)
        << templates.selected_key().toStdString();
  }
  templates.select("chapter_selection");
  EXPECT_TRUE(
      eventually([&] { return child<QPushButton>(dialog, "template_create").isEnabled(); }));
  take_screenshot(dialog, "german-template-dialog-small", {910, 512});
  apply_language("en");
}

TEST_F(PagesToRead, CountInTheNavigation) {
  auto& navigation = child<QListWidget>(window_, "navigation");
  const auto texts = [&] {
    QStringList all{};
    for (int row = 0; row < navigation.count(); ++row) {
      all.append(navigation.item(row)->data(Qt::AccessibleTextRole).toString());
    }
    return all;
  };
  EXPECT_TRUE(eventually([&] {
    return texts().contains("Participants 12") && texts().contains("Sessions 13") &&
           texts().contains("Stimuli 10") && texts().contains("Devices 1 ready");
  })) << texts().join(", ").toStdString();
}

TEST_F(StudyPages, SayWhatToDoWhereThereIsNothing) {
  Study::create(home() / "empty", "empty");
  ASSERT_TRUE(window_.open_study(home() / "empty"));
  for (const char* key : {"protocols", "participants", "sessions", "stimuli"}) {
    window_.show_page(key);
    QWidget* page = window_.page(key);
    EXPECT_TRUE(eventually([&] {
      const auto* empty = page->findChild<EmptyState*>();
      return empty != nullptr && empty->isVisible();
    })) << key;
  }
}

TEST_F(StudyPages, StayWithTheStudyAndTheAttemptWhenTheThemeChanges) {
  open_lively();
  const Study& study = window_.study()->study();
  const SessionRow session = study.sessions().at(0);
  const std::int64_t id = study.attempts(session.id).at(0).id;
  qobject_cast<TrialsPage*>(window_.page("trials"))->show_session(session.id);
  qobject_cast<AttemptPage*>(window_.page("attempt"))->show_attempt(id);
  window_.show_page("attempt");
  const auto summary = [this] {
    return child<QLabel>(*window_.page("attempt"), "attempt_summary").text();
  };
  ASSERT_TRUE(eventually([&] { return !summary().isEmpty(); }));
  const QString shown = summary();
  QPointer<QWidget> before = window_.page("attempt");
  choose_theme("&Dark");
  ASSERT_TRUE(eventually([&before] { return before.isNull(); })) << "its pages are made anew";
  ASSERT_TRUE(theme().dark);
  EXPECT_TRUE(eventually([&] { return summary() == shown; }));
  EXPECT_EQ(window_.shown_page(), "attempt");
  EXPECT_EQ(qobject_cast<TrialsPage*>(window_.page("trials"))->session(), session.id);
  EXPECT_EQ(child<QLabel>(*window_.page("attempt"), "attempt_names").isVisible(),
            session.state != SessionState::completed);

  table_of("sessions", "sessions_table", 15);
  take_screenshot(window_, "study-sessions-dark");
  before = window_.page("sessions");
  choose_theme("&Light");
  ASSERT_TRUE(eventually([&before] { return before.isNull(); }));
  ASSERT_FALSE(theme().dark);
  EXPECT_EQ(window_.shown_page(), "sessions");
  table_of("sessions", "sessions_table", 15);
}

TEST_F(StudyPages, Pictures) {
  if (qEnvironmentVariableIsEmpty("ASPERITY_SCREENSHOTS")) GTEST_SKIP() << "no folder for pictures";
  open_lively();
  table_of("protocols", "protocols_table", 4);
  take_screenshot(window_, "study-protocols");
  select_protocol("broken.json");
  take_screenshot(window_, "study-protocol-problems");
  table_of("participants", "participants_table", 12);
  take_screenshot(window_, "study-participants");
  table_of("sessions", "sessions_table", 15).selectRow(0);
  take_screenshot(window_, "study-sessions");
  table_of("stimuli", "stimuli_table", 16);
  take_screenshot(window_, "study-stimuli");
  window_.show_page("devices");
  const auto* look = window_.page("devices")->findChild<QPushButton*>("devices_look");
  ASSERT_TRUE(eventually([look] { return look->isEnabled(); }));
  take_screenshot(window_, "study-devices");
  Study::create(home() / "empty", "empty");
  window_.open_study(home() / "empty");
  QTest::qWait(100);
  take_screenshot(window_, "study-empty");
}

}  // namespace
}  // namespace asperity
