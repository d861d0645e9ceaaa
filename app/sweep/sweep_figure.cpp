// Draws fitted curves and drop points by level, with the estimates of a study in matching styles.

#include "app/sweep/sweep_figure.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr int kCurveSteps = 60;
constexpr double kMargin_dB = 1.0;
constexpr double kSmall = 0.6;

Phrase level_name(VariedQuantity varied, double value) {
  switch (varied) {
    case VariedQuantity::probe_diameter:
      return phrase("Figures", "probe %1 mm").with(text_of_number(kMillimetresPerMetre * value));
    case VariedQuantity::applied_force:
      return phrase("Figures", "force %1 N").with(text_of_number(value));
    case VariedQuantity::exploratory_speed:
      return phrase("Figures", "speed %1 mm/s").with(text_of_number(kMillimetresPerMetre * value));
    case VariedQuantity::turning:
      return phrase("Figures", "turning %1 rad").with(text_of_number(value));
  }
  return {};
}

/// The name states where all levels have the same curve, so that the others do not appear to be
/// missing.
Phrase curve_name(const Sweep& sweep, const SweepCurve& curve) {
  const Phrase level = level_name(sweep.order.varied, curve.value);
  const bool has_none =
      std::any_of(curve.fitted.begin(), curve.fitted.end(),
                  [](const SweepRow& row) { return row.status == kNoEffectByConstruction; });
  return has_none ? phrase("Figures", "%1 (no effect by construction)").with(level) : level;
}

Phrase sweep_title(VariedQuantity varied) {
  switch (varied) {
    case VariedQuantity::probe_diameter:
      return phrase("Figures", "Predicted roughness by probe diameter");
    case VariedQuantity::applied_force:
      return phrase("Figures", "Predicted roughness by applied force");
    case VariedQuantity::exploratory_speed:
      return phrase("Figures", "Predicted roughness by exploratory speed");
    case VariedQuantity::turning:
      return phrase("Figures", "Predicted roughness by amplitude of turning");
  }
  return {};
}

FigureAxis measure_axis(SweepMeasure measure) {
  FigureAxis axis{.unit = "m²/s⁴", .scale = AxisScale::log10};
  switch (measure) {
    case SweepMeasure::max_accel:
      axis.name = phrase("Figures", "maximum acceleration");
      axis.unit = "m/s²";
      break;
    case SweepMeasure::rms_accel:
      axis.name = phrase("Figures", "RMS acceleration");
      axis.unit = "m/s²";
      break;
    case SweepMeasure::fa1:
      axis.name = phrase("Figures", "power from 5 to 50 Hz");
      break;
    case SweepMeasure::fa2:
      axis.name = phrase("Figures", "power from 50 to 500 Hz");
      break;
    case SweepMeasure::pacinian:
      axis = {.name = phrase("Figures", "power relative to the threshold"), .unit = "dB"};
      break;
    case SweepMeasure::rms_torque:
      axis.name = phrase("Figures", "RMS torque");
      axis.unit = "N m";
      break;
    case SweepMeasure::fa1_torque:
      axis.name = phrase("Figures", "power of the torque from 5 to 50 Hz");
      axis.unit = "N² m²";
      break;
    case SweepMeasure::fa2_torque:
      axis.name = phrase("Figures", "power of the torque from 50 to 500 Hz");
      axis.unit = "N² m²";
      break;
    case SweepMeasure::rms_force:
      axis.name = phrase("Figures", "RMS force");
      axis.unit = "N";
      break;
    case SweepMeasure::fa1_force:
      axis.name = phrase("Figures", "power of the force from 5 to 50 Hz");
      axis.unit = "N²";
      break;
    case SweepMeasure::fa2_force:
      axis.name = phrase("Figures", "power of the force from 50 to 500 Hz");
      axis.unit = "N²";
      break;
  }
  return axis;
}

/// The displayed value: decibels are already logarithms.
double shown(const FigureAxis& axis, double log10) {
  return axis.scale == AxisScale::log10 ? std::pow(10.0, log10) : 10.0 * log10;
}

FigurePlace on_curve(const FigureAxis& axis, const Quadratic& curve, double log10_frequency) {
  const double y =
      curve.a + curve.b * log10_frequency + curve.c * log10_frequency * log10_frequency;
  return {.x = std::pow(10.0, log10_frequency), .y = shown(axis, y)};
}

/// A short line at the lower border in the style of each level; one line where all levels have the same drop point.
struct DropPoint {
  double spacing_m = 0.0;
  int style = 0;
};
void mark_drop_points(const std::vector<DropPoint>& points,
                      const std::function<double(double)>& x_of_spacing, Figure& figure) {
  constexpr double kHeight = 0.12;  // of the axis
  bool has_any = false;
  for (const DropPoint& point : points) {
    const double x = x_of_spacing(point.spacing_m);
    if (x < figure.x.low || x > figure.x.high) continue;
    const double top = figure.y.scale == AxisScale::log10
                           ? figure.y.low * std::pow(figure.y.high / figure.y.low, kHeight)
                           : std::lerp(figure.y.low, figure.y.high, kHeight);
    figure.series.push_back(
        {.style = point.style, .lines = {{{.x = x, .y = figure.y.low}, {.x = x, .y = top}}}});
    has_any = true;
  }
  if (!has_any) return;
  figure.note = phrase("Figures",
                       "%1 Lines at the lower border: drop points, the spacings from which on the "
                       "tip reaches the ground between two neighbouring elements.")
                    .with(figure.note);
}

/// The index of the series of a study's estimates with the filled marks of a condition. A single
/// condition has no name.
std::size_t series_of_condition(const Figure& estimates, const std::string& condition) {
  std::vector<std::string> there{};
  for (std::size_t i = 0; i < estimates.series.size(); ++i) {
    const FigureSeries& series = estimates.series[i];
    if (series.hollow) continue;
    const std::string name = series.name.english();
    if (name == condition || name.empty()) return i;
    there.push_back(name);
  }
  std::string names{};
  for (const std::string& name : there) names += (names.empty() ? "" : ", ") + name;
  throw std::runtime_error("the study has no estimates for the condition " + condition +
                           (names.empty() ? "; collect estimates first"
                                          : "; choose a condition with estimates: " + names));
}

}  // namespace

Figure sweep_figure(const Sweep& sweep, SweepMeasure measure) {
  Figure figure{
      .name = "sweep",
      .title = sweep_title(sweep.order.varied),
      .note = phrase(
          "Figures",
          "Filled symbols: strokes of the held tool. Small open symbols: strokes left out "
          "because of their status. Curves: parabolas fitted on logarithmic axes. Large open "
          "symbols: their peaks within the range, with 95 % CIs by Fieller's method."),
      .x = {.name = phrase("Figures", "spatial frequency"),
            .unit = "1/m",
            .scale = AxisScale::log10},
      .y = measure_axis(measure)};
  std::vector<FigurePlace> all{};
  std::vector<DropPoint> drop_points{};
  const std::vector<SweepCurve> curves = curves_of(sweep, measure);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const SweepCurve& curve = curves[i];
    const int style = static_cast<int>(i);
    FigureSeries counted{.name = curve_name(sweep, curve), .style = style};
    FigureSeries excluded{.style = style, .hollow = true};
    for (const SweepRow& row : sweep.rows) {
      const std::optional<double> log10 = log10_of(row, measure);
      if (row.value != curve.value || !log10) continue;
      const bool counts =
          std::any_of(curve.fitted.begin(), curve.fitted.end(),
                      [&row](const SweepRow& fitted) { return fitted.spacing_m == row.spacing_m; });
      const FigurePoint mark{
          .x = 1.0 / row.spacing_m, .y = shown(figure.y, *log10), .size = kSmall};
      (counts ? counted : excluded).points.push_back(mark);
      all.push_back({.x = mark.x, .y = mark.y});
    }
    if (counted.points.empty() && excluded.points.empty()) continue;
    const bool is_new = drop_points.empty() || sweep.order.varied == VariedQuantity::probe_diameter;
    if (const auto drop_m = drop_point_at(sweep.order, curve.value); drop_m && is_new) {
      drop_points.push_back({.spacing_m = *drop_m, .style = style});
    }
    if (curve.fit) {
      const double low = -std::log10(curve.fitted.back().spacing_m);
      const double high = -std::log10(curve.fitted.front().spacing_m);
      std::vector<FigurePlace>& line = counted.lines.emplace_back();
      for (int step = 0; step <= kCurveSteps; ++step) {
        const double part = static_cast<double>(step) / kCurveSteps;
        line.push_back(on_curve(figure.y, curve.fit->curve, std::lerp(low, high, part)));
      }
      all.insert(all.end(), line.begin(), line.end());
    }
    figure.series.push_back(std::move(counted));
    if (!excluded.points.empty()) figure.series.push_back(std::move(excluded));
    if (curve.fit && curve.fit->peak) {
      const FigurePlace top = on_curve(figure.y, curve.fit->curve, curve.fit->peak->x);
      FigurePoint mark{.x = top.x, .y = top.y, .size = 1.4};
      if (curve.fit->fieller) {
        mark.x_interval = FigureSpan{.low = std::pow(10.0, curve.fit->fieller->low),
                                     .high = std::pow(10.0, curve.fit->fieller->high)};
      }
      figure.series.push_back({.style = style, .hollow = true, .points = {mark}});
    }
  }
  if (all.empty()) {
    figure.instead = phrase(
        "Figures",
        "There is no curve, because the tool was not moved; use a stroke with a length above 0.");
    return figure;
  }
  const auto [left, right] = std::minmax_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [bottom, top] = std::minmax_element(
      all.begin(), all.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  figure.x.low = left->x / kBeyondMarks;
  figure.x.high = right->x * kBeyondMarks;
  if (figure.y.scale == AxisScale::log10) {
    figure.y.low = bottom->y / kBeyondMarks;
    figure.y.high = top->y * kBeyondMarks;
  } else {
    figure.y.low = bottom->y - kMargin_dB;
    figure.y.high = top->y + kMargin_dB;
  }
  mark_drop_points(
      drop_points, [](double spacing_m) { return 1.0 / spacing_m; }, figure);
  return figure;
}

void require_estimates(const Figure& estimates, const std::vector<std::string>& conditions) {
  for (const std::string& condition : conditions) (void)series_of_condition(estimates, condition);
}

Figure of_group(Figure estimates, AnswerGroup group) {
  if (group == AnswerGroup::virtual_participants) {
    estimates.y.name = phrase("Figures", "%1 of virtual participants").with(estimates.y.name);
  } else if (group == AnswerGroup::pilot) {
    estimates.y.name = phrase("Figures", "%1 in pilot sessions").with(estimates.y.name);
  }
  return estimates;
}

Figure beside_prediction(Figure estimates, const Sweep& sweep,
                         const std::vector<std::string>& conditions, SweepMeasure measure) {
  const std::vector<SweepCurve> curves = curves_of(sweep, measure);
  if (curves.size() != conditions.size()) {
    throw std::runtime_error("the number of levels of the sweep is " +
                             std::to_string(curves.size()) + " and that of conditions " +
                             std::to_string(conditions.size()) +
                             "; name one condition for each level");
  }
  std::vector<std::size_t> places{};
  for (const std::string& condition : conditions) {
    places.push_back(series_of_condition(estimates, condition));
  }
  double shortest_mm = 0.0;
  double longest_mm = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (const FigureSeries& series : estimates.series) {
    if (series.hollow) continue;
    for (const FigurePoint& point : series.points) {
      shortest_mm = count > 0.0 ? std::min(shortest_mm, point.x) : point.x;
      longest_mm = std::max(longest_mm, point.x);
      sum += std::log(point.y);
      count += 1.0;
    }
  }
  const std::string model =
      sweep.order.stroke.model == nullptr ? "" : sweep.order.stroke.model->declaration.id;
  constexpr double kRounding = 1e-9;  // of the spacings at the ends
  std::vector<FigureSeries> predicted{};
  double predicted_sum = 0.0;
  double predicted_count = 0.0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    FigureSeries& condition = estimates.series[places[i]];
    const Phrase level = curve_name(sweep, curves[i]);
    FigureSeries& marks = predicted.emplace_back(
        FigureSeries{.name = phrase("Figures", "predicted by %1: %2").with(model, level),
                     .style = condition.style,
                     .hollow = true});
    for (const SweepRow& row : curves[i].fitted) {
      const double spacing_mm = kMillimetresPerMetre * row.spacing_m;
      if (spacing_mm < shortest_mm * (1.0 - kRounding) ||
          spacing_mm > longest_mm * (1.0 + kRounding)) {
        continue;
      }
      const std::optional<double> log10 = log10_of(row, measure);
      if (!log10) continue;
      marks.points.push_back({.x = spacing_mm, .y = std::pow(10.0, *log10), .size = kSmall});
      predicted_sum += std::log(marks.points.back().y);
      predicted_count += 1.0;
    }
    if (condition.name.empty()) condition.name = phrase("Figures", "estimates");
  }
  if (predicted_count == 0.0) {
    throw std::runtime_error(
        "no spacing of the sweep lies within the range of the estimated spacings; choose spacings "
        "from " +
        text_of_number(shortest_mm) + " to " + text_of_number(longest_mm) + " mm");
  }
  const double factor = std::exp(sum / count - predicted_sum / predicted_count);
  for (FigureSeries& marks : predicted) {
    for (FigurePoint& mark : marks.points) {
      mark.y *= factor;
      estimates.y.low = std::min(estimates.y.low, mark.y / kBeyondMarks);
      estimates.y.high = std::max(estimates.y.high, mark.y * kBeyondMarks);
    }
    estimates.series.push_back(std::move(marks));
  }
  estimates.note =
      phrase(
          "Figures",
          "%1 Small open symbols: the %2 predicted by a sweep of %3, all multiplied by one factor.")
          .with(estimates.note, measure_axis(measure).name, model);
  std::vector<DropPoint> drop_points{};
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (i > 0 && sweep.order.varied != VariedQuantity::probe_diameter) break;
    if (const auto drop_m = drop_point_at(sweep.order, curves[i].value)) {
      drop_points.push_back({.spacing_m = *drop_m, .style = estimates.series[places[i]].style});
    }
  }
  const auto in_mm = [](double spacing_m) { return kMillimetresPerMetre * spacing_m; };
  mark_drop_points(drop_points, in_mm, estimates);
  return estimates;
}

}  // namespace asperity
