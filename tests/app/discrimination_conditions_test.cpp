// The conditions and the tasks of discriminations: what is estimated separately, and what is compared.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/psychometric_function.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/study_analysis.h"
#include "app/findings/outcome/study_test.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

/// Two participants, with the choices of two blocks.
AnalysisOutcome outcome_of_two_blocks(const json& protocol, const std::vector<MadeUpChoice>& only,
                                      std::vector<MadeUpChoice> other) {
  for (MadeUpChoice& choice : other) choice.block = "other";
  return outcome_of_choices(protocol, {.number = 2, .first = 1}, [&](int) {
    std::vector<MadeUpTrial> trials = trials_of(only);
    for (const MadeUpTrial& trial : trials_of(other)) trials.push_back(trial);
    return trials;
  });
}

json protocol_with_two_blocks(const std::string& judgement) {
  json protocol = discrimination_protocol(judgement);
  protocol["blocks"]["other"] = protocol["blocks"]["only"];
  return protocol;
}

TEST(Discrimination, TestsWhetherThresholdsDifferBetweenConditions) {
  const auto outcome_with = [](const std::vector<std::string>& textures) {
    const json protocol = discrimination_protocol("performance");
    return outcome_of_choices(protocol, {.number = 8}, [&](int person) {
      std::vector<MadeUpTrial> trials{};
      for (std::size_t i = 0; i < textures.size(); ++i) {
        PsychometricFunction function = kPerformer;
        function.alpha = i == 0 ? 5e-6 : 14e-6;
        MadeUpObserver observer(function,
                                static_cast<unsigned>(10 * person) + static_cast<unsigned>(i));
        std::vector<MadeUpChoice> choices = observer.choices(kAbove_m, 40, true);
        for (MadeUpChoice& choice : choices) choice.texture = textures[i];
        for (const MadeUpTrial& trial : trials_of(choices)) trials.push_back(trial);
      }
      return trials;
    });
  };
  const AnalysisOutcome two = outcome_with({"metal", "wood"});
  EXPECT_THAT(sentence_about(two, "conditions", "JND"),
              HasSubstr("The JND was significantly different between the conditions: Wilcoxon"));
  EXPECT_THAT(answer_to(two, "conditions"), HasSubstr("metal: "));
  EXPECT_THAT(answer_to(two, "conditions"), HasSubstr("wood: "));
  const std::vector<Finding> means = part_of(two, "mean_thresholds");
  const FoundNumbers found(means);
  EXPECT_LT(*found.value("mean.jnd", "metal"), *found.value("mean.jnd", "wood"));
  for (const Finding& finding : two.findings) {
    EXPECT_FALSE(finding.quantity.starts_with("friedman.")) << "a pair has one test";
  }
  std::vector<double> logs{};
  const std::vector<Finding> thresholds = part_of(two, "thresholds");
  const FoundNumbers own(thresholds);
  for (const Finding* const metal : own.all("jnd")) {
    if (metal->key.last() != "metal") continue;
    const std::string label = metal->key[0];
    logs.push_back(std::log(*own.value("jnd", label + "|wood") / *metal->value));
  }
  ASSERT_EQ(logs.size(), 8U);
  double mean = 0.0;
  for (const double one : logs) mean += one / 8.0;
  double squares = 0.0;
  for (const double one : logs) squares += (one - mean) * (one - mean);
  const double half = 2.3646242515927844 * std::sqrt(squares / 7.0 / 8.0);  // t of 7 df, 97.5 %
  const std::vector<Finding> compared = part_of(two, "compared_thresholds");
  const Finding* const ratio = FoundNumbers(compared).find("ratio.jnd", "wood|metal");
  ASSERT_TRUE(ratio != nullptr && ratio->low) << "no threshold is left out";
  EXPECT_NEAR(*ratio->low, std::exp(mean - half), 1e-9);
  EXPECT_NEAR(*ratio->high, std::exp(mean + half), 1e-9);
  const AnalysisOutcome three = outcome_with({"metal", "stone", "wood"});
  EXPECT_THAT(sentence_about(three, "conditions", "JND"), HasSubstr("Friedman test"));
  EXPECT_THAT(find_analysis("discrimination")->estimates(three).text, HasSubstr("stone, JND "));
}

// The third of six participants is always correct on wood, and therefore has no threshold there.
TEST(Discrimination, ComparesConditionsOverTheParticipantsWhoHaveAll) {
  PsychometricFunction always = kPerformer;
  always.gamma = 1.0;
  always.lambda = 0.0;
  const AnalysisOutcome outcome =
      outcome_of_choices(discrimination_protocol("performance"), {.number = 6}, [&](int person) {
        std::vector<MadeUpTrial> trials{};
        for (const char* const texture : {"metal", "wood"}) {
          PsychometricFunction function = kPerformer;
          function.alpha = std::string(texture) == "metal" ? 6e-6 : 12e-6;
          if (person == 2 && std::string(texture) == "wood") function = always;
          std::vector<MadeUpChoice> choices =
              MadeUpObserver(function, static_cast<unsigned>(20 + person))
                  .choices(kAbove_m, 60, true);
          for (MadeUpChoice& choice : choices) choice.texture = texture;
          for (const MadeUpTrial& trial : trials_of(choices)) trials.push_back(trial);
        }
        return trials;
      });
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers own(thresholds);
  double log_of_ratio = 0.0;
  double log_of_wood = 0.0;
  std::size_t complete = 0;
  for (const Finding* const metal : own.all("jnd")) {
    if (metal->key.last() != "metal") continue;
    const std::string label = metal->key[0];
    const auto wood = own.value("jnd", label + "|wood");
    if (!wood || !metal->value) continue;
    log_of_ratio += std::log(*wood / *metal->value) / 5.0;
    log_of_wood += std::log(*wood) / 5.0;
    ++complete;
  }
  ASSERT_EQ(complete, 5U);
  const std::vector<Finding> compared = part_of(outcome, "compared_thresholds");
  const FoundNumbers found(compared);
  const Finding* const ratio = found.find("ratio.jnd", "wood|metal");
  ASSERT_NE(ratio, nullptr);
  EXPECT_EQ(ratio->n, 5U);
  EXPECT_NEAR(*ratio->value, std::exp(log_of_ratio), 1e-9);
  EXPECT_FALSE(ratio->low) << "an interval would describe the other five";
  EXPECT_THAT(ratio->method, HasSubstr("without an interval: 1 of those with trials in both"));
  const Finding* const wood = found.find("geomean.jnd", "wood");
  ASSERT_NE(wood, nullptr);
  EXPECT_EQ(wood->n, 5U);
  EXPECT_NEAR(*wood->value, std::exp(log_of_wood), 1e-12);
  EXPECT_FALSE(wood->low);
  const std::string answer = answer_to(outcome, "conditions");
  EXPECT_THAT(answer, HasSubstr("geometric mean thresholds of 5 participants: metal: "));
  EXPECT_THAT(answer, HasSubstr("ratio wood / metal: "));
  EXPECT_THAT(answer, HasSubstr("Left out: 1 of 6 participants"));
  EXPECT_THAT(answer, HasSubstr("The ratio therefore has no CI"));
  EXPECT_THAT(find_analysis("discrimination")->estimates(outcome).text,
              HasSubstr("The ratio of the JNDs (wood / metal) was "));
}

// The ratio is that of the JNDs: it is no effect of the test of the points of subjective equality.
TEST(Discrimination, StatesTheRatioOfThresholdsOfTheirTestAlone) {
  json protocol = discrimination_protocol("comparison");
  protocol["analysis"]["family"] = {"conditions"};
  MadeUpStudy made;
  add_participants(made, made.add_protocol("compared", "discrimination", protocol.dump()),
                   {.number = 6}, [](int person) {
                     std::vector<MadeUpTrial> trials{};
                     for (const char* const texture : {"metal", "wood"}) {
                       MadeUpObserver observer(kComparer, static_cast<unsigned>(20 + person));
                       for (MadeUpChoice& choice : observer.choices(kAround_m, 40, false)) {
                         choice.texture = texture;
                         trials.push_back(discriminated(choice));
                       }
                     }
                     return trials;
                   });
  std::map<std::string, bool> states_effect{};
  for (const StudyTest& test :
       find_analysis("discrimination")->test_family(gather_answers(made.study(), {}, {}).front())) {
    states_effect[test.about.text()] = test.in_units.has_value();
  }
  EXPECT_EQ(states_effect, (std::map<std::string, bool>{{"JND", true}, {"PSE", false}}));
}

// As strings "0.01" comes before "9e-04".
TEST(Discrimination, NamesConditionsThatAreNumbersByTheirFactor) {
  const auto trials_of_person = [](int person) {
    std::vector<MadeUpTrial> trials{};
    for (const double wavelength_m : {0.01, 0.0009}) {
      MadeUpObserver observer(kPerformer, static_cast<unsigned>(person));
      for (MadeUpTrial& trial : trials_of(observer.choices(kAbove_m, 40, true))) {
        json factors = json::parse(trial.factors_json);
        factors["wavelength_m"] = wavelength_m;
        trial.factors_json = factors.dump();
        trials.push_back(std::move(trial));
      }
    }
    return trials;
  };
  const AnalysisOutcome outcome =
      outcome_of_choices(discrimination_protocol("performance"), {.number = 3}, trials_of_person);
  const std::string answer = answer_to(outcome, "conditions");
  EXPECT_THAT(answer, HasSubstr("wavelength 900 µm: "));
  EXPECT_LT(answer.find("wavelength 900 µm"), answer.find("wavelength 10 mm"));
  EXPECT_THAT(find_analysis("discrimination")->estimates(outcome).text,
              HasSubstr("wavelength 10 mm, JND "));
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  EXPECT_NE(FoundNumbers(means).find("mean.jnd", "wavelength_m 9e-04"), nullptr);
}

TEST(Discrimination, StatesThatNoParticipantHasAllConditions) {
  const auto trials_of_person = [](int person) {
    std::vector<MadeUpChoice> choices =
        MadeUpObserver(kPerformer, static_cast<unsigned>(person)).choices(kAbove_m, 40, true);
    for (MadeUpChoice& choice : choices) choice.texture = person % 2 == 0 ? "metal" : "wood";
    return trials_of(choices);
  };
  const AnalysisOutcome outcome =
      outcome_of_choices(discrimination_protocol("performance"), {.number = 6}, trials_of_person);
  EXPECT_THAT(sentence_about(outcome, "conditions", "JND"),
              HasSubstr("no participant has trials in every condition"));
  EXPECT_THAT(answer_to(outcome, "conditions"),
              HasSubstr("no participant has trials in every condition"));
}

TEST(Discrimination, DoesNotDivideTheTrialsByFactorsThatAreDrawn) {
  for (const bool is_drawn : {false, true}) {
    json protocol = discrimination_protocol("performance");
    if (is_drawn) protocol["blocks"]["only"]["drawn"] = {"texture"};
    MadeUpStudy made;
    const std::int64_t id = made.add_protocol("jnd", "discrimination", protocol.dump());
    made.add_person("p1", "");
    std::vector<MadeUpChoice> choices = MadeUpObserver(kPerformer, 5).choices(kAbove_m, 40, true);
    for (std::size_t i = 0; i < choices.size(); ++i) {
      choices[i].texture = i % 4 < 2 ? "metal" : "wood";
    }
    made.add_session("p1", id, trials_of(choices));
    const AnalysisOutcome outcome = outcome_of_discrimination(made);
    const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
    EXPECT_EQ(FoundNumbers(thresholds).find("jnd", "p1|all") != nullptr, is_drawn);
    const std::map<std::string, std::string> wide = wide_rows(made).at(0);
    EXPECT_EQ(wide.contains("jnd_which_jnd"), is_drawn);
    EXPECT_EQ(wide.contains("jnd_which_metal_jnd"), !is_drawn);
  }
}

TEST(Discrimination, MakesBlocksOfTheSameTaskConditions) {
  json protocol = protocol_with_two_blocks("performance");
  protocol["stimuli"]["fine"] = protocol["stimuli"]["grating"];
  for (json& surface : protocol["blocks"]["other"]["presented"]) surface["stimulus"] = "fine";
  // How the levels are stated does not matter.
  protocol["blocks"]["other"]["vary"].erase("levels");
  protocol["blocks"]["other"]["vary"]["levels_percent"] = json::array();
  PsychometricFunction worse = kPerformer;
  worse.alpha = 16e-6;
  const AnalysisOutcome outcome =
      outcome_of_two_blocks(protocol, MadeUpObserver(kPerformer, 5).choices(kAbove_m, 80, true),
                            MadeUpObserver(worse, 6).choices(kAbove_m, 80, true));
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  EXPECT_FALSE(found.find("jnd", "p1|all"));
  EXPECT_NEAR(*found.value("jnd", "p1|only"), kPerformer.inverse(0.75), 3e-6);
  EXPECT_NEAR(*found.value("jnd", "p1|other"), worse.inverse(0.75), 5e-6);
  EXPECT_NE(answer_to(outcome, "threshold"), "") << "it is one task";
  EXPECT_THAT(answer_to(outcome, "conditions"), HasSubstr("other: "));
}

TEST(Discrimination, SeparatesTasksByTheirQuestion) {
  for (const char* const key : {"name", "prompt"}) {
    json protocol = protocol_with_two_blocks("performance");
    protocol["blocks"]["other"]["question"][key] = "Which is harder?";
    const std::vector<MadeUpChoice> choices =
        MadeUpObserver(kPerformer, 5).choices(kAbove_m, 40, true);
    const AnalysisOutcome outcome = outcome_of_two_blocks(protocol, choices, choices);
    EXPECT_NE(answer_to(outcome, "threshold:only"), "") << key;
    EXPECT_NE(answer_to(outcome, "threshold:other"), "") << key;
  }
}

TEST(Discrimination, AnswersWithTheTestsOfTheTaskOnly) {
  json protocol = protocol_with_two_blocks("comparison");
  protocol["blocks"]["only_harder"] = protocol["blocks"]["other"];
  protocol["blocks"].erase("other");
  protocol["blocks"]["only_harder"]["question"]["prompt"] = "Which is smoother?";
  const AnalysisOutcome outcome = outcome_of_choices(protocol, {.number = 6}, [](int person) {
    const auto seed = static_cast<unsigned>(person);
    std::vector<MadeUpChoice> choices =
        MadeUpObserver(kComparer, 10 + seed).choices(kAround_m, 40, false);
    for (MadeUpChoice choice : MadeUpObserver(kComparer, 30 + seed).choices(kAround_m, 40, false)) {
      choice.block = "only_harder";
      choice.chose_comparison = !choice.chose_comparison;
      choices.push_back(choice);
    }
    return trials_of(choices);
  });
  EXPECT_THAT(answer_to(outcome, "point_of_subjective_equality:only"),
              Not(HasSubstr("only_harder")));
  EXPECT_THAT(answer_to(outcome, "point_of_subjective_equality:only_harder"),
              HasSubstr("(only_harder)"));
  const std::string note = table_of(outcome, "psychometric").note.english();
  EXPECT_THAT(note, HasSubstr("only: Hits are choices of the comparison."));
  EXPECT_THAT(note, HasSubstr("only_harder: Hits are choices of the standard"));
}

TEST(Discrimination, StatesReasonsInTheWordsOfTheJudgement) {
  MadeUpStudy made;
  const std::int64_t protocol =
      made.add_protocol("compared", "discrimination", discrimination_protocol("comparison").dump());
  PsychometricFunction always = kComparer;
  always.gamma = 1.0;
  always.lambda = 0.0;
  PsychometricFunction never = kComparer;
  never.gamma = 0.0;
  never.lambda = 1.0;
  PsychometricFunction high = kComparer;
  high.alpha = 70e-6;
  PsychometricFunction steep = kComparer;
  steep.gamma = steep.lambda = 0.0;
  steep.beta = 1e9;
  for (const auto& [label, function] :
       {std::pair{"always", always}, std::pair{"high", high}, std::pair{"never", never},
        std::pair{"steep", steep}, std::pair{"usual", kComparer}}) {
    made.add_person(label, "");
    made.add_session(label, protocol,
                     trials_of(MadeUpObserver(function, 3).choices(kAround_m, 60, false)));
  }
  const AnalysisOutcome outcome = outcome_of_discrimination(made);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  for (const auto& [key, quantity, word] : {std::tuple{"always|all", "pse", "below_levels"},
                                            std::tuple{"high|all", "pse", "outside_levels"},
                                            std::tuple{"high|all", "slope", "outside_levels"},
                                            std::tuple{"never|all", "pse", "above_levels"},
                                            std::tuple{"never|all", "slope", "above_levels"},
                                            std::tuple{"steep|all", "jnd", "slope_at_bound"},
                                            std::tuple{"steep|all", "slope", "slope_at_bound"}}) {
    const Finding* const finding = found.find(composed_quantity(quantity), key);
    ASSERT_NE(finding, nullptr) << key << quantity;
    EXPECT_FALSE(finding->value) << key << quantity;
    EXPECT_EQ(finding->word, word) << key << quantity;
    EXPECT_THAT(finding->status, Not(HasSubstr("correct"))) << key << quantity;
    EXPECT_THAT(finding->status, Not(HasSubstr("differences"))) << key << quantity;
  }
  EXPECT_TRUE(found.value("slope", "usual|all"));
}

TEST(Discrimination, SeparatesBlocksThatVaryDifferentParameters) {
  json protocol = protocol_with_two_blocks("performance");
  protocol["blocks"]["other"]["question"]["judgement"] = "comparison";
  const AnalysisOutcome outcome =
      outcome_of_two_blocks(protocol, MadeUpObserver(kPerformer, 5).choices(kAbove_m, 40, true),
                            MadeUpObserver(kComparer, 6).choices(kAround_m, 40, false));
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  EXPECT_TRUE(found.value("jnd", "p1|only"));
  EXPECT_TRUE(found.value("pse", "p1|other"));
  EXPECT_FALSE(found.find("pse", "p1|only"));
  EXPECT_NE(answer_to(outcome, "threshold:only"), "");
  EXPECT_NE(answer_to(outcome, "point_of_subjective_equality:other"), "");
}

}  // namespace
}  // namespace asperity
