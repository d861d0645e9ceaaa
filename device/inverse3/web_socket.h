// One connection to a service on this machine that speaks WebSocket.

#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

namespace asperity {

/// Text messages over ws://host:port/, one after the other, as a client.
///
/// Errors: the constructor throws std::runtime_error with a sentence when the host is a name that nobody knows
/// (host_address.h), nobody listens there, or does not speak WebSocket, within `patience`, or until `stop`.
///
/// Threads: all of it belongs to one thread at a time, but for `wake`, which may come from any.
class WebSocket final {
 public:
  /// `stop` ends the connecting, and nothing after it.
  WebSocket(const std::string& host, int port, std::chrono::milliseconds patience,
            const std::stop_token& stop = {});
  ~WebSocket();
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;

  bool is_open() const noexcept;
  /// False when the connection is gone, or does not take it within a quarter of a second.
  bool send(std::string_view text);
  /// The next message; nothing when none comes within `patience`, the connection is gone or `wake` was called.
  std::optional<std::string> receive(std::chrono::milliseconds patience);
  /// The connection's file; −1 when it is gone.
  int file() const noexcept;
  /// Ends the `receive` that waits, or else the next one that would have to wait.
  void wake() noexcept;

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace asperity
