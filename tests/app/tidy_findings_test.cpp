// Options of an analysis, and its findings for people and programs.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/choices/decision_rules.h"
#include "analysis/choices/forced_choice.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/cli/output/analysis_output.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST(FamilyOptions, AreReadFromJson) {
  const FamilyOptions options = FamilyOptions::of_json(
      R"({"items": ["b", "a"], "step": 2, "free": "yes", "none": null,
          "within": {"spacing": ["0.5", 1], "probe": "x"}})",
      "case.json");
  EXPECT_THAT(options.texts("items"), ElementsAre("b", "a"));
  EXPECT_THAT(options.numbers("step"), ElementsAre(2.0));
  EXPECT_EQ(options.text("free"), "yes");
  EXPECT_FALSE(options.has("none"));
  EXPECT_EQ(options.number_or("none", 3.0), 3.0);
  EXPECT_EQ(options.confidence(), 0.95);
  EXPECT_THAT(options.levels("within"), ElementsAre(Pair("spacing", ElementsAre("0.5", "1")),
                                                    Pair("probe", ElementsAre("x"))));
  EXPECT_FALSE(FamilyOptions::of_json("[]", "case.json").has("items"));
}

TEST(FamilyOptions, AreSetAsValues) {
  FamilyOptions options{};
  options.set("margin", 0.1);
  options.set("parts", std::string("12"));
  options.set("items", std::vector<std::string>{"1", "a,b"});
  options.set("within", {{"spacing", {"0.001", "0.002"}}, {"condition", {"slow"}}});
  EXPECT_EQ(options.number("margin"), 0.1);
  EXPECT_EQ(options.text("parts"), "12");
  EXPECT_EQ(options.texts("items"), (std::vector<std::string>{"1", "a,b"}));
  EXPECT_EQ(options.levels("within").front().first, "spacing");
  EXPECT_EQ(options.levels("within").back().second, std::vector<std::string>{"slow"});
}

TEST(FamilyOptions, AreReadFromTheCommandLine) {
  FamilyOptions options{};
  options.add("items", "wood,2,metal");
  options.add("conf", "0.9");
  options.add("target", "metal");
  options.add("target", "metal");
  EXPECT_EQ(refusal_of<std::runtime_error>([&] { options.add("target", "wood"); }),
            "the option \"target\" is given twice, as metal and as wood; give it once");
  options.add("within", R"({"a": ["x", "y"]})");
  EXPECT_THAT(options.texts("items"), ElementsAre("wood", "2", "metal"));
  EXPECT_EQ(options.confidence(), 0.9);
  options.add("lower", "-.3");
  EXPECT_EQ(options.number("lower"), -0.3);
  EXPECT_EQ(options.text("target"), "metal");
  EXPECT_THAT(options.levels("within"), ElementsAre(Pair("a", ElementsAre("x", "y"))));
}

TEST(FamilyOptions, AreRefusedInSentences) {
  FamilyOptions options{};
  options.add("conf", "95");
  options.add("target", "wood");
  EXPECT_EQ(refusal_of<std::runtime_error>([&] { options.texts("items"); }),
            "the option \"items\" is missing and has no default; give it a value");
  EXPECT_EQ(refusal_of<std::runtime_error>([&] { options.number("target"); }),
            "the option \"target\" is not a number; set it to a number");
  EXPECT_EQ(refusal_of<std::runtime_error>([&] { options.confidence(); }),
            "the option \"conf\" is 95; it must lie between 0 and 1");
  EXPECT_THAT(refusal_of<std::runtime_error>([] { FamilyOptions::of_json("{", "o.json"); }),
              AllOf(HasSubstr("o.json: the options are not valid JSON"), HasSubstr("line 1"),
                    testing::Not(HasSubstr("json.exception"))));
}

TEST(FamilyOptions, AreRefusedWhereTheyContradictThemselves) {
  EXPECT_EQ(refusal_of<std::runtime_error>(
                [] { FamilyOptions::of_json(R"({"conf": 0.9, "conf": 0.5})", "o.json"); }),
            "o.json: the options have the key \"conf\" twice in one object; keep one");
  FamilyOptions options = FamilyOptions::of_json(R"({"conf": 0.99})", "o.json");
  options.add("conf", "0.9");  // instead of that of the file
  options.add("conf", "0.9");
  EXPECT_EQ(options.confidence(), 0.9);
  EXPECT_EQ(refusal_of<std::runtime_error>([&] { options.add("conf", "0.5"); }),
            "the option \"conf\" is given twice, as 0.9 and as 0.5; give it once");
}

TEST(FamilyOptions, KnowWhichNobodyAskedFor) {
  FamilyOptions options{};
  options.add("conf", "0.9");
  options.add("confidence", "0.9");
  options.confidence();
  EXPECT_THAT(options.never_asked_for(), ElementsAre("confidence"));
}

TidyInput input_of(const std::string& table, const std::string& options) {
  TidyInput input{};
  input.tables.emplace_back(table, "table.csv");
  input.options = FamilyOptions::of_json(options, "options");
  return input;
}

TableFindings ratings() {
  const TidyInput input = input_of("subject,item,score\nx,new,3\nx,old,1\ny,new,2\ny,old,2\n",
                                   R"({"items": ["new", "old"]})");
  return {.kind = "rating", .files = {"table.csv"}, .findings = rating_findings(input)};
}

TEST(TableFindings, StandWithKeysDownAndQuantitiesAcross) {
  const std::string text = display_text_of(ratings());
  EXPECT_THAT(text, HasSubstr("rating: table.csv\n"));
  EXPECT_THAT(text, testing::ContainsRegex("key  mean\\.score  mean\\.score interval  mean\\.rank\n"
                                           "new  2\\.5         \\[−3\\.853, 8\\.853\\] +1\\.75\n"));
  EXPECT_THAT(text, HasSubstr("friedman.chisq    1\n"));
  EXPECT_THAT(text, HasSubstr("friedman.chisq, friedman.df, friedman.p: Friedman's test"));
}

TEST(TableFindings, TellWhatIsLeftOutOfRatings) {
  EXPECT_THAT(display_text_of(ratings()), testing::Not(HasSubstr("left out")));
  const TidyInput input = input_of("subject,item,score\nx,new,3\nx,old,1\ny,new,2\nz,old,\n",
                                   R"({"items": ["new", "old"]})");
  const std::string text =
      display_text_of(TableFindings{.kind = "rating", .findings = rating_findings(input)});
  EXPECT_THAT(text, testing::ContainsRegex("n\\.complete +1\n"));
  EXPECT_THAT(text, testing::ContainsRegex("n\\.incomplete +2\n"));
}

std::string findings_text(const std::string& family, const TidyInput& input) {
  return display_text_of(
      TableFindings{.kind = family, .findings = tidy_family(family).findings(input)});
}

constexpr const char* kTips = R"({"within": {"tip": ["a", "b", "c"]}})";
constexpr const char* kTipRows =
    "subject,tip,y\nA,a,1\nA,b,2\nA,c,4\nB,a,3\nB,b,7\nB,c,5\nC,a,2\nC,b,4\nC,c,9\n";

TEST(TableFindings, TellWhichRowsAreAveraged) {
  const std::string single = findings_text("rmanova", input_of(kTipRows, kTips));
  EXPECT_THAT(single, testing::ContainsRegex("key  cells\\.with\\.k\n1    9\n"));
  EXPECT_THAT(single, testing::ContainsRegex("replicates +none\n"));
  const std::string stray =
      findings_text("rmanova", input_of(kTipRows + std::string("B,c,1\n"), kTips));
  EXPECT_THAT(stray, testing::ContainsRegex("key  cells\\.with\\.k\n1    8\n2    1\n"));
  EXPECT_THAT(
      stray,
      HasSubstr(
          "! unequal: B has 2 values in the cell c, while 8 of 9 cells have 1 value. The values of "
          "a cell are averaged: check whether a row occurs twice, or has the "
          "wrong participant or cell"));
  std::string twice = kTipRows;
  for (const char* row :
       {"A,a,2", "A,b,1", "A,c,4", "B,a,4", "B,b,4", "B,c,5", "C,a,1", "C,b,4", "C,c,8"}) {
    twice += std::string(row) + '\n';
  }
  const std::string equal = findings_text("rmanova", input_of(twice, kTips));
  EXPECT_THAT(equal, testing::ContainsRegex("key  cells\\.with\\.k\n2    9\n"));
  EXPECT_THAT(equal, testing::ContainsRegex("replicates +equal\n"));
  EXPECT_THAT(equal, testing::Not(HasSubstr("! ")));
  const std::string estimates = findings_text(
      "magnitude",
      input_of("subject,probe,spacing,estimate\nA,p,1,2\nA,p,2,5\nA,p,4,3\nA,p,4,4\nB,p,1,1\n"
               "B,p,2,3\nB,p,4,2\nB,p,4,3\nB,p,1,2\nB,p,2,3\nA,p,1,2\n",
               R"({"zero_rule": "exclude", "normalisation": "geomean"})"));
  EXPECT_THAT(estimates,
              HasSubstr("! unequal: A has 1 value in the cell p|2, while 5 of 6 cells have 2 "
                        "values. The values of a cell are averaged: check whether a row is missing "
                        "or has no value that counts, or has the wrong "
                        "participant or cell"));
}

TEST(TableFindings, CountTheChoicesThatCochransTestLeavesOut) {
  const std::string text = findings_text(
      "selection", input_of("subject,sample,choice\nx,1,a\nx,2,b\nx,1,b\ny,1,a\ny,2,a\n",
                            R"({"renderers": ["a", "b"], "target": "a"})"));
  EXPECT_THAT(text, HasSubstr("cochran.repeated"));
}

// The least possible epsilon is no interval, and an interval has both its ends.
TEST(TableFindings, CallAnIntervalWhatHasBothEnds) {
  const std::string anova = findings_text("rmanova", input_of(kTipRows, kTips));
  EXPECT_THAT(anova, HasSubstr("eps.lower"));
  EXPECT_THAT(anova, HasSubstr("p.lower"));
  EXPECT_THAT(anova, testing::Not(HasSubstr("eps interval")));
  EXPECT_THAT(anova, testing::Not(HasSubstr("p interval")));
  EXPECT_THAT(anova, testing::Not(testing::ContainsRegex("\\[[-.0-9e]+( |\n)")));
  EXPECT_THAT(anova, HasSubstr("cell.mean interval"));
  const std::string estimates = findings_text(
      "magnitude", input_of("subject,probe,spacing,estimate\nA,p,1,2\nA,p,2,5\nB,p,1,1\nB,p,2,4\n",
                            R"({"zero_rule": "exclude", "normalisation": "geomean"})"));
  EXPECT_THAT(estimates, HasSubstr("geomean.ci interval"));
  EXPECT_THAT(estimates, HasSubstr("geomean.ci.morey interval"));
  EXPECT_THAT(estimates, testing::Not(HasSubstr("upper.morey ")));
  EXPECT_THAT(estimates, testing::Not(HasSubstr("geomean interval"))) << "said by geomean.ci";
}

TEST(TableFindings, HaveTheIntervalsThatTheirMethodsPromise) {
  const std::string groups = findings_text(
      "group", input_of("subject,group,correct,trials\nA,f,6,10\nB,f,8,10\nC,m,5,10\nD,m,4,10\n",
                        R"({"groups": ["f", "m"]})"));
  EXPECT_THAT(groups, testing::ContainsRegex("f .* 0\\.7 +\\[0\\.0[0-9]+, 0\\.9[0-9]+\\]"));
  EXPECT_THAT(groups,
              testing::ContainsRegex("subj\\.diff interval +\\[−0\\.[0-9]+, 0\\.[0-9]+\\]\n"));
  const std::string ratings =
      findings_text("rating", input_of("subject,item,score\nx,new,3\nx,old,1\ny,new,2\ny,old,2\n",
                                       R"({"items": ["new", "old"]})"));
  EXPECT_THAT(ratings, HasSubstr("mean.score: mean of the participants; t interval"));
  const std::string pairs = findings_text(
      "paired", input_of("subject,first,second,winner\nx,a,b,a\nx,b,a,b\ny,a,b,a\ny,b,a,a\n",
                         R"({"items": ["a", "b"]})"));
  EXPECT_THAT(pairs, HasSubstr("bt.ability interval"));
  EXPECT_THAT(pairs, HasSubstr("bt.ability: Bradley–Terry, ties left out, relative to a, "
                               "judgements treated as independent; Wald interval"));
  EXPECT_LT(pairs.find("bt.ability.sumzero.cluster"), pairs.find("bt.ability.sumzero "));
  EXPECT_LT(pairs.find("bt.worth"), pairs.find("bt.ability interval"));
}

TEST(TableFindings, StopWhereNobodyReadsOnAndSayHowManyThereAre) {
  std::string rows = "subject,trial,stimulus,response\n";
  for (int person = 1; person <= 201; ++person) rows += std::to_string(person) + ",1,a,a\n";
  const TidyInput input = input_of(rows, "{}");
  const TableFindings findings{.kind = "matching", .findings = matching_findings(input)};
  const std::string text = display_text_of(findings);
  EXPECT_THAT(text, HasSubstr("\n100 "));
  EXPECT_THAT(text, testing::Not(HasSubstr("\n101 ")));
  EXPECT_THAT(text, HasSubstr("… and 101 more rows; --json prints all rows\n"));
  EXPECT_THAT(findings_json(findings), HasSubstr("\"key\": \"201\""));
}

// Of four shares, 1, 1, 1 and 0.5, Student's interval goes beyond 1.
TEST(TableFindings, EndTheIntervalOfAMeanShareWhereSharesEnd) {
  const TidyInput input = input_of(
      "subject,stimulus,response\nA,x,x\nA,y,y\nB,x,x\nB,y,y\nC,x,x\nC,y,y\nD,x,x\nD,y,x\n",
      R"({"labels": ["x", "y"]})");
  const TableFindings findings{.kind = "recognition", .findings = recognition_findings(input)};
  EXPECT_THAT(display_text_of(findings),
              testing::ContainsRegex("subj\\.ci interval +\\[0\\.4772, 1\\]\n"));
  EXPECT_THAT(display_text_of(findings), HasSubstr("subj.mean interval"));
  EXPECT_THAT(findings_json(findings), HasSubstr("1.27")) << "uncut for who compares it";
}

TEST(TableFindings, AreOneJsonDocument) {
  const std::string json = findings_json(ratings());
  EXPECT_EQ(json.find("{\n  \"format\": \"asperity.findings/1\""), 0U);
  EXPECT_THAT(json, HasSubstr("\"quantity\": \"mean.rank\""));
  EXPECT_THAT(json, HasSubstr("\"value\": 1.75"));
}

TEST(TableFindings, SayWhyThereIsNoNumber) {
  const TidyInput input = input_of("id,k,n,p0\nnobody,0,0,0.5\n", "{}");
  const TableFindings findings{.kind = "proportion", .findings = proportion_findings(input)};
  EXPECT_THAT(display_text_of(findings),
              HasSubstr("! no_data: n is 0, so that nothing can be estimated"));
}

// The trials of no reversal are an empty word.
TEST(TableFindings, NameTheQuantityOfAStatusWithoutAWord) {
  const TidyInput input = input_of("track,trial,response\nleft,1,1\nleft,2,1\n",
                                   R"({"tracks": {"left": {"start": 5, "n_down": 2, "n_up": 1,
                                       "step": 1, "scale": "linear", "discard": 0}}})");
  const TableFindings findings{.kind = "staircase", .findings = staircase_findings(input)};
  EXPECT_THAT(display_text_of(findings),
              HasSubstr("\n! reversal.trials left: the track has no reversal: run more trials\n"));
}

TEST(TidyFamilies, RefuseWhatCannotBeWithLineAndColumn) {
  EXPECT_EQ(refusal_of<std::runtime_error>(
                [] { proportion_findings(input_of("id,k,n,p0\na,3,2,0.5\n", "{}")); }),
            "table.csv:2:2: k is 3 and n is 2; k must be at most n");
  EXPECT_EQ(refusal_of<std::runtime_error>([] {
              paired_findings(input_of("subject,first,second,winner\nx,a,b,c\n",
                                       R"({"items": ["a", "b", "c"]})"));
            }),
            "table.csv:2:4: winner is \"c\", which is not one of the two items compared; it must "
            "be one of them or tie");
  EXPECT_EQ(refusal_of<std::runtime_error>([] {
              ranking_findings(input_of("subject,trial,item,rank\nx,1,a,1\nx,1,b,1\n",
                                        R"({"items": ["a", "b"]})"));
            }),
            "table.csv:3:4: the rank 1 occurs twice in its trial; give each item its own rank, or "
            "analyse tied items with the family \"rating\"");
  EXPECT_EQ(
      refusal_of<std::runtime_error>([] {
        selection_findings(input_of("subject,sample,choice\nx,1,a\n",
                                    R"({"renderers": ["a", "b"], "target": "c"})"));
      }),
      "the option \"target\" is \"c\", which \"renderers\" does not name; choose one of them");
}

TEST(TidyFamilies, AnswerOneParticipantAndOneRow) {
  EXPECT_FALSE(selection_findings(input_of("subject,sample,choice\nx,1,a\n",
                                           R"({"renderers": ["a", "b"], "target": "a"})"))
                   .empty());
  EXPECT_FALSE(
      matching_findings(input_of("subject,trial,stimulus,response\nx,1,a,\n", "{}")).empty());
  EXPECT_FALSE(paired_findings(
                   input_of("subject,first,second,winner\nx,a,b,a\n", R"({"items": ["a", "b"]})"))
                   .empty());
  EXPECT_FALSE(
      ranking_findings(input_of("subject,trial,item,rank\nx,1,a,1\n", R"({"items": ["a", "b"]})"))
          .empty());
  EXPECT_FALSE(
      rating_findings(input_of("subject,item,score\nx,a,1\n", R"({"items": ["a", "b"]})")).empty());
}

TEST(TidyFamilies, AnswerTablesWithoutARowOrRefuseThem) {
  EXPECT_TRUE(proportion_findings(input_of("id,k,n,p0\n", "{}")).empty());
  EXPECT_FALSE(selection_findings(input_of("subject,sample,choice\n",
                                           R"({"renderers": ["a", "b"], "target": "a"})"))
                   .empty());
  EXPECT_THAT(refusal_of<std::runtime_error>(
                  [] { matching_findings(input_of("subject,trial,stimulus,response\n", "{}")); }),
              HasSubstr("has no trial"));
  EXPECT_FALSE(
      paired_findings(input_of("subject,first,second,winner\n", R"({"items": ["a", "b"]})"))
          .empty());
  EXPECT_FALSE(
      ranking_findings(input_of("subject,trial,item,rank\n", R"({"items": ["a", "b"]})")).empty());
  EXPECT_FALSE(
      rating_findings(input_of("subject,item,score\n", R"({"items": ["a", "b"]})")).empty());
}

double value_of(const std::vector<Finding>& findings, const std::string& quantity,
                const std::string& key) {
  for (const Finding& finding : findings) {
    if (finding.quantity == quantity && finding.key == key) return finding.value.value();
  }
  throw std::runtime_error("no finding " + quantity);
}

// A table of counts says what a table of single trials says.
// The numbers are those of equivalence_test.cpp and effect_size_test.cpp of the same values.
TEST(TidyFamilies, CompareTwoSamplesForEquivalence) {
  const std::string table =
      "subject,group,value\na,x,5\nb,x,7\nc,x,8\nd,x,6\ne,x,9\n"
      "f,y,6\ng,y,9\nh,y,7\ni,y,11\nj,y,8\nk,y,10\nl,y,7\nm,y,\n";
  const auto tested =
      equivalence_findings(input_of(table, R"({"groups": ["x", "y"], "lower": -3, "upper": 3})"));
  EXPECT_NEAR(value_of(tested, "tost.p", ""), 0.0564843604938138, 1e-12);
  EXPECT_NEAR(value_of(tested, "equivalence.margin", ""), 3.07473095602759, 1e-11);
  EXPECT_NEAR(value_of(tested, "jzs.bf10", "0.7071"), 0.773757847439147, 1e-10);
  EXPECT_NEAR(value_of(tested, "cohen.d.ci.lower", ""), -1.92491586125751, 1e-8);
  EXPECT_NEAR(value_of(tested, "hedges.g.ci.upper", ""), 0.42460597382058, 1e-8);
  EXPECT_EQ(value_of(tested, "n.incomplete", ""), 1.0);
  const auto described = equivalence_findings(input_of(table, R"({"groups": ["x", "y"]})"));
  EXPECT_NEAR(value_of(described, "equivalence.margin", ""), 3.07473095602759, 1e-11);
  EXPECT_TRUE(std::none_of(described.begin(), described.end(), [](const Finding& finding) {
    return finding.quantity == "equivalent" || finding.quantity == "tost.p";
  })) << "there is no verdict without bounds";
}

TEST(TidyFamilies, CompareOneSampleWithNothing) {
  const auto found = equivalence_findings(
      input_of("subject,value\na,1\nb,2\nc,3\n", R"({"lower": -9, "upper": 9})"));
  EXPECT_NEAR(value_of(found, "t", ""), 2.0 * std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(value_of(found, "dz", ""), 2.0, 1e-14);
}

TEST(TidyFamilies, LeaveOutTargetsThatNotAllRatersScored) {
  const std::string complete = "target,rater,score\nx,A,1\nx,B,2\ny,A,4\ny,B,3\nz,A,6\nz,B,7\n";
  const auto all = icc_findings(input_of(complete, "{}"));
  const auto more = icc_findings(input_of(complete + "v,A,9\nw,A,5\nw,B,\n", "{}"));
  EXPECT_EQ(value_of(more, "n.targets", ""), 3.0);
  EXPECT_EQ(value_of(more, "n.incomplete", ""), 2.0);
  EXPECT_EQ(value_of(more, "icc", "ICC2"), value_of(all, "icc", "ICC2"));
}

// The corrected d′ of a and b are z(8.5/11) − z(2.5/11) = 1.496 and z(6.5/11) − z(3.5/11) = 0.702.
TEST(TidyFamilies, AverageTheSensitivityOverParticipantsWithAnIntervalFromThem) {
  const std::string header = "id,subject,design,signal_yes,signal_n,noise_yes,noise_n\n";
  std::string table = header;
  for (const char* const subject : {"a", "c", "e"}) {
    table += std::string("x,") + subject + ",yesno,8,10,2,10\n";
  }
  for (const char* const subject : {"b", "d", "f"}) {
    table += std::string("x,") + subject + ",yesno,6,10,3,10\n";
  }
  const auto found = dprime_findings(input_of(table, "{}"));
  EXPECT_NEAR(value_of(found, "dprime.loglinear", "x|a"), 1.496, 1e-3);
  EXPECT_NEAR(value_of(found, "dprime.mean", "x"), 0.5 * (1.496 + 0.702), 1e-3);
  const auto mean = std::find_if(found.begin(), found.end(), [](const Finding& finding) {
    return finding.quantity == "dprime.mean";
  });
  // t of five degrees of freedom, 1.099 ± 2.571·0.4349/√6, but for the 64 different resamples.
  ASSERT_TRUE(mean->low && mean->high);
  EXPECT_NEAR(*mean->low, 0.642, 0.15);
  EXPECT_NEAR(*mean->high, 1.556, 0.15);
  EXPECT_GE(*mean->low, 0.702 - 1e-3) << "no resample leaves the range of the participants";
  const auto few =
      dprime_findings(input_of(header + "x,a,yesno,8,10,2,10\nx,b,yesno,6,10,3,10\n", "{}"));
  for (const Finding& finding : few) {
    if (finding.quantity != "dprime.mean") continue;
    EXPECT_FALSE(finding.low) << "of two participants";
  }
}

// (20 + 1/3)/21 and (10 + 1/3)/21 correct: the first participant has no error, and d′ is finite.
TEST(TidyFamilies, AverageTheSensitivityOfChoicesAmongThreeOverParticipants) {
  std::string table = "id,subject,design,signal_yes,signal_n,m\n";
  for (const char* const subject : {"a", "c", "e"}) {
    table += std::string("x,") + subject + ",mafc,20,20,3\ny," + subject + ",oddity,20,20,\n";
  }
  for (const char* const subject : {"b", "d", "f"}) {
    table += std::string("x,") + subject + ",mafc,10,20,3\ny," + subject + ",oddity,10,20,\n";
  }
  const auto found = dprime_findings(input_of(table, "{}"));
  const auto mean_of = [](const auto& dprime) {
    return 0.5 * (dprime((20.0 + 1.0 / 3.0) / 21.0) + dprime((10.0 + 1.0 / 3.0) / 21.0));
  };
  EXPECT_NEAR(value_of(found, "dprime.mean", "x"),
              mean_of([](double p) { return ForcedChoice{.alternatives = 3}.dprime(p); }), 1e-9);
  EXPECT_NEAR(value_of(found, "dprime.mean", "y"),
              mean_of([](double p) { return Oddity{}.dprime(p); }), 1e-9);
  for (const Finding& finding : found) {
    const bool is_mean = finding.quantity == "dprime.mean";
    EXPECT_TRUE(!is_mean || (finding.low && finding.high));
  }
  const auto guessing =
      dprime_findings(input_of("id,subject,design,signal_yes,signal_n,m\nx,a,mafc,2,6,3\n", "{}"));
  EXPECT_NEAR(value_of(guessing, "dprime.mean", "x"), 0.0, 1e-9) << "not moved away from 0";
}

// Exactly: a rounding error would be printed as d′ = −2.1e−16.
TEST(TidyFamilies, GiveChoicesAtChanceASensitivityOfZero) {
  const auto found = dprime_findings(input_of(
      "id,design,signal_yes,signal_n,m\nx,mafc,2,6,3\ny,mafc,7,21,3\nz,mafc,25,100,4\n", "{}"));
  for (const char* const condition : {"x", "y", "z"}) {
    EXPECT_EQ(value_of(found, "dprime", condition), 0.0) << condition;
  }
}

// Participants whose criteria differ: their pooled area is too small, and only the mean of their own areas has an interval.
TEST(TidyFamilies, GiveTheMeanOfTheAreasAndNotThePooledAreaAnInterval) {
  std::string table = "condition,subject,rating,noise,signal\n";
  for (const char* const subject : {"a", "b", "c", "d", "e"}) {
    for (const char* const counts : {"1,9,3", "2,6,5", "3,4,7", "4,1,5"}) {
      table += std::string("x,") + subject + ',' + counts + '\n';
    }
  }
  table += "x,f,1,10,3\nx,f,2,6,5\nx,f,3,3,7\nx,f,4,1,5\n";
  const auto found = roc_findings(input_of(table, "{}"));
  const auto area = std::find_if(found.begin(), found.end(), [](const Finding& finding) {
    return finding.quantity == "uv.az";
  });
  ASSERT_NE(area, found.end());
  EXPECT_EQ(area->n, 240U) << "trials";
  EXPECT_FALSE(area->low || area->high);
  const auto mean = std::find_if(found.begin(), found.end(), [](const Finding& finding) {
    return finding.quantity == "uv.az.mean";
  });
  ASSERT_NE(mean, found.end());
  EXPECT_EQ(mean->n, 6U);
  EXPECT_TRUE(mean->low && mean->high);
  for (const Finding& finding : found) {
    if (finding.quantity == "auc" || finding.quantity == "uv.mu" || finding.quantity == "ev.mu") {
      EXPECT_FALSE(finding.low || finding.high) << finding.quantity;
    }
    if (finding.quantity == "auc.mean") {
      EXPECT_EQ(finding.n, 6U);
      EXPECT_TRUE(finding.low && finding.high);
    }
    EXPECT_FALSE(finding.quantity == "auc.lower" || finding.quantity == "auc.upper");
  }
  EXPECT_EQ(value_of(found, "n.signal", "x"), 120.0);
}

// Two participants with the same sensitivity and criteria two standard deviations apart: pooled, their noise and signal overlap more.
TEST(TidyFamilies, AverageTheAreasOfParticipantsWithDifferentCriteria) {
  std::string table = "condition,subject,rating,noise,signal\n";
  for (const char* const row : {"a,1,50,16", "a,2,34,34", "a,3,14,34", "a,4,2,16"}) {
    table += std::string("x,") + row + '\n';
  }
  for (const char* const row : {"b,1,2,0", "b,2,14,2", "b,3,34,14", "b,4,50,84"}) {
    table += std::string("x,") + row + '\n';
  }
  const auto found = roc_findings(input_of(table, "{}"));
  const auto alone = [](const std::string& rows) {
    return roc_findings(input_of("condition,rating,noise,signal\n" + rows, "{}"));
  };
  const auto first = alone("x,1,50,16\nx,2,34,34\nx,3,14,34\nx,4,2,16\n");
  const auto second = alone("x,1,2,0\nx,2,14,2\nx,3,34,14\nx,4,50,84\n");
  for (const char* const quantity : {"uv.az", "auc"}) {
    const double mean = 0.5 * (value_of(first, quantity, "x") + value_of(second, quantity, "x"));
    EXPECT_NEAR(value_of(found, std::string(quantity) + ".mean", "x"), mean, 1e-12);
  }
  EXPECT_GT(value_of(found, "uv.az.mean", "x"), value_of(found, "uv.az", "x"));
  EXPECT_GT(value_of(found, "auc.mean", "x"), value_of(found, "auc", "x"));
}

// Ten trials of each kind that the ratings separate are also compatible with a smaller area: an interval [1, 1] is not one.
TEST(TidyFamilies, GiveNoIntervalOfAnAreaAtItsEndOrWithoutVariance) {
  for (const auto& [rows, reason] :
       {std::pair("a,1,10,0\na,2,0,10\n", "the coverage of the interval of the area alone is 0 %"),
        std::pair("a,1,10,3\na,2,0,7\n", "lacks the part of trials that all have the same")}) {
    const auto found =
        roc_findings(input_of(std::string("condition,rating,noise,signal\n") + rows, "{}"));
    for (const Finding& finding : found) {
      if (finding.quantity != "auc" && !finding.quantity.starts_with("auc.")) continue;
      EXPECT_FALSE(finding.low || finding.high) << rows;
      if (finding.quantity == "auc") {
        EXPECT_THAT(finding.method, HasSubstr(reason));
      }
      EXPECT_FALSE(finding.quantity.ends_with("lower") || finding.quantity.ends_with("upper"));
    }
  }
}

// The responses and numbers of crossed_binomial_test.cpp.
TEST(TidyFamilies, FitParticipantsAndItemsAsCrossed) {
  const std::string hits = "1233231122333221121213113332332323333322232323223333333322112332";
  std::string table = "subject,item,condition,correct,trials\n";
  for (std::size_t i = 0; i < hits.size(); ++i) {
    table += "P" + std::to_string(i / 8) + ",T" + std::to_string(i / 2 % 4) +
             (i % 2 == 0 ? ",plain," : ",masked,") + hits[i] + ",3\n";
  }
  const auto found = glmm_findings(
      input_of(table, R"({"fixed": {"condition": ["plain", "masked"]}, "chance": 0.25})"));
  EXPECT_NEAR(value_of(found, "glmm.beta", "condition|masked"), 0.546906472, 1e-7);
  EXPECT_NEAR(value_of(found, "glmm.se", "intercept"), 0.4837842, 2e-6);
  EXPECT_NEAR(value_of(found, "glmm.sigma", "item"), 0.461973039, 1e-7);
  EXPECT_NEAR(value_of(found, "glmm.z", "intercept"), (1.200993899 + std::log(3.0)) / 0.4837842,
              1e-4);
  EXPECT_NEAR(value_of(found, "glmm.proportion", ""), 1.0 / (1.0 + std::exp(-1.200993899)), 1e-7);
  EXPECT_GT(value_of(found, "glmm.lr", "condition"), 0.0);
  // Wald's: 1.959964 standard errors to either side, on the scale of the logits.
  const auto interval_of = [&found](const std::string& quantity) {
    const auto one = std::find_if(found.begin(), found.end(), [&quantity](const Finding& finding) {
      return finding.quantity == quantity;
    });
    return std::pair(one->low.value(), one->high.value());
  };
  const double half = 1.959963985 * 0.4837842;
  const auto [low, high] = interval_of("glmm.beta");
  EXPECT_NEAR(low, 1.200993899 - half, 1e-5);
  EXPECT_NEAR(high, 1.200993899 + half, 1e-5);
  const auto [least, most] = interval_of("glmm.proportion");
  EXPECT_NEAR(least, 1.0 / (1.0 + std::exp(-1.200993899 + half)), 1e-5);
  EXPECT_NEAR(most, 1.0 / (1.0 + std::exp(-1.200993899 - half)), 1e-5);
  const auto probit = glmm_findings(
      input_of(table, R"({"fixed": {"condition": ["plain", "masked"]}, "link": "probit"})"));
  EXPECT_NEAR(value_of(probit, "glmm.beta", "intercept"), 0.718190575, 1e-7);
}

TEST(TidyFamilies, GiveTheAverageProportionOfOtherParticipantsAndItemsByT) {
  std::string table = "subject,item,correct,trials\n";
  const std::string hits = "12331223213312321133223313230233";
  for (std::size_t i = 0; i < hits.size(); ++i) {
    table += "P" + std::to_string(i / 4) + ",T" + std::to_string(i % 4) + ',' + hits[i] + ",3\n";
  }
  const auto found = glmm_findings(input_of(table, R"({"chance": 0.25, "random": ["item"]})"));
  const double df = 3.0;  // of 4 items
  EXPECT_EQ(value_of(found, "glmm.t.df", "intercept"), df);
  const double t = value_of(found, "glmm.t", "intercept");
  EXPECT_EQ(value_of(found, "glmm.t.p", "intercept"), *two_sided_tail({.value = t, .df = df}));
  EXPECT_LT(t, value_of(found, "glmm.z", "intercept"));
  const double intercept = value_of(found, "glmm.beta", "intercept");
  const double half = *t_limit({.df = df}) * (intercept + std::log(3.0)) / t;
  const auto proportion = std::find_if(found.begin(), found.end(), [](const Finding& finding) {
    return finding.quantity == "glmm.proportion";
  });
  ASSERT_TRUE(proportion != found.end() && proportion->low);
  EXPECT_NEAR(*proportion->low, 1.0 / (1.0 + std::exp(-intercept + half)), 1e-9);
}

TEST(TidyFamilies, ReferTheLikelihoodRatioOfTwoGroupsToF) {
  const std::string table =
      "subject,group,correct,trials\na,x,3,9\nb,x,5,9\nc,x,8,9\nd,y,4,9\ne,y,8,9\nf,y,9,9\n";
  const auto found = group_findings(input_of(table, R"({"groups": ["x", "y"]})"));
  EXPECT_EQ(value_of(found, "mixed.lr.group.F.p", ""),
            *upper_tail(FStatistic{
                .value = value_of(found, "mixed.lr.group", ""), .df1 = 1.0, .df2 = 4.0}));
  EXPECT_GT(value_of(found, "mixed.lr.group.F.p", ""), value_of(found, "mixed.lr.group.p", ""));
}

TEST(TidyFamilies, TakeRowsThatStandForSeveral) {
  const char* options = R"({"items": ["a", "b"]})";
  const auto single = paired_findings(input_of(
      "subject,first,second,winner\nx,a,b,a\nx,a,b,a\nx,b,a,b\ny,a,b,tie\ny,b,a,a\n", options));
  const auto counted = paired_findings(
      input_of("subject,first,second,winner,times\nx,a,b,a,2\nx,b,a,b,1\ny,a,b,tie,1\ny,b,a,a,1\n",
               options));
  for (const char* quantity : {"bt.ability", "bt.se.cluster"}) {
    EXPECT_NEAR(value_of(counted, quantity, "b"), value_of(single, quantity, "b"), 1e-12);
  }
  const std::string trials = "x,1,p,p,2\nx,1,q,r,2\nx,1,r,q,2\ny,1,p,p,1\ny,1,q,q,1\ny,1,r,r,1\n";
  const auto goes =
      matching_findings(input_of("subject,trial,stimulus,response,times\n" + trials, "[]"));
  EXPECT_EQ(value_of(goes, "n.trials", ""), 3.0);
  EXPECT_EQ(value_of(goes, "total.correct", ""), 5.0);
  EXPECT_EQ(value_of(goes, "confusion", "q|r"), 2.0);
  // A permutation of three has 0, 1 or 3 right in 2, 3 and 1 of 6 orders. Five or more of three goes:
  // two 3 at least (16 of 216), or one 3 and twice 1 (27 of 216).
  EXPECT_NEAR(value_of(goes, "exact.p.greater", ""), 43.0 / 216.0, 1e-12);
  // Of one relabelling per participant: x has 0, 2 or 6 right, y 0, 1 or 3: 6 of x (6 of 36) or 2 and 3 (3 of 36).
  EXPECT_NEAR(value_of(goes, "relabel.p.greater", ""), 9.0 / 36.0, 1e-12);
  EXPECT_NEAR(value_of(goes, "relabel.smallest", ""), 1.0 / 36.0, 1e-12);
}

}  // namespace
}  // namespace asperity
