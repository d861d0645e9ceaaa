// The model of choices by level and exploration: what is planted is found, and the numbers are those of the family glmm.

#include "app/findings/methods/discrimination/choice_model.h"

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"
#include "tests/app/analysed_study.h"

namespace asperity {
namespace {

constexpr double kStandardAmplitude_m = 50e-6;

constexpr const char* kComparisonOfAmplitudes = R"({"kind": "discrimination",
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5}}},
  "blocks": {"only": {
    "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels": []},
    "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
    "question": {"name": "which", "prompt": "Which is rougher?", "judgement": "comparison"}}}})";

/// What a participant does: ln(p/(1 − p)) = own + per_m·Δlevel + per_N·Δforce.
struct ChoosingHand {
  double own_sd = 0.8;
  double per_m = 1.2e5;
  double per_N = 3.0;
  bool has_forces = true;
};

struct ChosenTrial {
  std::string participant{};
  double level_m = 0.0;
  double force_difference_N = 0.0;
  double speed_difference_m_per_s = 0.0;
  bool comparison_first = false;
  bool chose_comparison = false;
};

void feel(MadeUpTrial& trial, double force_N, double speed_m_per_s) {
  const int position = static_cast<int>(trial.compliance.size()) / 2 + 1;
  const auto add = [&](const char* quantity, double mean) {
    ComplianceRow row{};
    row.position = position;
    row.quantity = quantity;
    row.mean = row.p05 = row.p50 = row.p95 = mean;
    trial.compliance.push_back(row);
  };
  add("normal_force_N", force_N);
  add("speed_m_per_s", speed_m_per_s);
}

/// The choices of participants, and their analysis.
struct Chosen {
  std::vector<ChosenTrial> trials{};
  AnalysisOutcome outcome{};

  const StoredTable* table() const { return find_table(outcome, kChoiceModel); }
  std::optional<double> number(const std::string& quantity, const std::string& key) const {
    return finding_of(outcome, kChoiceModel, quantity, key).value;
  }
};

Chosen chosen_by(const ChoosingHand& hand, int people = 3, int trials = 30) {
  Chosen all{};
  MadeUpStudy made;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  const std::int64_t declared = made.add_protocol("jnd", "discrimination", kComparisonOfAmplitudes);
  for (int person = 0; person < people; ++person) {
    const std::string label = "p" + std::to_string(person);
    made.add_person(label, "F");
    const double own = hand.own_sd * normal(random);
    std::vector<MadeUpTrial> of_person{};
    for (int i = 0; i < trials; ++i) {
      ChosenTrial chosen{.participant = label,
                         .level_m = kStandardAmplitude_m + 1e-5 * (i % 3 - 1),
                         .comparison_first = (i / 3) % 2 == 0};
      // As stored: means of both surfaces.
      const double force_N = 1.0 + 0.2 * normal(random);
      const double standard_N = 1.0 + 0.2 * normal(random);
      const double speed = 0.05 + 0.005 * normal(random);
      const double standard_speed = 0.05 + 0.005 * normal(random);
      chosen.force_difference_N = static_cast<float>(force_N) - static_cast<float>(standard_N);
      chosen.speed_difference_m_per_s =
          static_cast<float>(speed) - static_cast<float>(standard_speed);
      const double eta = own + hand.per_m * (chosen.level_m - kStandardAmplitude_m) +
                         hand.per_N * (force_N - standard_N);
      chosen.chose_comparison = uniform(random) < 1.0 / (1.0 + std::exp(-eta));
      all.trials.push_back(chosen);

      MadeUpTrial trial{};
      trial.factors_json = nlohmann::json{{"amplitude_m", chosen.level_m}}.dump();
      trial.surfaces = {surface_of("standard", "sinusoid", ""),
                        surface_of("comparison", "sinusoid", "")};
      if (chosen.comparison_first) std::swap(trial.surfaces[0], trial.surfaces[1]);
      trial.answers = {chosen.chose_comparison ? "comparison" : "standard"};
      trial.options = {"standard", "comparison"};
      trial.block = "only";
      if (hand.has_forces) {
        if (chosen.comparison_first) feel(trial, force_N, speed);
        feel(trial, standard_N, standard_speed);
        if (!chosen.comparison_first) feel(trial, force_N, speed);
      }
      of_person.push_back(trial);
    }
    made.add_session(label, declared, of_person);
  }
  all.outcome = analyze_study(made.study()).front();
  return all;
}

/// Of ten participants with 80 trials each, computed once in this process.
const Chosen& chosen_by_ten() {
  static const Chosen kChosen = chosen_by({}, 10, 80);
  return kChosen;
}

/// The same trials as a table for the family, in units of the standard deviations over the trials.
std::vector<Finding> findings_of_family(const std::vector<ChosenTrial>& trials) {
  const auto deviation_of = [&](auto value) {
    double sum = 0.0;
    double squares = 0.0;
    for (const ChosenTrial& trial : trials) sum += value(trial);
    const double mean = sum / static_cast<double>(trials.size());
    for (const ChosenTrial& trial : trials) squares += std::pow(value(trial) - mean, 2.0);
    return std::sqrt(squares / static_cast<double>(trials.size()));
  };
  const auto level = [](const ChosenTrial& trial) { return trial.level_m; };
  const auto force = [](const ChosenTrial& trial) { return trial.force_difference_N; };
  const auto speed = [](const ChosenTrial& trial) { return trial.speed_difference_m_per_s; };
  const double level_sd = deviation_of(level);
  const double force_sd = deviation_of(force);
  const double speed_sd = deviation_of(speed);
  std::string text = "subject,correct,trials,level,force,speed,first\n";
  for (const ChosenTrial& trial : trials) {
    text += trial.participant + ',' + (trial.chose_comparison ? '1' : '0') + ",1," +
            number_text((trial.level_m - kStandardAmplitude_m) / level_sd) + ',' +
            number_text(force(trial) / force_sd) + ',' + number_text(speed(trial) / speed_sd) +
            ',' + (trial.comparison_first ? '1' : '0') + '\n';
  }
  TidyInput input{};
  input.tables.emplace_back(text, "choices.csv");
  input.options.set("random", std::vector<std::string>{"subject"});
  input.options.set("covariates", std::vector<std::string>{"level", "force", "speed", "first"});
  return glmm_findings(input);
}

TEST(ChoiceModelTest, IsTheMixedModelOfTheFamilyWithCovariates) {
  const Chosen& chosen = chosen_by_ten();
  const std::vector<Finding> findings = findings_of_family(chosen.trials);
  const FoundNumbers family(findings);
  for (const auto& [factor, covariate] :
       {std::pair("level_difference", "level"), std::pair("force_difference", "force"),
        std::pair("speed_difference", "speed"), std::pair("comparison_first", "first")}) {
    EXPECT_NEAR(std::log(chosen.number("odds_ratio", factor).value()),
                family.value("glmm.beta", covariate).value(), 1e-4)
        << factor;
  }
  EXPECT_NEAR(chosen.number("sigma", "subject").value(),
              family.value("glmm.sigma", "subject").value(), 1e-3);
}

TEST(ChoiceModelTest, FindsTheForceThatChangesChoices) {
  ASSERT_NE(chosen_by_ten().table(), nullptr);
  const Table& shown = chosen_by_ten().table()->table;
  ASSERT_EQ(shown.rows.size(), 4U);
  const auto cell = [&](std::size_t row, const char* column) {
    return shown.rows[row][column_of(shown, column).value()];
  };
  EXPECT_EQ(cell(1, "factor"), Cell{"force_difference"});
  EXPECT_EQ(cell(1, "unit"), Cell{"N"});
  EXPECT_EQ(cell(1, "answers"), Cell{std::int64_t{800}});
  const double sd_N = number_of(cell(1, "sd")).value();
  EXPECT_NEAR(sd_N, 0.2 * std::sqrt(2.0), 0.02);
  // 3 per newton lies in the interval, and no effect does not.
  EXPECT_LT(number_of(cell(1, "odds_ratio_low")).value(), std::exp(3.0 * sd_N));
  EXPECT_GT(number_of(cell(1, "odds_ratio_high")).value(), std::exp(3.0 * sd_N));
  EXPECT_GT(number_of(cell(1, "odds_ratio_low")).value(), 1.0);
  EXPECT_LT(number_of(cell(2, "odds_ratio_low")).value(), 1.0);  // the speed has no effect
  EXPECT_GT(number_of(cell(2, "odds_ratio_high")).value(), 1.0);
}

TEST(ChoiceModelTest, ExistsWhereParticipantsDoNotDiffer) {
  const Chosen chosen = chosen_by({.own_sd = 0.0}, 6);
  EXPECT_EQ(chosen.number("sigma", "subject"), 0.0);
  EXPECT_TRUE(chosen.number("odds_ratio", "force_difference"));
}

TEST(ChoiceModelTest, StatesThatEffectsPredictEveryChoice) {
  const Chosen chosen = chosen_by({.own_sd = 0.0, .per_m = 0.0, .per_N = 1e6});
  ASSERT_NE(chosen.table(), nullptr);
  EXPECT_EQ(chosen.table()->table.rows.at(0).back(), Cell{"separated_choices"});
}

TEST(ChoiceModelTest, IsAbsentWithoutForces) {
  EXPECT_EQ(chosen_by({.has_forces = false}).table(), nullptr);
}

}  // namespace
}  // namespace asperity
