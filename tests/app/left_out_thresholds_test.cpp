// The bias of means that leave out thresholds on one side of the presented levels, or on both.

#include "app/findings/study/left_out_thresholds.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/missing_threshold.h"

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
    one.key = "p" + std::to_string(i + 1) + "|all";
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

TEST(LeftOutThresholds, BiasAMeanInOneDirectionOnlyIfTheyAreOnOneSide) {
  const WhyNoThreshold below = threshold_below_levels();
  const WhyNoThreshold above = threshold_above_levels();
  struct Case {
    std::vector<WhyNoThreshold> missing{};
    const char* bias = "";
  };
  const DiscriminationStudy study{};
  for (const Case& one :
       {Case{{below, below},
             "2 below the presented levels; a mean without such thresholds is too high."},
        Case{{above}, "1 above the presented levels; a mean without such thresholds is too low."},
        Case{{below, above, below},
             "2 below and 1 above the presented levels; the direction of the bias of a mean "
             "without such thresholds is unknown."}}) {
    const std::string all = std::to_string(4 + one.missing.size());
    const DiscriminationResults results = results_with(study, one.missing);
    EXPECT_EQ(with_left_out_thresholds(Phrase("Answer."), results).english(),
              "Answer. Left out of " + all + " thresholds: " + one.bias);
    EXPECT_THAT(with_left_out_means(Phrase("Note."), {results}).english(),
                HasSubstr(": left out of " + all + " thresholds: " + one.bias));
    EXPECT_EQ(bias_sentence(results.fit.thresholds, "jnd", "JND"),
              " Of the " + all + " JNDs, the mean does not include " + one.bias);
  }
}

TEST(LeftOutThresholds, AreCountedOverAllTasks) {
  const DiscriminationStudy study{};
  const std::vector<DiscriminationResults> all{results_with(study, {threshold_below_levels()}),
                                               results_with(study, {threshold_above_levels()})};
  EXPECT_THAT(with_left_out_means({}, all).english(),
              HasSubstr("left out of 10 thresholds: 1 below and 1 above the presented levels"));
}

}  // namespace
}  // namespace asperity
