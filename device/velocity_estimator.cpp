// Fits a line to a window of readings by least squares, and ignores implausible readings.

#include "device/velocity_estimator.h"

#include <cmath>

#include "device/refusal.h"

namespace asperity {

double VelocityWindow::lag_s(double period_s) const noexcept {
  return 0.5 * (samples - 1) * period_s;
}

double VelocityWindow::noise_m_per_s(double position_noise_m, double period_s) const noexcept {
  const double n = samples;
  return position_noise_m / period_s * std::sqrt(12.0 / (n * (n * n - 1.0)));
}

VelocityEstimator::VelocityEstimator(const VelocityWindow& window, double fastest_per_s)
    : check_(fastest_per_s) {
  if (window.samples < 2 || window.samples > kMostSamples) {
    refuse("samples of the velocity window", window.samples, "2 to 64");
  }
  window_ = static_cast<std::size_t>(window.samples);
}

glm::dvec3 VelocityEstimator::add(std::int64_t time_ns, const glm::dvec3& position_m) noexcept {
  if (count_ > 0 && time_ns <= readings_[newest_].time_ns) return velocity_m_per_s_;
  const ProbeState reading{
      .time_ns = time_ns, .position_m = position_m, .velocity_m_per_s = velocity_m_per_s_};
  switch (check_.judge(reading, ReadingCheck::Origin::fresh)) {
    case ReadingCheck::Verdict::plausible:
      break;
    case ReadingCheck::Verdict::held:
      return velocity_m_per_s_;
    case ReadingCheck::Verdict::lost:
      reset();
      check_.judge(reading, ReadingCheck::Origin::fresh);
      break;
  }
  newest_ = count_ == 0 ? 0 : (newest_ + 1) % window_;
  readings_[newest_] = {.time_ns = time_ns, .position_m = position_m};
  if (count_ < window_) ++count_;
  if (count_ < 2) return velocity_m_per_s_;

  // From the newest reading on, so that the numbers stay small whatever the clock's origin and the
  // device's.
  double time_s = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    time_s += 1e-9 * static_cast<double>(readings_[i].time_ns - time_ns);
  }
  const double mean_s = time_s / static_cast<double>(count_);
  glm::dvec3 covariance{0.0};
  double variance = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double since_s = 1e-9 * static_cast<double>(readings_[i].time_ns - time_ns) - mean_s;
    covariance += since_s * (readings_[i].position_m - position_m);
    variance += since_s * since_s;
  }
  velocity_m_per_s_ = covariance / variance;
  return velocity_m_per_s_;
}

void VelocityEstimator::reset() noexcept {
  count_ = 0;
  velocity_m_per_s_ = glm::dvec3(0.0);
  check_.restart();
}

}  // namespace asperity
