// Ratings of items on ordered categories and on continuous scales, with participants as random intercepts.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/number_text.h"
#include "tests/coverage/coverage_parts.h"

namespace asperity {

namespace {

constexpr std::array kItemEffects{0.0, 1.0};
constexpr std::array kInterceptSpreads{0.0, 1.0};
constexpr std::array<const char*, 3> kItems{"A", "B", "C"};

/// The items take turns, and differ by equal steps: nothing, half the effect, the effect.
template <class Rating>
DrawnTable rated(std::string_view columns, const CoverageSetting& setting, Random& random,
                 Rating rating) {
  DrawnTable table(columns);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const std::size_t item = (trial + i) % kItems.size();
      const double mean = own + 0.5 * setting.effect * static_cast<double>(item);
      table.add({participant_label(i), kItems[item], rating(mean)});
    }
  }
  return table;
}

// --- ordered categories ------------------------------------------------------------------------------

/// Five categories.
constexpr std::array kThresholds{-1.5, -0.5, 0.5, 1.5};

TidyInput draw_categories(const CoverageSetting& setting, Random& random) {
  TidyInput input =
      rated("subject,item,score", setting, random, [&random](double mean) {
        const double u = random.uniform();
        const double latent = mean + std::log(u / (1.0 - u));
        return std::to_string(1 + std::count_if(kThresholds.begin(), kThresholds.end(),
                                                [latent](double one) { return latent > one; }));
      }).as_input();
  input.options.add("items", "A,B,C");
  return input;
}

std::vector<CheckedInterval> category_intervals(const CoverageSetting& setting) {
  return {{.quantity = "logodds", .key = "C", .truth = setting.effect}};
}

std::vector<CheckedTest> category_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "lr.p"}, {.quantity = "wald.p", .key = "C"}};
}

// --- continuous scales -------------------------------------------------------------------------------

TidyInput draw_continuous(const CoverageSetting& setting, Random& random) {
  TidyInput input = rated("subject,item,y", setting, random, [&random](double mean) {
                      return number_text(mean + random.normal());
                    }).as_input();
  input.options.set("fixed", {{"item", {"A", "B", "C"}}});
  return input;
}

std::vector<CheckedInterval> continuous_intervals(const CoverageSetting& setting) {
  return {{.quantity = "lmm.beta", .key = "item|C", .truth = setting.effect}};
}

std::vector<CheckedTest> continuous_tests(const CoverageSetting& setting) {
  if (setting.effect != 0.0) return {};
  return {{.quantity = "lmm.F.p", .key = "item"}};
}

}  // namespace

std::span<const CoveragePart> rating_parts() {
  static const auto kOfRatings = all_designs(kItemEffects, kInterceptSpreads);
  static const std::array kParts{
      CoveragePart{.name = "ordered_categories",
                   .model = "three items in turn on five ordered categories (proportional odds); a "
                            "participant's intercept is normal; cumulative link mixed model",
                   .effect = "log odds ratio of the third item to the first",
                   .spread = "SD of the intercepts",
                   .settings = kOfRatings,
                   .draw = draw_categories,
                   .findings = ordinal_findings,
                   .intervals = category_intervals,
                   .tests = category_tests,
                   .tables = 10000},
      CoveragePart{.name = "continuous_scale",
                   .model =
                       "three items in turn on a continuous scale, residuals normal with an SD "
                       "of 1; a participant's intercept is normal; linear mixed model",
                   .effect = "difference of the third item from the first",
                   .spread = "SD of the intercepts",
                   .settings = kOfRatings,
                   .draw = draw_continuous,
                   .findings = lmm_findings,
                   .intervals = continuous_intervals,
                   .tests = continuous_tests,
                   .tables = 10000}};
  return kParts;
}

}  // namespace asperity
