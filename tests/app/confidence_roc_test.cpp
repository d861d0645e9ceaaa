// Ratings of confidence next to a discrimination, from the rows of a study to the ROC.

#include "app/findings/methods/discrimination/sensitivity/confidence_roc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/random.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/outcome/found_numbers.h"
#include "protocols/kind_keys/discrimination_design.h"
#include "tests/app/coverage_counts.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ConfidenceJson = nlohmann::json;

/// Impressions are N(0, 1) of noise and N(mean, deviation) of a signal; five criteria make six categories.
struct ConfidentObserver {
  double mean = 0.0;
  double deviation = 1.0;

  double area() const { return normal_below(mean / std::sqrt(1.0 + deviation * deviation)); }
};
constexpr std::array kCriteria{-0.6, 0.0, 0.5, 1.0, 1.6};

ConfidenceJson confidence_protocol(const DiscriminationDesign& design, bool is_stated) {
  ConfidenceJson protocol = discrimination_protocol("performance");
  ConfidenceJson& block = protocol["blocks"]["only"];
  block["design"] = std::string(design.id);
  const ConfidenceJson asked = block["question"];
  block.erase("question");
  block["questions"] = {asked,
                        {{"name", "sure"},
                         {"prompt", "How sure?"},
                         {"scale", {{"minimum", 1}, {"maximum", 3}, {"points", 3}}}}};
  if (is_stated) block["questions"][1]["confidence_of"] = asked.at("name");
  return protocol;
}

/// A trial of two alternatives, or of yes/no.
MadeUpTrial rated_with_confidence(const DiscriminationDesign& design, bool is_signal,
                                  double impression) {
  const auto category = static_cast<int>(
      std::count_if(kCriteria.begin(), kCriteria.end(),
                    [impression](double criterion) { return impression > criterion; }));
  const bool is_yes = category >= 3;
  const int confidence = is_yes ? category - 2 : 3 - category;
  MadeUpTrial trial{};
  std::vector<std::string> items{is_signal ? "comparison" : "standard"};
  double value_m = 55e-6;
  if (design.has_noise()) {
    if (!is_signal) value_m = kStandard_m;
    trial.options = {"yes", "no"};
    trial.answers = {is_yes ? "yes" : "no"};
    trial.right = {is_signal ? "yes" : "no"};
  } else {
    items.emplace_back(is_signal ? "standard" : "comparison");
    trial.options = items;
    trial.answers = {items[is_yes ? 0 : 1]};
    trial.right = {"comparison"};
  }
  trial.factors_json = ConfidenceJson{{"amplitude_m", value_m}}.dump();
  for (const std::string& item : items) {
    trial.surfaces.push_back(surface_of(item, "sinusoid", ""));
    trial.surfaces.back().role = item;
  }
  trial.questions = {"which", "sure"};
  trial.answers.push_back(std::to_string(confidence));
  return trial;
}

/// Of eight participants with this observer, computed once in this process.
const AnalysisOutcome& outcome_with_confidence(const DiscriminationDesign& design,
                                               const ConfidentObserver& observer,
                                               bool is_stated = true) {
  constexpr int kTrialsOfKind = 100;
  const auto trials_of_person = [&](int person) {
    Random random(static_cast<std::uint64_t>(100 + person));
    std::vector<MadeUpTrial> trials{};
    for (int i = 0; i < kTrialsOfKind; ++i) {
      trials.push_back(rated_with_confidence(design, false, random.normal()));
      trials.push_back(rated_with_confidence(design, true,
                                             observer.mean + observer.deviation * random.normal()));
    }
    return trials;
  };
  return outcome_once(
      outcome_key("confidence", design.id, observer.mean, observer.deviation, is_stated), [&] {
        return analysed("discrimination", confidence_protocol(design, is_stated).dump(),
                        {.number = 8, .first = 1}, trials_of_person);
      });
}

const std::vector<const DiscriminationDesign*>& rated_designs() {
  static const std::vector<const DiscriminationDesign*> kDesigns{&yes_no_task(),
                                                                 &two_alternatives()};
  return kDesigns;
}

const std::string kLevelOfRoc = "all|5.5e-05";

// 800 trials of each kind: A_z has a standard error of about 0.011, and 3.29 of them contain it with 99.9 %.
TEST(ConfidenceRoc, RecoversTheAreaAndTheRatioOfThePlantedObserver) {
  constexpr ConfidentObserver kPlanted{.mean = 1.4, .deviation = 1.6};
  for (const DiscriminationDesign* const design : rated_designs()) {
    SCOPED_TRACE(std::string(design->id));
    const std::vector<Finding> roc =
        part_of(outcome_with_confidence(*design, kPlanted), "confidence_roc");
    const FoundNumbers found(roc);
    EXPECT_EQ(found.value("n.noise", kLevelOfRoc), 800.0);
    EXPECT_EQ(found.value("n.signal", kLevelOfRoc), 800.0);
    const Finding* const area = found.find("uv.az", kLevelOfRoc);
    ASSERT_TRUE(area != nullptr && area->value);
    EXPECT_FALSE(area->low || area->high);
    EXPECT_NEAR(*area->value, kPlanted.area(), 3.29 * 0.011);
    const auto error = found.value("uv.sigma.se", kLevelOfRoc);
    ASSERT_TRUE(error);
    EXPECT_NEAR(*found.value("uv.sigma", kLevelOfRoc), kPlanted.deviation, 3.29 * *error);
    EXPECT_LT(*found.value("lr.equal.variance.p", kLevelOfRoc), 0.001);
    EXPECT_TRUE(found.find("uv.az", kLevelOfRoc + "|p1"));
    const Finding* const pooled = found.find("auc", kLevelOfRoc);
    ASSERT_NE(pooled, nullptr);
    EXPECT_FALSE(pooled->low || pooled->high);
    const Finding* const own = found.find("auc", kLevelOfRoc + "|p1");
    ASSERT_NE(own, nullptr);
    EXPECT_TRUE(own->low && own->high);
    const Finding* const mean = found.find("auc.mean", kLevelOfRoc);
    ASSERT_NE(mean, nullptr);
    EXPECT_TRUE(mean->low && mean->high);
  }
}

TEST(ConfidenceRoc, DoesNotRejectEqualVariancesOfAnObserverWhoHasThem) {
  for (const DiscriminationDesign* const design : rated_designs()) {
    const std::vector<Finding> roc = part_of(
        outcome_with_confidence(*design, {.mean = 1.0, .deviation = 1.0}), "confidence_roc");
    EXPECT_GT(*FoundNumbers(roc).value("lr.equal.variance.p", kLevelOfRoc), 0.001);
  }
}

TEST(ConfidenceRoc, HasAnAreaOfAHalfForGuesses) {
  for (const DiscriminationDesign* const design : rated_designs()) {
    const std::vector<Finding> roc =
        part_of(outcome_with_confidence(*design, {}), "confidence_roc");
    const FoundNumbers found(roc);
    EXPECT_NEAR(*found.value("auc", kLevelOfRoc), 0.5,
                3.29 * *found.value("auc.se.delong", kLevelOfRoc));
  }
}

TEST(ConfidenceRoc, HasATableAndAnAnswer) {
  const AnalysisOutcome& outcome =
      outcome_with_confidence(yes_no_task(), {.mean = 1.4, .deviation = 1.6});
  const Table& table = table_of(outcome, "confidence_roc").table;
  EXPECT_EQ(table.rows.size(), 9U) << "all participants, and each one";
  EXPECT_EQ(table.rows.front().front(), Cell{std::string("all participants")});
  EXPECT_THAT(table_of(outcome, "confidence_roc").note.english(),
              HasSubstr("its coverage was " + span_of_coverage("ratings_of_signal", "auc")));
  EXPECT_THAT(table_of(outcome, "confidence_roc").note.english(),
              HasSubstr("contained the common A_z in " +
                        span_of_coverage("areas_of_participants", "uv.az", true)));
  EXPECT_THAT(table_of(outcome, "confidence_roc").note.english(),
              HasSubstr("DeLong’s the common area by trapezoids in " +
                        span_of_coverage("areas_of_participants", "auc", true)));
  EXPECT_THAT(answer_to(outcome, "confidence_roc"),
              HasSubstr("55 µm: mean A_z of 8 of 8 participants = 0.7"));
  EXPECT_THAT(answer_to(outcome, "confidence_roc"),
              HasSubstr("; mean area by trapezoids of 8 of 8 participants = 0.7"));
  EXPECT_THAT(answer_to(outcome, "confidence_roc"),
              HasSubstr("too small where participants have different criteria"));
  EXPECT_THAT(answer_to(outcome, "confidence_roc"), HasSubstr("test of equal variances χ²(1) = "));
  EXPECT_THAT(answer_to(outcome, "confidence_roc"),
              HasSubstr("exploratory and uncorrected, and treat the responses of all participants "
                        "as independent"));
}

// All trials with a signal have the highest rating: DeLong's standard error lacks one of its two parts.
TEST(ConfidenceRoc, HasNoIntervalWhereAllSignalsHaveOneRating) {
  const std::vector<Finding> roc = part_of(
      outcome_with_confidence(yes_no_task(), {.mean = 20.0, .deviation = 1.0}), "confidence_roc");
  const Finding* const area = FoundNumbers(roc).find("auc", kLevelOfRoc + "|p1");
  ASSERT_TRUE(area != nullptr && area->value);
  EXPECT_FALSE(area->low);
  EXPECT_EQ(FoundNumbers(roc).find("auc.lower", kLevelOfRoc + "|p1"), nullptr);
  EXPECT_EQ(FoundNumbers(roc).find("auc.upper", kLevelOfRoc + "|p1"), nullptr);
  EXPECT_THAT(area->method, HasSubstr("; without an interval"));
}

TEST(ConfidenceRoc, DistinguishesAParticipantWithTheLabelAllFromAllParticipants) {
  EXPECT_THAT(std::string(kAllParticipants), HasSubstr(" ")) << "labels have no blanks";
}

TEST(ConfidenceRoc, IsAbsentWhereAScaleDoesNotRateConfidence) {
  const AnalysisOutcome& outcome =
      outcome_with_confidence(yes_no_task(), {.mean = 1.0, .deviation = 1.0}, false);
  EXPECT_EQ(find_table(outcome, "confidence_roc"), nullptr);
  EXPECT_TRUE(part_of(outcome, "confidence_roc").empty());
}

}  // namespace
}  // namespace asperity
