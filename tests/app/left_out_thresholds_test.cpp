// What the mean is that leaves out thresholds on one side of the presented levels, or on both.

#include "app/findings/methods/discrimination/thresholds/left_out_thresholds.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/methods/discrimination/thresholds/missing_threshold.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

/// Four estimates of 2 and these without a number.
std::vector<Finding> thresholds_with(const std::vector<WhyNoThreshold>& missing) {
  std::vector<Finding> findings(4 + missing.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    Finding& one = findings[i];
    one.analysis = kThresholds;
    one.quantity = "jnd";
    one.key = {"p" + std::to_string(i + 1), "all"};
    if (i < 4) {
      one.value = 2.0;
    } else {
      one.word = missing[i - 4].word;
      one.status = missing[i - 4].sentence.english();
    }
  }
  return findings;
}

DiscriminationResults results_with(const DiscriminationStudy& study,
                                   const std::vector<WhyNoThreshold>& missing) {
  DiscriminationResults results({}, study, false);
  results.conditions = {"all"};
  results.fit.thresholds = thresholds_with(missing);
  return results;
}

TEST(LeftOutThresholds, MakeTheMeanABoundOnlyIfAllAreOnOneSide) {
  const WhyNoThreshold below = threshold_below_levels();
  const WhyNoThreshold above = threshold_above_levels();
  const WhyNoThreshold unknown = quartiles_outside_levels();
  struct Case {
    std::vector<WhyNoThreshold> missing{};
    MeanOfThresholds mean = MeanOfThresholds::complete;
    const char* text = "";
  };
  const DiscriminationStudy study{};
  for (
      const Case& one :
      {Case{
           {below, slope_at_bound()},
           MeanOfThresholds::upper_bound,
           "2 below the presented levels; the mean of the others is an upper bound and has no CI."},
       Case{{above},
            MeanOfThresholds::lower_bound,
            "1 above the presented levels; the mean of the others is a lower bound and has no CI."},
       Case{{below, above, below},
            MeanOfThresholds::no_bound,
            "2 below the presented levels, 1 above the presented levels; the mean of the others is "
            "neither an upper nor a lower bound and is not reported."},
       Case{
           {below, unknown},
           MeanOfThresholds::no_bound,
           "1 below the presented levels, 1 not estimated (outside the presented levels); the mean "
           "of the others is neither an upper nor a lower bound and is not reported."}}) {
    const std::string all = std::to_string(4 + one.missing.size());
    const DiscriminationResults results = results_with(study, one.missing);
    EXPECT_EQ(left_out_thresholds(results.fit.thresholds, "jnd", "all").mean(), one.mean);
    EXPECT_EQ(with_left_out_thresholds(Phrase("Answer."), results, "jnd").english(),
              "Answer. Left out of " + all + " thresholds: " + one.text);
    EXPECT_EQ(bound_sentences(results.fit.thresholds, "jnd", "JND"),
              " Of the " + all + " JNDs, the mean does not include " + one.text);
  }
  EXPECT_EQ(bound_sentences(results_with(study, {}).fit.thresholds, "jnd", "JND"), "");
}

TEST(LeftOutThresholds, AreThoseOfOneCondition) {
  std::vector<Finding> thresholds = thresholds_with({threshold_below_levels()});
  thresholds[0].key = {"p1", "wood"};
  thresholds[4].key = {"p5", "wood"};
  EXPECT_EQ(left_out_thresholds(thresholds, "jnd", "wood").of, 2U);
  EXPECT_EQ(left_out_thresholds(thresholds, "jnd", "wood").below, 1U);
  EXPECT_EQ(left_out_thresholds(thresholds, "jnd", "all").missing(), 0U);
}

}  // namespace
}  // namespace asperity
