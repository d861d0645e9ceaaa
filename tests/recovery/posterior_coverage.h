// How often the credible intervals of psi and QUEST+ contain the true threshold.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/procedures/procedure.h"

namespace asperity {

/// A procedure with 60 trials, and its observers: drawn from the prior of the procedure, or, with a slope, as in recovery.h with
/// a lapse rate of 2 %.
struct PosteriorCell {
  std::string_view procedure{};  ///< in files and tables
  ProcedureSettings settings{};
  std::optional<double> beta{};
};
std::vector<PosteriorCell> posterior_cells();

/// Simulation-based calibration [Talts 2018]: the posterior probability that the threshold is below the true one, its rank, is
/// uniform between 0 and 1 if truths are drawn from the prior and the posterior distribution is correct. A true threshold is
/// distributed evenly over the step of the grid about its value, as the posterior distribution is. Ranks of observers that
/// are not drawn from the prior need not be uniform.
///
/// [Talts 2018] Talts, Betancourt, Simpson, Vehtari, Gelman: Validating Bayesian inference algorithms with simulation-based
/// calibration.
struct PosteriorCoverage {
  static constexpr std::size_t kRanks = 20;
  std::size_t observers = 0;
  std::vector<std::size_t> ranks{};  ///< observers by twentieth of the rank
  std::size_t below = 0;             ///< the 95 % interval is below the true threshold
  std::size_t above = 0;             ///< the interval is above it
  double ratio = 0.0;                ///< median of the upper over the lower end

  double covered() const {
    return 1.0 - static_cast<double>(below + above) / static_cast<double>(observers);
  }
  /// Pearson's X² of the ranks against equal proportions; 19 degrees of freedom.
  double chi_squared() const;

  bool operator==(const PosteriorCoverage&) const = default;
};

struct PosteriorCoverageRun {
  std::size_t observers = 2000;
  std::size_t jobs = 1;  ///< the numbers do not depend on it
  std::uint64_t seed = 1;
};
PosteriorCoverage posterior_coverage(const PosteriorCell& cell, const PosteriorCoverageRun& run);

std::string posterior_coverage_header();
std::string row_text(const PosteriorCell& cell, const PosteriorCoverage& coverage);

}  // namespace asperity
