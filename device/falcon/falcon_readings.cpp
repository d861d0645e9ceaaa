// What a Falcon's answers mean, and which of them are not to be believed.

#include "device/falcon/falcon_readings.h"

#include <glm/geometric.hpp>

namespace asperity::falcon {
namespace {

constexpr double kFastest_m_per_s = 5.0;
constexpr double kJitter_m = 0.001;
constexpr std::int64_t kDoubt_ns =
    100'000'000;  // HapticDevice::kLongestSilence_ns and again as long

}  // namespace

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
  const double since_s = 1e-9 * static_cast<double>(now_ns - heard_ns_);
  heard_ns_ = now_ns;
  if (last_ &&
      !(glm::distance(*place, last_->position_m) <= kJitter_m + kFastest_m_per_s * since_s)) {
    if (!doubted_since_ns_) doubted_since_ns_ = now_ns;
    if (now_ns - *doubted_since_ns_ < kDoubt_ns) return {};
    velocity_.reset();
  }
  doubted_since_ns_.reset();
  reading.velocity_m_per_s = velocity_.add(now_ns, *place);
  last_ = reading;
  return reading;
}

void Readings::reset() noexcept {
  velocity_.reset();
  last_.reset();
  doubted_since_ns_.reset();
  is_homed_ = false;
}

}  // namespace asperity::falcon
