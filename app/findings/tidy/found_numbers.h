// Looks up findings by name.

#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/numbers/finding.h"
#include "app/words/text_parts.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// A missing cell where there is no number.
Cell cell_of(const std::optional<double>& number);

/// Findings by quantity and key. They must outlive this object.
class FoundNumbers final {
 public:
  FoundNumbers() = default;
  explicit FoundNumbers(std::span<const Finding> findings);

  /// Null where there is none.
  const Finding* find(std::string_view quantity, std::string_view key = {}) const;
  /// Nothing where there is no number.
  std::optional<double> value(std::string_view quantity, std::string_view key = {}) const;
  /// All findings of a quantity, in their order.
  std::vector<const Finding*> all(std::string_view quantity) const;
  /// The number as a cell of a table.
  Cell cell(std::string_view quantity, std::string_view key = {}) const;
  /// The number rounded to a whole one, as a cell that is displayed without decimals.
  Cell count(std::string_view quantity, std::string_view key = {}) const;
  /// The ends of the interval of a number, as two cells.
  std::pair<Cell, Cell> interval(std::string_view quantity, std::string_view key = {}) const;

 private:
  std::span<const Finding> in_order_{};
  std::map<std::pair<std::string_view, std::string_view>, const Finding*> findings_{};
};

}  // namespace asperity
