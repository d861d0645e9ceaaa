// What the families of analyses answer to tables that have no answer.

#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/analyses/tidy/tidy_families.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::vector<Finding> findings_of(const std::string& family, const std::string& table,
                                 const std::string& options) {
  TidyInput input{.options = FamilyOptions::of_json(options, "options")};
  input.tables.emplace_back(table, "t.csv");
  return tidy_family(family).findings(input);
}

std::string refusal_of(const std::string& family, const std::string& table,
                       const std::string& options) {
  try {
    findings_of(family, table, options);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

std::string word_of(const std::vector<Finding>& findings, const std::string& quantity) {
  for (const Finding& finding : findings) {
    if (finding.quantity == quantity) {
      EXPECT_NE(finding.status, "ok") << quantity << " needs a sentence";
      return finding.word;
    }
  }
  return "(absent)";
}

constexpr const char* kLabels = R"({"labels": ["x", "y", "z"]})";
constexpr const char* kMagnitude = R"({"zero_rule": "halfmin", "normalisation": "geomean"})";
constexpr const char* kWithin = R"({"within": {"s": ["a", "b"]}})";
constexpr const char* kGroups = R"({"groups": ["a", "b"]})";

TEST(TidyRefusals, NameTheLineAndTheColumn) {
  EXPECT_THAT(refusal_of("recognition", "subject,stimulus,response\nA,x,q\n", kLabels),
              HasSubstr("t.csv:2:3"));
  EXPECT_THAT(
      refusal_of("magnitude", "subject,probe,spacing,estimate\nA,1,1,2\nA,1,2,-3\n", kMagnitude),
      HasSubstr("t.csv:3:4"));
  EXPECT_THAT(refusal_of("magnitude", "subject,probe,spacing,estimate\nAnna,1,1,0\n", kMagnitude),
              HasSubstr("all estimates of Anna are 0"));
  EXPECT_THAT(refusal_of("rmanova", "subject,s,y\nA,a,1\nA,q,2\n", kWithin),
              HasSubstr("t.csv:3:2: \"q\" is no level of s"));
  EXPECT_THAT(refusal_of("group", "subject,group,correct,trials\nA,a,5,4\n", kGroups),
              HasSubstr("t.csv:2:3"));
  EXPECT_THAT(refusal_of("power", "id,kind,n,alpha,p0\none,binom_two,9,0.05,\n", "[]"),
              HasSubstr("t.csv:2:5: p0 is missing"));
  EXPECT_THAT(refusal_of("power", "id,kind,n,alpha\none,luck,9,0.05\n", "[]"),
              HasSubstr("there is no kind of plan \"luck\""));
}

// None of these can be told from a table that was pasted twice, and each would be an n too large.
TEST(TidyRefusals, NameTheRowThatSaysAThingASecondTime) {
  EXPECT_EQ(
      refusal_of("rating", "subject,item,score\nA,a,6\nA,b,2\nA,a,1\n", R"({"items": ["a", "b"]})"),
      "t.csv:4:2: A has a row with \"a\" already; a participant scores an item once");
  const std::string once = "; there is one row per participant, who is in one group";
  EXPECT_EQ(
      refusal_of("group", "subject,group,correct,trials\nA,a,3,4\nB,b,1,4\nA,a,0,4\n", kGroups),
      "t.csv:4:1: \"A\" stands a second time" + once);
  EXPECT_EQ(
      refusal_of("group", "subject,group,correct,trials\nA,a,3,4\nB,b,1,4\nA,b,0,4\n", kGroups),
      "t.csv:4:1: \"A\" stands a second time" + once);
  EXPECT_THAT(refusal_of("proportion", "id,k,n,p0\nx,1,2,0.5\ny,1,2,0.5\nx,1,2,0.5\n", "[]"),
              HasSubstr("t.csv:4:1: \"x\" stands a second time"));
  EXPECT_THAT(
      refusal_of("power", "id,kind,n,alpha,d\nx,paired_t,9,0.05,1\nx,paired_t,8,0.05,1\n", "[]"),
      HasSubstr("t.csv:3:1: \"x\" stands a second time"));
  EXPECT_EQ(refusal_of("magnitude",
                       "subject,probe,spacing,rep,estimate\nA,1,0.5,1,2\nA,1,0.5,2,3\n"
                       "A,1,0.50,1,4\n",
                       kMagnitude),
            "t.csv:4:4: A has repetition 1 of probe 1, spacing 0.5 already");
  EXPECT_EQ(refusal_of("matching",
                       "subject,trial,stimulus,response,group\nA,1,x,x,F\nA,1,y,y,F\n"
                       "A,2,x,x,M\nA,2,y,y,M\n",
                       "[]"),
            "t.csv:4:5: A stands in two groups");
  const std::string times = "the rows of a trial must stand for as many trials";
  EXPECT_EQ(
      refusal_of("matching", "subject,trial,stimulus,response,times\nA,1,x,x,2\nA,1,y,y,3\n", "[]"),
      "t.csv:3:5: " + times);
  EXPECT_EQ(refusal_of("ranking", "subject,trial,item,rank,times\nA,1,a,1,2\nA,1,b,2,3\n",
                       R"({"items": ["a", "b"]})"),
            "t.csv:3:5: " + times);
}

TEST(TidyRefusals, SayWhichOptionIsWrong) {
  EXPECT_THAT(refusal_of("rmanova", "subject,s,y\nA,a,1\n", R"({"within": "s"})"),
              HasSubstr("\"within\" must be an object of factors with their levels, like "
                        "{\"spacing\": [1, 2, 4]}"));
  EXPECT_THAT(refusal_of("psyfit", "condition,x,n,k\nc,1,4,2\n",
                         R"({"shape": "cauchy", "gamma": 0, "lambda": 0, "pt": 0.5})"),
              HasSubstr("\"shape\" is \"cauchy\""));
  EXPECT_THAT(refusal_of("rmanova", "subject,s,y\nA,a,1\nA,b,1\nB,a,2\nB,b,4\n",
                         R"({"within": {"s": ["a", "b"]}, "type": 1})"),
              HasSubstr("\"type\" is 1"));
  EXPECT_THAT(
      refusal_of("group", "subject,group,correct,trials\nA,a,3,4\n", R"({"groups": ["a"]})"),
      HasSubstr("it needs two"));
}

TEST(TidyRefusals, AreWordsWhereOnePersonOrNobodyAnswered) {
  EXPECT_EQ(
      word_of(findings_of("recognition", "subject,stimulus,response\nA,x,\n", kLabels), "status"),
      "no_data");
  EXPECT_EQ(
      word_of(findings_of("recognition", "subject,stimulus,response\nA,x,x\n", kLabels), "subj.t"),
      "undefined_one_participant");
  EXPECT_EQ(word_of(findings_of("magnitude",
                                "subject,probe,spacing,estimate\nA,1,1,2\nA,1,2,3\nA,1,4,5\n",
                                kMagnitude),
                    "status"),
            "one_participant");
  EXPECT_EQ(word_of(findings_of("rmanova", "subject,s,y\nA,a,1\nA,b,2\n", kWithin), "status"),
            "too_few_participants");
  EXPECT_EQ(
      word_of(findings_of("group", "subject,group,correct,trials\nA,a,3,4\n", kGroups), "status"),
      "no_data");
}

TEST(TidyRefusals, TakeNoAgreementOfOneWithHimself) {
  const char* items = R"({"items": ["a", "b", "c"]})";
  const std::vector<Finding> one =
      findings_of("rating", "subject,item,score\nA,a,1\nA,b,2\nA,c,3\n", items);
  EXPECT_EQ(word_of(one, "friedman.chisq"), "undefined_one_row");
  EXPECT_EQ(word_of(one, "friedman.p"), "(absent)");
  EXPECT_EQ(word_of(one, "kendall.W"), "(absent)");
  EXPECT_EQ(word_of(findings_of("rating", "subject,item,score\nA,a,1\n", items), "friedman.chisq"),
            "no_data");
  EXPECT_EQ(
      word_of(findings_of("ranking", "subject,trial,item,rank\nA,1,a,1\nA,1,b,2\nA,1,c,3\n", items),
              "friedman.chisq"),
      "undefined_one_row");
}

TEST(TidyRefusals, SayWhyANumberIsNotDefined) {
  const auto why = [](const std::vector<Finding>& findings, const std::string& quantity) {
    for (const Finding& finding : findings) {
      if (finding.quantity == quantity) return finding.word + ": " + finding.status;
    }
    return std::string();
  };
  const char* choices = R"({"renderers": ["a", "b"], "target": "a"})";
  EXPECT_EQ(
      why(findings_of("selection", "subject,sample,choice\nA,1,a\n", choices), "subj.t.p.two"),
      "NA: one participant has no spread: run more");
  EXPECT_EQ(why(findings_of("selection", "subject,sample,choice\nA,1,a\nB,1,a\n", choices),
                "subj.t.p.two"),
            "NA: all participants have the same share");
  EXPECT_EQ(why(findings_of("rating", "subject,item,score\nA,a,2\nA,b,2\nB,a,3\nB,b,3\n",
                            R"({"items": ["a", "b"]})"),
                "friedman.p"),
            "NA: all items are tied in every row: there is no order to test");
  EXPECT_EQ(why(findings_of("recognition", "subject,stimulus,response\nA,y,y\nB,y,x\n", kLabels),
                "recall"),
            "NA: it was never presented");
}

TEST(TidyFamilies, RefuseAnOptionThatTheyDoNotHaveAndSayWhichIsMeant) {
  const auto refusal = [](const std::string& family, const std::string& option) {
    FamilyOptions options{};
    options.add(option, "x");
    try {
      refuse_unknown_options(tidy_family(family), options);
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("rating", "item"), "rating has no option \"item\"; did you mean \"items\"?");
  EXPECT_EQ(refusal("rating", "target"),
            "rating has no option \"target\"; it has: items (all that were scored), conf");
  EXPECT_EQ(refusal("power", "conf"), "power has no option \"conf\"; it takes none");
  EXPECT_EQ(refusal("rating", "items"), "");
}

// 0.50 in a table and 0.5 in the options are one level, and the order is that of the options.
TEST(TidyFamilies, TakeEqualNumbersForOneLevel) {
  const std::vector<Finding> findings =
      findings_of("rmanova", "subject,s,y\nA,0.50,1\nA,10,2\nB,0.50,3\nB,10,7\n",
                  R"({"within": {"s": [10, 0.5]}})");
  const auto found = std::find_if(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.quantity == "pair.diff";
  });
  ASSERT_NE(found, findings.end());
  EXPECT_EQ(found->key, "s|10|0.5");
  EXPECT_EQ(found->value, 2.5);
}

}  // namespace
}  // namespace asperity
