// The figure of simulated power.

#include "app/power/curve/power_curve_figure.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/figure.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

/// 10 and 20 participants, 40 and 80 of 100 studies significant.
PowerCurve curve_of(const std::string& effect, const std::string& test) {
  PowerCurve curve{.effect = effect, .family = "pairs", .test = test};
  const std::vector<StudiesOfSize> studies{
      {.participants = 10, .significant = {.hits = 40, .trials = 100}},
      {.participants = 20, .significant = {.hits = 80, .trials = 100}}};
  for (const PowerOfSize& size : monotone_power(studies)) curve.sizes.push_back({.power = size});
  return curve;
}

std::vector<std::string> names(const Figure& figure) {
  std::vector<std::string> all{};
  for (const FigureSeries& series : figure.series) all.push_back(series.name.english());
  return all;
}

TEST(PowerCurveFigure, HasTheIntervalOfEveryNumberAndTheFit) {
  const Figure figure =
      power_curve_figure(std::vector{curve_of("e=1", "order"), curve_of("e=1", "")});
  ASSERT_TRUE(figure.is_drawn());
  ASSERT_THAT(figure.series, SizeIs(1));  // the family is left out
  const FigureSeries& series = figure.series.front();
  EXPECT_EQ(series.name.english(), "");
  ASSERT_THAT(series.points, SizeIs(2));
  EXPECT_EQ(series.points[1].x, 20.0);
  EXPECT_EQ(series.points[1].y, 0.8);
  // Clopper and Pearson: 80 of 100.
  ASSERT_TRUE(series.points[1].y_interval);
  EXPECT_NEAR(series.points[1].y_interval->low, 0.7082, 1e-4);
  EXPECT_NEAR(series.points[1].y_interval->high, 0.8734, 1e-4);
  ASSERT_THAT(series.lines, SizeIs(1));
  EXPECT_EQ(series.lines[0][0].y, 0.4);
  ASSERT_THAT(figure.references, SizeIs(2));
  EXPECT_EQ(figure.references[1].value, 0.9);
}

TEST(PowerCurveFigure, NamesWhatDiffers) {
  EXPECT_EQ(
      names(power_curve_figure(std::vector{curve_of("e=1", "order"), curve_of("e=2", "order")})),
      (std::vector<std::string>{"e=1", "e=2"}));
  EXPECT_EQ(
      names(power_curve_figure(std::vector{curve_of("e=1", "order"), curve_of("e=1", "side")})),
      (std::vector<std::string>{"order", "side"}));
  EXPECT_EQ(
      names(power_curve_figure(std::vector{curve_of("e=1", "order"), curve_of("e=2", "side")})),
      (std::vector<std::string>{"e=1 · order", "e=2 · side"}));
}

TEST(PowerCurveFigure, ShowsTheFamilyWhereItHasTooManyTests) {
  std::vector<PowerCurve> curves{};
  for (int test = 0; test < 7; ++test) curves.push_back(curve_of("e=1", std::to_string(test)));
  curves.push_back(curve_of("e=1", ""));
  curves.push_back(curve_of("e=2", ""));
  EXPECT_EQ(names(power_curve_figure(curves)), (std::vector<std::string>{"e=1", "e=2"}));
  curves.pop_back();
  EXPECT_EQ(names(power_curve_figure(curves)), (std::vector<std::string>{""}));
}

TEST(PowerCurveFigure, WithoutStudiesStatesWhy) {
  EXPECT_THAT(power_curve_figure({}).instead.english(), HasSubstr("no study was simulated"));
}

}  // namespace
}  // namespace asperity
