// An interval is drawn only if both of its limits exist and are finite.

#include "app/findings/outcome/finding_parts.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/number_text.h"

namespace asperity {

std::optional<FigureSpan> interval_of(const Finding& finding) {
  if (!finding.low || !finding.high || !std::isfinite(*finding.low) ||
      !std::isfinite(*finding.high)) {
    return {};
  }
  return FigureSpan{.low = *finding.low, .high = *finding.high};
}

bool draws_intervals(std::span<const FigureSeries> series) {
  return std::any_of(series.begin(), series.end(), [](const FigureSeries& one) {
    return std::any_of(one.points.begin(), one.points.end(), [](const FigurePoint& point) {
      return point.x_interval.has_value() || point.y_interval.has_value();
    });
  });
}

std::string percent_of(const std::vector<const Finding*>& findings) {
  for (const Finding* finding : findings) {
    if (finding->confidence) return number_text(std::round(1e6 * *finding->confidence) / 1e4);
  }
  return "95";
}

}  // namespace asperity
