// What a Falcon's answers mean.

#include "device/falcon/falcon_readings.h"

namespace asperity::falcon {

std::optional<Reading> Readings::take(const Answer& answer, std::int64_t now_ns) noexcept {
  Reading reading{.time_ns = now_ns,
                  .angles = angles_at(answer.counts),
                  .buttons = answer.buttons,
                  .is_homed = answer.is_homed()};
  // Homing moves the encoders' zero: what was before lies elsewhere.
  if (reading.is_homed != is_homed_) reset();
  is_homed_ = reading.is_homed;
  if (!is_homed_) return reading;

  const std::optional<glm::dvec3> place = position_m(reading.angles);
  if (!place) return {};
  reading.position_m = *place;
  reading.velocity_m_per_s = velocity_.add(now_ns, *place);
  return reading;
}

void Readings::reset() noexcept {
  velocity_.reset();
  is_homed_ = false;
}

}  // namespace asperity::falcon
