// Which attempts count in analyses, and the first reason why others do not.

#include "results_schema/analysis_use.h"

#include <gtest/gtest.h>

#include "results_schema/rows.h"

namespace asperity {
namespace {

/// An answered attempt at a trial of the main phase.
struct Answered {
  PlannedTrialRow trial{};
  AttemptRow attempt{};
  Answered() {
    trial.phase = "main";
    attempt.responses.emplace_back();
  }
  AnalysisUse use() const { return use_in_analyses(trial, attempt); }
};

TEST(AnalysisUse, CountsAnsweredAttemptsOfTheMainPhase) {
  Answered it;
  EXPECT_EQ(it.use(), AnalysisUse::counted);
  it.attempt.flagged = true;
  EXPECT_EQ(it.use(), AnalysisUse::counted) << "a flag leaves nothing out";
}

TEST(AnalysisUse, LeavesOutForTheFirstOfItsReasons) {
  Answered it;
  it.attempt.excluded = "the alarm rang";
  EXPECT_EQ(it.use(), AnalysisUse::excluded);
  it.attempt.responses.clear();
  EXPECT_EQ(it.use(), AnalysisUse::unanswered);
  it.attempt.valid = false;
  EXPECT_EQ(it.use(), AnalysisUse::invalid);
  it.trial.repetition = 0;
  EXPECT_EQ(it.use(), AnalysisUse::anchor);
  it.trial.phase = "practice";
  EXPECT_EQ(it.use(), AnalysisUse::practice);
}

TEST(AnalysisUse, IsKnownOfATrialBeforeItIsRun) {
  EXPECT_EQ(use_in_analyses("main", 2, false), AnalysisUse::counted);
  EXPECT_EQ(use_in_analyses("main", 0, false), AnalysisUse::anchor);
  EXPECT_EQ(use_in_analyses("main", 0, true), AnalysisUse::catch_trial);
  EXPECT_EQ(use_in_analyses("practice", 0, true), AnalysisUse::practice);
  EXPECT_EQ(use_in_analyses("familiarisation", 1, false), AnalysisUse::practice);
}

}  // namespace
}  // namespace asperity
