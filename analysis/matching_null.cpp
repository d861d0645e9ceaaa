// Fixed points of random permutations, counted.

#include "analysis/matching_null.h"

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "analysis/number_text.h"

namespace asperity {
namespace {

constexpr std::size_t kMostItems = 12;

void refuse_impossible(std::size_t items) {
  if (items < 1 || items > kMostItems) {
    throw std::invalid_argument("items is " + std::to_string(items) +
                                "; matching is counted for 1 to 12 items");
  }
}

std::uint64_t factorial(std::size_t n) {
  std::uint64_t product = 1;
  for (std::uint64_t i = 2; i <= n; ++i) {
    product *= i;
  }
  return product;
}

// D(j) = (j − 1)·(D(j − 1) + D(j − 2)), D(0) = 1, D(1) = 0.
std::uint64_t derangements(std::size_t n) {
  std::array<std::uint64_t, kMostItems + 1> count{1, 0};
  for (std::size_t j = 2; j <= n; ++j) {
    count[j] = (j - 1) * (count[j - 1] + count[j - 2]);
  }
  return count[n];
}

}  // namespace

double item_chance(std::size_t items) {
  refuse_impossible(items);
  return 1.0 / static_cast<double>(items);
}

double whole_chance(std::size_t items) {
  refuse_impossible(items);
  return 1.0 / static_cast<double>(factorial(items));
}

std::vector<double> fixed_point_distribution(std::size_t items) {
  refuse_impossible(items);
  const std::uint64_t all = factorial(items);
  std::vector<double> probability(items + 1);
  for (std::size_t right = 0; right <= items; ++right) {
    const std::uint64_t choices = all / (factorial(right) * factorial(items - right));
    probability[right] =
        static_cast<double>(choices * derangements(items - right)) / static_cast<double>(all);
  }
  return probability;
}

MatchingNull::MatchingNull(const Design& design) {
  if (design.assignments < 1) {
    throw std::invalid_argument("assignments is 0; a null distribution needs at least one");
  }
  const std::vector<double> one = fixed_point_distribution(design.items);
  probability_ = one;
  for (std::size_t i = 1; i < design.assignments; ++i) {
    std::vector<double> sum(probability_.size() + design.items);
    for (std::size_t a = 0; a < probability_.size(); ++a) {
      for (std::size_t b = 0; b < one.size(); ++b) {
        sum[a + b] += probability_[a] * one[b];
      }
    }
    probability_ = std::move(sum);
  }
}

double MatchingNull::upper_tail(std::size_t right) const noexcept {
  if (right == 0) {
    return 1.0;
  }
  double sum = 0.0;
  for (std::size_t k = probability_.size(); k > right; --k) {  // the smallest first
    sum += probability_[k - 1];
  }
  return sum;
}

CountInterval MatchingNull::central_interval(double confidence) const {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument("confidence is " + number_text(confidence) +
                                "; it must lie between 0 and 1");
  }
  const double allowed = 0.5 * (1.0 - confidence);
  CountInterval interval{.low = 0, .high = probability_.size() - 1};
  double below = probability_[interval.low];
  while (below <= allowed) {
    below += probability_[++interval.low];
  }
  double above = probability_[interval.high];
  while (above <= allowed) {
    above += probability_[--interval.high];
  }
  return interval;
}

}  // namespace asperity
