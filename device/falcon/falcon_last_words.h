// Zero for a Falcon's motors when the program that drove it is dead or stands still.

#pragma once

#include <array>

#include "device/falcon/falcon_frame.h"
#include "device/watchdog_process.h"

namespace asperity::falcon {

/// Which Falcon: the kernel's node, and the driver's own open file of it, which has claimed it.
struct LastWords {
  std::array<char, 32> node{};  ///< "/dev/bus/usb/001/021"
  int file = -1;
  Frame zero = frame_of({});
};

/// A frame of zero words over an open file of the node that has claimed the interface; false when the device
/// does not take it within 20 ms. A system call and nothing else.
bool send_zero(int file, const Frame& zero) noexcept;

/// What a WatchdogProcess does for a Falcon; `about` is a LastWords. While the program stands still it holds
/// the device, and the frame goes over its own file. Once it has ended, or has left the last word to the watchdog, the
/// node is opened anew and the frame sent until the device takes it: while the kernel still holds the claim of the dead,
/// which takes as long as a busy machine makes it, for a minute; where the destructor waits, for a second.
void say_last_words(WatchdogProcess::Cause cause, const void* about) noexcept;

}  // namespace asperity::falcon
