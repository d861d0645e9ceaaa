// Scales on which the same items have values: principal components of their correlations.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/scales/principal_components.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/simulated_coverage.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {
namespace {

std::string component_name(Eigen::Index component) { return "C" + std::to_string(component + 1); }

/// Which item has no score, and on which scale.
std::string first_missing_score(const Eigen::MatrixXd& values,
                                const std::vector<std::string>& items,
                                const std::vector<std::string>& scales) {
  for (Eigen::Index item = 0; item < values.rows(); ++item) {
    for (Eigen::Index scale = 0; scale < values.cols(); ++scale) {
      if (!std::isnan(values(item, scale))) continue;
      return "the item \"" + items[static_cast<std::size_t>(item)] +
             "\" has no score on the scale \"" + scales[static_cast<std::size_t>(scale)] + '"';
    }
  }
  return {};
}

struct ComponentTables {
  std::vector<std::string> items{};
  std::vector<std::string> scales{};
  std::vector<Eigen::MatrixXd>
      of_people{};           ///< by participant, where the table has the column `subject`
  Eigen::MatrixXd values{};  ///< items × scales, means over participants
};

/// Scores, NaN where there is none, by participant where the table has them.
ComponentTables component_tables(const TidyTable& table) {
  const bool has_people = table.has("subject");
  const LabelColumn items = table.all_labels("item");
  const LabelColumn scales = table.all_labels("scale");
  const LabelColumn people = has_people ? table.all_labels("subject") : LabelColumn{};
  const std::vector<std::optional<double>> scores = table.numbers("score");
  std::vector<Eigen::MatrixXd> tables(
      std::max<std::size_t>(1, people.names.size()),
      Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(items.names.size()),
                                static_cast<Eigen::Index>(scales.names.size()), kUndefined));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!scores[row]) continue;
    const std::size_t person = has_people ? people.codes[row] : 0;
    double& value = tables[person](static_cast<Eigen::Index>(items.codes[row]),
                                   static_cast<Eigen::Index>(scales.codes[row]));
    if (value == value) {
      table.refuse(row, "scale",
                   items.names[items.codes[row]] + " already has a score on \"" +
                       scales.names[scales.codes[row]] + "\"" +
                       (has_people ? " by " + people.names[person] : "") +
                       "; remove one of the rows: an item has one score per scale" +
                       (has_people ? " and participant" : ""));
    }
    value = *scores[row];
  }
  ComponentTables made{.items = items.names, .scales = scales.names, .values = mean_table(tables)};
  if (has_people) made.of_people = std::move(tables);
  return made;
}

}  // namespace

std::vector<Finding> components_findings(const TidyInput& input) {
  const ComponentTables tables = component_tables(input.table());
  const auto& [items, scales, of_people, values] = tables;
  const Eigen::Index rows = values.rows();
  const Eigen::Index columns = values.cols();
  FindingList findings{};
  const auto n = static_cast<std::size_t>(rows);
  const Basis basis{
      .n = n, .method = "principal components of the correlations of the scales over the items"};
  const auto refuse = [&](const char* word, const std::string& status) {
    findings.word("eigenvalue", "", word, status, basis);
    return findings.take();
  };
  if (rows < 3) {
    return refuse("too_few_items",
                  "principal components require at least 3 items, and the table has " +
                      std::to_string(rows) + ": add items");
  }
  if (columns < 2) {
    return refuse("too_few_scales",
                  "principal components require at least 2 scales, and the table has " +
                      std::to_string(columns) + ": add scales");
  }
  if (values.hasNaN()) {
    return refuse("incomplete", first_missing_score(values, items, scales) +
                                    ": enter the score, or leave this item or this scale out");
  }
  if (const std::optional<Eigen::Index> constant = constant_column(values)) {
    return refuse("no_variance", "all items have the same score on the scale \"" +
                                     scales[static_cast<std::size_t>(*constant)] +
                                     "\": leave this scale out");
  }
  const std::optional<PrincipalComponents> found = principal_components(values);
  const ParallelAnalysis noise = parallel_analysis(found->eigenvalues, rows);
  const Basis limit{.n = n,
                    .method = "parallel analysis: 95th percentile of " +
                              std::to_string(noise.data_sets) + " tables of random numbers"};
  findings.count("retained", "", noise.retained, limit);
  const double confidence = input.options.confidence();
  const std::optional<CorrectedComponents> corrected_of =
      corrected_components(of_people, confidence);
  const std::string method_of_corrected = basis.method +
                                          "; without the variance that the participants' "
                                          "deviations add to observed means";
  const auto add_proportion = [&](const FindingKey& key,
                                  const std::optional<ComponentEstimate>& estimate) {
    if (!estimate) return;
    findings.number(
        "proportion.corrected", key, estimate->corrected,
        {.n = of_people.size(),
         .method = method_of_corrected + "; t interval of the jackknife over participants" +
                   simulated_coverage({94, 100}),
         .interval = estimate->interval,
         .confidence = confidence});
  };
  const auto add_loading = [&](const FindingKey& key,
                               const std::optional<ComponentEstimate>& estimate) {
    if (!estimate) return;
    findings.number("loading.corrected", key, estimate->corrected,
                    {.n = of_people.size(),
                     .method = method_of_corrected +
                               "; without an interval by the jackknife over participants" +
                               simulated_coverage({60, 97})});
  };
  for (Eigen::Index component = 0; component < columns; ++component) {
    const auto place = static_cast<std::size_t>(component);
    const std::string name = component_name(component);
    findings.number("eigenvalue", name, found->eigenvalues(component), basis);
    findings.number("proportion", name, found->proportion(component), basis);
    if (corrected_of) add_proportion(name, corrected_of->proportions[place]);
    findings.number("parallel.limit", name, noise.limits(component), limit);
    for (Eigen::Index scale = 0; scale < columns; ++scale) {
      const auto of_scale = static_cast<std::size_t>(scale);
      const FindingKey key{scales[of_scale], name};
      findings.number("loading", key, found->loadings(scale, component), basis);
      if (corrected_of) add_loading(key, corrected_of->loadings[of_scale][place]);
    }
    for (Eigen::Index item = 0; item < rows; ++item) {
      findings.number("score", {items[static_cast<std::size_t>(item)], name},
                      found->scores(item, component), basis);
    }
  }
  return findings.take();
}

}  // namespace asperity
