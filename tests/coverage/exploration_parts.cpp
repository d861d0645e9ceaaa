// Choices of one of two surfaces that depend on how the surfaces were explored.

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/tail_probabilities.h"
#include "app/findings/methods/discrimination/choice_model.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

constexpr std::array kForceEffects{0.0, 0.5};
constexpr std::array kInterceptSpreads{0.0, 1.0};
constexpr double kLevelEffect = 1.0;
constexpr std::array kLevelDifferences{-1.0, 0.0, 1.0};
/// The standard's mean force and speed, and the SD of the differences from them.
constexpr double kStandard = 1.0;
constexpr double kDeviation = 0.1;

/// As many differences as there are trials, with the mean 0 and the standard deviation 1, in random order: effects per
/// standard deviation over the trials then have true values.
std::vector<double> shuffled_differences(std::size_t n, Random& random) {
  std::vector<double> differences{};
  double squares = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double z = std::copysign(normal_limit(std::abs(2.0 * p - 1.0)), p - 0.5);
    differences.push_back(z);
    squares += z * z;
  }
  for (double& z : differences) z /= std::sqrt(squares / static_cast<double>(n));
  random.shuffle(std::span(differences));
  return differences;
}

TidyInput draw_explored_choices(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,level,force,speed,first,correct,trials");
  const std::size_t n = setting.participants * setting.trials;
  const std::vector<double> forces = shuffled_differences(n, random);
  const std::vector<double> speeds = shuffled_differences(n, random);
  std::size_t row = 0;
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial, ++row) {
      const double level = kLevelDifferences[(trial + i) % kLevelDifferences.size()];
      const double eta = own + kLevelEffect * level + setting.effect * forces[row];
      table.add({participant_label(i), number_text(level), number_text(forces[row]),
                 number_text(speeds[row]),
                 (trial / kLevelDifferences.size() + i) % 2 == 0 ? "1" : "0",
                 random.uniform() < 1.0 / (1.0 + std::exp(-eta)) ? "1" : "0", "1"});
    }
  }
  TidyInput input = std::move(table).as_input();
  input.options.set("random", std::vector<std::string>{"subject"});
  input.options.set("covariates", std::vector<std::string>{"level", "force", "speed", "first"});
  return input;
}

/// The two surfaces of a trial, the standard first or second.
void explore(GatheredAnswers& gathered, const DiscriminationTrial& trial, double force,
             double speed) {
  const SessionAnswers::Exploration standard{.force_N = kStandard, .speed_m_per_s = kStandard};
  const SessionAnswers::Exploration comparison{.force_N = kStandard + kDeviation * force,
                                               .speed_m_per_s = kStandard + kDeviation * speed};
  gathered.exploration.add(trial.comparison_first ? std::array{comparison, standard}
                                                  : std::array{standard, comparison});
}

/// Those of the family `glmm`, which has tests, and of the analysis of a study, which has odds ratios.
std::vector<Finding> findings_of_explored_choices(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const std::vector<double> levels = table.all_numbers("level");
  const std::vector<double> forces = table.all_numbers("force");
  const std::vector<double> speeds = table.all_numbers("speed");
  const std::vector<std::uint64_t> first = table.counts("first");
  const std::vector<std::uint64_t> chosen = table.counts("correct");
  GatheredAnswers gathered{};
  Dimension varied{};
  varied.standard = 0.0;
  DiscriminationStudy study{.task = {.is_performance = false, .varied = varied},
                            .conditions = {"all"}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    study.trials.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                            .value = levels[row],
                            .chose_comparison = chosen[row] == 1,
                            .comparison_first = first[row] == 1,
                            .first_surface = 2 * row});
    explore(gathered, study.trials.back(), forces[row], speeds[row]);
  }
  AnalysisOutcome outcome{};
  outcome.findings = glmm_findings(input);
  add_choice_model(gathered, {study}, outcome);
  return outcome.findings;
}

std::vector<CheckedInterval> explored_intervals(const CoverageSetting& setting) {
  return {{.quantity = "glmm.beta", .key = "force", .truth = setting.effect},
          {.quantity = "odds_ratio",
           .key = "level_difference",
           .truth = std::exp(kLevelEffect * std::sqrt(2.0 / 3.0))},
          {.quantity = "odds_ratio", .key = "force_difference", .truth = std::exp(setting.effect)},
          {.quantity = "odds_ratio", .key = "speed_difference", .truth = 1.0}};
}

std::vector<CheckedTest> explored_tests(const CoverageSetting& setting) {
  std::vector<CheckedTest> tests{{.quantity = "glmm.p", .key = "speed"},
                                 {.quantity = "glmm.lr.p", .key = "speed"}};
  if (setting.effect == 0.0) {
    tests.push_back({.quantity = "glmm.p", .key = "force"});
    tests.push_back({.quantity = "glmm.lr.p", .key = "force"});
  }
  return tests;
}

}  // namespace

std::span<const CoveragePart> exploration_parts() {
  static const auto kExplored = all_designs(kForceEffects, kInterceptSpreads);
  static const std::array kParts{CoveragePart{
      .name = "explored_choices",
      .model = "choices between a comparison at three levels and a standard; the logit depends on "
               "the level and on the difference of the forces, and not on that of the speeds; a "
               "participant's intercept is normal; logistic mixed model with covariates, as the "
               "family `glmm` and as the analysis of a study fits it (`add_choice_model`)",
      .effect = "log odds ratio per SD of the difference of the forces",
      .spread = "SD of the intercepts",
      .settings = kExplored,
      .draw = draw_explored_choices,
      .findings = findings_of_explored_choices,
      .intervals = explored_intervals,
      .tests = explored_tests,
      .tables = 10000}};
  return kParts;
}

}  // namespace asperity
