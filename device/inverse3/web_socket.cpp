// One connection to a service on this machine that speaks WebSocket.

#include "device/inverse3/web_socket.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <deque>
#include <stdexcept>
#include <vector>

#include <libwebsockets.h>

#include "device/inverse3/host_address.h"

namespace asperity {
namespace {

constexpr std::chrono::milliseconds kToSend(250);  // a line that takes nothing for so long is gone
constexpr std::size_t kReceiveBuffer_bytes = 65536;
constexpr unsigned int kMostFiles = 8;  // of its own: the socket and what wakes it, with room

}  // namespace

struct WebSocket::Connection {
  lws_context* context = nullptr;
  lws* line = nullptr;
  bool is_open = false;
  std::string failure{};
  std::string incoming{};
  std::deque<std::string> received{};
  std::vector<unsigned char> outgoing{};  // with the room in front that the library wants
  std::atomic<bool> is_woken{false};
  struct Timer {
    lws_sorted_usec_list_t entry{};  // first: the library hands back its address
    lws_context* context = nullptr;
    bool is_late = false;

    static void ring(lws_sorted_usec_list_t* entry) {
      auto* timer = reinterpret_cast<Timer*>(entry);
      timer->is_late = true;
      // Timers ring before the library looks at its sockets, where it would wait for something else.
      lws_cancel_service(timer->context);
    }
  };
  Timer timer{};

  ~Connection() {
    if (context != nullptr) lws_context_destroy(context);
  }

  static int on_event(lws* line, lws_callback_reasons reason, void*, void* in, std::size_t length) {
    auto* self = static_cast<Connection*>(lws_context_user(lws_get_context(line)));
    switch (reason) {
      case LWS_CALLBACK_CLIENT_ESTABLISHED:
        self->is_open = true;
        break;
      case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
        self->failure = in == nullptr ? "no reason reported"
                                      : std::string(static_cast<const char*>(in), length);
        self->line = nullptr;
        break;
      case LWS_CALLBACK_CLIENT_CLOSED:
        self->is_open = false;
        self->line = nullptr;
        break;
      case LWS_CALLBACK_CLIENT_RECEIVE:
        self->incoming.append(static_cast<const char*>(in), length);
        if (lws_is_final_fragment(line) != 0 && lws_remaining_packet_payload(line) == 0) {
          self->received.push_back(std::move(self->incoming));
          self->incoming.clear();
        }
        break;
      case LWS_CALLBACK_CLIENT_WRITEABLE:
        if (!self->outgoing.empty()) {
          const std::size_t payload = self->outgoing.size() - LWS_PRE;
          const int written =
              lws_write(line, self->outgoing.data() + LWS_PRE, payload, LWS_WRITE_TEXT);
          self->outgoing.clear();
          if (written < static_cast<int>(payload)) return -1;
        }
        break;
      default:
        break;
    }
    return 0;
  }

  // Lets the connection live until `done`, it ends or the time is over.
  template <typename Done>
  void serve_until(std::chrono::milliseconds patience, Done done) {
    timer.is_late = false;
    if (patience.count() > 0) {
      timer.context = context;
      lws_sul_schedule(context, 0, &timer.entry, &Timer::ring,
                       std::chrono::microseconds(patience).count());
    }
    while (!done() && line != nullptr && !timer.is_late) {
      const int wait = patience.count() > 0 ? 0 : -1;  // −1: what is there, and no waiting
      if (lws_service(context, wait) < 0 || wait < 0) break;
    }
    lws_sul_cancel(&timer.entry);
  }
};

WebSocket::WebSocket(const std::string& host, int port, std::chrono::milliseconds patience,
                     const std::stop_token& stop)
    : connection_(std::make_unique<Connection>()) {
  const auto latest = std::chrono::steady_clock::now() + patience;
  const std::string place = host + ":" + std::to_string(port);
  // Given a name, the library would look it up in a call that hears of no stop.
  const std::string address = host_address(host, patience, stop);
  lws_set_log_level(0, nullptr);  // what matters is told by whoever called
  static constexpr lws_protocols kProtocols[] = {
      {"asperity", &Connection::on_event, 0, kReceiveBuffer_bytes, 0, nullptr, 0},
      {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
  lws_context_creation_info settings{};
  settings.port = CONTEXT_PORT_NO_LISTEN;
  settings.protocols = kProtocols;
  settings.gid = static_cast<gid_t>(-1);
  settings.uid = static_cast<uid_t>(-1);
  settings.user = connection_.get();
  settings.fd_limit_per_thread = kMostFiles;
  connection_->context = lws_create_context(&settings);
  if (connection_->context == nullptr) {
    throw std::runtime_error("A connection to " + place +
                             " cannot be created. Close other programs, then try again.");
  }
  lws_client_connect_info target{};
  target.context = connection_->context;
  target.address = address.c_str();
  target.port = port;
  target.path = "/";
  target.host = host.c_str();
  target.origin = host.c_str();
  target.local_protocol_name = "asperity";
  target.pwsi = &connection_->line;
  lws_client_connect_via_info(&target);
  {
    const std::stop_callback wakes(
        stop, [context = connection_->context] { lws_cancel_service(context); });
    // At least a moment: no patience at all would mean no wait for what is there.
    const auto left = std::max(
        std::chrono::ceil<std::chrono::milliseconds>(latest - std::chrono::steady_clock::now()),
        std::chrono::milliseconds(1));
    connection_->serve_until(
        left, [this, &stop] { return connection_->is_open || stop.stop_requested(); });
  }
  if (!connection_->is_open) {
    const std::string& failure = connection_->failure;
    throw std::runtime_error("No service responds at " + place +
                             (failure.empty() ? "" : " (" + failure + ")") +
                             ". Check that it runs and that the address is correct.");
  }
}

WebSocket::~WebSocket() = default;

bool WebSocket::is_open() const noexcept { return connection_->is_open; }

int WebSocket::file() const noexcept {
  return connection_->is_open ? lws_get_socket_fd(connection_->line) : -1;
}

bool WebSocket::send(std::string_view text) {
  if (!connection_->is_open) return false;
  connection_->outgoing.assign(LWS_PRE + text.size(), 0);
  std::memcpy(connection_->outgoing.data() + LWS_PRE, text.data(), text.size());
  lws_callback_on_writable(connection_->line);
  connection_->serve_until(kToSend, [this] { return connection_->outgoing.empty(); });
  if (!connection_->outgoing.empty()) {
    // Nothing that was meant for then may go out later.
    connection_->outgoing.clear();
    connection_->is_open = false;
  }
  return connection_->is_open;
}

std::optional<std::string> WebSocket::receive(std::chrono::milliseconds patience) {
  if (connection_->received.empty()) {
    connection_->serve_until(
        patience, [this] { return !connection_->received.empty() || connection_->is_woken; });
    connection_->is_woken = false;
  }
  if (connection_->received.empty()) return std::nullopt;
  std::string message = std::move(connection_->received.front());
  connection_->received.pop_front();
  return message;
}

void WebSocket::wake() noexcept {
  connection_->is_woken = true;
  lws_cancel_service(connection_->context);
}

}  // namespace asperity
