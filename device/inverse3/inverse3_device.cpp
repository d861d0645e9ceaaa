// An Inverse3 of Haply, through the service that its maker installs on the same machine.

#include "device/inverse3/inverse3_device.h"

#include <atomic>
#include <charconv>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <sys/prctl.h>
#include <thread>
#include <utility>
#include <vector>

#include "device/inverse3/inverse3_shutdown.h"
#include "device/inverse3/web_socket.h"
#include "device/small_turn.h"
#include "device/units_in_use.h"
#include "device/velocity_estimator.h"

namespace asperity {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr VelocityWindow kInverse3Window{.samples = 5};  // 2 ms late at 1 kHz
constexpr milliseconds kBetweenConnections(500);
constexpr milliseconds kForLastWord(100);
constexpr double kTrialForce_N = 0.02;
constexpr int kTrialMessages = 3;  // the force that a service tells may be the one before
// What is asked of it at most, and where: the service tells neither.
constexpr double kMostForce_N = 5.0;
constexpr double kHalfBox_m = 0.12;
// Where the documents have the handle rest when the origin is the device's base.
constexpr glm::dvec3 kRestFromBase_m(0.0, -0.12, 0.15);

void require_no_stop_at(const InverseServicePlace& place, const std::stop_token& stop) {
  if (!stop.stop_requested()) return;
  throw OpeningStopped("The Inverse Service at " + place.text() +
                       " was not reached: opening the device was stopped on request. "
                       "Open it again to use it.");
}

std::unique_ptr<WebSocket> connection_to(const InverseServicePlace& place,
                                         const Inverse3Patience& patience,
                                         const std::stop_token& stop) {
  try {
    return std::make_unique<WebSocket>(place.host, place.port, patience.connection, stop);
  } catch (const std::runtime_error&) {
    require_no_stop_at(place, stop);
    throw;
  }
}

Inverse3Inventory inventory_at(WebSocket& socket, const InverseServicePlace& place,
                               const Inverse3Patience& patience, const std::stop_token& stop) {
  const std::stop_callback wakes(stop, [&socket] { socket.wake(); });
  const std::optional<std::string> message = socket.receive(patience.inventory);
  require_no_stop_at(place, stop);
  std::optional<Inverse3Inventory> inventory = message ? inventory_from(*message) : std::nullopt;
  if (!inventory) {
    throw std::runtime_error("The program at " + place.text() +
                             " is not Haply's Inverse Service: it does not list devices. Name the "
                             "address of the service "
                             "with --service HOST:PORT.");
  }
  return *std::move(inventory);
}

// Zero as the last word of a connection, waited for until so many updates came: an end at once may take it along.
void say_last(WebSocket& socket, const std::string& zero, int updates) {
  if (!socket.send(zero)) return;
  // One of the waits may end at once by what woke us.
  for (int waits = updates + 1; waits > 0 && updates > 0; --waits) {
    if (socket.receive(kForLastWord)) --updates;
  }
}

// Where a device is asked for something before it is used, and how long an answer is waited for.
struct Inquiry {
  WebSocket& socket;
  const InverseServicePlace& place;
  const std::string& id;
  const Inverse3Patience& patience;
  const std::stop_token& stop;
};

// The upward force that the service tells after it was asked for one, in this spelling.
double told_force_N(const Inquiry& at, ForceSpelling spelling, double force_N,
                    const std::string& profile = {}) {
  const std::string& id = at.id;
  const std::stop_callback wakes(at.stop, [&at] { at.socket.wake(); });
  double told_N = 0.0;
  for (int i = 0; i < kTrialMessages; ++i) {
    if (!at.socket.send(force_command(id, spelling, {0.0, 0.0, force_N}, i == 0 ? profile : "")))
      break;
    const std::optional<std::string> message = at.socket.receive(at.patience.inventory);
    require_no_stop_at(at.place, at.stop);
    const std::optional<Inverse3State> state = message ? state_from(*message, id) : std::nullopt;
    if (!state) {
      throw std::runtime_error("The Inverse Service does not report the position of the Inverse3 " +
                               id + ". Check that it has power and that no other program uses it.");
    }
    told_N = state->force_N.z;
  }
  return told_N;
}

struct FoundSpelling {
  ForceSpelling spelling = ForceSpelling::vector;
  bool is_confirmed = false;  // the service told that it applied a force that was so spelt
};

// A service that does not know a spelling takes the message and applies no force.
FoundSpelling spelling_of(const Inquiry& at, const Inverse3Inventory& inventory) {
  const double without_N = told_force_N(at, ForceSpelling::vector, 0.0, "asperity");
  for (const ForceSpelling spelling : {ForceSpelling::vector, ForceSpelling::values}) {
    double with_N = 0.0;
    try {
      with_N = told_force_N(at, spelling, kTrialForce_N);
      told_force_N(at, spelling, 0.0);
    } catch (...) {
      constexpr int kWithThatOfTheTrial = 2;
      say_last(at.socket, force_command(at.id, spelling, {}), kWithThatOfTheTrial);
      throw;
    }
    if (with_N - without_N > 0.5 * kTrialForce_N)
      return {.spelling = spelling, .is_confirmed = true};
  }
  // It does not tell what it applies: what the documents of its version say.
  return {.spelling = inventory.has_session ? ForceSpelling::vector : ForceSpelling::values};
}

// From where the service counts to where we do; refuses what would turn "up" into another direction, or a
// millimetre into two.
glm::dvec3 origin_of(const Inverse3Entry& entry) {
  const std::string remedy =
      " Set it to the preset \"defaults\" and the basis \"XYZ\", in Haply's Device Manager or as "
      "the service's documents describe, and open it again.";
  const std::string who = "The Inverse3 " + entry.id;
  if (!entry.axes.empty() && entry.axes != "XYZ") {
    throw std::runtime_error(who + " reports its axes as \"" + entry.axes +
                             "\"; this program needs x to the right, y away, z up, \"XYZ\"." +
                             remedy);
  }
  if (entry.is_transformed) {
    throw std::runtime_error(who +
                             " reports positions that a mount or a workspace transform moves, "
                             "turns or scales; forces and sizes would not be those at the hand." +
                             remedy);
  }
  if (entry.preset.empty() || entry.preset == "defaults" || entry.preset == "arm_front") {
    return kRestFromBase_m;
  }
  if (entry.preset == "arm_front_centered") return glm::dvec3(0.0);
  throw std::runtime_error(
      who + " has the workspace preset \"" + entry.preset +
      "\", with which the directions of its axes are unknown to this program." + remedy);
}

bool has_origin(const Inverse3Entry& entry, const glm::dvec3& origin_m) {
  try {
    return origin_of(entry) == origin_m;
  } catch (const std::runtime_error&) {
    return false;
  }
}

std::string remark_on(const FoundSpelling& found) {
  const std::string name = found.spelling == ForceSpelling::vector ? "vector" : "values";
  if (found.is_confirmed) return "The format of forces is \"" + name + "\".";
  return "The format of forces is \"" + name +
         "\", as documented for the service's version; the service did not confirm that it applies "
         "forces in this format. Check by hand that a force can be felt before the first session.";
}

}  // namespace

InverseServicePlace InverseServicePlace::of(const std::string& text) {
  InverseServicePlace place;
  const std::size_t colon = text.rfind(':');
  if (!text.substr(0, colon).empty()) place.host = text.substr(0, colon);
  if (colon == std::string::npos) return place;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data() + colon + 1, end, place.port);
  if (error != std::errc() || stopped != end || place.port < 1 || place.port > 65535) {
    throw std::runtime_error("The address of the Inverse Service is \"" + text +
                             "\"; it must be HOST:PORT, with a port from 1 to 65535.");
  }
  return place;
}

struct Inverse3Device::Opened {
  InverseServicePlace place{};
  Inverse3Patience patience{};
  std::unique_ptr<WebSocket> socket{};
  DeviceCapability capability{};
  ForceSpelling spelling = ForceSpelling::vector;
  glm::dvec3 origin_m{0.0};
  std::string grip_id{};
};

// The driver's thread and what it holds.
struct Inverse3Device::Line {
  InverseServicePlace place;
  Inverse3Patience patience;
  std::string id;
  std::string grip_id;
  ForceSpelling spelling = ForceSpelling::vector;
  glm::dvec3 origin_m{0.0};
  UnitInUse in_use;

  explicit Line(Opened& opened)
      : place(opened.place),
        patience(opened.patience),
        id(opened.capability.serial),
        grip_id(opened.grip_id),
        spelling(opened.spelling),
        origin_m(opened.origin_m),
        in_use("inverse3", {.model = opened.capability.model,
                            .serial = opened.capability.serial,
                            .place = opened.place.text()}),
        socket(std::move(opened.socket)) {
    begin_watch();
  }

  std::mutex mutex{};  // for `socket` being another one, and for `changed`
  std::condition_variable changed{};
  std::unique_ptr<WebSocket> socket{};
  // Of this connection, which does not end before it: it has the connection's file as well.
  Inverse3Shutdown shutdown{};
  std::unique_ptr<WatchdogProcess> watchdog{};
  bool stopping = false;
  std::thread thread{};

  // The driver's thread.
  TickCall call{};
  bool is_ready = true;  ///< the device was on this connection's list
  std::optional<Inverse3State> state{};
  Wrench wanted{};
  VelocityEstimator velocity{kInverse3Window};
  VelocityEstimator angular_velocity{kInverse3Window, kFastestTurn_rad_per_s};
  glm::dvec3 turned_rad{0.0};
  glm::dquat last_grip{1.0, 0.0, 0.0, 0.0};

  std::atomic<bool> is_connected{true};
  std::atomic<bool> knows_device{true};
  std::atomic<bool> is_watched{true};     ///< otherwise nobody would take its force away for us
  std::atomic<bool> is_elsewhere{false};  ///< with axes or an origin other than when it was opened

  std::mutex tick_mutex{};  ///< for `is_in_tick`; no tick holds it
  bool is_in_tick = false;  ///< the connection is not used by the driver's thread

  void note_tick(bool is_under_way) {
    const std::lock_guard lock(tick_mutex);
    is_in_tick = is_under_way;
  }

  bool must_stop() {
    const std::lock_guard lock(mutex);
    return stopping;
  }

  // Errors: std::runtime_error where no process can be started: then there is no force.
  void begin_watch() {
    shutdown = Inverse3Shutdown::over(socket->file(), command({}));
    watchdog = std::make_unique<WatchdogProcess>(&shut_down_inverse3, &shutdown, shutdown.file);
    is_watched.store(true);
  }

  std::string command(const glm::dvec3& force_N) const {
    return force_command(id, spelling, force_N);
  }

  void run() {
    prctl(PR_SET_TIMERSLACK, 1UL);
    const auto period = std::chrono::duration_cast<steady_clock::duration>(
        std::chrono::duration<double>(1.0 / call.rate_Hz));
    std::string message = command({});
    while (!must_stop()) {
      if (!is_ready || !socket->is_open()) {
        reconnect();
        message = command({});
        continue;
      }
      if (!watchdog->is_there()) {
        is_watched.store(false);
        message = command({});
      }
      const steady_clock::time_point sent = steady_clock::now();
      if (!socket->send(message)) continue;  // the line is closed
      const std::optional<std::string> update = socket->receive(patience.update);
      if (must_stop()) break;
      if (!update) {
        message = command({});
        continue;
      }
      state = state_from(*update, id, grip_id);
      knows_device.store(state.has_value());
      wanted = Wrench{};
      note_tick(true);
      call.function(call.argument);
      note_tick(false);
      message = command(wanted.force_N);
      std::this_thread::sleep_until(sent + period);
      // An update that came after all, for a message that was thought lost, must not be taken for the next one.
      while (socket->receive(milliseconds(0))) {
      }
    }
    say_last(*socket, command({}), 1);
  }

  // One trial to have the connection and the device back; waits a while after one that failed.
  void reconnect() {
    is_connected.store(false);
    state.reset();
    velocity.reset();
    angular_velocity.reset();
    bool is_there = false;
    bool tells_otherwise = false;
    watchdog.reset();
    try {
      auto fresh = std::make_unique<WebSocket>(place.host, place.port, patience.connection);
      {
        const std::lock_guard lock(mutex);
        socket = std::move(fresh);
        if (stopping) return;
      }
      for (const Inverse3Entry& entry : inventory_at(*socket, place, patience, {}).devices) {
        if (entry.id != id) continue;
        // Restarted with other axes the service would have forces point elsewhere.
        is_there = has_origin(entry, origin_m);
        tells_otherwise = !is_there;
      }
      knows_device.store(is_there || tells_otherwise);
      if (is_there) begin_watch();
    } catch (const std::runtime_error&) {
      is_there = false;  // `trouble` tells that there is no connection
    }
    is_elsewhere.store(tells_otherwise);
    is_ready = is_there;
    is_connected.store(is_there);
    if (is_there) return;
    std::unique_lock lock(mutex);
    changed.wait_for(lock, kBetweenConnections, [this] { return stopping; });
  }
};

std::unique_ptr<Inverse3Device::Opened> Inverse3Device::open(const InverseServicePlace& place,
                                                             const std::string& device_id,
                                                             const Inverse3Patience& patience,
                                                             const std::stop_token& stop) {
  auto opened = std::make_unique<Opened>();
  opened->place = place;
  opened->patience = patience;
  opened->socket = connection_to(place, patience, stop);
  const Inverse3Inventory inventory = inventory_at(*opened->socket, place, patience, stop);
  const Inverse3Entry* entry = nullptr;
  for (const Inverse3Entry& candidate : inventory.devices) {
    if (candidate.id == device_id) entry = &candidate;
  }
  if (entry == nullptr) {
    throw std::runtime_error("The Inverse Service at " + place.text() + " has no Inverse3 \"" +
                             device_id + "\": check its power and its cable.");
  }
  opened->origin_m = origin_of(*entry);
  const FoundSpelling found = spelling_of({.socket = *opened->socket,
                                           .place = place,
                                           .id = device_id,
                                           .patience = patience,
                                           .stop = stop},
                                          inventory);
  opened->spelling = found.spelling;
  // A grip does not say which arm it is screwed to.
  if (inventory.grips.size() == 1 && inventory.devices.size() == 1) {
    opened->grip_id = inventory.grips.front();
  }
  const bool has_grip = !opened->grip_id.empty();
  DeviceCapability& capability = opened->capability;
  capability.name = "inverse3";
  capability.model = "Inverse3";
  capability.serial = device_id;
  capability.sensed_degrees_of_freedom = has_grip ? 6 : 3;
  capability.actuated_degrees_of_freedom = 3;
  capability.workspace_minimum_m = glm::dvec3(-kHalfBox_m);
  capability.workspace_maximum_m = glm::dvec3(kHalfBox_m);
  capability.peak_force_N = kMostForce_N;
  capability.maximum_rate_Hz = 1000.0;
  capability.buttons = has_grip ? 3 : 0;
  capability.pacing = Pacing::theirs;
  capability.remarks =
      filters_of(*entry) + " Its axes are " + (entry->axes.empty() ? "not reported" : entry->axes) +
      ", its workspace preset is " + (entry->preset.empty() ? "not reported" : entry->preset) +
      ". The service reports neither its peak force nor its workspace: 5 N and a box of 24 cm are "
      "limits set by this program. " +
      remark_on(found) + " Velocity is the slope of the last five positions.";
  if (!has_grip && !inventory.grips.empty()) {
    capability.remarks +=
        " Its grip is not read: with more than one device or more than one grip, the service does "
        "not report which grip belongs to which device.";
  }
  return opened;
}

Inverse3Device::Inverse3Device(const InverseServicePlace& place, const std::string& device_id,
                               const Inverse3Patience& patience, const std::stop_token& stop)
    : Inverse3Device(open(place, device_id, patience, stop)) {}

Inverse3Device::Inverse3Device(std::unique_ptr<Opened> opened)
    : HapticDevice(opened->capability, ForceLimits{}), line_(std::make_unique<Line>(*opened)) {}

Inverse3Device::~Inverse3Device() { stop_calls(); }

void Inverse3Device::start_calls(const TickCall& call) {
  if (line_->thread.joinable())
    throw std::logic_error(
        "the calls of the device inverse3 have already begun; call stop_calls first");
  line_->call = call;
  line_->stopping = false;
  line_->thread = std::thread([line = line_.get()] { line->run(); });
}

void Inverse3Device::stop_calls() noexcept {
  if (!line_->thread.joinable()) return;
  {
    const std::lock_guard lock(line_->mutex);
    line_->stopping = true;
    line_->socket->wake();
  }
  line_->changed.notify_all();
  line_->thread.join();
}

void Inverse3Device::zero_force_from_outside() noexcept {
  const std::lock_guard lock(line_->tick_mutex);
  // Between two ticks the thread of the driver runs, and sends by itself.
  if (line_->is_in_tick) shut_down_inverse3(WatchdogProcess::Cause::stopped, &line_->shutdown);
}

bool Inverse3Device::do_read(std::int64_t now_ns, ProbeState& state) noexcept {
  Line& line = *line_;
  if (!line.state || !line.is_watched.load(std::memory_order_relaxed)) return false;
  state.position_m = line.state->position_m - line.origin_m;
  state.velocity_m_per_s = line.velocity.add(now_ns, state.position_m);
  state.orientation = line.state->grip.value_or(line.last_grip);
  line.turned_rad += small_turn_rad(line.last_grip, state.orientation);
  line.last_grip = state.orientation;
  state.angular_velocity_rad_per_s = line.angular_velocity.add(now_ns, line.turned_rad);
  state.buttons = line.state->buttons;
  return true;
}

bool Inverse3Device::do_send(const Wrench& limited) noexcept {
  const bool is_watched = line_->is_watched.load(std::memory_order_relaxed);
  line_->wanted = is_watched ? limited : Wrench{};  // goes out with the next message
  return is_watched && line_->state.has_value();
}

std::string Inverse3Device::trouble() const {
  const std::string who = "the Inverse3 " + capability().serial;
  if (!line_->knows_device.load()) {
    return "The Inverse Service no longer detects " + who + ": check its power and its cable.";
  }
  if (line_->is_elsewhere.load()) {
    return "The Inverse Service responds again but reports " + who +
           " in other axes or from another origin than when it was opened: no force is sent. "
           "Restore the axes and the origin in Haply's Device Manager, or end the session and open "
           "the device again.";
  }
  if (!line_->is_connected.load()) {
    return "The connection to the Inverse Service at " + line_->place.text() +
           " was lost: check that the service runs. This program tries to connect again.";
  }
  if (!line_->is_watched.load()) {
    return "The Inverse3 " + capability().serial + " receives no force: " + kWatchdogIsGone +
           ". End the session and open the device again.";
  }
  if (has_fallen_silent()) {
    return "The Inverse Service at " + line_->place.text() + " has reported nothing about " + who +
           " for more than " + std::to_string(kLongestSilence_ns / 1'000'000) +
           " ms: check that the service runs, that no other program keeps this computer busy, and "
           "that the device has power.";
  }
  return "";
}

namespace {

DriverSurvey inverse3_survey(const DriverOptions& options, const Inverse3Patience& patience) {
  DriverSurvey survey;
  std::optional<InverseServicePlace> place;
  try {
    place = InverseServicePlace::of(options.service);
    const auto socket = connection_to(*place, patience, options.stop);
    const Inverse3Inventory inventory = inventory_at(*socket, *place, patience, options.stop);
    survey.found = "Haply's Inverse Service at " + place->text();
    const std::vector<AttachedDevice> ours = UnitInUse::of("inverse3");
    for (const Inverse3Entry& entry : inventory.devices) {
      AttachedDevice device{.model = "Inverse3",
                            .serial = entry.id,
                            .place = place->text(),
                            .remark = filters_of(entry)};
      for (const AttachedDevice& used : ours) {
        if (used.serial == device.serial && used.place == device.place) device = used;
      }
      survey.attached.push_back(device);
    }
  } catch (const std::runtime_error& refusal) {
    survey.blocker = refusal.what();
    if (place) {
      survey.blocker +=
          " Install Haply's Inverse Service and start it (systemctl start haply-inverse-service), "
          "or name its address with --service HOST:PORT.";
    }
  }
  return survey;
}

}  // namespace

Driver inverse3_driver(const Inverse3Patience& patience) {
  return {.id = "inverse3",
          .name = "Haply Inverse3",
          .summary = "Inverse3 of Haply, through the manufacturer's local service.",
          .velocity = kInverse3Window,
          .find = [patience](
                      const DriverOptions& options) { return inverse3_survey(options, patience); },
          .open = [patience](const std::string& which,
                             const DriverOptions& options) -> std::unique_ptr<HapticDevice> {
            const DriverSurvey survey = inverse3_survey(options, patience);
            require_no_stop_at(InverseServicePlace::of(options.service), options.stop);
            if (!survey.blocker.empty()) throw std::runtime_error(survey.blocker);
            const AttachedDevice device = choose_attached("Inverse3", survey.attached, which);
            return std::make_unique<Inverse3Device>(InverseServicePlace::of(options.service),
                                                    device.serial, patience, options.stop);
          }};
}

}  // namespace asperity
