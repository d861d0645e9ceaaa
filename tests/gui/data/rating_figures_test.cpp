// Figures of ratings: profiles of items over scales, and the biplot of their components.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <QtGui/QFont>
#include <QtGui/QFontInfo>
#include <QtGui/QFontMetricsF>
#include <gtest/gtest.h>

#include "app/figures/figure_files.h"
#include "app/figures/label_places.h"
#include "app/findings/methods/rating/biplot_figure.h"
#include "app/findings/methods/rating/profile_figure.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/family_figures.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/stored_tables.h"
#include "tests/gui/data/drawn_svg.h"

namespace asperity {
namespace {

struct Rated {
  std::string scale{};
  std::string item{};
  Cell mean{};
  Cell low{};
  Cell high{};
  std::int64_t persons = 12;
};

StoredTable ratings_of(const std::vector<Rated>& rows) {
  StoredTable table{.name = "ratings",
                    .table = {{"scale", "item", "persons", "mean", "mean_low", "mean_high"}, {}}};
  for (const Rated& row : rows) {
    table.table.rows.push_back({row.scale, row.item, row.persons, row.mean, row.low, row.high});
  }
  return table;
}

/// "rough" from smooth to rough, "hard" from soft to hard, both from −3 to 3.
StoredTable two_scales() {
  return {.name = "scales",
          .table = {{"scale", "minimum", "low_label", "maximum", "high_label", "points"},
                    {{std::string("rough"), -3.0, std::string("smooth"), 3.0, std::string("rough"),
                      std::int64_t{7}},
                     {std::string("hard"), -3.0, std::string("soft"), 3.0, std::string("hard"),
                      std::int64_t{7}}}}};
}

Figure profile_of(const StoredTable& ratings, const StoredTable* scales) {
  if (scales == nullptr) return profile_figure(result_of(ratings), nullptr);
  const ResultTable shown = result_of(*scales);
  return profile_figure(result_of(ratings), &shown);
}

StoredTable two_profiles() {
  return ratings_of({{"rough", "metal", -1.0, -1.5, -0.5},
                     {"rough", "wood", 2.0, 1.0, 3.0},
                     {"hard", "metal", 0.5, 0.0, 1.0},
                     {"hard", "wood", 1.5, 1.0, 2.0}});
}

std::vector<std::string> words_of(const std::vector<Phrase>& phrases) {
  std::vector<std::string> words{};
  for (const Phrase& phrase : phrases) words.push_back(phrase.english());
  return words;
}

TEST(ProfileFigure, HasARowPerScaleBetweenItsEndsAndALinePerItem) {
  const StoredTable scales = two_scales();
  const Figure figure = profile_of(two_profiles(), &scales);
  ASSERT_TRUE(figure.is_drawn());
  EXPECT_EQ(words_of(figure.y.places), (std::vector<std::string>{"smooth", "soft"}));
  EXPECT_EQ(words_of(figure.y.far_places), (std::vector<std::string>{"rough", "hard"}));
  EXPECT_EQ(figure.x.low, -3.0);
  EXPECT_EQ(figure.x.high, 3.0);
  ASSERT_EQ(figure.series.size(), 2U);
  const FigureSeries& metal = figure.series[0];
  const FigureSeries& wood = figure.series[1];
  EXPECT_EQ(metal.name.english(), "metal");
  EXPECT_NE(metal.style, wood.style);
  ASSERT_EQ(metal.points.size(), 2U);
  EXPECT_EQ(metal.points[0].x, -1.0);
  EXPECT_EQ(metal.points[0].x_interval->low, -1.5);
  EXPECT_EQ(metal.points[1].x, 0.5);
  EXPECT_EQ(wood.points[0].x_interval->high, 3.0);
  // One above the other in the row, and at the same distance in all rows.
  EXPECT_LT(metal.points[0].y, wood.points[0].y);
  EXPECT_DOUBLE_EQ(metal.points[1].y - metal.points[0].y, 1.0);
  EXPECT_DOUBLE_EQ(metal.points[0].y + wood.points[0].y, 0.0);
  ASSERT_EQ(metal.lines.size(), 1U);
  EXPECT_EQ(metal.lines[0][1].x, 0.5);
  EXPECT_NE(figure.note.english().find("(n = 12)"), std::string::npos) << figure.note.english();
}

TEST(ProfileFigure, DrawsEachRowOverItsOwnScaleIfTheyDiffer) {
  StoredTable scales = two_scales();
  scales.table.rows[1][1] = 0.0;  // hard: from 0 to 2
  scales.table.rows[1][3] = 2.0;
  const Figure figure = profile_of(two_profiles(), &scales);
  EXPECT_EQ(figure.x.low, 0.0);
  EXPECT_EQ(figure.x.high, 100.0);
  EXPECT_NEAR(figure.series[0].points[0].x, 100.0 / 3.0, 1e-12);  // −1 of −3 to 3
  EXPECT_NEAR(figure.series[0].points[1].x, 25.0, 1e-12);         // 0.5 of 0 to 2
  EXPECT_NEAR(figure.series[0].points[1].x_interval->high, 50.0, 1e-12);
  EXPECT_NE(figure.note.english().find("each row is drawn over the range of its scale"),
            std::string::npos);
}

TEST(ProfileFigure, NamesScalesWhoseEndsDoNotDistinguishThem) {
  StoredTable scales = two_scales();
  for (std::vector<Cell>& row : scales.table.rows) {
    row[2] = std::string("not at all");
    row[4] = std::string("very");
  }
  Figure figure = profile_of(two_profiles(), &scales);
  EXPECT_EQ(words_of(figure.y.places),
            (std::vector<std::string>{"rough: not at all", "hard: not at all"}));
  EXPECT_EQ(words_of(figure.y.far_places), (std::vector<std::string>{"very", "very"}));
  for (std::vector<Cell>& row : scales.table.rows) row[2] = row[4] = Cell{};
  figure = profile_of(two_profiles(), &scales);
  EXPECT_EQ(words_of(figure.y.places), (std::vector<std::string>{"rough", "hard"}));
  EXPECT_TRUE(figure.y.far_places.empty());
}

TEST(ProfileFigure, ExplainsTheArrowsOfIntervalsThatLeaveTheScale) {
  const StoredTable scales = two_scales();
  constexpr const char* kArrow = "An arrow marks a CI that continues beyond the end of the scale.";
  EXPECT_EQ(profile_of(two_profiles(), &scales).note.english().find(kArrow), std::string::npos);
  StoredTable ratings = two_profiles();
  ratings.table.rows[1][5] = 3.2;
  EXPECT_NE(profile_of(ratings, &scales).note.english().find(kArrow), std::string::npos);
}

// Without a range the axis holds all intervals.
TEST(ProfileFigure, NeedsNeitherRangesNorIntervals) {
  Figure figure = profile_of(two_profiles(), nullptr);
  EXPECT_EQ(words_of(figure.y.places), (std::vector<std::string>{"rough", "hard"}));
  EXPECT_EQ(figure.x.low, -1.5);
  EXPECT_EQ(figure.x.high, 3.0);
  const StoredTable one_person = ratings_of(
      {{"rough", "metal", -1.0, Cell{}, Cell{}, 1}, {"hard", "metal", 0.5, Cell{}, Cell{}, 1}});
  figure = profile_of(one_person, nullptr);
  ASSERT_TRUE(figure.is_drawn());
  EXPECT_FALSE(figure.series[0].points[0].x_interval.has_value());
  EXPECT_NE(figure.note.english().find("there are no CIs"), std::string::npos);
  EXPECT_EQ(figure.x.name.english(), "mean rating");
}

TEST(ProfileFigure, InterruptsALineWhereAMeanIsMissing) {
  const Figure figure = profile_of(ratings_of({{"rough", "metal", -1.0, -1.5, -0.5},
                                               {"hard", "wood", 1.0, 0.0, 2.0},
                                               {"slippery", "metal", 0.5, 0.0, 1.0, 10},
                                               {"coarse", "metal", 0.5, 0.0, 1.0}}),
                                   nullptr);
  ASSERT_EQ(figure.series.size(), 2U);
  ASSERT_EQ(figure.series[0].lines.size(), 2U);
  EXPECT_EQ(figure.series[0].lines[0].size(), 1U);
  EXPECT_EQ(figure.series[0].lines[1].size(), 2U);
  EXPECT_NE(figure.note.english().find("(n = 10 to 12)"), std::string::npos);
}

TEST(ProfileFigure, DistinguishesTwelveItemsAndRefusesMore) {
  std::vector<Rated> rows{};
  for (int item = 0; item < 12; ++item) {
    for (const char* scale : {"rough", "hard"}) {
      rows.push_back(
          {scale, "item" + std::to_string(item), 0.5 * item, 0.5 * item - 1.0, 0.5 * item + 1.0});
    }
  }
  const Figure twelve = profile_of(ratings_of(rows), nullptr);
  std::vector<std::pair<int, bool>> looks{};
  for (const FigureSeries& one : twelve.series) {
    const std::pair<int, bool> look(one.style, one.hollow);
    EXPECT_EQ(std::count(looks.begin(), looks.end(), look), 0) << one.name.english();
    looks.push_back(look);
    for (const FigurePoint& point : one.points) {
      EXPECT_LT(std::abs(point.y - std::round(point.y)), 0.5);
    }
  }
  EXPECT_EQ(looks.size(), 12U);
  rows.push_back({"rough", "another", 0.0, -1.0, 1.0});
  EXPECT_NE(profile_of(ratings_of(rows), nullptr).instead.english().find("13 items"),
            std::string::npos);
  for (Rated& row : rows) row.mean = Cell{};
  EXPECT_FALSE(profile_of(ratings_of(rows), nullptr).is_drawn());
}

/// The scores of four items on three scales, of which the first two are the same.
TidyInput four_items() {
  TidyInput input{};
  input.tables.emplace_back(
      "item,scale,score\n"
      "a,rough,1\na,coarse,1\na,hard,2\n"
      "b,rough,2\nb,coarse,2\nb,hard,1\n"
      "c,rough,3\nc,coarse,3\nc,hard,4\n"
      "d,rough,4\nd,coarse,4\nd,hard,2\n",
      "means.csv");
  return input;
}

/// The findings of four_items with another number of retained components.
std::vector<Finding> components_with(double retained) {
  std::vector<Finding> findings = tidy_family("components").findings(four_items());
  for (Finding& finding : findings) {
    if (finding.quantity == "retained") finding.value = retained;
  }
  return findings;
}

TEST(BiplotFigure, HasScoresAsPointsAndLoadingsAsArrowsInEqualUnits) {
  const TidyInput input = four_items();
  const std::vector<Finding> findings = tidy_family("components").findings(input);
  const FoundNumbers found(findings);
  const std::vector<Figure> figures = figures_of("components", input, findings);
  ASSERT_EQ(figures.size(), 1U);
  const Figure& figure = figures.front();
  ASSERT_TRUE(figure.is_drawn()) << figure.instead.english();
  EXPECT_EQ(figure.shape, FigureShape::square);
  ASSERT_EQ(figure.series.size(), 2U);
  const FigureSeries& items = figure.series[0];
  ASSERT_EQ(items.points.size(), 4U);
  EXPECT_EQ(items.points[3].label.english(), "d");
  // Standardised: the products of points and arrows are the ratings, as far as two components have them.
  EXPECT_EQ(items.points[3].x, found.value("score", "d|C1").value() /
                                   std::sqrt(found.value("eigenvalue", "C1").value()));
  EXPECT_EQ(items.points[3].y, found.value("score", "d|C2").value() /
                                   std::sqrt(found.value("eigenvalue", "C2").value()));
  const FigureSeries& scales = figure.series[1];
  ASSERT_EQ(scales.arrows.size(), 3U);
  EXPECT_EQ(scales.arrows[2].label.english(), "hard");
  // One factor for all arrows, in the legend and in the note.
  const double factor = scales.arrows[2].to.x / found.value("loading", "hard|C1").value();
  EXPECT_NEAR(scales.arrows[2].to.y, factor * found.value("loading", "hard|C2").value(), 1e-12);
  EXPECT_NEAR(scales.arrows[0].to.x, factor * found.value("loading", "rough|C1").value(), 1e-12);
  EXPECT_EQ(scales.name.english(), factor == 1.0 ? "scales (loadings)" : "scales (loadings × 1.5)");
  const std::string percent =
      std::to_string(std::lround(100.0 * found.value("proportion", "C1").value()));
  EXPECT_EQ(figure.x.name.english(), "C1 (" + percent + " % of the variance)");
  for (const FigureAxis* axis : {&figure.x, &figure.y}) {
    EXPECT_LT(axis->low, 0.0);
    EXPECT_GT(axis->high, 0.0);
  }
  for (const FigurePoint& point : items.points) {
    EXPECT_TRUE(point.x > figure.x.low && point.x < figure.x.high && point.y > figure.y.low &&
                point.y < figure.y.high);
  }
  EXPECT_LE(figure.y.high - figure.y.low, figure.x.high - figure.x.low + 1e-12);
}

TEST(BiplotFigure, StatesWhatParallelAnalysisRetains) {
  const auto note = [](double retained) {
    const std::vector<Finding> findings = components_with(retained);
    return biplot_figure(FoundNumbers(findings)).note.english();
  };
  EXPECT_NE(note(0.0).find("retains no component"), std::string::npos);
  EXPECT_NE(note(1.0).find("retains only the first component"), std::string::npos);
  EXPECT_EQ(note(2.0).find("Parallel analysis"), std::string::npos);
  EXPECT_EQ(note(3.0).find("Parallel analysis"), std::string::npos);
}

TEST(BiplotFigure, SaysWhyThereIsNoPlane) {
  TidyInput input{};
  input.tables.emplace_back(
      "item,scale,score\na,rough,1\na,hard,2\nb,rough,2\nb,hard,4\nc,rough,3\nc,hard,6\n", "m.csv");
  std::vector<Finding> findings = tidy_family("components").findings(input);
  EXPECT_NE(biplot_figure(FoundNumbers(findings)).instead.english().find("one component only"),
            std::string::npos);
  TidyInput few{};
  few.tables.emplace_back("item,scale,score\na,rough,1\na,hard,2\nb,rough,2\nb,hard,1\n", "m.csv");
  findings = tidy_family("components").findings(few);
  EXPECT_NE(biplot_figure(FoundNumbers(findings)).instead.english().find("at least 3 items"),
            std::string::npos);
  EXPECT_FALSE(biplot_figure(FoundNumbers()).is_drawn());
}

/// The rectangles of all horizontal texts.
std::vector<QRectF> written_in(const DrawnSvg& svg) {
  std::vector<QRectF> places{};
  for (const DrawnText& text : svg.texts) {
    if (text.is_turned) continue;
    QFont font{};
    font.setFamily(QFontInfo(font).family());
    font.setPixelSize(static_cast<int>(text.letters));
    const QFontMetricsF metrics(font);
    places.push_back(metrics.tightBoundingRect(text.words).translated(text.at));
  }
  return places;
}

// Three arrows in nearly the same direction, as scales that measure the same.
TEST(BiplotFigure, KeepsTheLabelsOfSimilarScalesApartAndOnTheSheet) {
  std::vector<Finding> findings = tidy_family("components").findings(four_items());
  for (Finding& finding : findings) {
    if (finding.quantity != "loading") continue;
    if (finding.key.last() == "C1") finding.value = 0.99;
    if (finding.key.last() == "C2") finding.value = finding.key[0] == "hard" ? 0.02 : 0.0;
  }
  for (const double width_mm : {kColumnWidth_mm, kPageWidth_mm}) {
    const DrawnSvg svg = read_svg(QByteArray::fromStdString(
        svg_of(biplot_figure(FoundNumbers(findings)), {.width_mm = width_mm})));
    const std::vector<QRectF> places = written_in(svg);
    for (std::size_t a = 0; a < places.size(); ++a) {
      EXPECT_TRUE(svg.view.contains(places[a]))
          << svg.texts[static_cast<int>(a)].words.toStdString();
      for (std::size_t b = a + 1; b < places.size(); ++b) {
        EXPECT_FALSE(places[a].intersects(places[b])) << a << ' ' << b << ' ' << width_mm;
      }
    }
    for (const char* word : {"a", "d", "rough", "coarse", "hard"}) {
      EXPECT_TRUE(svg.words().contains(word)) << word;
    }
  }
}

TEST(ProfileFigure, WritesTheEndsOfItsRowsOnBothSidesOfTheSheet) {
  const StoredTable scales = two_scales();
  const Figure figure = profile_of(two_profiles(), &scales);
  for (const double width_mm : {kColumnWidth_mm, kPageWidth_mm}) {
    const DrawnSvg svg =
        read_svg(QByteArray::fromStdString(svg_of(figure, {.width_mm = width_mm})));
    const auto at = [&svg](const char* word) {
      for (const DrawnText& text : svg.texts) {
        if (text.words == word) return text.at;
      }
      ADD_FAILURE() << word << " is missing";
      return QPointF();
    };
    EXPECT_LT(at("smooth").x(), svg.circles[0].x());
    EXPECT_GT(at("rough").x(), svg.circles[0].x());
    EXPECT_EQ(at("smooth").y(), at("rough").y());
    EXPECT_LT(at("smooth").y(), at("soft").y());
    EXPECT_TRUE(svg.words().contains("metal")) << "in the legend";
    for (const QRectF& place : written_in(svg)) EXPECT_TRUE(svg.view.contains(place));
  }
}

// A study asks one scale or several; see also the analysis page.
TEST(RatingFigures, AreARowPerItemForASingleScale) {
  AnalysisOutcome outcome{};
  outcome.tables.push_back(result_of(
      ratings_of({{"rough", "metal", -1.0, -1.5, -0.5}, {"rough", "wood", 2.0, 1.0, 3.0}})));
  outcome.questions.push_back({.name = "ratings_rough", .table = "ratings"});
  for (const char* item : {"metal", "wood"}) {
    Finding& mean = outcome.findings.emplace_back();
    mean.analysis = "ratings";
    mean.quantity = "mean.score";
    mean.key = {"rough", item};
    mean.value = 1.0;
    mean.n = 12;
  }
  const std::vector<Figure> figures = rating_figures(outcome.tables.front(), outcome);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "ratings");
  EXPECT_EQ(figures[0].question, "ratings_rough");
  EXPECT_EQ(words_of(figures[0].y.places),
            (std::vector<std::string>{"metal (n = 12)", "wood (n = 12)"}));
}

TEST(RatingFigures, FollowTheLastAnswerOnTheirScales) {
  AnalysisOutcome outcome{};
  outcome.tables.push_back(result_of(two_profiles()));
  outcome.questions.push_back({.name = "ratings_rough", .table = "ratings"});
  outcome.questions.push_back({.name = "ratings_hard", .table = "ratings"});
  const std::vector<Figure> figures = rating_figures(outcome.tables.front(), outcome);
  ASSERT_EQ(figures.size(), 1U);
  EXPECT_EQ(figures[0].name, "profile");
  EXPECT_EQ(figures[0].question, "ratings_hard");
}

TEST(LabelPlaces, CoverALineRatherThanAMarkAndNothingRatherThanALine) {
  LabelPlaces places(QRectF(0, 0, 100, 100));
  const QSizeF label(20, 10);
  const QRectF first(QPointF(50, 45), label);
  const QRectF second(QPointF(10, 45), label);
  const QRectF third(QPointF(30, 80), label);
  const QRectF outside(QPointF(90, 45), label);
  const QPointF named(40, 50);
  EXPECT_EQ(places.take(named, std::array{first, second}), first);
  EXPECT_EQ(places.take(named, std::array{first, second}), second) << "the first one is taken";
  places.keep_free(QLineF(0, 85, 100, 85), 4.0);
  EXPECT_EQ(places.take(named, std::array{outside, first, third}), third);
  EXPECT_EQ(places.take(named, std::array{third, QRectF(QPointF(30, 60), label)}).top(), 60.0);
}

TEST(LabelPlaces, StayOnTheSideOfAnArrowOnWhichTheNamedPointIs) {
  LabelPlaces places(QRectF(0, 0, 100, 100));
  places.keep_free(QLineF(0, 50, 100, 50), 4.0);
  const QSizeF label(20, 10);
  const QRectF above(QPointF(30, 35), label);
  const QRectF below(QPointF(30, 55), label);
  EXPECT_EQ(places.take(QPointF(40, 70), std::array{above, below}), below);
}

// The third point is near the second one, but not near the first one of their group.
TEST(NearPoints, AreThoseNearTheFirstOfTheirGroup) {
  const std::array points{QPointF(0, 0), QPointF(6, 0), QPointF(12, 0), QPointF(0, 9)};
  const std::vector<std::vector<std::size_t>> groups{{0, 1, 3}, {2}};
  EXPECT_EQ(near_points(points, 10.0), groups);
  EXPECT_EQ(near_points(points, 1.0).size(), 4U);
}

TEST(JoinedNames, AreBrokenIntoTwoLinesAndThenCounted) {
  const QFontMetricsF metrics{QFont()};
  const QStringList names{"cork", "felt", "wool", "slate", "brick", "oak"};
  const auto joined = [&](const QStringList& of, const QString& widest) {
    return joined_names(of, metrics, metrics.horizontalAdvance(widest)).join('/');
  };
  EXPECT_EQ(joined({"cork"}, "c"), "cork");
  EXPECT_EQ(joined(names, "cork, felt, wool, slate, brick, oak"),
            "cork, felt, wool, slate, brick, oak");
  EXPECT_EQ(joined(names, "slate, brick, oak"), "cork, felt, wool,/slate, brick, oak");
  EXPECT_EQ(joined(names, "cork, felt,"), "cork, felt,/wool, +3");
}

}  // namespace
}  // namespace asperity
