// A recording as curves to look at: over time, from above, and as a spectrum.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/spectrum.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

struct TimeStretch {
  double begin_s = 0.0;
  double end_s = 0.0;

  double duration_s() const noexcept { return end_s - begin_s; }
};

struct PathPoint {
  double x_m = 0.0;
  double y_m = 0.0;
  bool touching = false;
};

/// What was felt of one surface of the attempt.
struct SurfaceCurves {
  int position = 0;                   ///< in its trial, from 1
  std::vector<TimeStretch> visits{};  ///< more than one where the hand came back to it
  /// Of the tip from above, in the device frame; no two points nearer than 0.25 mm unless the
  /// contact begins or ends between them.
  std::vector<PathPoint> path{};
  /// Of the normal force that the device got in the longest contact; absent when that is shorter
  /// than a window of 256 ticks or holds a force that is no number. Where the device was sent no force
  /// in all of it (a device without motors), of the force that the renderer computed.
  std::optional<PowerSpectrum> spectrum{};
  bool is_spectrum_of_rendered = false;
  TimeStretch longest_contact{};
};

/// Times in seconds since the beginning of the attempt; the spans over ticks are of one length.
///
/// Force is the normal one, along z, and speed the one along the surface, as an attempt is judged
/// by them. A contact lasts until the probe has been out of the surface for 20 ms: crests of a
/// texture that let go of it for a tick do not end one.
struct RecordingCurves {
  std::vector<double> time_s{};
  std::vector<double> rendered_N{};
  std::vector<double> sent_N{};
  std::vector<double> penetration_m{};
  std::vector<double> speed_m_per_s{};
  std::vector<double> x_m{};
  std::vector<double> y_m{};
  std::vector<double> z_m{};

  std::vector<TimeStretch> contacts{};
  std::vector<double> missed_s{};   ///< ticks that began more than a period late
  std::vector<double> limited_s{};  ///< ticks whose force was shortened, for whatever reason
  std::vector<SurfaceCurves> surfaces{};

  TimeStretch whole() const noexcept {
    return time_s.empty() ? TimeStretch{} : TimeStretch{time_s.front(), time_s.back()};
  }
};

/// `begin_ns`: the beginning of the attempt, on the clock of the records. Errors:
/// std::invalid_argument for a rate that is not positive.
RecordingCurves curves_of(std::span<const TickRecord> records, double rate_Hz,
                          std::int64_t begin_ns);

struct CurvePoint {
  double time_s = 0.0;
  double value = 0.0;
};

/// What a line through the samples within `seen` looks like when it is `columns` wide: of as many
/// equal groups of samples the lowest and the highest, in the order in which they came; every
/// sample where there are no more than two per column. The next sample on either side is there too,
/// so that the line leaves the picture. Values that are not finite are left out.
///
/// `time_s` ascends and is as long as `values`; `columns` ≥ 1.
std::vector<CurvePoint> envelope_of(std::span<const double> time_s, std::span<const double> values,
                                    const TimeStretch& seen, int columns);

}  // namespace asperity
