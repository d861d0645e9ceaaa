// Logarithmic buckets.

#include "analysis/power/positive_quantiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numbers/number_text.h"

namespace asperity {

namespace {

constexpr double kError = 0.001;
constexpr double kRatio = (1.0 + kError) / (1.0 - kError);

}  // namespace

void PositiveQuantiles::add(double number) {
  if (!(number >= 0.0)) {
    throw std::invalid_argument("a number is " + number_text(number) + "; it must be at least 0");
  }
  ++count_;
  if (number == 0.0) {
    ++zeros_;
  } else if (std::isfinite(number)) {
    ++buckets_[static_cast<int>(std::ceil(std::log(number) / std::log(kRatio)))];
  }
}

std::optional<double> PositiveQuantiles::quantile(double p) const {
  if (!(p >= 0.0 && p <= 1.0)) {
    throw std::invalid_argument("p is " + number_text(p) + "; it must be from 0 to 1");
  }
  if (count_ == 0) return std::nullopt;
  const auto rank = std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::ceil(p * static_cast<double>(count_))));
  std::uint64_t below = zeros_;
  if (rank <= below) return 0.0;
  for (const auto& [bucket, numbers] : buckets_) {
    below += numbers;
    if (rank <= below) return 2.0 * std::pow(kRatio, bucket) / (kRatio + 1.0);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace asperity
