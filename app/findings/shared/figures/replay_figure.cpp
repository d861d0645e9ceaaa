// Draws the RMS of both forces and of their difference in nine bands of frequency.

#include "app/findings/shared/figures/replay_figure.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

FigureSeries series_of(const ForceEnergy& energy, double duration_s, const Phrase& name,
                       int style) {
  const std::span<const double> borders_Hz = critical_band_borders_Hz();
  FigureSeries series{.name = name, .style = style, .lines = {{}}};
  for (std::size_t band = 0; band < kCriticalBands; ++band) {
    if (!(energy.bands_N2_s[band] > 0.0)) {
      series.lines.emplace_back();
      continue;
    }
    const FigurePlace place{.x = std::sqrt(borders_Hz[band] * borders_Hz[band + 1]),
                            .y = std::sqrt(energy.bands_N2_s[band] / duration_s)};
    series.points.push_back({.x = place.x, .y = place.y});
    series.lines.back().push_back(place);
  }
  std::erase_if(series.lines, [](const auto& line) { return line.size() < 2; });
  return series;
}

}  // namespace

Figure replay_figure(const ForceDifference& pooled, const std::string& compared) {
  Figure figure{
      .name = "replay",
      .title = phrase("Figures", "Recorded and replayed forces"),
      .note = phrase("Figures",
                     "RMS of the forces in nine bands of frequency, over all recorded "
                     "presentations. The difference is that of the forces in each tick. A band "
                     "without energy has no mark."),
      .x = {.name = phrase("Figures", "frequency"),
            .unit = "Hz",
            .scale = AxisScale::log10,
            .low = critical_band_borders_Hz().front(),
            .high = critical_band_borders_Hz().back()},
      .y = {.name = phrase("Figures", "RMS force"), .unit = "N", .scale = AxisScale::log10}};
  const Phrase replayed = compared.empty() ? phrase("Figures", "replayed force")
                                           : phrase("Figures", "force of %1").with(compared);
  const std::pair<const ForceEnergy*, Phrase> shown[]{
      {&pooled.recorded, phrase("Figures", "recorded force")},
      {&pooled.compared, replayed},
      {&pooled.difference, phrase("Figures", "difference")}};
  double low_N = 0.0;
  double high_N = 0.0;
  int style = 0;
  for (const auto& [energy, name] : shown) {
    FigureSeries series = series_of(*energy, pooled.duration_s, name, style++);
    for (const FigurePoint& point : series.points) {
      low_N = low_N > 0.0 ? std::min(low_N, point.y) : point.y;
      high_N = std::max(high_N, point.y);
    }
    if (!series.points.empty()) figure.series.push_back(std::move(series));
  }
  if (figure.series.empty()) {
    figure.instead = phrase("Figures",
                            "There is no figure, because no force has energy in any band; record "
                            "presentations of a surface that was felt.");
    return figure;
  }
  figure.y.low = low_N / kBeyondMarks;
  figure.y.high = high_N * kBeyondMarks;
  return figure;
}

}  // namespace asperity
