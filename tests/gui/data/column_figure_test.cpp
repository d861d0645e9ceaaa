// Figures of columns of a table.

#include "app/findings/shared/figures/column_figure.h"

#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/findings/outcome/figure.h"

namespace asperity {
namespace {

Table moved_table() {
  return {.columns = {"time_s", "x_m", "fx_N", "fz_N", "qw"},
          .rows = {{0.0, 0.001, 0.0, 1.0, 1.0},
                   {0.5, 0.002, -0.5, 2.0, 1.0},
                   {1.0, 0.003, Cell(), 3.0, 1.0},
                   {1.5, 0.004, 0.25, std::string("4"), 1.0}}};
}

TEST(ColumnFigure, DrawsALineForEachColumnWithItsUnit) {
  const Figure figure = column_figure(moved_table(), {.x = "x_m", .y = {"fx_N", "fz_N"}});
  ASSERT_TRUE(figure.is_drawn());
  EXPECT_EQ(figure.x.name.english(), "x");
  EXPECT_EQ(figure.x.unit, "m");
  EXPECT_EQ(figure.y.name.english(), "fx, fz");
  EXPECT_EQ(figure.y.unit, "N");
  ASSERT_EQ(figure.series.size(), 2U);
  EXPECT_EQ(figure.series[0].name.english(), "fx");
  EXPECT_NE(figure.series[0].style, figure.series[1].style);
  // A missing number interrupts the line.
  ASSERT_EQ(figure.series[0].lines.size(), 2U);
  EXPECT_EQ(figure.series[0].lines[0].size(), 2U);
  ASSERT_EQ(figure.series[1].lines.size(), 1U);
  EXPECT_EQ(figure.series[1].lines[0].back().y, 4.0);
  EXPECT_LT(figure.y.low, -0.5);
  EXPECT_GT(figure.y.high, 4.0);
  EXPECT_LT(figure.x.low, 0.001);
  EXPECT_GT(figure.x.high, 0.004);
}

TEST(ColumnFigure, RefusesColumnsThatCannotShareAnAxis) {
  const auto refused = [](const ColumnChoice& choice) {
    try {
      require_columns(moved_table().columns, choice);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refused({.x = "x_m", .y = {"fx_N", "fz_N"}}), "");
  EXPECT_NE(refused({.x = "x_m", .y = {"fx_N", "time_s"}}).find("different units"),
            std::string::npos);
  EXPECT_NE(refused({.x = "x", .y = {"fx_N"}}).find("there is no column \"x\"; write one of"),
            std::string::npos);
  EXPECT_NE(refused({.x = "x_m", .y = {"fx_N", "fx_N"}}).find("named twice"), std::string::npos);
  EXPECT_NE(refused({.x = "x_m", .y = {}}).find("at least one"), std::string::npos);
}

}  // namespace
}  // namespace asperity
