// Measures the readings of a device that nothing moves: where it rests, its noise and its drift.

#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include <glm/vec3.hpp>

#include "analysis/words/phrase.h"
#include "device/device_capability.h"
#include "renderers/servo/tick_record.h"
#include "results_schema/rows.h"

namespace asperity {

/// The event of a drift check: text one of the two below, data as `drift_data_json`.
inline constexpr const char* kDriftChecked = "drift_checked";
inline constexpr const char* kHandOff = "hand_off";
inline constexpr const char* kTipHeld = "tip";

/// The positions of the probe at the times t of n ticks are described by a straight line per axis,
///
///   x(t) = m + b·(t − t̄),  b = Σ(t − t̄)·x/Σ(t − t̄)²,
///
/// with m their mean, b the drift and r the residuals. Lengths are those of vectors, in the frame of the device.
struct RestReading {
  std::size_t ticks = 0;
  double duration_s = 0.0;  ///< from the first to the last tick
  glm::dvec3 position_m{};  ///< m
  double noise_m = 0.0;     ///< √(Σ|r|²/(n − 2)); 0 for fewer than three ticks
  double drift_m = 0.0;     ///< |b|·duration
};

/// All zero without ticks.
RestReading rest_reading(std::span<const TickRecord> records);

/// The largest noise and drift that a device at rest should have: ten steps of its position. A reading between two steps
/// alternates between them; ten steps are a motion. Nothing where the step is not known.
std::optional<double> rest_limit_m(const DeviceCapability& device);

/// One check, compared with the first one of the session.
struct DriftCheck {
  RestReading reading{};
  std::optional<double> shift_m{};  ///< from the position of the first check; nothing for that one
  std::optional<double> limit_m{};  ///< as `rest_limit_m`

  /// Whether noise and drift are within the limit; nothing without one.
  std::optional<bool> is_passed() const;
};

/// Members `ticks`, `duration_s`, `position_m`, `noise_m`, `drift_m`, and where they are known `shift_m`, `limit_m` and `passed`.
std::string drift_data_json(const DriftCheck& check);

/// The position of the first of these events that is a check of this part (kHandOff, kTipHeld); nothing if there is none.
std::optional<glm::dvec3> first_rest_m(std::span<const EventRow> events, const std::string& part);

/// The result for the experimenter, in millimetres.
Phrase drift_text(const std::string& part, const DriftCheck& check);

}  // namespace asperity
