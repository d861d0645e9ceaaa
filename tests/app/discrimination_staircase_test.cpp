// Discriminations whose levels a staircase chose: tracks, intervals by repeating the procedure, catch trials.

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/psychometric_function.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_coverage.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/study_tests.h"
#include "app/findings/study/analyze_study.h"
#include "protocols/file/stored_protocol.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"
#include "tests/app/stored_tables.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Discrimination, CountsErrorsInCatchTrialsAndEstimatesNothingFromThem) {
  const auto outcome_with = [](bool with_catch_trials) {
    const MadeUpParticipants two{.number = 2, .first = 1};
    return outcome_of_choices(discrimination_protocol("performance"), two, [&](int person) {
      MadeUpObserver observer(kPerformer, static_cast<unsigned>(person + 1));
      std::vector<MadeUpTrial> trials = trials_of(observer.choices(kAbove_m, 40, true));
      for (int i = 0; i < 5 && with_catch_trials; ++i) {
        MadeUpTrial easy = discriminated({.value_m = 100e-6, .chose_comparison = i > 0});
        if (i == 4) {  // a missed deadline
          easy.outcome = AttemptOutcome::timed_out;
          easy.answers.clear();
          easy.right.clear();
        }
        easy.repetition = 0;
        easy.is_catch = true;
        easy.valid = person == 0 || i != 3;
        trials.push_back(easy);
      }
      return trials;
    });
  };
  const AnalysisOutcome with = outcome_with(true);
  const AnalysisOutcome without = outcome_with(false);
  EXPECT_EQ(table_of(with, "thresholds").table.rows, table_of(without, "thresholds").table.rows);
  EXPECT_EQ(table_of(with, "order").table.rows, table_of(without, "order").table.rows);
  EXPECT_EQ(with.count.planned_trials, without.count.planned_trials);
  const Table& caught = table_of(with, "catch_trials").table;
  const std::vector<std::vector<Cell>> expected{
      {std::string("p1"), std::string("only"), std::int64_t{3}, std::int64_t{5}, 0.6},
      {std::string("p2"), std::string("only"), std::int64_t{2}, std::int64_t{4}, 0.5}};
  EXPECT_EQ(caught.rows, expected);
  EXPECT_THROW(table_of(without, "catch_trials"), std::runtime_error);
}

TEST(Discrimination, NeverReportsProportionsOverLevelsOfAProcedure) {
  json protocol = discrimination_protocol("performance");
  MadeUpStudy made;
  const std::int64_t constant = made.add_protocol("constant", "discrimination", protocol.dump());
  protocol["blocks"]["only"]["procedure"] = {{"method", "transformed_up_down"}};
  const std::int64_t adaptive = made.add_protocol("adaptive", "discrimination", protocol.dump());
  for (const char* const label : {"p1", "p2"}) {
    made.add_person(label, "");
    for (const std::int64_t id : {constant, adaptive}) {
      made.add_session(label, id,
                       trials_of(MadeUpObserver(kPerformer, 3).choices(kAbove_m, 20, true)));
    }
  }
  for (const AnalysisOutcome& outcome : analyze_study(made.study(), std::nullopt, {})) {
    const bool is_constant = outcome.protocol == "constant";
    EXPECT_EQ(column_of(table_of(outcome, "order").table, "share_first").has_value(), is_constant);
    EXPECT_EQ(column_of(table_of(outcome, "trial_course").table, "share").has_value(), is_constant);
    EXPECT_TRUE(column_of(table_of(outcome, "order").table, "difference"));
  }
}

// Two interleaved tracks in each of two runs of a block, and one of a second session.
TEST(Discrimination, ListsTheTrialsOfTracksInTheirOrder) {
  MadeUpStudy made;
  json protocol = discrimination_protocol("performance");
  protocol["blocks"]["only"]["procedure"] = {{"method", "transformed_up_down"}};
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  made.add_person("p1", "");
  const auto run_of = [](int block_ordinal, int tracks) {
    std::vector<MadeUpTrial> trials{};
    int count = 0;
    for (MadeUpTrial& trial : trials_of(MadeUpObserver(kPerformer, 5).choices(kAbove_m, 2, true))) {
      trial.block_ordinal = block_ordinal;
      trial.track = 1 + count % tracks;
      trial.step = 1 + count++ / tracks;
      trials.push_back(trial);
    }
    return trials;
  };
  std::vector<MadeUpTrial> trials = run_of(2, 2);
  for (const MadeUpTrial& trial : run_of(4, 2)) trials.push_back(trial);
  made.add_session("p1", id, trials);
  made.add_session("p1", id, run_of(2, 1));
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const Table& tracks = table_of(outcome, "tracks").table;
  ASSERT_EQ(tracks.rows.size(), 30U);
  std::vector<std::vector<std::int64_t>> expected{};
  for (const auto& [session, block_ordinal, track, steps] :
       {std::tuple{1, 2, 1, 5}, std::tuple{1, 2, 2, 5}, std::tuple{1, 4, 1, 5},
        std::tuple{1, 4, 2, 5}, std::tuple{2, 2, 1, 10}}) {
    for (int step = 1; step <= steps; ++step) {
      expected.push_back({session, block_ordinal, track, step});
    }
  }
  std::vector<std::vector<std::int64_t>> listed{};
  for (const std::vector<Cell>& row : tracks.rows) {
    std::vector<std::int64_t>& one = listed.emplace_back();
    for (const char* const column : {"session", "block_ordinal", "track", "step"}) {
      one.push_back(std::get<std::int64_t>(row[*column_of(tracks, column)]));
    }
  }
  EXPECT_EQ(listed, expected);
  EXPECT_EQ(tracks.rows.back()[*column_of(tracks, "level")], Cell(kAbove_m.back()));
}

// The trials of constant stimuli are numbered like those of a track, but no level follows from a response.
TEST(Discrimination, HasNoTracksOfConstantStimuli) {
  json protocol = discrimination_protocol("performance");
  protocol["blocks"]["only"]["procedure"] = {{"method", "constant_stimuli"}, {"repetitions", 20}};
  const AnalysisOutcome outcome = outcome_of_choices(protocol, {}, [](int) {
    std::vector<MadeUpTrial> trials =
        trials_of(MadeUpObserver(kPerformer, 5).choices(kAbove_m, 20, true));
    int step = 0;
    for (MadeUpTrial& trial : trials) {
      trial.track = 1;
      trial.step = ++step;
    }
    return trials;
  });
  EXPECT_THROW(table_of(outcome, "tracks"), std::runtime_error);
  EXPECT_FALSE(table_of(outcome, "psychometric").table.rows.empty());
}

TEST(Discrimination, RepeatsTheProcedureForTheIntervalsOfItsThresholds) {
  const AnalysisOutcome& outcome = outcome_of_twelve_staircases();
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  const double jnd_m = kPerformer.inverse(0.75);
  int given = 0;
  int holding = 0;
  for (const Finding* const jnd : found.all("jnd")) {
    if (!jnd->value) continue;
    ASSERT_TRUE(jnd->low && jnd->high) << jnd->key;
    EXPECT_THAT(jnd->method, HasSubstr("running the procedure again: 500 repetitions"));
    EXPECT_THAT(jnd->method, Not(HasSubstr("delta")));
    EXPECT_LT(*jnd->low, *jnd->value);
    EXPECT_GT(*jnd->high, *jnd->value);
    ++given;
    holding += *jnd->low <= jnd_m && jnd_m <= *jnd->high ? 1 : 0;
    const auto without = found.value("without", jnd->key);
    ASSERT_TRUE(without);
    EXPECT_LT(*without, 250.0);
  }
  EXPECT_GE(given, 10);
  EXPECT_GE(holding, given - 2) << "of 95 % intervals";
  const std::vector<Finding> functions = part_of(outcome, "psychometric");
  for (const Finding* const beta : FoundNumbers(functions).all("fit.beta")) {
    EXPECT_GE(*beta->value, 1.0);
    EXPECT_LE(*beta->value, 8.0);
  }
  const StoredTable& table = table_of(outcome, "thresholds");
  const auto without = column_of(table.table, "without_threshold");
  ASSERT_TRUE(without);
  EXPECT_EQ(table.table.rows[0][*column_of(table.table, "repetitions")], Cell(std::int64_t{500}));
  const Table shown = shown_table(outcome, "thresholds");
  EXPECT_FALSE(column_of(shown, "repetitions"));
  const Cell of_all = shown.rows[0][*column_of(shown, "without_threshold")];
  EXPECT_THAT(std::get<std::string>(of_all), testing::EndsWith("/500"));
  EXPECT_THAT(table.note.english(), HasSubstr("running the procedure again"));
  EXPECT_THAT(table.note.english(), Not(HasSubstr("delta"))) << "no interval is of this method";
  const AnalysisOutcome alone = outcome_of_staircases(staircase_protocol(40), 1, 80);
  int compared = 0;
  for (const Finding& each : part_of(alone, "thresholds")) {
    if (each.key != "p10|all") continue;
    const Finding* const same = found.find(composed_quantity(each.quantity), each.key);
    ASSERT_NE(same, nullptr) << each.quantity;
    EXPECT_EQ(each, *same) << each.quantity << ": the same for the same responses";
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

// A track that ended before its rule did is repeated with as many trials as it has.
TEST(Discrimination, RepeatsUnfinishedTracksWithTheirNumberOfTrials) {
  const json protocol = staircase_protocol(120);
  const AnalysisOutcome unfinished = outcome_of_staircases(protocol, 1, 60);
  const AnalysisOutcome finished = outcome_of_staircases(staircase_protocol(60), 1, 60);
  const std::vector<Finding> thresholds = part_of(unfinished, "thresholds");
  EXPECT_EQ(thresholds, part_of(finished, "thresholds"));
  const Finding* const jnd = FoundNumbers(thresholds).find("jnd", "p10|all");
  EXPECT_TRUE(jnd != nullptr && jnd->low && jnd->high);
  const Protocol::Block block = stored_protocol(protocol.dump()).protocol.blocks.at("only");
  ASSERT_EQ(block.procedure->tracks.size(), 2U);
  Dimension varied = *block.vary;
  const DiscriminationTask task{.is_performance = true, .varied = varied};
  const PlacedTrials placed{.tracks = {{.settings = block.procedure->tracks[0], .levels = varied}},
                            .fixed = {{60e-6, 7}}};
  std::uint64_t trials = 0;
  for (const PsychometricBlock& one : run_again(task, placed, kPerformer, Random(1))) {
    trials += one.trials;
  }
  EXPECT_EQ(trials, 120U + 7U);
}

// The second session was stopped after 60 of its 80 trials: the second track has 20 of 40.
TEST(Discrimination, MarksParticipantsWithAnUnfinishedTrack) {
  const json protocol = staircase_protocol(40);
  const auto study_of = [&](MadeUpStudy& made, SessionState last) {
    const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
    add_participants(made, id, {.number = 2}, [&](int person) {
      std::vector<MadeUpTrial> trials =
          staircase_trials(kPerformer, protocol, 200 + static_cast<std::uint64_t>(person));
      if (person == 1) {
        trials.resize(60);
        made.set_state(last);
      }
      return trials;
    });
  };
  MadeUpStudy made;
  study_of(made, SessionState::stopped);
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const StoredTable& table = table_of(outcome, "thresholds");
  const auto unfinished = column_of(table.table, "unfinished_tracks");
  ASSERT_TRUE(unfinished);
  EXPECT_EQ(table.table.rows[0][*unfinished], Cell{});
  EXPECT_EQ(table.table.rows[1][*unfinished], Cell(std::int64_t{1}));
  EXPECT_THAT(table.note.english(),
              HasSubstr("Unfinished tracks: tracks that were begun and not finished"));
  EXPECT_THAT(
      answer_to(outcome, "threshold"),
      HasSubstr(" Participants with an unfinished track: 1 of 2. Estimates from unfinished tracks "
                "that are included in the mean, because the presented trials were sufficient: 1 of "
                "1."));
  EXPECT_THAT(find_analysis("discrimination")->estimates(outcome).text,
              HasSubstr("Tracks of one of 2 participants were unfinished; the threshold was "
                        "estimated from the presented trials and is included in the means."));
  EXPECT_EQ(wide_rows(made).at(1).at("jnd_which_unfinished_tracks"), "1");

  // In a completed session the missing answers belong to attempts that do not count.
  MadeUpStudy completed;
  study_of(completed, SessionState::completed);
  EXPECT_FALSE(column_of(table_of(outcome_of_discrimination(completed), "thresholds").table,
                         "unfinished_tracks"));
  EXPECT_FALSE(wide_rows(completed).at(1).contains("jnd_which_unfinished_tracks"));
}

// Three trials at one or two levels have no threshold.
TEST(Discrimination, StatesNothingAboutTheMeanWhereAnUnfinishedTrackHasNoThreshold) {
  const json protocol = staircase_protocol(40);
  MadeUpStudy made;
  const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
  made.add_person("p10", "");
  std::vector<MadeUpTrial> trials = staircase_trials(kPerformer, protocol, 200);
  trials.resize(3);
  made.set_state(SessionState::stopped);
  made.add_session("p10", id, trials);
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  EXPECT_THAT(answer_to(outcome, "threshold"),
              testing::AllOf(HasSubstr(" Participants with an unfinished track: 1 of 1."),
                             Not(HasSubstr("included in the mean"))));
  EXPECT_THAT(find_analysis("discrimination")->estimates(outcome).text,
              HasSubstr("Tracks of the only participant were unfinished; no threshold could be "
                        "estimated from the presented trials."));
}

TEST(Discrimination, HasNoIntervalOfAProcedureThatCannotBeRepeated) {
  const json protocol = staircase_protocol(40);
  json unknown = protocol;
  unknown["blocks"]["only"]["procedure"]["steps"] = {3};  // not on the grid
  const AnalysisOutcome outcome = outcome_of_choices(
      unknown, {.first = 1}, [&](int) { return staircase_trials(kPerformer, protocol, 3); });
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const Finding* const jnd = FoundNumbers(thresholds).find("jnd", "p1|all");
  ASSERT_TRUE(jnd != nullptr && jnd->value);
  EXPECT_FALSE(jnd->low || jnd->high);
  EXPECT_THAT(jnd->method, HasSubstr("cannot be repeated"));
}

TEST(Discrimination, StatesTheSimulatedCoverageOfItsIntervals) {
  const auto coverages = simulated_coverages();
  const auto is_of_library = [](const SimulatedCoverage& each) {
    return each.down == 3 && each.tracks == 2 && each.trials == 40;
  };
  std::vector<SimulatedCoverage> rows{};
  std::copy_if(coverages.begin(), coverages.end(), std::back_inserter(rows), is_of_library);
  ASSERT_EQ(rows.size(), 2U);
  const bool deviates = std::any_of(rows.begin(), rows.end(), [](const SimulatedCoverage& row) {
    return row.coverage_percent < 93.0 || row.coverage_percent > 97.0;
  });
  const std::string simulated =
      table_of(outcome_of_twelve_staircases(), "thresholds").note.english();
  EXPECT_EQ(simulated.find("3-down/1-up, 2 × 40 trials") != std::string::npos, deviates)
      << simulated;
  EXPECT_THAT(simulated, Not(HasSubstr("was not simulated")));
  const AnalysisOutcome other = outcome_of_staircases(staircase_protocol(41), 1, 82);
  EXPECT_THAT(table_of(other, "thresholds").note.english(), HasSubstr("was not simulated"));
}

}  // namespace
}  // namespace asperity
