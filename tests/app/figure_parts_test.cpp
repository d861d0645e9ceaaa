// A figure with many rows, divided for the pages of a report.

#include "app/report/text/figure_parts.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// A row for each pair of ten models, with two marks per row where `marks` is 2.
Figure forest(std::size_t rows, std::size_t marks) {
  Figure figure{.name = "pairs", .title = "Choices", .shape = FigureShape::rows};
  figure.marks_per_row = marks;
  figure.series.resize(marks);
  for (std::size_t row = 0; row < rows; ++row) {
    figure.y.places.emplace_back("row " + std::to_string(row));
    for (std::size_t mark = 0; mark < marks; ++mark) {
      const double offset = marks == 1 ? 0.0 : mark == 0 ? -0.2 : 0.2;
      figure.series[mark].points.push_back(
          {.x = static_cast<double>(row), .y = static_cast<double>(row) + offset});
    }
  }
  return figure;
}

TEST(FigureParts, HaveEveryRowOnceWithItsMarks) {
  for (const std::size_t marks : {1U, 2U}) {
    const std::vector<Figure> parts = parts_of_rows(forest(45, marks));
    ASSERT_EQ(parts.size(), marks == 1 ? 2U : 3U);
    std::size_t row = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_EQ(parts[i].title.english(),
                "Choices, part " + std::to_string(i + 1) + " of " + std::to_string(parts.size()));
      for (const FigureSeries& series : parts[i].series) {
        ASSERT_EQ(series.points.size(), parts[i].y.places.size());
      }
      for (std::size_t place = 0; place < parts[i].y.places.size(); ++place, ++row) {
        EXPECT_EQ(parts[i].y.places[place].english(), "row " + std::to_string(row));
        for (const FigureSeries& series : parts[i].series) {
          EXPECT_EQ(series.points[place].x, static_cast<double>(row));
          EXPECT_NEAR(series.points[place].y, static_cast<double>(place), 0.21);
        }
      }
    }
    EXPECT_EQ(row, 45U);
  }
}

// A profile or a tree would lose what crosses a division.
TEST(FigureParts, AreTheFigureItselfWhereLinesJoinItsRows) {
  Figure figure = forest(45, 1);
  figure.series.front().lines = {{{.x = 0.0, .y = 10.0}, {.x = 1.0, .y = 30.0}}};
  EXPECT_EQ(parts_of_rows(figure).size(), 1U);
  figure.series.front().lines = {{{.x = 0.0, .y = 10.0}, {.x = 1.0, .y = 10.0}}};
  EXPECT_EQ(parts_of_rows(figure).size(), 2U);
}

TEST(FigureParts, AreTheFigureItselfWhereItFitsOnAPage) {
  const std::vector<Figure> parts = parts_of_rows(forest(12, 2));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts.front().title.english(), "Choices");
}

}  // namespace
}  // namespace asperity
