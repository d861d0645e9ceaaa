// Whether a pose that stays the same is accepted.

#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec3.hpp>

#include "device/probe_state.h"

namespace asperity {

/// Finds the pose that is frozen: a sensor, cable or program of the maker's that gives the same answer for ever.
///
/// Position and orientation equal to the last bit are frozen
///
///   · after 1 s of more than 2 N: motors that push and move nothing, not by one step of an encoder, or
///   · when the velocity that was read with them adds up to 2 cm (Σ|v|·Δt).
///
/// until one of them changes. Only what the device reported anew counts: the last reading, held while none comes, is the
/// same to the last bit and keeps its velocity too. A hand at rest is not frozen: it is pushed by less, or trembles by
/// more than a step (38 µm on a Falcon) within a second. Velocities that drivers make of positions stop with them,
/// after millimetres at the speed of a hand.
///
/// Real-time: does not allocate, lock or throw.
class PoseWatch final {
 public:
  /// A new reading, and the weakest force on the hand since the last one. Readings come in order of time.
  void take(const ProbeState& state, double force_N) noexcept;
  bool is_frozen() const noexcept { return is_frozen_; }

 private:
  std::optional<ProbeState> last_{};
  std::optional<std::int64_t> pushed_since_ns_{};
  double claimed_m_ = 0.0;
  bool is_frozen_ = false;
};

}  // namespace asperity
