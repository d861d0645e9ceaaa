// Declares the claim of the one process of this computer that drives a device.

#pragma once

#include <memory>
#include <string>

namespace asperity {

/// Drives a device, as the only process that does so with this program: from `take` until it is destroyed or the process
/// ends, however it ends.
///
/// A manufacturer's library need not refuse a device that another process has open. The claim is a name in the abstract
/// namespace of sockets (unix(7)), which is no file and leaves nothing behind. The programs of one user's session see each
/// other's: the name begins with XDG_RUNTIME_DIR.
class DeviceClaim final {
 public:
  /// `name` is "DRIVER:SERIAL". Null where a process has it, this one included.
  /// Errors: std::runtime_error where the system has no sockets left.
  static std::unique_ptr<DeviceClaim> take(const std::string& name);
  ~DeviceClaim();
  DeviceClaim(const DeviceClaim&) = delete;
  DeviceClaim& operator=(const DeviceClaim&) = delete;

 private:
  explicit DeviceClaim(int socket) noexcept : socket_(socket) {}

  int socket_;
};

}  // namespace asperity
