// What a paper states about the agreement, reliability and dimensions of ratings.

#include "app/findings/methods/rating/rating_sentences.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/display_number.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kSevenPointScale = R"("scale": {"minimum": 1, "maximum": 7, "points": 7})";

/// Four participants rate five items twice; the second scale and the construct on request.
AnalysisOutcome study_with_ratings(bool with_second_scale) {
  const std::string second =
      std::string(R"(, {"name": "coarse", "prompt": "How coarse?", )") + kSevenPointScale + "}";
  const std::string construct =
      R"(, "analysis": {"constructs": {"coarseness": {"scales": ["rough", "coarse"]}}})";
  const std::string source =
      std::string(
          R"({"kind": "rating", "blocks": {"only": {"questions": [{"name": "rough", "prompt": "How rough?", )") +
      kSevenPointScale + "}" + (with_second_scale ? second : "") + "]}}" +
      (with_second_scale ? construct : "") + "}";
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("made", "rating", source);
  for (int person = 0; person < 4; ++person) {
    std::vector<MadeUpTrial> trials{};
    for (int repetition = 1; repetition <= 2; ++repetition) {
      for (int item = 0; item < 5; ++item) {
        MadeUpTrial trial{};
        const std::string name(1, static_cast<char>('a' + item));
        trial.surfaces = {surface_of(name, "height_map", name)};
        trial.questions = {"rough"};
        trial.answers = {std::to_string(1 + item + (person * repetition + item) % 3)};
        if (with_second_scale) {
          trial.questions.push_back("coarse");
          trial.answers.push_back(std::to_string(1 + item + (person + repetition) % 2));
        }
        trial.repetition = repetition;
        trials.push_back(trial);
      }
    }
    const std::string label = "p" + std::to_string(person + 1);
    made.add_person(label, "");
    made.add_session(label, protocol, trials);
  }
  return analyze_study(made.study(), std::nullopt, {}).at(0);
}

std::string with_interval_text(const Finding& one) {
  return "= " + display_bounded(one.value.value()) + ", 95 % CI [" +
         display_bounded(one.low.value()) + ", " + display_bounded(one.high.value()) + "]";
}

TEST(RatingSentences, StateAgreementReliabilityAndComponents) {
  const AnalysisOutcome outcome = study_with_ratings(true);
  const FoundNumbers found(outcome.findings);
  const std::string text = rating_estimates_sentence(outcome).text;
  EXPECT_THAT(
      text,
      HasSubstr("Agreement of the participants: on the scale “rough”, ICC(2,1) " +
                with_interval_text(*found.find("icc", "rough|ICC2")) + ", and ICC(3,k) " +
                with_interval_text(*found.find("icc", "rough|ICC3k")) + "; “coarse”, ICC(2,1) "));
  EXPECT_THAT(text, HasSubstr("Reliability over repetitions: on the scale “rough”, mean ICC(3,1) " +
                              with_interval_text(*found.find("icc.mean", "rough|ICC3")) +
                              ", N = 4; “coarse”"));
  EXPECT_THAT(text,
              HasSubstr("For the construct “coarseness”, Cronbach’s α " +
                        with_interval_text(*found.find("cronbach.alpha", "coarseness")) + '.'));
  EXPECT_THAT(text, Not(HasSubstr("α is negative")));
  AnalysisOutcome opposite = outcome;
  for (Finding& finding : opposite.findings) {
    if (finding.quantity == "cronbach.alpha") finding.value = -0.4;
  }
  EXPECT_THAT(rating_estimates_sentence(opposite).text,
              HasSubstr("]. α is negative because the answers on its scales covary negatively"));
  EXPECT_THAT(text, HasSubstr("The first principal component had " +
                              display_percent(found.value("proportion", "C1").value()) +
                              " of the variance"));
  EXPECT_THAT(text, Not(HasSubstr("without the participants’ deviations")))
      << "four participants are too few";
  EXPECT_THAT(rating_methods_text(outcome), HasSubstr("[Shrout 1979]"));
  EXPECT_THAT(rating_methods_text(outcome), HasSubstr("[Horn 1965]"));
}

TEST(RatingSentences, StateOnlyWhatWasAnalysed) {
  const AnalysisOutcome outcome = study_with_ratings(false);
  const std::string text = rating_estimates_sentence(outcome).text + rating_methods_text(outcome);
  EXPECT_THAT(text, HasSubstr("ICC(2,1)"));
  for (const char* const absent : {"Cronbach", "component", "coarse"}) {
    EXPECT_THAT(text, Not(HasSubstr(absent)));
  }
  EXPECT_EQ(rating_estimates_sentence(AnalysisOutcome{}).text, "");
}

}  // namespace
}  // namespace asperity
