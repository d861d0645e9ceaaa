// The page of analyses: answers, figures and tables of made-up studies, their export and languages.

#include "app/gui/data/analysis_page.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>

#include <QtCore/QCoreApplication>
#include <QtCore/QMimeData>
#include <QtCore/QTranslator>
#include <QtGui/QClipboard>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QDialog>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QTableView>
#include <gtest/gtest.h>

#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/columns.h"
#include "app/findings/outcome/displayed_table.h"
#include "app/gui/base/open_study.h"
#include "app/gui/data/figure_view.h"
#include "app/gui/data/outcome_view.h"
#include "app/gui/data/result_table_view.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/gui/look/words.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"
#include "tests/app/stored_tables.h"
#include "tests/gui/support/screenshot.h"
#include "tests/gui/support/widgets.h"

namespace asperity {
namespace {

/// Ten people choose between two models; `hits` of their twenty choices are height_map.
void add_hits(MadeUpStudy& made, int hits) {
  const std::int64_t protocol = made.add_protocol("which_is_real", "selection");
  for (int person = 0; person < 10; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    made.add_person(label, person % 2 == 0 ? "F" : "M");
    std::vector<MadeUpTrial> trials{};
    for (int column = 1; column <= 2; ++column) {
      MadeUpTrial trial{};
      trial.options = {"height_map", "sinusoid"};
      for (const std::string& model : trial.options) {
        trial.surfaces.push_back(surface_of(model, model, "brick"));
      }
      const int number = 2 * person + column - 1;
      trial.answers = {trial.options[number < hits ? 0 : 1]};
      trial.factors_json = R"({"column": )" + std::to_string(column) + "}";
      trials.push_back(trial);
    }
    made.add_session(label, protocol, trials);
  }
}

/// The page of a study that `fill` makes, after its first reading.
struct OpenAnalysisPage {
  explicit OpenAnalysisPage(const std::function<void(MadeUpStudy&)>& fill)
      : study((fill(made), made.folder())) {
    page.show();
    EXPECT_TRUE(refreshed.wait(kPatience_ms));
  }

  MadeUpStudy made{};
  OpenStudy study;
  AnalysisPage page{study};
  QSignalSpy refreshed{&page, &AnalysisPage::refreshed};
};

// Counting takes 13 s for 3000 responses: meanwhile the page does not claim that there are none.
TEST(AnalysisPage, DoesNotReportAStudyWithoutResponsesBeforeTheyAreCounted) {
  for (const bool has_responses : {true, false}) {
    MadeUpStudy made{};
    if (has_responses) add_hits(made, 15);
    OpenStudy study(made.folder());
    AnalysisPage page{study};
    QSignalSpy refreshed{&page, &AnalysisPage::refreshed};
    page.show();
    EXPECT_TRUE(child<QWidget>(page, "analysis_unknown").isVisible());
    EXPECT_FALSE(child<QWidget>(page, "analysis_none").isVisible());
    ASSERT_TRUE(refreshed.wait(kPatience_ms));
    EXPECT_FALSE(child<QWidget>(page, "analysis_unknown").isVisible());
    EXPECT_EQ(child<QWidget>(page, "analysis_none").isVisible(), !has_responses);
  }
}

std::function<void(MadeUpStudy&)> with_hits(int hits) {
  return [hits](MadeUpStudy& made) { add_hits(made, hits); };
}

/// Tests that change nothing of what is shown of 15 hits have one page.
class AnalysisOfHits : public testing::Test {
 protected:
  static void TearDownTestSuite() { opened_.reset(); }

  static OpenAnalysisPage& opened() {
    if (!opened_) opened_ = std::make_unique<OpenAnalysisPage>(with_hits(15));
    return *opened_;
  }

  MadeUpStudy& made = opened().made;
  AnalysisPage& page = opened().page;

 private:
  static inline std::unique_ptr<OpenAnalysisPage> opened_{};
};

TEST_F(AnalysisOfHits, SaysTheAnswerInASentenceAboveItsTables) {
  ASSERT_EQ(page.outcomes().size(), 1U);
  const auto* answer = page.findChild<QLabel*>("answer");
  ASSERT_NE(answer, nullptr);
  const QString words = answer->text().simplified();  // without no-break spaces
  EXPECT_TRUE(words.startsWith("height_map was chosen most often: in 75 % of"))
      << words.toStdString();
  EXPECT_TRUE(words.contains("chance level of 50 %")) << words.toStdString();
  ASSERT_GE(page.findChildren<QTableView*>().size(), 2);
  // In the order of the analysis: whatever a header could sort by.
  const QAbstractItemModel* counts = page.findChild<QTableView*>("table_table_1")->model();
  EXPECT_EQ(counts->index(0, 0).data().toString(), "height_map");
  take_screenshot(page, "data-analysis");
}

TEST_F(AnalysisOfHits, DrawsEveryShareWithItsOwnInterval) {
  const auto* view = page.findChild<FigureView*>("figure_shares_forest");
  ASSERT_NE(view, nullptr);
  const FigureSeries& all = view->figure().series.front();
  const auto point = std::find_if(all.points.begin(), all.points.end(),
                                  [](const FigurePoint& one) { return one.x == 0.75; });
  ASSERT_NE(point, all.points.end());  // 15 of 20: (0.5313, 0.8881)
  EXPECT_NEAR(point->x_interval->low, 0.5313, 1e-4);
  EXPECT_NEAR(point->x_interval->high, 0.8881, 1e-4);
  // The whole figure is in sight: as high as it needs for its width.
  const auto* canvas = view->findChild<QWidget*>("canvas");
  ASSERT_NE(canvas, nullptr);
  page.resize(1366, 768);
  EXPECT_TRUE(eventually([canvas] {
    return canvas->width() > 600 && canvas->height() == canvas->heightForWidth(canvas->width());
  }));
  // It goes with its table, above it.
  const auto* table =
      page.findChild<QTableView*>("table_" + QString::fromStdString(view->figure().table));
  ASSERT_NE(table, nullptr);
  EXPECT_LT(view->mapTo(&page, QPoint()).y(), table->mapTo(&page, QPoint()).y());
  EXPECT_FALSE(canvas->accessibleName().isEmpty());
}

/// Six participants rate ten items, enough for the loadings of two components, on two scales.
void add_ratings_of_items(MadeUpStudy& made) {
  const std::int64_t protocol = made.add_protocol("attributes", "rating", R"({"kind": "rating",
      "blocks": {"only": {"questions": [
        {"name": "rough", "prompt": "How rough?",
         "scale": {"minimum": 1, "maximum": 7, "points": 7, "labels": ["smooth", "rough"]}},
        {"name": "hard", "prompt": "How hard?",
         "scale": {"minimum": 1, "maximum": 7, "points": 7, "labels": ["soft", "hard"]}}]}}})");
  const std::vector<std::pair<std::string, std::pair<int, int>>> items{
      {"brick", {5, 5}}, {"cork", {3, 3}},  {"felt", {2, 2}},    {"foil", {3, 6}},
      {"glass", {2, 7}}, {"metal", {2, 6}}, {"leather", {4, 4}}, {"paper", {3, 4}},
      {"sand", {6, 5}},  {"wood", {4, 3}}};
  for (int person = 0; person < 6; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    made.add_person(label, "");
    std::vector<MadeUpTrial> trials{};
    for (const auto& [item, scores] : items) {
      MadeUpTrial trial{};
      trial.surfaces = {surface_of(item, "height_map", item)};
      trial.questions = {"rough", "hard"};
      trial.answers = {std::to_string(scores.first + person % 3 - 1),
                       std::to_string(scores.second + person % 2 - 1)};
      trials.push_back(trial);
    }
    made.add_session(label, protocol, trials);
  }
}

TEST(AnalysisPage, ShowsTheProfileAndTheBiplotOfRatingsAboveTheirTables) {
  OpenAnalysisPage opened(add_ratings_of_items);
  AnalysisPage& page = opened.page;
  page.resize(1366, 768);
  for (const auto& [name, of] : {std::pair{"figure_profile", "table_ratings"},
                                 std::pair{"figure_biplot", "table_loadings"}}) {
    const auto* view = page.findChild<FigureView*>(name);
    const auto* table = page.findChild<QTableView*>(of);
    ASSERT_NE(view, nullptr) << name;
    ASSERT_NE(table, nullptr) << of;
    EXPECT_TRUE(view->figure().is_drawn()) << view->figure().instead.english();
    EXPECT_LT(view->mapTo(&page, QPoint()).y(), table->mapTo(&page, QPoint()).y());
    EXPECT_NE(view->findChild<QPushButton*>("save_figure"), nullptr);
  }
  const Figure& profile = page.findChild<FigureView*>("figure_profile")->figure();
  EXPECT_EQ(profile.y.places.front().english(), "smooth");
  EXPECT_EQ(profile.y.far_places.front().english(), "rough");
  EXPECT_EQ(profile.x.low, 1.0);
  EXPECT_EQ(profile.x.high, 7.0);
  take_screenshot(page, "data-analysis-ratings");
}

// Rows are as high whatever their width; curves are not.
TEST(FigureOfCurves, IsAsHighAsItNeedsAtEveryWidth) {
  Figure figure{};
  figure.x = {.name = phrase("Figures", "spacing"), .unit = "mm", .low = 0.0, .high = 1.0};
  figure.y = figure.x;
  figure.series = {{.points = {{.x = 0.5, .y = 0.5}}}};
  FigureView view(figure);
  view.show();
  const auto* canvas = view.findChild<QWidget*>("canvas");
  ASSERT_NE(canvas, nullptr);
  for (const int width : {500, 700, 900}) {
    view.resize(width, view.heightForWidth(width));
    EXPECT_TRUE(eventually([&] {
      return canvas->width() > width - 60 &&
             canvas->height() == canvas->heightForWidth(canvas->width());
    })) << canvas->height()
        << " of " << canvas->heightForWidth(canvas->width()) << " at " << width;
  }
}

TEST(AnalysisPage, ShowsEachQuestionWithItsAnswerAndFoldsTheMethodAway) {
  AnalysisOutcome outcome{};
  outcome.protocol = "which_is_real";
  outcome.questions = {{.name = "preference",
                        .question = "Is one chosen more often?",
                        .answer = "height_map was chosen in 15 of 20.",
                        .method = "Sign flips over persons.",
                        .table = "shares"},
                       {.name = "position",
                        .question = "Does the position matter?",
                        .answer = "The first was chosen in 9 of 20.",
                        .method = "Positions as items.",
                        .table = "nothing_of_this_name"}};
  outcome.tables =
      results_of({{.name = "table_1", .title = "Counts", .table = {{"item"}, {{"wave"}}}},
                  {.name = "shares", .title = "Shares", .table = {{"item"}, {{"wave"}}}}});
  const std::unique_ptr<QWidget> page(make_outcome(outcome, {}));
  page->show();
  EXPECT_EQ(page->findChild<QLabel*>("answer")->text(), "height_map was chosen in 15 of 20.");
  EXPECT_EQ(page->findChild<QLabel*>("further_answer")->text(), "The first was chosen in 9 of 20.");
  QStringList shown{};
  QStringList hidden{};
  for (const QLabel* label : page->findChildren<QLabel*>()) {
    (label->isVisible() ? shown : hidden) << label->text();
  }
  EXPECT_TRUE(shown.contains("Does the position matter?"));
  EXPECT_TRUE(hidden.contains("Sign flips over persons."));
  EXPECT_EQ(shown.count("Shares"), 1);
  EXPECT_EQ(shown.count("Counts"), 1);
  // The table that says more stands with its question, before the others.
  EXPECT_LT(shown.indexOf("Shares"), shown.indexOf("Does the position matter?"));
  EXPECT_LT(shown.indexOf("Shares"), shown.indexOf("Counts"));
}

TEST_F(AnalysisOfHits, SavesAFigureAndReplacesAFileOnlyWhenToldTo) {
  auto* view = page.findChild<FigureView*>("figure_shares_forest");
  ASSERT_NE(view, nullptr);
  auto* banner = page.findChild<Banner*>();
  const auto save_as = [&](const std::string& name) {
    QMenu* widths = view->findChild<QPushButton*>("save_figure")->menu();
    widths->actions().front()->trigger();
    auto* dialog = page.findChild<QFileDialog*>("figure_dialog");
    ASSERT_NE(dialog, nullptr);
    EXPECT_TRUE(dialog->selectedFiles().front().endsWith("which_is_real_1_shares_forest.svg"))
        << dialog->selectedFiles().front().toStdString();
    dialog->setObjectName("asked");
    emit dialog->fileSelected(QString::fromStdString(made.beside(name).string()));
    dialog->close();
  };
  for (const std::string name : {"shares.svg", "shares.pdf", "shares.png"}) {
    save_as(name);
    ASSERT_TRUE(eventually([&] { return banner->text().contains(QString::fromStdString(name)); }));
    EXPECT_GT(std::filesystem::file_size(made.beside(name)), 1000U);
  }
  EXPECT_NE(read_file(made.beside("shares.svg")).find("width=\"85mm\""), std::string::npos);
  write_file(made.beside("shares.svg"), std::string_view("another"), Overwrite::allow);
  save_as("shares.svg");
  ASSERT_TRUE(eventually([&] { return banner->text().contains("already"); }));
  EXPECT_EQ(read_file(made.beside("shares.svg")), "another");
  for (QPushButton* button : banner->findChildren<QPushButton*>()) {
    if (button->text().startsWith("Replace")) button->click();
  }
  ASSERT_TRUE(eventually([&] { return banner->text().contains("figure is in"); }));
  EXPECT_NE(read_file(made.beside("shares.svg")), "another");
}

TEST_F(AnalysisOfHits, CopiesAFigureAsAPictureAndAsSvg) {
  QGuiApplication::clipboard()->clear();
  auto* copy =
      page.findChild<FigureView*>("figure_shares_forest")->findChild<QPushButton*>("copy_figure");
  copy->setFocus();
  QTest::keyClick(copy, Qt::Key_Space);
  auto* banner = page.findChild<Banner*>();
  ASSERT_TRUE(eventually([&] { return banner->text().contains("clipboard"); }));
  const QMimeData* content = QGuiApplication::clipboard()->mimeData();
  EXPECT_TRUE(content->hasImage());
  EXPECT_TRUE(content->data("image/svg+xml").contains("<svg"));
}

TEST(AnalysisPage, LooksTheSameInTheDark) {
  apply_theme(*qApp, ThemeChoice::dark);
  {
    OpenAnalysisPage opened(with_hits(15));
    AnalysisPage& page = opened.page;
    auto* view = page.findChild<FigureView*>("figure_shares_forest");
    ASSERT_NE(view, nullptr);
    // Light letters on the dark card.
    const QImage picture = view->grab().toImage();
    EXPECT_LT(QColor(picture.pixel(8, 8)).lightness(), 80);
    int light = 0;
    for (int y = 0; y < picture.height(); ++y) {
      for (int x = 0; x < picture.width(); ++x) {
        light += QColor(picture.pixel(x, y)).lightness() > 180 ? 1 : 0;
      }
    }
    EXPECT_GT(light, 500);
    take_screenshot(page, "data-analysis-dark");
  }
  apply_theme(*qApp, ThemeChoice::light);
}

/// A language in which every word of an analysis stands in angle brackets.
class Brackets final : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* words, const char*, int) const override {
    const QString of = context;
    if (of == "Columns") return QString::fromUtf8(words);  // %1, %2
    return of == "Analysis" || of == "AnalysisWords" ? "<" + QString::fromUtf8(words) + ">" : "";
  }
};

TEST(AnalysisPage, SaysFixedWordsInTheLanguageOfTheWindowsAndLeavesNamesAlone) {
  Brackets brackets;
  QCoreApplication::installTranslator(&brackets);
  OpenAnalysisPage opened(with_hits(15));
  AnalysisPage& page = opened.page;
  QStringList words{};
  for (const QLabel* label : page.findChildren<QLabel*>()) words << label->text();
  EXPECT_TRUE(words.contains("<Choices (counts)>"));
  EXPECT_TRUE(words.contains("<Chance level: 1/2 of the choices for each model.>"));
  for (const QTableView* table : page.findChildren<QTableView*>()) {
    for (int i = 0; i < table->model()->columnCount(); ++i) {
      const QString heading = table->model()->headerData(i, Qt::Horizontal).toString();
      EXPECT_TRUE(heading.startsWith("<")) << heading.toStdString();
    }
  }
  const auto* counts = page.findChild<QTableView*>("table_table_1")->model();
  EXPECT_EQ(counts->index(0, 0).data().toString(), "height_map");
  // Where the program's own word can stand only: a study may name its pictures as it likes.
  EXPECT_EQ(words_as_published(words_of_sex("Total")), "<Total>");
  EXPECT_EQ(words_as_published(words_of_item("Total")), "Total");
  EXPECT_EQ(words_as_published(heading_for(columns::kFelt, Reader::window)), "<stimulus>");
  QCoreApplication::removeTranslator(&brackets);
}

// At 1366 × 900 the page has room for about 800 points.
TEST(ResultTableView, FitsByItsHeadingsAndNamesAndCutsNoNumber) {
  StoredTable stored{.name = "made_up", .table = {.columns = {"which rendering was felt"}}};
  stored.table.rows.emplace_back();
  stored.table.rows[0].emplace_back("a rendering with a long name of several words");
  for (int i = 1; i <= 5; ++i) {
    stored.table.columns.push_back("mean of the quantity number " + std::to_string(i));
    stored.table.rows[0].emplace_back(12.5 * i);
  }
  ResultTableView table(result_of(stored));
  const auto cuts_a_number = [&table] {
    for (int column = 1; column < table.model()->columnCount(); ++column) {
      if (table.columnWidth(column) <
          table.sizeHintForIndex(table.model()->index(0, column)).width())
        return true;
    }
    return false;
  };
  const auto show_at = [&table](int width) {
    table.resize(width, table.height());
    table.show();
    QCoreApplication::processEvents();
    return table.horizontalHeader()->length() <= table.viewport()->width();
  };
  EXPECT_TRUE(show_at(4000));
  const int one_line = table.horizontalHeader()->height();
  EXPECT_LT(table.width(), 4000) << "no wider than its columns";
  EXPECT_TRUE(show_at(800));
  EXPECT_GT(table.horizontalHeader()->height(), one_line);
  EXPECT_FALSE(cuts_a_number());
  const int height = table.height();
  EXPECT_FALSE(show_at(300));
  EXPECT_FALSE(cuts_a_number());
  EXPECT_GT(table.height(), height) << "with room for the scroll bar";
  EXPECT_TRUE(show_at(4000));
  EXPECT_EQ(table.horizontalHeader()->height(), one_line);
}

TEST(AnalysisPage, NamesTheColumnsOfRatingsInTheLanguageOfTheWindows) {
  Brackets brackets;
  QCoreApplication::installTranslator(&brackets);
  OpenAnalysisPage opened(add_ratings_of_items);
  AnalysisPage& page = opened.page;
  for (const char* name : {"ratings", "scales", "agreement", "components", "loadings"}) {
    const auto* table = page.findChild<QTableView*>(QString("table_") + name);
    ASSERT_NE(table, nullptr) << name;
    for (int i = 0; i < table->model()->columnCount(); ++i) {
      const QString heading = table->model()->headerData(i, Qt::Horizontal).toString();
      EXPECT_TRUE(heading.startsWith("<")) << name << ": " << heading.toStdString();
    }
  }
  QCoreApplication::removeTranslator(&brackets);
}

TEST(AnalysisPage, SaysWhatToDoWhileThereIsNothing) {
  OpenAnalysisPage opened([](MadeUpStudy&) {});
  AnalysisPage& page = opened.page;
  EXPECT_FALSE(page.findChild<QPushButton*>("export_tables")->isEnabled());
  EXPECT_TRUE(page.findChild<EmptyState*>("analysis_none")->isVisible());
  take_screenshot(page, "data-analysis-empty", {1366, 768});
}

TEST(AnalysisPage, ExportsTheTablesToANewFolder) {
  OpenAnalysisPage opened(with_hits(10));
  auto& [made, study, page, refreshed] = opened;
  page.findChild<QPushButton*>("export_tables")->click();
  auto* dialog = page.findChild<QFileDialog*>("export_dialog");
  ASSERT_NE(dialog, nullptr);
  emit dialog->fileSelected(QString::fromStdString(made.beside("tables").string()));
  auto* banner = page.findChild<Banner*>();
  ASSERT_TRUE(eventually([banner] { return banner->isVisible(); }));
  EXPECT_TRUE(std::filesystem::exists(made.beside("tables") / "responses.tsv"));
  const auto files = std::count_if(
      std::filesystem::recursive_directory_iterator(made.beside("tables")),
      std::filesystem::recursive_directory_iterator(),
      [](const std::filesystem::directory_entry& entry) { return !entry.is_directory(); });
  EXPECT_TRUE(banner->text().startsWith(QString("%1 files").arg(files)))
      << banner->text().toStdString();
  EXPECT_TRUE(banner->text().contains("codebook.tsv")) << banner->text().toStdString();
}

TEST(AnalysisPage, NamesAHeightFieldThatTheExportLacks) {
  OpenAnalysisPage opened([](MadeUpStudy& made) {
    add_hits(made, 10);
    std::vector<StimulusFileRow> files{};
    MadeUpTrial trial{};
    trial.options = {"height_map", "sinusoid"};
    trial.answers = {"height_map"};
    for (const std::string& model : trial.options) {
      const std::string sha256(64, model == "sinusoid" ? '1' : '0');
      trial.surfaces.push_back(surface_of(model, model, "brick"));
      trial.surfaces.back().assets = {{"height_field", sha256}};
      files.push_back({"stimuli/" + model + ".png.json", sha256, 1});
    }
    made.set_files(files);
    made.add_session("p10", made.study().sessions().front().protocol_id, {trial});
  });
  auto& [made, study, page, refreshed] = opened;
  page.findChild<QPushButton*>("export_tables")->click();
  emit page.findChild<QFileDialog*>("export_dialog")
      ->fileSelected(QString::fromStdString(made.beside("tables").string()));
  auto* banner = page.findChild<Banner*>();
  ASSERT_TRUE(eventually([banner] { return banner->isVisible(); }));
  EXPECT_TRUE(
      banner->text().contains("stimuli/height_map.png, the height field of the "
                              "stimulus \"surface\" (brick), is missing from the study"))
      << banner->text().toStdString();
  EXPECT_TRUE(banner->text().contains("README.txt states 1 further warning."))
      << banner->text().toStdString();
  take_screenshot(page, "data-export-incomplete", {1280, 720});
}

TEST(AnalysisPage, ExportsForThePublicWhenToldTo) {
  OpenAnalysisPage opened(with_hits(10));
  auto& [made, study, page, refreshed] = opened;
  page.findChild<QPushButton*>("export_tables")->click();
  auto* dialog = page.findChild<QFileDialog*>("export_dialog");
  ASSERT_NE(dialog, nullptr);
  take_screenshot(*dialog, "data-export-dialog", {800, 500});
  EXPECT_FALSE(dialog->findChild<QCheckBox*>("export_recordings")->isChecked());
  auto* for_public = dialog->findChild<QCheckBox*>("export_public");
  EXPECT_TRUE(for_public->isVisibleTo(dialog));
  auto* relabel = dialog->findChild<QCheckBox*>("export_relabel");
  auto* age_bands = dialog->findChild<QCheckBox*>("export_age_bands");
  EXPECT_FALSE(relabel->isEnabled()) << "for the public only";
  EXPECT_FALSE(age_bands->isEnabled());
  for_public->click();
  relabel->click();
  age_bands->click();
  emit dialog->fileSelected(QString::fromStdString(made.beside("tables").string()));
  auto* banner = page.findChild<Banner*>();
  ASSERT_TRUE(eventually([banner] { return banner->isVisible(); }));
  const auto read = [&made = made](const char* name) {
    return read_file(made.beside("tables") / name);
  };
  EXPECT_EQ(read("sessions.tsv").find("started_utc"), std::string::npos);
  EXPECT_EQ(read("sessions.tsv").find("seed"), std::string::npos);
  EXPECT_NE(read("participants.tsv").find("age_band"), std::string::npos);
  EXPECT_EQ(read("participants.tsv").find("p10"), std::string::npos);
}

TEST(AnalysisPage, ExportsAllOrNothingWhenItIsCancelled) {
  OpenAnalysisPage opened(with_hits(10));
  auto& [made, study, page, refreshed] = opened;
  auto* export_tables = page.findChild<QPushButton*>("export_tables");
  export_tables->click();
  emit page.findChild<QFileDialog*>("export_dialog")
      ->fileSelected(QString::fromStdString(made.beside("tables").string()));
  EXPECT_FALSE(export_tables->isEnabled()) << "one at a time";
  auto* line = page.findChild<TaskLine*>("exporting");
  EXPECT_TRUE(line->findChild<QLabel*>("task_words")->text().contains("tables"));
  line->findChild<QPushButton*>("task_cancel")->click();
  auto* banner = page.findChild<Banner*>();
  ASSERT_TRUE(eventually([banner] { return banner->isVisible(); }));
  // A machine that is busy elsewhere may notice too late.
  const bool in_time = banner->text().contains("Writing the tables was cancelled. No part");
  EXPECT_EQ(std::filesystem::exists(made.beside("tables")), !in_time);
  ASSERT_TRUE(eventually([&] { return export_tables->isEnabled(); }));
}

TEST(AnalysisPage, TellsNothingByNameWhileASessionRuns) {
  std::unique_ptr<StudyLock> lock{};
  OpenAnalysisPage opened([&lock](MadeUpStudy& made) {
    add_hits(made, 15);
    made.study().add_participant({.label = "p99"});
    SessionRow session = made.study().sessions().front();
    session.participant = "p99";
    session.session = 0;
    session.state = SessionState::open;
    session.ended_utc.reset();
    made.study().add_session(session, {});
    lock = std::make_unique<StudyLock>(made.folder(), Study::session_lock_name("p99"));
  });
  AnalysisPage& page = opened.page;
  EXPECT_EQ(page.findChild<QLabel*>("answer"), nullptr);
  EXPECT_TRUE(page.findChildren<QTableView*>().isEmpty());
}

TEST(AnalysisPage, ShowsNoOtherResultsWhileThoseOfTheChosenProtocolAreCounted) {
  OpenAnalysisPage opened(with_hits(15));
  auto& [made, study, page, refreshed] = opened;
  auto* list = page.findChild<QListWidget*>("outcomes");
  study.announce_change();
  page.choose("another", SessionMode::simulate);
  EXPECT_TRUE(child<QWidget>(page, "analysis_counting").isVisible());
  EXPECT_EQ(page.findChild<QLabel*>("answer"), nullptr);
  EXPECT_TRUE(list->selectedItems().isEmpty());
  // Cancelled: the previous results.
  child<TaskLine>(page, "analysing").findChild<QPushButton*>("task_cancel")->click();
  EXPECT_EQ(list->currentRow(), 0);
  EXPECT_NE(page.findChild<QLabel*>("answer"), nullptr);
  // Counted: the chosen ones.
  study.announce_change();
  page.choose("which_is_real", SessionMode::run);
  EXPECT_EQ(list->currentRow(), -1);
  ASSERT_TRUE(refreshed.wait(kPatience_ms));
  EXPECT_EQ(list->currentRow(), 0);
  EXPECT_EQ(page.findChild<QWidget*>("analysis_counting"), nullptr);
  EXPECT_NE(page.findChild<QLabel*>("answer"), nullptr);
}

/// One choice of one participant.
void add_choice(MadeUpStudy& made, std::int64_t protocol, const std::string& label,
                SessionMode mode) {
  if (mode == SessionMode::simulate) {
    made.add_virtual(label, "F");
  } else {
    made.add_person(label, "F");
  }
  MadeUpTrial trial{};
  trial.options = {"height_map", "sinusoid"};
  for (const std::string& model : trial.options) {
    trial.surfaces.push_back(surface_of(model, model, "brick"));
  }
  trial.answers = {"height_map"};
  made.add_session(label, protocol, {trial}, mode);
}

TEST(AnalysisPage, KeepsTheChosenExperimentWhenAnotherHasResults) {
  std::int64_t first = 0;
  OpenAnalysisPage opened([&first](MadeUpStudy& made) {
    first = made.add_protocol("first", "selection");
    add_choice(made, first, "p01", SessionMode::run);
    const std::string source = R"({"title": "Which feels real?"})";
    add_choice(made, made.add_protocol("second", "selection", source), "p02", SessionMode::run);
  });
  auto& [made, study, page, refreshed] = opened;
  auto* list = page.findChild<QListWidget*>("outcomes");
  list->setCurrentRow(1);
  ASSERT_TRUE(list->currentItem()->text().startsWith("Which feels real?\nsecond"));
  add_choice(made, first, "v01", SessionMode::simulate);
  study.announce_change();
  ASSERT_TRUE(refreshed.wait(kPatience_ms));
  EXPECT_EQ(list->count(), 3);
  EXPECT_TRUE(list->currentItem()->text().contains("second"));
}

TEST(AnalysisPage, StaysAsItIsUnderADialog) {
  std::int64_t first = 0;
  OpenAnalysisPage opened([&first](MadeUpStudy& made) {
    first = made.add_protocol("first", "selection");
    add_choice(made, first, "p01", SessionMode::run);
  });
  auto& [made, study, page, refreshed] = opened;
  auto* list = page.findChild<QListWidget*>("outcomes");
  const auto& area = *page.findChild<QScrollArea*>();
  const QWidget* const shown = area.widget();
  QDialog dialog(&page);
  dialog.open();
  add_choice(made, first, "v01", SessionMode::simulate);
  study.announce_change();
  page.choose("first", SessionMode::simulate);
  ASSERT_TRUE(refreshed.wait(kPatience_ms));
  EXPECT_EQ(area.widget(), shown);
  EXPECT_EQ(list->count(), 1);
  auto& banner = *page.findChild<Banner*>();
  EXPECT_EQ(banner.text(), "There are new results of first.");
  dialog.close();
  EXPECT_EQ(list->count(), 2);
  EXPECT_EQ(list->currentRow(), 0) << "what was read stays chosen";
  for (QPushButton* const button : banner.findChildren<QPushButton*>()) {
    if (button->text() == "Show the results") button->click();
  }
  EXPECT_EQ(list->currentRow(), 1);
}

TEST(AnalysisPage, ReadsAgainWhenTheStudyChanges) {
  OpenAnalysisPage opened([](MadeUpStudy&) {});
  auto& [made, study, page, refreshed] = opened;
  add_hits(made, 15);
  study.announce_change();
  ASSERT_TRUE(refreshed.wait(kPatience_ms));
  EXPECT_EQ(page.outcomes().size(), 1U);
  EXPECT_EQ(page.findChild<QListWidget*>("outcomes")->count(), 1);
}

}  // namespace
}  // namespace asperity
