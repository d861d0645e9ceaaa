// What the families of analyses answer to tables that have no answer.

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/tidy/tidy_families.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::vector<Finding> findings_of(const std::string& family, const std::string& table,
                                 const std::string& options) {
  TidyInput input{.options = FamilyOptions::of_json(options, "options")};
  input.tables.emplace_back(table, "t.csv");
  return tidy_family(family).findings(input);
}

std::string family_refusal(const std::string& family, const std::string& table,
                           const std::string& options) {
  return refusal_of([&] { findings_of(family, table, options); });
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

std::string sentence_of(const std::vector<Finding>& findings, const std::string& quantity) {
  for (const Finding& finding : findings) {
    if (finding.quantity == quantity) return finding.status;
  }
  return "(absent)";
}

/// "no_data: …": the word and the sentence.
std::string reason_of(const std::vector<Finding>& findings, const std::string& quantity) {
  return word_of(findings, quantity) + ": " + sentence_of(findings, quantity);
}

constexpr const char* kLabels = R"({"labels": ["x", "y", "z"]})";
constexpr const char* kMagnitude = R"({"zero_rule": "halfmin", "normalisation": "geomean"})";
constexpr const char* kWithin = R"({"within": {"s": ["a", "b"]}})";
constexpr const char* kGroups = R"({"groups": ["a", "b"]})";

TEST(TidyRefusals, NameTheLineAndTheColumn) {
  EXPECT_THAT(family_refusal("recognition", "subject,stimulus,response\nA,x,q\n", kLabels),
              HasSubstr("t.csv:2:3"));
  EXPECT_THAT(family_refusal("magnitude", "subject,probe,spacing,estimate\nA,1,1,2\nA,1,2,-3\n",
                             kMagnitude),
              HasSubstr("t.csv:3:4"));
  EXPECT_THAT(
      family_refusal("magnitude", "subject,probe,spacing,estimate\nAnna,1,1,0\n", kMagnitude),
      HasSubstr("all estimates of Anna are 0"));
  EXPECT_EQ(family_refusal("psyfit", "condition,x,n,k\nc,0,10,1\nc,1,10,2\nc,2,10,5\n",
                           R"({"shape": "weibull", "gamma": 0, "lambda": 0, "pt": 0.5})"),
            "t.csv:2:4: k is 1 at x 0, where a Weibull function with gamma 0 has no hits; set "
            "gamma to the "
            "rate of hits without a stimulus, or to free, or correct the row");
  EXPECT_THAT(family_refusal("rmanova", "subject,s,y\nA,a,1\nA,q,2\n", kWithin),
              HasSubstr("t.csv:3:2: \"q\" is not a level of s"));
  EXPECT_THAT(family_refusal("group", "subject,group,correct,trials\nA,a,5,4\n", kGroups),
              HasSubstr("t.csv:2:3"));
  EXPECT_THAT(family_refusal("power", "id,kind,n,alpha,p0\none,binom_two,9,0.05,\n", "[]"),
              HasSubstr("t.csv:2:5: p0 is missing"));
  EXPECT_THAT(family_refusal("power", "id,kind,n,alpha\none,luck,9,0.05\n", "[]"),
              HasSubstr("the kind of plan \"luck\" is unknown"));
}

TEST(TidyRefusals, NameTheTrackAndTheOptionOfItsRule) {
  const std::string rule =
      R"("start": 5, "n_down": 2, "n_up": 1, "step": 1, "scale": "linear", "discard": 0)";
  const auto refusal = [](const std::string& rows, const std::string& options) {
    return family_refusal("staircase", "track,trial,response\n" + rows, options);
  };
  const std::string one = R"({"tracks": {"a": {)" + rule + "}}}";
  EXPECT_EQ(refusal("a,1,1\n", one), "");
  EXPECT_EQ(refusal("a,1,1\nb,1,1\n", one),
            "t.csv:3:1: the track \"b\" has no rule; add it to the option \"tracks\"");
  EXPECT_EQ(refusal("", one),
            "tracks.a: the table has no trial of this track; remove its rule, or correct its name");
  EXPECT_EQ(refusal("a,1,1\na,1,0\n", one),
            "t.csv:3:2: the track a already has a trial 1; number the trials of a track in order");
  EXPECT_EQ(refusal("a,1,2\n", one),
            "t.csv:2:3: response is 2; it must be 1 (correct) or 0 (incorrect), or empty");
  EXPECT_THAT(refusal(",1,1\n", one), HasSubstr("t.csv:2:1"));
  EXPECT_EQ(refusal("a,1,1\n", "{}"),
            "the option \"tracks\" is missing and has no default; give it a value");
  EXPECT_THAT(refusal("a,1,1\n", R"({"tracks": 3})"), HasSubstr("is empty or not an object"));
  EXPECT_THAT(refusal("a,1,1\n", R"({"tracks": {"a": 3}})"),
              HasSubstr("\"tracks.a\" is not an object; set it to options with their values"));
  EXPECT_THAT(refusal("a,1,1\n", R"({"tracks": {"a": {"start": 5}}})"),
              HasSubstr("tracks.a: the option \"scale\" is missing"));
  EXPECT_EQ(refusal("a,1,1\n", R"({"tracks": {"a": {)" + rule + R"(, "min": 6}}})"),
            "tracks.a: start is 5; it must lie between the bounds, min and max; correct the rule");
  EXPECT_THAT(refusal("a,1,1\n", R"({"tracks": {"a": {)" + rule + R"(, "discrad": 6}}})"),
              HasSubstr("tracks.a: there is no option \"discrad\"; did you mean \"discard\"?"));
  EXPECT_THAT(
      refusal("a,1,1\n", R"({"tracks": {"a": {)" + rule + R"(, "even": 1}}})"),
      HasSubstr("tracks.a: the option \"even\" is neither true nor false; set it to one of them"));
  EXPECT_EQ(word_of(findings_of("staircase", "track,trial,response\na,1,1\n", one), "threshold"),
            "insufficient_reversals");
}

// None of these can be told from a table that was pasted twice, and each would be an n too large.
TEST(TidyRefusals, NameTheRowThatSaysAThingASecondTime) {
  EXPECT_EQ(family_refusal("rating", "subject,item,score\nA,a,6\nA,b,2\nA,a,1\n",
                           R"({"items": ["a", "b"]})"),
            "t.csv:4:2: A has already rated \"a\"; remove one of the rows: a participant "
            "rates an item once");
  EXPECT_EQ(family_refusal("rating", "subject,item,score\nA,a,\nA,b,2\nA,a,1\nA,b,\n",
                           R"({"items": ["a", "b"]})"),
            "")
      << "no score is none";
  const std::string once =
      "; there must be one row per participant, with one group. Remove or rename one of the rows";
  EXPECT_EQ(
      family_refusal("group", "subject,group,correct,trials\nA,a,3,4\nB,b,1,4\nA,a,0,4\n", kGroups),
      "t.csv:4:1: \"A\" occurs a second time" + once);
  EXPECT_EQ(
      family_refusal("group", "subject,group,correct,trials\nA,a,3,4\nB,b,1,4\nA,b,0,4\n", kGroups),
      "t.csv:4:1: \"A\" occurs a second time" + once);
  EXPECT_EQ(family_refusal("group", "subject,group,correct,trials\nA,a,3,4\nA,a,2,4\n", kGroups),
            "t.csv:3:1: \"A\" occurs a second time" + once);
  EXPECT_EQ(
      family_refusal("proportion", "id,k,n,p0\nx,1,2,0.5\ny,1,2,0.5\nx,2,2,0.5\n", "[]"),
      "t.csv:4:1: \"x\" occurs a second time; there must be one row per count of hits. Remove "
      "or rename one of the rows");
  EXPECT_EQ(
      family_refusal("power", "id,kind,n,alpha,d\nx,paired_t,9,0.05,1\nx,paired_t,8,0.05,1\n",
                     "[]"),
      "t.csv:3:1: \"x\" occurs a second time; there must be one row per plan. Remove or rename "
      "one of the rows");
  EXPECT_EQ(family_refusal("matching",
                           "subject,trial,stimulus,response,group\nA,1,x,x,F\nA,1,y,y,F\n"
                           "A,2,x,x,M\nA,2,y,y,M\n",
                           "[]"),
            "t.csv:4:5: A is in the groups \"F\" and \"M\"; enter one group for each participant");
  EXPECT_EQ(family_refusal("matching",
                           "subject,trial,stimulus,response,times\nA,1,x,x,2\nA,1,y,y,3\n", "[]"),
            "t.csv:3:5: times is 3, but 2 in the rows before it of the same trial; enter the same "
            "number in all of them");
  EXPECT_EQ(
      family_refusal("ranking", "subject,trial,item,rank,times\nA,1,a,1,2\nA,1,b,2,3\n",
                     R"({"items": ["a", "b"]})"),
      "t.csv:3:5: times is 3, but 2 in another row of the same trial; enter the same number in "
      "all of them");
}

// Repetitions begin anew in every session and block, and an attempt without an estimate is none.
TEST(TidyRefusals, TakeARepetitionWhoseNumberStandsTwiceForAReplicate) {
  const std::string once = "A,1,1,1,3\nA,1,2,1,5\nB,1,1,1,2\nB,1,2,1,7\n";
  const auto replicates = [](const std::string& rows) {
    for (const Finding& finding :
         findings_of("magnitude", "subject,probe,spacing,rep,estimate\n" + rows, kMagnitude)) {
      if (finding.quantity == "replicates") return finding.word + ": " + finding.status;
    }
    return std::string();
  };
  EXPECT_EQ(replicates(once), "none: ok");
  EXPECT_EQ(replicates(once + "A,1,1,1,\n"), "none: ok");
  EXPECT_EQ(replicates(once + once), "equal: ok");
  EXPECT_EQ(
      replicates(once + "A,1,1.0,1,4\n"),
      "unequal: A has 2 values in the cell 1|1, while 3 of 4 cells have 1 value. The values of a "
      "cell are averaged: check whether a row occurs twice, or has the wrong participant or cell");
}

TEST(TidyRefusals, NameWhatEquivalenceAndReliabilityLack) {
  const std::string pairs = "subject,a,b\nA,1,2\nB,2,4\n";
  EXPECT_EQ(family_refusal("equivalence", pairs, R"({"lower": -1})"),
            "the option \"upper\" is missing; set both equivalence bounds, \"lower\" and "
            "\"upper\", or neither");
  EXPECT_THAT(family_refusal("equivalence", pairs, R"({"lower": 1, "upper": 1})"),
              HasSubstr("the lower bound must be less than the upper one"));
  EXPECT_THAT(family_refusal("equivalence", pairs, R"({"alpha": 0.5})"),
              HasSubstr("\"alpha\" is 0.5"));
  EXPECT_EQ(word_of(findings_of("equivalence", "subject,a,b\nA,1,2\nB,2,3\n", "{}"), "tost.p"),
            "undefined_zero_variance");
  EXPECT_EQ(word_of(findings_of("equivalence", "subject,a,b\nA,1,\n", "{}"), "diff"), "no_data");
  EXPECT_THAT(family_refusal("dprime", "id,design,signal_yes,signal_n\nx,triangle,1,2\n", "{}"),
              HasSubstr("\"triangle\" is not a design; use one of yesno, 2afc"));
  EXPECT_THAT(family_refusal("dprime", "id,design,signal_yes,signal_n\nx,yesno,1,2\n", "{}"),
              HasSubstr("this design needs a number of trials above 0"));
  EXPECT_THAT(family_refusal("dprime", "id,design,signal_yes,signal_n\nx,mafc,1,2\n", "{}"),
              HasSubstr("needs the number m of alternatives"));
  EXPECT_THAT(family_refusal("roc", "condition,rating,noise,signal\nx,1,2,3\nx,1,2,3\n", "{}"),
              HasSubstr("the rating 1 occurs a second time in the condition x"));
  EXPECT_EQ(family_refusal("icc", "target,rater,score\nx,A,1\nx,A,2\n", "{}"),
            "t.csv:3:3: x has already been rated by the rater A; remove one of the rows: a target "
            "is rated once "
            "by each rater");
  EXPECT_EQ(word_of(findings_of("icc", "target,rater,score\nx,A,1\nx,B,1\ny,A,1\n", "{}"), "icc"),
            "too_few_targets");
  EXPECT_EQ(
      word_of(findings_of("icc", "target,rater,score\nx,A,1\nx,B,1\ny,A,1\ny,B,1\n", "{}"), "icc"),
      "undefined_zero_variance");
}

TEST(TidyRefusals, NameWhatIsTooFewAndHowManyAreNeeded) {
  EXPECT_EQ(
      reason_of(findings_of("icc", "target,rater,score\nx,A,1\ny,A,2\n", "{}"), "icc"),
      "too_few_raters: reliability requires at least 2 raters, and the table has 1: add raters");
  EXPECT_EQ(reason_of(findings_of("icc", "target,rater,score\nx,A,1\nx,B,2\ny,A,1\n", "{}"), "icc"),
            "too_few_targets: reliability requires at least 2 targets that every rater rated, and "
            "the table "
            "has 1: add targets");
  EXPECT_EQ(
      reason_of(findings_of("components",
                            "item,scale,score\nx,hard,1\nx,rough,2\ny,hard,2\ny,rough,1\n", "{}"),
                "eigenvalue"),
      "too_few_items: principal components require at least 3 items, and the table has 2: add "
      "items");
  EXPECT_EQ(
      reason_of(findings_of("components", "item,scale,score\nx,hard,1\ny,hard,2\nz,hard,3\n", "{}"),
                "eigenvalue"),
      "too_few_scales: principal components require at least 2 scales, and the table has 1: add "
      "scales");
  EXPECT_EQ(reason_of(findings_of("ordinal", "subject,item,score\nA,x,1\nA,y,2\nB,x,2\nB,y,1\n",
                                  R"({"items": ["x", "y", "z"]})"),
                      "lr.p"),
            "item_without_response: the item \"z\" has no response: remove it from the option "
            "\"items\"");
}

TEST(TidyRefusals, NameAResponseTimeThatIsNone) {
  const std::string columns = "subject,time_s,tip\n";
  EXPECT_EQ(
      family_refusal("response_times", columns + "A,1.5,a\nA,0,b\n", "{}"),
      "t.csv:3:2: time_s is 0; a response time must be above 0 s. Correct it, or leave the cell "
      "empty where there is none");
  EXPECT_THAT(
      family_refusal("response_times", columns + "A,1.5,c\n", R"({"factors": {"tip": ["a"]}})"),
      HasSubstr("tip is \"c\"; it must be one of: a"));
  EXPECT_EQ(word_of(findings_of("response_times", columns + "A,,a\n", "{}"), "status"), "no_data");
  EXPECT_EQ(word_of(findings_of("response_times", columns + "A,2,a\n", "{}"), "geomean.status"),
            "too_few_participants");
  EXPECT_EQ(
      word_of(findings_of("response_times", columns + "A,2,a\nB,2,a\n", "{}"), "geomean.status"),
      "undefined_zero_variance");
}

TEST(TidyRefusals, NameATrialThatStandsTwice) {
  const std::string columns = "subject,trial,time_s\n";
  EXPECT_EQ(family_refusal("learning", columns + "A,2,1.5\nB,2,1\nA,2,3\n", "{}"),
            "t.csv:4:2: A already has a trial 2; number the trials of a participant consecutively");
  EXPECT_EQ(family_refusal("learning", columns + "A,0,1.5\n", "{}"),
            "t.csv:2:2: trial is 0; number the trials from 1");
  EXPECT_EQ(family_refusal("learning", columns + "A,1,1.5\n", R"({"blocks": 1.5})"),
            "the option \"blocks\" is 1.5; it must be a whole number above 0");
  EXPECT_EQ(family_refusal("learning", "subject,trial,correct,items\nA,1,3,2\n", "{}"),
            "t.csv:2:3: correct is 3 and items is 2; items must be at least 1, and correct at most "
            "items: correct the counts, or leave out rows without items");
  EXPECT_EQ(
      word_of(findings_of("learning", columns + "A,1,1.5\nA,2,1\n", "{}"), "half.ratio.status"),
      "too_few_participants");
  EXPECT_TRUE(findings_of("learning", columns + "A,1,\n", "{}").size() == 1);  // n.untimed
}

TEST(TidyRefusals, GiveNoNumberOfAMixedModelThatHasNone) {
  const std::string columns = "subject,item,correct,trials\n";
  EXPECT_EQ(word_of(findings_of("glmm", columns + "A,x,3,3\nA,y,3,3\nB,x,0,3\nB,y,0,3\n", "{}"),
                    "glmm.status"),
            "no_maximum");
  EXPECT_EQ(word_of(findings_of("glmm", columns + "A,x,9,10\nA,y,9,10\nB,x,4,10\nB,y,4,10\n", "{}"),
                    "glmm.status"),
            "no_item_variance");
  EXPECT_EQ(word_of(findings_of("glmm", columns, "{}"), "glmm.status"), "no_data");
  // Advice is not what the options already have.
  const auto of_participants =
      findings_of("glmm", columns + "A,x,4,10\nB,x,4,10\nC,x,4,10\n", R"({"random": "subject"})");
  EXPECT_EQ(word_of(of_participants, "glmm.status"), "no_participant_variance");
  EXPECT_THAT(sentence_of(of_participants, "glmm.status"), HasSubstr("use the family proportion"));
  EXPECT_EQ(
      family_refusal("glmm", columns + "A,x,4,3\n", "{}"),
      "t.csv:2:3: correct is 4 and trials is 3; trials must be at least 1, and correct at most "
      "trials: correct the counts, or leave out rows without trials");
  EXPECT_THAT(family_refusal("glmm", columns + "A,x,1,3\n", R"({"random": ["texture"]})"),
              HasSubstr("\"random\" names \"texture\"; it must be subject, item, or both"));
  EXPECT_THAT(family_refusal("glmm", columns + "A,x,1,3\n", R"({"link": "log"})"),
              HasSubstr("it must be logit or probit"));
}

TEST(TidyRefusals, NameTheLevelWhoseResponsesAreAllCorrect) {
  const std::string columns = "subject,item,correct,trials,tip\n";
  const auto findings = findings_of(
      "glmm",
      columns + "A,x,4,10,thin\nA,y,7,10,thin\nB,x,5,10,thin\nB,y,9,10,thin\nB,x,3,3,thick\n",
      R"({"random": "subject", "fixed": {"tip": ["thin", "thick"]}})");
  EXPECT_EQ(word_of(findings, "glmm.status"), "separated_level");
  EXPECT_THAT(
      sentence_of(findings, "glmm.status"),
      HasSubstr("every response at the level \"thick\" of tip is correct, so that the effect "
                "of tip has no finite estimate"));
  // The first level has no coefficient, and the effect no estimate all the same.
  const auto of_first = findings_of(
      "glmm", columns + "A,x,0,9,thin\nB,y,0,9,thin\nA,x,4,9,thick\nA,y,7,9,thick\nB,y,2,9,thick\n",
      R"({"random": "subject", "fixed": {"tip": ["thin", "thick"]}})");
  EXPECT_EQ(word_of(of_first, "glmm.status"), "separated_level");
  EXPECT_THAT(sentence_of(of_first, "glmm.status"),
              HasSubstr("every response at the level \"thin\" of tip is incorrect"));
}

TEST(TidyRefusals, FitNoFunctionWithMoreParametersThanLevels) {
  const auto findings =
      findings_of("psyfit", "condition,x,n,k\na,1,20,4\na,2,20,15\n",
                  R"({"shape": "logistic", "gamma": 0, "lambda": "free", "pt": 0.5})");
  EXPECT_EQ(word_of(findings, "status"), "too_few_levels");
  EXPECT_EQ(word_of(findings, "threshold"), "(absent)");
}

// Each participant has the same difference, so that nothing but rounding is left, whatever the unit.
TEST(TidyRefusals, FitNoLinearMixedModelWithoutResidualVariance) {
  for (const char* const unit : {"", "e-9", "e6"}) {
    std::string table = "subject,cond,y\n";
    for (const char* const row :
         {"A,a,1.1", "A,b,1.4", "B,a,2.3", "B,b,2.6", "C,a,0.7", "C,b,1.0"}) {
      table += std::string(row) + unit + '\n';
    }
    const auto findings = findings_of("lmm", table, R"({"fixed": {"cond": ["a", "b"]}})");
    EXPECT_EQ(word_of(findings, "lmm.status"), "no_residual_variance") << unit;
    EXPECT_EQ(word_of(findings, "lmm.F"), "(absent)") << unit;
  }
}

// The effect is the same in all participants.
TEST(TidyRefusals, SayThatThereIsNoErrorVariance) {
  const auto findings = findings_of(
      "rmanova", "subject,a,y\nA,1,1\nA,2,2\nA,3,4\nB,1,2\nB,2,3\nB,3,5\nC,1,3\nC,2,4\nC,3,6\n",
      R"({"within": {"a": [1, 2, 3]}})");
  for (const char* const quantity : {"F", "p", "eps.GG", "mauchly.W"}) {
    word_of(findings, quantity);
    EXPECT_THAT(sentence_of(findings, quantity), HasSubstr("no error variance")) << quantity;
  }
}

TEST(TidyRefusals, DrawNoConfigurationOfPairsThatAreJudgedAlike) {
  std::string table = "subject,first,second,dissimilarity\n";
  for (const char* const subject : {"A", "B"}) {
    for (const char* const pair : {"a,b", "a,c", "a,d", "b,c", "b,d", "c,d"}) {
      table += std::string(subject) + ',' + pair + ",0.3\n";
    }
  }
  const auto findings = findings_of("similarity", table, "{}");
  EXPECT_EQ(word_of(findings, "stress.ordinal"), "no_differences");
  EXPECT_EQ(word_of(findings, "dimensions"), "(absent)");
}

TEST(TidyRefusals, NameATrackThatStaysAtABound) {
  const auto track = [](const std::string& responses) {
    std::string table = "track,trial,response\n";
    for (std::size_t i = 0; i < responses.size(); ++i) {
      table += "a," + std::to_string(i + 1) + ',' + responses[i] + '\n';
    }
    return findings_of("staircase", table,
                       R"({"tracks": {"a": {"start": 2, "n_down": 1, "n_up": 1, "step": 1,
                           "scale": "linear", "min": 1, "discard": 0}}})");
  };
  // The levels are 2 and then 1, four times.
  EXPECT_EQ(word_of(track("11111"), "bound.status"), "at_lowest");
  EXPECT_THAT(sentence_of(track("11111"), "bound.status"),
              HasSubstr("4 of 5 trials are at the lowest level, so that the mean of the reversals "
                        "depends on this bound"));
  EXPECT_EQ(word_of(track("10101"), "bound.status"), "(absent)");
}

TEST(TidyRefusals, SayWhichOptionIsWrong) {
  EXPECT_THAT(family_refusal("rmanova", "subject,s,y\nA,a,1\n", R"({"within": "s"})"),
              HasSubstr("\"within\" is not an object; set it to the factors with their levels, as "
                        "{\"spacing\": [1, 2, 4]}"));
  EXPECT_THAT(family_refusal("psyfit", "condition,x,n,k\nc,1,4,2\n",
                             R"({"shape": "cauchy", "gamma": 0, "lambda": 0, "pt": 0.5})"),
              HasSubstr("\"shape\" is \"cauchy\""));
  for (const char* performance : {"0.5", "0.98", "1.5", "-1"}) {
    EXPECT_EQ(family_refusal("psyfit", "condition,x,n,k\nc,1,4,2\nc,2,4,3\n",
                             R"({"shape": "normal", "gamma": 0.5, "lambda": 0.02, "pt": )" +
                                 std::string(performance) + '}'),
              "the option \"pt\" is " + std::string(performance) +
                  "; the performance at the threshold must lie between gamma and 1 - lambda, which "
                  "are 0.5 and 0.98. Choose a value between them");
  }
  EXPECT_THAT(family_refusal("rmanova", "subject,s,y\nA,a,1\nA,b,1\nB,a,2\nB,b,4\n",
                             R"({"within": {"s": ["a", "b"]}, "type": 1})"),
              HasSubstr("\"type\" is 1"));
  EXPECT_THAT(
      family_refusal("group", "subject,group,correct,trials\nA,a,3,4\n", R"({"groups": ["a"]})"),
      HasSubstr("must name two groups, not 1; name the two groups to compare"));
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
      "NA: differences between participants cannot be estimated from one participant: add "
      "participants");
  EXPECT_EQ(why(findings_of("selection", "subject,sample,choice\nA,1,a\nB,1,a\n", choices),
                "subj.t.p.two"),
            "NA: all participants have the same proportion: add participants");
  EXPECT_EQ(why(findings_of("rating", "subject,item,score\nA,a,2\nA,b,2\nB,a,3\nB,b,3\n",
                            R"({"items": ["a", "b"]})"),
                "friedman.p"),
            "NA: all items are tied in every row, so that there is no order to test: add rows in "
            "which they differ");
  EXPECT_EQ(why(findings_of("recognition", "subject,stimulus,response\nA,y,y\nB,y,x\n", kLabels),
                "recall"),
            "NA: this stimulus was never presented, so that no trial could be correct");
}

// Two columns of the same name in the options are two things with one name: every number of them is wrong.
TEST(TidyRefusals, TakeNoNameTwice) {
  EXPECT_EQ(family_refusal("selection", "subject,sample,choice\nA,1,a\n",
                           R"({"renderers": ["a", "b", "a"], "target": "a"})"),
            "the option \"renderers\" names \"a\" twice; name it once");
  EXPECT_EQ(family_refusal("recognition", "subject,stimulus,response\nA,x,x\n",
                           R"({"labels": ["x", "x", "y"]})"),
            "the option \"labels\" names \"x\" twice; name it once");
  EXPECT_EQ(family_refusal("group", "subject,group,correct,trials\nA,a,3,4\n",
                           R"({"groups": ["a", "a"]})"),
            "the option \"groups\" names \"a\" twice; name it once");
  EXPECT_EQ(
      family_refusal("rmanova", "subject,s,y\nA,a,1\n", R"({"within": {"s": ["a", "b", "a"]}})"),
      "the option \"within.s\" names \"a\" twice; name it once");
  for (const char* family : {"paired", "ranking", "rating"}) {
    EXPECT_EQ(family_refusal(family, "subject,first,second,winner,trial,item,rank,score\n",
                             R"({"items": [1, 1, 2]})"),
              "the option \"items\" names \"1\" twice; name it once");
  }
  EXPECT_THAT(family_refusal("paired", "subject,first,second,winner\nA,a,tie,tie\n",
                             R"({"items": ["a", "tie"]})"),
              HasSubstr("names \"tie\""));
  EXPECT_THAT(
      family_refusal("recognition", "subject,stimulus,response\nA,x,x\n", R"({"labels": "x"})"),
      HasSubstr("at least two stimuli"));
}

TEST(TidyRefusals, TakeWholeRanksFromOne) {
  const char* items = R"({"items": ["a", "b"]})";
  for (const char* rank : {"0", "-1", "1.5"}) {
    EXPECT_THAT(
        family_refusal("ranking",
                       "subject,trial,item,rank\nA,1,a,2\nA,1,b," + std::string(rank) + '\n',
                       items),
        HasSubstr("t.csv:3:4: rank is " + std::string(rank) + "; it must be a whole number"));
  }
}

TEST(TidyRefusals, CountNoMoreOutcomesThanCanBeCounted) {
  const std::string head = "id,kind,n,alpha,probs\n";
  EXPECT_THAT(
      family_refusal("power", head + "one,chisq_uniform_exact,1000,0.05,0.2;0.2;0.2;0.2;0.2\n",
                     "[]"),
      HasSubstr(
          "t.csv:2:2: choices is 1000 and the number of alternatives is 5: too many outcomes"));
  EXPECT_EQ(
      family_refusal("power", head + "one,chisq_uniform_exact,60,0.05,0.25;0.25;0.25;0.25\n", "[]"),
      "");
}

TEST(TidyRefusals, SayNothingOfASampleInWhichNothingWasChosen) {
  const char* choices = R"({"renderers": ["a", "b"], "target": "a"})";
  const std::vector<Finding> one =
      findings_of("selection", "subject,sample,choice\nA,1,\nB,1,\nA,2,a\nB,2,b\n", choices);
  EXPECT_EQ(word_of(one, "status"), "no_data");
  // Numbers of nothing; of every other number it is said that there is none.
  const auto is_told = testing::AnyOf("n.valid", "status", "count", "chisq.df", "luce.addhalf",
                                      "mcnemar.b", "mcnemar.c", "mcnemar.exact.p", "subj.n");
  std::size_t of_sample = 0;
  for (const Finding& finding : one) {
    if (finding.key != "1" && finding.key[0] != "1") continue;
    ++of_sample;
    if (finding.word != "NA") {
      EXPECT_THAT(finding.quantity, is_told);
    }
  }
  EXPECT_GT(of_sample, 20U);
  const std::vector<Finding> none =
      findings_of("selection", "subject,sample,choice\nA,1,\nB,1,\n", choices);
  EXPECT_GT(none.size(), 40U) << "of the sample and of all";
  for (const Finding& finding : none) {
    if (finding.word != "NA") {
      EXPECT_THAT(finding.quantity, is_told);
    }
  }
}

TEST(TidyRefusals, CountSeveralChoicesOfAParticipantWithASample) {
  const char* choices = R"({"renderers": ["a", "b"], "target": "a"})";
  const auto repeated = [choices](const std::string& rows) {
    for (const Finding& finding :
         findings_of("selection", "subject,sample,choice\n" + rows, choices)) {
      if (finding.quantity == "choices.repeated") return finding.value.value_or(-1.0);
    }
    return 0.0;
  };
  EXPECT_EQ(repeated("A,1,a\nA,2,a\nB,1,b\nB,2,a\n"), 0.0);
  EXPECT_EQ(repeated("A,1,a\nA,1,\nB,1,b\n"), 0.0) << "one of them was not made";
  EXPECT_EQ(repeated("A,1,a\nA,1,b\nA,1,a\nB,1,b\n"), 2.0);
}

// A choice that was not made is no first one, and none that is left out.
TEST(TidyRefusals, TakeTheFirstChoiceThatWasMadeForCochransTest) {
  const std::vector<Finding> findings =
      findings_of("selection", "subject,sample,choice\nA,1,\nA,1,a\nA,2,a\nA,2,b\nB,1,b\nB,2,a\n",
                  R"({"renderers": ["a", "b"], "target": "a"})");
  std::map<std::string, double> counts{};
  for (const Finding& finding : findings) {
    if (finding.value) counts.emplace(finding.quantity, *finding.value);
  }
  EXPECT_EQ(counts.at("choices.repeated"), 1.0);
  EXPECT_EQ(counts.at("cochran.repeated"), 1.0);
  EXPECT_EQ(counts.at("cochran.n.complete"), 2.0);
}

TEST(TidyRefusals, HaveNoThresholdOfDataThatDoNotRise) {
  for (const char* rows : {"c,1,10,9\nc,2,10,7\nc,3,10,5\n", "c,1,10,5\nc,2,10,5\nc,3,10,5\n"}) {
    const std::vector<Finding> findings =
        findings_of("psyfit", std::string("condition,x,n,k\n") + rows,
                    R"({"shape": "logistic", "gamma": 0, "lambda": 0, "pt": 0.5})");
    EXPECT_EQ(word_of(findings, "status"), "not_increasing");
    EXPECT_EQ(findings.size(), 1U) << "no alpha, no standard error, no JND";
  }
}

TEST(TidyRefusals, SayThatAnIntervalHasNoEnd) {
  const std::vector<Finding> findings =
      findings_of("psyfit", "condition,x,n,k\nc,1,20,10\nc,2,20,10\nc,3,20,12\n",
                  R"({"shape": "logistic", "gamma": 0, "lambda": 0, "pt": 0.5})");
  EXPECT_EQ(word_of(findings, "alpha.profile.lower"), "unbounded");
  EXPECT_EQ(word_of(findings, "alpha.profile.upper"), "unbounded");
}

TEST(TidyRefusals, SayThatAFixedLapseRateMovesTheThreshold) {
  const std::string rows =
      "condition,x,n,k\nc,1,200,1\nc,2,200,10\nc,3,200,100\nc,4,200,180\nc,5,200,188\nc,6,200,"
      "189\nc,7,200,190\nc,8,200,189\n";
  const auto options = [](const std::string& lambda) {
    return R"({"shape": "logistic", "gamma": 0, "pt": 0.5, "bootstrap": 20, "lambda": )" + lambda +
           '}';
  };
  EXPECT_EQ(word_of(findings_of("psyfit", rows, options("0")), "lapse.status"), "sensitive");
  EXPECT_EQ(word_of(findings_of("psyfit", rows, options("0.055")), "lapse.status"), "(absent)");
  EXPECT_EQ(word_of(findings_of("psyfit", rows, options("\"free\"")), "lapse.status"), "(absent)");
  EXPECT_THAT(family_refusal("psyfit", rows,
                             R"({"shape": "logistic", "gamma": 0, "lambda": 0, "pt": 0.5,
                                 "bootstrap": 2.5})"),
              HasSubstr("\"bootstrap\" is 2.5; it must be a whole number of draws"));
}

// Responses "cannot tell" can be split only between a known number of alternatives.
TEST(TidyRefusals, NeedTheNumberOfAlternativesOfUnforcedChoices) {
  const char* options = R"({"shape": "normal", "gamma": 0, "lambda": 0, "pt": 0.5})";
  EXPECT_THAT(family_refusal("psyfit", "condition,x,n,k,unsure\nc,1,10,2,3\nc,2,10,8,0\n", options),
              HasSubstr("t.csv:2:5: responses \"cannot tell\" count as 1/m of a hit; state m"));
  EXPECT_THAT(
      family_refusal("psyfit", "condition,x,n,k,unsure,m\nc,1,10,2,3,2\nc,2,10,8,1,3\n", options),
      HasSubstr("t.csv:3:6"));
  EXPECT_THAT(
      family_refusal("psyfit", "condition,x,n,k,unsure,m\nc,1,10,8,3,2\nc,2,10,8,0,2\n", options),
      HasSubstr("t.csv:2:5: k and unsure together exceed n"));
}

// Two levels and two parameters: the function passes through both proportions.
TEST(TidyRefusals, TestNoFitWithoutDegreesOfFreedom) {
  const auto findings =
      findings_of("psyfit", "condition,x,n,k\na,1,20,11\na,2,20,16\n",
                  R"({"shape": "logistic", "gamma": 0.5, "lambda": 0.02, "pt": 0.75})");
  for (const char* const p : {"deviance.p.chisq", "deviance.p.montecarlo"}) {
    EXPECT_EQ(word_of(findings, p), "NA") << p;
  }
}

// A Weibull function of levels above 0: no limit is below them, and a threshold outside them has none.
TEST(TidyRefusals, GiveNoImpossibleLimitsOfAThreshold) {
  const char* options = R"({"shape": "weibull", "gamma": 0.5, "lambda": 0.02, "pt": 0.75})";
  const auto inside =
      findings_of("psyfit", "condition,x,n,k\nc,1,8,5\nc,2,8,4\nc,3,8,6\nc,4,8,7\n", options);
  for (const Finding& finding : inside) {
    if (finding.quantity.find("threshold") == std::string::npos) continue;
    if (finding.quantity.ends_with("lower") && finding.value) {
      EXPECT_GE(*finding.value, 0.0) << finding.quantity;
    }
  }
  const auto outside = findings_of(
      "psyfit", "condition,x,n,k\nc,1,20,11\nc,2,20,9\nc,3,20,11\nc,4,20,12\n", options);
  EXPECT_EQ(word_of(outside, "threshold.status"), "outside_range");
  for (const char* const absent :
       {"threshold.se", "threshold.delta.lower", "threshold.overdispersed.lower",
        "bootstrap.threshold.se", "bootstrap.threshold.upper"}) {
    EXPECT_EQ(word_of(outside, absent), "(absent)") << absent;
  }
}

// A threshold outside the levels rests on the form of the function alone.
TEST(TidyRefusals, SayWhereAThresholdIsNotAmongTheLevels) {
  const char* options = R"({"shape": "logistic", "gamma": 0.5, "lambda": 0.02, "pt": 0.75})";
  const std::string head = "condition,x,n,k\n";
  EXPECT_EQ(word_of(findings_of("psyfit", head + "c,1,20,10\nc,2,20,11\nc,3,20,13\n", options),
                    "threshold.status"),
            "outside_range");
  EXPECT_EQ(
      word_of(findings_of("psyfit", head + "c,1,10,5\nc,2,10,7\nc,3,10,10\nc,9,0,0\n", options),
              "threshold.status"),
      "(absent)");
}

// Scales of one, four and five participants: no spread between participants, too little, enough.
TEST(TidyRefusals, HaveNoIntervalOfAScaleOverFewerThanFiveParticipants) {
  const auto scale_of = [](const std::string& family, int people) {
    std::string rows = family == "paired" ? "subject,first,second,winner,times\n"
                                          : "subject,trial,item,rank,times\n";
    for (int person = 0; person < people; ++person) {
      const std::string who = std::to_string(person);
      const std::string more = std::to_string(2 + person % 3);
      rows += family == "paired" ? who + ",a,b,a," + more + '\n' + who + ",a,b,b,2\n"
                                 : who + ",1,a,1," + more + '\n' + who + ",1,b,," + more + '\n' +
                                       who + ",2,b,1,2\n" + who + ",2,a,,2\n";
    }
    return findings_of(family, rows, R"({"items": ["a", "b"]})");
  };
  for (const auto& [family, prefix, value] :
       {std::array{"paired", "bt", "bt.ability.sumzero.cluster"},
        std::array{"ranking", "pl", "pl.logworth.sumzero.cluster"}}) {
    for (const int people : {1, 4, 5}) {
      const std::vector<Finding> findings = scale_of(family, people);
      EXPECT_EQ(word_of(findings, std::string(prefix) + ".cluster.status"),
                people < 5 ? "too_few_participants" : "(absent)");
      for (const Finding& finding : findings) {
        if (finding.quantity == value) {
          EXPECT_EQ(finding.low.has_value(), people == 5);
        }
        if (finding.quantity == std::string(prefix) + ".se.cluster") {
          EXPECT_EQ(finding.word, people == 1 ? "NA" : "") << finding.key;
        }
      }
    }
  }
}

TEST(TidyRefusals, HaveNoClusterErrorOfAGroupWithOneParticipant) {
  std::map<std::string, std::string> words{};
  for (const Finding& finding :
       findings_of("group", "subject,group,correct,trials\nA,a,1,3\nB,a,3,3\nC,b,2,3\n", kGroups)) {
    if (finding.quantity == "glm.se.cluster") words[finding.key.text()] = finding.word;
  }
  EXPECT_EQ(words.at("intercept"), "") << "of the first group, which has two";
  EXPECT_EQ(words.at("b"), "NA");
}

TEST(TidyRefusals, HaveNoRandomInterceptsOfParticipantsWhoAreAllOrNothing) {
  const std::string head = "subject,group,correct,trials\n";
  const std::vector<Finding> findings = findings_of(
      "group", head + "A,a,3,3\nB,a,0,3\nC,a,3,3\nD,b,0,3\nE,b,3,3\nF,b,0,3\n", kGroups);
  EXPECT_EQ(word_of(findings, "mixed.status"), "no_maximum");
  for (const Finding& finding : findings) {
    const bool is_status =
        finding.quantity == "mixed.status" || finding.quantity == "mixed.boundary";
    EXPECT_TRUE(is_status || !finding.quantity.starts_with("mixed.")) << finding.quantity;
  }
  EXPECT_EQ(word_of(findings_of("group", head + "A,a,1,1\nB,a,0,1\nC,b,1,1\nD,b,0,1\n", kGroups),
                    "mixed.status"),
            "flat");
  EXPECT_EQ(word_of(findings_of("group", head + "A,a,1,3\nB,a,3,3\nC,b,0,3\nD,b,2,3\n", kGroups),
                    "mixed.status"),
            "(absent)");
}

TEST(TidyRefusals, FindNoCurveWhereAllEstimatesAreTheSame) {
  std::string rows = "subject,probe,spacing,estimate\n";
  for (const char* person : {"A", "B", "C"}) {
    for (const char* spacing : {"0.5", "1", "2", "4"}) {
      rows += std::string(person) + ",1," + spacing + ",5\n";
    }
  }
  int flat = 0;
  int undefined = 0;
  int peaks = 0;
  for (const Finding& finding : findings_of("magnitude", rows, kMagnitude)) {
    if (finding.quantity.starts_with("exponent.subject") ||
        finding.quantity == "pooled.linear.slope" || finding.quantity == "quad.cov") {
      ++flat;
      EXPECT_EQ(finding.value, 0.0) << finding.quantity;
    }
    if (finding.quantity.ends_with(".r2") || finding.quantity.starts_with("pooled.quad.vs")) {
      ++undefined;
      EXPECT_EQ(finding.word, "NA") << finding.quantity;
    }
    if (finding.quantity == "peak.status") {
      ++peaks;
      EXPECT_EQ(finding.word, "no_maximum");
    }
  }
  EXPECT_GT(flat, 0);
  EXPECT_GT(undefined, 0);
  EXPECT_EQ(peaks, 1);
}

TEST(TidyFamilies, RefuseTablesThatTheyWouldNotRead) {
  const auto refusal = [](const std::string& family, std::size_t tables) {
    TidyInput input{};
    for (std::size_t i = 0; i < tables; ++i) {
      input.tables.emplace_back("a\n1\n", "t" + std::to_string(i) + ".csv");
    }
    return refusal_of([&] { refuse_further_tables(tidy_family(family), input); });
  };
  for (const auto& [family, most] :
       {std::pair{"selection", 1}, std::pair{"group", 1}, std::pair{"magnitude", 2},
        std::pair{"psyfit", 2}, std::pair{"seedpaper", 3}}) {
    const auto tables = static_cast<std::size_t>(most);
    EXPECT_EQ(refusal(family, tables), "");
    EXPECT_THAT(refusal(family, tables + 1),
                testing::StartsWith("t" + std::to_string(most) + ".csv: " + family + " takes "));
  }
}

TEST(TidyFamilies, RefuseAnOptionThatTheyDoNotHaveAndSayWhichIsMeant) {
  const auto refusal = [](const std::string& family, const std::string& option) {
    FamilyOptions options{};
    options.add(option, "x");
    return refusal_of<std::runtime_error>(
        [&] { refuse_unknown_options(tidy_family(family), options); });
  };
  EXPECT_EQ(refusal("rating", "item"), "rating has no option \"item\"; did you mean \"items\"?");
  EXPECT_EQ(refusal("rating", "target"),
            "rating has no option \"target\"; choose one of: items (all that were rated), conf; "
            "parts: all, items");
  EXPECT_EQ(refusal("power", "conf"), "power has no option \"conf\"; leave it out");
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

TEST(TidyRefusals, NameTheFileAndTheNumberThatIsTooLarge) {
  EXPECT_THAT(family_refusal("rating", "subject,item,score\nA,a,6\n", R"({"conf": 1e400})"),
              testing::AllOf(testing::StartsWith("options: "), HasSubstr("too large, '1e400'")));
  TidyInput input{};
  for (const char* name : {"1.csv", "2.csv", "3.csv"}) {
    input.tables.emplace_back("exp,renderer,count\nfirst,image,2147483648\nfirst,b,3\n", name);
  }
  EXPECT_EQ(refusal_of([&] { tidy_family("seedpaper").findings(input); }),
            "1.csv:2:3: count is 2147483648; it must be a whole number from 0 to 1000000");
}

// The interval of DeLong exceeds 1 for this area, which no area can.
TEST(TidyRefusals, TruncateTheIntervalOfAnAreaUnderTheRoc) {
  const std::vector<Finding> findings =
      findings_of("roc", "condition,rating,noise,signal\nc,1,9,0\nc,2,1,1\nc,3,0,9\n", "{}");
  for (const Finding& finding : findings) {
    if (finding.quantity != "auc") continue;
    ASSERT_TRUE(finding.value && finding.low && finding.high);
    EXPECT_LT(*finding.value, 1.0);
    EXPECT_EQ(*finding.high, 1.0);
    EXPECT_THAT(finding.method, HasSubstr("truncated"));
  }
}

}  // namespace
}  // namespace asperity
