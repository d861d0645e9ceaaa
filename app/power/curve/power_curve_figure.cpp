// Names the curves by the properties in which they differ, and draws at most six.

#include "app/power/curve/power_curve_figure.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "app/power/curve/planned_sample.h"

namespace asperity {

namespace {

constexpr std::size_t kMostCurves = 6;  // as many as are distinguishable

using Curves = std::vector<const PowerCurve*>;

Curves those(std::span<const PowerCurve> curves, bool families) {
  Curves chosen{};
  for (const PowerCurve& curve : curves) {
    if (curve.test.empty() == families) chosen.push_back(&curve);
  }
  return chosen;
}

Curves shown_curves(std::span<const PowerCurve> curves) {
  Curves tests = those(curves, false);
  Curves families = those(curves, true);
  Curves shown = tests.size() <= kMostCurves || families.empty() ? tests : families;
  if (shown.size() > kMostCurves) shown.resize(kMostCurves);
  return shown;
}

/// The properties of a curve that differ between the curves: "comparisons.rougher.slope=0.8 · order".
Phrase name_of(const PowerCurve& curve, const Curves& all) {
  const auto differs = [&](const std::string PowerCurve::*part) {
    return std::any_of(all.begin(), all.end(),
                       [&](const PowerCurve* other) { return other->*part != curve.*part; });
  };
  const Phrase test =
      curve.test.empty()
          ? phrase("Figures", "at least one test of the family %1").with(curve.family)
          : Phrase(curve.test);
  const bool has_effect = differs(&PowerCurve::effect);
  if (!differs(&PowerCurve::test) && !differs(&PowerCurve::family)) {
    return has_effect ? Phrase(curve.effect) : Phrase{};
  }
  return has_effect ? phrase("Figures", "%1 · %2").with(curve.effect, test) : test;
}

FigureSeries series_of(const PowerCurve& curve, Phrase name, int style) {
  FigureSeries series{.name = std::move(name), .style = style};
  std::vector<FigurePlace>& line = series.lines.emplace_back();
  for (const TestAtSize& size : curve.sizes) {
    const double n = size.power.participants;
    series.points.push_back({.x = n,
                             .y = size.power.power,
                             .y_interval = FigureSpan{.low = size.power.interval.low,
                                                      .high = size.power.interval.high}});
    line.push_back({.x = n, .y = size.power.fitted});
  }
  return series;
}

}  // namespace

Figure power_curve_figure(std::span<const PowerCurve> curves) {
  Figure figure{
      .name = "power_curve",
      .title = phrase("Figures", "Power over the number of participants"),
      .note = phrase("Figures",
                     "Marks: proportions of significant simulated studies, with 95 % Monte-Carlo "
                     "CIs (Clopper–Pearson). Lines: monotone fits (isotonic regression). Dashed "
                     "lines: powers of 80 % and 90 %."),
      .x = {.name = phrase("Figures", "participants")},
      .y = {.name = phrase("Figures", "power: probability of detecting the effect"),
            .low = 0.0,
            .high = 1.0}};
  const Curves shown = shown_curves(curves);
  if (shown.empty()) {
    figure.instead = phrase("Figures", "There is no power curve, because no study was simulated.");
    return figure;
  }
  for (const PowerCurve* curve : shown) {
    figure.series.push_back(
        series_of(*curve, name_of(*curve, shown), static_cast<int>(figure.series.size())));
  }
  const std::vector<TestAtSize>& sizes = shown.front()->sizes;
  const double least = sizes.front().power.participants;
  const double most = sizes.back().power.participants;
  const double room = most > least ? 0.05 * (most - least) : 1.0;
  figure.x.low = std::max(0.0, least - room);
  figure.x.high = most + room;
  figure.references.push_back({.at = FigureReference::At::y,
                               .value = kWantedPowers[0],
                               .label = phrase("Figures", "80 %")});
  figure.references.push_back({.at = FigureReference::At::y,
                               .value = kWantedPowers[1],
                               .label = phrase("Figures", "90 %")});
  return figure;
}

}  // namespace asperity
