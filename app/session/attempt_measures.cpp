// Selects the ticks in contact, and compares fractions, means and strokes with the bands of the protocol.

#include "app/session/attempt_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "analysis/numbers/summary.h"
#include "analysis/signals/compliance.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/servo/contact.h"

namespace asperity {

namespace {

std::vector<double> sorted_seconds(std::vector<double> nanoseconds) {
  for (double& value : nanoseconds) value *= 1e-9;
  // In simulated time all are equal.
  if (!std::ranges::is_sorted(nanoseconds)) std::ranges::sort(nanoseconds);
  return nanoseconds;
}

ComplianceRow compliance_row(const std::string& quantity, std::span<const double> samples,
                             const Band& band) {
  ComplianceRow row{};
  row.quantity = quantity;
  row.minimum = band.minimum;
  row.maximum = band.maximum;
  if (const auto compliance = compliance_of(samples, {band.minimum, band.maximum})) {
    row.mean = compliance->summary.mean;
    row.sd = compliance->summary.sd;
    row.p05 = compliance->summary.p05;
    row.p50 = compliance->summary.p50;
    row.p95 = compliance->summary.p95;
    row.fraction_in_band = compliance->fraction_inside;
  }
  return row;
}

bool is_declared(const Band& band) { return band.minimum || band.maximum; }

/// A quantity that varies during contact: a minimum fraction of its samples has to lie in the
/// band.
ComplianceRow judged_by_fraction(const std::string& quantity, std::span<const double> samples,
                                 const Band& band, double required_fraction) {
  ComplianceRow row = compliance_row(quantity, samples, band);
  if (is_declared(band)) row.passed = row.fraction_in_band.value_or(0.0) >= required_fraction;
  return row;
}

/// A quantity with one value per surface, or one that is judged by its mean.
ComplianceRow judged_by_mean(const std::string& quantity, std::span<const double> samples,
                             const Band& band) {
  ComplianceRow row = compliance_row(quantity, samples, band);
  if (is_declared(band)) {
    row.passed = !samples.empty() && row.mean >= band.minimum.value_or(row.mean) &&
                 row.mean <= band.maximum.value_or(row.mean);
  }
  return row;
}

/// The strokes of one surface, of which those after the required number of a visit do not count.
class VisitStrokes final {
 public:
  explicit VisitStrokes(std::optional<int> of_visit) : of_visit_(of_visit) {}

  void lift() { strokes_.lift(); }
  void take(double along_m, std::int64_t time_ns) { strokes_.take(along_m, time_ns); }
  /// The hand has lifted from the surface for the last time in this visit.
  void end_visit() {
    const std::vector<double> all = strokes_.lengths_m();
    const std::size_t made = all.size() - read_;
    const std::size_t counted =
        of_visit_ ? std::min(made, static_cast<std::size_t>(*of_visit_)) : made;
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(read_);
    lengths_m_.insert(lengths_m_.end(), first, first + static_cast<std::ptrdiff_t>(counted));
    read_ = all.size();
  }
  /// After the last `end_visit`.
  const std::vector<double>& lengths_m() const noexcept { return lengths_m_; }
  std::vector<double> speeds_m_per_s() const { return strokes_.speeds_m_per_s(); }

 private:
  std::optional<int> of_visit_{};
  HandStrokes strokes_{};
  std::vector<double> lengths_m_{};
  std::size_t read_ = 0;
};

}  // namespace

ServoQualityRow servo_quality_of(std::span<const TickRecord> records, double rate_Hz,
                                 std::uint64_t lost_records) {
  ServoQualityRow row{};
  row.rate_Hz = rate_Hz;
  row.ticks = static_cast<std::int64_t>(records.size());
  row.lost_records = static_cast<std::int64_t>(lost_records);
  std::int64_t missed_in_contact = 0;
  std::vector<double> periods{};
  std::vector<double> lateness{};
  std::vector<double> execution{};
  for (std::size_t i = 0; i < records.size(); ++i) {
    const TickRecord& record = records[i];
    if (i > 0) {
      periods.push_back(static_cast<double>(record.probe.time_ns - records[i - 1].probe.time_ns));
    }
    lateness.push_back(record.lateness_ns);
    execution.push_back(record.execution_ns);
    if (record.has(TickFlag::missed_deadline)) {
      ++row.missed_deadlines;
      if (is_in_contact(record) || (i > 0 && is_in_contact(records[i - 1]))) ++missed_in_contact;
    }
    if (record.has(TickFlag::gap_in_contact)) ++row.gaps_in_contact;
    if (record.has(TickFlag::reading_held)) ++row.held_readings;
    if (record.has(TickFlag::limited_force) || record.has(TickFlag::limited_torque)) {
      ++row.saturated_ticks;
    }
    if (record.has(TickFlag::limited_slew)) ++row.slew_limited_ticks;
    if (record.has(TickFlag::limited_not_finite)) ++row.not_finite_ticks;
  }
  row.missed_in_contact = missed_in_contact;
  if (periods.empty()) return row;
  periods = sorted_seconds(std::move(periods));
  lateness = sorted_seconds(std::move(lateness));
  execution = sorted_seconds(std::move(execution));
  const Summary summary = *summary_of(periods);
  row.period_mean_s = summary.mean;
  row.period_sd_s = summary.sd;
  row.period_p50_s = quantile(periods, 0.5);
  row.period_p99_s = quantile(periods, 0.99);
  row.period_p99_9_s = quantile(periods, 0.999);
  row.period_maximum_s = periods.back();
  row.lateness_p50_s = quantile(lateness, 0.5);
  row.lateness_p99_s = quantile(lateness, 0.99);
  row.lateness_maximum_s = lateness.back();
  row.execution_p99_s = quantile(execution, 0.99);
  row.execution_maximum_s = execution.back();
  return row;
}

std::int64_t gaps_in_contact_of(std::span<const TickRecord> records, std::uint64_t presentation) {
  std::int64_t gaps = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!records[i].has(TickFlag::gap_in_contact)) continue;
    const bool touched_before = i > 0 && is_in_contact(records[i - 1], presentation);
    if (touched_before || is_in_contact(records[i], presentation)) ++gaps;
  }
  return gaps;
}

void fill_times(std::span<const TickRecord> records, std::uint64_t presentation, double rate_Hz,
                PresentationRow& row) {
  std::int64_t contact_ticks = 0;
  for (const TickRecord& record : records) {
    if (!is_rendered(record, presentation)) continue;
    if (!row.onset_ns) row.onset_ns = record.probe.time_ns;
    row.offset_ns = record.probe.time_ns;
    if (!is_in_contact(record, presentation)) continue;
    if (!row.contact_ns) row.contact_ns = record.probe.time_ns;
    ++contact_ticks;
  }
  row.contact_s = static_cast<double>(contact_ticks) / rate_Hz;
}

std::vector<ComplianceRow> compliance_of(std::span<const TickRecord> records,
                                         std::uint64_t presentation, double rate_Hz,
                                         const Exploration& exploration, JudgedForce force,
                                         std::optional<int> strokes_of_visit) {
  ContactReader reader(exploration.direction_rad, force);
  VisitStrokes hand_strokes(strokes_of_visit);
  std::vector<double> force_N{};
  std::int64_t contact_ticks = 0;
  std::int64_t visit_ticks = 0;  // of contact in the present visit (VisitRow)
  std::int64_t longest_visit_ticks = 0;
  for (const TickRecord& record : records) {
    if (is_rendered(record, presentation) && record.has(TickFlag::first_of_presentation)) {
      visit_ticks = 0;
      hand_strokes.end_visit();
    }
    // Another patch side by side is touched.
    if (is_in_contact(record) && record.presentation != presentation &&
        record.presentation != kSideBySide) {
      visit_ticks = 0;
    }
    if (is_in_contact(record, presentation)) {
      ++contact_ticks;
      longest_visit_ticks = std::max(longest_visit_ticks, ++visit_ticks);
    }
    const std::optional<HandSample> hand = reader.take(record);
    if (!hand || hand->presentation != presentation) continue;
    force_N.push_back(hand->pressing_N);
    if (hand->begins_contact) hand_strokes.lift();
    hand_strokes.take(hand->along_m, record.probe.time_ns);
  }
  hand_strokes.end_visit();
  const std::vector<double>& stroke_lengths_m = hand_strokes.lengths_m();
  const std::vector<double> speed_m_per_s = hand_strokes.speeds_m_per_s();
  const double fraction = exploration.required_fraction_in_band;
  const std::array<double, 1> contact_s{static_cast<double>(contact_ticks) / rate_Hz};
  const std::array<double, 1> strokes{static_cast<double>(stroke_lengths_m.size())};
  // The minimum applies to all visits together, the maximum to each visit: a participant who may
  // feel a surface again may feel it for longer in total.
  ComplianceRow contact = compliance_row(
      "contact_s", contact_s, {exploration.minimum_contact_s, {}, exploration.maximum_contact_s});
  contact.fraction_in_band.reset();
  contact.passed =
      contact_s[0] >= exploration.minimum_contact_s &&
      static_cast<double>(longest_visit_ticks) / rate_Hz <= exploration.maximum_contact_s;
  return {judged_by_fraction("normal_force_N", force_N, exploration.normal_force_N, fraction),
          judged_by_fraction("speed_m_per_s", speed_m_per_s, exploration.speed_m_per_s, fraction),
          contact, judged_by_mean("strokes", strokes, exploration.strokes),
          judged_by_mean("stroke_length_m", stroke_lengths_m, exploration.stroke_length_m)};
}

HandHabits habits_for(const Exploration& exploration, const SurfacePatch& patch) {
  const auto aim = [](const Band& band, double otherwise) {
    if (band.target) return *band.target;
    if (band.minimum && band.maximum) return 0.5 * (*band.minimum + *band.maximum);
    return band.maximum ? std::min(otherwise, *band.maximum)
                        : std::max(otherwise, band.minimum.value_or(otherwise));
  };
  HandHabits habits{};
  habits.centre_m = patch.centre_m;
  habits.direction_rad = exploration.direction_rad;
  habits.stroke_length_m = aim(exploration.stroke_length_m, habits.stroke_length_m);
  if (is_declared(exploration.speed_m_per_s) || exploration.speed_m_per_s.target) {
    // The band refers to the mean of a stroke; the habit of a hand is the speed in the middle of a
    // stroke.
    const double mean_of_steady = 1.0 - habits.gathering;
    habits.speed_m_per_s =
        aim(exploration.speed_m_per_s, mean_of_steady * habits.speed_m_per_s) / mean_of_steady;
  }
  habits.normal_force_N = aim(exploration.normal_force_N, habits.normal_force_N);
  return habits;
}

HandHabits habits_over_patches(const Exploration& exploration, const SurfacePatch& workspace,
                               std::span<const SurfacePatch> patches, int minimum_visits) {
  HandHabits habits = habits_for(exploration, workspace);
  const double border_m =
      workspace.edge == PatchEdge::fade ? std::max(kBlend_m, workspace.edge_width_m) : kBlend_m;
  const glm::dvec2 middle_m(workspace.centre_m);
  glm::dvec2 narrowest_m(0.5 * workspace.extent_m);  // half of a patch
  std::vector<glm::dvec3> centres_m{};
  for (const SurfacePatch& patch : patches) {
    const glm::dvec2 own_m(patch.centre_m);
    const glm::dvec2 lowest_m = glm::max(own_m - 0.5 * patch.extent_m + kBlend_m,
                                         middle_m - 0.5 * workspace.extent_m + border_m);
    const glm::dvec2 highest_m = glm::min(own_m + 0.5 * patch.extent_m - kBlend_m,
                                          middle_m + 0.5 * workspace.extent_m - border_m);
    centres_m.emplace_back(0.5 * (lowest_m + highest_m), patch.centre_m.z);
    // A patch within the fading border leaves no room; the hand then moves a little at its middle.
    const glm::dvec2 room_m = glm::max(0.5 * (highest_m - lowest_m), 0.05 * patch.extent_m);
    narrowest_m = glm::min(narrowest_m, room_m);
  }
  const glm::dvec2 along(std::abs(std::cos(habits.direction_rad)),
                         std::abs(std::sin(habits.direction_rad)));
  constexpr double kAcross = 1e-9;  // cos(π/2) is not 0
  double half_m = 0.5 * habits.stroke_length_m;
  for (int axis = 0; axis < 2; ++axis) {
    if (along[axis] > kAcross) half_m = std::min(half_m, narrowest_m[axis] / along[axis]);
  }
  habits.stroke_length_m = 2.0 * half_m;
  // Strokes wander by up to 2.5 standard deviations of the drift, along and across.
  const glm::dvec2 left_m = narrowest_m - half_m * along;
  const double wander_m = std::max(0.0, std::min(left_m.x, left_m.y)) / (along.x + along.y);
  habits.drift_m = std::min(habits.drift_m, wander_m / 2.5);
  habits.centre_m = centres_m.front();
  habits.further_centres = static_cast<int>(centres_m.size()) - 1;
  std::copy(centres_m.begin() + 1, centres_m.end(), habits.further_centres_m.begin());
  const double visits = std::max(1, minimum_visits);
  const auto requested =
      exploration.strokes.target ? exploration.strokes.target : exploration.strokes.minimum;
  const double strokes =
      requested ? std::max(1.0, std::ceil(*requested / visits)) : habits.strokes_at_a_centre;
  const double stroke_s =
      habits.stroke_length_m / (habits.speed_m_per_s * (1.0 - habits.gathering));
  // One visit more than required, for the one that the end cuts off.
  const double longest_visit_s = exploration.maximum_contact_s / (visits + 1.0);
  habits.strokes_at_a_centre =
      std::max(1, static_cast<int>(std::min(strokes, longest_visit_s / stroke_s)));
  return habits;
}

}  // namespace asperity
