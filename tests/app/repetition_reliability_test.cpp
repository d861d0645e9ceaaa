// Reliability over repetitions of selections and of magnitudes, and over those that a plan numbers.

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const AnsweredQuestion* asked(const AnalysisOutcome& outcome) {
  return find_question(outcome, "reliability");
}

const Finding& reliability_in(const AnalysisOutcome& outcome, const std::string& quantity,
                              const std::string& key) {
  return finding_of(outcome, "reliability", quantity, key);
}

/// One response of a recognition that the plan numbers, without a factor for it.
MadeUpTrial recognised(int repetition, bool is_right) {
  MadeUpTrial trial{};
  trial.repetition = repetition;
  trial.surfaces = {surface_of("metal", "height_map", "metal")};
  trial.options = {"metal", "stone"};
  trial.answers = {trial.options[is_right ? 0 : 1]};
  trial.right = {"metal"};
  return trial;
}

// Proportions 0, ¼; ¼, ½; ½, ¾; ¾, 1: consistent, each repetition a quarter better.
TEST(ReliabilityOfPlannedRepetitions, IsAskedWithoutAFactorForThem) {
  const AnalysisOutcome outcome = analysed("recognition", "{}", {.number = 4}, [](int i) {
    std::vector<MadeUpTrial> trials{};
    for (const int repetition : {1, 2}) {
      for (int k = 0; k < 4; ++k) {
        trials.push_back(recognised(repetition, k < i + repetition - 1));
      }
    }
    return trials;
  });
  ASSERT_NE(asked(outcome), nullptr);
  EXPECT_NEAR(*reliability_in(outcome, "icc", "ICC3").value, 1.0, 1e-12);
  EXPECT_THAT(asked(outcome)->method.english(),
              StartsWith("Intraclass correlations of the participants' proportions correct in "));
}

// The second repetition has twice as many trials, and the same proportions.
TEST(ReliabilityOfPlannedRepetitions, IsOfProportionsWhereNumbersOfTrialsDiffer) {
  const AnalysisOutcome outcome = analysed("recognition", "{}", {.number = 4}, [](int i) {
    std::vector<MadeUpTrial> trials{};
    for (const int repetition : {1, 2}) {
      for (int k = 0; k < 4 * repetition; ++k) {
        trials.push_back(recognised(repetition, k < i * repetition));
      }
    }
    return trials;
  });
  EXPECT_NEAR(*reliability_in(outcome, "icc", "ICC2").value, 1.0, 1e-12);
}

// Trials of no column are not its repetitions.
TEST(ReliabilityOfPlannedRepetitions, IsNotAskedWhereOnlySomeTrialsHaveAColumn) {
  const AnalysisOutcome outcome = analysed("recognition", "{}", {.number = 4}, [](int i) {
    std::vector<MadeUpTrial> trials{};
    for (const int repetition : {1, 2}) {
      for (int k = 0; k < 4; ++k) {
        trials.push_back(recognised(repetition, k < i));
        if (repetition == 1) trials.back().factors_json = R"({"column": 1})";
      }
    }
    return trials;
  });
  EXPECT_EQ(asked(outcome), nullptr);
}

// Metal in the first repetition and stone in the second, for all participants: an effect of the texture would count as unreliability.
TEST(ReliabilityOfPlannedRepetitions, IsNotThatOfTextures) {
  const AnalysisOutcome outcome = analysed("recognition", "{}", {.number = 4}, [](int i) {
    std::vector<MadeUpTrial> trials{};
    for (const int repetition : {1, 2}) {
      for (int k = 0; k < 4; ++k) {
        trials.push_back(recognised(repetition, k < i));
        if (repetition == 1) continue;
        trials.back().surfaces = {surface_of("stone", "height_map", "stone")};
        trials.back().right = {"stone"};
      }
    }
    return trials;
  });
  EXPECT_EQ(asked(outcome), nullptr);
  EXPECT_EQ(reliability_in(outcome, "icc", "").word, "repetitions_are_textures");
  EXPECT_THAT(outcome.remarks, testing::Contains(testing::Property(
                                   &Phrase::english,
                                   HasSubstr("repetitions and textures cannot be distinguished"))));
}

MadeUpTrial selected(int repetition, const std::string& chosen) {
  MadeUpTrial trial{};
  trial.repetition = repetition;
  for (const std::string model : {"a", "b", "c"}) {
    trial.surfaces.push_back(surface_of(model, model, "wood"));
    trial.options.push_back(model);
  }
  trial.answers = {chosen};
  return trial;
}

std::vector<MadeUpTrial> steady_choices(int i) {
  std::vector<MadeUpTrial> trials{};
  for (const int repetition : {1, 2}) {
    for (int k = 0; k < 4; ++k) {
      trials.push_back(selected(repetition, k < i ? "a" : k % 2 == 0 ? "b" : "c"));
    }
  }
  return trials;
}

TEST(ReliabilityOfSelections, IsThatOfTheChoicesOfTheTarget) {
  const AnalysisOutcome outcome =
      analysed("selection", R"({"analysis": {"target": "a"}})", {.number = 4}, steady_choices);
  ASSERT_NE(asked(outcome), nullptr);
  EXPECT_NEAR(*reliability_in(outcome, "icc", "ICC2").value, 1.0, 1e-12);
  EXPECT_THAT(asked(outcome)->method.english(),
              HasSubstr("the participants' proportions of choices of a in each repetition"));
}

TEST(ReliabilityOfSelections, HasAStatusWithoutATarget) {
  const AnalysisOutcome outcome = analysed("selection", "{}", {.number = 4}, steady_choices);
  EXPECT_EQ(asked(outcome), nullptr);
  const Finding& none = reliability_in(outcome, "icc", "");
  EXPECT_FALSE(none.value);
  EXPECT_EQ(none.status, "the protocol declares no target");
}

/// Estimates of the first of three surfaces in repetitions from 1 on, as logarithms.
AnalysisOutcome estimated(int people, int repetitions,
                          const std::function<double(int, int, int)>& logarithm_of,
                          int surfaces = 3) {
  constexpr const char* kSource = R"({
    "estimation": {"spacing": "texture"},
    "factors": {"texture": {"levels": ["fine", "coarse", "coarser"]}},
    "textures": {"fine": {"spacing_m": 0.001}, "coarse": {"spacing_m": 0.002},
                 "coarser": {"spacing_m": 0.003}}})";
  return analysed("magnitude", kSource, {.number = people}, [&](int i) {
    std::vector<MadeUpTrial> trials{};
    for (int repetition = 1; repetition <= repetitions; ++repetition) {
      for (int surface = 0; surface < surfaces; ++surface) {
        constexpr std::array kThreeTextures{R"({"texture": "fine"})", R"({"texture": "coarse"})",
                                            R"({"texture": "coarser"})"};
        MadeUpTrial trial{};
        trial.repetition = repetition;
        trial.surfaces = {surface_of("s", "pd_gradient", "s")};
        trial.factors_json = kThreeTextures.at(static_cast<std::size_t>(surface));
        trial.answers = {text_of_number(std::pow(10.0, logarithm_of(i, surface, repetition)))};
        trials.push_back(trial);
      }
    }
    return trials;
  });
}

// Of p10 and p11 both repetitions order the surfaces alike, of p12 and p13 the other way round: correlations 1, 1,
// −1 and −1. Their scales, a decade apart, do not matter.
TEST(ReliabilityOfMagnitudes, IsTheMeanOfTheParticipantsOwn) {
  const AnalysisOutcome outcome = estimated(4, 2, [](int i, int surface, int repetition) {
    return i + 0.25 * (i < 2 || repetition == 1 ? surface : 2 - surface);
  });
  const Finding& mean = reliability_in(outcome, "icc.mean", "ICC3");
  EXPECT_NEAR(*mean.value, 0.0, 1e-9);
  EXPECT_EQ(mean.n, 4U);
  // t₃(.975)·SD/√4 with SD² = 4/3 exceeds 1, where the interval is cut.
  EXPECT_NEAR(mean.low.value(), -1.0, 1e-12);
  EXPECT_NEAR(mean.high.value(), 1.0, 1e-12);
  ASSERT_NE(asked(outcome), nullptr);
  EXPECT_EQ(asked(outcome)->answer.english(),
            "Within-participant reliability of one of the 2 repetitions: mean ICC(3,1) = .00, "
            "95 % CI [−1.00, 1.00]; N = 4 participants.");
}

// The second repetition is a fifth of a decade higher: consistent in logarithms alone.
TEST(ReliabilityOfMagnitudes, IsThatOfLogarithms) {
  const AnalysisOutcome outcome = estimated(
      2, 2, [](int i, int surface, int repetition) { return i + surface + 0.2 * repetition; });
  EXPECT_NEAR(*reliability_in(outcome, "icc.mean", "ICC3").value, 1.0, 1e-9);
}

// Correlations 1 and, with the surfaces alike on average, −1/2: the interval of three repetitions ends there.
TEST(ReliabilityOfMagnitudes, HasAnIntervalWithinWhatCorrelationsCanBe) {
  const AnalysisOutcome outcome = estimated(2, 3, [](int i, int surface, int repetition) {
    return i == 0 ? 0.1 * surface
                  : 0.1 * (surface == 0   ? repetition
                           : surface == 1 ? 4 - repetition
                                          : 2);
  });
  const Finding& mean = reliability_in(outcome, "icc.mean", "ICC3");
  EXPECT_NEAR(*mean.value, 0.25, 1e-9);
  EXPECT_EQ(mean.low.value(), -0.5);
  EXPECT_EQ(mean.high.value(), 1.0);
}

TEST(ReliabilityOfMagnitudes, LeavesOutWhoEstimatesNoDifference) {
  const AnalysisOutcome outcome = estimated(
      3, 2, [](int i, int surface, int /*repetition*/) { return i == 0 ? 1.0 : 0.1 * surface; });
  EXPECT_EQ(reliability_in(outcome, "icc.mean", "ICC3").n, 2U);
  EXPECT_NEAR(*reliability_in(outcome, "icc.mean", "ICC3").value, 1.0, 1e-9);
}

// F has one degree of freedom in its numerator.
TEST(ReliabilityOfMagnitudes, HasAStatusWithTwoSurfaces) {
  const auto logarithm_of = [](int i, int surface, int repetition) {
    return i + surface + 0.1 * surface * repetition;
  };
  const AnalysisOutcome outcome = estimated(4, 2, logarithm_of, 2);
  EXPECT_EQ(asked(outcome), nullptr);
  const Finding& none = reliability_in(outcome, "icc.mean", "");
  EXPECT_FALSE(none.value);
  EXPECT_EQ(none.word, "too_few_surfaces");
  EXPECT_EQ(none.status,
            "an intraclass correlation requires at least 3 surfaces with all repetitions, because "
            "that of 2 has almost no information: add surfaces");
  EXPECT_NE(asked(estimated(4, 2, logarithm_of)), nullptr) << "of three surfaces";
}

TEST(ReliabilityOfSelections, HasAStatusWithTwoParticipants) {
  const AnalysisOutcome outcome =
      analysed("selection", R"({"analysis": {"target": "a"}})", {.number = 2}, steady_choices);
  EXPECT_EQ(asked(outcome), nullptr);
  EXPECT_THAT(reliability_in(outcome, "icc", "").status,
              HasSubstr("at least 3 participants with all repetitions"));
}

}  // namespace
}  // namespace asperity
