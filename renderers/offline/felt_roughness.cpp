// Implements two held tools, one along x and z and one along y, and the acceleration in the last window.

#include "renderers/offline/felt_roughness.h"

#include <cmath>

#include "device/refusal.h"
#include "renderers/offline/drag.h"

namespace asperity {

FeltRoughness::FeltRoughness(const Judging& judging)
    : judging_(judging), beside_(judging.hand, {}) {
  require_positive("Judging::rate_Hz", judging.rate_Hz);
  require_positive("Judging::window_s", judging.window_s);
  dropped_ = static_cast<std::size_t>(
      std::ceil(judging.rate_Hz * beginning_s(judging.hand, std::nullopt)));
}

void FeltRoughness::add(const glm::dvec3& force_N) {
  if (!along_) {
    along_.emplace(judging_.hand, HeldTool::Stroke{.press_N = force_N.z});
  } else {
    along_->advance(1.0 / judging_.rate_Hz);
    beside_.advance(1.0 / judging_.rate_Hz);
  }
  along_->feel({force_N.x, 0.0, force_N.z});
  beside_.feel({force_N.y, 0.0, 0.0});
  if (dropped_ > 0) {
    --dropped_;
    return;
  }
  const glm::dvec2& along_m_per_s2 = along_->acceleration_m_per_s2();
  accelerations_m_per_s2_.emplace_back(along_m_per_s2.x, beside_.acceleration_m_per_s2().x,
                                       along_m_per_s2.y);
  if (static_cast<double>(accelerations_m_per_s2_.size()) > judging_.window_s * judging_.rate_Hz) {
    accelerations_m_per_s2_.pop_front();
  }
}

std::optional<HeldToolRecord> FeltRoughness::record() const {
  const std::size_t samples = accelerations_m_per_s2_.size();
  if (samples == 0 || static_cast<double>(samples) < judging_.shortest_s * judging_.rate_Hz) {
    return {};
  }
  HeldToolRecord record(judging_.rate_Hz);
  record.reserve(samples);
  for (const glm::dvec3& one : accelerations_m_per_s2_) record.add(one.x, one.z, one.y);
  return record;
}

std::optional<HeldToolRoughness> FeltRoughness::roughness() const {
  const std::optional<HeldToolRecord> felt = record();
  if (!felt) return {};
  return felt->roughness();
}

std::optional<double> FeltRoughness::rms_accel_m_per_s2() const {
  const std::optional<HeldToolRecord> felt = record();
  if (!felt) return {};
  return felt->rms_accel_m_per_s2();
}

}  // namespace asperity
