// What a device's sensors make of the hand: late, in steps, with noise.

#include "device/imperfect_sensor.h"

#include <cmath>

#include <glm/common.hpp>

#include "device/refusal.h"

namespace asperity {
namespace {

constexpr double kLongestLatency_s = 0.05;  // after this a device counts as lost
constexpr double kFastestSensor_Hz = 10'000.0;

}  // namespace

ImperfectSensor::ImperfectSensor(const SensorSettings& settings)
    : settings_(settings), random_(settings.noise_seed) {
  require_not_negative("latency_s of the sensor", settings.latency_s);
  if (settings.latency_s > kLongestLatency_s) {
    refuse("latency_s of the sensor", settings.latency_s, "at most 0.05");
  }
  require_not_negative("position_noise_m of the sensor", settings.position_noise_m);
  require_not_negative("position_step_m of the sensor", settings.position_step_m);
  if (settings.velocity) velocity_.emplace(*settings.velocity);
  if (settings.latency_s > 0.0) {
    // The one before the time that is wanted, and those since.
    pasts_.resize(static_cast<std::size_t>(std::ceil(settings.latency_s * kFastestSensor_Hz)) + 3);
  }
}

ProbeState ImperfectSensor::read(const ProbeState& hand) noexcept {
  ProbeState state = hand;
  if (!pasts_.empty()) delay(state);
  if (settings_.position_noise_m > 0.0) {
    for (int axis = 0; axis < 3; ++axis) {
      state.position_m[axis] += settings_.position_noise_m * random_.normal();
    }
  }
  if (settings_.position_step_m > 0.0) {
    for (int axis = 0; axis < 3; ++axis) {
      state.position_m[axis] = settings_.position_step_m *
                               std::round(state.position_m[axis] / settings_.position_step_m);
    }
  }
  if (velocity_) state.velocity_m_per_s = velocity_->add(state.time_ns, state.position_m);
  return state;
}

void ImperfectSensor::delay(ProbeState& state) noexcept {
  const bool is_new = count_ == 0 || past(count_ - 1).time_ns < state.time_ns;
  if (is_new && count_ == pasts_.size()) {
    oldest_ = (oldest_ + 1) % pasts_.size();
    --count_;
  }
  if (is_new) ++count_;
  pasts_[(oldest_ + count_ - 1) % pasts_.size()] = {.time_ns = state.time_ns,
                                                    .position_m = state.position_m,
                                                    .velocity_m_per_s = state.velocity_m_per_s};
  const std::int64_t wanted_ns = state.time_ns - std::llround(1e9 * settings_.latency_s);
  while (count_ > 1 && past(1).time_ns <= wanted_ns) {
    oldest_ = (oldest_ + 1) % pasts_.size();
    --count_;
  }
  const Past& before = past(0);
  state.position_m = before.position_m;
  state.velocity_m_per_s = before.velocity_m_per_s;
  if (count_ > 1 && wanted_ns > before.time_ns) {
    const Past& after = past(1);
    const double part = static_cast<double>(wanted_ns - before.time_ns) /
                        static_cast<double>(after.time_ns - before.time_ns);
    state.position_m = glm::mix(before.position_m, after.position_m, part);
    state.velocity_m_per_s = glm::mix(before.velocity_m_per_s, after.velocity_m_per_s, part);
  }
}

}  // namespace asperity
