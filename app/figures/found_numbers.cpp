#include "app/figures/found_numbers.h"

#include <algorithm>
#include <cmath>

#include "analysis/number_text.h"

namespace asperity {

const Finding* FoundNumbers::find(std::string_view quantity, std::string_view key) const {
  const auto found = std::find_if(findings_.begin(), findings_.end(), [&](const Finding& finding) {
    return finding.quantity == quantity && finding.key == key;
  });
  return found == findings_.end() ? nullptr : &*found;
}

std::optional<double> FoundNumbers::number(std::string_view quantity, std::string_view key) const {
  const Finding* found = find(quantity, key);
  return found == nullptr ? std::nullopt : found->value;
}

std::vector<const Finding*> FoundNumbers::all(std::string_view quantity) const {
  std::vector<const Finding*> found{};
  for (const Finding& finding : findings_) {
    if (finding.quantity == quantity) found.push_back(&finding);
  }
  return found;
}

std::vector<std::string> parts_of(const std::string& key) {
  std::vector<std::string> parts{};
  std::size_t begin = 0;
  for (std::size_t bar = key.find('|'); bar != std::string::npos; bar = key.find('|', begin)) {
    parts.push_back(key.substr(begin, bar - begin));
    begin = bar + 1;
  }
  parts.push_back(key.substr(begin));
  return parts;
}

std::optional<FigureSpan> interval_of(const Finding& finding) {
  if (!finding.low || !finding.high || !std::isfinite(*finding.low) ||
      !std::isfinite(*finding.high)) {
    return {};
  }
  return FigureSpan{.low = *finding.low, .high = *finding.high};
}

std::string percent_of(const std::vector<const Finding*>& findings) {
  for (const Finding* finding : findings) {
    if (finding->confidence) return number_text(std::round(1e6 * *finding->confidence) / 1e4);
  }
  return "95";
}

}  // namespace asperity
