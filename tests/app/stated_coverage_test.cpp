// The coverage that notes state is that of docs/data/coverage.tsv.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/test_methods.h"
#include "app/findings/tidy/tidy_families.h"
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
  EXPECT_THAT(note,
              HasSubstr("at least " + smallest_coverage("choice_effects", "signflip.d", 0.0, 0.8) +
                        " with a true d of at most 0.8"));
  EXPECT_THAT(note,
              HasSubstr("at least " + smallest_coverage("choice_effects", "signflip.d", 0.8, 1e9) +
                        " with a larger one"));
  EXPECT_THAT(test_method("relabel.exact.p")->coverage.english(),
              HasSubstr(smallest_coverage("choice_effects", "relabel.W", 0.0, 1.0).substr(0, 2) +
                        " to 100 %"));
}

/// "up to 7 %": the greatest Type I error rate over the designs with these numbers of participants.
std::string greatest_size(const std::string& part, const std::string& quantity, double from,
                          double to) {
  double greatest = 0.0;
  for (const DrawnCount& count : coverage_counts(part, quantity)) {
    if (count.participants < from || count.participants > to) continue;
    greatest = std::max(greatest, 100.0 * count.failed / count.given);
  }
  return std::to_string(std::lround(greatest)) + " %";
}

/// How the family describes this number of three participants who rate two items twice.
std::string method_in(const char* family, const std::string& quantity, const char* score) {
  std::string rows = std::string("subject,item,") + score + "\n";
  for (const char* const row : {"a,x,1", "a,y,3", "a,x,2", "a,y,2", "b,x,2", "b,y,4", "b,x,3",
                                "b,y,5", "c,x,1", "c,y,2", "c,x,3", "c,y,4"}) {
    rows += std::string(row) + '\n';
  }
  TidyInput input{};
  input.tables.emplace_back(rows, "t.csv");
  const std::vector<std::pair<std::string, std::vector<std::string>>> fixed{{"item", {"x", "y"}}};
  input.options.set("fixed", fixed);
  input.options.set("items", std::vector<std::string>{"x", "y"});
  for (const Finding& finding : tidy_family(family).findings(input)) {
    if (finding.quantity == quantity) return finding.method;
  }
  return {};
}

TEST(StatedSize, OfMixedModelsOfRatingsIsTheGreatestOfTheSimulations) {
  EXPECT_THAT(method_in("lmm", "lmm.F.p", "y"),
              HasSubstr("up to " + greatest_size("continuous_scale", "lmm.F.p", 2.0, 20.0)));
  const std::string ordinal = method_in("ordinal", "lr.p", "score");
  EXPECT_THAT(ordinal,
              HasSubstr("up to " + greatest_size("ordered_categories", "lr.p", 3.0, 20.0)));
  EXPECT_THAT(ordinal, HasSubstr(greatest_size("ordered_categories", "lr.p", 2.0, 2.0) +
                                 " with 2 participants"));
}

}  // namespace
}  // namespace asperity
