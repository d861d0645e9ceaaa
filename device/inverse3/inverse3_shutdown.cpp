// Zero for an Inverse3 when the program that drove it is dead or stands still.

#include "device/inverse3/inverse3_shutdown.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <vector>

#include <poll.h>

#include "device/monotonic_clock.h"

namespace asperity {
namespace {

// RFC 6455: one frame that is a whole text, masked as a client's has to be.
constexpr unsigned char kWholeText = 0x81;
constexpr unsigned char kMasked = 0x80;
constexpr std::size_t kLongestShort_bytes = 125;
constexpr unsigned char kSixteenBits = 126;  // of the length follow
constexpr std::size_t kMask_bytes = 4;       // all zero: the text stands as it is

constexpr int kMostUnread_bytes = 32768;
constexpr std::int64_t kToHear_ns = 1'000'000'000;

}  // namespace

Inverse3Shutdown Inverse3Shutdown::over(int file, std::string_view message) {
  std::vector<unsigned char> frame{kWholeText};
  if (message.size() <= kLongestShort_bytes) {
    frame.push_back(static_cast<unsigned char>(kMasked | message.size()));
  } else {
    frame.insert(frame.end(), {static_cast<unsigned char>(kMasked | kSixteenBits),
                               static_cast<unsigned char>(message.size() >> 8U),
                               static_cast<unsigned char>(message.size() & 0xffU)});
  }
  frame.insert(frame.end(), kMask_bytes, 0);
  frame.insert(frame.end(), message.begin(), message.end());
  Inverse3Shutdown zero{.file = file, .length = frame.size()};
  if (frame.size() > zero.frame.size()) {
    throw std::length_error("the message for the Inverse Service takes a frame of " +
                            std::to_string(frame.size()) + " bytes; it must have at most " +
                            std::to_string(zero.frame.size()) + ": shorten the message");
  }
  std::copy(frame.begin(), frame.end(), zero.frame.begin());
  return zero;
}

void shut_down_inverse3(WatchdogProcess::Cause cause, const void* about) noexcept {
  const auto& zero = *static_cast<const Inverse3Shutdown*>(about);
  const bool is_stopped = cause == WatchdogProcess::Cause::stopped;
  int unread_bytes = 0;
  if (is_stopped && ioctl(zero.file, FIONREAD, &unread_bytes) == 0 &&
      unread_bytes > kMostUnread_bytes) {
    return;
  }
  const ssize_t sent = send(zero.file, zero.frame.data(), zero.length, MSG_DONTWAIT | MSG_NOSIGNAL);
  if (is_stopped || sent < 0) return;
  // An end at once, with answers still to be read, would take the message along.
  shutdown(zero.file, SHUT_WR);
  const std::int64_t until_ns = monotonic_now_ns() + kToHear_ns;
  std::array<unsigned char, 4096> answers{};
  for (;;) {
    const std::int64_t left_ns = until_ns - monotonic_now_ns();
    pollfd answer{zero.file, POLLIN, 0};
    if (left_ns <= 0 || poll(&answer, 1, static_cast<int>(left_ns / 1'000'000) + 1) <= 0) return;
    if (recv(zero.file, answers.data(), answers.size(), MSG_DONTWAIT) <= 0) return;
  }
}

}  // namespace asperity
