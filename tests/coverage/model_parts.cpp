// Psychometric functions, and mixed models of participants and textures.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/findings/shared/crossed_textures.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

// --- psychometric functions --------------------------------------------------------------------------

constexpr std::array kGuessRates{0.0, 0.5};
constexpr std::array kOneWay{0.0};
constexpr double kThreshold = 0.3;
constexpr double kSteepness = 1.5;
constexpr double kLapses = 0.02;
constexpr double kFurthestLevel = 2.0;

void add_condition_to(DrawnTable& table, std::string_view condition, const CoverageSetting& setting,
                      Random& random) {
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double x =
        kFurthestLevel *
        (2.0 * static_cast<double>(i) / static_cast<double>(setting.participants - 1) - 1.0);
    const double p = setting.effect + (1.0 - setting.effect - kLapses) /
                                          (1.0 + std::exp(-kSteepness * (x - kThreshold)));
    std::size_t hits = 0;
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      hits += random.uniform() < p ? 1 : 0;
    }
    table.add({condition, number_text(x), std::to_string(setting.trials), std::to_string(hits)});
  }
}

/// Half way between guesses and lapses.
double asked_performance(const CoverageSetting& setting) {
  return 0.5 * (setting.effect + 1.0 - kLapses);
}

TidyInput with_psychometric_options(DrawnTable table, const CoverageSetting& setting,
                                    std::string_view draws) {
  TidyInput input = std::move(table).as_input();
  input.options.add("shape", "logistic");
  input.options.add("gamma", number_text(setting.effect));
  input.options.add("lambda", number_text(kLapses));
  input.options.add("pt", number_text(asked_performance(setting)));
  input.options.add("bootstrap", std::string(draws));
  return input;
}

TidyInput draw_two_functions(const CoverageSetting& setting, Random& random) {
  DrawnTable table("condition,x,n,k");
  add_condition_to(table, "a", setting, random);
  add_condition_to(table, "b", setting, random);
  return with_psychometric_options(std::move(table), setting, "0");
}

TidyInput draw_one_function(const CoverageSetting& setting, Random& random) {
  DrawnTable table("condition,x,n,k");
  add_condition_to(table, "a", setting, random);
  return with_psychometric_options(std::move(table), setting, "1000");
}

/// Half way, the logistic function is at its middle.
std::vector<CheckedInterval> function_intervals(const CoverageSetting&) {
  return {{.quantity = "threshold", .key = "a", .truth = kThreshold},
          {.quantity = "alpha.profile",
           .key = "a",
           .truth = kThreshold,
           .lower = "alpha.profile.lower",
           .upper = "alpha.profile.upper"},
          {.quantity = "threshold.overdispersed",
           .key = "a",
           .truth = kThreshold,
           .lower = "threshold.overdispersed.lower",
           .upper = "threshold.overdispersed.upper"}};
}

std::vector<CheckedTest> function_tests(const CoverageSetting&) {
  return {{.quantity = "deviance.p.chisq", .key = "a"},
          {.quantity = "lr.same.function.p", .key = "a|b"}};
}

std::vector<CheckedInterval> bootstrap_intervals(const CoverageSetting&) {
  return {{.quantity = "bootstrap.threshold",
           .key = "a",
           .truth = kThreshold,
           .lower = "bootstrap.threshold.lower",
           .upper = "bootstrap.threshold.upper"}};
}

std::vector<CheckedTest> bootstrap_tests(const CoverageSetting&) {
  return {{.quantity = "deviance.p.montecarlo", .key = "a"}};
}

// --- participants and textures -----------------------------------------------------------------------

constexpr double kChanceOfTextures = 0.25;
constexpr std::array kAverageProportions{kChanceOfTextures, 0.5, 0.8, 0.95};
constexpr std::array kInterceptSpreads{0.5, 1.0};

double logit(double p) { return std::log(p / (1.0 - p)); }

/// The textures take turns.
template <std::size_t kTextures>
TidyInput draw_crossed(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,texture,hit");
  std::array<double, kTextures> of_textures{};
  for (double& one : of_textures) one = setting.spread * random.normal();
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = logit(setting.effect) + setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const std::size_t texture = (trial + i) % kTextures;
      const double p = 1.0 / (1.0 + std::exp(-own - of_textures[texture]));
      table.add(
          {participant_label(i), std::to_string(texture + 1), random.uniform() < p ? "1" : "0"});
    }
  }
  return std::move(table).as_input();
}

/// What the analysis of a study gives of such responses.
std::vector<Finding> findings_of_other_textures(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn textures = table.all_labels("texture");
  const std::vector<std::uint64_t> hits = table.counts("hit");
  std::vector<TextureResponse> responses{};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    responses.push_back({.person = static_cast<std::uint32_t>(participants.codes[row]),
                         .texture = static_cast<std::uint32_t>(textures.codes[row]),
                         .is_hit = hits[row] == 1});
  }
  AnalysisOutcome outcome{};
  ask_other_textures({.responses = responses, .chance = kChanceOfTextures}, outcome);
  return outcome.findings;
}

std::vector<CheckedInterval> crossed_intervals(const CoverageSetting& setting) {
  return {{.quantity = "glmm.proportion", .truth = setting.effect}};
}

std::vector<CheckedTest> crossed_tests(const CoverageSetting& setting) {
  if (setting.effect != kChanceOfTextures) return {};
  return {{.quantity = "glmm.p", .key = "intercept"}, {.quantity = "glmm.t.p", .key = "intercept"}};
}

/// The analysis needs five participants.
std::vector<CoverageSetting> crossed_settings() {
  std::vector<CoverageSetting> settings = all_designs(kAverageProportions, kInterceptSpreads);
  std::erase_if(settings, [](const CoverageSetting& one) { return one.participants < 5; });
  return settings;
}

}  // namespace

std::span<const CoveragePart> model_parts() {
  static const auto kOfGuessRates = all_designs(kGuessRates, kOneWay);
  static const auto kOfDrawn = [] {
    std::vector<CoverageSetting> settings = kOfGuessRates;
    std::erase_if(settings, [](const CoverageSetting& one) { return one.participants < 5; });
    return settings;
  }();
  static const auto kCrossed = crossed_settings();
  static const std::array kParts{
      CoveragePart{.name = "psychometric",
                   .model = "hits at equally spaced levels (as many as the design has "
                            "participants) by a logistic function with a fixed guess rate and a "
                            "lapse rate of 2 %; two identical conditions",
                   .effect = "guess rate",
                   .spread = "one participant",
                   .settings = kOfGuessRates,
                   .draw = draw_two_functions,
                   .findings = psyfit_findings,
                   .intervals = function_intervals,
                   .tests = function_tests},
      CoveragePart{.name = "bootstrapped",
                   .model = "one condition of `psychometric`, with 1000 tables of the parametric "
                            "bootstrap for each; five levels or more",
                   .effect = "guess rate",
                   .spread = "one participant",
                   .settings = kOfDrawn,
                   .draw = draw_one_function,
                   .findings = psyfit_findings,
                   .intervals = bootstrap_intervals,
                   .tests = bootstrap_tests,
                   .tables = 500},
      CoveragePart{.name = "crossed_textures",
                   .model =
                       "correct responses to four textures in turn; logits of participants and of "
                       "textures are normal; analysed by the function that the analysis of a study "
                       "calls (`ask_other_textures`), which requires five participants",
                   .effect = "proportion correct of an average participant with an average "
                             "texture; .25 is the chance level",
                   .spread = "SD of the logits of participants, and of textures",
                   .settings = kCrossed,
                   .draw = draw_crossed<4>,
                   .findings = findings_of_other_textures,
                   .intervals = crossed_intervals,
                   .tests = crossed_tests},
      CoveragePart{.name = "crossed_ten_textures",
                   .model = "as `crossed_textures`, with ten textures",
                   .effect = "proportion correct of an average participant with an average "
                             "texture; .25 is the chance level",
                   .spread = "SD of the logits of participants, and of textures",
                   .settings = kCrossed,
                   .draw = draw_crossed<10>,
                   .findings = findings_of_other_textures,
                   .intervals = crossed_intervals,
                   .tests = crossed_tests}};
  return kParts;
}

}  // namespace asperity
