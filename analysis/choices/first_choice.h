// Scales on which alternatives lie when each choice is the best of all.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity {

/// Luce's model: P(j) ∝ w_j, so that the shares are the worths. Relative to one alternative,
/// ln(x_j/x_reference) with the standard error √(1/x_j + 1/x_reference). Where any count is 0, ½ is
/// added to all (`half_added`), or nothing finite would come out.
struct LuceWorths {
  bool half_added = false;
  std::vector<double> share{};           ///< with the halves, where they were added
  std::vector<double> log_worth{};       ///< 0 for the reference
  std::vector<double> standard_error{};  ///< 0 for the reference
};
LuceWorths luce_worths(std::span<const std::uint64_t> counts, std::size_t reference);

/// Thurstone's model of the best of K: each alternative j gives a value of N(μ_j, 1), independent of
/// the others, and the largest is chosen,
///
///   P(j) = ∫ φ(z − μ_j)·Π_{k≠j} Φ(z − μ_k) dz.
///
/// The μ with Σμ = 0 at which these are `shares`. The unit is the standard deviation of one value.
/// Throws std::invalid_argument unless the shares are at least two, positive, and sum to 1.
std::vector<double> first_choice_means(std::span<const double> shares);

}  // namespace asperity
