// Prepares a recording for display: over time, from above, and as a spectrum.

#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/signals/spectrum.h"
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

/// The data of one surface of the attempt.
struct SurfaceCurves {
  int position = 0;                   ///< in its trial, from 1
  std::vector<TimeStretch> visits{};  ///< more than one where the surface was felt again
  /// The path of the tip from above, in the device frame; consecutive points are at least 0.25 mm
  /// apart unless the contact begins or ends between them.
  std::vector<PathPoint> path{};
  /// Of the normal force that the device was sent in the longest contact; absent when that contact
  /// is shorter than a window of 256 ticks or contains a force that is not finite. Where the
  /// device was sent no force during the whole contact (a device without motors), of the force that
  /// the renderer computed.
  std::optional<PowerSpectrum> spectrum{};
  bool is_spectrum_of_rendered = false;
  TimeStretch longest_contact{};
};

/// Times in seconds since the beginning of the attempt; the spans over ticks have equal length.
///
/// Force is the normal force, along z, and speed the one along the surface, as used to judge an
/// attempt. A contact (contact.h) lasts until the probe has been out of the surface for `kLift_s`: it is
/// not ended by the crests of a texture that release the probe for a tick.
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
  std::vector<double> limited_s{};  ///< ticks whose force was reduced, for any reason
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

/// A line through the samples within `seen`, reduced to `columns` points of width: the lowest and
/// the highest of each of that many equal groups of samples, in chronological order; every sample
/// where there are at most two per column. The next sample on either side is included, so that the
/// line extends beyond the picture. Values that are not finite are omitted.
///
/// `time_s` ascends and has the length of `values`; `columns` ≥ 1.
std::vector<CurvePoint> envelope_of(std::span<const double> time_s, std::span<const double> values,
                                    const TimeStretch& seen, int columns);

}  // namespace asperity
