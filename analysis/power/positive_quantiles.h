// Quantiles of any number of positive numbers in bounded memory.

#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace asperity {

/// Counts numbers in buckets whose bounds have the ratio γ = (1 + a)/(1 − a), a = 0.001: bucket i holds γ^(i−1) < x ≤ γ^i and is
/// represented by 2·γ^i/(γ + 1), which differs from each of its numbers by a relative error of at most a [Masson 2019]. The memory
/// depends on the range of the numbers (1151 buckets for a factor of 10), not on how many there are; the result does not depend on
/// their order.
///
/// [Masson 2019] Masson, Rim, Lee: DDSketch: a fast and fully-mergeable quantile sketch with relative-error guarantees.
class PositiveQuantiles final {
 public:
  /// 0 and infinity are counted as they are. Throws std::invalid_argument for a negative number and for NaN.
  void add(double number);

  std::uint64_t count() const noexcept { return count_; }
  /// The ⌈p·count⌉-th smallest number, at least the first, with a relative error of at most 0.001; nothing without numbers.
  /// Throws std::invalid_argument for p outside [0, 1].
  std::optional<double> quantile(double p) const;

 private:
  std::map<int, std::uint64_t> buckets_{};  ///< of the finite numbers above 0, by i
  std::uint64_t zeros_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace asperity
