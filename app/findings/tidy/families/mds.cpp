// Multidimensional scaling of one table of dissimilarities: classical, ratio and non-metric.

#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/dissimilarity/multidimensional_scaling.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/rated_pairs.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

struct ScaledTable {
  std::vector<std::string> items{};
  WeightedDissimilarities given{};
};

ScaledTable scaled_table(const TidyInput& input) {
  const TidyTable& table = input.table();
  ScaledTable made{.items = input.options.texts("items")};
  const LabelColumn first = table.labels("item", made.items);
  const LabelColumn second = table.labels("other", made.items);
  const std::vector<std::optional<double>> values = table.numbers("dissimilarity");
  const auto m = static_cast<Eigen::Index>(made.items.size());
  made.given = {.values = Dissimilarities::Zero(m, m), .weights = Eigen::MatrixXd::Zero(m, m)};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (const auto& [column, labels] : {std::pair{"item", &first}, std::pair{"other", &second}}) {
      if (labels->codes[row] == LabelColumn::kMissing)
        table.refuse(row, column, "the item is missing; enter it, or remove the row");
    }
    const auto i = static_cast<Eigen::Index>(first.codes[row]);
    const auto j = static_cast<Eigen::Index>(second.codes[row]);
    if (i == j) table.refuse(row, "other", "a pair has two different items; remove this row");
    if (!values[row]) continue;
    if (*values[row] < 0.0)
      table.refuse(row, "dissimilarity", "a dissimilarity is at least 0; correct it");
    if (made.given.weights(i, j) > 0.0) {
      table.refuse(row, "other",
                   "this pair already has a dissimilarity; combine the two rows into one");
    }
    for (const auto& [a, b] : {std::pair{i, j}, std::pair{j, i}}) {
      made.given.values(a, b) = *values[row];
      made.given.weights(a, b) = 1.0;
    }
  }
  return made;
}

/// The number of an item in the order of the values; equal ones share their mean.
std::vector<double> mean_ranks(const std::vector<double>& values) {
  std::vector<double> ranks(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    double below = 0.0;
    double equal = 0.0;
    for (const double other : values) {
      below += other < values[i] ? 1.0 : 0.0;
      equal += other == values[i] ? 1.0 : 0.0;
    }
    ranks[i] = below + 0.5 * (equal + 1.0);
  }
  return ranks;
}

void add_distances(const std::string& quantity, const ScaledTable& table,
                   const Eigen::MatrixXd& points, double factor, const std::string& method,
                   FindingList& findings) {
  const Dissimilarities distances = factor * distances_between(points);
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    for (std::size_t j = i + 1; j < table.items.size(); ++j) {
      findings.number(quantity, {table.items[i], table.items[j]},
                      distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                      {.n = table.items.size(), .method = method});
    }
  }
}

void add_classical(const ScaledTable& table, Eigen::Index dimensions, FindingList& findings) {
  const std::size_t n = table.items.size();
  const ClassicalScaling map = classical_scaling(table.given.values, dimensions);
  for (Eigen::Index i = 0; i < map.eigenvalues.size(); ++i) {
    findings.number("classical.eig", std::to_string(i + 1), map.eigenvalues(i),
                    {.n = n, .method = "eigenvalue of classical scaling"});
  }
  findings.number("classical.gof1", "", map.fit_of_absolute.value_or(kUndefined),
                  {.n = n, .method = "eigenvalues of the dimensions / sum of |eigenvalues|"});
  findings.number(
      "classical.gof2", "", map.fit_of_positive.value_or(kUndefined),
      {.n = n, .method = "eigenvalues of the dimensions / sum of the positive eigenvalues"});
  add_distances("classical.dist", table, map.points, 1.0, "distance in the classical configuration",
                findings);
}

void add_ratio(const ScaledTable& table, Eigen::Index dimensions, FindingList& findings) {
  const std::size_t n = table.items.size();
  const Configuration map =
      scaled(table.given, {.dimensions = dimensions, .level = ScalingLevel::ratio});
  double raw = 0.0;
  double square = 0.0;
  for (const ShepardPoint& pair : shepard_diagram(table.given, map.points, ScalingLevel::ratio)) {
    raw += (pair.dissimilarity - pair.distance) * (pair.dissimilarity - pair.distance);
    square += pair.distance * pair.distance;
  }
  const std::string method = "metric scaling (SMACOF), unit of the dissimilarities";
  findings.number("ratio.rawstress", "", raw,
                  {.n = n, .method = method + ": sum of squared differences"});
  findings.number("ratio.stress1", "", std::sqrt(raw / square),
                  {.n = n, .method = method + ": √(raw stress / sum of squared distances)"});
  add_distances("ratio.dist", table, map.points, 1.0, method + ": distance", findings);
}

void add_nonmetric(const ScaledTable& table, Eigen::Index dimensions, FindingList& findings) {
  const std::size_t n = table.items.size();
  const Configuration map = scaled(table.given, {.dimensions = dimensions, .random_starts = 60});
  const std::string method = "non-metric scaling (SMACOF), primary approach to ties";
  findings.number("nonmetric.stress1", "", map.stress_1,
                  {.n = n, .method = method + ": Kruskal's stress-1"});
  std::vector<double> distances{};
  std::vector<double> dissimilarities{};
  double square = 0.0;
  for (const ShepardPoint& pair : shepard_diagram(table.given, map.points, ScalingLevel::ordinal)) {
    distances.push_back(pair.distance);
    dissimilarities.push_back(pair.dissimilarity);
    square += pair.distance * pair.distance;
  }
  findings.number(
      "nonmetric.rho", "",
      pearson_correlation(mean_ranks(distances), mean_ranks(dissimilarities)).value_or(kUndefined),
      {.n = n, .method = method + ": Spearman's correlation of distances and dissimilarities"});
  add_distances("nonmetric.dist", table, map.points,
                std::sqrt(static_cast<double>(distances.size()) / square),
                method + ": distance, root mean square 1", findings);
}

}  // namespace

std::vector<Finding> mds_findings(const TidyInput& input) {
  const ScaledTable table = scaled_table(input);
  const double wanted = input.options.number_or("dimensions", 2.0);
  const auto items = static_cast<double>(table.items.size());
  FindingList findings{};
  if (!(wanted >= 1.0 && wanted < items && wanted == std::floor(wanted))) {
    throw std::runtime_error(
        "the option \"dimensions\" must be a whole number from 1 to the number of items less 1, " +
        std::to_string(table.items.empty() ? 0 : table.items.size() - 1) + "; correct it");
  }
  if (!connects_all_items(table.given.weights)) {
    findings.word("nonmetric.stress1", "", "not_connected",
                  "the pairs with a dissimilarity do not connect all items: add pairs between the "
                  "separate groups of items",
                  {.n = table.items.size(), .method = "multidimensional scaling"});
    return findings.take();
  }
  const auto dimensions = static_cast<Eigen::Index>(wanted);
  const Eigen::Index m = table.given.values.rows();
  if ((table.given.weights.array() > 0.0).count() == m * (m - 1))
    add_classical(table, dimensions, findings);
  add_ratio(table, dimensions, findings);
  add_nonmetric(table, dimensions, findings);
  return findings.take();
}

}  // namespace asperity
