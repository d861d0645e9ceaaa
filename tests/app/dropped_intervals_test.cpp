// Intervals that are withdrawn, with every finding that states their limits.

#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/methods/discrimination/sensitivity/sensitivity_bounds.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A number with an interval from 1 to 3, and its limits.
void add_number_and_limits(const std::string& quantity, const std::string& ending,
                           const std::string& key, FindingList& list) {
  list.number(quantity + ending, key, 2.0,
              {.method = "method", .interval = ConfidenceInterval{1.0, 3.0}, .confidence = 0.95});
  list.number(quantity + ".lower" + ending, key, 1.0);
  list.number(quantity + ".upper" + ending, key, 3.0);
}

std::vector<std::string> names_of(const std::vector<Finding>& findings) {
  std::vector<std::string> names{};
  for (const Finding& each : findings) names.push_back(each.quantity + ' ' + each.key.text());
  return names;
}

TEST(DroppedIntervals, LeaveNoFindingThatStatesALimit) {
  FindingList list{};
  add_number_and_limits("auc", "", "a", list);
  add_number_and_limits("auc", "", "b", list);
  add_number_and_limits("dprime.diff", ".loglinear", "a", list);
  std::vector<Finding> findings = list.take();
  drop_intervals(findings, [](const Finding& finding) -> std::optional<std::string> {
    if (finding.key != "a" || !finding.low) return std::nullopt;
    return "no interval";
  });
  EXPECT_THAT(names_of(findings), ElementsAre("auc a", "auc b", "auc.lower b", "auc.upper b",
                                              "dprime.diff.loglinear a"));
  EXPECT_FALSE(findings[0].low || findings[0].high || findings[0].confidence);
  EXPECT_EQ(findings[0].method, "method; no interval");
  EXPECT_EQ(findings[0].value, 2.0);
  EXPECT_EQ(findings[1].low, 1.0);
  EXPECT_EQ(findings[1].method, "method");
}

TEST(DroppedIntervals, OfMeansWhichAreBoundsHaveNoLimits) {
  const DiscriminationStudy study{};
  DiscriminationResults results({}, study, false);
  results.conditions = {"all"};
  FindingList list{};
  add_number_and_limits("dprime.mean", "", "all|0.5", list);
  add_number_and_limits("dprime.mean", "", "all|1", list);
  std::vector<Finding> findings = list.take();
  mark_bounds(results,
              {{{0, 0.5}, {.participants = 7}}, {{0, 1.0}, {.participants = 7, .at_ceiling = 2}}},
              findings);
  EXPECT_THAT(names_of(findings), ElementsAre("dprime.mean all|0.5", "dprime.mean.lower all|0.5",
                                              "dprime.mean.upper all|0.5", "dprime.mean all|1"));
  EXPECT_FALSE(findings.back().low);
  EXPECT_THAT(findings.back().method, HasSubstr("a lower bound without an interval: d′ of 2 of 7"));
}

}  // namespace
}  // namespace asperity
