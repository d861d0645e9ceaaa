// The errors of thresholds that procedures and estimates find for simulated observers.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/psychometric/psychometric_model.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

/// The observer: two alternatives, ψ(x) = ½ + (½ − λ)·F(x) at the level 10^x, F the Gumbel function of x
/// (`psychometric_function.h`), the Weibull function of the level. Its α is uniform between ±`kAlphaSpread`.
struct RecoveryObserver {
  double beta = 3.5;
  double lapse = 0.02;

  bool operator==(const RecoveryObserver&) const = default;
};
inline constexpr double kAlphaSpread = 0.3;  ///< log10 units
inline constexpr double kGuess = 0.5;
inline constexpr double kCommonPerformance = 0.75;
/// What the fit assumes as the lapse rate of every observer.
inline constexpr double kAssumedLapse = 0.02;
inline constexpr SlopeRange kSlopeLimits{.least = 1.0, .greatest = 8.0};

struct RecoveryProcedure {
  std::string_view name{};     ///< in files and tables
  std::string_view meaning{};  ///< its settings, for readers
  ProcedureSettings settings{};
  /// The probability that the observer responds "cannot tell" instead of guessing. ψ is then the proportion of correct
  /// responses in which "cannot tell" counts ½.
  double unsure = 0.0;
};
/// On the grid of 81 levels from 0.1 to 10 in steps of 0.025 log10 units; up-down methods begin at 10^0.6. All have tracks
/// of the greatest number of `recovery_trials`, of which shorter ones are prefixes.
std::vector<RecoveryProcedure> recovery_procedures();
/// Psi and QUEST+ on the same grid, with 41 thresholds over its range and the target 80 %, near 1 − 1/e between guesses and
/// lapses. A track of theirs takes a hundred times as long, so that their tables have fewer observers.
std::vector<RecoveryProcedure> bayesian_recovery_procedures();
/// The numbers of trials after which a track is evaluated, ascending.
std::vector<std::size_t> recovery_trials();

/// How a threshold is estimated, and of which performance.
///
/// A fit is the maximum of the likelihood over α and β with γ = ½ and λ = `kAssumedLapse` (`maximise_psychometric`), β within
/// `kSlopeLimits` or free. A fit without a
/// function that rises and is more likely than every constant has no threshold; a threshold beyond the grid counts as its end.
/// A posterior mean is that of the prior of the procedure (`credible_threshold`), which does not know the lapse rate.
enum class RecoveryEstimate {
  fit_common,   ///< β within its limits, at `kCommonPerformance`
  free_common,  ///< β free, at `kCommonPerformance`; only of observers with the assumed lapse rate
  fit_target,   ///< β within its limits, at the target of the procedure
  posterior_common,  ///< of psi and QUEST+, at `kCommonPerformance`
  posterior_target,  ///< of psi and QUEST+, at the target of the procedure
  reversals  ///< the geometric mean of the reversals after the first four, an estimate of the target
};
std::string_view name_of(RecoveryEstimate estimate) noexcept;

/// Errors in log10 units: estimate minus the level at which the observer has the performance.
struct RecoveryRow {
  std::string procedure{};
  RecoveryEstimate estimate = RecoveryEstimate::fit_common;
  RecoveryObserver observer{};
  std::size_t trials = 0;
  std::size_t observers = 0;
  std::size_t without = 0;  ///< observers without a threshold, who are left out
  double bias = 0.0;        ///< mean error
  double rmse = 0.0;        ///< root of the mean squared error
  /// The least standard error of an unbiased estimate at the levels of these tracks, if γ and λ are known and α and β
  /// are not: √(∇gᵀ·I⁻¹·∇g), with the Fisher information I summed over trials and averaged over observers. Biased
  /// estimates, such as one at the end of the grid, can have a smaller error. `RecoveryProcedure::unsure` is known as well.
  double bound = 0.0;

  bool operator==(const RecoveryRow&) const = default;
};

struct RecoveryRun {
  std::size_t observers = 2000;
  std::size_t jobs = 1;  ///< the rows do not depend on it
  std::uint64_t seed = 1;
};

/// The rows of one procedure and one kind of observer: estimates, then numbers of trials. The i-th observers of all kinds and
/// procedures draw the same numbers, so that differences between rows are more precise than the rows.
std::vector<RecoveryRow> recovery_rows(const RecoveryProcedure& procedure,
                                       const RecoveryObserver& observer, const RecoveryRun& run);

/// The kinds of observers of the committed tables.
std::vector<RecoveryObserver> recovery_observers();
std::vector<RecoveryObserver> bayesian_recovery_observers();
inline constexpr std::size_t kBayesianObservers = 400;

std::string recovery_header();
/// Six decimals, which the same numbers have on every machine.
std::string row_text(const RecoveryRow& row);

}  // namespace asperity
