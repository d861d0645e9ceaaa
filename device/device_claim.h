// Declares the claim of the one process of this computer that drives a device of a driver.

#pragma once

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

namespace asperity {

/// Drives a device of a driver, as the only process that does so with this program: from `take` until it is destroyed or the
/// process ends, however it ends.
///
/// A manufacturer's library need not refuse a device that another process has open, and states its serial number only once it
/// is open: the claim is therefore that of the driver, and it is taken before any of its devices is opened. It is a name in the
/// abstract namespace of sockets (unix(7)), which is no file and leaves nothing behind. The programs of one user's session see each
/// other's: the name begins with XDG_RUNTIME_DIR.
class DeviceClaim final {
 public:
  /// `name` is the id of the driver. Null where a process has it, this one included.
  /// Errors: std::runtime_error where the system has no sockets left.
  static std::unique_ptr<DeviceClaim> take(const std::string& name);
  /// The same, tried again and again. Null where a process has it until `latest`, or the stop comes first.
  static std::unique_ptr<DeviceClaim> take_until(std::chrono::steady_clock::time_point latest,
                                                 const std::string& name,
                                                 const std::stop_token& stop = {});
  ~DeviceClaim();
  DeviceClaim(const DeviceClaim&) = delete;
  DeviceClaim& operator=(const DeviceClaim&) = delete;

 private:
  explicit DeviceClaim(int socket) noexcept : socket_(socket) {}

  int socket_;
};

}  // namespace asperity
