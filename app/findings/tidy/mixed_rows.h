// The measurements of a linear mixed model row by row, from any source, so that no table of them is made.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// What the family `lmm` models. There may be millions of rows: they are visited several times instead of stored.
struct MixedRows {
  struct Row {
    std::optional<double> y{};
    std::size_t participant = 0;        ///< below `participants`
    std::vector<std::size_t> levels{};  ///< as `factors`; LabelColumn::kMissing where it has none
    std::vector<std::optional<double>> covariates{};  ///< as the names
  };
  struct Factor {
    std::string name{};
    std::vector<std::string> levels{};
  };
  std::vector<Factor> factors{};
  std::vector<std::string> covariates{};
  std::size_t participants = 0;
  std::size_t rows = 0;
  /// The model is of the natural logarithms of `y`, which are above 0.
  bool is_logarithmic = false;
  double confidence = 0.95;
  /// Visits all rows, always in the same order.
  std::function<void(const std::function<void(const Row&)>&)> for_each{};
};

/// As the family `lmm`. Throws std::invalid_argument for a `y` without a logarithm, and as `linear_mixed`.
std::vector<Finding> findings_of(const MixedRows& rows);

}  // namespace asperity
