// The claim of the one process of this computer that drives a device, as the address of a socket.

#include "device/device_claim.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <sys/socket.h>
#include <sys/un.h>
#include <system_error>
#include <unistd.h>

#include "device/pause.h"

namespace asperity {
namespace {

[[noreturn]] void refuse(const char* what, int error) {
  throw std::runtime_error(std::string("the device cannot be marked as in use (") + what + ": " +
                           std::generic_category().message(error) +
                           "); close other programs, then open it again");
}

}  // namespace

std::unique_ptr<DeviceClaim> DeviceClaim::take(const std::string& name) {
  constexpr std::string_view kBeginning = "asperity ";
  constexpr std::size_t kLongest_bytes = 90;
  const char* const session = std::getenv("XDG_RUNTIME_DIR");
  std::string full = (session == nullptr ? "" : session + std::string("/")) + name;
  if (full.size() > kLongest_bytes) full.erase(0, full.size() - kLongest_bytes);
  // An address that begins with a zero is abstract; its name ends with its length.
  sockaddr_un address{};
  static_assert(1 + kBeginning.size() + kLongest_bytes <= sizeof address.sun_path);
  address.sun_family = AF_UNIX;
  char* end = std::copy(kBeginning.begin(), kBeginning.end(), address.sun_path + 1);
  end = std::copy(full.begin(), full.end(), end);
  const auto length = static_cast<socklen_t>(end - reinterpret_cast<char*>(&address));

  const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (socket < 0) refuse("socket", errno);
  std::unique_ptr<DeviceClaim> claim(new DeviceClaim(socket));
  if (::bind(socket, reinterpret_cast<const sockaddr*>(&address), length) == 0) return claim;
  if (errno != EADDRINUSE) refuse("bind", errno);
  return nullptr;
}

std::unique_ptr<DeviceClaim> DeviceClaim::take_until(std::chrono::steady_clock::time_point latest,
                                                     const std::string& name,
                                                     const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kBetweenTrials(10);
  while (!stop.stop_requested()) {
    if (auto taken = take(name)) return taken;
    if (std::chrono::steady_clock::now() > latest) break;
    pause(stop, kBetweenTrials);
  }
  return nullptr;
}

DeviceClaim::~DeviceClaim() { ::close(socket_); }

}  // namespace asperity
