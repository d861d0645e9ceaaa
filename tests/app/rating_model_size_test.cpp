// The Type I error rates that stand next to the p values of the mixed models of ratings are those of the simulations.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "app/findings/study/study_tests.h"
#include "tests/app/analysed_study.h"
#include "tests/app/coverage_counts.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The greatest Type I error rate in percent over the designs of a part of docs/data/coverage.tsv. An interval of an effect that is 0 has that of
/// the test that it inverts: the proportion of tables in which it does not contain 0.
class SimulatedSize {
 public:
  SimulatedSize(const std::string& part, const std::string& quantity) {
    for (const DrawnCount& count : coverage_counts(part, quantity)) {
      if (count.effect != 0.0) continue;
      double& greatest = count.participants == 2.0 ? of_two_ : of_more_;
      greatest = std::max(greatest, 100.0 * count.failed / count.given);
    }
  }
  /// "up to 7 %"
  std::string of_two() const { return words_of(of_two_); }
  std::string of_more() const { return words_of(of_more_); }
  std::string of_all() const { return words_of(std::max(of_two_, of_more_)); }

 private:
  static std::string words_of(double percent) {
    return "up to " + std::to_string(std::lround(percent)) + " %";
  }
  double of_two_ = 0.0;
  double of_more_ = 0.0;
};

/// Four participants rate two items on this scale.
AnalysisOutcome ratings_on(const std::string& scale) {
  std::vector<std::vector<MadeUpTrial>> people{};
  for (const auto& [wood, stone] : {std::pair{1, 3}, {3, 2}, {2, 4}, {4, 7}}) {
    std::vector<MadeUpTrial>& trials = people.emplace_back();
    for (const auto& [item, rating] : {std::pair{"wood", wood}, {"stone", stone}}) {
      MadeUpTrial& trial = trials.emplace_back();
      trial.surfaces = {surface_of(item, "height_map", item)};
      trial.questions = {"rough"};
      trial.answers = {std::to_string(rating)};
    }
  }
  return analysed("rating",
                  R"({"kind": "rating", "blocks": {"only": {"question":
          {"name": "rough", "prompt": "How rough?", "scale": )" +
                      scale + "}}}}",
                  {.first = 1}, people);
}

std::string note_below(const AnalysisOutcome& outcome, const std::string& name) {
  return table_of(outcome, name).note.english();
}

constexpr const char* kLinearTest = "The F test of the linear mixed model";
constexpr const char* kOrdinalTest = "The likelihood-ratio test of the cumulative link mixed model";

TEST(RatingModel, StatesTheSizeOfItsTestsOnAContinuousScale) {
  const AnalysisOutcome outcome = ratings_on(R"({"minimum": 0, "maximum": 10})");
  EXPECT_THAT(note_below(outcome, "mixed_model"),
              HasSubstr("neither items nor participants differed the Type I error rate at "
                        "α = .05 was " +
                        SimulatedSize("continuous_scale", "lmm.beta").of_all() + '.'));
  const std::string tests = note_below(outcome, StudyTests::kTable);
  EXPECT_THAT(tests, HasSubstr(std::string(kLinearTest) +
                               " is slightly liberal: in simulations without differences, its "
                               "Type I error rate at α = .05 was " +
                               SimulatedSize("continuous_scale", "lmm.F.p").of_all() + '.'));
  EXPECT_THAT(tests, Not(HasSubstr(kOrdinalTest)));
}

TEST(RatingModel, StatesTheSizeOfItsTestsOnOrderedCategories) {
  const AnalysisOutcome outcome = ratings_on(R"({"minimum": 1, "maximum": 7, "points": 7})");
  EXPECT_THAT(note_below(outcome, "ordinal"),
              HasSubstr("without differences the Type I error rate at α = .05 was " +
                        SimulatedSize("ordered_categories", "wald.p").of_all() + '.'));
  const SimulatedSize ratio("ordered_categories", "lr.p");
  const std::string tests = note_below(outcome, StudyTests::kTable);
  EXPECT_THAT(tests,
              HasSubstr(std::string(kOrdinalTest) +
                        " is slightly liberal: in simulations without differences, its "
                        "Type I error rate at α = .05 was " +
                        ratio.of_more() + ", and " + ratio.of_two() + " with two participants."));
  EXPECT_THAT(tests, Not(HasSubstr(kLinearTest)));
}

}  // namespace
}  // namespace asperity
