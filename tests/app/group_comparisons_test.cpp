// Groups are compared in thresholds, exponents and ratings, and in profiles of ratings, choices and dissimilarities.

#include "app/findings/shared/group_comparisons.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/tail_probabilities.h"
#include "analysis/psychometric/psychometric_function.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "protocols/plan/permuted_blocks.h"
#include "tests/app/analysed_study.h"
#include "tests/app/made_up_choices.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int kPeople = 8;  // the first half haptic, the other visual

std::string group_of(int person) { return person < kPeople / 2 ? "haptic" : "visual"; }

AnalysisOutcome outcome_of_groups(json protocol,
                                  const std::function<std::vector<MadeUpTrial>(int)>& trials_of) {
  protocol["groups"] = {{"factor", "training"}};
  protocol["factors"]["training"]["levels"] = {"haptic", "visual"};
  MadeUpStudy made{};
  const std::int64_t stored =
      made.add_protocol("grouped", protocol.at("kind").get<std::string>(), protocol.dump());
  for (int person = 0; person < kPeople; ++person) {
    const std::string label = "p" + std::to_string(10 + person);
    made.add_person(label, "");
    made.set_group(group_of(person));
    std::vector<MadeUpTrial> trials = trials_of(person);
    for (MadeUpTrial& trial : trials) {
      json factors = json::parse(trial.factors_json);
      factors["training"] = group_of(person);
      trial.factors_json = factors.dump();
    }
    made.add_session(label, stored, trials);
  }
  return analyze_study(made.study()).front();
}

// --- ratings -----------------------------------------------------------------------------------------

json rating_protocol(const std::vector<std::string>& scales) {
  json protocol = json::parse(R"({"kind": "rating", "blocks": {"only": {"questions": []}}})");
  for (const std::string& scale : scales) {
    protocol["blocks"]["only"]["questions"].push_back(
        {{"name", scale},
         {"prompt", "How " + scale + "?"},
         {"scale", {{"minimum", 1}, {"maximum", 7}, {"points", 7}}}});
  }
  protocol["analysis"]["family"] = {"groups", "group_profiles"};
  return protocol;
}

MadeUpTrial rated(const std::string& item, int rough) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of(item, "height_map", item)};
  trial.questions = {"rough"};
  trial.answers = {std::to_string(rough)};
  return trial;
}

/// Wood and metal of each participant: as in ProfileComparison.IsTheProportionOfTheSquaresBetweenTheGroups.
constexpr std::array<std::array<int, 2>, kPeople> kOpposite{
    {{7, 1}, {6, 2}, {7, 2}, {6, 1}, {1, 7}, {2, 6}, {2, 7}, {1, 6}}};

TEST(GroupComparisons, TellLevelFromFormOfRatings) {
  const AnalysisOutcome outcome = outcome_of_groups(rating_protocol({"rough"}), [](int person) {
    const auto& own = kOpposite[static_cast<std::size_t>(person)];
    return std::vector{rated("wood", own[0]), rated("metal", own[1])};
  });
  // Both groups rate 4 on average.
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.mean", "haptic").value, 4.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.shift").value, 0.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.perm.p.two").value, 1.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.r2").value, 100.0 / 102.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.perm.p").value, 2.0 / 70.0, 1e-12);
  EXPECT_THAT(question_of(outcome, "group_profiles").method.english(),
              HasSubstr("R² is .14 on average"));
  // Wood: 2.5 above a participant's mean in one group, 2.5 below it in the other.
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.diff", "wood").value, 5.0, 1e-12);
  EXPECT_THAT(
      answer_to(outcome, "groups"),
      HasSubstr("Not significantly: the mean rating on the scale “rough”: 4.00 (95 % CI ["));
  EXPECT_THAT(answer_to(outcome, "group_profiles"), HasSubstr("R² = .98 of the variation"));
  EXPECT_THAT(answer_to(outcome, "group_profiles"), HasSubstr("(haptic − visual)"));
  EXPECT_THAT(sentence_about(outcome, "groups"),
              HasSubstr("The mean ratings of the groups haptic and visual were not significantly"));
  // Corrected for both tests: 4/70 = .057.
  EXPECT_THAT(sentence_about(outcome, "group_profiles"),
              HasSubstr("The differences between the items in the ratings were not significantly "
                        "different in the groups haptic and visual: permutation test of group "
                        "labels of profiles"));
  EXPECT_EQ(table_of(outcome, kGroupMeans).table.rows.size(), 2U);
  EXPECT_EQ(table_of(outcome, kGroupProfiles).table.rows.size(), 2U);
  EXPECT_THAT(remarks_of(outcome), Not(HasSubstr("not compared")));
}

// Eight participants in two blocks of four, two of each group in a block, and the group haptic above the other: of 6·6 ways to
// exchange labels within the blocks this one and its mirror image have such a difference. Of all labels there would be 70 ways.
TEST(GroupComparisons, ExchangeLabelsWithinTheBlocksOfTheAssignment) {
  json protocol = rating_protocol({"rough"});
  protocol["groups"] = {
      {"factor", "training"}, {"assigned", "permuted_blocks"}, {"seed", 8}, {"block_sizes", {4}}};
  protocol["factors"]["training"]["levels"] = {"haptic", "visual"};
  const PermutedBlocks blocks{.groups = 2, .sizes = {4}, .seed = 8};
  for (const SessionMode mode : {SessionMode::run, SessionMode::simulate}) {
    MadeUpStudy made{};
    const std::int64_t stored = made.add_protocol("grouped", "rating", protocol.dump());
    for (std::size_t place = 0; place < 8; ++place) {
      const bool is_haptic = permuted_place(blocks, text_of(mode), place).group == 0;
      const std::string label = "virtual000" + std::to_string(place + 1);
      mode == SessionMode::run ? made.add_person(label, "") : made.add_virtual(label, "F");
      made.set_group(is_haptic ? "haptic" : "visual");
      const int level = static_cast<int>(place % 3) + (is_haptic ? 4 : 1);
      std::vector<MadeUpTrial> trials{rated("wood", is_haptic ? 7 : level),
                                      rated("metal", is_haptic ? level : 7)};
      for (MadeUpTrial& trial : trials) {
        json factors = json::parse(trial.factors_json);
        factors["training"] = is_haptic ? "haptic" : "visual";
        trial.factors_json = factors.dump();
      }
      made.add_session(label, stored, trials, mode);
    }
    const AnalysisOutcome outcome = analyze_study(made.study()).front();
    EXPECT_NEAR(*finding_of(outcome, "groups", "values.perm.p.two").value, 2.0 / 36.0, 1e-12);
    EXPECT_NEAR(*finding_of(outcome, "groups", "values.perm.smallest").value, 2.0 / 36.0, 1e-12);
    EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.perm.p").value, 2.0 / 36.0, 1e-12);
    EXPECT_THAT(question_of(outcome, "groups").method.english(),
                HasSubstr("Labels are exchanged only within the blocks in which the groups were "
                          "assigned."));
  }
}

// Every participant of one group is above those of the other, so that p = 2/70; Welch's CI is 5 − 1.75 ± 3.6.
TEST(GroupComparisons, EstablishNothingInAnswersAndInTheTextForAPaperWhereTheIntervalContainsZero) {
  constexpr std::array<int, kPeople> kRatings{7, 3, 7, 3, 2, 2, 2, 1};
  json protocol = rating_protocol({"rough"});
  protocol["analysis"]["family"] = {"groups"};
  const AnalysisOutcome outcome = outcome_of_groups(protocol, [&](int person) {
    const int own = kRatings[static_cast<std::size_t>(person)];
    return std::vector{rated("wood", own), rated("metal", own)};
  });
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.perm.p.two").value, 2.0 / 70.0, 1e-12);
  const std::string answer = answer_to(outcome, "groups");
  EXPECT_THAT(answer, StartsWith("Not established: the mean rating on the scale “rough”: 5.00"));
  EXPECT_THAT(answer, HasSubstr("The test is significant, but the 95 % CI of the difference "
                                "contains 0; more participants are needed."));
  const std::string sentence = sentence_about(outcome, "groups");
  EXPECT_THAT(sentence, StartsWith("It was not established that the mean ratings were higher in "
                                   "the group haptic than in the group visual: "));
  EXPECT_THAT(sentence, HasSubstr("; the 95 % CI of the difference contains 0"));
}

TEST(GroupComparisons, NameTheScaleWhereThereAreSeveral) {
  json protocol = rating_protocol({"rough", "hard"});
  protocol["analysis"]["family"] = {"groups"};
  const AnalysisOutcome outcome = outcome_of_groups(protocol, [](int person) {
    const int hard = person < 4 ? 7 - person % 2 : 2 - person % 2;
    std::vector<MadeUpTrial> trials{rated("wood", 4), rated("metal", 5)};
    for (MadeUpTrial& trial : trials) {
      trial.questions.emplace_back("hard");
      trial.answers.push_back(std::to_string(hard));
    }
    return trials;
  });
  EXPECT_THAT(
      sentence_about(outcome, "groups", {"haptic", "visual", "hard"}),
      HasSubstr("The mean ratings on the scale “hard” of the groups haptic and visual were not"));
  EXPECT_NEAR(*finding_of(outcome, "groups:hard", "values.shift").value, 5.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "groups:hard", "values.perm.p.two").value, 2.0 / 70.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "groups:rough", "values.perm.p.two").value, 1.0, 1e-12);
}

TEST(GroupComparisons, OfOneParticipantInEachGroupAreNoTest) {
  const AnalysisOutcome outcome = outcome_of_groups(rating_protocol({"rough"}), [](int person) {
    return person % 4 == 0 ? std::vector{rated("wood", 4), rated("metal", 5 - person / 4)}
                           : std::vector<MadeUpTrial>{};
  });
  for (const char* const test : {"groups", "group_profiles"}) {
    EXPECT_THAT(sentence_about(outcome, test),
                HasSubstr("could not be computed: each of the groups has one participant."));
  }
}

// Only one group felt stone: the others are compared in wood and metal, in which nothing is missing.
TEST(GroupComparisons, OfProfilesAreOfTheItemsThatBothGroupsHave) {
  const AnalysisOutcome outcome = outcome_of_groups(rating_protocol({"rough"}), [](int person) {
    const auto& own = kOpposite[static_cast<std::size_t>(person)];
    std::vector<MadeUpTrial> trials{rated("wood", own[0]), rated("metal", own[1])};
    if (person < 4) trials.push_back(rated("stone", 4));
    return trials;
  });
  EXPECT_EQ(finding_of(outcome, "group_profiles", "profile.incomplete").value, 0.0);
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.r2").value, 100.0 / 102.0, 1e-12);
  EXPECT_EQ(table_of(outcome, kGroupProfiles).table.rows.size(), 2U);
}

// --- thresholds --------------------------------------------------------------------------------------

std::vector<MadeUpTrial> choices_of(int person, double alpha_m) {
  PsychometricFunction function = kPerformer;
  function.alpha = alpha_m;
  return trials_of(
      MadeUpObserver(function, static_cast<unsigned>(40 + person)).choices(kAbove_m, 60, true));
}

json thresholds_protocol() {
  json protocol = discrimination_protocol("performance");
  protocol["analysis"]["family"] = {"groups"};
  return protocol;
}

TEST(GroupComparisons, CompareThresholdsByTheirRatio) {
  const AnalysisOutcome outcome = outcome_of_groups(thresholds_protocol(), [](int person) {
    return choices_of(person, person < 4 ? 6e-6 : 12e-6);
  });
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  std::array<double, 2> logs{};
  for (const Finding* const jnd : FoundNumbers(thresholds).all("jnd")) {
    const bool is_second = jnd->key.last() == "visual";
    logs[is_second ? 1 : 0] += std::log(*jnd->value) / 4.0;
  }
  const Finding ratio = finding_of(outcome, "groups", "values.ratio");
  EXPECT_NEAR(*ratio.value, std::exp(logs[0] - logs[1]), 1e-12);
  ASSERT_TRUE(ratio.low && ratio.high);
  EXPECT_LT(*ratio.high, 1.0);
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.mean", "visual").value, std::exp(logs[1]),
              1e-18);
  EXPECT_EQ(finding_of(outcome, "groups", "values.mean", "visual").unit, "m");
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.log.perm.p.two").value, 2.0 / 70.0, 1e-12);
  EXPECT_THAT(answer_to(outcome, "groups"),
              HasSubstr("Yes: the geometric mean of the thresholds: "));
  EXPECT_THAT(answer_to(outcome, "groups"), HasSubstr(" µm ("));
  EXPECT_THAT(answer_to(outcome, "groups"), HasSubstr("ratio haptic / visual: 0."));
  EXPECT_THAT(sentence_about(outcome, "groups"),
              HasSubstr("The thresholds were significantly lower in the group haptic than in the "
                        "group visual"));
}

// One of the visual participants is always correct, and therefore has no threshold.
TEST(GroupComparisons, HaveNoIntervalWhereAThresholdIsMissing) {
  const AnalysisOutcome outcome = outcome_of_groups(thresholds_protocol(), [](int person) {
    if (person != 7) return choices_of(person, person < 4 ? 6e-6 : 12e-6);
    std::vector<MadeUpTrial> trials = choices_of(person, 12e-6);
    for (MadeUpTrial& trial : trials) trial.answers = {"comparison"};
    return trials;
  });
  EXPECT_EQ(finding_of(outcome, "groups", "values.missing", "visual").value, 1.0);
  const Finding ratio = finding_of(outcome, "groups", "values.ratio");
  EXPECT_EQ(ratio.n, 7U);
  EXPECT_FALSE(ratio.low) << "it would describe the others";
  EXPECT_TRUE(finding_of(outcome, "groups", "values.mean", "haptic").low) << "this group has all";
  EXPECT_FALSE(finding_of(outcome, "groups", "values.mean", "visual").low);
  EXPECT_FALSE(finding_of(outcome, "groups", "values.hedges.g").low);
  EXPECT_THAT(answer_to(outcome, "groups"), HasSubstr("Left out: 1 of 8 participants"));
}

// Thresholds of a condition that all participants have are compared between the groups, and not with those of others.
TEST(GroupComparisons, CompareThresholdsWithinConditions) {
  const AnalysisOutcome outcome = outcome_of_groups(thresholds_protocol(), [](int person) {
    std::vector<MadeUpTrial> trials{};
    for (const char* const texture : {"metal", "wood"}) {
      const bool is_hard = person >= 4 && std::string(texture) == "wood";
      for (MadeUpTrial& trial : choices_of(person, is_hard ? 13e-6 : 6e-6)) {
        json factors = json::parse(trial.factors_json);
        factors["texture"] = texture;
        trial.factors_json = factors.dump();
        trials.push_back(std::move(trial));
      }
    }
    return trials;
  });
  EXPECT_NEAR(*finding_of(outcome, "groups:wood", "values.log.perm.p.two").value, 2.0 / 70.0,
              1e-12);
  EXPECT_GT(*finding_of(outcome, "groups:metal", "values.log.perm.p.two").value, 0.2);
  EXPECT_THAT(sentence_about(outcome, "groups", {"haptic", "visual", "metal"}),
              HasSubstr("The thresholds (metal) of the groups haptic and visual were not"));
  EXPECT_THAT(answer_to(outcome, "groups:wood"),
              HasSubstr("the geometric mean of the thresholds (wood): "));
}

// One level: no function can be fitted, and d′ is compared. Correct with the comparison first and second: 18 and 15 of 20 in one
// group, 14 and 12 in the other, one more or less for each participant; d′ = (z(H) − z(F))/√2 with the log-linear correction.
TEST(GroupComparisons, CompareSensitivityWhereThereIsOneLevel) {
  const auto corrected = [](int hits) { return normal_quantile((hits + 0.5) / 21.0); };
  std::array<double, 2> means{};
  const AnalysisOutcome outcome = outcome_of_groups(thresholds_protocol(), [&](int person) {
    const int more = person % 2;
    const int first = (person < 4 ? 17 : 13) + more;
    const int second = (person < 4 ? 15 : 12) - more;
    means[person < 4 ? 0 : 1] += (corrected(first) - corrected(20 - second)) / std::sqrt(2.0) / 4.0;
    std::vector<MadeUpChoice> choices{};
    for (int trial = 0; trial < 40; ++trial) {
      const bool is_first = trial < 20;
      choices.push_back({.value_m = kAbove_m.front(),
                         .chose_comparison = trial % 20 < (is_first ? first : second),
                         .comparison_first = is_first});
    }
    return trials_of(choices);
  });
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.mean", "haptic").value, means[0], 1e-9);
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.shift").value, means[0] - means[1], 1e-9);
  EXPECT_THAT(answer_to(outcome, "groups"), HasSubstr("the mean d′: "));
  EXPECT_THAT(sentence_about(outcome, "groups"),
              HasSubstr("The mean d′ was significantly higher in the group haptic than in the "
                        "group visual"));
}

// --- magnitudes --------------------------------------------------------------------------------------

// Estimates c·P^n with n = 0.4, 0.45, 0.5 and 0.55, and 0.3 more in the other group; scales are free.
TEST(GroupComparisons, CompareExponentsAndTheFormOfEstimates) {
  const json protocol = json::parse(R"({"kind": "magnitude",
      "estimation": {"factor": "surface", "predictor": "values", "unit": "µm",
                     "values": {"brick": 2, "cork": 4, "oak": 16}},
      "factors": {"surface": {"levels": ["oak", "cork", "brick"]}},
      "blocks": {"only": {"question": {"name": "size", "prompt": "How strong?"}}},
      "analysis": {"family": ["groups"]}})");
  const std::map<std::string, double> values{{"brick", 2.0}, {"cork", 4.0}, {"oak", 16.0}};
  const AnalysisOutcome outcome = outcome_of_groups(protocol, [&values](int person) {
    const double exponent = 0.4 + 0.05 * (person % 4) + (person < 4 ? 0.0 : 0.3);
    std::vector<MadeUpTrial> trials{};
    for (const auto& [name, value] : values) {
      MadeUpTrial& trial = trials.emplace_back();
      trial.surfaces = {surface_of(name, "height_map", name)};
      trial.factors_json = R"({"surface": ")" + name + "\"}";
      trial.number = (1.0 + person) * std::pow(value, exponent);
      trial.answers = {std::to_string(*trial.number)};
    }
    return trials;
  });
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.mean", "haptic").value, 0.475, 1e-6);
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.shift").value, -0.3, 1e-6);
  EXPECT_NEAR(*finding_of(outcome, "groups", "values.perm.p.two").value, 2.0 / 70.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.perm.p").value, 2.0 / 70.0, 1e-12);
  EXPECT_THAT(sentence_about(outcome, "groups"),
              HasSubstr("The exponents were significantly smaller in the group haptic than in the "
                        "group visual"));
}

// One group estimates ten times as much with the second probe, and the exponents are the same in both.
TEST(GroupComparisons, OfEstimatesAreNotOfTheConditions) {
  const json protocol = json::parse(R"({"kind": "magnitude",
      "estimation": {"factor": "surface", "condition": "probe"},
      "factors": {"surface": {"levels": ["oak", "cork", "brick"]},
                  "probe": {"levels": ["small", "large"]}},
      "blocks": {"only": {"question": {"name": "size", "prompt": "How strong?"}}},
      "analysis": {"family": ["group_profiles"]}})");
  const AnalysisOutcome outcome = outcome_of_groups(protocol, [](int person) {
    std::vector<MadeUpTrial> trials{};
    for (const std::string probe : {"small", "large"}) {
      double value = 2.0;
      for (const std::string name : {"brick", "cork", "oak"}) {
        MadeUpTrial& trial = trials.emplace_back();
        trial.surfaces = {surface_of(name, "height_map", name)};
        trial.factors_json = json{{"surface", name}, {"probe", probe}}.dump();
        trial.number = std::pow(value, 0.4 + 0.05 * (person % 4)) *
                       (person < 4 && probe == "large" ? 10.0 : 1.0);
        trial.answers = {std::to_string(*trial.number)};
        value *= 2.0;
      }
    }
    return trials;
  });
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.r2").value, 0.0, 1e-9);
  EXPECT_GT(*finding_of(outcome, "group_profiles", "profile.perm.p").value, 0.9);
}

// --- choices and dissimilarities -----------------------------------------------------------------------

TEST(GroupComparisons, CompareWhichItemsAreChosen) {
  const json protocol = json::parse(R"({"kind": "paired_comparison", "blocks": {"only": {
      "question": {"name": "rougher", "prompt": "Which is rougher?"}}},
      "analysis": {"family": ["group_profiles"]}})");
  const auto compared = [](const std::string& first, const std::string& second, bool is_first) {
    MadeUpTrial trial{};
    trial.surfaces = {surface_of(first, "height_map", first),
                      surface_of(second, "height_map", second)};
    trial.options = {first, second};
    trial.answers = {is_first ? first : second};
    return trial;
  };
  const AnalysisOutcome outcome = outcome_of_groups(protocol, [&](int person) {
    const bool is_haptic = person < 4;
    return std::vector{compared("a", "b", is_haptic), compared("a", "c", is_haptic),
                       compared("b", "c", person % 2 == 0)};
  });
  // a: in both of its comparisons, or in none.
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.diff", "a").value, 1.0, 1e-12);
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.perm.p").value, 2.0 / 70.0, 1e-12);
  EXPECT_THAT(sentence_about(outcome, "group_profiles"),
              HasSubstr("The proportions of choices of the items were significantly different in "
                        "the groups haptic and visual"));
}

TEST(GroupComparisons, CompareTheChoicesOfASelectionWithoutATarget) {
  const json protocol =
      json::parse(R"({"kind": "selection", "analysis": {"family": ["group_profiles"]}})");
  const AnalysisOutcome outcome = outcome_of_groups(protocol, [](int person) {
    std::vector<MadeUpTrial> trials{};
    for (int i = 0; i < 4; ++i) {
      MadeUpTrial& trial = trials.emplace_back();
      trial.options = {"height_map", "sinusoid", "random_field"};
      for (const std::string& model : trial.options) {
        trial.surfaces.push_back(surface_of(model, model, "metal"));
      }
      // Three of four times the first model in one group, the second in the other.
      trial.answers = {i == person % 4 ? "random_field" : person < 4 ? "height_map" : "sinusoid"};
    }
    return trials;
  });
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.diff", "height_map").value, 0.75,
              1e-12);
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.diff", "random_field").value, 0.0,
              1e-12);
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.perm.p").value, 2.0 / 70.0, 1e-12);
}

TEST(GroupComparisons, CompareDissimilaritiesByWholeParticipants) {
  const json protocol = json::parse(R"({"kind": "similarity", "blocks": {"only": {"question": {
      "name": "different", "prompt": "How different?", "rates": "dissimilarity",
      "scale": {"minimum": 0, "maximum": 100}}}},
      "analysis": {"family": ["group_profiles"]}})");
  const auto different = [](const std::string& first, const std::string& second, int rating) {
    MadeUpTrial trial{};
    trial.surfaces = {surface_of(first, "height_map", first),
                      surface_of(second, "height_map", second)};
    trial.questions = {"different"};
    trial.answers = {std::to_string(rating)};
    return trial;
  };
  // The two orders of a pair are averaged: 40 + p and 60 + p.
  const AnalysisOutcome outcome = outcome_of_groups(protocol, [&](int person) {
    const int far = person < 4 ? 90 : 10;
    return std::vector{different("a", "b", 40 + person), different("b", "a", 60 + person),
                       different("a", "c", far), different("b", "c", 100 - far),
                       different("a", "a", 0)};
  });
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.perm.p").value, 2.0 / 70.0, 1e-12);
  // Mean of a participant: (50 + p + 100)/3. Of a|c: 90 and 10, and p is 1.5 and 5.5 on average.
  EXPECT_NEAR(*finding_of(outcome, "group_profiles", "profile.diff", "a / c").value,
              80.0 + 4.0 / 3.0, 1e-9);
  EXPECT_THAT(answer_to(outcome, "group_profiles"), HasSubstr("that of a / c, 81.33. Permutation"));
}

}  // namespace
}  // namespace asperity
