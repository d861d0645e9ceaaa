// Figures show the numbers of findings and tables, each at its place.

#include "app/findings/outcome/figures_of.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "app/findings/methods/magnitude/roughness_figure.h"
#include "app/findings/methods/magnitude/stimulus_estimates_figure.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/group_figures.h"
#include "app/findings/outcome/single_participants.h"
#include "app/findings/shared/anchor_figures.h"
#include "app/findings/shared/anchors.h"
#include "app/findings/shared/choice_tables.h"
#include "app/findings/shared/figures/forest_figures.h"
#include "app/findings/shared/figures/replay_figure.h"
#include "app/findings/shared/figures/response_time_figures.h"
#include "app/findings/shared/figures/similarity_figures.h"
#include "app/findings/study/family_figures.h"
#include "app/findings/tidy/tidy_families.h"
#include "app/sweep/sweep_figure.h"
#include "renderers/built_in_models.h"
#include "tests/app/stored_tables.h"
#include "tests/gui/data/drawn_case.h"

namespace asperity {
namespace {

struct Analysed {
  ReferenceCase read;
  std::vector<Finding> findings{};
  std::vector<Figure> figures{};

  double number(const std::string& quantity, const std::string& key) const {
    for (const Finding& finding : findings) {
      if (finding.quantity == quantity && finding.key == key) return finding.value.value();
    }
    ADD_FAILURE() << quantity << ' ' << key << " is missing";
    return 0.0;
  }
  const Figure& figure(const std::string& name) const {
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [&name](const Figure& one) { return one.name == name; });
    if (found == figures.end()) throw std::runtime_error("no figure " + name);
    return *found;
  }
};

Analysed analysed(const std::string& name) {
  Analysed all{test::case_to_draw(std::filesystem::path(ASPERITY_SOURCE_DIR) /
                                  "tests/analysis/reference" / name)};
  all.findings = tidy_family(all.read.family).findings(all.read.input);
  all.figures = figures_of(all.read.family, all.read.input, all.findings, "mm");
  return all;
}

std::vector<std::string> drawn_places(const FigureAxis& axis) {
  std::vector<std::string> names{};
  for (const Phrase& place : axis.places) names.push_back(place.english());
  return names;
}

TEST(FiguresOf, ShowTheMeansOfAnchorsAndALineForEachRun) {
  AnalysisOutcome outcome{};
  StoredTable anchors{.name = kAnchors,
                      .table = {{"participant", "session", "block_ordinal", "block", "place",
                                 "question", "response"},
                                {}}};
  const auto add = [&anchors](const std::string& participant, const std::string& place,
                              double response) {
    anchors.table.rows.push_back({participant, std::int64_t{1}, std::int64_t{2},
                                  std::string("main"), place, std::string("rough"), response});
  };
  for (const auto& [participant, first] : {std::pair{"a", 4.0}, std::pair{"b", 6.0}}) {
    add(participant, "start", first);
    add(participant, "middle", first - 0.5);
    add(participant, "end", 3.0);
  }
  outcome.tables.push_back(result_of(anchors));
  const ResultTable trend = result_of(
      {.name = kAnchorTrend,
       .table = {{"block", "question", "measure", "persons", "start", "middle", "end", "change"},
                 {{std::string("main"), std::string("rough"), std::string(kAnchorRating),
                   std::int64_t{2}, 5.0, 4.5, 3.0, -2.0}}}});
  const std::vector<Figure> figures = anchor_figures(trend, outcome);
  ASSERT_EQ(figures.size(), 1U);
  const Figure& figure = figures.front();
  EXPECT_EQ(figure.name, "anchors_main_rough");
  EXPECT_EQ(drawn_places(figure.x), (std::vector<std::string>{"start", "middle", "end"}));
  ASSERT_EQ(figure.series.size(), 2U);
  std::vector<double> means{};
  for (const FigurePoint& point : figure.series[0].points) means.push_back(point.y);
  EXPECT_EQ(means, (std::vector<double>{5.0, 4.5, 3.0}));
  EXPECT_TRUE(figure.series[1].single);
  ASSERT_EQ(figure.series[1].lines.size(), 2U);
  EXPECT_EQ(figure.series[1].lines[1].front().y, 6.0);
  EXPECT_EQ(figure.series[1].lines[1].back().x, 2.0);
  EXPECT_LT(figure.y.low, 3.0);
  EXPECT_GT(figure.y.high, 6.0);
}

TEST(FiguresOf, PutEachShareOfATableWithItsIntervalIntoARow) {
  const Figure figure = share_forest(
      result_of({.name = "shares",
                 .table = {{"column", "item", "chosen", "of", "persons", "share", "wilson_low",
                            "wilson_high", "chance"},
                           {{std::string("1"), std::string("wave"), std::int64_t{3},
                             std::int64_t{10}, std::int64_t{10}, 0.3, 0.11, 0.6, 0.5},
                            {std::string("all"), std::string("wave"), std::int64_t{12},
                             std::int64_t{20}, std::int64_t{10}, 0.6, 0.39, 0.78, 0.5}}}}));
  EXPECT_TRUE(figure.is_drawn());
  EXPECT_EQ(figure.name, "shares_forest");
  EXPECT_EQ(drawn_places(figure.y),
            (std::vector<std::string>{"repetition 1 · wave (3 of 10)", "all · wave (12 of 20)"}));
  ASSERT_EQ(figure.series.size(), 2U);
  EXPECT_FALSE(figure.series[0].hollow);  // all columns
  EXPECT_TRUE(figure.series[1].hollow);   // a part
  const FigurePoint& all = figure.series[0].points.front();
  EXPECT_EQ(all.x, 0.6);
  EXPECT_EQ(all.y, 1.0);
  EXPECT_EQ(all.x_interval->low, 0.39);
  EXPECT_EQ(all.x_interval->high, 0.78);
  ASSERT_EQ(figure.references.size(), 1U);
  EXPECT_EQ(figure.references.front().value, 0.5);
}

// One participant has no interval; a table of one column has no parts.
TEST(FiguresOf, ExplainOnlyTheMarksOfSharesThatAreDrawn) {
  const StoredTable shares{
      .name = "shares",
      .table = {{"column", "item", "chosen", "of", "persons", "share", "wilson_low", "wilson_high"},
                {{std::string("all"), std::string("wave"), std::int64_t{1}, std::int64_t{2},
                  std::int64_t{1}, 0.5, 0.1, 0.9}}}};
  const StoredTable persons{
      .name = "persons",
      .table = {{"item", "persons", "mean", "mean_low", "mean_high"},
                {{std::string("wave"), std::int64_t{1}, 0.5, Cell{}, Cell{}},
                 {std::string("grain"), std::int64_t{1}, 0.5, Cell{}, Cell{}}}}};
  AnalysisOutcome outcome{};
  outcome.tables = results_of({shares, persons});
  EXPECT_EQ(share_forest(outcome.tables[0], outcome, {"persons", "choice"}).note.english(),
            "Points are proportions of all responses of a row; error bars show their Wilson 95 % "
            "CIs. Squares are means of the participants' own proportions: the participant is the "
            "unit of analysis.");
  const Figure means = person_forest(outcome.tables[1], outcome, "choice", "shares");
  EXPECT_EQ(means.note.english(),
            "Squares are means of the participants' own proportions: the participant is the unit "
            "of analysis.");
  EXPECT_EQ(means.x.name.english(), "mean proportion");
}

TEST(FiguresOf, ExplainOnlyTheMarksOfRoughnessThatAreDrawn) {
  std::vector<Finding> findings{};
  for (const char* const spacing : {"0.001", "0.002"}) {
    Finding& mean = findings.emplace_back();
    mean.quantity = "geomean";
    mean.key = {"small", spacing};
    mean.value = 1.5;
  }
  EXPECT_EQ(roughness_figure(FoundNumbers(findings), "m", CurveNames::of_probes).note.english(),
            "Filled symbols: geometric means of normalised estimates.");
  for (Finding& mean : findings) {
    mean.low = 1.0;
    mean.high = 2.0;
    mean.confidence = 0.95;
  }
  EXPECT_EQ(roughness_figure(FoundNumbers(findings), "m", CurveNames::of_probes).note.english(),
            "Filled symbols: geometric means of the estimates with t-based 95 % CIs over the "
            "participants.");
  Finding& within = findings.emplace_back();
  within.quantity = "geomean.ci.lower.morey";
  within.key = {"small", "0.001"};
  within.value = 1.0;
  EXPECT_EQ(roughness_figure(FoundNumbers(findings), "m", CurveNames::of_probes).note.english(),
            "Filled symbols: geometric means of normalised estimates with within-participant 95 % "
            "CIs (Cousineau and Morey), which serve to compare cells and do not include the "
            "differences between participants.");
}

// 1, 1, 1 and 0.5: Student's interval of the mean, 0.875, goes to 1.27; that on the logit scale is drawn.
TEST(FiguresOf, EndTheIntervalOfAMeanShareWhereSharesEnd) {
  TidyInput input{.options = FamilyOptions::of_json(R"({"labels": ["x", "y"]})", "options")};
  input.tables.emplace_back(
      "subject,stimulus,response\nA,x,x\nA,y,y\nB,x,x\nB,y,y\nC,x,x\nC,y,y\nD,x,x\nD,y,x\n",
      "t.csv");
  const std::vector<Finding> findings = recognition_findings(input);
  EXPECT_GT(FoundNumbers(findings).value("subj.ci.upper").value(), 1.2);
  const Figure figure = figures_of("recognition", input, findings).front();
  EXPECT_EQ(figure.x.low, 0.0);
  EXPECT_EQ(figure.x.high, 1.0);
  const FigurePoint& mean = figure.series[1].points.back();
  EXPECT_EQ(mean.x, 0.875);
  EXPECT_EQ(mean.x_interval->high, FoundNumbers(findings).find("subj.mean")->high.value());
  EXPECT_LT(mean.x_interval->high, 1.0);
  EXPECT_GT(mean.x_interval->high, 0.95);
}

TEST(FiguresOf, MarkChanceInEachRowWhereItDiffers) {
  const Analysed all = analysed("proportion_01");
  const Figure& figure = all.figure("proportions");
  EXPECT_TRUE(figure.references.empty());
  const FigureSeries& chances = figure.series.back();
  EXPECT_EQ(chances.name.english(), "chance level");
  EXPECT_GT(chances.points.size(), 2U);
}

TEST(FiguresOf, CountTheAnswersOfARowAndNotItsParticipants) {
  const Analysed all = analysed("recognition_01");
  const Figure& figure = all.figure("recognised");
  const std::string first = figure.y.places.front().english();
  const Figure& confusions = all.figure("confusions");
  double trials = 0.0;
  for (const FigureCell& cell : confusions.cells) {
    if (cell.row == 0) trials += std::stod(cell.text);
  }
  EXPECT_NE(first.find("of " + std::to_string(static_cast<int>(trials)) + ")"), std::string::npos)
      << first;
}

TEST(FiguresOf, ShadeConfusionsByTheirShareOfARow) {
  const Analysed all = analysed("recognition_01");
  const Figure& figure = all.figure("confusions");
  const auto labels = all.read.input.options.texts("labels");
  EXPECT_EQ(drawn_places(figure.x), labels);
  EXPECT_EQ(drawn_places(figure.y), labels);
  ASSERT_EQ(figure.cells.size(), labels.size() * labels.size());
  std::map<std::size_t, double> sums{};
  for (const FigureCell& cell : figure.cells) {
    const std::string key = labels[cell.row] + '|' + labels[cell.column];
    EXPECT_EQ(std::stod(cell.text), all.number("confusion", key)) << key;
    EXPECT_EQ(cell.framed, cell.row == cell.column) << key;
    sums[cell.row] += cell.shade.value();
  }
  for (const auto& [row, sum] : sums) EXPECT_NEAR(sum, 1.0, 1e-12) << labels[row];
}

TEST(FiguresOf, JoinBranchesAtTheHeightsOfTheirClusters) {
  const Analysed all = analysed("recognition_01");
  const Figure& figure = all.figure("similarity_tree");
  ASSERT_TRUE(figure.is_drawn());
  const auto& joins = figure.series.front().lines;
  ASSERT_EQ(joins.size(), figure.y.places.size() - 1);
  std::multiset<double> heights{};
  for (const auto& join : joins) {
    ASSERT_EQ(join.size(), 4U);
    EXPECT_EQ(join[1].x, join[2].x);
    heights.insert(join[1].x);
  }
  std::multiset<double> expected{};
  for (std::size_t i = 1; i <= joins.size(); ++i) {
    expected.insert(all.number("hclust.shepard.average.height", std::to_string(i)));
  }
  ASSERT_EQ(heights.size(), expected.size());
  for (auto a = heights.begin(), b = expected.begin(); a != heights.end(); ++a, ++b) {
    EXPECT_NEAR(*a, *b, 1e-9);
  }
  EXPECT_GT(figure.x.high, *heights.rbegin());
}

TEST(FiguresOf, KeepTheDistancesOfAMap) {
  const Analysed all = analysed("recognition_01");
  const Figure& figure = all.figure("similarity_map");
  ASSERT_TRUE(figure.is_drawn());
  const std::vector<FigurePoint>& points = figure.series.front().points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const std::string key = points[i].label.english() + '|' + points[j].label.english();
      EXPECT_NEAR(std::hypot(points[i].x - points[j].x, points[i].y - points[j].y),
                  all.number("mds.shepard.dist2d", key), 1e-9)
          << key;
    }
  }
  EXPECT_NEAR(figure.x.high - figure.x.low, figure.y.high - figure.y.low, 1e-12);
  EXPECT_NE(figure.note.english().find("% of the sum of the absolute eigenvalues"),
            std::string::npos);
}

TEST(FiguresOf, OrderAScaleFromTheTopDown) {
  const Analysed all = analysed("paired_01");
  const Figure& figure = all.figure("preference");
  const std::vector<FigurePoint>& points = figure.series.front().points;
  const std::vector<std::string> items = drawn_places(figure.y);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].y, static_cast<double>(i));
    EXPECT_EQ(points[i].x, all.number("bt.ability.sumzero", items[i]));
    if (i > 0) {
      EXPECT_LE(points[i].x, points[i - 1].x);
    }
    ASSERT_TRUE(points[i].x_interval);
    EXPECT_LT(figure.x.low, points[i].x_interval->low);
    EXPECT_GT(figure.x.high, points[i].x_interval->high);
  }
}

// An item that was never chosen has no place in the table of the scale, which is then missing.
TEST(FiguresOf, DrawAScaleWithItsTableOrElseWithThatOfThePairs) {
  AnalysisOutcome outcome{};
  for (const auto& [item, worth] : {std::pair{"wave", 0.0}, std::pair{"grain", 1.5}}) {
    outcome.findings.push_back({.quantity = "bt.firth.ability", .key = item, .value = worth});
    outcome.findings.back().analysis = kWorthScale;
  }
  outcome.findings.push_back({.quantity = "bt.status"});
  outcome.findings.back().analysis = kWorthScale;
  const ResultTable pairs = result_of(
      {.name = "pairs",
       .table = {{"item", "against", "chosen", "of", "share", "wilson_low", "wilson_high"},
                 {{std::string("grain"), std::string("wave"), std::int64_t{4}, std::int64_t{4}, 1.0,
                   0.5, 1.0}}}});
  const std::vector<Figure> both = figures_of_pairs(pairs, outcome);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].name, "scale");
  EXPECT_EQ(both[1].question, "pairs");
  EXPECT_EQ(drawn_places(both[1].y), (std::vector<std::string>{"grain", "wave"}));
  outcome.tables.push_back({.name = kWorthScale});
  EXPECT_EQ(figures_of_pairs(pairs, outcome).size(), 1U);
}

/// Two tips over four spacings, the second half as rough.
Sweep two_tips() {
  static const ModelRegistry kModels = built_in_models();
  Sweep sweep{};
  sweep.order.stroke.model = kModels.find("pd_gradient");
  sweep.order.values = {0.001, 0.002};
  sweep.order.spacings_m = {0.0005, 0.001, 0.002, 0.004};
  for (const double tip_m : sweep.order.values) {
    for (const double spacing_m : sweep.order.spacings_m) {
      HeldToolRoughness roughness{};
      roughness.max_accel_m_per_s2 = 1e-6 / (tip_m * spacing_m);
      sweep.rows.push_back(
          {.value = tip_m, .spacing_m = spacing_m, .roughness = roughness, .status = "ok"});
    }
  }
  return sweep;
}

TEST(BesidePrediction, HasTheGeometricMeanOfTheEstimatesAndNothingBeyondTheirSpacings) {
  Figure estimates{};
  for (int style = 0; style < 2; ++style) {
    FigureSeries& tip = estimates.series.emplace_back();
    tip.name = Phrase(style == 0 ? "small" : "large");
    tip.style = style;
    for (const double spacing_mm : {1.0, 2.0, 4.0}) {
      tip.points.push_back({.x = spacing_mm, .y = 8.0});
    }
  }
  estimates.series.push_back({.style = 0, .hollow = true, .points = {{.x = 1.5, .y = 9.0}}});
  estimates.y = {.scale = AxisScale::log10, .low = 7.0, .high = 9.0};

  const Figure both = beside_prediction(estimates, two_tips(), {"small", "large"});
  ASSERT_EQ(both.series.size(), 5U);
  EXPECT_EQ(both.series[0].name.english(), "small");
  EXPECT_EQ(both.series[3].name.english(), "predicted by pd_gradient: probe 1 mm");
  EXPECT_NE(both.note.english().find("predicted by a sweep of pd_gradient"), std::string::npos);
  double product = 1.0;
  for (std::size_t tip = 0; tip < 2; ++tip) {
    const FigureSeries& marks = both.series[3 + tip];
    EXPECT_EQ(marks.style, static_cast<int>(tip));
    EXPECT_TRUE(marks.hollow);
    ASSERT_EQ(marks.points.size(), 3U);
    EXPECT_EQ(marks.points.front().x, 1.0);
    for (const FigurePoint& mark : marks.points) product *= mark.y / 8.0;
  }
  EXPECT_NEAR(product, 1.0, 1e-9);
  EXPECT_NEAR(both.series[3].points[0].y / both.series[4].points[0].y, 2.0, 1e-9);
  EXPECT_LT(both.y.low, both.series[4].points[2].y);
  EXPECT_GT(both.y.high, both.series[3].points[0].y);

  // A level goes where its condition is, in whatever order the study has them.
  const Figure turned = beside_prediction(estimates, two_tips(), {"large", "small"});
  EXPECT_EQ(turned.series[3].name.english(), "predicted by pd_gradient: probe 1 mm");
  EXPECT_EQ(turned.series[3].style, 1);

  EXPECT_THROW(beside_prediction(estimates, two_tips(), {"small"}), std::runtime_error);
  estimates.series.erase(estimates.series.begin());
  EXPECT_THROW(require_estimates(estimates, {"small", "large"}), std::runtime_error);
  EXPECT_NO_THROW(require_estimates(estimates, {"large"}));
  EXPECT_THROW(beside_prediction(estimates, two_tips(), {"small", "large"}), std::runtime_error);
}

TEST(BesidePrediction, SaysInTheDrawingWhoseEstimatesTheyAreAndWhatHasNoEffect) {
  Figure estimates{};
  estimates.y = {.name = Phrase("roughness"), .scale = AxisScale::log10, .low = 7.0, .high = 9.0};
  FigureSeries& all = estimates.series.emplace_back();
  all.points = {{.x = 1.0, .y = 8.0}, {.x = 4.0, .y = 8.0}};
  EXPECT_EQ(of_group(estimates, AnswerGroup::people).y.name.english(), "roughness");
  EXPECT_EQ(of_group(estimates, AnswerGroup::pilot).y.name.english(),
            "roughness in pilot sessions");
  estimates = of_group(estimates, AnswerGroup::virtual_participants);
  EXPECT_EQ(estimates.y.name.english(), "roughness of virtual participants");
  Sweep sweep = two_tips();
  sweep.order.values = {0.001};
  std::erase_if(sweep.rows, [](const SweepRow& row) { return row.value != 0.001; });
  for (SweepRow& row : sweep.rows) row.status = kNoEffectByConstruction;
  const Figure beside = beside_prediction(estimates, sweep, {""});
  EXPECT_EQ(beside.y.name.english(), "roughness of virtual participants");
  // A key has two names at least: the marks are told from the estimates.
  EXPECT_EQ(beside.series[0].name.english(), "estimates");
  EXPECT_EQ(beside.series[1].name.english(),
            "predicted by pd_gradient: probe 1 mm (no effect by construction)");
  EXPECT_EQ(sweep_figure(sweep).series[0].name.english(), "probe 1 mm (no effect by construction)");
}

// E = RMS²·T: energies of 0.02 and 0.08 N² s in 2 s are an RMS of 0.1 and 0.2 N.
TEST(ReplayFigure, DrawsTheForcesInTheirBands) {
  ForceDifference pooled{.samples = 2000, .duration_s = 2.0};
  pooled.recorded.bands_N2_s[4] = 0.02;
  pooled.recorded.bands_N2_s[5] = 0.02;
  pooled.compared.bands_N2_s[4] = 0.08;
  const Figure figure = replay_figure(pooled, "sinusoid");
  ASSERT_TRUE(figure.is_drawn());
  ASSERT_EQ(figure.series.size(), 2U) << "the difference has no energy";
  EXPECT_EQ(figure.series[0].name.english(), "recorded force");
  EXPECT_EQ(figure.series[1].name.english(), "force of sinusoid");
  ASSERT_EQ(figure.series[0].points.size(), 2U);
  EXPECT_NEAR(figure.series[0].points[0].x, std::sqrt(50.0 * 80.0), 1e-9);
  EXPECT_NEAR(figure.series[0].points[0].y, 0.1, 1e-12);
  EXPECT_NEAR(figure.series[1].points[0].y, 0.2, 1e-12);
  EXPECT_LT(figure.y.low, 0.1);
  EXPECT_GT(figure.y.high, 0.2);
  EXPECT_FALSE(replay_figure({}, "").is_drawn());
}

TEST(FiguresOf, DrawSmallPredictorsInMicrometres) {
  std::vector<Finding> findings{};
  for (const auto& [stimulus, amplitude_m] : {std::pair{"fine", 2e-5}, std::pair{"coarse", 8e-5}}) {
    findings.push_back({.quantity = "predictor", .key = stimulus, .value = amplitude_m});
    findings.push_back(
        {.quantity = "geomean", .key = {"all", stimulus}, .value = 1e5 * amplitude_m});
  }
  const Figure figure = stimulus_estimates_figure(FoundNumbers(findings), "amplitude", "m");
  EXPECT_EQ(figure.x.unit, "µm");
  EXPECT_NEAR(figure.series.front().points.front().x, 20.0, 1e-9);
  EXPECT_NEAR(figure.series.front().points.back().x, 80.0, 1e-9);
  EXPECT_EQ(figure.series.front().points.back().label, "coarse");
}

TEST(FiguresOf, DrawRoughnessByProbeWithItsCurveAndPeak) {
  const Analysed all = analysed("magnitude_01");
  const Figure& figure = all.figure("roughness");
  EXPECT_EQ(figure.x.scale, AxisScale::log10);
  EXPECT_EQ(figure.y.scale, AxisScale::log10);
  EXPECT_EQ(figure.x.unit, "mm");
  const FigureSeries& first = figure.series.front();
  EXPECT_EQ(first.name.english(), "probe 1.5");
  const FigurePoint& point = first.points.front();
  EXPECT_EQ(point.x, 0.4);
  EXPECT_EQ(point.y, all.number("geomean", "1.5|0.4"));
  EXPECT_EQ(point.y_interval->low, all.number("geomean.ci.lower.morey", "1.5|0.4"));
  EXPECT_EQ(point.y_interval->high, all.number("geomean.ci.upper.morey", "1.5|0.4"));
  const auto peak = std::find_if(figure.series.begin(), figure.series.end(),
                                 [](const FigureSeries& series) { return series.hollow; });
  ASSERT_NE(peak, figure.series.end());
  EXPECT_EQ(peak->points.front().x, all.number("peak", "1.5"));
  EXPECT_EQ(peak->points.front().y, all.number("peak.height", "1.5"));
  for (const FigurePlace& place : first.lines.front()) {
    const double x = std::log10(place.x);
    const double log10_roughness = all.number("quad.coef", "1.5|a") +
                                   all.number("quad.coef", "1.5|b") * x +
                                   all.number("quad.coef", "1.5|c") * x * x;
    EXPECT_NEAR(std::log10(place.y), log10_roughness, 1e-9);
  }
  EXPECT_NEAR(first.lines.front().front().x, 0.4, 1e-9);
  // Nothing of the curve is higher than its peak, and it comes within a step of it.
  double highest = 0.0;
  for (const FigurePlace& place : first.lines.front()) highest = std::max(highest, place.y);
  EXPECT_LE(highest, peak->points.front().y * (1.0 + 1e-9));
  EXPECT_GT(highest, peak->points.front().y * 0.995);
}

TEST(FiguresOf, DrawSharesByLevelWithTheFunctionThroughItsThreshold) {
  const Analysed all = analysed("psyfit_01");
  const Figure& figure = all.figure("psychometric");
  const TidyTable& table = all.read.input.table();
  const auto hits = table.counts("k");
  const auto trials = table.counts("n");
  const FigureSeries& data = figure.series.front();
  ASSERT_EQ(data.points.size(), trials.size());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    EXPECT_EQ(data.points[i].x, table.all_numbers("x")[i]);
    EXPECT_EQ(data.points[i].y, static_cast<double>(hits[i]) / static_cast<double>(trials[i]));
  }
  const FigureSeries& threshold = figure.series.back();
  ASSERT_TRUE(threshold.hollow);
  const FigurePoint& mark = threshold.points.front();
  const std::string condition{table.texts("condition").front()};
  EXPECT_EQ(mark.x, all.number("threshold", condition));
  EXPECT_EQ(mark.y, all.read.input.options.number("pt"));
  EXPECT_EQ(mark.x_interval->low, all.number("threshold.delta.lower", condition));
  const std::vector<FigurePlace>& curve = data.lines.front();
  for (std::size_t i = 1; i < curve.size(); ++i) {
    if (curve[i - 1].x > mark.x || curve[i].x < mark.x) continue;
    EXPECT_LE(curve[i - 1].y, mark.y);
    EXPECT_GE(curve[i].y, mark.y);
  }
  ASSERT_EQ(figure.references.size(), 1U);
  EXPECT_EQ(figure.references.front().value, all.read.input.options.number("gamma"));
}

TEST(FiguresOf, SetTheMeanOfPersonsBesideTheSharesOfTheirAnswers) {
  AnalysisOutcome outcome{};
  outcome.tables =
      results_of({{.name = "shares_by_texture",
                   .table = {{"felt", "correct", "of", "persons", "share", "wilson_low",
                              "wilson_high", "chance"},
                             {{std::string("wood"), std::int64_t{12}, std::int64_t{20},
                               std::int64_t{5}, 0.6, 0.39, 0.78, 0.25}}}},
                  {.name = "persons",
                   .table = {{"answers", "persons", "mean", "mean_low", "mean_high"},
                             {{std::string("all"), std::int64_t{5}, 0.55, 0.3, 0.8}}}}});
  const Figure figure = share_forest(outcome.tables.front(), outcome, {"persons", "matching"});
  EXPECT_EQ(drawn_places(figure.y),
            (std::vector<std::string>{"wood (12 of 20)", "mean of 5 participants"}));
  ASSERT_EQ(figure.series.size(), 2U);
  EXPECT_NE(figure.series[0].style, figure.series[1].style);
  EXPECT_EQ(figure.series[1].points.front().x, 0.55);
  EXPECT_EQ(figure.series[1].points.front().x_interval->low, 0.3);
  ASSERT_EQ(figure.references.size(), 1U);
}

// What the sentence beside the figure says: an interval of the pooled choices alone excludes chance
// where that of the participants does not.
TEST(FiguresOf, SetTheMeansOfPersonsBesideTheSharesOfPositions) {
  AnalysisOutcome outcome{};
  outcome.tables =
      results_of({{.name = "positions",
                   .table = {{"position", "chosen", "of", "persons", "share", "wilson_low",
                              "wilson_high", "chance"},
                             {{std::string("1"), std::int64_t{27}, std::int64_t{40},
                               std::int64_t{4}, 0.675, 0.52, 0.8, 0.5},
                              {std::string("2"), std::int64_t{13}, std::int64_t{40},
                               std::int64_t{4}, 0.325, 0.2, 0.48, 0.5}}}},
                  {.name = "persons_by_position",
                   .table = {{"position", "persons", "mean", "mean_low", "mean_high"},
                             {{std::string("1"), std::int64_t{4}, 0.68, 0.34, 1.0},
                              {std::string("2"), std::int64_t{4}, 0.32, 0.0, 0.66}}}}});
  const Figure figure =
      share_forest(outcome.tables.front(), outcome, {"persons_by_position", "position"});
  EXPECT_EQ(drawn_places(figure.y),
            (std::vector<std::string>{"position 1 (27 of 40)", "position 2 (13 of 40)",
                                      "position 1 · mean of 4 participants",
                                      "position 2 · mean of 4 participants"}));
  ASSERT_EQ(figure.series.size(), 2U);
  EXPECT_EQ(figure.series[1].points.front().x_interval->low, 0.34);
}

TEST(FiguresOf, ShowBothGroupsAndTheirDifference) {
  const Analysed all = analysed("group_01");
  const std::vector<std::string> groups = all.read.input.options.texts("groups");
  const Figure& means = all.figure("group_means");
  for (std::size_t i = 0; i < 2; ++i) {
    const FigurePoint& point = means.series.front().points.at(i);
    EXPECT_EQ(point.x, all.number("subj.mean", groups[i]));
    ASSERT_TRUE(point.x_interval);
    EXPECT_LT(point.x_interval->low, point.x);
  }
  const Figure& difference = all.figure("group_difference");
  const auto& points = difference.series.front().points;
  ASSERT_EQ(points.size(), 2U);
  EXPECT_NEAR(points[0].x, all.number("subj.mean", groups[0]) - all.number("subj.mean", groups[1]),
              1e-12);
  EXPECT_EQ(points[1].x, all.number("diff", ""));
  EXPECT_EQ(points[1].x_interval->low, all.number("diff.newcombe.lower", ""));
  EXPECT_EQ(difference.references.front().value, 0.0);
  EXPECT_NE(difference.note.english().find("Newcombe's for all responses pooled"),
            std::string::npos);
}

TEST(FiguresOf, ShowEveryPairOfGroupsUnderItsName) {
  const Analysed all = analysed("group_01");
  AnalysisOutcome outcome{.kind = "recognition"};
  for (const char* pair : {"groups:haptic|visual", "groups:haptic|not trained"}) {
    outcome.questions.push_back({.name = pair});
    for (Finding finding : all.findings) {
      finding.analysis = pair;
      outcome.findings.push_back(std::move(finding));
    }
  }
  std::vector<std::string> names{};
  const std::vector<Figure> figures = figures_of_comparisons({}, outcome);
  for (const Figure& figure : figures) {
    names.push_back(figure.name);
    EXPECT_TRUE(figure.is_drawn());
  }
  EXPECT_EQ(names, (std::vector<std::string>{
                       "groups_haptic_visual_means", "groups_haptic_visual_difference",
                       "groups_haptic_not_trained_means", "groups_haptic_not_trained_difference"}));
  EXPECT_EQ(figures.front().question, "groups:haptic|visual");
}

// Items of one go depend on each other, so that they are not pooled, and nothing says that they are.
TEST(FiguresOf, SayNothingOfAPooledDifferenceWhereThereIsNone) {
  AnalysisOutcome outcome{};
  for (const auto& [quantity, key, value] :
       {std::tuple("subj.mean", "F", 0.75), std::tuple("subj.mean", "M", 0.5),
        std::tuple("subj.diff", "", 0.25)}) {
    outcome.findings.push_back({.quantity = quantity, .key = key, .value = value, .n = 8});
    outcome.findings.back().analysis = "sexes";
  }
  outcome.findings.back().low = -0.125;
  outcome.findings.back().high = 0.625;
  const std::vector<Figure> figures = figures_of_comparisons({}, outcome);
  ASSERT_EQ(figures.size(), 2U);
  const Figure& difference = figures.back();
  EXPECT_EQ(difference.name, "group_difference");
  EXPECT_EQ(difference.question, "sexes");
  EXPECT_EQ(difference.series.front().points.size(), 1U);
  EXPECT_NE(difference.note.english().find("Welch's"), std::string::npos);
  EXPECT_EQ(difference.note.english().find("Newcombe"), std::string::npos);
}

TEST(FiguresOf, DrawScoresByItemWithTheirIntervals) {
  const Analysed all = analysed("rating_01");
  const Figure& figure = all.figure("ratings");
  const auto items = all.read.input.options.texts("items");
  ASSERT_EQ(figure.series.front().points.size(), items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(figure.series.front().points[i].x, all.number("mean.score", items[i]));
    EXPECT_EQ(figure.y.places[i].english().find(items[i]), 0U);
  }
}

TEST(FiguresOf, DrawALineThroughTheCellsOfEachSetting) {
  const Analysed all = analysed("rmanova_02");
  const Figure& figure = all.figure("means");
  std::size_t points = 0;
  std::size_t intervals = 0;
  for (const FigureSeries& series : figure.series) {
    points += series.points.size();
    EXPECT_EQ(series.points.size(), figure.x.places.size());
    ASSERT_EQ(series.lines.size(), 1U);
    EXPECT_EQ(series.lines.front().size(), series.points.size());
    for (std::size_t level = 0; level < series.points.size(); ++level) {
      EXPECT_NEAR(series.points[level].x, static_cast<double>(level), 0.31);
      intervals += series.points[level].y_interval ? 1 : 0;
    }
  }
  std::size_t cells = 0;
  std::size_t halves = 0;
  for (const Finding& finding : all.findings) {
    cells += finding.quantity == "cell.mean" ? 1 : 0;
    halves += finding.quantity == "cell.ci.half.morey" && finding.value ? 1 : 0;
  }
  EXPECT_EQ(points, cells);
  EXPECT_EQ(intervals, halves);
  EXPECT_GT(intervals, 0U);
}

TEST(FiguresOf, DrawPowerBySizeWhereAPlanHasSeveral) {
  TidyInput input{};
  input.tables.emplace_back(
      "id,kind,n,alpha,p0,p1\n"
      "a,binom_greater,40,0.05,0.25,0.5\nb,binom_greater,20,0.05,0.25,0.5\n"
      "c,binom_greater,20,0.05,0.25,0.6\n",
      "plans.csv");
  const std::vector<Finding> findings = power_findings(input);
  const Figure figure = figures_of("power", input, findings).front();
  ASSERT_EQ(figure.series.size(), 2U);
  EXPECT_EQ(figure.series[0].name.english(), "p₁ = 0.5");
  ASSERT_EQ(figure.series[0].points.size(), 2U);
  EXPECT_EQ(figure.series[0].points[0].x, 20.0) << "from small to large";
  EXPECT_LT(figure.series[0].points[0].y, figure.series[0].points[1].y);
  EXPECT_EQ(figure.references.front().value, 0.8);
  // Single plans are rows.
  EXPECT_EQ(analysed("power_01").figure("power").shape, FigureShape::rows);
}

TEST(FiguresOf, HoldEveryMarkWithinTheAxesForEveryCase) {
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(ASPERITY_SOURCE_DIR) / "tests/analysis/reference")) {
    if (!std::filesystem::exists(entry.path() / "case.json")) continue;
    for (const Figure& figure : analysed(entry.path().filename()).figures) {
      const std::string name = entry.path().filename().string() + ' ' + figure.name;
      if (!figure.is_drawn()) continue;
      EXPECT_FALSE(figure.series.empty() && figure.cells.empty()) << name;
      const auto holds = [](const FigureAxis& axis, double value) {
        if (!axis.places.empty()) {
          // Several marks at one place stand beside each other.
          constexpr double kHalf = 0.5;
          return value >= -kHalf && value <= static_cast<double>(axis.places.size()) - kHalf;
        }
        return value >= axis.low && value <= axis.high;
      };
      for (const FigureSeries& series : figure.series) {
        for (const FigurePoint& point : series.points) {
          EXPECT_TRUE(holds(figure.x, point.x) && holds(figure.y, point.y)) << name;
          // Those of fitted marks may go on; those of data do not.
          if (series.hollow) continue;
          for (const auto& [span, axis] :
               {std::pair{point.x_interval, &figure.x}, std::pair{point.y_interval, &figure.y}}) {
            if (!span) continue;
            EXPECT_TRUE(holds(*axis, span->low) && holds(*axis, span->high)) << name;
          }
        }
        for (const auto& line : series.lines) {
          for (const FigurePlace& place : line) {
            EXPECT_TRUE(holds(figure.x, place.x) && holds(figure.y, place.y)) << name;
          }
        }
      }
    }
  }
}

TEST(FiguresOf, SayASentenceWhereThereIsNothingToDraw) {
  // Never compared in both directions: the scale has no finite places.
  EXPECT_NE(analysed("paired_05").figure("preference").instead.english().find("There is no scale"),
            std::string::npos);
  TidyInput input{};
  input.tables.emplace_back("condition,x,n,k\na,1,0,0\n", "blocks.csv");
  for (const char* option : {"shape=logistic", "gamma=0.5", "lambda=0", "pt=0.75"}) {
    const std::string text(option);
    input.options.add(text.substr(0, text.find('=')), text.substr(text.find('=') + 1));
  }
  input.tables.emplace_back("id,k,n,p0\nnobody,0,0,0.5\n", "counts.csv");
  for (const char* family :
       {"selection", "matching", "recognition", "paired", "ranking", "magnitude", "psyfit",
        "seedpaper", "group", "rating", "rmanova", "power"}) {
    for (const Figure& figure : figures_of(family, input, {})) {
      EXPECT_FALSE(figure.is_drawn()) << family << ' ' << figure.name;
    }
  }
  TidyInput counts{};
  counts.tables.emplace_back("id,k,n,p0\nnobody,0,0,0.5\n", "counts.csv");
  for (const Figure& figure : figures_of("proportion", counts, {})) {
    EXPECT_FALSE(figure.is_drawn());
  }
}

std::vector<Figure> two_figures_of(const ResultTable& table, const AnalysisOutcome& outcome) {
  return {{.name = table.name + "_one"}, {.name = table.name + outcome.kind}};
}

TEST(FiguresOf, AreThoseThatTheTablesDeclareInTheirOrder) {
  AnalysisOutcome outcome{.kind = "_of_rating"};
  outcome.tables = {{.name = "first", .figures = two_figures_of},
                    {.name = "without"},
                    {.name = "last", .figures = two_figures_of}};
  std::vector<std::pair<std::string, std::string>> made{};
  for (const Figure& figure : figures_of(outcome)) made.emplace_back(figure.name, figure.table);
  EXPECT_EQ(made, (std::vector<std::pair<std::string, std::string>>{{"first_one", "first"},
                                                                    {"first_of_rating", "first"},
                                                                    {"last_one", "last"},
                                                                    {"last_of_rating", "last"}}));
}

TEST(SingleParticipants, StandAsideOfEqualValues) {
  // Three within 0.1 of the least stand about 0 in the order of their size; the fourth is alone.
  EXPECT_EQ(places_aside(std::vector{0.55, 0.5, 0.9, 0.5}, 0.1),
            (std::vector<double>{0.5, -0.5, 0.0, 0.0}));
  // Many share the room.
  const std::vector<double> many = places_aside(std::vector<double>(21, 1.0), 0.1);
  EXPECT_NEAR(many.front(), -1.0, 1e-12);
  EXPECT_NEAR(many.back(), 1.0, 1e-12);
}

/// The marks of single participants; throws where there is no such series, or more than one.
const FigureSeries& singles_in(const Figure& figure) {
  const FigureSeries* found = nullptr;
  for (const FigureSeries& series : figure.series) {
    if (!series.single) continue;
    if (found != nullptr) throw std::runtime_error("two series of single participants");
    found = &series;
  }
  if (found == nullptr) throw std::runtime_error("no single participants");
  return *found;
}

TEST(FiguresOf, PutResponseTimesByConditionOnALogarithmicAxis) {
  const Analysed times = analysed("response_times_01");
  const Figure& figure = times.figure("response_times");
  EXPECT_EQ(figure.x.scale, AxisScale::log10);
  EXPECT_EQ(drawn_places(figure.y),
            (std::vector<std::string>{"all trials (n = 5)", "1 (n = 5)", "2 (n = 5)",
                                      "wood (n = 4)", "metal (n = 5)"}));
  const FigureSeries& means = figure.series.front();
  EXPECT_FALSE(means.single);
  ASSERT_EQ(means.points.size(), 5U);
  EXPECT_EQ(means.points[3].x, times.number("geomean", "texture=wood"));
  EXPECT_EQ(means.points[3].x_interval->low, times.number("geomean.lower", "texture=wood"));
  const FigureSeries& singles = singles_in(figure);
  ASSERT_EQ(singles.points.size(), 24U);  // one has no time with wood
  EXPECT_EQ(singles.points[0].x, times.number("subject.geomean", "P01"));
  EXPECT_EQ(singles.points[15].x, times.number("subject.geomean", "P01|texture=wood"));
  EXPECT_NEAR(singles.points[15].y, 3.0, 0.41);
  EXPECT_EQ(figure.note.english(),
            "Points are geometric means over the participants; error bars show their t-based 90 % "
            "CIs on the logarithmic scale. Response times are measured from the cue to the "
            "response. Small pale marks: individual participants.");
}

// Of three participants in all trials, of two with wood; other quantities stand between the findings.
TEST(FiguresOf, PutContactTimesByConditionWithTheirQuartiles) {
  std::vector<Finding> findings{};
  const auto add = [&findings](const char* quantity, const FindingKey& key, double value,
                               std::size_t n) {
    Finding& finding = findings.emplace_back();
    finding.quantity = quantity;
    finding.key = key;
    finding.value = value;
    finding.n = n;
  };
  add("median", "contact_s", 4.0, 3);
  add("quartile.lower", "contact_s", 3.0, 3);
  add("quartile.upper", "contact_s", 6.0, 3);
  add("subject.value", {"contact_s", "P1"}, 2.0, 1);
  add("subject.value", {"contact_s", "P2"}, 4.0, 1);
  add("subject.value", {"contact_s", "P3"}, 8.0, 1);
  add("median", {"contact_s", "texture=wood"}, 5.0, 2);
  add("quartile.lower", {"contact_s", "texture=wood"}, 4.5, 2);
  add("quartile.upper", {"contact_s", "texture=wood"}, 5.5, 2);
  add("subject.value", {"contact_s", "P1", "texture=wood"}, 4.0, 1);
  add("subject.value", {"contact_s", "P2", "texture=wood"}, 6.0, 1);
  add("median", "response_s", 1.0, 3);
  const Figure figure = contact_times_figure(FoundNumbers(findings));
  EXPECT_EQ(figure.name, "contact_times");
  EXPECT_EQ(drawn_places(figure.y),
            (std::vector<std::string>{"all trials (n = 3)", "wood (n = 2)"}));
  const FigureSeries& medians = figure.series.front();
  ASSERT_EQ(medians.points.size(), 2U);
  EXPECT_EQ(medians.points[0].x, 4.0);
  EXPECT_EQ(medians.points[0].x_interval->low, 3.0);
  EXPECT_EQ(medians.points[1].x_interval->high, 5.5);
  const FigureSeries& singles = singles_in(figure);
  ASSERT_EQ(singles.points.size(), 5U);
  EXPECT_EQ(singles.points[4].x, 6.0);
  EXPECT_EQ(figure.x.low, 0.0);
  EXPECT_GT(figure.x.high, 8.0);
}

TEST(FiguresOf, PutALineOfEachParticipantBehindTheCourseOverTrials) {
  const Analysed times = analysed("learning_01");
  const Figure& figure = times.figure("times_over_trials");
  EXPECT_EQ(drawn_places(figure.x), (std::vector<std::string>{"1–3", "4–6", "7–9", "10–12", "13"}));
  const FigureSeries& singles = singles_in(figure);
  ASSERT_EQ(singles.lines.size(), 4U);
  EXPECT_EQ(singles.lines[3].size(), 3U);  // nine trials
  EXPECT_EQ(singles.lines[0][1].y, times.number("subject.block", "P01|4-6"));
  const FigureSeries& means = figure.series.front();
  EXPECT_EQ(means.points[1].y, times.number("block", "4-6"));
  EXPECT_EQ(means.lines.front().size(), 5U);
  const Analysed correct = analysed("learning_02");
  EXPECT_EQ(correct.figure("correct_over_trials").y.high, 1.0);
  EXPECT_EQ(singles_in(correct.figure("correct_over_trials")).lines.size(), 5U);
}

// Between many participants nothing could be told apart.
TEST(FiguresOf, LeaveOutParticipantsThatAreTooMany) {
  std::vector<Finding> findings(1);
  findings[0].quantity = "geomean";
  findings[0].value = 2.0;
  for (std::size_t i = 0; i <= kMostSingle; ++i) {
    Finding& one = findings.emplace_back();
    one.quantity = "subject.geomean";
    one.key = "P" + std::to_string(i);
    one.value = 2.0;
  }
  const Figure figure = response_times_figure(FoundNumbers(findings));
  EXPECT_FALSE(shows_singles(figure));
  EXPECT_EQ(figure.note.english(),
            "Points are geometric means over the participants. Response times are measured from "
            "the cue to the response.");
}

// The mean of the marks is the point before them.
TEST(FiguresOf, PutParticipantsBehindTheMeansOfTheirProportions) {
  const Analysed choices = analysed("selection_01");
  const FigureSeries& singles = singles_in(choices.figure("choices"));
  ASSERT_EQ(singles.points.size(), 21U);  // seven participants, three alternatives
  double sum = 0.0;
  for (std::size_t i = 0; i < 7; ++i) sum += singles.points[i].x;
  EXPECT_NEAR(sum / 7.0, choices.number("subj.mean", "map"), 1e-12);
  EXPECT_TRUE(choices.figure("choices").note.english().ends_with(
      "Small pale marks: individual participants."));
  const Analysed recognised = analysed("recognition_01");
  const FigureSeries& shares = singles_in(recognised.figure("recognised"));
  double mean = 0.0;
  for (const FigurePoint& one : shares.points) {
    mean += one.x / static_cast<double>(shares.points.size());
  }
  EXPECT_NEAR(mean, recognised.number("subj.mean", ""), 1e-12);
}

TEST(FiguresOf, PutParticipantsBehindTheMeansOfATableOfPersons) {
  AnalysisOutcome outcome{};
  outcome.tables.push_back(
      result_of({.name = "persons",
                 .table = {{"item", "persons", "mean", "mean_low", "mean_high"},
                           {{std::string("wave"), std::int64_t{2}, 0.5, 0.1, 0.9},
                            {std::string("grain"), std::int64_t{2}, 0.5, 0.1, 0.9}}}}));
  for (const auto& [key, share] :
       {std::pair(FindingKey{"A", "wave"}, 0.25), std::pair(FindingKey{"A", "grain"}, 0.75),
        std::pair(FindingKey{"B", "wave"}, 0.75)}) {
    Finding& own = outcome.findings.emplace_back();
    own.analysis = "choice";
    own.quantity = "subject.share";
    own.key = key;
    own.value = share;
  }
  outcome.findings.push_back(outcome.findings.front());
  outcome.findings.back().analysis = "texture";  // not what the table is about
  const Figure figure = person_forest(outcome.tables.front(), outcome, "choice", "shares");
  const FigureSeries& singles = singles_in(figure);
  ASSERT_EQ(singles.points.size(), 3U);
  EXPECT_EQ(singles.points[1].x, 0.75);
  EXPECT_EQ(singles.points[1].y, 0.0);
  EXPECT_EQ(singles.points[2].y, 1.0);
}

TEST(FiguresOf, PutParticipantsBehindTheMeansOfTwoGroups) {
  const Analysed groups = analysed("group_01");
  const Figure& figure = groups.figure("group_means");
  std::array<double, 2> sums{};
  std::array<double, 2> marks{};
  for (const FigurePoint& one : singles_in(figure).points) {
    const std::size_t row = one.y < 0.5 ? 0 : 1;
    sums[row] += one.x;
    ++marks[row];
  }
  const std::vector<FigurePoint>& means = figure.series.front().points;
  EXPECT_NEAR(sums[0] / marks[0], means[0].x, 1e-12);
  EXPECT_NEAR(sums[1] / marks[1], means[1].x, 1e-12);
}

TEST(FiguresOf, PutParticipantsBehindTheMeansOfEstimates) {
  const Analysed roughness = analysed("magnitude_01");
  const Figure& figure = roughness.figure("roughness");
  std::size_t marks = 0;
  for (const FigureSeries& series : figure.series)
    marks += series.single ? series.points.size() : 0;
  const std::size_t estimates = static_cast<std::size_t>(
      std::count_if(roughness.findings.begin(), roughness.findings.end(),
                    [](const Finding& one) { return one.quantity == "norm.estimate"; }));
  EXPECT_EQ(marks, estimates);
  EXPECT_GT(marks, 0U);
  for (const FigureSeries& series : figure.series) {
    for (const FigurePoint& point : series.points) {
      EXPECT_GE(point.y, figure.y.low);
      EXPECT_LE(point.y, figure.y.high);
    }
  }
}

}  // namespace
}  // namespace asperity
