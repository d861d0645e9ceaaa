// The pages of a study: what they list, how it sorts, what can be done from there.

#include <fstream>
#include <memory>
#include <string>
#include <utility>

#include <QtCore/QPointer>
#include <QtCore/QRegularExpression>
#include <QtGui/QTextDocumentFragment>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QRadioButton>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QTabWidget>

#include "app/gui/base/open_study.h"
#include "app/gui/base/study_table.h"
#include "app/gui/data/attempt_page.h"
#include "app/gui/editor/protocol_editor_page.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/look/controls.h"
#include "app/gui/participant/participant_view.h"
#include "app/gui/study/devices_page.h"
#include "app/gui/study/participants_page.h"
#include "app/gui/study/protocols_page.h"
#include "app/gui/study/sessions_page.h"
#include "app/gui/study/stimuli_page.h"
#include "app/gui/study/trials_page.h"
#include "app/gui/window/study_window.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/stored_protocol.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/gui/study/quiet_home.h"
#include "tests/gui/support/gated_examination.h"
#include "tests/gui/support/screenshot.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class PagesOfAWindow : public QuietHome {
 protected:
  PagesOfAWindow() {
    window_.resize(1366, 768);
    window_.show();
  }
  static void close_window() { made_.reset(); }

  /// The page is shown and its table filled.
  StudyTable& table_of(const char* page, const char* name, int rows) {
    window_.show_page(page);
    auto& table = child<StudyTable>(window_, name);
    if (!eventually([&] { return table.shown_rows() == rows; })) {
      throw std::runtime_error(std::string(name) + " has " + std::to_string(table.shown_rows()) +
                               " rows");
    }
    return table;
  }
  void click(const char* button) {
    QTest::mouseClick(&child<QPushButton>(window_, button), Qt::LeftButton);
  }
  void choose_theme(const QString& name) {
    for (QAction* action : window_.findChildren<QAction*>()) {
      if (action->text() == name) action->trigger();
    }
  }
  static void press(QWidget& in, const QString& text) {
    for (auto* button : in.findChildren<QPushButton*>()) {
      if (button->text() == text) return QTest::mouseClick(button, Qt::LeftButton);
    }
    ADD_FAILURE() << "no button " << text.toStdString();
  }
  /// Every text of the column has the room that it needs.
  static void expect_whole(const StudyTable& table, int column) {
    constexpr int kPadding = 16;
    for (int row = 0; row < table.shown_rows(); ++row) {
      const QRect cell = table.visualRect(table.model()->index(row, column));
      const QRect room(0, 0, cell.width() - kPadding, 10'000);
      const QRect needed =
          QFontMetrics(table.font())
              .boundingRect(room, Qt::TextWordWrap | Qt::AlignLeft, table.text_at(row, column));
      EXPECT_LE(needed.height(), cell.height())
          << table.text_at(row, column).toStdString() << " in " << cell.width();
    }
  }
  QString texts_on(const char* page) const {
    QStringList texts{};
    for (const auto* label : child<QWidget>(window_, page).findChildren<QLabel*>()) {
      if (label->isVisible()) texts.append(label->text());
    }
    return texts.join(" | ");
  }
  static QStringList column(const StudyTable& table, int column) {
    QStringList texts{};
    for (int row = 0; row < table.shown_rows(); ++row) texts.append(table.text_at(row, column));
    return texts;
  }

  void select_protocol(const char* name) {
    table_of("protocols", "protocols_table", 4)
        .select(QString::fromStdString((window_.study()->folder() / "protocols" / name).string()));
  }

  StudyWindow& window_ = made_ ? *made_ : *(made_ = std::make_unique<StudyWindow>());

 private:
  static inline std::unique_ptr<StudyWindow> made_{};
};

/// Each test has its own window and study.
class StudyPages : public PagesOfAWindow {
 protected:
  ~StudyPages() override { close_window(); }

  void open_demo() { ASSERT_TRUE(window_.open_study(small_demo_study())); }
  void open_lively() { ASSERT_TRUE(window_.open_study(lively_study())); }
};

/// Tests that change nothing of the study, and of the window only what the constructor restores, have one of both.
class PagesToRead : public PagesOfAWindow {
 protected:
  PagesToRead() {
    if (!study_) {
      study_ = std::make_unique<TemporaryFolder>();
      copy(lively_study(), study_->path(), std::filesystem::copy_options::recursive);
      EXPECT_TRUE(window_.open_study(study_->path()));
    }
    window_.show_page("protocols");
    child<QPushButton>(window_, "participants_people").click();
    child<QLineEdit>(window_, "sessions_filter").clear();
    child<StudyTable>(window_, "sessions_table").sortByColumn(5, Qt::DescendingOrder);
  }
  static void TearDownTestSuite() {
    close_window();
    study_.reset();
  }

 private:
  static inline std::unique_ptr<TemporaryFolder> study_{};
};

TEST_F(PagesToRead, ListTheProtocolsOfTheDemoStudyAsValid) {
  const StudyTable& table = table_of("protocols", "protocols_table", 4);
  EXPECT_EQ(column(table, 5).count("✓ valid"), 3);
  const int recognition = static_cast<int>(column(table, 1).indexOf("chapter_recognition"));
  ASSERT_GE(recognition, 0);
  EXPECT_EQ(table.text_at(recognition, 2), "absolute identification");
  EXPECT_EQ(table.text_at(recognition, 3), "1.1.0");
  select_protocol("chapter_recognition.json");
  EXPECT_TRUE(child<QPushButton>(window_, "protocol_start").isEnabled());
  EXPECT_TRUE(child<QLabel>(window_, "protocol_facts").text().contains("trial"));
}

TEST_F(PagesToRead, SelectAProtocolByAClickOnItsTitle) {
  select_protocol("broken.json");
  const StudyTable& table = table_of("protocols", "protocols_table", 4);
  const int row = static_cast<int>(column(table, 1).indexOf("chapter_recognition"));
  const QRect title = table.visualRect(table.model()->index(row, 0));
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, title.center());
  EXPECT_TRUE(table.selected_key().endsWith("/chapter_recognition.json"));
}

TEST_F(StudyPages, EndTheListOfProtocolsBelowAWholeRow) {
  window_.resize(1280, 720);
  window_.show();
  open_lively();
  const StudyTable& table = table_of("protocols", "protocols_table", 4);
  const auto part = [&] {
    const int bottom = table.viewport()->height();
    const int row = table.rowAt(bottom - 1);
    if (row < 0) return 0;  // ground below the last row
    const QRect cell = table.visualRect(table.model()->index(row, 0));
    return cell.bottom() - bottom + 1;
  };
  ASSERT_TRUE(
      eventually([&] { return child<Banner>(window_, "protocols_interrupted").isVisible(); }));
  QTest::qWait(100);  // rows find their height in several rounds of layout
  EXPECT_LE(part(), 0) << "pixels of a row are cut off";
  const int rows = table.rowAt(table.viewport()->height() - 1);
  EXPECT_TRUE(rows < 0 || rows >= 2) << rows;
  // A border that was moved by hand stays where it is.
  auto* both = child<QWidget>(window_, "protocols_page").findChild<QSplitter*>();
  ASSERT_NE(both, nullptr);
  both->setSizes({170, both->height() - 170 - both->handleWidth()});
  emit both->splitterMoved(170, 1);
  window_.resize(1280, 740);
  QTest::qWait(50);
  EXPECT_NEAR(table.height(), 170, 8);
}

TEST_F(PagesToRead, ShowTheProblemsOfABrokenProtocolAndRefuseToStartIt) {
  select_protocol("broken.json");
  const auto& problems = child<StudyTable>(window_, "protocol_problems");
  ASSERT_EQ(problems.shown_rows(), 2);
  EXPECT_TRUE(problems.isVisible());
  EXPECT_TRUE(column(table_of("protocols", "protocols_table", 4), 5).contains("✕ 2 problems"))
      << "the mark that the editor shows next to the same problems";
  for (const auto& [mark, state] : {std::pair("✓", State::fine), {"✕", State::stop}}) {
    const StudyTable& table = table_of("protocols", "protocols_table", 4);
    const auto row =
        static_cast<int>(column(table, 5).indexOf(QRegularExpression(mark + QString(".*"))));
    const QVariant color = table.model()->index(row, 5).data(Qt::ForegroundRole);
    EXPECT_EQ(color.value<QBrush>().color(), color_of(state)) << mark;
  }
  EXPECT_TRUE(problems.text_at(0, 1).contains("stimuli/mteal.png"));
  EXPECT_GT(problems.text_at(0, 0).toInt(), 1);
  EXPECT_FALSE(child<QPushButton>(window_, "protocol_start").isEnabled());
  EXPECT_EQ(child<QLabel>(window_, "protocol_reason").text(),
            "Fix the problems listed below first.");
}

TEST_F(StudyPages, FollowProtocolFilesThatOthersChange) {
  open_demo();
  const StudyTable& table = table_of("protocols", "protocols_table", 3);
  const std::filesystem::path file =
      window_.study()->folder() / "protocols" / "chapter_matching.json";
  std::ofstream(file) << "{\n\"format\": 3";
  EXPECT_TRUE(eventually([&] { return column(table, 5).filter("problem").size() == 1; }));
  std::filesystem::remove(file);
  EXPECT_TRUE(eventually([&] { return table.shown_rows() == 2; }));
}

TEST_F(StudyPages, ShowTheWarningsAboutAValidProtocol) {
  open_demo();
  StudyTable& table = table_of("protocols", "protocols_table", 3);
  const std::filesystem::path file =
      window_.study()->folder() / "protocols" / "chapter_recognition.json";
  std::string text = read_file(file);
  const std::string explorations = R"("explorations": {)";
  text.insert(text.find(explorations) + explorations.size(),
              R"("unused": {"minimum_contact_s": 1},)");
  write_file(file, text, Overwrite::allow);
  EXPECT_TRUE(eventually([&] { return column(table, 5).contains("▲ valid, 1 warning"); }))
      << column(table, 5).join(", ").toStdString();
  table.select(QString::fromStdString(file.string()));
  const QString description = child<QLabel>(window_, "protocol_description").text();
  EXPECT_TRUE(description.startsWith("▲ Line ")) << description.toStdString();
  EXPECT_TRUE(description.contains("no block uses the exploration \"unused\""));
  EXPECT_TRUE(child<QPushButton>(window_, "protocol_start").isEnabled());
}

// The relief of 500 N/m exerts at most 1.5 N, which `check` finds by rendering it.
TEST_F(StudyPages, ShowTheWarningsThatNeedTheStimuli) {
  open_demo();
  StudyTable& table = table_of("protocols", "protocols_table", 3);
  const std::filesystem::path file =
      window_.study()->folder() / "protocols" / "chapter_recognition.json";
  std::string text = read_file(file);
  const std::string target = R"("minimum": 0.3, "target": 1,)";
  ASSERT_NE(text.find(target), std::string::npos);
  text.replace(text.find(target), target.size(), R"("minimum": 0.3, "target": 2,)");
  write_file(file, text, Overwrite::allow);
  EXPECT_TRUE(eventually([&] { return column(table, 5).contains("▲ valid, 1 warning"); }))
      << column(table, 5).join(", ").toStdString();
  table.select(QString::fromStdString(file.string()));
  const QString description = child<QLabel>(window_, "protocol_description").text();
  EXPECT_TRUE(description.startsWith("▲ Line 77: the stimulus")) << description.toStdString();
  EXPECT_TRUE(description.contains("exerts at most 1.50 N")) << description.toStdString();
  EXPECT_TRUE(child<QPushButton>(window_, "protocol_start").isEnabled());
}

TEST_F(StudyPages, ListProtocolsWithoutWaitingForTheirStimuli) {
  open_demo();
  const auto gate = std::make_shared<GatedExamination>();
  window_.study()->examiner().set_examine(examine_through(gate));
  const StudyTable& table = table_of("protocols", "protocols_table", 3);
  ASSERT_TRUE(eventually([&] { return gate->has_begun(1); }));
  EXPECT_EQ(column(table, 5).count("✓ valid"), 3);
  const auto& note = child<QLabel>(window_, "protocols_examining");
  EXPECT_TRUE(note.isVisible());
  EXPECT_EQ(note.text(), "Examining stimuli: 0 of 3");
  const QString selected = table.selected_key();
  ASSERT_FALSE(selected.isEmpty());
  gate->is_open = true;
  EXPECT_TRUE(eventually([&] { return column(table, 5).count("▲ valid, 1 warning") == 3; }))
      << column(table, 5).join(", ").toStdString();
  EXPECT_EQ(table.selected_key(), selected);
  EXPECT_TRUE(child<QLabel>(window_, "protocol_description")
                  .text()
                  .startsWith("▲ Line 1: the gate is open"));
  EXPECT_FALSE(note.isVisible());
  EXPECT_EQ(gate->begun, 3);
  // They are known when the list is read again.
  window_.study()->announce_change();
  QTest::qWait(200);
  EXPECT_EQ(column(table, 5).count("▲ valid, 1 warning"), 3);
  EXPECT_EQ(gate->begun, 3);
}

TEST_F(StudyPages, RefuseToStartAProtocolWhoseStimuliHaveAProblem) {
  open_demo();
  window_.study()->examiner().set_examine([](const Protocol&, const std::stop_token&) {
    return StimulusExamination{.problems = {{.message = "the hand never touches it"}}};
  });
  const StudyTable& table = table_of("protocols", "protocols_table", 3);
  EXPECT_TRUE(eventually([&] { return column(table, 5).count("✕ 1 problem") == 3; }));
  EXPECT_EQ(child<StudyTable>(window_, "protocol_problems").text_at(0, 1),
            "the hand never touches it");
  EXPECT_FALSE(child<QPushButton>(window_, "protocol_start").isEnabled());
}

TEST_F(StudyPages, ExamineNothingForAListThatIsNotShown) {
  open_demo();
  const auto gate = std::make_shared<GatedExamination>();
  window_.study()->examiner().set_examine(examine_through(gate));
  table_of("protocols", "protocols_table", 3);
  ASSERT_TRUE(eventually([&] { return gate->has_begun(1); }));
  window_.show_page("sessions");
  ASSERT_TRUE(eventually([&] { return gate->has_stopped(1); }));
  QTest::qWait(20);
  EXPECT_EQ(gate->begun, 1);
  window_.show_page("protocols");
  EXPECT_TRUE(eventually([&] { return gate->has_begun(2); }));
  close_window();
  EXPECT_TRUE(gate->has_stopped(2));
}

TEST_F(PagesToRead, CountParticipantsDoneOfPlanned) {
  const StudyTable& table = table_of("protocols", "protocols_table", 4);
  EXPECT_TRUE(column(table, 4).contains("10 of 20")) << column(table, 4).join(", ").toStdString();
}

TEST_F(StudyPages, NeverCutTheTitleOfAProtocol) {
  open_demo();
  window_.resize(1000, 640);
  StudyTable& table = table_of("protocols", "protocols_table", 3);
  for (const char* const larger : {"", "large text"}) {
    if (*larger != 0) {
      QFont font = table.font();
      font.setPointSizeF(1.5 * font.pointSizeF());
      table.setFont(font);
      table.resizeRowsToContents();
    }
    expect_whole(table, 0);
  }
}

// The room of a laptop with 1366 x 768 pixels at 150 %.
TEST_F(StudyPages, CutNoTitleAndNoActionOfAProtocolOnASmallScreen) {
  open_demo();
  window_.resize(895, 464);
  StudyTable& table = table_of("protocols", "protocols_table", 3);
  expect_whole(table, 0);
  EXPECT_GE(table.columnWidth(0), 250);
  for (const char* const name :
       {"protocol_start", "protocol_edit", "protocol_preview", "protocol_simulate",
        "protocol_simulate_several", "protocol_by_mouse", "protocol_more"}) {
    const auto& button = child<QPushButton>(window_, name);
    EXPECT_TRUE(eventually([&] { return button.width() >= button.sizeHint().width(); }))
        << name << ": " << button.width() << " of " << button.sizeHint().width();
  }
  // A lower button at the end of a row does not cut the others.
  window_.resize(1280, 720);
  const auto& last = child<QPushButton>(window_, "protocol_more");
  EXPECT_TRUE(eventually([&] { return last.visibleRegion().boundingRect() == last.rect(); }))
      << last.visibleRegion().boundingRect().height() << " of " << last.height();
}

TEST_F(StudyPages, DuplicateRenameAndDeleteAProtocolThatWasNeverRun) {
  open_demo();
  const StudyTable& table = table_of("protocols", "protocols_table", 3);
  const auto act = [this](const char* name) {
    child<QPushButton>(window_, "protocol_more").menu()->findChild<QAction*>(name)->trigger();
  };
  const QString first = table.selected_key();
  act("protocol_duplicate");
  ASSERT_TRUE(eventually([&] { return table.shown_rows() == 4; }));
  EXPECT_EQ(table.selected_key().toStdString(),
            QString(first).replace(".json", "_2.json").toStdString());

  act("protocol_rename");
  auto& name = child<QLineEdit>(window_, "protocol_file_name");
  ASSERT_TRUE(eventually([&] { return name.isVisible(); }));
  name.setText("No name");
  click("protocol_file_act");
  ASSERT_TRUE(
      eventually([&] { return texts_on("protocols_page").contains("cannot be the name"); }));
  name.setText("mine");
  click("protocol_file_act");
  ASSERT_TRUE(eventually([&] { return column(table, 1).contains("mine"); }));
  EXPECT_TRUE(table.selected_key().endsWith("/mine.json"));
  EXPECT_FALSE(name.isVisible());

  act("protocol_delete");
  auto& really = child<QPushButton>(window_, "protocol_file_act");
  ASSERT_TRUE(eventually([&] { return really.isVisible(); }));
  EXPECT_FALSE(name.isVisible());
  // Return does not delete: the file cannot be restored.
  const auto& cancel = child<QPushButton>(window_, "protocol_file_cancel");
  EXPECT_EQ(window_.focusWidget(), &cancel);
  QTest::keyClick(window_.focusWidget(), Qt::Key_Return);
  EXPECT_TRUE(eventually([&] { return !really.isVisible(); }));
  EXPECT_EQ(table.shown_rows(), 4);
  act("protocol_delete");
  ASSERT_TRUE(eventually([&] { return really.isVisible(); }));
  really.click();
  EXPECT_TRUE(eventually([&] { return table.shown_rows() == 3; }));
}

TEST_F(PagesToRead, SayWhyAProtocolThatWasRunIsNeitherRenamedNorDeleted) {
  select_protocol("chapter_recognition.json");
  for (const char* const action : {"protocol_rename", "protocol_delete"}) {
    child<QPushButton>(window_, "protocol_more").menu()->findChild<QAction*>(action)->trigger();
    EXPECT_TRUE(eventually([&] {
      return texts_on("protocols_page")
          .contains("chapter_recognition.json has been run (12 sessions)");
    }));
    EXPECT_FALSE(child<QPushButton>(window_, "protocol_file_act").isVisible());
  }
  EXPECT_TRUE(std::filesystem::exists(window_.study()->folder() / "protocols" /
                                      "chapter_recognition.json"));
}

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
  ASSERT_TRUE(eventually([&] { return templates.shown_rows() == 25; }));
  auto& own = child<QRadioButton>(dialog, "template_own");
  const auto& copied = child<QRadioButton>(dialog, "template_copied");
  const auto state = [&] {
    const QString html = child<QLabel>(dialog, "template_state").text();
    return QTextDocumentFragment::fromHtml(html).toPlainText().simplified();
  };
  const auto& create = child<QPushButton>(dialog, "template_create");
  const auto shows = [&](const char* start) {
    return eventually([&] { return state().startsWith(start); });
  };
  constexpr const char* kValid = "✓ With these textures the protocol is valid.";
  constexpr const char* kProblem = "▲ With these textures the protocol has ";

  templates.select("chapter_selection");
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(own.isChecked());
  tick_only(dialog, {});
  EXPECT_FALSE(child<QLabel>(dialog, "template_state").isVisibleTo(&dialog));
  EXPECT_FALSE(create.isEnabled());

  // One of its models renders recordings, of which the template has one for its own texture.
  templates.select("map_of_renderings");
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(copied.isChecked());
  own.click();
  EXPECT_TRUE(shows(kProblem)) << state().toStdString();
  EXPECT_TRUE(state().contains("the asset \"recording\"")) << state().toStdString();
  EXPECT_TRUE(state().contains(": Surfaces › ")) << "the page of the form, not /textures";
  EXPECT_TRUE(create.isEnabled()) << "it can be corrected in the form";
  take_screenshot(dialog, "template-dialog-problem", {1120, 700});

  templates.select("roughness_force");
  EXPECT_TRUE(shows(kValid)) << state().toStdString();
  EXPECT_TRUE(own.isChecked());
  tick_only(dialog, {"brick"});
  EXPECT_TRUE(shows(kProblem)) << state().toStdString();
  EXPECT_TRUE(create.isEnabled());

  // Closing does not wait for the check that runs.
  const QPointer<QDialog> closed(&dialog);
  templates.select("map_of_renderings");
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
  ASSERT_TRUE(eventually([&] { return templates.shown_rows() == 25; }));
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

TEST_F(StudyPages, ReportAnInterruptedSessionAndOfferToResumeIt) {
  open_lively();
  auto& banner = child<Banner>(window_, "protocols_interrupted");
  ASSERT_TRUE(eventually([&] { return banner.isVisible(); }));
  EXPECT_EQ(banner.text(),
            "Session 1 of P012 was interrupted; trials completed and stored: 3 of 12.");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  press(banner, "Resume session 1 of P012");
  ASSERT_EQ(wanted.count(), 1);
  const auto wish = wanted[0][0].value<SessionWish>();
  EXPECT_EQ(wish.participant, "P012");
  EXPECT_EQ(wish.protocol.filename(), "chapter_recognition.json");
  EXPECT_EQ(Study::open(window_.study()->folder(), Access::read_only).session(*wish.session).state,
            SessionState::crashed);
  EXPECT_FALSE(banner.isVisible());
  window_.study()->announce_change();
  table_of("sessions", "sessions_table", 15);
  table_of("protocols", "protocols_table", 4);
  EXPECT_FALSE(banner.isVisible()) << "reported once only";
}

TEST_F(StudyPages, ReportAnInterruptedSessionOnTheWelcomePage) {
  open_lively();
  const std::filesystem::path folder = window_.study()->folder();
  window_.close_study();
  auto& banner = child<Banner>(window_, "welcome_interrupted");
  ASSERT_TRUE(eventually([&] { return banner.isVisible(); }));
  EXPECT_TRUE(banner.text().startsWith("Session 1 of P012 in the study “demo” was interrupted;"))
      << banner.text().toStdString();
  EXPECT_TRUE(child<QLabel>(window_, "welcome_versions")
                  .text()
                  .endsWith(". Before 1.0.0, finish a study with the version that began it; the "
                            "package of each version stays available."))
      << child<QLabel>(window_, "welcome_versions").text().toStdString();
  window_.resize(1280, 720);
  const auto cut = [&]() -> std::string {
    for (const auto* label : child<QWidget>(window_, "welcome_page").findChildren<QLabel*>()) {
      if (!label->isVisible() || label->text().isEmpty()) continue;
      if (label->height() < label->heightForWidth(label->width()))
        return label->text().toStdString();
    }
    return {};
  };
  EXPECT_TRUE(eventually([&] { return cut().empty(); })) << cut();
  take_screenshot(window_, "study-welcome-interrupted");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  press(banner, "Resume session 1 of P012");
  ASSERT_NE(window_.study(), nullptr);
  EXPECT_EQ(window_.study()->folder(), folder);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted[0][0].value<SessionWish>().participant, "P012");
}

TEST_F(StudyPages, ShowAnInterruptedSessionThatCannotBeResumed) {
  const std::filesystem::path folder = lively_study();
  std::ofstream(folder / "protocols" / "chapter_recognition.json", std::ios::app) << "\n";
  ASSERT_TRUE(window_.open_study(folder));
  auto& banner = child<Banner>(window_, "protocols_interrupted");
  ASSERT_TRUE(eventually([&] { return banner.isVisible(); }));
  EXPECT_TRUE(banner.text().contains("restore chapter_recognition version 1.1.0 to resume"))
      << banner.text().toStdString();
  press(banner, "Show the sessions");
  EXPECT_EQ(window_.shown_page(), "sessions");
}

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

TEST_F(PagesToRead, SayWhichProtocolAPersonWantsToRun) {
  select_protocol("chapter_recognition.json");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  click("protocol_start");
  ASSERT_EQ(wanted.count(), 1);
  const auto wish = wanted[0][0].value<SessionWish>();
  EXPECT_EQ(wish.protocol.parent_path(), window_.study()->folder() / "protocols");
  EXPECT_FALSE(wish.participant);
  EXPECT_FALSE(wish.session);
}

TEST_F(PagesToRead, PreviewThePlanStepByStep) {
  select_protocol("chapter_recognition.json");
  click("protocol_preview");
  auto* page = window_.findChild<ProtocolsPage*>();  // the editor shows a plan as well
  const auto& plan = child<StudyTable>(*page, "plan_table");
  ASSERT_TRUE(eventually([&] { return plan.shown_rows() > 10; }));
  EXPECT_TRUE(column(plan, 2).contains("screen"));
  const QStringList before = column(plan, 3);
  QTest::mouseClick(&child<QPushButton>(*page, "plan_another"), Qt::LeftButton);
  EXPECT_TRUE(eventually([&] { return column(plan, 3) != before; }));
  take_screenshot(window_, "study-plan");
}

TEST_F(StudyPages, EditAProtocolInTheWindowAndLoseNothingOfIt) {
  open_demo();
  StudyTable& table = table_of("protocols", "protocols_table", 3);
  const QString file = QString::fromStdString(
      (window_.study()->folder() / "protocols" / "chapter_recognition.json").string());
  table.select(file);
  click("protocol_edit");
  EXPECT_EQ(window_.shown_page(), "editor");
  auto* editor = window_.findChild<ProtocolEditorPage*>();
  EXPECT_EQ(QString::fromStdString(editor->file().string()), file);
  ASSERT_TRUE(eventually([&] { return editor->is_checked(); }));
  auto& plan = child<StudyTable>(*editor, "plan_table");
  ASSERT_TRUE(eventually([&] { return plan.shown_rows() > 10; }));
  take_screenshot(window_, "study-editor");

  auto& pages = child<QListWidget>(window_, "navigation");
  QTest::mouseClick(pages.viewport(), Qt::LeftButton, {},
                    pages.visualItemRect(pages.item(0)).center());
  EXPECT_EQ(window_.shown_page(), "protocols");
  click("protocol_edit");
  EXPECT_EQ(window_.shown_page(), "editor");

  QTest::keyClicks(&child<ProtocolTextEdit>(*editor, "editor_text"), "  ");
  window_.show_page("sessions");
  window_.close();
  EXPECT_TRUE(window_.isVisible());
  EXPECT_EQ(window_.shown_page(), "editor");
  click("editor_leave_stay");
  choose_theme("&Dark");
  EXPECT_FALSE(theme().dark);
  EXPECT_EQ(window_.findChild<ProtocolEditorPage*>(), editor);
  click("editor_leave_save");
  ASSERT_TRUE(eventually([&] { return theme().dark; }));
  ASSERT_TRUE(eventually([&] {
    editor = window_.findChild<ProtocolEditorPage*>();
    return editor != nullptr && editor->is_checked() && !editor->file().empty();
  }));
  EXPECT_EQ(editor->content().substr(0, 3), "  {");
  EXPECT_EQ(window_.shown_page(), "editor");
  apply_theme(*qobject_cast<QApplication*>(QCoreApplication::instance()), ThemeChoice::light);

  QTest::keyClicks(&child<ProtocolTextEdit>(*editor, "editor_text"), "  ");
  window_.close();
  EXPECT_TRUE(window_.isVisible());
  click("editor_leave_discard");
  EXPECT_TRUE(eventually([&] { return !window_.isVisible(); }));
}

TEST_F(PagesToRead, SayWhichProtocolIsToBeSimulated) {
  select_protocol("chapter_recognition.json");
  QSignalSpy wanted(&window_, &StudyWindow::session_wanted);
  click("protocol_simulate");
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(wanted[0][0].value<SessionWish>().simulate);
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

TEST_F(StudyPages, ShowStimuliWithWhatUsesThem) {
  open_demo();
  const StudyTable& table = table_of("stimuli", "stimuli_table", 16);
  // Where "brick_photo.png" stands is for the locale to say.
  const int brick = static_cast<int>(column(table, 0).indexOf("brick.png"));
  const int photo = static_cast<int>(column(table, 0).indexOf("brick_photo.png"));
  ASSERT_GE(brick, 0);
  ASSERT_GE(photo, 0);
  EXPECT_EQ(table.text_at(brick, 1), "height field (photograph)");
  EXPECT_EQ(table.text_at(brick, 2), "100 × 100");
  EXPECT_EQ(table.text_at(brick, 3), "64 × 64");
  EXPECT_TRUE(table.text_at(brick, 6).contains("chapter_recognition"));
  EXPECT_EQ(table.text_at(photo, 1), "picture");
  for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
    window_.resize(size);
    EXPECT_TRUE(eventually([&] { return cut_cells(table).isEmpty(); }))
        << size.width() << ": " << cut_cells(table).join(" | ").toStdString();
  }
  std::filesystem::remove(window_.study()->folder() / "stimuli" / "brick.png");
  EXPECT_TRUE(eventually([&] { return table.shown_rows() == 15; }));
}

TEST_F(StudyPages, ShowTheBodiesOfProtocolsWithAPicture) {
  open_demo();
  std::string protocol{};
  for (const LibraryProtocol& each : library_protocols()) {
    if (each.name == "tools_matching") protocol = each.text;
  }
  const std::pair<std::string, std::string> reliefs[] = {{"file_fine", "metal"},
                                                         {"file_medium", "stone"},
                                                         {"file_coarse", "wood"},
                                                         {"file_plate", "brick"}};
  for (const auto& [theirs, ours] : reliefs) {
    for (std::size_t at = 0; (at = protocol.find(theirs)) != std::string::npos;) {
      protocol.replace(at, theirs.size(), ours);
    }
  }
  write_file(window_.study()->folder() / "protocols" / "tools.json", protocol, Overwrite::refuse);
  const StudyTable& table = table_of("stimuli", "stimuli_table", 20);
  const auto row_of = [&table](const QString& name) {
    int row = 0;
    while (row < table.shown_rows() && table.text_at(row, 0) != name) ++row;
    return row;
  };
  const int fine = row_of("fine");
  ASSERT_LT(fine, 20);
  EXPECT_TRUE(table.text_at(fine, 1).startsWith("cylinder of "));
  EXPECT_EQ(table.text_at(fine, 2), "7.64 × 8 × 7.64");
  EXPECT_EQ(table.text_at(fine, 6), "tools_matching");
  EXPECT_TRUE(table.text_at(row_of("studded_plate"), 1).startsWith("plate of "));
  const QIcon icon = table.model()->index(fine, 0).data(Qt::DecorationRole).value<QIcon>();
  const QImage picture = icon.pixmap(72, 72).toImage();
  // The body in the middle, nothing around it.
  EXPECT_GT(picture.pixelColor(picture.width() / 2, picture.height() / 2).alpha(), 200);
  EXPECT_EQ(picture.pixelColor(1, 1).alpha(), 0);
  take_screenshot(window_, "study-stimuli-bodies");
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

/// A survey of two drivers: one of a device that is not set up yet, one without its maker's library.
std::vector<SurveyedDriver> found_devices(bool has_firmware) {
  AttachedDevice falcon{.model = "Novint Falcon", .serial = "A7", .place = "usb 1-2"};
  if (!has_firmware) falcon.blocker = "Name the file of its firmware.";
  return {{.id = "simulated", .summary = "no participant feels it"},
          {.id = "falcon", .summary = "over USB", .survey = {.attached = {falcon}}},
          {.id = "openhaptics",
           .survey = {.blocker = "OpenHaptics is not installed. Name it with --library FILE."}}};
}

TEST_F(PagesToRead, SayOfEveryDeviceWhatWouldMakeItUsableAndLookAgain) {
  bool has_firmware = false;
  DevicesPage page(
      *window_.study(),
      [&has_firmware](const std::stop_token&) { return found_devices(has_firmware); }, nullptr);
  QSignalSpy counted(&page, &StudyPage::counted);
  EXPECT_EQ(counted.size(), 0) << "nobody has looked at it yet";
  page.show();
  const auto texts_of = [&page](const char* card) {
    QString texts{};
    const auto* found = page.findChild<QFrame*>(card);
    if (found == nullptr) return texts;
    for (const QLabel* label : found->findChildren<QLabel*>()) texts += label->text() + "|";
    return texts;
  };
  ASSERT_TRUE(eventually([&] { return counted.size() == 1; }));
  EXPECT_EQ(page.count(), "1 ready");
  EXPECT_TRUE(texts_of("device_falcon").contains("Novint Falcon, serial number A7, at usb 1-2"));
  EXPECT_TRUE(texts_of("device_falcon").contains("Name the file of its firmware."));
  EXPECT_TRUE(texts_of("device_falcon").contains("not usable yet"));
  // What is attached stands above what only stands for it, and is reached first.
  const auto* falcon = page.findChild<QFrame*>("device_falcon");
  const auto* models = page.findChild<QFrame*>("device_models");
  ASSERT_TRUE(falcon != nullptr && models != nullptr);
  EXPECT_LT(falcon->mapTo(&page, QPoint(0, 0)).y(), models->mapTo(&page, QPoint(0, 0)).y());
  const QWidget* at = falcon->findChildren<QPushButton*>().value(0);
  ASSERT_NE(at, nullptr);
  while (!models->isAncestorOf(at)) {
    at = at->nextInFocusChain();
    ASSERT_NE(at->objectName(), "devices_look") << "once around";
  }
  const auto* udev = page.findChild<QLabel*>("devices_udev");
  ASSERT_NE(udev, nullptr);
  EXPECT_TRUE(udev->text().contains(QString::fromStdString(missing_udev_rule().english())));
  EXPECT_EQ(udev->isVisibleTo(&page), !missing_udev_rule().empty());
  EXPECT_TRUE(texts_of("device_openhaptics").contains("Name it with “Set up…”."))
      << "the window's own control, and no option of a command";
  EXPECT_EQ(page.findChild<QFrame*>("device_simulated"), nullptr) << "it has its card already";
  EXPECT_TRUE(texts_of("device_models").contains("delta.3"));
  TestedDevice wanted{};
  QObject::connect(&page, &DevicesPage::test_wanted,
                   [&wanted](const TestedDevice& device) { wanted = device; });
  page.findChild<QPushButton*>("device_test_simulated:falcon")->click();
  EXPECT_EQ(wanted.device, "simulated:falcon");
  EXPECT_EQ(wanted.which.model, "in place of Novint Falcon") << "whose profiles it has";
  EXPECT_TRUE(wanted.is_simulated);

  has_firmware = true;
  page.findChild<QPushButton*>("devices_look")->click();
  ASSERT_TRUE(eventually([&] { return counted.size() == 2; }));
  EXPECT_EQ(page.count(), "2 ready");
  EXPECT_FALSE(texts_of("device_falcon").contains("firmware"));
  EXPECT_TRUE(texts_of("device_falcon").contains("1 ready"));
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
