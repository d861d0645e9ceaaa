// Comparisons of the groups to which a protocol assigns participants: the numbers of women and men, under other names.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/study_tests.h"
#include "app/findings/shared/group_equivalence.h"
#include "app/findings/study/analyze_study.h"
#include "app/report/text/study_report.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string grouped_source(const std::string& levels, const std::string& analysis) {
  return R"({"groups": {"factor": "training"}, "factors": {"training": {"levels": [)" + levels +
         R"(]}}, "analysis": )" + analysis + "}";
}

MadeUpTrial recognised(bool is_correct) {
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("metal", "height_map", "metal")};
  trial.answers = {is_correct ? "metal" : "stone"};
  trial.right = {"metal"};
  trial.options = {"metal", "stone"};
  return trial;
}

MadeUpTrial assigned(bool is_correct) {
  MadeUpTrial trial{};
  trial.options = {"metal", "stone"};
  for (const std::string& texture : trial.options) {
    trial.surfaces.push_back(surface_of(texture, "height_map", texture));
  }
  trial.right = trial.options;
  trial.answers = trial.options;
  if (!is_correct) std::swap(trial.answers.front(), trial.answers.back());
  return trial;
}

MadeUpTrial selected(bool is_target) {
  MadeUpTrial trial{};
  trial.options = {"height_map", "sinusoid"};
  for (const std::string& model : trial.options) {
    trial.surfaces.push_back(surface_of(model, model, "metal"));
  }
  trial.answers = {is_target ? "height_map" : "sinusoid"};
  return trial;
}

struct Member {
  std::string group{};
  std::string sex{};
  int correct = 0;  ///< of eight
};

/// Practised with complete success, others at chance: 7, 6, 8 and 7 of 8; 4, 3, 5 and 4 of 8.
const std::vector<Member> kTwoGroups{{"haptic", "F", 7}, {"haptic", "F", 6}, {"haptic", "F", 8},
                                     {"haptic", "F", 7}, {"visual", "M", 4}, {"visual", "M", 3},
                                     {"visual", "M", 5}, {"visual", "M", 4}};

class ComparedGroups : public testing::Test {
 protected:
  void add(const std::string& kind, const std::string& source, const std::vector<Member>& members) {
    const std::int64_t protocol = made_.add_protocol("grouped", kind, source);
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::string label = "p" + std::to_string(10 + i);
      made_.add_person(label, members[i].sex);
      made_.set_group(members[i].group);
      std::vector<MadeUpTrial> trials{};
      for (int k = 0; k < 8; ++k) {
        const bool is_hit = k < members[i].correct;
        trials.push_back(kind == "matching"    ? assigned(is_hit)
                         : kind == "selection" ? selected(is_hit)
                                               : recognised(is_hit));
        trials.back().factors_json = R"({"training": ")" + members[i].group + "\"}";
      }
      made_.add_session(label, protocol, trials);
    }
    outcome_ = analyze_study(made_.study()).front();
  }

  const Finding& finding(const std::string& analysis, const std::string& quantity,
                         const std::string& key = "") const {
    for (const Finding& one : outcome_.findings) {
      if (one.analysis == analysis && one.quantity == quantity && one.key == key) return one;
    }
    throw std::runtime_error("no finding " + analysis + " " + quantity + " " + key);
  }
  std::string answer(const std::string& question) const {
    for (const AnsweredQuestion& one : outcome_.questions) {
      if (one.name == question) return one.answer.english();
    }
    return "(not asked)";
  }
  std::vector<std::string> sentences() const {
    std::vector<std::string> texts{};
    for (const TestSentence& one : outcome_.test_sentences) {
      if (one.test == kGroupsTest) texts.push_back(one.text);
    }
    return texts;
  }

  /// The paragraphs of the report of the study, one per line.
  std::string report_text() {
    const Report report = study_report(made_.study());
    std::string text{};
    for (const ReportChapter& chapter : report.chapters) {
      for (const ReportSection& section : chapter.sections) {
        for (const ReportPart& part : section.parts) {
          if (const auto* words = std::get_if<ReportText>(&part)) text += words->text + '\n';
        }
      }
    }
    return text;
  }

  MadeUpStudy made_{};
  AnalysisOutcome outcome_{};
};

// 7 + 6 + 8 + 7 = 28 and 4 + 3 + 5 + 4 = 16 of 32: the difference is 12/32. Of the 70 divisions of eight participants
// into two fours, this one and its mirror image have the largest difference: p = 2/70.
TEST_F(ComparedGroups, DifferByTheirParticipantsMeans) {
  add("recognition", grouped_source(R"("haptic", "visual")", "{}"), kTwoGroups);
  EXPECT_NEAR(*finding("groups", "subj.mean", "haptic").value, 28.0 / 32.0, 1e-12);
  EXPECT_NEAR(*finding("groups", "subj.mean", "visual").value, 16.0 / 32.0, 1e-12);
  EXPECT_NEAR(*finding("groups", "subj.diff").value, 12.0 / 32.0, 1e-12);
  EXPECT_NEAR(*finding("tests", "p", "test=groups about=haptic|visual").value, 2.0 / 70.0, 1e-12);
  EXPECT_THAT(answer("groups"),
              StartsWith("For these participants, the mean proportion correct is 88 % (95 % CI ["));
  EXPECT_THAT(answer("groups"), HasSubstr("for haptic and 50 % ("));
  EXPECT_THAT(answer("groups"), HasSubstr("difference (haptic − visual) 37.5 percentage points"));
  EXPECT_THAT(answer(kGroupsEquivalence), HasSubstr("declares no equivalence margin"));
}

TEST_F(ComparedGroups, AreConfirmatoryWhereTheProtocolDeclaresThem) {
  add("recognition", grouped_source(R"("haptic", "visual")", R"({"family": ["groups"]})"),
      kTwoGroups);
  EXPECT_EQ(outcome_.questions.front().name, "groups") << "the main question";
  EXPECT_THAT(answer("groups"), StartsWith("Yes: the mean proportion correct is 88 %"));
  EXPECT_THAT(answer("groups"), HasSubstr("p = .029, the only test of its family"));
  EXPECT_THAT(sentences(),
              ElementsAre(StartsWith("The mean proportion correct was significantly higher in the "
                                     "group haptic than in the group visual: permutation test")));
}

// Here the groups are the sexes.
TEST_F(ComparedGroups, HaveTheNumbersOfTheSameComparisonOfWomenAndMen) {
  add("recognition", grouped_source(R"("haptic", "visual")", R"({"equivalence_margin": 0.5})"),
      kTwoGroups);
  std::size_t compared = 0;
  for (const Finding& one : outcome_.findings) {
    if (!one.analysis.starts_with("sexes")) continue;
    std::string key = one.key.text();
    for (const auto& [sex, group] : {std::pair("F", "haptic"), std::pair("M", "visual")}) {
      if (key == sex) key = group;
      if (key.ends_with(std::string("|") + sex)) key.replace(key.size() - 1, 1, group);
    }
    const Finding& same =
        finding(one.analysis == "sexes" ? "groups" : kGroupsEquivalence, one.quantity, key);
    EXPECT_EQ(same.value, one.value) << one.quantity;
    EXPECT_EQ(same.low, one.low) << one.quantity;
    EXPECT_EQ(same.high, one.high) << one.quantity;
    EXPECT_EQ(same.n, one.n) << one.quantity;
    ++compared;
  }
  EXPECT_GT(compared, 20U);
  EXPECT_THAT(answer("sexes"), HasSubstr("for women and 50 % ("));
  EXPECT_THAT(answer("sexes"), HasSubstr("difference (women − men) 37.5 percentage points"));
}

TEST_F(ComparedGroups, AreComparedPairByPairAndCorrectedTogether) {
  std::vector<Member> members = kTwoGroups;
  for (const int correct : {4, 4, 3, 5}) members.push_back({"none", "F", correct});
  add("recognition", grouped_source(R"("haptic", "visual", "none")", R"({"family": ["groups"]})"),
      members);
  std::set<std::string> about{};
  for (const Finding& one : outcome_.findings) {
    if (one.analysis == "tests" && one.quantity == "p.holm") about.insert(one.key.text());
  }
  EXPECT_THAT(about, ElementsAre("test=groups about=haptic|none", "test=groups about=haptic|visual",
                                 "test=groups about=visual|none"));
  EXPECT_NEAR(*finding("groups:haptic|visual", "subj.diff").value, 12.0 / 32.0, 1e-12);
  EXPECT_NEAR(*finding("groups:visual|none", "subj.diff").value, 0.0, 1e-12);
  // Two of three at 2/70, thrice; the third is not smaller.
  EXPECT_NEAR(*finding("tests", "p.holm", "test=groups about=haptic|visual").value, 3 * 2.0 / 70.0,
              1e-12);
  EXPECT_THAT(answer("groups:haptic|visual"), StartsWith("Not significantly: "));
  EXPECT_THAT(sentences(), testing::SizeIs(3));
}

TEST_F(ComparedGroups, AreComparedByMatchedItems) {
  add("matching", grouped_source(R"("haptic", "visual")", "{}"), kTwoGroups);
  EXPECT_NEAR(*finding("groups", "subj.diff").value, *finding("sexes", "subj.diff").value, 1e-12);
  EXPECT_NEAR(*finding("tests", "p", "test=groups about=haptic|visual").value,
              *finding("tests", "p", "test=sexes about=F|M").value, 1e-12);
  EXPECT_THAT(answer("groups"),
              HasSubstr("the mean proportion of correctly matched items is 88 % ("));
}

TEST_F(ComparedGroups, AreComparedByChoicesOfTheDeclaredTarget) {
  add("selection", grouped_source(R"("haptic", "visual")", R"({"target": "height_map"})"),
      kTwoGroups);
  EXPECT_NEAR(*finding("groups", "subj.diff").value, 12.0 / 32.0, 1e-12);
  EXPECT_THAT(answer("groups"),
              HasSubstr("the mean proportion of choices of height_map is 88 % ("));
  EXPECT_EQ(answer(kGroupsEquivalence), "(not asked)");
}

TEST_F(ComparedGroups, AreNotComparedWithoutATargetOrASecondGroup) {
  add("selection", grouped_source(R"("haptic", "visual")", "{}"), kTwoGroups);
  EXPECT_EQ(answer("groups"), "(not asked)");
}

TEST_F(ComparedGroups, HaveAReasonWhereTheDeclaredTestCannotBeMade) {
  const std::vector<Member> one_group(kTwoGroups.begin(), kTwoGroups.begin() + 4);
  add("recognition", grouped_source(R"("haptic", "visual")", R"({"family": ["groups"]})"),
      one_group);
  EXPECT_THAT(sentences(),
              ElementsAre("The test of groups could not be computed: the participants are not in "
                          "two groups of the protocol."));
}

TEST_F(ComparedGroups, AreInTheReportWithTheirSizes) {
  add("recognition", grouped_source(R"("haptic", "visual")", "{}"), kTwoGroups);
  // The made-up protocol cannot be read, which leaves out how participants were assigned.
  EXPECT_THAT(
      report_text(),
      HasSubstr("Participants were assigned to two groups (haptic, n = 4; visual, n = 4)."));
}

}  // namespace
}  // namespace asperity
