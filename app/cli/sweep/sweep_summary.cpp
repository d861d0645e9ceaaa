// Prints the results of a sweep.

#include "app/cli/sweep/sweep_summary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "analysis/numbers/number_text.h"
#include "app/cli/output/terminal.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

const char* varied_text(VariedQuantity varied) {
  switch (varied) {
    case VariedQuantity::probe_diameter:
      return "the probe diameter";
    case VariedQuantity::applied_force:
      return "the applied force";
    case VariedQuantity::exploratory_speed:
      return "the exploratory speed";
    case VariedQuantity::turning:
      return "the amplitude of turning";
  }
  return "";
}

/// Rows without a measure to fit whose stroke was complete: nothing moved the tool.
void say_unmoved(const Sweep& sweep, SweepMeasure measure, std::size_t unmoved) {
  const RoughnessStroke& stroke = sweep.order.stroke;
  std::string why = "the acceleration has no power in that band; choose another --measure";
  if (measure == SweepMeasure::max_accel || measure == SweepMeasure::rms_accel) {
    why = "the tool was not accelerated";
    if (stroke.mode == DragMode::constant_height) {
      why += "; at constant height only a force along the stroke accelerates it, and " +
             stroke.model->declaration.id +
             " has none with these parameters; use --drag constant_force, with which the texture "
             "lifts the tool";
    } else {
      why += "; choose another texture or other parameters of the model";
    }
  }
  say("not fitted: " + counted(unmoved, "row") + " with a complete stroke whose " +
      text_of(measure) + " is 0: " + why);
}

}  // namespace

Table summary_table(const Sweep& sweep, SweepMeasure measure) {
  const auto count = [&sweep](double value, const char* status) {
    return static_cast<std::int64_t>(std::count_if(
        sweep.rows.begin(), sweep.rows.end(),
        [&](const SweepRow& row) { return row.value == value && row.status == status; }));
  };
  const std::map<VariedQuantity, const char*> units{{VariedQuantity::probe_diameter, "_m"},
                                                    {VariedQuantity::applied_force, "_N"},
                                                    {VariedQuantity::exploratory_speed, "_m_per_s"},
                                                    {VariedQuantity::turning, ""}};
  Table table{.columns = {text_of(sweep.order.varied) + std::string(units.at(sweep.order.varied)),
                          "rows_fitted", "stick_slip", "not_converged", "lost_contact", "saturated",
                          "greatest_at_mm", "parabola_peak_mm", "low_mm", "high_mm", "r2"}};
  const auto rounded = [](std::optional<double> number, double unit) {
    return number ? Cell(std::round(*number * unit * 1e3) / 1e3) : Cell();
  };
  for (const SweepCurve& curve : curves_of(sweep, measure)) {
    std::optional<double> peak_m{};
    std::optional<double> low_m{};
    std::optional<double> high_m{};
    std::optional<double> r2{};
    if (curve.fit) {
      if (std::isfinite(curve.fit->r2)) r2 = curve.fit->r2;
      if (curve.fit->peak) peak_m = std::pow(10.0, -curve.fit->peak->x);
      if (curve.fit->peak && curve.fit->fieller) {
        low_m = std::pow(10.0, -curve.fit->fieller->high);
        high_m = std::pow(10.0, -curve.fit->fieller->low);
      }
    }
    table.rows.push_back({curve.value, static_cast<std::int64_t>(curve.fitted.size()),
                          count(curve.value, "stick_slip"), count(curve.value, "not_converged"),
                          count(curve.value, "lost_contact"), count(curve.value, "saturated"),
                          rounded(curve.greatest_at_m, 1e3), rounded(peak_m, 1e3),
                          rounded(low_m, 1e3), rounded(high_m, 1e3), rounded(r2, 1.0)});
  }
  return table;
}

void say_without_effect(const Sweep& sweep) {
  const bool is_so = std::any_of(sweep.rows.begin(), sweep.rows.end(), [](const SweepRow& row) {
    return row.status == kNoEffectByConstruction;
  });
  if (!is_so) return;
  say(std::string(kNoEffectByConstruction) + ": " + sweep.order.stroke.model->declaration.id +
      " cannot depend on " + varied_text(sweep.order.varied) +
      "; one stroke per spacing represents all values, and their curves are the same");
}

void say_lost_contact(const Sweep& sweep) {
  const auto lost = std::count_if(sweep.rows.begin(), sweep.rows.end(), [](const SweepRow& row) {
    return row.status == text_of(DragStatus::lost_contact);
  });
  if (lost == 0) return;
  say(std::string(text_of(DragStatus::lost_contact)) + ": " +
      counted(static_cast<std::size_t>(lost), "row") +
      " left out, in which the tool was in the air for more than " +
      number_text(100.0 * kMostWithoutContact) +
      " % of the time; press with a greater --applied-force-n, or choose a lower texture, a slower "
      "stroke, or a hand with more damping (--hand firm)");
}

void say_absent_numbers(const Sweep& sweep, SweepMeasure measure) {
  if (!spacing_has_effect(sweep.order)) {
    say("n/a: the file of --asset is the same at every spacing, so that the force of " +
        sweep.order.stroke.model->declaration.id +
        " does not depend on the spacing and no curve was fitted; compare the levels, or leave out "
        "--asset for the file that the texture suggests at each spacing");
    return;
  }
  bool is_short = false;
  bool is_at_end = false;
  bool has_no_top = false;
  std::map<double, std::size_t> unmoved{};  // by level
  std::size_t all_unmoved = 0;
  for (const SweepRow& row : sweep.rows) {
    if (!row.roughness || log10_of(row, measure)) continue;
    ++unmoved[row.value];
    ++all_unmoved;
  }
  if (all_unmoved > 0) say_unmoved(sweep, measure, all_unmoved);
  for (const SweepCurve& curve : curves_of(sweep, measure)) {
    if (!curve.fit) {
      is_short = is_short || !unmoved.contains(curve.value);
      continue;
    }
    is_at_end = is_at_end || !curve.greatest_at_m;
    has_no_top = has_no_top || !curve.fit->peak;
  }
  if (is_short) {
    say("n/a: a maximum within the range and a parabola need at least three fitted spacings "
        "(--spacings FROM:TO:COUNT; see the column status)");
  }
  if (is_at_end) {
    say("greatest_at_mm n/a: the greatest value is at the first or the last spacing; the maximum "
        "may lie outside the range of spacings: widen --spacings");
  }
  if (has_no_top) {
    say("parabola_peak_mm n/a: the parabola has no maximum within the range of spacings; choose "
        "other --spacings");
  }
}

}  // namespace asperity
