// Figures of thresholds: psychometric functions of participants, means by condition, and tracks.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/methods/discrimination/thresholds/psychometric_figures.h"
#include "app/findings/methods/discrimination/thresholds/study_track_figures.h"
#include "app/findings/methods/discrimination/thresholds/track_figure.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/figures_of.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "app/findings/study/family_figures.h"
#include "app/findings/tidy/reference_case.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/made_up_study.h"
#include "tests/app/stored_tables.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Figure& figure_named(const std::vector<Figure>& figures, const std::string& name) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&name](const Figure& one) { return one.name == name; });
  if (found == figures.end()) throw std::runtime_error("no figure " + name);
  return *found;
}

/// Two participants who choose the comparison as often as stated, of 20 trials at each level of two textures; the second
/// one without the last levels that are left out. `unsure`: so many last responses at each level are "cannot tell".
std::vector<Figure> figures_of_discrimination(const std::string& judgement,
                                              const std::vector<double>& values_m,
                                              const std::vector<int>& hits,
                                              std::size_t left_out_of_second = 0, int unsure = 0) {
  nlohmann::json protocol = nlohmann::json::parse(R"({"kind": "discrimination",
    "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-05}}},
    "blocks": {"only": {
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels": []},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "question": {"name": "which", "prompt": "Which is rougher?"}}}})");
  protocol["blocks"]["only"]["question"]["judgement"] = judgement;
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  for (const std::string label : {"p1", "p2"}) {
    std::vector<MadeUpTrial> trials{};
    const std::size_t levels = values_m.size() - (label == "p2" ? left_out_of_second : 0);
    for (const char* const texture : {"metal", "wood"}) {
      for (std::size_t level = 0; level < levels; ++level) {
        for (int i = 0; i < 20; ++i) {
          MadeUpTrial trial{};
          trial.factors_json =
              nlohmann::json{{"amplitude_m", values_m[level]}, {"texture", texture}}.dump();
          trial.surfaces = {surface_of("standard", "sinusoid", ""),
                            surface_of("comparison", "sinusoid", "")};
          trial.answers = {i < hits[level] ? "comparison" : "standard"};
          trial.options = {"standard", "comparison"};
          if (unsure > 0) trial.options.emplace_back("cannot_tell");
          if (i >= 20 - unsure) trial.answers = {"cannot_tell"};
          if (judgement == "performance") trial.right = {"comparison"};
          trials.push_back(trial);
        }
      }
    }
    made.add_person(label, "");
    made.add_session(label, id, trials);
  }
  return figures_of(analyze_study(made.study(), std::nullopt, {}).front());
}

TEST(ThresholdFigures, DrawTheFunctionsOfEachParticipantInTheirUnit) {
  const std::vector<Figure> figures = figures_of_discrimination(
      "performance", {52.5e-6, 55e-6, 60e-6, 65e-6, 75e-6}, {10, 12, 15, 18, 20});
  const Figure& figure = figure_named(figures, "psychometric_p1");
  EXPECT_TRUE(figure.is_drawn());
  EXPECT_EQ(figure.table, "psychometric");
  EXPECT_EQ(figure.x.unit, "µm");
  EXPECT_EQ(figure.x.name.english(), "difference of the amplitude from the standard");
  EXPECT_EQ(figure.y.name.english(), "proportion correct");
  const FigureSeries& metal = figure.series.front();
  EXPECT_EQ(metal.name.english(), "metal");
  ASSERT_EQ(metal.points.size(), 5U);
  EXPECT_NEAR(metal.points[2].x, 10.0, 1e-9);
  EXPECT_NEAR(metal.points[2].y, 0.75, 1e-9);
  ASSERT_FALSE(metal.lines.empty());
  EXPECT_NEAR(metal.lines.front().back().y, 1.0, 0.07) << "the curve has the same unit";
  ASSERT_EQ(figure.references.size(), 1U);
  EXPECT_EQ(figure.references.front().value, 0.5);
  const Figure& thresholds = figure_named(figures, "thresholds");
  EXPECT_EQ(thresholds.x.unit, "µm");
  ASSERT_EQ(thresholds.y.places.size(), 2U);
  EXPECT_EQ(thresholds.y.places.front().english(), "metal");
  EXPECT_NEAR(thresholds.series.back().points.front().x, 10.0, 2.0);
}

TEST(ThresholdFigures, DrawHitsThatAreNotWholeWithTheirBootstrapIntervals) {
  const std::vector<Figure> figures = figures_of_discrimination(
      "performance", {52.5e-6, 55e-6, 60e-6, 65e-6, 75e-6}, {10, 12, 15, 18, 20}, 0, 1);
  const Figure& figure = figure_named(figures, "psychometric_p1");
  ASSERT_TRUE(figure.is_drawn());
  const FigureSeries& metal = figure.series.front();
  ASSERT_EQ(metal.points.size(), 5U);
  EXPECT_NEAR(metal.points[2].y, 15.5 / 20.0, 1e-9);
  EXPECT_NEAR(metal.points[4].y, 19.5 / 20.0, 1e-9);
  EXPECT_THAT(figure.note.english(),
              HasSubstr("95 % CIs by percentiles of a bootstrap of the three outcomes."));
  const std::vector<Figure> choices =
      figures_of_discrimination("comparison", {35e-6, 45e-6, 55e-6, 65e-6}, {1, 6, 14, 19}, 0, 1);
  EXPECT_THAT(figure_named(choices, "psychometric_p1_comparison").note.english(),
              HasSubstr("bootstrap of the three outcomes"));
}

// The second participant has no level above 75 % correct: no threshold, and no open symbol.
TEST(ThresholdFigures, ExplainOnlyTheThresholdsThatAreDrawn) {
  const std::vector<Figure> figures = figures_of_discrimination(
      "performance", {52.5e-6, 55e-6, 60e-6, 65e-6, 75e-6}, {10, 11, 12, 18, 20}, 2);
  EXPECT_THAT(figure_named(figures, "psychometric_p1").note.english(),
              HasSubstr("Open symbols: thresholds, the level of 75 % correct, with 95 % CIs by the "
                        "delta method."));
  EXPECT_THAT(figure_named(figures, "psychometric_p2").note.english(),
              Not(HasSubstr("Open symbols")));
  EXPECT_THAT(figure_named(figures, "thresholds").note.english(), HasSubstr("there are no CIs"));
  EXPECT_EQ(
      note_on_functions({.percent_correct = "75", .intervals = FunctionsNote::Intervals::none})
          .english(),
      "Filled symbols: proportions correct, larger for more trials. Curves: "
      "maximum-likelihood psychometric functions. Open symbols: thresholds, the level of 75 % "
      "correct, without CIs.");
}

TEST(ThresholdFigures, HaveTheSameAxisForAllParticipants) {
  const std::vector<Figure> figures = figures_of_discrimination(
      "performance", {52.5e-6, 55e-6, 60e-6, 70e-6, 1250e-6}, {10, 12, 15, 18, 20}, 1);
  const FigureAxis& first = figure_named(figures, "psychometric_p1").x;
  const FigureAxis& second = figure_named(figures, "psychometric_p2").x;
  EXPECT_EQ(first.unit, "mm");
  EXPECT_EQ(second.unit, first.unit);
  EXPECT_EQ(second.low, first.low);
  EXPECT_EQ(second.high, first.high);
  EXPECT_GT(second.high, 1.2);
}

TEST(ThresholdFigures, DrawThePointOfSubjectiveEqualityNextToTheStandard) {
  const std::vector<Figure> figures =
      figures_of_discrimination("comparison", {35e-6, 45e-6, 55e-6, 65e-6}, {1, 6, 14, 19});
  const Figure& figure = figure_named(figures, "psychometric_p2_comparison");
  EXPECT_EQ(figure.x.name.english(), "amplitude of the comparison");
  EXPECT_EQ(figure.y.name.english(), "proportion of choices");
  ASSERT_EQ(figure.references.size(), 1U);
  EXPECT_EQ(figure.references.front().at, FigureReference::At::x);
  EXPECT_NEAR(figure.references.front().value, 50.0, 1e-9);
  const FigureSeries& mark = figure.series.back();
  ASSERT_TRUE(mark.hollow);
  EXPECT_NEAR(mark.points.front().x, 50.0, 0.5);
  EXPECT_EQ(mark.points.front().y, 0.5);
  EXPECT_NEAR(figure_named(figures, "points_of_subjective_equality").series.back().points.front().x,
              50.0, 0.5);
}

TEST(TrackFigures, DrawEveryTrialByItsResponseAndRingsAtReversals) {
  const ReferenceCase read = read_reference_case(std::filesystem::path(ASPERITY_SOURCE_DIR) /
                                                 "tests/analysis/reference/staircase_01");
  const std::vector<Finding> findings = tidy_family("staircase").findings(read.input);
  const std::vector<Figure> figures = figures_of("staircase", read.input, findings, "mm");
  ASSERT_EQ(figures.size(), 1U);
  const Figure& figure = figures.front();
  EXPECT_EQ(figure.name, "tracks");
  EXPECT_EQ(figure.y.unit, "mm");
  const FoundNumbers found(findings);
  std::size_t filled = 0;
  std::size_t open = 0;
  std::size_t rings = 0;
  for (const FigureSeries& series : figure.series) {
    if (!series.hollow) {
      filled += series.points.size();
    } else if (!series.points.empty() && series.points.front().size > 2.0) {
      rings += series.points.size();
    } else {
      open += series.points.size();
    }
  }
  const auto responses = read.input.table().numbers("response");
  EXPECT_EQ(filled, static_cast<std::size_t>(std::count(responses.begin(), responses.end(), 1.0)));
  EXPECT_EQ(open, static_cast<std::size_t>(std::count(responses.begin(), responses.end(), 0.0)));
  double reversals = 0.0;
  for (const Finding* const count : found.all("n.reversals"))
    reversals += count->value.value_or(0.0);
  EXPECT_EQ(static_cast<double>(rings), reversals);
}

TEST(TrackFigures, DrawTheTracksOfEachParticipantOfAStudy) {
  StoredTable tracks{
      .name = "tracks",
      .table = {{"participant", "condition", "track", "step", "level", "hit", "unit"}, {}}};
  const std::vector<double> levels_m{70e-6, 60e-6, 65e-6, 60e-6};
  for (const char* const person : {"p1", "p2"}) {
    for (std::size_t i = 0; i < levels_m.size(); ++i) {
      tracks.table.rows.push_back({std::string(person), std::string("all"), std::int64_t{1},
                                   static_cast<std::int64_t>(i + 1), levels_m[i],
                                   std::int64_t{i == 1 ? 0 : 1}, std::string("m")});
    }
  }
  const std::vector<Figure> figures = track_figures(result_of(tracks), {});
  const Figure& figure = figure_named(figures, "tracks_p2");
  EXPECT_EQ(figure.y.unit, "µm");
  ASSERT_EQ(figure.series.size(), 3U);
  EXPECT_EQ(figure.series[0].points.size(), 2U) << "reversals after the second and the third trial";
  EXPECT_EQ(figure.series[1].points.size(), 3U);
  EXPECT_NEAR(figure.series[1].points[0].y, 70.0, 1e-9);
  ASSERT_EQ(figure.series[2].points.size(), 1U);
  EXPECT_NEAR(figure.series[2].points[0].y, 60.0, 1e-9);
}

TEST(TrackFigures, HaveASymbolForResponsesThatCannotTell) {
  StoredTable tracks{
      .name = "tracks",
      .table = {{"participant", "condition", "track", "step", "level", "hit", "unit"}, {}}};
  for (const auto& [person, third] : {std::pair{"p1", 0.5}, std::pair{"p2", 0.0}}) {
    for (const auto& [step, hit] : {std::pair{1, 1.0}, std::pair{2, 0.0}, std::pair{3, third}}) {
      tracks.table.rows.push_back({std::string(person), std::string("all"), std::int64_t{1},
                                   std::int64_t{step}, 70e-6, hit, std::string("m")});
    }
  }
  const std::vector<Figure> figures = track_figures(result_of(tracks), {});
  const Figure& with = figure_named(figures, "tracks_p1");
  EXPECT_THAT(with.note.english(), HasSubstr("Open symbols with a dot: responses “cannot tell”"));
  ASSERT_EQ(with.series.size(), 3U);
  EXPECT_EQ(with.series[1].points.size(), 2U);
  EXPECT_TRUE(with.series[1].hollow);
  ASSERT_EQ(with.series[2].points.size(), 1U) << "drawn last, into the open symbol";
  EXPECT_FALSE(with.series[2].hollow);
  EXPECT_EQ(with.series[2].points[0].x, 3.0);
  EXPECT_LT(with.series[2].points[0].size, 0.5);
  const Figure& without = figure_named(figures, "tracks_p2");
  EXPECT_EQ(without.series.size(), 2U);
  EXPECT_THAT(without.note.english(), testing::Not(HasSubstr("dot")));
}

TEST(TrackFigures, SeparateTheRunsOfABlock) {
  StoredTable tracks{.name = "tracks",
                     .table = {{"participant", "condition", "session", "block_ordinal", "track",
                                "step", "level", "hit", "unit"},
                               {}}};
  for (const auto& [session, block_ordinal] : {std::pair{1, 2}, std::pair{1, 4}, std::pair{2, 2}}) {
    for (const std::int64_t step : {1, 2, 3}) {
      tracks.table.rows.push_back({std::string("p1"), std::string("wood"), std::int64_t{session},
                                   std::int64_t{block_ordinal}, std::int64_t{1}, step, 70e-6,
                                   std::int64_t{1}, std::string("m")});
    }
  }
  const std::vector<Figure> figures = track_figures(result_of(tracks), {});
  const Figure& figure = figure_named(figures, "tracks_p1");
  std::vector<std::string> names{};
  for (const FigureSeries& series : figure.series) {
    names.push_back(series.name.english());
    EXPECT_EQ(series.points.size(), 3U);
  }
  EXPECT_THAT(names, testing::ElementsAre("wood, run 1, track 1", "wood, run 2, track 1",
                                          "wood, run 3, track 1"));
}

TEST(TrackFigures, FindReversalsInTheLevels) {
  std::vector<TrackTrial> trials{};
  for (const double level : {10.0, 8.0, 8.0, 6.0, 8.0, 6.0, 4.0})
    trials.push_back({.level = level});
  mark_reversals(trials);
  std::vector<bool> marked{};
  for (const TrackTrial& trial : trials) marked.push_back(trial.is_reversal);
  EXPECT_THAT(marked, testing::ElementsAre(false, false, false, true, true, false, false));
}

TEST(TrackFigures, StateThatThereIsNoTrial) {
  EXPECT_THAT(tracks_figure({}, "mm").instead.english(), HasSubstr("No track has a trial"));
}

}  // namespace
}  // namespace asperity
