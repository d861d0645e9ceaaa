// Walks over the p values in order and keeps the running extreme.

#include "analysis/tests/multiplicity.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>

#include "analysis/numbers/number_text.h"

namespace asperity {
namespace {

std::vector<std::size_t> ascending(std::span<const double> p) {
  for (const double one : p) {
    if (!(one >= 0.0 && one <= 1.0)) {
      throw std::invalid_argument("p is " + number_text(one) + "; it must lie between 0 and 1");
    }
  }
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [p](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  return order;
}

}  // namespace

std::vector<double> holm_adjusted(std::span<const double> p) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> adjusted(p.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    largest = std::max(largest, static_cast<double>(order.size() - i) * p[order[i]]);
    adjusted[order[i]] = std::min(1.0, largest);
  }
  return adjusted;
}

std::vector<double> benjamini_hochberg_adjusted(std::span<const double> p) {
  const std::vector<std::size_t> order = ascending(p);
  std::vector<double> adjusted(p.size());
  double smallest = 1.0;
  for (std::size_t i = order.size(); i-- > 0;) {
    const double share = static_cast<double>(order.size()) / static_cast<double>(i + 1);
    smallest = std::min(smallest, share * p[order[i]]);
    adjusted[order[i]] = smallest;
  }
  return adjusted;
}

}  // namespace asperity
