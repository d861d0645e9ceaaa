// A report as HTML, as pages and as PDF, and the button that saves one.

#include <filesystem>
#include <set>
#include <stop_token>

#include <QtCore/QDir>
#include <QtCore/QXmlStreamReader>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QFileDialog>
#include <QtWidgets/QLabel>
#include <QtWidgets/QPushButton>
#include <gtest/gtest.h>

#include "app/gui/base/open_study.h"
#include "app/gui/data/analysis_page.h"
#include "app/gui/look/controls.h"
#include "app/gui/look/task_line.h"
#include "app/report/pages/html_report.h"
#include "app/report/pages/pdf_report.h"
#include "app/report/pages/report_file.h"
#include "app/report/pages/report_pages.h"
#include "app/report/pages/table_layout.h"
#include "app/report/text/study_report.h"
#include "tests/app/made_up_study.h"
#include "tests/gui/support/widgets.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

/// `hits` of forty choices of ten people are height_map.
void add_choices(MadeUpStudy& made, int hits, SessionMode mode = SessionMode::run) {
  const std::int64_t protocol = made.add_protocol("which_is_real", "selection");
  for (int person = 0; person < 10; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    if (!made.study().participant(label)) made.add_person(label, person % 2 == 0 ? "F" : "M");
    std::vector<MadeUpTrial> trials{};
    for (int column = 1; column <= 4; ++column) {
      MadeUpTrial trial{};
      trial.options = {"height_map", "sinusoid"};
      for (const std::string& model : trial.options) {
        trial.surfaces.push_back(surface_of(model, model, "brick"));
      }
      trial.answers = {trial.options[4 * person + column - 1 < hits ? 0 : 1]};
      trial.factors_json = R"({"column": )" + std::to_string(column) + "}";
      trials.push_back(trial);
    }
    made.add_session(label, protocol, trials, mode);
  }
}

Report report_of(const Study& study) { return study_report(study); }

/// One chapter of one section.
Report report_with(std::vector<ReportPart> parts, const std::string& mark = "") {
  Report report{"A study", "Data of 2001-02-03 (UTC)", "asperity, some version", {}};
  report.chapters.push_back({"A chapter",
                             mark,
                             mark.empty() ? AnswerGroup::people : AnswerGroup::pilot,
                             {{"A section", std::move(parts)}}});
  return report;
}

ReportTable long_table(int rows) {
  ReportTable table{};
  table.number = 1;
  table.title = "Many rows";
  table.columns = {{"name", false}, {"value", true}};
  for (int i = 0; i < rows; ++i) {
    table.rows.push_back({"row " + std::to_string(i), std::to_string(i)});
  }
  return table;
}

/// The text of all elements, with spaces for no-break spaces; fails where it is no XML.
QString read_as_xml(const std::string& html, QStringList* elements = nullptr) {
  QXmlStreamReader reader(QByteArray::fromStdString(html));
  QString text{};
  while (!reader.atEnd()) {
    reader.readNext();
    if (reader.isCharacters()) text += reader.text();
    if (reader.isStartElement() && elements != nullptr) *elements << reader.name().toString();
  }
  EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString() << " in line "
                                  << reader.lineNumber();
  return text.replace(QChar::Nbsp, ' ');
}

TEST(HtmlReport, IsWellFormedAndNeedsNothingFromElsewhere) {
  MadeUpStudy made;
  add_choices(made, 27);
  const Report report = report_of(made.study());
  const std::string html = html_of(report);
  QStringList elements{};
  const QString text = read_as_xml(html, &elements);
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>\n<html lang=\"en\""));
  EXPECT_FALSE(elements.contains("script"));
  EXPECT_FALSE(elements.contains("link"));
  EXPECT_FALSE(elements.contains("img"));
  EXPECT_EQ(html.find("src="), std::string::npos);
  EXPECT_EQ(html.find("url(http"), std::string::npos);
  EXPECT_TRUE(elements.contains("svg")) << "figures are in it";
  EXPECT_EQ(elements.count("table"), elements.count("caption"));
  for (const ReportChapter& chapter : report.chapters) {
    for (const ReportSection& section : chapter.sections) {
      for (const ReportPart& part : section.parts) {
        if (const auto* words = std::get_if<ReportText>(&part)) {
          EXPECT_TRUE(text.contains(QString::fromStdString(words->text))) << words->text;
        }
        if (const auto* table = std::get_if<ReportTable>(&part)) {
          for (const auto& row : table->rows) {
            for (const std::string& cell : row) {
              EXPECT_TRUE(text.contains(QString::fromStdString(cell))) << cell;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(html, html_of(report_of(made.study()))) << "the same study, the same bytes";
}

TEST(HtmlReport, BreaksNoLineWithinANumber) {
  ReportTable table = long_table(1);
  table.rows[0] = {"wood", "0.33 [0.16, 0.49]"};
  const QString html =
      QString::fromStdString(html_of(report_with({ReportText{"A test, p = .03."}, table})));
  EXPECT_TRUE(html.contains("A test, p\u00A0=\u00A0.03."));
  EXPECT_TRUE(html.contains("0.33 [0.16,\u00A00.49]"));
}

TEST(ReportPages, BreakNoLineWithinANumber) {
  QFont font{};
  font.setPixelSize(150);
  const QString text =
      "The difference was 0.33, 95 % CI [−0.16, 0.49], t(19) = 12.25, p = .031, trials 1–5.";
  for (double width = 1500.0; width < 6000.0; width += 50.0) {
    for (const QString& line : broken_lines(text, font, width)) {
      EXPECT_FALSE(line.endsWith("[−0.16,")) << width;
      EXPECT_FALSE(line.endsWith("=")) << width;
      EXPECT_FALSE(line.startsWith("=")) << width;
      EXPECT_FALSE(line.startsWith("%")) << width;
      EXPECT_FALSE(line.endsWith("1–")) << width;
    }
  }
}

TEST(HtmlReport, EscapesWhatStudiesCallTheirThings) {
  ReportTable table = long_table(1);
  table.title = "Title & <title>";
  table.columns[0].heading = "<th> & \"quotes\"";
  table.rows[0] = {"</td><script>alert(1)</script>", "1 < 2"};
  table.note = "a note with ]]> & <b>";
  Report report = report_with({ReportText{"<p>R&D \x01 'x'"}, ReportList{{"<li>"}}, table});
  report.title = "</title><script>";
  report.chapters[0].heading = "<h2>&amp;";
  report.chapters[0].mark = "<mark>";
  QStringList elements{};
  const QString text = read_as_xml(html_of(report), &elements);
  EXPECT_FALSE(elements.contains("script"));
  EXPECT_FALSE(elements.contains("b"));
  for (const char* words : {"<p>R&D   'x'", "<li>", "Title & <title>", "<th> & \"quotes\"",
                            "</td><script>alert(1)</script>", "1 < 2", "a note with ]]> & <b>",
                            "</title><script>", "<h2>&amp;", "<mark>"}) {
    EXPECT_TRUE(text.contains(words)) << words;
  }
}

TEST(HtmlReport, MarksEverySectionOfAPilot) {
  MadeUpStudy made;
  add_choices(made, 20, SessionMode::pilot);
  const Report report = report_of(made.study());
  const QString html = QString::fromStdString(html_of(report));
  qsizetype sections = 0;
  for (const ReportChapter& chapter : report.chapters) {
    sections += static_cast<qsizetype>(chapter.sections.size());
  }
  EXPECT_EQ(html.count("<h3>"), sections);
  for (const QString& line : html.split('\n')) {
    if (line.startsWith("<h3>") || line.startsWith("<h2>")) {
      EXPECT_TRUE(line.contains("PILOT: not study data")) << line.toStdString();
    }
  }
}

std::vector<PageText> texts_of(const ReportPages& pages, std::size_t page) {
  std::vector<PageText> texts{};
  for (const PageMark& mark : pages.marks(page)) {
    if (const auto* text = std::get_if<PageText>(&mark)) texts.push_back(*text);
  }
  return texts;
}

bool stands_on(const ReportPages& pages, std::size_t page, const QString& words) {
  for (const PageText& text : texts_of(pages, page)) {
    if (text.text == words) return true;
  }
  return false;
}

/// Pages as pictures, for people to look at.
void take_pictures(const ReportPages& pages, const QString& name) {
  const QString folder = qEnvironmentVariable("ASPERITY_SCREENSHOTS");
  if (folder.isEmpty()) return;
  QDir().mkpath(folder);
  constexpr double kDotsPerInch = 96.0;
  const double scale = kDotsPerInch / kReportUnitsPerInch;
  for (std::size_t page = 0; page < pages.count(); ++page) {
    QImage image((ReportPages::size() * scale).toSize(), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
    painter.scale(scale, scale);
    pages.draw(page, painter);
    painter.end();
    image.save(QString("%1/%2-%3.png").arg(folder, name).arg(page + 1, 2, 10, QChar('0')));
  }
}

TEST(ReportPages, KeepEverythingInsideTheirMargins) {
  MadeUpStudy made;
  add_choices(made, 27);
  const Report report = report_of(made.study());
  const ReportPages pages(report);
  ASSERT_GE(pages.count(), 3U);
  const QRectF area = ReportPages::text_area();
  std::size_t figures = 0;
  for (std::size_t page = 0; page < pages.count(); ++page) {
    for (const PageMark& mark : pages.marks(page)) {
      if (const auto* text = std::get_if<PageText>(&mark)) {
        EXPECT_GE(text->baseline.x(), area.left() - 1.0) << text->text.toStdString();
        EXPECT_LE(text->baseline.x() + text->width, area.right() + 20.0)
            << text->text.toStdString();
      }
      if (const auto* figure = std::get_if<PageFigure>(&mark)) {
        EXPECT_TRUE(area.adjusted(-1, -1, 1, 1).contains(figure->place)) << "page " << page + 1;
        ++figures;
      }
    }
    EXPECT_TRUE(stands_on(pages, page, QString("Page %1 of %2").arg(page + 1).arg(pages.count())));
  }
  EXPECT_GE(figures, 1U);
  take_pictures(pages, "report-people");
}

TEST(ReportPages, SayInTheHeadingOfEachWhoseDataItShows) {
  MadeUpStudy made;
  add_choices(made, 20);
  add_choices(made, 20, SessionMode::pilot);
  const Report report = report_of(made.study());
  ASSERT_EQ(report.chapters.size(), 5U);
  const ReportPages pages(report);
  std::set<QString> seen{};
  for (std::size_t page = 1; page < pages.count(); ++page) {
    const bool is_pilot = stands_on(pages, page, "PILOT: not study data");
    const QString heading = texts_of(pages, page)[is_pilot ? 1 : 0].text;
    EXPECT_EQ(is_pilot, heading.contains("pilot sessions")) << heading.toStdString();
    seen.insert(heading);
  }
  EXPECT_EQ(seen.size(), 4U) << "no page has both";
}

TEST(ReportPages, RepeatTheHeadingsOfALongTableAndCutNoRow) {
  ReportTable table = long_table(200);
  for (auto& row : table.rows)
    row[0] +=
        " with a text that is so long that it takes two lines of "
        "the column, because it goes on and on and on and on, "
        "until nobody reads it any more, or wants to";
  const Report report = report_with({table});
  const ReportPages pages(report);
  ASSERT_GE(pages.count(), 3U);
  const QRectF area = ReportPages::text_area();
  int rows = 0;
  for (std::size_t page = 0; page < pages.count(); ++page) {
    EXPECT_TRUE(stands_on(pages, page, "value")) << "page " << page + 1;
    EXPECT_EQ(stands_on(pages, page, "Table 1, continued"), page > 0);
    int on_this = 0;
    for (const PageText& text : texts_of(pages, page)) {
      if (text.text.startsWith("row ")) ++on_this;
      const bool is_frame = text.text.startsWith("Page ") || text.font.pixelSize() == 150;
      if (is_frame) continue;
      EXPECT_LE(text.baseline.y(), area.bottom()) << text.text.toStdString();
    }
    EXPECT_GE(on_this, 3) << "page " << page + 1;
    rows += on_this;
  }
  EXPECT_EQ(rows, 200);
}

TEST(ReportPages, LeaveNoHeadingAloneAtTheEndOfAPage) {
  // Whatever the height that is left, a heading and a table of five rows move together.
  for (int lines = 30; lines < 60; ++lines) {
    Report report = report_with({});
    for (int i = 0; i < lines; ++i) {
      report.chapters[0].sections[0].parts.emplace_back(ReportText{"A line."});
    }
    report.chapters[0].sections.push_back({"The next section", {long_table(5)}});
    const ReportPages pages(report);
    std::size_t heading = 99;
    for (std::size_t page = 0; page < pages.count(); ++page) {
      if (stands_on(pages, page, "The next section")) heading = page;
    }
    ASSERT_LT(heading, pages.count());
    EXPECT_TRUE(stands_on(pages, heading, "row 0")) << lines;
    EXPECT_TRUE(stands_on(pages, heading, "row 4")) << lines;
  }
}

TEST(ReportPages, KeepAnAnswerWithItsFigure) {
  Figure figure{.name = "shares", .shape = FigureShape::wide, .series = {{}}};
  figure.series.front().points = {{.x = 0.5, .y = 0.5}};
  // Whatever the height that is left: answer, method and figure move together.
  for (int lines = 0; lines < 60; ++lines) {
    std::vector<ReportPart> parts(static_cast<std::size_t>(lines), ReportText{"A line."});
    parts.emplace_back(ReportText{"An answer.", ReportText::Tone::lead});
    parts.emplace_back(ReportText{"How it was computed."});
    parts.emplace_back(ReportFigure{1, figure});
    const Report report = report_with(std::move(parts));
    const ReportPages pages(report);
    for (std::size_t page = 0; page < pages.count(); ++page) {
      const std::vector<PageMark>& marks = pages.marks(page);
      const bool has_figure = std::any_of(marks.begin(), marks.end(), [](const PageMark& mark) {
        return std::holds_alternative<PageFigure>(mark);
      });
      EXPECT_EQ(stands_on(pages, page, "An answer."), has_figure) << lines;
      EXPECT_EQ(stands_on(pages, page, "How it was computed."), has_figure) << lines;
    }
  }
}

// A figure that is nearly small enough for the page is made so, and leaves no half of it empty.
TEST(ReportPages, MakeAFigureSmallerThatNearlyFits) {
  Figure figure{.name = "shares", .shape = FigureShape::square, .series = {{}}};
  figure.series.front().points = {{.x = 0.5, .y = 0.5}};
  const double bottom = ReportPages::text_area().bottom();
  double whole = 0.0;
  std::set<double> smaller{};
  for (int lines = 0; lines < 34; ++lines) {  // of the first page
    std::vector<ReportPart> parts(static_cast<std::size_t>(lines), ReportText{"A line."});
    parts.emplace_back(ReportText{"An answer.", ReportText::Tone::lead});
    parts.emplace_back(ReportFigure{1, figure});
    const Report report = report_with(std::move(parts));
    const ReportPages pages(report);
    for (std::size_t page = 0; page < pages.count(); ++page) {
      for (const PageMark& mark : pages.marks(page)) {
        const auto* placed = std::get_if<PageFigure>(&mark);
        if (placed == nullptr) continue;
        if (lines == 0) whole = placed->place.width();
        EXPECT_LE(placed->place.bottom(), bottom);
        EXPECT_GE(placed->place.width(), 0.69 * whole) << lines;
        if (placed->place.width() < 0.99 * whole) {
          EXPECT_EQ(page, 0U) << "a page of its own has room for all of it";
          smaller.insert(placed->place.width());
        }
      }
    }
  }
  EXPECT_GE(smaller.size(), 3U);
}

TEST(TableLayout, BreaksWordsAndNamesThatAreTooLong) {
  ReportTable table = long_table(1);
  table.rows[0][0] = std::string(400, 'a');
  const double width = ReportPages::text_area().width();
  const LaidOutTable made = lay_out(table, "DejaVu Sans", width).front();
  EXPECT_LE(made.right.back(), width + 1.0);
  ASSERT_GT(made.rows[0].cells[0].size(), 1);
  for (const QString& line : made.rows[0].cells[0]) {
    EXPECT_LE(text_width(line, made.font), made.right[0] - made.left[0] + 2.0);
  }
  ReportTable wide{};
  for (int i = 0; i < 40; ++i) wide.columns.push_back({"column " + std::to_string(i), true});
  wide.rows.push_back(std::vector<std::string>(40, "0.1234"));
  for (const LaidOutTable& part : lay_out(wide, "DejaVu Sans", width)) {
    EXPECT_LE(part.right.back(), width + 1.0);
  }
}

ReportTable table_of_tests(const std::string& statistic) {
  ReportTable table{};
  table.number = 1;
  table.title = "Tests";
  table.columns = {{"test"},        {"method"},  {"n", true},       {"statistic"},
                   {"effect size"}, {"p", true}, {"p, Holm", true}, {"role"}};
  table.rows = {{"order of presentation", "Wilcoxon signed-rank test", "6 participants", statistic,
                 "r = .10", ".875", ".875", "confirmatory"}};
  return table;
}

TEST(TableLayout, BreaksNoLineWithinAStatement) {
  const double width = ReportPages::text_area().width();
  for (const char* statistic : {"W⁺ = 11.50", "χ²(3) = 0.19", "F(1, 353.00) = 4.64"}) {
    ReportTable table = table_of_tests(statistic);
    // Until there is no room left.
    for (int longer = 0; longer < 40; ++longer) {
      table.rows[0][0] += " of it";
      table.rows[0][7] += "y";
      for (const LaidOutTable& part : lay_out(table, "DejaVu Sans", width)) {
        for (std::size_t i = 0; i < part.columns.size(); ++i) {
          if (part.columns[i] != 3 && part.columns[i] != 4) continue;
          EXPECT_EQ(part.rows[0].cells[i].size(), 1)
              << part.rows[0].cells[i].join('|').toStdString();
        }
      }
    }
  }
}

// Thresholds have many columns; letters of five points cannot be read on paper.
TEST(TableLayout, DividesATableThatIsTooWide) {
  const double width = ReportPages::text_area().width();
  ReportTable table = long_table(3);
  table.columns = {{"participant"}, {"condition"}};
  for (auto& row : table.rows) row = {"virtual" + row[0].substr(4), "all"};
  for (int i = 0; i < 6; ++i) {
    table.columns.push_back({"JND " + std::to_string(i), true});
    table.columns.push_back({"95 % CI", true});
    for (auto& row : table.rows) row.insert(row.end(), {"10.7 µm", "[4.64 µm, 21.4 µm]"});
  }
  const std::vector<LaidOutTable> parts = lay_out(table, "DejaVu Sans", width);
  ASSERT_EQ(parts.size(), 2U);
  std::size_t next = 2;
  for (const LaidOutTable& part : parts) {
    EXPECT_GE(part.font.pixelSize(), 140) << "7 points";
    EXPECT_LE(part.right.back(), width + 1.0);
    ASSERT_GE(part.columns.size(), 6U);
    EXPECT_EQ(part.columns[0], 0U);
    EXPECT_EQ(part.columns[1], 1U);
    EXPECT_FALSE(table.columns[part.columns[2]].heading.starts_with("95 %"));
    for (std::size_t i = 2; i < part.columns.size(); ++i) EXPECT_EQ(part.columns[i], next++);
  }
  EXPECT_EQ(next, table.columns.size()) << "every column once";
  const ReportPages pages(report_with({table}));
  EXPECT_TRUE(stands_on(pages, 0, "Table 1. Many rows"));
  EXPECT_TRUE(stands_on(pages, 0, "Table 1, further columns"));
  take_pictures(pages, "report-wide-table");
}

TEST(PdfReport, HasAllPagesItsLettersAndNoPixels) {
  MadeUpStudy made;
  add_choices(made, 27);
  const Report report = report_of(made.study());
  const QByteArray pdf = QByteArray::fromStdString(pdf_of(report));
  EXPECT_TRUE(pdf.startsWith("%PDF-"));
  EXPECT_TRUE(pdf.trimmed().endsWith("%%EOF"));
  const ReportPages pages(report);
  EXPECT_EQ(static_cast<std::size_t>(pdf.count("/Type /Page\n")), pages.count());
  EXPECT_TRUE(pdf.contains("/FontFile2") || pdf.contains("/FontFile3")) << "fonts are in it";
  EXPECT_FALSE(pdf.contains("/Subtype /Image")) << "figures are vectors";
  // A4 in points.
  EXPECT_TRUE(pdf.contains("/MediaBox [0 0 595.") || pdf.contains("/MediaBox [0 0 595 842]"));
}

TEST(ReportFile, IsNotWrittenWhenItIsStopped) {
  MadeUpStudy made;
  add_choices(made, 20);
  std::stop_source source{};
  source.request_stop();
  for (const char* name : {"report.pdf", "report.html"}) {
    EXPECT_FALSE(
        write_report(made.study(), made.beside(name), Overwrite::refuse, {}, source.get_token()));
    EXPECT_FALSE(std::filesystem::exists(made.beside(name)));
  }
}

TEST(ReportFile, HasOneOfTwoEndings) {
  MadeUpStudy made;
  EXPECT_THROW(require_report_path("report.docx", Overwrite::allow), std::invalid_argument);
  EXPECT_THROW(require_report_path(made.folder() / "study.sqlite", Overwrite::allow),
               std::invalid_argument);
}

TEST(ReportFile, LooksAtItsFolderBeforeTheWork) {
  const MadeUpStudy made;
  const auto refusal = [](const std::filesystem::path& path) {
    return refusal_of<ResultsError>([&] { require_report_path(path, Overwrite::refuse); });
  };
  EXPECT_NE(refusal(made.beside("nowhere") / "report.pdf").find("there is no folder"),
            std::string::npos);
  std::filesystem::create_directory(made.beside("folder.pdf"));
  EXPECT_NE(refusal(made.beside("folder.pdf")).find("is a folder"), std::string::npos);
  EXPECT_EQ(refusal(made.beside("report.pdf")), "");
}

class SavingAReport : public testing::Test {
 protected:
  SavingAReport() {
    add_choices(made_, 27);
    study_ = std::make_unique<OpenStudy>(made_.folder());
    page_ = std::make_unique<AnalysisPage>(*study_);
    QSignalSpy refreshed(page_.get(), &AnalysisPage::refreshed);
    page_->show();
    refreshed.wait(kPatience_ms);
    button_ = page_->findChild<QPushButton*>("save_report");
    banner_ = page_->findChild<Banner*>();
  }
  void choose(const std::filesystem::path& file) {
    button_->click();
    auto* dialog = page_->findChild<QFileDialog*>("report_dialog");
    ASSERT_NE(dialog, nullptr);
    emit dialog->fileSelected(QString::fromStdString(file.string()));
    dialog->close();
  }
  bool told(const QString& words) {
    return eventually([&] { return banner_->isVisible() && banner_->text().contains(words); });
  }

  MadeUpStudy made_;
  std::unique_ptr<OpenStudy> study_{};
  std::unique_ptr<AnalysisPage> page_{};
  QPushButton* button_ = nullptr;
  Banner* banner_ = nullptr;
};

TEST_F(SavingAReport, WritesTheFileAndSaysWhereItIs) {
  ASSERT_TRUE(button_->isEnabled());
  choose(made_.beside("report.html"));
  ASSERT_TRUE(told("The report is in")) << banner_->text().toStdString();
  const std::string html = read_file(made_.beside("report.html"));
  EXPECT_NE(html.find("was chosen most often"), std::string::npos);
}

TEST_F(SavingAReport, ReplacesAFileOnlyWhenSomebodySaysSo) {
  const std::filesystem::path file = made_.beside("report.pdf");
  write_file(file, "precious", Overwrite::refuse);
  choose(file);
  ASSERT_TRUE(told("already exists"));
  EXPECT_EQ(read_file(file), "precious");
  for (QPushButton* each : banner_->findChildren<QPushButton*>()) {
    if (each->text() == "Replace it") each->click();
  }
  ASSERT_TRUE(told("The report is in"));
  EXPECT_TRUE(read_file(file).starts_with("%PDF-"));
}

TEST_F(SavingAReport, LeavesNothingBehindWhenItIsCancelled) {
  choose(made_.beside("report.pdf"));
  EXPECT_FALSE(button_->isEnabled()) << "one at a time";
  auto* line = page_->findChild<TaskLine*>("saving_report");
  line->findChild<QPushButton*>("task_cancel")->click();
  ASSERT_TRUE(eventually([this] { return button_->isEnabled(); }));
  // A machine that is busy elsewhere may notice too late.
  const bool in_time = banner_->text().contains("was cancelled");
  EXPECT_EQ(std::filesystem::exists(made_.beside("report.pdf")), !in_time);
}

}  // namespace
}  // namespace asperity
