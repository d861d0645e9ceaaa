// Cuts the ticks into contacts, thins paths, and reduces curves to the extremes of each column of pixels.

#include "app/records/recording_curves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "analysis/numbers/number_text.h"
#include "analysis/signals/compliance.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/servo/contact.h"

namespace asperity {

namespace {

constexpr double kPathStep_m = 0.25e-3;  // about a pixel where a patch of 100 mm fills its plot
constexpr std::size_t kWindow = 1024;    // about one second: lines 1 Hz apart
constexpr std::size_t kShortWindow = 256;

bool is_limited(const TickRecord& record) {
  return record.has(TickFlag::limited_not_finite) || record.has(TickFlag::limited_force) ||
         record.has(TickFlag::limited_torque) || record.has(TickFlag::limited_slew);
}

/// Consecutive ticks except for short gaps: first and last tick.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  std::uint64_t presentation = 0;
};

template <class Belongs>
std::vector<Run> runs_of(std::span<const TickRecord> records, double longest_gap_s,
                         const Belongs& belongs) {
  const auto longest_gap_ns = static_cast<std::int64_t>(longest_gap_s * 1e9);
  std::vector<Run> runs{};
  for (std::size_t i = 0; i < records.size(); ++i) {
    if (!belongs(records[i])) continue;
    const bool goes_on =
        !runs.empty() && runs.back().presentation == records[i].presentation &&
        records[i].probe.time_ns - records[runs.back().last].probe.time_ns <= longest_gap_ns;
    if (goes_on) {
      runs.back().last = i;
    } else {
      runs.push_back({i, i, records[i].presentation});
    }
  }
  return runs;
}

std::optional<PowerSpectrum> spectrum_of(std::span<const double> force_N, double rate_Hz) {
  if (force_N.size() < kShortWindow) return {};
  if (!std::all_of(force_N.begin(), force_N.end(), [](double f) { return std::isfinite(f); })) {
    return {};
  }
  return welch_spectrum(force_N, {rate_Hz, force_N.size() < kWindow ? kShortWindow : kWindow});
}

void add_to_path(std::vector<PathPoint>& path, const TickRecord& record) {
  const PathPoint point{record.probe.position_m.x, record.probe.position_m.y,
                        is_in_contact(record)};
  if (!std::isfinite(point.x_m) || !std::isfinite(point.y_m)) return;
  if (!path.empty() && path.back().touching == point.touching &&
      std::hypot(point.x_m - path.back().x_m, point.y_m - path.back().y_m) < kPathStep_m) {
    return;
  }
  path.push_back(point);
}

}  // namespace

RecordingCurves curves_of(std::span<const TickRecord> records, double rate_Hz,
                          std::int64_t begin_ns) {
  if (!(rate_Hz > 0.0))
    throw std::invalid_argument("rate_Hz is " + number_text(rate_Hz) + "; it must be above 0");
  RecordingCurves curves{};
  std::map<std::uint64_t, SurfaceCurves> surfaces{};
  for (const TickRecord& record : records) {
    const double time_s = static_cast<double>(record.probe.time_ns - begin_ns) * 1e-9;
    const glm::dvec3& velocity = record.probe.velocity_m_per_s;
    curves.time_s.push_back(time_s);
    curves.rendered_N.push_back(record.rendered.force_N.z);
    curves.sent_N.push_back(record.sent.force_N.z);
    curves.penetration_m.push_back(record.penetration_m);
    curves.speed_m_per_s.push_back(
        tangential_speed_m_per_s({velocity.x, velocity.y, velocity.z}, {0.0, 0.0, 1.0}));
    curves.x_m.push_back(record.probe.position_m.x);
    curves.y_m.push_back(record.probe.position_m.y);
    curves.z_m.push_back(record.probe.position_m.z);
    if (record.has(TickFlag::missed_deadline)) curves.missed_s.push_back(time_s);
    if (is_limited(record)) curves.limited_s.push_back(time_s);
    if (record.presentation != 0) add_to_path(surfaces[record.presentation].path, record);
  }
  const auto stretch_of = [&curves](const Run& run) {
    return TimeStretch{curves.time_s[run.first], curves.time_s[run.last]};
  };
  const auto is_shown = [](const TickRecord& record) { return record.presentation != 0; };
  for (const Run& run : runs_of(records, kLift_s, is_shown)) {
    surfaces[run.presentation].visits.push_back(stretch_of(run));
  }
  const auto is_felt = [](const TickRecord& record) { return is_in_contact(record); };
  for (const Run& run : runs_of(records, kLift_s, is_felt)) {
    curves.contacts.push_back(stretch_of(run));
    SurfaceCurves& surface = surfaces[run.presentation];
    if (stretch_of(run).duration_s() <= surface.longest_contact.duration_s()) continue;
    surface.longest_contact = stretch_of(run);
    const auto contact_of = [&run](const std::vector<double>& force_N) {
      return std::span(force_N).subspan(run.first, run.last - run.first + 1);
    };
    const std::span<const double> sent_N = contact_of(curves.sent_N);
    surface.is_spectrum_of_rendered =
        std::all_of(sent_N.begin(), sent_N.end(), [](double force_N) { return force_N == 0.0; });
    surface.spectrum = spectrum_of(
        surface.is_spectrum_of_rendered ? contact_of(curves.rendered_N) : sent_N, rate_Hz);
  }
  surfaces.erase(kSideBySide);  // the flat surface between patches
  for (auto& [position, surface] : surfaces) {
    surface.position = static_cast<int>(position);
    curves.surfaces.push_back(std::move(surface));
  }
  return curves;
}

std::vector<CurvePoint> envelope_of(std::span<const double> time_s, std::span<const double> values,
                                    const TimeStretch& seen, int columns) {
  auto first = static_cast<std::size_t>(
      std::lower_bound(time_s.begin(), time_s.end(), seen.begin_s) - time_s.begin());
  auto end = static_cast<std::size_t>(std::upper_bound(time_s.begin(), time_s.end(), seen.end_s) -
                                      time_s.begin());
  if (first > 0) --first;
  if (end < time_s.size()) ++end;
  std::vector<CurvePoint> points{};
  const auto add = [&](std::size_t i) { points.push_back({time_s[i], values[i]}); };
  const std::size_t n = end > first ? end - first : 0;
  const auto groups = static_cast<std::size_t>(columns);
  if (n <= 2 * groups) {
    for (std::size_t i = first; i < end; ++i) {
      if (std::isfinite(values[i])) add(i);
    }
    return points;
  }
  for (std::size_t group = 0; group < groups; ++group) {
    std::optional<std::size_t> lowest{};
    std::optional<std::size_t> highest{};
    for (std::size_t i = first + group * n / groups; i < first + (group + 1) * n / groups; ++i) {
      if (!std::isfinite(values[i])) continue;
      if (!lowest || values[i] < values[*lowest]) lowest = i;
      if (!highest || values[i] > values[*highest]) highest = i;
    }
    if (!lowest) continue;
    add(std::min(*lowest, *highest));
    if (*lowest != *highest) add(std::max(*lowest, *highest));
  }
  return points;
}

}  // namespace asperity
