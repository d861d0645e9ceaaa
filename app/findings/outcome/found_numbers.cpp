// Indexes findings by quantity and key; of equal names, the first is found.

#include "app/findings/outcome/found_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

namespace asperity {

FoundNumbers::FoundNumbers(std::span<const Finding> findings) {
  for (const Finding& finding : findings) add(finding);
}

FoundNumbers::FoundNumbers(std::span<const Finding> findings, std::string_view analysis) {
  for (const Finding& finding : findings) {
    if (finding.analysis == analysis) add(finding);
  }
}

void FoundNumbers::add(const Finding& finding) {
  in_order_.push_back(&finding);
  findings_.emplace(std::pair<std::string_view, FindingKey>(finding.quantity, finding.key),
                    &finding);
}

const Finding* FoundNumbers::find(QuantityName quantity, const FindingKey& key) const {
  const auto found = findings_.find({quantity, key});
  return found == findings_.end() ? nullptr : found->second;
}

std::optional<double> FoundNumbers::value(QuantityName quantity, const FindingKey& key) const {
  const Finding* finding = find(quantity, key);
  return finding == nullptr ? std::nullopt : finding->value;
}

std::vector<const Finding*> FoundNumbers::all(QuantityName quantity) const {
  std::vector<const Finding*> found{};
  std::copy_if(in_order_.begin(), in_order_.end(), std::back_inserter(found),
               [quantity](const Finding* finding) { return finding->quantity == quantity; });
  return found;
}

ResultCell FoundNumbers::cell(QuantityName quantity, const FindingKey& key) const {
  return cell_of(value(quantity, key));
}

ResultCell FoundNumbers::count(QuantityName quantity, const FindingKey& key) const {
  const std::optional<double> number = value(quantity, key);
  return number ? ResultCell{static_cast<std::int64_t>(std::llround(*number))} : ResultCell{};
}

ResultCell FoundNumbers::interval(QuantityName quantity, const FindingKey& key) const {
  const Finding* finding = find(quantity, key);
  return finding == nullptr ? ResultCell{} : interval_cell(finding->low, finding->high);
}

}  // namespace asperity
