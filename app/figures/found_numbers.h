// Findings by name.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/finding.h"
#include "app/figures/figure.h"

namespace asperity {

/// Looks into findings that outlive it.
class FoundNumbers final {
 public:
  explicit FoundNumbers(std::span<const Finding> findings) : findings_(findings) {}

  const Finding* find(std::string_view quantity, std::string_view key = {}) const;
  /// Nothing where the answer is no number.
  std::optional<double> number(std::string_view quantity, std::string_view key = {}) const;
  /// In their order.
  std::vector<const Finding*> all(std::string_view quantity) const;

 private:
  std::span<const Finding> findings_{};
};

/// The names of things that a key is made of.
std::vector<std::string> parts_of(const std::string& key);

/// From low to high, where the finding has both.
std::optional<FigureSpan> interval_of(const Finding& finding);

/// "95" of a confidence of 0.95; of findings without one likewise.
std::string percent_of(const std::vector<const Finding*>& findings);

}  // namespace asperity
