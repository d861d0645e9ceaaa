// The protocols of a study: what their list shows, and how much of it.

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <utility>

#include <QtCore/QRegularExpression>
#include <QtTest/QTest>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QSplitter>

#include "app/gui/base/open_study.h"
#include "app/gui/base/settings.h"
#include "app/gui/base/study_table.h"
#include "app/gui/look/controls.h"
#include "app/gui/study/protocol_texts.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/gui/editor/library_text.h"
#include "tests/gui/study/pages_of_a_window.h"
#include "tests/gui/support/gated_examination.h"
#include "tests/gui/support/screenshot.h"

namespace asperity {
namespace {

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

TEST(DescriptionOfAProtocol, StatesTheDesignsOfBlocksInTheLanguageOfTheWindows) {
  ProtocolOverview overview{};
  overview.check = check_protocol_text(library_text("amplitude_jnd"), "amplitude_jnd.json",
                                       built_in_models(), std::nullopt, std::nullopt);
  apply_language("de");
  const QString german = description_of(overview);
  apply_language("en");
  EXPECT_TRUE(german.contains(
      "2IFC-Aufgabe, eine Oberfläche nach der anderen, 3-down/1-up-Treppenverfahren (79,4 %), "
      "40 Durchgänge × 2 verschränkte Folgen (Tracks), ein Kontrolldurchgang je"))
      << german.toStdString();
  EXPECT_TRUE(german.contains("; Standardfehler der log10-Schwelle mindestens 0,"))
      << german.toStdString();
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

// The table has fewer rows where the card of the selected protocol needs more room.
TEST_F(StudyPages, KeepTheSelectedProtocolInSight) {
  window_.resize(1280, 720);
  window_.show();
  open_lively();
  StudyTable& table = table_of("protocols", "protocols_table", 4);
  constexpr int kMoment_ms = 50;
  for (const bool is_planned : {false, true}) {
    for (int row = 0; row < 4; ++row) {
      const QModelIndex cell = table.model()->index(row, 0);
      table.scrollTo(cell);
      QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(cell).center());
      QTest::qWait(kMoment_ms);
      const QModelIndex now = table.model()->index(row, 0);  // the page may have been filled again
      EXPECT_TRUE(table.selectionModel()->isSelected(now));
      EXPECT_TRUE(table.viewport()->rect().contains(table.visualRect(now).center())) << row;
    }
    if (is_planned) break;
    select_protocol("chapter_recognition.json");
    click("protocol_preview");
  }
}

TEST_F(StudyPages, LetNothingOfThePlanOverlapTheButtonsOfItsProtocol) {
  open_lively();
  for (const char* const language : {"en", "de"}) {
    apply_language(language);
    window_.resize(1280, 720);
    select_protocol("chapter_recognition.json");
    const auto& interrupted = child<Banner>(window_, "protocols_interrupted");
    ASSERT_TRUE(eventually([&] { return interrupted.isVisible(); }));
    const auto& page = child<QWidget>(window_, "protocols_page");
    for (Banner* const banner : page.findChildren<Banner*>()) {
      if (banner != &interrupted) banner->show_news(State::look, "news");
    }
    click("protocol_preview");
    const auto place = [&](const char* name) {
      const auto& control = child<QWidget>(window_, name);
      return QRect(control.mapTo(&page, QPoint()), control.size());
    };
    EXPECT_TRUE(eventually([&] {
      return child<QWidget>(window_, "plan_seed").isVisible() &&
             place("plan_seed").top() > place("protocol_more").bottom();
    })) << place("plan_seed").top()
        << " " << place("protocol_more").bottom();
    take_screenshot(window_, QString("protocols-banners-%1").arg(language), {1280, 720});
  }
  apply_language("en");
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
  EXPECT_TRUE(problems.text_at(0, 0).startsWith("Surfaces › Textures › "))
      << problems.text_at(0, 0).toStdString();
  EXPECT_TRUE(problems.text_at(0, 0).contains("stimuli/mteal.png"));
  EXPECT_FALSE(child<QPushButton>(window_, "protocol_start").isEnabled());
  EXPECT_EQ(child<QLabel>(window_, "protocol_reason").text(),
            "Fix the problems listed below first.");
  take_screenshot(window_, "study-problems", {1366, 900});
}

TEST_F(StudyPages, FollowProtocolFilesThatOthersChange) {
  open_demo();
  const StudyTable& table = table_of("protocols", "protocols_table", 3);
  const std::filesystem::path file =
      window_.study()->folder() / "protocols" / "chapter_matching.json";
  std::ofstream(file) << "{\n\"format\": 3";
  EXPECT_TRUE(eventually([&] { return column(table, 5).filter("problem").size() == 1; }));
  table_of("protocols", "protocols_table", 3).select(QString::fromStdString(file.string()));
  const QString problem = child<StudyTable>(window_, "protocol_problems").text_at(0, 0);
  EXPECT_TRUE(problem.startsWith("Line 2: ")) << problem.toStdString();
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
  EXPECT_TRUE(description.startsWith("▲ Task › Explorations › unused: no block uses"))
      << description.toStdString();
  EXPECT_TRUE(description.contains("no block uses the exploration \"unused\""));
  take_screenshot(window_, "study-warnings", {1366, 900});
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
  EXPECT_TRUE(description.contains("the stimulus")) << description.toStdString();
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
  EXPECT_TRUE(
      child<QLabel>(window_, "protocol_description").text().startsWith("▲ the gate is open"));
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
  EXPECT_EQ(child<StudyTable>(window_, "protocol_problems").text_at(0, 0),
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

}  // namespace
}  // namespace asperity
