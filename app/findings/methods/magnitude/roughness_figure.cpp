// Estimated roughness by the spacing of a texture.

#include "app/findings/methods/magnitude/roughness_figure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/findings/outcome/single_participants.h"
#include "app/words/text_parts.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr int kStepsOfParabola = 60;  // of a fitted curve

struct Range {
  double low = 0.0;
  double high = 0.0;

  void hold(double value) {
    low = low > 0.0 ? std::min(low, value) : value;
    high = std::max(high, value);
  }
};

bool has_curves(const std::vector<FigureSeries>& series) {
  return std::any_of(series.begin(), series.end(),
                     [](const FigureSeries& one) { return !one.lines.empty(); });
}

/// Whether the intervals are those of normalised estimates; otherwise they are between participants.
bool has_within_intervals(const FoundNumbers& found) {
  return !found.all("geomean.ci.lower.morey").empty();
}

/// Explains only the marks that are drawn.
Phrase roughness_note(const FoundNumbers& found, const std::vector<FigureSeries>& means,
                      const std::vector<FigureSeries>& peaks) {
  const std::string percent = percent_of(found.all("geomean"));
  Phrase note =
      draws_intervals(means) && !has_within_intervals(found)
          ? phrase("Figures",
                   "Filled symbols: geometric means of the estimates with t-based %1 % CIs over "
                   "the participants.")
                .with(percent)
      : draws_intervals(means)
          ? phrase("Figures",
                   "Filled symbols: geometric means of normalised estimates with "
                   "within-participant %1 % CIs (Cousineau and Morey), which serve to compare "
                   "cells and do not include the differences between participants.")
                .with(percent)
          : phrase("Figures", "Filled symbols: geometric means of normalised estimates.");
  if (has_curves(means)) {
    note = phrase("Figures", "%1 Curves: mean parabolas of the log estimates.").with(note);
  }
  if (peaks.empty()) return note;
  return (draws_intervals(peaks)
              ? phrase(
                    "Figures",
                    "%1 Open symbols: significant interior maxima of the curves, with CIs by the "
                    "delta method.")
              : phrase("Figures", "%1 Open symbols: significant interior maxima of the curves."))
      .with(note);
}

}  // namespace

Figure roughness_figure(const FoundNumbers& found, const std::string& unit, CurveNames names) {
  Figure figure{.name = "roughness", .title = phrase("Figures", "Estimated roughness by spacing")};
  // Spacings are drawn in millimetres, like those of a sweep beside them: 0.5 and not 5e-04.
  constexpr double kMillimetre_m = 1.0 / kMillimetresPerMetre;
  const DrawnUnit drawn = drawn_unit(unit, kMillimetre_m);
  const double scale = 1.0 / drawn.size;
  Range x{};
  Range y{};
  std::vector<std::string> probes{};
  std::vector<FigureSeries> peaks{};
  const SinglesByCondition singles = singles_by_condition(found.all("norm.estimate"));
  std::map<std::string, std::vector<SingleValues>> singles_of_probe{};
  const auto series_of = [&](const std::string& probe) -> FigureSeries& {
    const auto at = std::find(probes.begin(), probes.end(), probe) - probes.begin();
    if (at == static_cast<std::ptrdiff_t>(probes.size())) {
      probes.push_back(probe);
      figure.series.push_back({.name = names == CurveNames::alone
                                           ? Phrase(probe)
                                           : phrase("Figures", "probe %1").with(probe),
                               .style = static_cast<int>(at)});
    }
    return figure.series[static_cast<std::size_t>(at)];
  };
  for (const Finding* mean : found.all("geomean")) {
    const auto& [probe, place] = std::pair(mean->key[0], mean->key[1]);
    const auto spacing = number_in(place);
    if (mean->key.size() != 2 || !spacing || !mean->value || !(*mean->value > 0.0)) continue;
    const auto interval = interval_of(*mean);
    series_of(probe).points.push_back(
        {.x = scale * *spacing, .y = *mean->value, .y_interval = interval});
    x.hold(*spacing);
    y.hold(*mean->value);
    if (const auto own = singles.find(mean->key); own != singles.end()) {
      singles_of_probe[probe].push_back({scale * *spacing, own->second});
      for (const double value : own->second) y.hold(value);
    }
    if (interval && interval->low > 0.0) {
      y.hold(interval->low);
      y.hold(interval->high);
    }
  }
  if (probes.empty()) {
    const Finding* status = found.find("status");
    figure.instead =
        status != nullptr
            ? phrase("Figures", "There is no curve: %1.").with(status->status)
            : phrase("Figures",
                     "There is no curve, because there are no estimates; collect estimates first.");
    return figure;
  }
  const double first = std::log10(x.low);
  const double last = std::log10(x.high);
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const auto a = found.value("quad.coef", {probes[i], "a"});
    const auto b = found.value("quad.coef", {probes[i], "b"});
    const auto c = found.value("quad.coef", {probes[i], "c"});
    if (!a || !b || !c) continue;
    std::vector<FigurePlace>& curve = figure.series[i].lines.emplace_back();
    for (int step = 0; step <= kStepsOfParabola; ++step) {
      const double at = std::lerp(first, last, static_cast<double>(step) / kStepsOfParabola);
      const double roughness = std::pow(10.0, *a + *b * at + *c * at * at);
      curve.push_back({.x = scale * std::pow(10.0, at), .y = roughness});
      y.hold(roughness);
    }
    const Finding* peak = found.find("peak", probes[i]);
    const auto height = found.value("peak.height", probes[i]);
    const Finding* status = found.find("peak.status", probes[i]);
    const Finding* interior = found.find("invU.significant", probes[i]);
    if (peak == nullptr || !peak->value || !height || status == nullptr || status->word != "ok") {
      continue;
    }
    if (interior == nullptr || interior->word != "TRUE") continue;
    FigurePoint mark{
        .x = scale * *peak->value, .y = *height, .x_interval = interval_of(*peak), .size = 1.4};
    // An interval wider than the tested range does not locate the peak.
    if (mark.x_interval && mark.x_interval->low < x.low && mark.x_interval->high > x.high) continue;
    if (mark.x_interval) {
      mark.x_interval =
          FigureSpan{.low = scale * mark.x_interval->low, .high = scale * mark.x_interval->high};
    }
    peaks.push_back({.style = static_cast<int>(i), .hollow = true, .points = {mark}});
  }
  figure.note = roughness_note(found, figure.series, peaks);
  figure.series.insert(figure.series.end(), peaks.begin(), peaks.end());
  if (probes.size() == 1) figure.series.front().name = {};
  figure.x = {.name = unit.empty() ? phrase("Figures", "spacing, in the unit of the table")
                                   : phrase("Figures", "spacing"),
              .unit = drawn.text,
              .scale = AxisScale::log10,
              .low = scale * x.low / kBeyondMarks,
              .high = scale * x.high * kBeyondMarks};
  figure.y = {.name = phrase("Figures", "roughness, normalised estimate"),
              .scale = AxisScale::log10,
              .low = y.low / kBeyondMarks,
              .high = y.high * kBeyondMarks};
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const auto own = singles_of_probe.find(probes[i]);
    if (own == singles_of_probe.end()) continue;
    figure.series.push_back(
        singles_in_columns(own->second, figure.x, figure.y, static_cast<int>(i)));
  }
  figure.note = with_note_on_singles(figure.note, figure);
  return figure;
}

}  // namespace asperity
