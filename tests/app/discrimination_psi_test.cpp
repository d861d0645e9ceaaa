// Discriminations whose levels psi chose: the posterior threshold next to the fitted one.

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/psychometric/psychometric_function.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/figures_of.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/study/analyze_study.h"
#include "tests/app/made_up_choices.h"
#include "tests/app/made_up_study.h"
#include "tests/app/stored_tables.h"

namespace asperity {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Discrimination, ReportsThePosteriorThresholdOfPsiNextToTheFittedOne) {
  const AnalysisOutcome outcome = outcome_of_staircases(psi_protocol(40), 8, 80);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const FoundNumbers found(thresholds);
  const double jnd_m = kPerformer.inverse(0.75);
  int holding = 0;
  for (const Finding* const posterior : found.all("jnd.posterior")) {
    ASSERT_TRUE(posterior->value && posterior->low && posterior->high) << posterior->key;
    EXPECT_EQ(posterior->unit, "m");
    EXPECT_THAT(posterior->method, HasSubstr("credible interval"));
    EXPECT_LT(*posterior->low, *posterior->value);
    EXPECT_GT(*posterior->high, *posterior->value);
    EXPECT_NEAR(std::log10(*posterior->value / jnd_m), 0.0, 0.25);
    holding += *posterior->low <= jnd_m && jnd_m <= *posterior->high ? 1 : 0;
    const auto fitted = found.value("jnd", posterior->key);
    if (fitted) {
      EXPECT_NEAR(std::log10(*posterior->value / *fitted), 0.0, 0.15);
    }
  }
  EXPECT_EQ(found.all("jnd.posterior").size(), 8U);
  const Finding* const fitted = found.find("jnd", "p10|all");
  ASSERT_NE(fitted, nullptr);
  EXPECT_FALSE(fitted->low);
  EXPECT_EQ(found.find("without", "p10|all"), nullptr) << "the procedure is not run again";
  EXPECT_GE(holding, 6) << "of 95 % intervals";
  const StoredTable& table = table_of(outcome, "thresholds");
  EXPECT_TRUE(column_of(table.table, "jnd_posterior_low"));
  EXPECT_THAT(table.note.english(), HasSubstr("Posterior JND: mean of the posterior"));
  const std::vector<Finding> means = part_of(outcome, "mean_thresholds");
  EXPECT_TRUE(FoundNumbers(means).value("geomean.jnd.posterior", "all"));
  EXPECT_FALSE(
      column_of(table_of(outcome_of_twelve_staircases(), "thresholds").table, "jnd_posterior"));
}

// A fitted threshold of levels that psi chose has no interval, and the caption of its figure states none.
TEST(Discrimination, CaptionsThresholdsOfPsiWithoutIntervals) {
  std::size_t with_marks = 0;
  for (const Figure& figure : figures_of(outcome_of_staircases(psi_protocol(40), 8, 80))) {
    if (!figure.name.starts_with("psychometric_p")) continue;
    const std::string note = figure.note.english();
    EXPECT_THAT(note, Not(HasSubstr("95 % CI"))) << figure.name;
    if (note.find("Open symbols") == std::string::npos) continue;
    EXPECT_THAT(note, HasSubstr("the level of 75 % correct, without CIs.")) << figure.name;
    ++with_marks;
  }
  EXPECT_GT(with_marks, 0U);
}

// The same probabilities from the trials themselves: 41 thresholds from 2 to 100 % of 50 µm, 8 slopes, 4 lapse rates.
TEST(Discrimination, ComputesThePosteriorThresholdWithThePriorOfTheProtocol) {
  const json protocol = psi_protocol(20);
  const AnalysisOutcome outcome = outcome_of_staircases(protocol, 1, 40);
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const auto stated = FoundNumbers(thresholds).value("jnd.posterior", "p10|all");
  ASSERT_TRUE(stated);
  std::vector<std::pair<double, bool>> trials{};  // value of the comparison; was it chosen?
  for (const MadeUpTrial& trial : staircase_trials(kPerformer, protocol, 200)) {
    trials.emplace_back(json::parse(trial.factors_json)["amplitude_m"].get<double>(),
                        trial.answers.front() == "comparison");
  }
  double sum = 0.0;
  double weighted = 0.0;
  for (int i = 0; i < 41; ++i) {
    for (int j = 0; j < 8; ++j) {
      for (int k = 0; k < 4; ++k) {
        PsychometricFunction f{.shape = PsychometricShape::weibull,
                               .alpha = 1.0,
                               .beta = std::pow(8.0, j / 7.0),
                               .gamma = 0.5,
                               .lambda = 0.02 * k};
        const double threshold_m = 1e-6 * std::pow(50.0, i / 40.0);
        f.alpha = threshold_m / f.inverse(0.75);
        double likelihood = 1.0;
        for (const auto& [value_m, is_hit] : trials) {
          const double hit = f.value(value_m - kStandard_m);
          likelihood *= is_hit ? hit : 1.0 - hit;
        }
        sum += likelihood;
        weighted += likelihood * std::log(threshold_m);
      }
    }
  }
  EXPECT_NEAR(*stated / std::exp(weighted / sum), 1.0, 1e-6);
}

TEST(Discrimination, HasNoPosteriorThresholdThatThePriorDetermines) {
  const json protocol = psi_protocol(30);
  const PsychometricFunction guesser{
      .shape = PsychometricShape::weibull, .alpha = 1.0, .beta = 1.0, .gamma = 0.5};
  const AnalysisOutcome outcome =
      outcome_of_choices(protocol, {}, [&](int) { return staircase_trials(guesser, protocol, 3); });
  const std::vector<Finding> thresholds = part_of(outcome, "thresholds");
  const Finding* const posterior = FoundNumbers(thresholds).find("jnd.posterior", "p10|all");
  ASSERT_NE(posterior, nullptr);
  EXPECT_FALSE(posterior->value);
  EXPECT_EQ(posterior->word, "at_end_of_prior");
  EXPECT_THAT(posterior->status, HasSubstr("widen the range"));
}

}  // namespace
}  // namespace asperity
