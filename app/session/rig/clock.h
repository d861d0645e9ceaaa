// The clock of a session.

#pragma once

#include <atomic>
#include <cstdint>
#include <string>

namespace asperity {

/// Provides the time of a session: a monotonic count on which all stored times lie, and the date at
/// which it began.
///
/// A session in real time uses the system's clocks. A simulated one has a separate clock, which
/// starts at a fixed date and is moved only by the conductor; the same simulation therefore always
/// has the same time stamps.
///
/// Threads: any may read.
class Clock {
 public:
  virtual ~Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;

  virtual std::int64_t now_ns() const noexcept = 0;
  /// Now, as UTC ISO 8601 with milliseconds: "2026-01-01T00:00:00.000Z".
  virtual std::string utc() const = 0;
  /// The offset of this clock from the machine's monotonic clock, which stamps keys and buttons; 0
  /// where the two are unrelated.
  virtual std::int64_t ahead_ns() const noexcept { return 0; }

 protected:
  Clock() = default;
};

/// The machine's monotonic clock and its date.
class SystemClock final : public Clock {
 public:
  /// The machine's clock restarts with the machine; a session resumed after that needs a clock that
  /// does not: it then runs ahead of the machine's, from `not_before_ns`.
  explicit SystemClock(std::int64_t not_before_ns);
  std::int64_t now_ns() const noexcept override;
  /// 0 except after a restart of the machine.
  std::int64_t ahead_ns() const noexcept override { return ahead_ns_; }
  std::string utc() const override;

 private:
  std::int64_t ahead_ns_ = 0;
};

/// A clock that stands still until it is moved. The n-th session of a simulation begins n hours
/// after the epoch.
class SimulatedClock final : public Clock {
 public:
  /// 2026-01-01T00:00:00Z, in seconds since 1970.
  static constexpr std::int64_t kEpoch_s = 1767225600;

  explicit SimulatedClock(std::int64_t session_index)
      : begin_ns_(session_index * 3'600'000'000'000), now_ns_(begin_ns_) {}

  std::int64_t now_ns() const noexcept override { return now_ns_.load(); }
  std::string utc() const override;
  /// Errors: std::logic_error when `now_ns` is earlier than the current time.
  void move_to(std::int64_t now_ns);

 private:
  std::int64_t begin_ns_ = 0;
  std::atomic<std::int64_t> now_ns_{0};
};

inline double seconds_between(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return static_cast<double>(to_ns - from_ns) * 1e-9;
}

}  // namespace asperity
