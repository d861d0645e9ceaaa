// The coverage that notes state is that of docs/data/coverage.tsv.

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/test_methods.h"
#include "tests/app/coverage_counts.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

/// The smallest coverage over the settings whose true value has an absolute value from `from` to `to`, in whole per cent.
std::string smallest_coverage(const std::string& part, const std::string& quantity, double from,
                              double to) {
  double smallest = 1.0;
  for (const DrawnCount& count : coverage_counts(part, quantity)) {
    const double truth = std::abs(count.truth.value());
    // Of settings with the number in fewer than one table in twenty, the few that have it are unlike the others.
    if (truth < from || truth > to || count.given < 0.05 * count.tables) continue;
    smallest = std::min(smallest, 1.0 - count.failed / count.given);
  }
  return std::to_string(static_cast<int>(std::floor(100.0 * smallest))) + " %";
}

TEST(StatedCoverage, OfEffectSizesOfChoicesIsTheSmallestOfTheSimulations) {
  const std::string note = test_method("signflip.p.two")->coverage.english();
  EXPECT_THAT(note, HasSubstr("at least " +
                              smallest_coverage("choice_effects", "signflip.d", 0.0, 0.8) +
                              " with a true d of at most 0.8"));
  EXPECT_THAT(note, HasSubstr("at least " +
                              smallest_coverage("choice_effects", "signflip.d", 0.8, 1e9) +
                              " with a larger one"));
  EXPECT_THAT(test_method("relabel.exact.p")->coverage.english(),
              HasSubstr(smallest_coverage("choice_effects", "relabel.W", 0.0, 1.0).substr(0, 2) +
                        " to 100 %"));
}

}  // namespace
}  // namespace asperity
