// The coverage that notes state is that of docs/data/coverage.tsv.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/outcome/test_methods.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/coverage_counts.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The smallest coverage over the settings whose true value has an absolute value from `from` to `to`, in whole per cent.
std::string smallest_coverage(const std::string& part, const std::string& quantity, double from,
                              double to) {
  double smallest = 1.0;
  for (const DrawnCount& count : coverage_counts(part, quantity)) {
    const double truth = std::abs(count.truth.value());
    // Of settings with the number in fewer than one table in twenty, the few that have it are unlike the others.
    if (truth < from || truth > to || count.given < 0.05 * count.tables) continue;
    smallest = std::min(smallest, 1.0 - count.failed / count.given);
  }
  return std::to_string(static_cast<int>(std::floor(100.0 * smallest))) + " %";
}

TEST(StatedCoverage, OfEffectSizesOfChoicesIsTheSmallestOfTheSimulations) {
  const std::string note = test_method("signflip.p.two")->coverage.english();
  EXPECT_THAT(note,
              HasSubstr("at least " + smallest_coverage("choice_effects", "signflip.d", 0.0, 0.8) +
                        " with a true d of at most 0.8"));
  EXPECT_THAT(note,
              HasSubstr("at least " + smallest_coverage("choice_effects", "signflip.d", 0.8, 1e9) +
                        " with a larger one"));
  EXPECT_THAT(test_method("relabel.exact.p")->coverage.english(),
              HasSubstr(smallest_coverage("choice_effects", "relabel.W", 0.0, 1.0).substr(0, 2) +
                        " to 100 %"));
}

std::vector<Finding> findings_of(const char* family, const std::string& rows,
                                 const std::string& options = "{}") {
  TidyInput input{.options = FamilyOptions::of_json(options, "options")};
  input.tables.emplace_back(rows, "t.csv");
  return tidy_family(family).findings(input);
}

std::string method_of(const std::vector<Finding>& findings, const std::string& quantity) {
  for (const Finding& finding : findings) {
    if (finding.quantity == quantity) return finding.method;
  }
  return "(absent)";
}

TEST(StatedCoverage, OfOneParticipantOrMeansOfThemIsThatOfTheSimulations) {
  const std::vector<Finding> roc =
      findings_of("roc", "condition,rating,noise,signal\na,1,8,2\na,2,4,4\na,3,2,8\n");
  EXPECT_THAT(method_of(roc, "auc"), HasSubstr(span_of_coverage("ratings_of_signal", "auc")));
  const std::vector<Finding> fit = findings_of(
      "psyfit", "condition,x,n,k\na,1,20,2\na,2,20,8\na,3,20,13\na,4,20,18\n",
      R"({"shape": "logistic", "gamma": 0, "lambda": 0.02, "pt": 0.5, "bootstrap": 200})");
  for (const auto& [quantity, part, drawn] :
       {std::tuple("threshold", "psychometric", "threshold"),
        std::tuple("threshold.overdispersed.lower", "psychometric", "threshold.overdispersed"),
        std::tuple("fit.alpha", "psychometric", "alpha.profile"),
        std::tuple("bootstrap.threshold.lower", "bootstrapped", "bootstrap.threshold")}) {
    EXPECT_THAT(method_of(fit, quantity), HasSubstr(span_of_coverage(part, drawn))) << quantity;
  }
  std::string tasks = "id,subject,design,signal_yes,signal_n,noise_yes,noise_n\n";
  for (int i = 0; i < 6; ++i) {
    tasks += "a,p" + std::to_string(i) + ",yesno," + std::to_string(12 + i) + ",20,5,20\n";
  }
  EXPECT_THAT(method_of(findings_of("response_times", "subject,time_s\nA,1\nB,2\n"), "geomean"),
              HasSubstr(span_of_coverage("response_times", "geomean")));
  EXPECT_THAT(method_of(findings_of("dprime", tasks), "dprime.mean"),
              HasSubstr(span_of_coverage("sensitivity", "dprime.mean")));
}

TEST(StatedCoverage, OfPooledResponsesIsThatOfTheSimulations) {
  const auto spans = [](const std::string& part, const std::string& quantity) {
    return span_of_coverage(part, quantity, false) + " where participants are alike, and " +
           span_of_coverage(part, quantity, true) + " where they differ";
  };
  const std::vector<Finding> recognised =
      findings_of("recognition", "subject,stimulus,response\nA,x,x\nA,y,x\nB,y,y\nB,x,x\n",
                  R"({"labels": ["x", "y"]})");
  for (const char* const quantity : {"pc", "dprime"}) {
    EXPECT_THAT(method_of(recognised, quantity), HasSubstr(spans("recognition", quantity)));
  }
  const std::vector<Finding> matched = findings_of(
      "matching", "subject,trial,stimulus,response\nA,1,x,x\nA,1,y,y\nB,1,x,y\nB,1,y,x\n");
  EXPECT_THAT(method_of(matched, "perfect.wilson.lower"), HasSubstr(spans("matching", "perfect")));
  const std::vector<Finding> compared =
      findings_of("paired", "subject,first,second,winner\nA,x,y,x\nA,x,y,y\nB,y,x,x\nB,y,x,x\n",
                  R"({"items": ["x", "y"]})");
  EXPECT_THAT(method_of(compared, "bt.ability.sumzero"),
              HasSubstr(spans("pairs", "bt.ability.sumzero")));
  const std::vector<Finding> ranked = findings_of(
      "ranking", "subject,trial,item,rank\nA,1,x,1\nA,1,y,2\nA,2,x,2\nA,2,y,1\nB,1,x,1\nB,1,y,2\n",
      R"({"items": ["x", "y"]})");
  EXPECT_THAT(method_of(ranked, "pl.logworth.sumzero"),
              HasSubstr(spans("worths", "pl.logworth.sumzero")));
}

TEST(StatedCoverage, OfAreasOfParticipantsIsThatOfTheSimulations) {
  std::string table = "condition,subject,rating,noise,signal\n";
  for (const char* const row : {"a,1,8,2", "a,2,4,4", "a,3,2,8", "b,1,9,3", "b,2,3,4", "b,3,2,7"}) {
    table += std::string("x,") + row + '\n';
  }
  const std::vector<Finding> areas = findings_of("roc", table);
  for (const char* const quantity : {"uv.az.mean", "auc.mean"}) {
    EXPECT_THAT(method_of(areas, quantity),
                HasSubstr(span_of_coverage("areas_of_participants", quantity)));
  }
  for (const char* const quantity : {"uv.az", "auc"}) {
    EXPECT_THAT(method_of(areas, quantity),
                HasSubstr(span_of_coverage("areas_of_participants", quantity, false) +
                          " where participants are alike, and " +
                          span_of_coverage("areas_of_participants", quantity, true) +
                          " where they differ"));
  }
}

// The interval of Welch's t is truncated, and conservative near 0 and 1.
TEST(StatedCoverage, OfTheDifferenceOfTwoGroupsIsThatOfTheSimulations) {
  const std::vector<Finding> groups =
      findings_of("group", "subject,group,correct,trials\na,f,5,9\nb,f,6,9\nc,m,3,9\nd,m,5,9\n",
                  R"({"groups": ["f", "m"]})");
  EXPECT_THAT(method_of(groups, "subj.diff"), HasSubstr(span_of_coverage("groups", "subj.diff")));
  const std::vector<Finding> alone = findings_of(
      "group", "subject,group,correct,trials\na,f,5,9\nb,m,6,9\n", R"({"groups": ["f", "m"]})");
  EXPECT_THAT(method_of(alone, "subj.diff"), Not(HasSubstr("coverage"))) << "without an interval";
}

TEST(StatedCoverage, OfDifferencesOfAMixedModelIsThatOfTheSimulations) {
  TidyInput input{};
  input.tables.emplace_back(
      "subject,item,y\na,x,1\na,y,3\na,x,2\na,y,2\nb,x,2\nb,y,4\nb,x,3\nb,y,5\nc,x,1\nc,y,2\n",
      "t.csv");
  const std::vector<std::pair<std::string, std::vector<std::string>>> fixed{{"item", {"x", "y"}}};
  input.options.set("fixed", fixed);
  const std::vector<Finding> findings = tidy_family("lmm").findings(input);
  const auto difference = std::find_if(findings.begin(), findings.end(), [](const Finding& one) {
    return one.quantity == "lmm.beta" && one.key == "item|y";
  });
  ASSERT_NE(difference, findings.end());
  EXPECT_THAT(difference->method,
              HasSubstr(span_of_coverage("varying_items", "lmm.beta", true) + " where they vary"));
  std::vector<DrawnCount> alike = coverage_counts("continuous_scale", "lmm.beta");
  for (const DrawnCount& count : coverage_counts("varying_items", "lmm.beta")) {
    if (count.spread == 0.0) alike.push_back(count);
  }
  EXPECT_THAT(difference->method, HasSubstr(span_of_coverage(alike)));
}

/// "up to 7 %": the greatest Type I error rate over the designs with these numbers of participants.
std::string greatest_size(const std::string& part, const std::string& quantity, double from,
                          double to) {
  double greatest = 0.0;
  for (const DrawnCount& count : coverage_counts(part, quantity)) {
    if (count.participants < from || count.participants > to) continue;
    greatest = std::max(greatest, 100.0 * count.failed / count.given);
  }
  return std::to_string(std::lround(greatest)) + " %";
}

/// How the family describes this number of three participants who rate two items twice.
std::string method_in(const char* family, const std::string& quantity, const char* score) {
  std::string rows = std::string("subject,item,") + score + "\n";
  for (const char* const row : {"a,x,1", "a,y,3", "a,x,2", "a,y,2", "b,x,2", "b,y,4", "b,x,3",
                                "b,y,5", "c,x,1", "c,y,2", "c,x,3", "c,y,4"}) {
    rows += std::string(row) + '\n';
  }
  TidyInput input{};
  input.tables.emplace_back(rows, "t.csv");
  const std::vector<std::pair<std::string, std::vector<std::string>>> fixed{{"item", {"x", "y"}}};
  input.options.set("fixed", fixed);
  input.options.set("items", std::vector<std::string>{"x", "y"});
  for (const Finding& finding : tidy_family(family).findings(input)) {
    if (finding.quantity == quantity) return finding.method;
  }
  return {};
}

TEST(StatedSize, OfCorrectedAnalysesOfVarianceIsThatOfTheSimulations) {
  TidyInput input{};
  input.tables.emplace_back(
      "subject,item,y\na,x,1\na,y,3\na,z,2\nb,x,2\nb,y,2\nb,z,5\nc,x,4\nc,y,3\nc,z,1\nd,x,2\nd,y,"
      "5\nd,z,3\n",
      "t.csv");
  const std::vector<std::pair<std::string, std::vector<std::string>>> within{
      {"item", {"x", "y", "z"}}};
  input.options.set("within", within);
  double least = 100.0;
  double greatest = 0.0;
  for (const DrawnCount& count : coverage_counts("varying_items", "p.GG")) {
    const double size = 100.0 * count.failed / count.given;
    least = std::min(least, size);
    greatest = std::max(greatest, size);
  }
  EXPECT_THAT(method_of(tidy_family("rmanova").findings(input), "p.GG"),
              HasSubstr("was " + std::to_string(std::lround(least)) + " to " +
                        std::to_string(std::lround(greatest)) + " %"));
}

TEST(StatedSize, OfMixedModelsOfRatingsIsTheGreatestOfTheSimulations) {
  EXPECT_THAT(method_in("lmm", "lmm.F.p", "y"),
              HasSubstr("up to " + greatest_size("continuous_scale", "lmm.F.p", 2.0, 20.0)));
  const std::vector<DrawnCount> sizes = coverage_counts("varying_items", "lmm.F.p");
  const auto greatest_with = [&sizes](double spread) {
    double greatest = 0.0;
    for (const DrawnCount& count : sizes) {
      if (count.spread == spread) greatest = std::max(greatest, 100.0 * count.failed / count.given);
    }
    return std::to_string(std::lround(greatest));
  };
  EXPECT_THAT(method_in("lmm", "lmm.F.p", "y"),
              HasSubstr("up to " + greatest_with(0.5) + " and " + greatest_with(1.0) + " %"));
  const std::string beta = method_in("lmm", "lmm.beta", "y");
  EXPECT_THAT(beta, Not(HasSubstr("in simulations"))) << "the intercept";
  const std::string ordinal = method_in("ordinal", "lr.p", "score");
  EXPECT_THAT(ordinal,
              HasSubstr("up to " + greatest_size("ordered_categories", "lr.p", 3.0, 20.0)));
  EXPECT_THAT(ordinal, HasSubstr(greatest_size("ordered_categories", "lr.p", 2.0, 2.0) +
                                 " with 2 participants"));
}

}  // namespace
}  // namespace asperity
