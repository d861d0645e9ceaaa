// Indexes findings by quantity and key; of equal names, the first is found.

#include "app/findings/outcome/found_numbers.h"

#include <cmath>
#include <cstdint>

namespace asperity {

FoundNumbers::FoundNumbers(std::span<const Finding> findings) : in_order_(findings) {
  for (const Finding& finding : findings) {
    findings_.emplace(std::pair<std::string_view, std::string_view>(finding.quantity, finding.key),
                      &finding);
  }
}

const Finding* FoundNumbers::find(QuantityName quantity, std::string_view key) const {
  const auto found = findings_.find({quantity, key});
  return found == findings_.end() ? nullptr : found->second;
}

std::optional<double> FoundNumbers::value(QuantityName quantity, std::string_view key) const {
  const Finding* finding = find(quantity, key);
  return finding == nullptr ? std::nullopt : finding->value;
}

std::vector<const Finding*> FoundNumbers::all(QuantityName quantity) const {
  std::vector<const Finding*> found{};
  for (const Finding& finding : in_order_) {
    if (finding.quantity == quantity) found.push_back(&finding);
  }
  return found;
}

ResultCell FoundNumbers::cell(QuantityName quantity, std::string_view key) const {
  return cell_of(value(quantity, key));
}

ResultCell FoundNumbers::count(QuantityName quantity, std::string_view key) const {
  const std::optional<double> number = value(quantity, key);
  return number ? ResultCell{static_cast<std::int64_t>(std::llround(*number))} : ResultCell{};
}

ResultCell FoundNumbers::interval(QuantityName quantity, std::string_view key) const {
  const Finding* finding = find(quantity, key);
  return finding == nullptr ? ResultCell{} : interval_cell(finding->low, finding->high);
}

}  // namespace asperity
