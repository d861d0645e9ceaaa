// Figures of rated dissimilarities show the numbers of the findings.

#include "app/findings/methods/similarity/perceptual_map_figures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/figures/axis_ticks.h"
#include "app/figures/figure_files.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/family_figures.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/gui/data/drawn_case.h"
#include "tests/gui/data/drawn_svg.h"

namespace asperity {
namespace {

/// Six items, judged in every pair by five participants.
class PerceptualMap : public testing::Test {
 protected:
  PerceptualMap()
      : read_(test::case_to_draw(std::filesystem::path(ASPERITY_SOURCE_DIR) /
                                 "tests/analysis/reference/similarity_01")),
        findings_(tidy_family(read_.family).findings(read_.input)),
        figures_(figures_of(read_.family, read_.input, findings_, "mm")) {}

  const Figure& figure(const std::string& name) const {
    const auto found = std::find_if(figures_.begin(), figures_.end(),
                                    [&name](const Figure& one) { return one.name == name; });
    if (found == figures_.end()) throw std::runtime_error("no figure " + name);
    return *found;
  }
  double number(QuantityName quantity, const std::string& key) const {
    return FoundNumbers(findings_).value(quantity, key).value();
  }

  ReferenceCase read_{};
  std::vector<Finding> findings_{};
  std::vector<Figure> figures_{};
};

TEST_F(PerceptualMap, HasEachItemAtItsPositionInAnEllipse) {
  const Figure& map = figure("configuration");
  ASSERT_TRUE(map.is_drawn());
  ASSERT_EQ(map.series.size(), 2U);
  ASSERT_EQ(map.series[0].points.size(), 6U);
  ASSERT_EQ(map.series[1].lines.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const FigurePoint& point = map.series[0].points[i];
    const std::string item = point.label.english();
    EXPECT_EQ(point.x, number("position", item + "|1"));
    EXPECT_EQ(point.y, number("position", item + "|2"));
    double nearest = 1e9;
    double farthest = 0.0;
    for (const FigurePlace& place : map.series[1].lines[i]) {
      nearest = std::min(nearest, std::hypot(place.x - point.x, place.y - point.y));
      farthest = std::max(farthest, std::hypot(place.x - point.x, place.y - point.y));
      EXPECT_GE(place.x, map.x.low) << item;
      EXPECT_LE(place.x, map.x.high) << item;
      EXPECT_GE(place.y, map.y.low) << item;
      EXPECT_LE(place.y, map.y.high) << item;
    }
    EXPECT_NEAR(nearest, number("region.minor", item), 1e-9);
    EXPECT_NEAR(farthest, number("region.major", item), 1e-9);
    // The first place of an ellipse is the end of its major axis.
    const FigurePlace& end = map.series[1].lines[i].front();
    EXPECT_NEAR(std::atan2(end.y - point.y, end.x - point.x), number("region.angle", item), 1e-6);
  }
  EXPECT_DOUBLE_EQ(map.x.high - map.x.low, map.y.high - map.y.low) << "one unit on both axes";
}

TEST_F(PerceptualMap, ComparesDistancesWithDissimilaritiesOfAllPairs) {
  const Figure& shepard = figure("shepard_diagram");
  ASSERT_EQ(shepard.series.size(), 2U);
  ASSERT_EQ(shepard.series[0].points.size(), 15U);
  ASSERT_EQ(shepard.series[1].lines.size(), 1U);
  const std::vector<FigurePlace>& steps = shepard.series[1].lines.front();
  ASSERT_EQ(steps.size(), 15U);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    EXPECT_GE(steps[i].x, steps[i - 1].x);
    EXPECT_GE(steps[i].y, steps[i - 1].y) << "an isotonic regression";
  }
  // Stress-1 is the deviation of the points from the line: √(Σ(d − d̂)²/Σd²).
  double deviation = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double d = shepard.series[0].points[i].y;
    deviation += (d - steps[i].y) * (d - steps[i].y);
    sum += d * d;
  }
  EXPECT_NEAR(std::sqrt(deviation / sum), number("stress.ordinal", "2"), 1e-6);
}

TEST_F(PerceptualMap, HasTheStressOfEveryNumberOfDimensions) {
  const Figure& stress = figure("stress_by_dimensions");
  ASSERT_EQ(stress.series.size(), 2U);
  for (const FigurePoint& point : stress.series[0].points) {
    const std::string dimensions = std::to_string(static_cast<int>(point.x));
    EXPECT_EQ(point.y, number("stress.ordinal", dimensions));
  }
  EXPECT_EQ(stress.series[0].points.size(), 4U) << "six items";
  constexpr int kLabels = 7;
  for (const AxisTick& tick : ticks_of(stress.x, kLabels)) {
    EXPECT_EQ(tick.value, std::round(tick.value)) << "no half a dimension";
  }
}

TEST_F(PerceptualMap, HasTheWeightsOfEveryParticipantAndATree) {
  const Figure& weights = figure("weights_of_participants");
  ASSERT_EQ(weights.series.size(), 1U);
  ASSERT_EQ(weights.series[0].points.size(), 5U);
  for (const FigurePoint& point : weights.series[0].points) {
    EXPECT_EQ(point.x, number("indscal.weight", point.label.english() + "|1"));
    EXPECT_EQ(point.y, number("indscal.weight", point.label.english() + "|2"));
  }
  EXPECT_LE(weights.x.low, 0.0) << "weights are read from the origin";
  const Figure& tree = figure("similarity_tree");
  ASSERT_TRUE(tree.is_drawn());
  EXPECT_EQ(tree.title.english(), "Dendrogram of the rated dissimilarities");
  EXPECT_EQ(tree.y.places.size(), 6U);
}

TEST_F(PerceptualMap, IsDrawnWithAllItsNames) {
  for (const Figure& one : figures_) {
    const DrawnSvg svg = read_svg(QByteArray::fromStdString(svg_of(one, {})));
    EXPECT_FALSE(svg.words().isEmpty()) << one.name;
  }
  const DrawnSvg svg = read_svg(QByteArray::fromStdString(svg_of(figure("configuration"), {})));
  for (const char* const item : {"oak", "felt", "brick", "slate", "cork", "wool"}) {
    EXPECT_TRUE(svg.words().contains(item)) << item;
  }
}

// Labels would cover each other.
TEST_F(PerceptualMap, NamesItemsOnOnePlaceTogether) {
  Figure map = figure("configuration");
  std::vector<FigurePoint>& points = map.series[0].points;
  points[3].x = points[1].x;
  points[3].y = points[1].y;
  const QString both =
      QString::fromStdString(points[1].label.english() + ", " + points[3].label.english());
  const QStringList words = read_svg(QByteArray::fromStdString(svg_of(map, {}))).words();
  EXPECT_TRUE(words.contains(both)) << words.join('|').toStdString();
  EXPECT_FALSE(words.contains(QString::fromStdString(points[3].label.english())));
}

TEST_F(PerceptualMap, StatesThatItShowsTwoOfThreeDimensions) {
  EXPECT_EQ(figure("configuration").note.english().find("The first two of"), std::string::npos);
  std::vector<Finding> findings = findings_;
  for (Finding& finding : findings) {
    if (finding.quantity == "dimensions") finding.value = 3.0;
  }
  EXPECT_NE(figures_of("similarity", {}, findings)
                .front()
                .note.english()
                .find("The first two of 3 dimensions"),
            std::string::npos);
}

TEST(PerceptualMapWithoutNumbers, StatesWhyThereIsNone) {
  const std::vector<Finding> none{};
  const std::vector<Figure> nothing = figures_of("similarity", {}, none);
  for (const Figure& one : nothing) {
    EXPECT_FALSE(one.is_drawn()) << one.name;
    EXPECT_NE(one.instead.english().find("collect responses first"), std::string::npos) << one.name;
  }
  std::vector<Finding> findings(1);
  findings.front().quantity = "stress.ordinal";
  findings.front().word = "not_connected";
  EXPECT_EQ(figures_of("similarity", {}, findings).front().instead.english(),
            "There is no configuration: the rated pairs do not connect all items.");
}

}  // namespace
}  // namespace asperity
