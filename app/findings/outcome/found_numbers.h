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
#include "app/findings/outcome/result_table.h"
#include "app/findings/tidy/quantity_name.h"

namespace asperity {

/// Findings by quantity and key. They must outlive this object.
class FoundNumbers final {
 public:
  FoundNumbers() = default;
  explicit FoundNumbers(std::span<const Finding> findings);
  /// Those of one of several analyses.
  FoundNumbers(std::span<const Finding> findings, std::string_view analysis);

  bool empty() const noexcept { return in_order_.empty(); }

  /// Null where there is none.
  const Finding* find(QuantityName quantity, const FindingKey& key = {}) const;
  /// Nothing where there is no number.
  std::optional<double> value(QuantityName quantity, const FindingKey& key = {}) const;
  /// All findings of a quantity, in their order.
  std::vector<const Finding*> all(QuantityName quantity) const;
  /// The number as a cell of a table.
  ResultCell cell(QuantityName quantity, const FindingKey& key = {}) const;
  /// The number rounded to a whole one, as a count.
  ResultCell count(QuantityName quantity, const FindingKey& key = {}) const;
  /// The interval of a number; missing where it has no limits.
  ResultCell interval(QuantityName quantity, const FindingKey& key = {}) const;

 private:
  void add(const Finding& finding);

  std::vector<const Finding*> in_order_{};
  std::map<std::pair<std::string_view, FindingKey>, const Finding*> findings_{};
};

}  // namespace asperity
