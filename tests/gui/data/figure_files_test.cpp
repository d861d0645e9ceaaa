// Figures on paper: what is drawn where, in every form, and the same each time.

#include "app/figures/figure_files.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <QtCore/QLineF>
#include <QtGui/QFontMetricsF>
#include <QtGui/QImage>
#include <QtGui/QPainter>
#include <gtest/gtest.h>

#include "app/figures/axis_ticks.h"
#include "app/figures/draw_figure.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/study/family_figures.h"
#include "results_schema/study.h"
#include "tests/app/made_up_study.h"
#include "tests/gui/data/drawn_case.h"
#include "tests/gui/data/drawn_svg.h"

namespace asperity {
namespace {

std::filesystem::path all_cases() {
  return std::filesystem::path(ASPERITY_SOURCE_DIR) / "tests/analysis/reference";
}

std::vector<Figure> figures_of_case(const std::filesystem::path& folder) {
  const ReferenceCase read = test::case_to_draw(folder);
  return figures_of(read.family, read.input, tidy_family(read.family).findings(read.input), "mm");
}

DrawnSvg drawn(const Figure& figure, double width_mm = kColumnWidth_mm) {
  return read_svg(QByteArray::fromStdString(svg_of(figure, {.width_mm = width_mm})));
}

/// Two rows with intervals.
Figure small_forest() {
  Figure figure{.name = "small", .title = "Two shares", .shape = FigureShape::rows};
  figure.x = {.name = "share", .low = 0.0, .high = 1.0};
  figure.y.places = {"wood", "brick"};
  figure.series = {{.points = {{.x = 0.25, .y = 0.0, .x_interval = FigureSpan{0.1, 0.5}},
                               {.x = 0.75, .y = 1.0, .x_interval = FigureSpan{0.6, 1.0}}}}};
  figure.references = {{.value = 0.5, .label = "chance"}};
  return figure;
}

/// The left end of what is written at a tick, moved to its middle.
double middle_of(const DrawnSvg& svg, const QString& words) {
  for (const DrawnText& text : svg.texts) {
    if (text.words != words) continue;
    QFont font{};
    font.setFamily(QFontInfo(font).family());
    font.setPixelSize(static_cast<int>(text.letters));
    font.setHintingPreference(QFont::PreferNoHinting);
    return text.at.x() + QFontMetricsF(font).horizontalAdvance(words) / 2.0;
  }
  ADD_FAILURE() << "nothing says " << words.toStdString();
  return 0.0;
}

TEST(FigureFiles, PutPointsWhereTheTicksOfTheirAxisSay) {
  const DrawnSvg svg = drawn(small_forest());
  ASSERT_EQ(svg.circles.size(), 2);
  const double zero = middle_of(svg, "0");
  const double one = middle_of(svg, "1");
  ASSERT_GT(one - zero, 1000.0);
  EXPECT_NEAR(svg.circles[0].x(), zero + 0.25 * (one - zero), 1.0);
  EXPECT_NEAR(svg.circles[1].x(), zero + 0.75 * (one - zero), 1.0);
  EXPECT_LT(svg.circles[0].y(), svg.circles[1].y()) << "the first row is the upper one";
  // From 0.1 to 0.5 and from 0.6 to 1, at the heights of their points.
  const auto has_line = [&](double from, double to, double y) {
    for (const QList<QPointF>& line : svg.polylines) {
      if (line.size() == 2 && std::abs(line[0].x() - (zero + from * (one - zero))) < 1.0 &&
          std::abs(line[1].x() - (zero + to * (one - zero))) < 1.0 &&
          std::abs(line[0].y() - y) < 1.0) {
        return true;
      }
    }
    return false;
  };
  EXPECT_TRUE(has_line(0.1, 0.5, svg.circles[0].y()));
  EXPECT_TRUE(has_line(0.6, 1.0, svg.circles[1].y()));
  EXPECT_NEAR(middle_of(svg, "chance"), zero + 0.5 * (one - zero), 1.0);
}

TEST(FigureFiles, EndAnIntervalThatContinuesBeyondTheAxisWithAnArrow) {
  Figure figure = small_forest();
  const DrawnSvg capped = drawn(figure);
  figure.series[0].points[1].x_interval->high = 3.0;
  const DrawnSvg svg = drawn(figure);
  const double one = middle_of(svg, "1");
  // A cap is one line across the end; an arrow two that meet in it.
  const auto lines_into = [one](const DrawnSvg& in, double y) {
    int lines = 0;
    for (const QList<QPointF>& line : in.polylines) {
      const bool ends_there = QLineF(line.back(), QPointF(one, y)).length() < 1.0;
      lines += ends_there && std::abs(line.front().y() - y) > 10.0 ? 1 : 0;
    }
    return lines;
  };
  EXPECT_EQ(lines_into(svg, svg.circles[1].y()), 2);
  EXPECT_EQ(lines_into(capped, capped.circles[1].y()), 0);
}

TEST(FigureFiles, PutPowersOfTenAtEqualDistancesOnALogarithmicAxis) {
  Figure figure{.name = "powers"};
  figure.x = {.name = "spacing", .unit = "mm", .scale = AxisScale::log10, .low = 0.5, .high = 200};
  figure.y = {.name = "roughness", .scale = AxisScale::log10, .low = 0.1, .high = 10.0};
  figure.series = {{.points = {{.x = 1, .y = 0.1}, {.x = 10, .y = 1}, {.x = 100, .y = 10}}}};
  const DrawnSvg svg = drawn(figure);
  ASSERT_EQ(svg.circles.size(), 3);
  EXPECT_NEAR(svg.circles[0].x(), middle_of(svg, "1"), 1.0);
  EXPECT_NEAR(svg.circles[2].x(), middle_of(svg, "100"), 1.0);
  EXPECT_NEAR(2.0 * svg.circles[1].x(), svg.circles[0].x() + svg.circles[2].x(), 0.1);
  EXPECT_NEAR(2.0 * svg.circles[1].y(), svg.circles[0].y() + svg.circles[2].y(), 0.1);
  EXPECT_GT(svg.circles[0].y(), svg.circles[2].y()) << "numbers rise upwards";
}

// Without such a number readers cannot see what a distance on the axis means; response times of a
// quick task lie between 1.3 and 1.7 s, where no 1, 2 or 5 times a power of ten lies.
TEST(FigureFiles, LabelAtLeastTwoTicksOfEveryAxis) {
  for (const AxisScale scale : {AxisScale::log10, AxisScale::linear}) {
    for (const int power : {-7, -2, 0, 1, 6}) {
      for (double low = 1.0; low < 10.0; low *= 1.037) {
        for (double ratio = 1.01; ratio < 2000.0; ratio *= 1.17) {
          const double scaled = low * std::pow(10.0, power);
          const FigureAxis axis{.scale = scale, .low = scaled, .high = scaled * ratio};
          for (int labels = 2; labels <= 7; ++labels) {
            int labelled = 0;
            for (const AxisTick& tick : ticks_of(axis, labels)) {
              labelled += tick.label.empty() ? 0 : 1;
              ASSERT_GE(tick.value, axis.low * (1.0 - 1e-8));
              ASSERT_LE(tick.value, axis.high * (1.0 + 1e-8));
            }
            ASSERT_GE(labelled, 2) << axis.low << " to " << axis.high << ", " << labels;
          }
        }
      }
    }
  }
  Figure figure{.name = "quick"};
  figure.x = {.name = "response time", .unit = "s", .scale = AxisScale::log10};
  figure.x.low = 1.3;
  figure.x.high = 1.7;
  figure.y = {.name = "trials", .low = 0.0, .high = 1.0};
  figure.series = {{.points = {{.x = 1.5, .y = 0.5}}}};
  const DrawnSvg svg = drawn(figure);
  EXPECT_NEAR(svg.circles[0].x(), middle_of(svg, "1.5"), 1.0);
  EXPECT_LT(middle_of(svg, "1.4"), svg.circles[0].x());
}

TEST(FigureFiles, NameAxesWithTheirUnits) {
  Figure figure{.name = "units"};
  figure.x = {.name = "spacing", .unit = "mm", .low = 0.0, .high = 2.0};
  figure.y = {.name = "force", .unit = "N", .low = 0.0, .high = 1.0};
  figure.series = {{.points = {{.x = 1.0, .y = 0.5}}}};
  const QStringList words = drawn(figure).words();
  EXPECT_TRUE(words.contains("spacing (mm)"));
  EXPECT_TRUE(words.contains("force (N)"));
}

TEST(FigureFiles, SayWhyThereIsNothingInsteadOfAnEmptyPlot) {
  Figure figure = small_forest();
  figure.instead = "There is no answer yet.";
  const DrawnSvg svg = drawn(figure);
  EXPECT_EQ(svg.words().join(' '), "There is no answer yet.");
  EXPECT_TRUE(svg.circles.isEmpty());
  EXPECT_TRUE(svg.polylines.isEmpty());
}

TEST(FigureFiles, TellSeriesApartByShapeAsWellAsByColourAndNameThem) {
  Figure figure{.name = "series"};
  figure.series = {{.name = "slow", .style = 0, .points = {{.x = 0.2, .y = 0.2}}},
                   {.name = "quick", .style = 1, .points = {{.x = 0.8, .y = 0.8}}}};
  const DrawnSvg svg = drawn(figure);
  // Each once in the plot and once in the key.
  EXPECT_EQ(svg.circles.size(), 2);
  EXPECT_EQ(svg.rectangles.size(), 2);
  EXPECT_TRUE(svg.has_ground) << "words are dark in a viewer whose own ground is dark";
  EXPECT_TRUE(svg.words().contains("slow"));
  EXPECT_TRUE(svg.words().contains("quick"));
}

TEST(FigureFiles, WriteEveryCountIntoItsCellAndFrameTheRightOnes) {
  Figure figure{.name = "cells", .shape = FigureShape::square};
  figure.x.places = {"wood", "brick"};
  figure.y.places = {"wood", "brick"};
  figure.cells = {{.column = 0, .row = 0, .shade = 0.7, .text = "7", .framed = true},
                  {.column = 1, .row = 0, .shade = 0.3, .text = "3"},
                  {.column = 0, .row = 1, .shade = 0.1, .text = "11"},
                  {.column = 1, .row = 1, .shade = 0.9, .text = "99", .framed = true}};
  const DrawnSvg svg = drawn(figure);
  ASSERT_GE(svg.rectangles.size(), 6);  // and the frames of two
  for (int i = 0; i < 4; ++i) {
    const QRectF cell = svg.rectangles[i];
    const QString count = QString::fromStdString(figure.cells[static_cast<std::size_t>(i)].text);
    EXPECT_NEAR(middle_of(svg, count), cell.center().x(), 1.0) << count.toStdString();
  }
  EXPECT_NEAR(svg.rectangles[1].left(), svg.rectangles[0].right(), 0.1);
  EXPECT_NEAR(svg.rectangles[2].top(), svg.rectangles[0].bottom(), 0.1);
  EXPECT_TRUE(svg.rectangles[0].contains(svg.rectangles[4]));
  EXPECT_TRUE(svg.rectangles[3].contains(svg.rectangles[5]));
}

TEST(FigureFiles, AreTheSameBytesForTheSameFigure) {
  const Figure figure = small_forest();
  EXPECT_EQ(svg_of(figure), svg_of(figure));
  EXPECT_EQ(png_of(figure), png_of(figure));
  const std::string pdf = pdf_of(figure);
  EXPECT_EQ(pdf, pdf_of(figure));
  for (const char* const date : {"CreationDate", "ModDate", "CreateDate", "ModifyDate"}) {
    EXPECT_EQ(pdf.find(date), std::string::npos) << date;
  }
  // What comes after it still stands where the file says.
  const std::size_t at = pdf.rfind("startxref\n");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(pdf.compare(std::stoul(pdf.substr(at + 10)), 4, "xref"), 0);
}

/// All that our own cases give, at the width of a column and of a page: looked at by people where
/// ASPERITY_SCREENSHOTS names a folder.
TEST(FigureFiles, StayOnTheSheetInLettersThatCanBeReadForEveryKind) {
  const QString pictures = qEnvironmentVariable("ASPERITY_SCREENSHOTS");
  int seen = 0;
  for (const auto& entry : std::filesystem::directory_iterator(all_cases())) {
    if (!std::filesystem::exists(entry.path() / "case.json")) continue;
    for (const Figure& figure : figures_of_case(entry.path())) {
      for (const double width_mm : {kColumnWidth_mm, kPageWidth_mm}) {
        const std::string name = "figure-" + entry.path().filename().string() + "-" + figure.name +
                                 "-" + std::to_string(static_cast<int>(width_mm));
        if (!pictures.isEmpty()) {
          write_figure(std::filesystem::path(pictures.toStdString()) / (name + ".png"), figure,
                       {.width_mm = width_mm}, Overwrite::allow);
        }
        const DrawnSvg svg = drawn(figure, width_mm);
        ++seen;
        EXPECT_EQ(svg.width, QString("%1mm").arg(width_mm)) << name;
        EXPECT_EQ(svg.pictures, 0) << name << ": not of vectors";
        EXPECT_FALSE(svg.title.isEmpty()) << name;
        ASSERT_FALSE(svg.texts.isEmpty()) << name;
        for (const DrawnText& text : svg.texts) {
          constexpr double kSevenPoints = 7.0 / 72.0 * 2540.0;
          EXPECT_GE(text.letters, kSevenPoints) << name;
          if (text.is_turned) continue;
          QFont font{};
          font.setPixelSize(static_cast<int>(text.letters));
          const double breadth = QFontMetricsF(font).horizontalAdvance(text.words);
          EXPECT_GE(text.at.x(), 0.0) << name << ": " << text.words.toStdString();
          EXPECT_LE(text.at.x() + breadth, svg.view.right() + text.letters / 2.0)
              << name << ": " << text.words.toStdString();
          EXPECT_TRUE(svg.view.contains(text.at)) << name << ": " << text.words.toStdString();
        }
        for (const QPointF& middle : svg.circles) EXPECT_TRUE(svg.view.contains(middle)) << name;
        for (const QList<QPointF>& line : svg.polylines) {
          for (const QPointF& place : line) EXPECT_TRUE(svg.view.contains(place)) << name;
        }
      }
    }
  }
  EXPECT_GT(seen, 60);
}

TEST(FigureFiles, AreWrittenByTheirEndingAndNeverOverAnotherFileUnasked) {
  const MadeUpStudy made;
  const Figure figure = small_forest();
  for (const char* name : {"small.svg", "small.png", "small.pdf"}) {
    const std::filesystem::path file = made.beside(name);
    write_figure(file, figure, {}, Overwrite::refuse);
    EXPECT_GT(std::filesystem::file_size(file), 1000U) << name;
    EXPECT_THROW(write_figure(file, figure, {}, Overwrite::refuse), ResultsError) << name;
    EXPECT_NO_THROW(write_figure(file, figure, {}, Overwrite::allow)) << name;
  }
  EXPECT_EQ(read_file(made.beside("small.pdf")).substr(0, 5), "%PDF-");
  // 170 mm at 300 points per inch.
  EXPECT_EQ(QImage(QString::fromStdString(made.beside("small.png").string())).width(), 2008);
  EXPECT_THROW(write_figure(made.beside("small.bmp"), figure, {}, Overwrite::allow),
               std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(made.beside("small.bmp")));
}

TEST(FigureFiles, SpeakTheLanguageThatIsAskedFor) {
  Figure figure = small_forest();
  figure.x.name = phrase("Figures", "chance");
  const FigurePrint german{.look_up = [](const char*, const char* words) {
    return std::string(words) == "chance" ? "Zufall" : words;
  }};
  EXPECT_TRUE(
      read_svg(QByteArray::fromStdString(svg_of(figure, german))).words().contains("Zufall"));
}

TEST(DrawFigure, PaintsNothingOutsideOfItsRectangle) {
  QImage image(900, 700, QImage::Format_RGB32);
  image.fill(Qt::white);
  FigureLook look{};
  look.letters = 15.0;
  const QRect into(100, 100, 600, 400);
  QPainter painter(&image);
  draw_figure(small_forest(), painter, into, look);
  painter.end();
  ASSERT_LT(figure_height(small_forest(), into.width(), look), into.height());
  int inside = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (image.pixel(x, y) == qRgb(255, 255, 255)) continue;
      ASSERT_TRUE(into.contains(x, y)) << x << ", " << y;
      ++inside;
    }
  }
  EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace asperity
