// Determines the rows from the requested guidance and its bands, and places ticks at round steps.

#include "app/gui/participant/pages/guide_rows.h"

#include <cmath>

namespace asperity {

GuideRows guide_rows(const Exploration& asked) {
  using Guidance = Exploration::Guidance;
  const auto bounded = [](const Band& band) { return band.minimum || band.maximum; };
  GuideRows rows{};
  if (asked.guidance != Guidance::bars && asked.guidance != Guidance::moving_target) return rows;
  rows.force = bounded(asked.normal_force_N);
  rows.speed = asked.guidance == Guidance::bars && bounded(asked.speed_m_per_s);
  if (asked.guidance == Guidance::moving_target) {
    const bool goes_away =
        std::abs(std::sin(asked.direction_rad)) > std::abs(std::cos(asked.direction_rad));
    rows.track = goes_away ? 4 : 2;
  }
  return rows;
}

double height_of_guide_numbers(double letters_px) { return std::ceil(1.2 * letters_px); }

std::vector<double> guide_ticks(double end) {
  constexpr int kMost = 5;  // beside 0
  constexpr double kRounding = 1e-9;
  if (!(end > 0.0) || !std::isfinite(end)) return {};
  const double decade = std::pow(10.0, std::floor(std::log10(end)) - 1.0);
  double step = decade;
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    step = factor * decade;
    if (end / step < kMost + 1.0 - kRounding) break;
  }
  std::vector<double> ticks{};
  for (int i = 0; i * step <= end * (1.0 + kRounding); ++i) ticks.push_back(i * step);
  return ticks;
}

}  // namespace asperity
