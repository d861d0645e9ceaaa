// Mean, spread and quantiles by their definitions.

#include "analysis/numbers/summary.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/numbers/number_text.h"

namespace asperity {

double quantile(std::span<const double> sorted, double p) {
  if (sorted.empty()) {
    throw std::invalid_argument("sorted is empty; a quantile needs at least one value");
  }
  if (!(p >= 0.0 && p <= 1.0)) {
    throw std::invalid_argument("p is " + number_text(p) + "; a quantile needs 0 <= p <= 1");
  }
  const double h = static_cast<double>(sorted.size() - 1) * p;
  const auto below = static_cast<std::size_t>(h);
  if (below + 1 == sorted.size()) {
    return sorted.back();
  }
  return sorted[below] + (h - static_cast<double>(below)) * (sorted[below + 1] - sorted[below]);
}

std::optional<Summary> summary_of(std::span<const double> samples) {
  if (samples.empty()) {
    return std::nullopt;
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!std::isfinite(samples[i])) {
      throw std::invalid_argument("samples: sample " + std::to_string(i) +
                                  " is not finite; all must be finite");
    }
    sum += samples[i];
  }
  Summary summary;
  summary.n = samples.size();
  const auto count = static_cast<double>(samples.size());
  summary.mean = sum / count;
  if (samples.size() > 1) {
    double squares = 0.0;
    for (const double sample : samples) {
      squares += (sample - summary.mean) * (sample - summary.mean);
    }
    summary.sd = std::sqrt(squares / (count - 1.0));
  }
  std::vector<double> sorted(samples.begin(), samples.end());
  if (!std::ranges::is_sorted(sorted)) {
    std::ranges::sort(sorted);
  }
  summary.minimum = sorted.front();
  summary.p05 = quantile(sorted, 0.05);
  summary.p50 = quantile(sorted, 0.5);
  summary.p95 = quantile(sorted, 0.95);
  summary.maximum = sorted.back();
  return summary;
}

}  // namespace asperity
