// Implements the precision of a recording, which is applied before the renderer receives the sample.

#include "renderers/servo/tick_record.h"

namespace asperity {
namespace {

double through_float(double value) noexcept {
  return static_cast<double>(static_cast<float>(value));
}

}  // namespace

glm::dvec3 rounded_for_recording(const glm::dvec3& vector) noexcept {
  return {through_float(vector.x), through_float(vector.y), through_float(vector.z)};
}

ProbeState rounded_for_recording(const ProbeState& probe) noexcept {
  ProbeState rounded = probe;
  rounded.position_m = rounded_for_recording(probe.position_m);
  rounded.orientation =
      glm::dquat(through_float(probe.orientation.w), through_float(probe.orientation.x),
                 through_float(probe.orientation.y), through_float(probe.orientation.z));
  rounded.velocity_m_per_s = rounded_for_recording(probe.velocity_m_per_s);
  rounded.angular_velocity_rad_per_s = rounded_for_recording(probe.angular_velocity_rad_per_s);
  return rounded;
}

}  // namespace asperity
