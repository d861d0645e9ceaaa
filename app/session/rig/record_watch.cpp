// Summarises ticks in bins and in statistics of the loop, and collects changes of buttons.

#include "app/session/rig/record_watch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "renderers/servo/contact.h"

namespace asperity {

namespace {

constexpr auto kBin_ns = static_cast<std::int64_t>(SessionMonitor::kBin_s * 1e9);
constexpr auto kHealth_ns = static_cast<std::int64_t>(RecordWatch::kHealth_s * 1e9);
constexpr int kButtons = 32;

double lateness_s(std::vector<std::int32_t>& sorted_ns, double fraction) {
  const auto last = static_cast<double>(sorted_ns.size() - 1);
  return static_cast<double>(sorted_ns[static_cast<std::size_t>(std::lround(fraction * last))]) *
         1e-9;
}

}  // namespace

void RecordWatch::take(const TickRecord& record) {
  if (record.probe.buttons != buttons_) {
    for (int button = 0; button < kButtons; ++button) {
      const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(button);
      if (((record.probe.buttons ^ buttons_) & bit) == 0) continue;
      button_changes_.push_back(
          {button + 1, (record.probe.buttons & bit) != 0, record.probe.time_ns});
    }
    buttons_ = record.probe.buttons;
  }
  hand_.take(record);
  if (monitor_ == nullptr) return;
  if (record.has(TickFlag::missed_deadline)) ++missed_deadlines_;
  if (record.has(TickFlag::limited_force) || record.has(TickFlag::limited_torque)) {
    ++saturated_ticks_;
  }
  ticks_.push_back({record.probe.time_ns, record.lateness_ns});
  if (record.probe.time_ns - ticks_.front().time_ns > 2 * kHealth_ns) {
    const std::int64_t oldest_ns = record.probe.time_ns - kHealth_ns;
    ticks_.erase(ticks_.begin(), std::find_if(ticks_.begin(), ticks_.end(), [&](const Tick& tick) {
                   return tick.time_ns >= oldest_ns;
                 }));
  }
  take_into_bin(record);
}

void RecordWatch::take_into_bin(const TickRecord& record) {
  const std::int64_t time_ns = record.probe.time_ns;
  if (bin_is_open_ && time_ns - bin_began_ns_ >= kBin_ns) {
    monitor_->add_bin(bin_);
    bin_is_open_ = false;
    // Bins are contiguous while the ticks are.
    bin_began_ns_ = time_ns - bin_began_ns_ < 2 * kBin_ns ? bin_began_ns_ + kBin_ns : time_ns;
  } else if (!bin_is_open_) {
    bin_began_ns_ = time_ns;
  }
  const glm::dvec3& velocity = record.probe.velocity_m_per_s;
  const auto force_N = static_cast<float>(glm::length(record.sent.force_N));
  const auto speed = static_cast<float>(std::hypot(velocity.x, velocity.y));
  if (!bin_is_open_) {
    bin_ = {};
    bin_.force_minimum_N = bin_.force_maximum_N = force_N;
    bin_.speed_minimum_m_per_s = bin_.speed_maximum_m_per_s = speed;
    bin_is_open_ = true;
  }
  bin_.time_ns = time_ns;
  bin_.force_minimum_N = std::min(bin_.force_minimum_N, force_N);
  bin_.force_maximum_N = std::max(bin_.force_maximum_N, force_N);
  bin_.speed_minimum_m_per_s = std::min(bin_.speed_minimum_m_per_s, speed);
  bin_.speed_maximum_m_per_s = std::max(bin_.speed_maximum_m_per_s, speed);
  const std::optional<HandWatch::Now>& hand = hand_.now();
  bin_.is_felt = hand.has_value();
  bin_.pressing_N = hand ? hand->pressing_N : 0.0;
  bin_.stroking_m_per_s = hand ? hand->stroking_m_per_s : std::nullopt;
  bin_.x_m = static_cast<float>(record.probe.position_m.x);
  bin_.y_m = static_cast<float>(record.probe.position_m.y);
  bin_.z_m = static_cast<float>(record.probe.position_m.z);
  bin_.orientation = glm::quat(record.probe.orientation);
  bin_.touching = is_in_contact(record);
  bin_.surface = static_cast<int>(record.presentation);
}

std::vector<ButtonChange> RecordWatch::take_button_changes() {
  return std::exchange(button_changes_, {});
}

LoopHealth RecordWatch::health() const {
  LoopHealth health{};
  health.missed_deadlines = missed_deadlines_;
  health.saturated_ticks = saturated_ticks_;
  if (ticks_.empty()) return health;
  const std::int64_t oldest_ns = ticks_.back().time_ns - kHealth_ns;
  const auto first = std::find_if(ticks_.begin(), ticks_.end(),
                                  [&](const Tick& tick) { return tick.time_ns >= oldest_ns; });
  std::vector<std::int32_t> lateness_ns{};
  for (auto tick = first; tick != ticks_.end(); ++tick) lateness_ns.push_back(tick->lateness_ns);
  const double span_s = static_cast<double>(ticks_.back().time_ns - first->time_ns) * 1e-9;
  if (span_s > 0.0) health.rate_Hz = static_cast<double>(lateness_ns.size() - 1) / span_s;
  std::sort(lateness_ns.begin(), lateness_ns.end());
  health.lateness_p50_s = lateness_s(lateness_ns, 0.5);
  health.lateness_p99_s = lateness_s(lateness_ns, 0.99);
  health.lateness_maximum_s = lateness_s(lateness_ns, 1.0);
  return health;
}

}  // namespace asperity
