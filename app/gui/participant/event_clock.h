// When a key or button was pressed, on the machine's steady clock.

#pragma once

#include <cstdint>
#include <optional>

namespace asperity {

/// Turns the window system's time stamps into times of the steady clock.
///
/// An input event carries milliseconds of "some arbitrary point in time" (QInputEvent::timestamp):
/// under xcb the X server's time, under Wayland the compositor's, both counted in 32 bits, so that
/// they begin anew every 49.7 days. How far that clock is from ours is not told; but an event is
/// always heard after it happened, so of all differences (time heard − stamp) the smallest is the
/// nearest to the truth:
///
///   happened = stamp + min over the last minute or two of (heard − stamp)
///
/// What the caller may rely on: the answer is never later than `now_ns` and never more than
/// `kLongestDelay_s` earlier. It is late by at most the delay of the promptest event of the last
/// minutes and the millisecond of the stamps. A window that was busy delays the hearing, not the
/// answer. A clock that jumps, or an event that seems older than `kLongestDelay_s`, starts the search
/// anew. Clocks that drift apart (a remote display) are followed, because old differences are forgotten.
class EventClock final {
 public:
  enum class Stamps {
    of_window_system,
    invented,  ///< by tests, off screen, where no input device is: the time of hearing is taken
  };
  static constexpr double kLongestDelay_s = 1.0;

  explicit EventClock(Stamps stamps) : stamps_(stamps) {}

  /// `stamp_ms` 0 is no stamp. Give it every event, not only those whose time is wanted.
  std::int64_t happened_ns(std::uint64_t stamp_ms, std::int64_t now_ns);

 private:
  Stamps stamps_ = Stamps::invented;
  std::optional<std::uint32_t> last_stamp_ms_{};
  std::int64_t unwrapped_ms_ = 0;
  std::optional<std::int64_t> smallest_ns_{};    ///< of this minute
  std::optional<std::int64_t> previously_ns_{};  ///< of the minute before
  std::int64_t minute_began_ns_ = 0;
};

/// Whether the platform that the application runs on stamps its events.
EventClock::Stamps stamps_of_platform();

}  // namespace asperity
