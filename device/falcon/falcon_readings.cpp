// What a Falcon's answers mean.

#include "device/falcon/falcon_readings.h"

namespace asperity::falcon {

std::optional<Reading> Readings::take(const Answer& answer, std::int64_t now_ns) noexcept {
  Reading reading{.time_ns = now_ns, .buttons = answer.buttons, .is_homed = answer.is_homed()};
  // Homing moves the encoders' zero: what was before lies elsewhere.
  if (reading.is_homed != is_homed_) reset();
  is_homed_ = reading.is_homed;
  if (!is_homed_) return reading;

  const ArmAngles_rad angles = angles_at(answer.counts);
  const std::optional<glm::dvec3> place = position_m(angles);
  if (!place) return {};
  reading.position_m = *place;
  judge(now_ns, {.angles = angles, .position_m = *place});
  reading.plausible = plausible_;
  reading.velocity_m_per_s = velocity_.add(now_ns, *place);
  return reading;
}

void Readings::judge(std::int64_t now_ns, const Pose& pose) noexcept {
  const ProbeState state{.time_ns = now_ns, .position_m = pose.position_m};
  ReadingCheck::Verdict verdict = check_.judge(state, ReadingCheck::Origin::fresh);
  if (verdict == ReadingCheck::Verdict::lost && now_ns - plausible_ns_ > kPoseLasts_ns) {
    check_.restart();
    verdict = check_.judge(state, ReadingCheck::Origin::fresh);
  }
  if (verdict != ReadingCheck::Verdict::plausible) return;
  plausible_ = pose;
  plausible_ns_ = now_ns;
}

void Readings::reset() noexcept {
  velocity_.reset();
  check_.restart();
  is_homed_ = false;
}

}  // namespace asperity::falcon
