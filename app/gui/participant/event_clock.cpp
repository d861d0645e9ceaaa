// Relates the stamps of events to the steady clock by the smallest difference of the last minutes.

#include "app/gui/participant/event_clock.h"

#include <algorithm>

#include <QtGui/QGuiApplication>

namespace asperity {

namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr std::int64_t kMinute_ns = 60'000'000'000;
constexpr auto kLongestDelay_ns = static_cast<std::int64_t>(EventClock::kLongestDelay_s * 1e9);

}  // namespace

std::int64_t EventClock::happened_ns(std::uint64_t stamp_ms, std::int64_t now_ns) {
  if (stamps_ == Stamps::invented || stamp_ms == 0) return now_ns;
  const auto stamp = static_cast<std::uint32_t>(stamp_ms);
  // The difference of 32 bits is right across the wrap, and for events a little out of order.
  if (last_stamp_ms_) {
    unwrapped_ms_ += static_cast<std::int32_t>(stamp - *last_stamp_ms_);
  } else {
    unwrapped_ms_ = stamp;
  }
  last_stamp_ms_ = stamp;

  if (now_ns - minute_began_ns_ >= kMinute_ns) {
    previously_ns_ = smallest_ns_;
    smallest_ns_.reset();
    minute_began_ns_ = now_ns;
  }
  const std::int64_t stamp_ns = unwrapped_ms_ * kMillisecond_ns;
  const std::int64_t difference_ns = now_ns - stamp_ns;
  smallest_ns_ = std::min(smallest_ns_.value_or(difference_ns), difference_ns);
  std::int64_t offset_ns = std::min(*smallest_ns_, previously_ns_.value_or(*smallest_ns_));
  if (difference_ns - offset_ns > kLongestDelay_ns) {
    smallest_ns_ = difference_ns;
    previously_ns_.reset();
    offset_ns = difference_ns;
  }
  return stamp_ns + offset_ns;
}

EventClock::Stamps stamps_of_platform() {
  const QString platform = QGuiApplication::platformName();
  return platform == "offscreen" || platform == "minimal" ? EventClock::Stamps::invented
                                                          : EventClock::Stamps::of_window_system;
}

}  // namespace asperity
