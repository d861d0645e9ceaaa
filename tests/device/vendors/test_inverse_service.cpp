// A stand-in for Haply's Inverse Service, on the loopback and a free port.

#include "tests/device/vendors/test_inverse_service.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <deque>
#include <map>
#include <stdexcept>
#include <thread>

#include <libwebsockets.h>
#include <nlohmann/json.hpp>

namespace asperity {

using nlohmann::json;

struct TestInverseService::Server {
  Bench bench{};
  lws_context* context = nullptr;
  int port = 0;
  std::atomic<bool> ends{false};
  std::atomic<bool> hangs_up{false};
  std::thread thread{};

  // The server's thread.
  std::map<lws*, std::deque<std::string>> to_send{};
  std::map<lws*, std::string> incoming{};

  static int on_event(lws* line, lws_callback_reasons reason, void*, void* in, std::size_t length) {
    auto* self = static_cast<Server*>(lws_context_user(lws_get_context(line)));
    return self->handle(line, reason, in, length);
  }

  int handle(lws* line, lws_callback_reasons reason, void* in, std::size_t length) {
    switch (reason) {
      case LWS_CALLBACK_FILTER_PROTOCOL_CONNECTION: {
        const std::lock_guard lock(bench.mutex);
        return bench.refuses_connections ? 1 : 0;
      }
      case LWS_CALLBACK_ESTABLISHED: {
        const std::lock_guard lock(bench.mutex);
        ++bench.connections;
        if (!bench.lists_nothing) say(line, inventory());
        break;
      }
      case LWS_CALLBACK_CLOSED:
        to_send.erase(line);
        incoming.erase(line);
        break;
      case LWS_CALLBACK_RECEIVE:
        incoming[line].append(static_cast<const char*>(in), length);
        if (lws_is_final_fragment(line) != 0 && lws_remaining_packet_payload(line) == 0) {
          answer(line, json::parse(incoming[line], nullptr, false));
          incoming[line].clear();
        }
        break;
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        for (auto& [other, queue] : to_send) lws_callback_on_writable(other);
        break;
      case LWS_CALLBACK_SERVER_WRITEABLE: {
        if (hangs_up) return -1;
        std::deque<std::string>& queue = to_send[line];
        if (queue.empty()) break;
        std::vector<unsigned char> bytes(LWS_PRE + queue.front().size());
        std::memcpy(bytes.data() + LWS_PRE, queue.front().data(), queue.front().size());
        lws_write(line, bytes.data() + LWS_PRE, queue.front().size(), LWS_WRITE_TEXT);
        queue.pop_front();
        if (!queue.empty()) lws_callback_on_writable(line);
        break;
      }
      default:
        break;
    }
    return 0;
  }

  void say(lws* line, const json& message) {
    to_send[line].push_back(bench.talks_nonsense ? "{\"inverse3\": 7," : message.dump());
    lws_callback_on_writable(line);
  }

  json state_of_devices() const {
    json devices = json::array();
    for (const std::string& id : bench.ids) {
      json state;
      const auto vector = [](const std::array<double, 3>& v) {
        return json{{"x", v[0]}, {"y", v[1]}, {"z", v[2]}};
      };
      if (!bench.omits_identity || bench.position_m != std::array{0.0, 0.0, 0.0}) {
        state["cursor_position"] = vector(bench.position_m);
      }
      if (bench.scale != 1.0) {
        state["transform"]["scale"] = vector({bench.scale, bench.scale, bench.scale});
      }
      if (bench.tells_forces) state["current_cursor_force"] = vector(bench.force_N);
      if (!bench.omits_identity)
        state["body_orientation"] = {{"w", 1}, {"x", 0}, {"y", 0}, {"z", 0}};
      devices.push_back({{"device_id", id}, {"state", state}});
    }
    return devices;
  }

  json grips() const {
    json all = json::array();
    for (const std::string& id : bench.grips) {
      // Turned by 90° about the axis that points up, its second button down.
      const double half = bench.turns ? std::sqrt(0.5) : 0.0;
      all.push_back({{"device_id", id},
                     {"state",
                      {{"orientation", {{"w", half}, {"z", half}}},
                       {"buttons", {{"a", false}, {"b", true}, {"c", false}}}}}});
    }
    return all;
  }

  json inventory() const {
    json message;
    if (bench.numbers_sessions) message["session_id"] = 7;
    message["inverse3"] = state_of_devices();
    for (json& device : message["inverse3"]) {
      device["config"] = {
          {"handedness", "right"},
          {"preset", bench.preset},
          {"basis", {{"permutation", bench.axes}}},
          {"gravity_compensation", {{"enabled", true}, {"scaling_factor", 0.75}}},
          {"torque_scaling", {{"enabled", true}}},
          {"filters", {{"force_gate", {{"gain", 0.3}}}, {"damping", {{"scalar", 0.5}}}}}};
    }
    if (!bench.grips.empty()) message["wireless_verse_grip"] = grips();
    return message;
  }

  bool is_stalled() {
    const std::lock_guard lock(bench.mutex);
    return bench.stalls && !ends;
  }

  void answer(lws* line, const json& message) {
    while (is_stalled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    int delay_ms = 0;
    {
      const std::lock_guard lock(bench.mutex);
      ++bench.messages;
      if (message.contains("session")) {
        bench.profiles.push_back(message["session"]["configure"]["profile"]["name"]);
      }
      const json& command = message["inverse3"][0]["commands"]["set_cursor_force"];
      bench.force_N = {0.0, 0.0, 0.0};  // a force is for one message
      if (command.contains(bench.force_field)) {
        const json& force = command[bench.force_field];
        bench.force_N = {force["x"], force["y"], force["z"]};
        bench.strongest_N = std::max(
            bench.strongest_N, std::hypot(bench.force_N[0], bench.force_N[1], bench.force_N[2]));
      }
      if (bench.was_dropped) {
        bench.after_a_drop_N = std::max(
            bench.after_a_drop_N, std::hypot(bench.force_N[0], bench.force_N[1], bench.force_N[2]));
      }
      bench.was_dropped = bench.answers_to_drop > 0;
      if (bench.was_dropped) {
        --bench.answers_to_drop;
        return;
      }
      if (!bench.answers_forces && bench.force_N != std::array{0.0, 0.0, 0.0}) return;
      delay_ms = bench.delay_ms;
      if (bench.answers_to_delay > 0 && --bench.answers_to_delay == 0) bench.delay_ms = 0;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
    const std::lock_guard lock(bench.mutex);
    ++bench.answers;
    if (bench.counts_in_position) bench.position_m[0] = bench.answers;
    json update{{"inverse3", state_of_devices()}};
    if (!bench.grips.empty()) update["wireless_verse_grip"] = grips();
    say(line, update);
  }
};

TestInverseService::TestInverseService() : server_(std::make_unique<Server>()) {
  lws_set_log_level(0, nullptr);
  static constexpr lws_protocols kProtocols[] = {
      {"asperity", &Server::on_event, 0, 65536, 0, nullptr, 0},
      {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
  lws_context_creation_info settings{};
  settings.port = 0;  // any that is free
  settings.iface = "127.0.0.1";
  settings.protocols = kProtocols;
  settings.gid = static_cast<gid_t>(-1);
  settings.uid = static_cast<uid_t>(-1);
  settings.user = server_.get();
  settings.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
  server_->context = lws_create_context(&settings);
  lws_vhost* host =
      server_->context == nullptr ? nullptr : lws_create_vhost(server_->context, &settings);
  if (host == nullptr) throw std::runtime_error("the stand-in service cannot listen");
  server_->port = lws_get_vhost_listen_port(host);
  server_->thread = std::thread([server = server_.get()] {
    while (!server->ends && lws_service(server->context, 0) >= 0) {
      if (server->hangs_up && server->to_send.empty()) server->hangs_up = false;
    }
  });
}

TestInverseService::~TestInverseService() {
  server_->ends = true;
  lws_cancel_service(server_->context);
  server_->thread.join();
  lws_context_destroy(server_->context);
}

TestInverseService::Bench& TestInverseService::bench() noexcept { return server_->bench; }

std::string TestInverseService::place() const {
  return "127.0.0.1:" + std::to_string(server_->port);
}

void TestInverseService::disconnect() {
  server_->hangs_up = true;
  lws_cancel_service(server_->context);
}

}  // namespace asperity
