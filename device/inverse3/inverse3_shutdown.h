// Zero for an Inverse3 when the program that drove it is dead or stands still.

#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "device/watchdog_process.h"

namespace asperity {

/// What an Inverse Service is to hear, over the driver's own open connection.
struct Inverse3Shutdown {
  int file = -1;
  std::array<unsigned char, 512>
      frame{};  ///< of WebSocket, with the message that asks for no force
  std::size_t length = 0;

  /// Errors: std::length_error for a message that is too long for `frame`.
  static Inverse3Shutdown over(int file, std::string_view message);
};

/// What a WatchdogProcess does for an Inverse3, and the driver while a tick of its own thread does not return (as `stopped`);
/// `about` is a Inverse3Shutdown. While the program stands still the
/// connection stays open and the service would hold the last force: it hears the message, as long as it takes what it is
/// told and the program has no more than some hundred answers to read when it goes on. Once the program has ended it
/// hears it as the last word of the connection.
void shut_down_inverse3(WatchdogProcess::Cause cause, const void* about) noexcept;

}  // namespace asperity
