// Simulation-based calibration of psi and QUEST+, with 2000 truths from their prior.

#include <gtest/gtest.h>

#include "tests/recovery/posterior_coverage.h"

namespace asperity {
namespace {

// With 2000 truths the standard error of a coverage of 95 % is 0.5 %: 93 to 97 % leaves four of them. 43.8 is the 99.9 %
// quantile of χ² with 19 degrees of freedom.
TEST(PosteriorCoverage, IsCalibratedFor2000TruthsFromThePrior) {
  for (const PosteriorCell& cell : posterior_cells()) {
    if (cell.beta) continue;
    const PosteriorCoverage coverage =
        posterior_coverage(cell, {.observers = 2000, .jobs = 2, .seed = 3});
    EXPECT_GE(coverage.covered(), 0.93) << cell.procedure;
    EXPECT_LE(coverage.covered(), 0.97) << cell.procedure;
    EXPECT_LT(coverage.chi_squared(), 43.8) << cell.procedure;
  }
}

}  // namespace
}  // namespace asperity
