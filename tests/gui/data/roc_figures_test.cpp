// Figures of the ROC of confidence ratings.

#include "app/findings/methods/discrimination/sensitivity/roc_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/tail_probabilities.h"
#include "app/figures/figure_files.h"
#include "app/findings/gathering/answer_columns.h"
#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/family_figures.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/stored_tables.h"
#include "tests/gui/data/drawn_svg.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

struct PlantedRoc {
  std::string key{};
  double mean = 0.0;
  double deviation = 1.0;
};
constexpr std::array kRocCriteria{-0.8, 0.0, 0.8, 1.6};

/// 1000 trials of noise, N(0, 1), and of a signal for each key, in five ratings.
TidyInput planted_ratings(const std::vector<PlantedRoc>& planted) {
  LabelRows conditions{};
  NumberColumn ratings{};
  NumberColumn noise{};
  NumberColumn signal{};
  for (const PlantedRoc& each : planted) {
    double noise_above = 1.0;
    double signal_above = 1.0;
    for (std::size_t rating = 1; rating <= kRocCriteria.size() + 1; ++rating) {
      const bool is_last = rating > kRocCriteria.size();
      const double criterion = is_last ? 0.0 : kRocCriteria[rating - 1];
      const double noise_next = is_last ? 0.0 : normal_below(-criterion);
      const double signal_next =
          is_last ? 0.0 : normal_below((each.mean - criterion) / each.deviation);
      conditions.add(each.key);
      ratings.emplace_back(static_cast<double>(rating));
      noise.emplace_back(std::round(1000.0 * noise_above) - std::round(1000.0 * noise_next));
      signal.emplace_back(std::round(1000.0 * signal_above) - std::round(1000.0 * signal_next));
      noise_above = noise_next;
      signal_above = signal_next;
    }
  }
  TidyInput input{};
  input.tables.emplace_back(
      std::vector<TidyTable::Column>{{"condition", std::move(conditions).take()},
                                     {"rating", std::move(ratings)},
                                     {"noise", std::move(noise)},
                                     {"signal", std::move(signal)}},
      "the ratings");
  return input;
}

/// A study with two levels in a condition, and the ROC of one participant at the first.
AnalysisOutcome outcome_with_roc(const std::string& condition) {
  AnalysisOutcome outcome{};
  outcome.tables.push_back(result_of(
      {.name = kConfidenceRoc,
       .table = {
           {"participant", "condition", "parameter", "level", "unit"},
           {{std::string("all participants"), condition, std::string("amplitude_m"), 5.5e-05,
             std::string("m")},
            {std::string("p1"), condition, std::string("amplitude_m"), 5.5e-05, std::string("m")},
            {std::string("all participants"), condition, std::string("amplitude_m"), 6.5e-05,
             std::string("m")}}}}));
  outcome.questions.push_back({.name = kConfidenceRoc, .table = kConfidenceRoc});
  outcome.findings = roc_findings(planted_ratings({{condition + "|5.5e-05", 0.8},
                                                   {condition + "|5.5e-05|p1", 1.2},
                                                   {condition + "|6.5e-05", 1.6}}));
  for (Finding& finding : outcome.findings) finding.analysis = kConfidenceRoc;
  return outcome;
}

const Figure& roc_named(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&name](const Figure& one) { return one.name == name; });
  if (found == figures.end()) throw std::runtime_error("no figure " + name);
  return *found;
}

/// By trapezoids.
double area_below(const std::vector<FigurePlace>& curve) {
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    area += 0.5 * (curve[i].x - curve[i - 1].x) * (curve[i].y + curve[i - 1].y);
  }
  return area;
}

TEST(RocFigures, DrawTheFittedCurveThroughThePointsOverItsArea) {
  const PlantedRoc planted{"wood", 1.2, 1.5};
  const TidyInput input = planted_ratings({planted});
  const std::vector<Finding> findings = roc_findings(input);
  const std::vector<Figure> figures = figures_of("roc", input, findings, "");
  ASSERT_EQ(figures.size(), 1U);
  const Figure& figure = figures.front();
  ASSERT_TRUE(figure.is_drawn());
  EXPECT_EQ(figure.shape, FigureShape::square);
  ASSERT_EQ(figure.series.size(), 1U);
  const FigureSeries& roc = figure.series.front();
  EXPECT_TRUE(roc.name.empty()) << "one curve needs no legend";
  ASSERT_EQ(roc.points.size(), kRocCriteria.size()) << "a point per criterion";
  for (std::size_t i = 0; i < roc.points.size(); ++i) {
    EXPECT_NEAR(roc.points[i].x, normal_below(-kRocCriteria[i]), 6e-4);
    EXPECT_NEAR(roc.points[i].y, normal_below((planted.mean - kRocCriteria[i]) / planted.deviation),
                6e-4);
  }
  ASSERT_EQ(roc.lines.size(), 1U);
  const std::vector<FigurePlace>& curve = roc.lines.front();
  EXPECT_NEAR(curve.front().x, 0.0, 1e-4);
  EXPECT_NEAR(curve.front().y, 0.0, 1e-4);
  EXPECT_NEAR(curve.back().x, 1.0, 1e-4);
  EXPECT_NEAR(curve.back().y, 1.0, 1e-4);
  const double area = *FoundNumbers(findings).value("uv.az", "wood");
  EXPECT_NEAR(area_below(curve), area, 1e-3);
  EXPECT_THAT(figure.note.english(), HasSubstr("A_z: wood: " + display_number(area) + "."));
}

TEST(RocFigures, HaveACurveForEveryLevelAndAFigureForEveryParticipant) {
  const AnalysisOutcome outcome = outcome_with_roc("all");
  const std::vector<Figure> figures = roc_figures(outcome.tables.front(), outcome);
  ASSERT_EQ(figures.size(), 2U);
  EXPECT_EQ(figures.front().name, "roc") << "all participants first";
  EXPECT_EQ(figures.front().question, kConfidenceRoc);
  ASSERT_EQ(figures.front().series.size(), 2U);
  EXPECT_EQ(figures.front().series[1].name.english(), "65 µm");
  EXPECT_EQ(figures.front().series[1].points.size(), kRocCriteria.size())
      << "not those of a participant";
  EXPECT_THAT(figures.front().note.english(), HasSubstr("; 65 µm: 0.87"));
  const Figure& single = roc_named(figures, "roc_p1");
  EXPECT_TRUE(single.question.empty());
  EXPECT_EQ(single.title.english(), "ROC of the confidence ratings of participant p1");
  ASSERT_EQ(single.series.size(), 1U);
  EXPECT_NEAR(area_below(single.series.front().lines.at(0)), normal_below(1.2 / std::sqrt(2.0)),
              2e-3);
}

TEST(RocFigures, NameTheConditionWhereThereAreSeveral) {
  AnalysisOutcome outcome = outcome_with_roc("wood");
  const AnalysisOutcome more = outcome_with_roc("steel");
  ResultTable& table = outcome.tables.front();
  const ResultTable& added = more.tables.front();
  table.rows.insert(table.rows.end(), added.rows.begin(), added.rows.end());
  outcome.findings.insert(outcome.findings.end(), more.findings.begin(), more.findings.end());
  const std::vector<Figure> figures = roc_figures(outcome.tables.front(), outcome);
  EXPECT_EQ(figures.size(), 4U);
  EXPECT_EQ(roc_named(figures, "roc_steel").title.english(),
            "ROC of the confidence ratings: steel");
  EXPECT_TRUE(roc_named(figures, "roc_p1_wood").is_drawn());
}

TEST(RocFigures, NameTheParameterWhereTasksVarySeveral) {
  AnalysisOutcome outcome = outcome_with_roc("all");
  AnalysisOutcome more = outcome_with_roc("all");
  for (ResultRow& row : more.tables.front().rows) row[2] = std::string("spacing_m");
  ResultTable& table = outcome.tables.front();
  const ResultTable& added = more.tables.front();
  table.rows.insert(table.rows.end(), added.rows.begin(), added.rows.end());
  const std::vector<Figure> figures = roc_figures(outcome.tables.front(), outcome);
  ASSERT_EQ(figures.size(), 4U);
  EXPECT_TRUE(roc_named(figures, "roc_amplitude_m").is_drawn());
  EXPECT_THAT(roc_named(figures, "roc_p1_spacing_m").title.english(), HasSubstr(": spacing"));
}

TEST(RocFigures, StateWhyThereIsNothingToDraw) {
  TidyInput input = planted_ratings({});
  const std::vector<Figure> figures = figures_of("roc", input, {}, "");
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_THAT(figures.front().instead.english(), HasSubstr("An ROC needs trials with and trials"));
}

TEST(RocFigures, HaveADiagonalAcrossASquare) {
  const TidyInput input = planted_ratings({{"wood", 1.2, 1.5}});
  const Figure figure = figures_of("roc", input, roc_findings(input), "").front();
  const DrawnSvg svg =
      read_svg(QByteArray::fromStdString(svg_of(figure, {.width_mm = kColumnWidth_mm})));
  ASSERT_EQ(svg.circles.size(), static_cast<qsizetype>(kRocCriteria.size()));
  // Both axes have the same scale, in which the diagonal is the line of equal numbers.
  const std::vector<FigurePoint>& points = figure.series.front().points;
  const double per_x = (svg.circles[0].x() - svg.circles[3].x()) / (points[0].x - points[3].x);
  const double per_y = (svg.circles[3].y() - svg.circles[0].y()) / (points[0].y - points[3].y);
  EXPECT_NEAR(per_x, per_y, 0.01 * per_x);
  const QPointF origin(svg.circles[0].x() - per_x * points[0].x,
                       svg.circles[0].y() + per_y * points[0].y);
  const QPointF corner = origin + QPointF(per_x, -per_y);
  EXPECT_TRUE(std::any_of(svg.polylines.begin(), svg.polylines.end(), [&](const auto& line) {
    return line.size() == 2 && (line[0] - origin).manhattanLength() < 4.0 &&
           (line[1] - corner).manhattanLength() < 4.0;
  }));
  EXPECT_TRUE(svg.words().contains("chance level"));
}

}  // namespace
}  // namespace asperity
