// Whether a pose that stays the same is to be believed.

#include "device/pose_watch.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace asperity {
namespace {

constexpr double kStrongPush_N = 2.0;
constexpr std::int64_t kLongPush_ns = 1'000'000'000;
constexpr double kClaimedWay_m = 0.02;
constexpr double kLongestStep_s = 0.1;  // of a velocity that is taken to have lasted

}  // namespace

void PoseWatch::take(const ProbeState& state, double force_N) noexcept {
  const bool is_same =
      last_ && last_->position_m == state.position_m && last_->orientation == state.orientation;
  if (!is_same) {
    last_ = state;
    pushed_since_ns_.reset();
    claimed_m_ = 0.0;
    is_frozen_ = false;
    return;
  }
  const double dt_s = 1e-9 * static_cast<double>(state.time_ns - last_->time_ns);
  claimed_m_ += glm::length(state.velocity_m_per_s) * std::clamp(dt_s, 0.0, kLongestStep_s);
  last_->time_ns = state.time_ns;
  if (force_N <= kStrongPush_N)
    pushed_since_ns_.reset();
  else if (!pushed_since_ns_)
    pushed_since_ns_ = state.time_ns;
  const bool is_pushed_in_vain =
      pushed_since_ns_ && state.time_ns - *pushed_since_ns_ > kLongPush_ns;
  is_frozen_ = is_frozen_ || is_pushed_in_vain || claimed_m_ > kClaimedWay_m;
}

}  // namespace asperity
