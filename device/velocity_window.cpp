// How fast something moves, from its last few positions.

#include "device/velocity_window.h"

#include <algorithm>

namespace asperity {

glm::dvec3 VelocityWindow::next(std::int64_t time_ns, const glm::dvec3& position_m) noexcept {
  if (count_ == 0 || time_ns != readings_[newest_].time_ns) {
    newest_ = count_ == 0 ? 0 : (newest_ + 1) % kReadings;
    readings_[newest_] = {.time_ns = time_ns, .position_m = position_m};
    count_ = std::min(count_ + 1, kReadings);
  }
  return slope();
}

glm::dvec3 VelocityWindow::slope() const noexcept {
  // Relative to the newest, so that no digits are lost to a large time or a far position.
  const Reading& newest = readings_[newest_];
  double mean_s = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    mean_s += 1e-9 * static_cast<double>(readings_[i].time_ns - newest.time_ns);
  }
  mean_s /= static_cast<double>(count_);
  glm::dvec3 covariance(0.0);
  double variance = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double time_s =
        1e-9 * static_cast<double>(readings_[i].time_ns - newest.time_ns) - mean_s;
    covariance += time_s * (readings_[i].position_m - newest.position_m);
    variance += time_s * time_s;
  }
  return variance > 0.0 ? covariance / variance : glm::dvec3(0.0);
}

}  // namespace asperity
