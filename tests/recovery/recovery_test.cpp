// Whether thresholds are found again, and whether their errors are counted right.

#include "tests/recovery/recovery.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "app/findings/methods/discrimination/thresholds/discrimination_coverage.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/tables/tidy_table.h"
#include "tests/recovery/posterior_coverage.h"
#include "tests/recovery/threshold_coverage.h"

namespace asperity {
namespace {

const RecoveryProcedure& recovery_procedure(std::string_view name) {
  static const std::vector<RecoveryProcedure> kAll = recovery_procedures();
  return *std::find_if(kAll.begin(), kAll.end(), [name](const RecoveryProcedure& procedure) {
    return procedure.name == name;
  });
}

const RecoveryRow& row_in(const std::vector<RecoveryRow>& rows, RecoveryEstimate estimate,
                          std::size_t trials) {
  return *std::find_if(rows.begin(), rows.end(), [&](const RecoveryRow& row) {
    return row.estimate == estimate && row.trials == trials;
  });
}

TEST(Recovery, UsesSettingsWithoutProblems) {
  for (const RecoveryProcedure& procedure : recovery_procedures()) {
    EXPECT_TRUE(problems_of(procedure.settings).empty()) << procedure.name;
    EXPECT_EQ(procedure_of(procedure.settings).most_trials(procedure.settings), 240U);
  }
}

TEST(Recovery, GivesTheSameRowsForAnyNumberOfJobs) {
  const RecoveryProcedure& procedure = recovery_procedure("weighted_75");
  const auto one = recovery_rows(procedure, {}, {.observers = 24, .jobs = 1});
  EXPECT_EQ(one, recovery_rows(procedure, {}, {.observers = 24, .jobs = 3}));
  EXPECT_NE(one, recovery_rows(procedure, {}, {.observers = 24, .jobs = 1, .seed = 2}));
}

// An earlier simulation by another program, with 400 observers of α from ±0.3: RMSE 0.055 for the 3-down staircase with
// a maximum likelihood fit at its own target. The standard error of an RMSE of 400 is 1/√800 of it, 3.5 %: 0.058 leaves
// one and a half of them.
TEST(Recovery, FindsThresholdsAsPreciselyAsAnEarlierSimulation) {
  const auto rows = recovery_rows(recovery_procedure("1u3d"), {.beta = 3.5, .lapse = 0.02},
                                  {.observers = 400, .jobs = 2});
  const RecoveryRow& fit = row_in(rows, RecoveryEstimate::fit_target, 60);
  EXPECT_LE(fit.rmse, 0.058);
  EXPECT_LE(fit.without, 4U);
  // Its numbers for 40, 80 and 120 trials, with 10 %.
  EXPECT_LE(row_in(rows, RecoveryEstimate::fit_target, 40).rmse, 1.1 * 0.078);
  EXPECT_LE(row_in(rows, RecoveryEstimate::fit_target, 80).rmse, 1.1 * 0.040);
  EXPECT_LE(row_in(rows, RecoveryEstimate::fit_target, 120).rmse, 1.1 * 0.035);
}

// The stored table has an RMSE of 0.049 for 400 observers; the standard error of an RMSE of 40 is 11 % of it.
TEST(Recovery, FindsThresholdsOfPsi) {
  const auto procedures = bayesian_recovery_procedures();
  const auto rows =
      recovery_rows(procedures.front(), {.beta = 3.5, .lapse = 0.02}, {.observers = 40, .jobs = 2});
  EXPECT_LE(row_in(rows, RecoveryEstimate::posterior_target, 60).rmse, 0.066);
  EXPECT_EQ(row_in(rows, RecoveryEstimate::posterior_target, 60).without, 0U);
}

// 200 truths from the prior: X² of 20 equally probable ranks is below its 99.9 % quantile of 43.8, and a coverage below
// 90 % or above 99.5 % has a probability below 1 in 500 where it is 95 %.
TEST(PosteriorCoverage, IsCalibratedForObserversOfThePrior) {
  for (const std::size_t cell : {0U, 1U}) {  // psi, QUEST+
    const PosteriorCell one = posterior_cells()[cell];
    ASSERT_FALSE(one.beta);
    const PosteriorCoverage coverage = posterior_coverage(one, {.observers = 200, .jobs = 2});
    EXPECT_LT(coverage.chi_squared(), 43.8) << one.procedure;
    EXPECT_GE(coverage.covered(), 0.90) << one.procedure;
    EXPECT_LE(coverage.covered(), 0.995) << one.procedure;
    EXPECT_EQ(coverage, posterior_coverage(one, {.observers = 200, .jobs = 1}));
  }
}

TEST(PosteriorCoverageTable, HasTheCalibrationOf2000Observers) {
  const std::filesystem::path path =
      std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/data/posterior_coverage.tsv";
  const TidyTable table(read_file(path), path.string());
  const auto betas = table.texts("beta");
  const auto observers = table.all_numbers("observers");
  const auto covered = table.all_numbers("covered");
  const auto chi_squared = table.all_numbers("chi_squared");
  ASSERT_EQ(table.rows(), posterior_cells().size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    EXPECT_GE(observers[row], 2000.0);
    if (betas[row] != "prior") continue;
    EXPECT_GE(covered[row], 0.93);
    EXPECT_LE(covered[row], 0.97);
    EXPECT_LT(chi_squared[row], 43.8);
  }
}

// The efficient estimate of many trials: the error approaches the bound, and neither is far below the other.
TEST(Recovery, ApproachesItsBoundWithManyTrials) {
  const auto rows = recovery_rows(recovery_procedure("constant"), {.beta = 3.5, .lapse = 0.02},
                                  {.observers = 200, .jobs = 2});
  const RecoveryRow& many = row_in(rows, RecoveryEstimate::fit_common, 240);
  EXPECT_NEAR(many.rmse / many.bound, 1.0, 0.15);
  EXPECT_LT(std::abs(many.bias), 0.01);
  // Five levels equally often: the information of 240 trials is four times that of 60, and the bound half.
  EXPECT_NEAR(row_in(rows, RecoveryEstimate::fit_common, 60).bound / many.bound, 2.0, 1e-9);
}

// Information by hand for a single level: with β known the bound at the level of the performance itself would be the
// binomial one, √(p(1 − p)/n)/ψ′. Two parameters cannot be better.
TEST(Recovery, HasABoundAboveThatOfTheBestLevel) {
  const RecoveryObserver observer{.beta = 2.0, .lapse = 0.0};
  const auto rows = recovery_rows(recovery_procedure("constant"), observer, {.observers = 50});
  // F = ½ at 75 %; F′ = ln 10·β·ln 2·½ per log10 unit, ψ′ = ½F′.
  const double slope = 0.5 * std::log(10.0) * 2.0 * std::log(2.0) * 0.5;
  const double single = std::sqrt(0.75 * 0.25 / 60.0) / slope;
  const double bound = row_in(rows, RecoveryEstimate::fit_common, 60).bound;
  EXPECT_GT(bound, single);
  EXPECT_LT(bound, 2.0 * single);
}

// Per trial, half the guesses as "cannot tell" have 1.5·ψ/(1.5·ψ − 0.5) times the information, 1.8 times at 75 %.
TEST(Recovery, IsMorePreciseWhereGuessesAreReplaced) {
  const RecoveryRun run{.observers = 200, .jobs = 2};
  const auto forced = recovery_rows(recovery_procedure("weighted_75"), {}, run);
  const auto unforced = recovery_rows(recovery_procedure("unforced_75"), {}, run);
  const RecoveryRow& with_guesses = row_in(forced, RecoveryEstimate::fit_common, 120);
  const RecoveryRow& without = row_in(unforced, RecoveryEstimate::fit_common, 120);
  EXPECT_LT(without.bound, 0.9 * with_guesses.bound);
  EXPECT_LT(without.rmse, 0.95 * with_guesses.rmse);
  EXPECT_LT(std::abs(without.bias), 0.012);
}

TEST(Recovery, ReportsReversalsAtTheTargetOfTheProcedure) {
  const auto rows = recovery_rows(recovery_procedure("1u2d"), {.beta = 3.5, .lapse = 0.0},
                                  {.observers = 200, .jobs = 2});
  // At the target the bias of long tracks is some hundredths; the 75 % point is 0.05 away.
  EXPECT_LT(std::abs(row_in(rows, RecoveryEstimate::reversals, 240).bias), 0.045);
  EXPECT_EQ(row_in(rows, RecoveryEstimate::reversals, 240).without, 0U);
}

/// The RMSE by procedure, estimate, β, λ and number of trials, and the smallest number of observers.
struct StoredErrors {
  std::map<std::tuple<std::string, std::string, double, double, double>, double> rmse{};
  double observers = 0.0;
};
StoredErrors stored_errors(const std::filesystem::path& file) {
  const std::filesystem::path path = std::filesystem::path(ASPERITY_SOURCE_DIR) / file;
  const TidyTable table(read_file(path), path.string());
  const auto procedures = table.texts("procedure");
  const auto estimates = table.texts("estimate");
  const auto betas = table.all_numbers("beta");
  const auto lapses = table.all_numbers("lapse");
  const auto trials = table.all_numbers("trials");
  const auto observers = table.all_numbers("observers");
  const auto rmse = table.all_numbers("rmse_log10");
  StoredErrors stored{.observers = *std::min_element(observers.begin(), observers.end())};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    stored.rmse[{std::string(procedures[row]), std::string(estimates[row]), betas[row], lapses[row],
                 trials[row]}] = rmse[row];
  }
  return stored;
}

TEST(RecoveryTable, HasTheThresholdsOfAtLeast2000ObserversPerCell) {
  const StoredErrors stored = stored_errors("docs/data/threshold_recovery.tsv");
  EXPECT_GE(stored.observers, 2000.0);
  for (const RecoveryProcedure& procedure : recovery_procedures()) {
    for (const RecoveryObserver& observer : recovery_observers()) {
      for (const std::size_t trials : recovery_trials()) {
        EXPECT_TRUE(stored.rmse.contains({std::string(procedure.name), "fit_75", observer.beta,
                                          observer.lapse, static_cast<double>(trials)}));
      }
    }
  }
  EXPECT_LE(stored.rmse.at({"1u3d", "fit_target", 3.5, 0.02, 60.0}), 0.058);
}

// The earlier simulation: RMSE 0.048 of psi with slope and lapse rate marginalised, at its own target after 60 trials, and
// 0.083, 0.039 and 0.033 after 40, 80 and 120. The bar of 0.053 leaves three standard errors; the others have 10 %.
TEST(RecoveryTable, HasThresholdsOfPsiAsPreciseAsThoseOfAnEarlierSimulation) {
  const StoredErrors stored = stored_errors("docs/data/bayesian_recovery.tsv");
  EXPECT_GE(stored.observers, static_cast<double>(kBayesianObservers));
  const auto rmse = [&](double trials) {
    return stored.rmse.at({"psi", "posterior_target", 3.5, 0.02, trials});
  };
  EXPECT_LE(rmse(60.0), 0.053);
  EXPECT_LE(rmse(40.0), 1.1 * 0.083);
  EXPECT_LE(rmse(80.0), 1.1 * 0.039);
  EXPECT_LE(rmse(120.0), 1.1 * 0.033);
  for (const RecoveryProcedure& procedure : bayesian_recovery_procedures()) {
    EXPECT_TRUE(problems_of(procedure.settings).empty()) << procedure.name;
    for (const RecoveryObserver& observer : bayesian_recovery_observers()) {
      EXPECT_TRUE(stored.rmse.contains(
          {std::string(procedure.name), "posterior_75", observer.beta, observer.lapse, 60.0}));
    }
  }
}

// The bar is 1.1 times the RMSE of the other program, which all cells hold; the greatest ratio is 1.091. The mean of all
// ratios shows that neither program is better.
TEST(RecoveryTable, IsAsPreciseAsAnIndependentSimulation) {
  const StoredErrors stored = stored_errors("docs/data/threshold_recovery.tsv");
  const StoredErrors independent = stored_errors("tests/recovery/independent.tsv");
  EXPECT_EQ(independent.rmse.size(), 5U * 9U * 5U + 4U * 9U * 5U) << "all forced choices";
  double logarithms = 0.0;
  for (const auto& [cell, rmse] : independent.rmse) {
    const auto& [procedure, estimate, beta, lapse, trials] = cell;
    EXPECT_LE(stored.rmse.at(cell), 1.1 * rmse)
        << procedure << ' ' << estimate << ' ' << beta << ' ' << lapse << ' ' << trials;
    logarithms += std::log(stored.rmse.at(cell) / rmse);
  }
  EXPECT_NEAR(logarithms / static_cast<double>(independent.rmse.size()), 0.0, 0.03);
}

TEST(IntervalCoverage, IsTheSameForAnyNumberOfJobs) {
  const CoverageCell cell = coverage_cells().back();
  const IntervalCoverage one = interval_coverage(cell, {.observers = 6, .jobs = 1});
  EXPECT_EQ(one, interval_coverage(cell, {.observers = 6, .jobs = 2}));
  EXPECT_EQ(one.observers, 6U);
}

// With 40 observers and a coverage of 90 % or more, fewer than 31 of 40 have a probability below 1 in 100.
TEST(IntervalCoverage, OfRepeatedProceduresIsNearWhatTheyState) {
  for (const std::size_t cell : {1U, 5U}) {  // 3-down/1-up, 2 × 40 trials
    const IntervalCoverage coverage =
        interval_coverage(coverage_cells()[cell], {.observers = 40, .jobs = 2, .seed = 5});
    EXPECT_GE(coverage.intervals, 34U);
    EXPECT_LE(coverage.below + coverage.above, coverage.intervals - 31U * coverage.intervals / 40U);
    EXPECT_GT(coverage.without, 0U) << "some repetitions have no threshold, and they are counted";
    EXPECT_LT(coverage.without, 40U * 250U);
  }
}

TEST(IntervalCoverageTable, IsWhatTheProgramStatesNextToItsIntervals) {
  const std::filesystem::path path =
      std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/data/interval_coverage.tsv";
  const TidyTable table(read_file(path), path.string());
  const auto procedures = table.texts("procedure");
  const auto betas = table.all_numbers("beta");
  const auto observers = table.all_numbers("observers");
  const auto covered = table.all_numbers("covered");
  const auto stated = simulated_coverages();
  const std::vector<CoverageCell> cells = coverage_cells();
  ASSERT_EQ(table.rows(), cells.size());
  ASSERT_EQ(stated.size(), cells.size());
  for (std::size_t row = 0; row < cells.size(); ++row) {
    EXPECT_GE(observers[row], 1000.0);
    EXPECT_EQ(procedures[row], cells[row].procedure);
    EXPECT_EQ(stated[row].procedure, cells[row].procedure);
    EXPECT_EQ(betas[row], cells[row].beta);
    EXPECT_EQ(stated[row].beta, cells[row].beta);
    EXPECT_EQ(stated[row].tracks, cells[row].tracks.size());
    EXPECT_EQ(stated[row].tracks * stated[row].trials, cells[row].trials());
    EXPECT_NEAR(stated[row].coverage_percent, 100.0 * covered[row], 0.051);
  }
}

TEST(RecoveryTable, HasARowPerEstimateAndNumberOfTrials) {
  const auto rows = recovery_rows(recovery_procedure("1u2d"), {}, {.observers = 3});
  ASSERT_EQ(rows.size(), 4U * recovery_trials().size());
  const std::string text = recovery_header() + '\n' + row_text(rows.front()) + '\n';
  const TidyTable table(text, "rows");
  EXPECT_EQ(table.texts("procedure").front(), "1u2d");
  EXPECT_EQ(table.texts("estimate").front(), "fit_75");
  EXPECT_EQ(table.all_numbers("trials").front(), 40.0);
  EXPECT_NEAR(table.all_numbers("rmse_log10").front(), rows.front().rmse, 1e-6);
}

}  // namespace
}  // namespace asperity
