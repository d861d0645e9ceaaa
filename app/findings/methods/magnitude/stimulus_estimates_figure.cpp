// Magnitude estimates by stimulus: over a predictor on logarithmic axes, or as rows.

#include "app/findings/methods/magnitude/stimulus_estimates_figure.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/findings/outcome/drawn_table.h"
#include "app/findings/outcome/finding_parts.h"
#include "app/words/text_parts.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

/// A range above 0.
struct PositiveRange {
  double low = 0.0;
  double high = 0.0;

  void hold(double value) {
    if (!(value > 0.0)) return;
    low = low > 0.0 ? std::min(low, value) : value;
    high = std::max(high, value);
  }
};

/// The series of a condition, made when it is first named.
FigureSeries& series_of(const std::string& condition, Figure& figure,
                        std::vector<std::string>& conditions) {
  const auto at = std::find(conditions.begin(), conditions.end(), condition) - conditions.begin();
  if (at == static_cast<std::ptrdiff_t>(conditions.size())) {
    conditions.push_back(condition);
    figure.series.push_back({.name = condition, .style = static_cast<int>(at)});
  }
  return figure.series[static_cast<std::size_t>(at)];
}

/// Explains only the marks that are drawn.
Phrase note_of(const FoundNumbers& found, const Figure& figure) {
  const std::string percent = percent_of(found.all("geomean"));
  const bool is_within = !found.all("geomean.ci.lower.morey").empty();
  const Phrase means =
      !draws_intervals(figure.series)
          ? phrase("Figures", "Filled symbols: geometric means of the estimates.")
      : is_within
          ? phrase("Figures",
                   "Filled symbols: geometric means of normalised estimates with "
                   "within-participant %1 % CIs (Cousineau and Morey), which serve to compare "
                   "cells and do not include the differences between participants.")
                .with(percent)
          : phrase("Figures",
                   "Filled symbols: geometric means of the estimates with t-based %1 % CIs "
                   "over the participants.")
                .with(percent);
  if (found.all("exponent.mean").empty()) return means;
  return phrase("Figures", "%1 Lines: power functions with the mean exponent.").with(means);
}

/// The line of a condition over the range of the predictor, which is drawn `scale` times as large.
void add_line(const FoundNumbers& found, const std::string& condition, const PositiveRange& x,
              double scale, PositiveRange& y, FigureSeries& series) {
  const auto exponent = found.value("exponent.mean", condition);
  const auto intercept = found.value("intercept.mean", condition);
  if (!exponent || !intercept) return;
  std::vector<FigurePlace>& line = series.lines.emplace_back();
  for (const double end : {x.low, x.high}) {
    const double estimate = std::pow(10.0, *intercept + *exponent * std::log10(end / scale));
    line.push_back({.x = end, .y = estimate});
    y.hold(estimate);
  }
}

}  // namespace

Figure stimulus_estimates_figure(const FoundNumbers& found, const Phrase& predictor,
                                 const std::string& unit) {
  double greatest = 0.0;  // of the predictor
  for (const Finding* value : found.all("predictor")) {
    greatest = std::max(greatest, value->value.value_or(0.0));
  }
  const DrawnUnit drawn = drawn_unit(unit, greatest);
  const double scale = 1.0 / drawn.size;
  Figure figure{.name = "stimulus_estimates",
                .title = phrase("Figures", "Magnitude estimates by stimulus")};
  const bool has_predictor = !found.all("predictor").empty();
  std::vector<std::string> conditions{};
  std::vector<std::string> stimuli{};
  PositiveRange across{};
  PositiveRange estimates{};
  for (const Finding* mean : found.all("geomean")) {
    const std::vector<std::string>& parts = mean->key.names();
    if (parts.size() != 2 || !mean->value || !(*mean->value > 0.0)) continue;
    FigureSeries& series = series_of(parts.front(), figure, conditions);
    const std::optional<FigureSpan> interval = interval_of(*mean);
    estimates.hold(*mean->value);
    if (interval) {
      estimates.hold(interval->low);
      estimates.hold(interval->high);
    }
    if (has_predictor) {
      const double x = scale * found.value("predictor", parts.back()).value_or(0.0);
      if (!(x > 0.0)) continue;
      across.hold(x);
      const bool is_first_condition = parts.front() == conditions.front();  // one label per place
      series.points.push_back({.x = x,
                               .y = *mean->value,
                               .y_interval = interval,
                               .label = is_first_condition ? parts.back() : std::string()});
      continue;
    }
    auto place = std::find(stimuli.begin(), stimuli.end(), parts.back());
    if (place == stimuli.end()) place = stimuli.insert(stimuli.end(), parts.back());
    series.points.push_back({.x = *mean->value,
                             .y = static_cast<double>(place - stimuli.begin()),
                             .x_interval = interval});
  }
  if (conditions.empty()) {
    figure.instead = phrase("Figures",
                            "There are no means, because no participant has an estimate in every "
                            "cell; add the missing estimates.");
    return figure;
  }
  for (std::size_t i = 0; has_predictor && i < conditions.size(); ++i) {
    add_line(found, conditions[i], across, scale, estimates, figure.series[i]);
  }
  figure.note = note_of(found, figure);
  if (conditions.size() == 1) figure.series.front().name = {};
  const bool is_within = !found.all("geomean.ci.lower.morey").empty();
  FigureAxis axis{
      .name = is_within ? phrase("Figures", "normalised estimate") : phrase("Figures", "estimate"),
      .scale = AxisScale::log10,
      .low = estimates.low / kBeyondMarks,
      .high = estimates.high * kBeyondMarks};
  if (has_predictor) {
    figure.x = {.name = predictor,
                .unit = drawn.text,
                .scale = AxisScale::log10,
                .low = across.low / kBeyondMarks,
                .high = across.high * kBeyondMarks};
    figure.y = std::move(axis);
    return figure;
  }
  figure.shape = FigureShape::rows;
  figure.marks_per_row = conditions.size();
  figure.x = std::move(axis);
  for (const std::string& stimulus : stimuli) figure.y.places.emplace_back(stimulus);
  // Marks of several conditions lie one above the other.
  for (std::size_t i = 0; conditions.size() > 1 && i < conditions.size(); ++i) {
    const double apart = 0.6 / static_cast<double>(conditions.size());
    for (FigurePoint& point : figure.series[i].points) {
      point.y +=
          apart * (static_cast<double>(i) - (static_cast<double>(conditions.size()) - 1) / 2);
    }
  }
  return figure;
}

}  // namespace asperity
