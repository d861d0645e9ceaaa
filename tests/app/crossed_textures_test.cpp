// Participants and textures as crossed random intercepts, from the rows of a study.

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/study/analyze_study.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<std::string> kTextures{"brick", "metal", "stone", "wood"};
constexpr int kTrials = 3;  // of a participant with each texture

/// Of those trials, how many are hits.
using HitsOf = std::function<int(int participant, int texture)>;

/// Eight participants and four textures, where both differ.
int varied_hits(int participant, int texture) {
  static const std::string kHits = "13321123123311333333233231312113";
  return kHits[static_cast<std::size_t>(4 * participant + texture)] - '0';
}

MadeUpTrial recognised_picture(int texture, bool is_right) {
  MadeUpTrial trial{};
  const std::string& felt = kTextures.at(static_cast<std::size_t>(texture));
  trial.surfaces = {surface_of(felt, "height_map", felt)};
  trial.options = kTextures;
  trial.answers = {is_right ? felt : kTextures.at(static_cast<std::size_t>((texture + 1) % 4))};
  trial.right = {felt};
  return trial;
}

MadeUpTrial selected_model(int texture, bool is_target) {
  MadeUpTrial trial{};
  for (const std::string model : {"a", "b"}) {
    trial.surfaces.push_back(
        surface_of(model, model, kTextures.at(static_cast<std::size_t>(texture))));
    trial.options.push_back(model);
  }
  trial.answers = {is_target ? "a" : "b"};
  return trial;
}

using TrialOf = MadeUpTrial (*)(int texture, bool is_hit);

AnalysisOutcome outcome_of(const std::string& kind, TrialOf trial_of, int people, int textures,
                           const HitsOf& hits_of) {
  const auto trials_of = [&](int person) {
    std::vector<MadeUpTrial> trials{};
    for (int texture = 0; texture < textures; ++texture) {
      for (int k = 0; k < kTrials; ++k) {
        trials.push_back(trial_of(texture, k < hits_of(person, texture)));
      }
    }
    return trials;
  };
  return analysed(kind, R"({"analysis": {"target": "a"}})", {.number = people}, trials_of);
}

std::vector<Finding> of_family(const std::string& options, const HitsOf& hits_of) {
  std::string table = "subject,item,correct,trials\n";
  for (int i = 0; i < 8; ++i) {
    for (int texture = 0; texture < 4; ++texture) {
      table += std::to_string(i) + ',' + std::to_string(texture) + ',' +
               std::to_string(hits_of(i, texture)) + ',' + std::to_string(kTrials) + '\n';
    }
  }
  TidyInput input{};
  input.tables.emplace_back(table, "the table");
  input.options = FamilyOptions::of_json(options, "the options");
  return glmm_findings(input);
}

const Finding& found_in(const std::vector<Finding>& findings, const std::string& quantity,
                        const std::string& key) {
  for (const Finding& one : findings) {
    if (one.quantity == quantity && one.key == key) return one;
  }
  throw std::runtime_error("no finding " + quantity + " of " + key);
}

const AnsweredQuestion* asked_of_textures(const AnalysisOutcome& outcome) {
  return find_question(outcome, "glmm");
}

TEST(OtherTextures, HaveTheMixedModelOfTheCounts) {
  const AnalysisOutcome outcome = outcome_of("recognition", recognised_picture, 8, 4, varied_hits);
  const std::vector<Finding> family = of_family(R"({"chance": 0.25})", varied_hits);
  for (const auto& [quantity, key] :
       {std::pair("glmm.beta", "intercept"), std::pair("glmm.sigma", "subject"),
        std::pair("glmm.sigma", "item"), std::pair("glmm.t.p", "intercept"),
        std::pair("glmm.proportion", "")}) {
    EXPECT_EQ(found_in(outcome.findings, quantity, key).value,
              found_in(family, quantity, key).value)
        << quantity;
  }
  ASSERT_NE(asked_of_textures(outcome), nullptr);
  const std::string answer = asked_of_textures(outcome)->answer.english();
  EXPECT_THAT(answer, StartsWith("For a participant and a texture with random intercepts of 0, the "
                                 "proportion correct is estimated as "));
  EXPECT_THAT(answer, HasSubstr("compared with a chance level of 25 %: t("));
  EXPECT_THAT(answer, HasSubstr("(N = 4). This test is exploratory."));
}

// The maximum without intercepts of textures is that of both.
TEST(OtherTextures, ThatDoNotDifferHaveADeviationOfNothing) {
  const auto alike = [](int participant, int /*texture*/) { return participant % 4; };
  const AnalysisOutcome outcome = outcome_of("selection", selected_model, 8, 4, alike);
  const std::vector<Finding> family =
      of_family(R"({"chance": 0.5, "random": ["subject"], "likelihood": "quadrature"})", alike);
  EXPECT_EQ(found_in(outcome.findings, "glmm.sigma", "item").value, 0.0);
  EXPECT_EQ(found_in(outcome.findings, "glmm.sigma", "subject").value,
            found_in(family, "glmm.sigma", "subject").value);
  // Four textures remain a sample of four: 3 degrees of freedom, not those of eight participants.
  EXPECT_EQ(found_in(family, "glmm.t.df", "intercept").value, 7.0);
  EXPECT_EQ(found_in(outcome.findings, "glmm.t.df", "intercept").value, 3.0);
  EXPECT_GT(found_in(outcome.findings, "glmm.t.p", "intercept").value,
            found_in(family, "glmm.t.p", "intercept").value);
  ASSERT_NE(asked_of_textures(outcome), nullptr);
  EXPECT_THAT(asked_of_textures(outcome)->answer.english(),
              HasSubstr("the proportion of choices of a is estimated as "));
}

// Nine incorrect responses: three participants with one miss for each of three textures.
TEST(OtherTextures, AreNotAskedAboutNearTheCeiling) {
  const auto nearly_all = [](int participant, int texture) {
    return participant < 3 && texture < 3 ? kTrials - 1 : kTrials;
  };
  const AnalysisOutcome outcome = outcome_of("recognition", recognised_picture, 8, 4, nearly_all);
  EXPECT_EQ(asked_of_textures(outcome), nullptr);
  EXPECT_EQ(found_in(outcome.findings, "glmm.status", "").word, "near_ceiling");
}

TEST(OtherTextures, AreNotAskedAboutWithFewOrWithoutAMaximum) {
  const AnalysisOutcome few = outcome_of("recognition", recognised_picture, 4, 4, varied_hits);
  EXPECT_EQ(asked_of_textures(few), nullptr);
  EXPECT_EQ(found_in(few.findings, "glmm.status", "").status,
            "it needs at least 5 participants and 3 textures; participants: 4, textures: 4; add "
            "participants or textures");
  const AnalysisOutcome two = outcome_of("selection", selected_model, 8, 2, varied_hits);
  EXPECT_EQ(found_in(few.findings, "glmm.status", "").word, "too_few_participants");
  EXPECT_EQ(found_in(two.findings, "glmm.status", "").word, "too_few_textures");
  const AnalysisOutcome all =
      outcome_of("recognition", recognised_picture, 8, 4, [](int, int) { return kTrials; });
  EXPECT_EQ(asked_of_textures(all), nullptr);
  EXPECT_EQ(found_in(all.findings, "glmm.status", "").word, "no_maximum");
}

}  // namespace
}  // namespace asperity
