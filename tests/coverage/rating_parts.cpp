// Ratings of items on ordered categories and on continuous scales, with participants as random intercepts.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "analysis/numbers/number_text.h"
#include "analysis/scales/principal_components.h"
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

// --- effects of items that vary over participants ----------------------------------------------------

constexpr std::array<const char*, 4> kVaryingItems{"A", "B", "C", "D"};
constexpr std::array kEqualMeans{0.0};
constexpr std::array kSpreadsOfEffects{0.0, 0.5, 1.0};

/// Four items in turn; the effects of a participant are normal around 0, and the residuals have an SD of 1.
template <class Rating>
DrawnTable varying(std::string_view columns, const CoverageSetting& setting, Random& random,
                   Rating rating) {
  DrawnTable table(columns);
  for (std::size_t i = 0; i < setting.participants; ++i) {
    const double own = random.normal();
    std::array<double, kVaryingItems.size()> effects{};
    for (double& one : effects) one = setting.spread * random.normal();
    for (std::size_t trial = 0; trial < setting.trials; ++trial) {
      const std::size_t item = (trial + i) % kVaryingItems.size();
      table.add({participant_label(i), kVaryingItems[item],
                 rating(own + effects[item] + random.normal())});
    }
  }
  return table;
}

TidyInput draw_varying_items(const CoverageSetting& setting, Random& random) {
  TidyInput input = varying("subject,item,y", setting, random, [](double y) {
                      return number_text(y);
                    }).as_input();
  const std::vector<std::pair<std::string, std::vector<std::string>>> items{
      {"item", {kVaryingItems.begin(), kVaryingItems.end()}}};
  input.options.set("fixed", items);
  input.options.set("within", items);
  return input;
}

/// The same ratings on five categories.
TidyInput draw_varying_categories(const CoverageSetting& setting, Random& random) {
  constexpr std::array kBorders{-1.2, -0.4, 0.4, 1.2};
  TidyInput input =
      varying("subject,item,score", setting, random, [&kBorders](double y) {
        return std::to_string(1 + std::count_if(kBorders.begin(), kBorders.end(),
                                                [y](double border) { return y > border; }));
      }).as_input();
  input.options.add("items", "A,B,C,D");
  return input;
}

std::vector<CheckedTest> varying_category_tests(const CoverageSetting&) {
  return {{.quantity = "lr.p"}};
}

/// The linear mixed model of the responses, and the analysis of variance of the participants' means.
std::vector<Finding> findings_of_varying_items(const TidyInput& input) {
  std::vector<Finding> findings = lmm_findings(input);
  const std::vector<Finding> anova = rmanova_findings(input);
  findings.insert(findings.end(), anova.begin(), anova.end());
  return findings;
}

std::vector<CheckedInterval> varying_item_intervals(const CoverageSetting&) {
  return {{.quantity = "pair.diff", .key = "item|A|D", .truth = 0.0},
          {.quantity = "lmm.beta", .key = "item|D", .truth = 0.0}};
}

std::vector<CheckedTest> varying_item_tests(const CoverageSetting&) {
  return {{.quantity = "p.GG", .key = "item"}, {.quantity = "lmm.F.p", .key = "item"}};
}

/// Those in which every participant rates every item.
std::vector<CoverageSetting> varying_item_settings() {
  std::vector<CoverageSetting> settings = all_designs(kEqualMeans, kSpreadsOfEffects);
  std::erase_if(settings, [](const CoverageSetting& one) {
    return one.trials < kVaryingItems.size() || one.participants < 3;
  });
  return settings;
}

// --- principal components of mean ratings ------------------------------------------------------------

constexpr std::size_t kRatedItems = 10;
constexpr std::size_t kRatedScales = 8;
constexpr std::array kSpreadsOfRatings{0.5, 1.0};
using RatingTable = std::array<std::array<double, kRatedScales>, kRatedItems>;

/// True means: a common variable with the loadings below, and an own part of each cell.
const RatingTable& true_means() {
  static const RatingTable kMeans = [] {
    constexpr std::array kLoadings{0.9, -0.9, 0.8, 0.8, -0.7, 0.9, 0.6, -0.8};
    constexpr double kOwnPart = 0.35;
    Random random = Random(5).split("components");
    RatingTable means{};
    for (auto& of_item : means) {
      const double common = random.normal();
      for (std::size_t scale = 0; scale < kRatedScales; ++scale) {
        of_item[scale] = common * kLoadings[scale] + kOwnPart * random.normal();
      }
    }
    return means;
  }();
  return kMeans;
}

TidyInput draw_mean_ratings(const CoverageSetting& setting, Random& random) {
  DrawnTable table("subject,item,scale,score");
  for (std::size_t i = 0; i < setting.participants; ++i) {
    for (std::size_t item = 0; item < kRatedItems; ++item) {
      for (std::size_t scale = 0; scale < kRatedScales; ++scale) {
        table.add({participant_label(i), std::to_string(item), std::to_string(scale),
                   number_text(true_means()[item][scale] + setting.spread * random.normal())});
      }
    }
  }
  return std::move(table).as_input();
}

struct FirstComponent {
  double proportion = 0.0;
  double loading_of_first = 0.0;  ///< with the sign that makes the largest loading positive
};

/// By power iteration on the correlations of the true means.
FirstComponent first_component() {
  std::array<std::array<double, kRatedItems>, kRatedScales> z{};
  for (std::size_t scale = 0; scale < kRatedScales; ++scale) {
    double mean = 0.0;
    for (const auto& of_item : true_means())
      mean += of_item[scale] / static_cast<double>(kRatedItems);
    double squares = 0.0;
    for (const auto& of_item : true_means()) {
      squares += (of_item[scale] - mean) * (of_item[scale] - mean);
    }
    for (std::size_t item = 0; item < kRatedItems; ++item) {
      z[scale][item] = (true_means()[item][scale] - mean) / std::sqrt(squares);
    }
  }
  std::array<double, kRatedScales> axis{};
  axis.fill(1.0);
  axis[1] = -1.0;
  double eigenvalue = 0.0;
  for (int step = 0; step < 500; ++step) {
    std::array<double, kRatedScales> next{};
    for (std::size_t a = 0; a < kRatedScales; ++a) {
      for (std::size_t b = 0; b < kRatedScales; ++b) {
        double correlation = 0.0;
        for (std::size_t item = 0; item < kRatedItems; ++item)
          correlation += z[a][item] * z[b][item];
        next[a] += correlation * axis[b];
      }
    }
    double length = 0.0;
    for (const double one : next) length += one * one;
    eigenvalue = std::sqrt(length);
    for (std::size_t a = 0; a < kRatedScales; ++a) axis[a] = next[a] / eigenvalue;
  }
  const double largest = *std::max_element(axis.begin(), axis.end(), [](double one, double other) {
    return std::abs(one) < std::abs(other);
  });
  return {.proportion = eigenvalue / static_cast<double>(kRatedScales),
          .loading_of_first = (largest < 0.0 ? -1.0 : 1.0) * std::sqrt(eigenvalue) * axis[0]};
}

/// The family gives corrected loadings no interval, and states the coverage that this one has: that of the jackknife over the
/// participants.
std::vector<Finding> findings_of_components(const TidyInput& input) {
  const TidyTable& table = input.table();
  const LabelColumn participants = table.all_labels("subject");
  const LabelColumn items = table.all_labels("item");
  const LabelColumn scales = table.all_labels("scale");
  const std::vector<double> scores = table.all_numbers("score");
  std::vector<Eigen::MatrixXd> of_people(participants.names.size(),
                                         Eigen::MatrixXd(kRatedItems, kRatedScales));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    of_people[participants.codes[row]](static_cast<Eigen::Index>(items.codes[row]),
                                       static_cast<Eigen::Index>(scales.codes[row])) = scores[row];
  }
  const std::optional<CorrectedComponents> corrected =
      corrected_components(of_people, input.options.confidence());
  std::vector<Finding> findings = components_findings(input);
  for (Finding& finding : findings) {
    if (!corrected || finding.quantity != "loading.corrected" || finding.key != "0|C1") continue;
    const std::optional<ComponentEstimate>& loading = corrected->loadings.front().front();
    if (!loading) continue;
    finding.low = loading->interval.low;
    finding.high = loading->interval.high;
  }
  return findings;
}

std::vector<CheckedInterval> component_intervals(const CoverageSetting&) {
  const FirstComponent first = first_component();
  return {{.quantity = "proportion.corrected", .key = "C1", .truth = first.proportion},
          {.quantity = "loading.corrected", .key = "0|C1", .truth = first.loading_of_first}};
}

/// Those with an estimate.
std::vector<CoverageSetting> component_settings() {
  std::vector<CoverageSetting> settings = all_designs(kEqualMeans, kSpreadsOfRatings);
  std::erase_if(settings, [](const CoverageSetting& one) { return one.participants < 5; });
  return settings;
}

}  // namespace

std::span<const CoveragePart> rating_parts() {
  static const auto kOfVarying = varying_item_settings();
  static const auto kOfComponents = component_settings();
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
                   .tables = 10000},
      CoveragePart{.name = "varying_items",
                   .model = "four items in turn on a continuous scale, residuals normal with an SD "
                            "of 1; the effects of the items vary over the participants around "
                            "equal means; linear mixed model with random intercepts, and analysis "
                            "of variance of the participants' means",
                   .effect = "always 0",
                   .spread = "SD of the effects over the participants",
                   .settings = kOfVarying,
                   .draw = draw_varying_items,
                   .findings = findings_of_varying_items,
                   .intervals = varying_item_intervals,
                   .tests = varying_item_tests,
                   .tables = 4000},
      CoveragePart{.name = "varying_categories",
                   .model = "the ratings of `varying_items` on five ordered categories with the "
                            "borders ±0.4 and ±1.2; cumulative link mixed model with random "
                            "intercepts",
                   .effect = "always 0",
                   .spread = "SD of the effects over the participants",
                   .settings = kOfVarying,
                   .draw = draw_varying_categories,
                   .findings = ordinal_findings,
                   .intervals = no_intervals,
                   .tests = varying_category_tests,
                   .tables = 1000},
      CoveragePart{.name = "components",
                   .model = "ten items on eight scales, whose true means have a first principal "
                            "component of about nine tenths of the variance; a participant's "
                            "ratings vary independently around them",
                   .effect = "always 0",
                   .spread = "SD of the participants' ratings",
                   .settings = kOfComponents,
                   .draw = draw_mean_ratings,
                   .findings = findings_of_components,
                   .intervals = component_intervals,
                   .tests = no_tests,
                   .tables = 1000}};
  return kParts;
}

}  // namespace asperity
