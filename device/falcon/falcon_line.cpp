// The conversation with one Falcon, on a thread of its own.

#include "device/falcon/falcon_line.h"

#include <algorithm>
#include <chrono>
#include <pthread.h>
#include <sched.h>
#include <stdexcept>
#include <utility>

#include "device/drivers.h"
#include "device/pause.h"

namespace asperity::falcon {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPatience{20};  // for one frame; far more than it ever takes
constexpr milliseconds kPauseAfterError{1};
constexpr milliseconds kPauseBetweenSearches{200};
constexpr std::int64_t kSilence_ns = 1'000'000'000;  // after which the device is opened anew
constexpr int kPartingFrames = 3;
constexpr int kMeasuredFrames = 40;
constexpr std::int64_t kMeasuring_ns = 500'000'000;
// Above the servo's priority: it sleeps on the bus nearly always, and its answer should be there when
// a tick begins.
constexpr int kFifoPriority = 81;

// After a longer pause the program stood still, and frames of the watchdog were answered meanwhile.
constexpr std::int64_t kLongestGap_ns = 45'000'000;
// Exchanges that begin with what may still come to frames before, until so many have found nothing.
constexpr int kDoubtfulExchanges = 3;
constexpr int kMostLeftOver = 16;  // packets; the chip holds fewer

// Of the calling thread. Refused to most users, which the session's record says of the servo.
void take_priority(int policy) noexcept {
  const sched_param priority{policy == SCHED_FIFO ? kFifoPriority : 0};
  (void)pthread_setschedparam(pthread_self(), policy, &priority);
}

std::uint64_t packed(const std::array<std::int16_t, 3>& words) noexcept {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    bits |= std::uint64_t{static_cast<std::uint16_t>(words[i])} << (16 * i);
  }
  return bits;
}

std::array<std::int16_t, 3> unpacked(std::uint64_t bits) noexcept {
  std::array<std::int16_t, 3> words{};
  for (std::size_t i = 0; i < 3; ++i) {
    words[i] = static_cast<std::int16_t>(static_cast<std::uint16_t>(bits >> (16 * i)));
  }
  return words;
}

}  // namespace

void require_no_stop(const std::stop_token& stop) {
  if (!stop.stop_requested()) return;
  throw OpeningStopped(
      "the Novint Falcon was closed: opening it was stopped on request; open it again to use it");
}

FalconLine::FalconLine(LineSettings settings, const std::stop_token& stop)
    : settings_(std::move(settings)), answers_(settings_.velocity) {
  if (!settings_.clock) throw std::invalid_argument("LineSettings::clock is missing; set it");
  open(stop);
  thread_ = std::jthread([this](const std::stop_token& ended) { converse(ended); });
}

FalconLine::~FalconLine() = default;  // the thread is the last member: stopped and joined first

void FalconLine::command(const std::array<std::int16_t, 3>& motor_words) noexcept {
  words_.store(packed(motor_words), std::memory_order_relaxed);
  commanded_ns_.store(now_ns(), std::memory_order_release);
}

void FalconLine::open(const std::stop_token& stop) {
  was_alone_ = attached_falcons(usb_).size() == 1;
  auto port = std::make_unique<FalconPort>(usb_, settings_.place);
  make_ready(*port, stop);
  require_no_stop(stop);
  port_ = std::move(port);
  begin_watch();
  heard_ns_ = exchanged_ns_ = now_ns();
  connected_.store(true, std::memory_order_release);
  rate_Hz_ = measured_rate_Hz();
}

void FalconLine::begin_watch() {
  watched_.store(false, std::memory_order_release);
  last_words_ = port_->last_words();
  if (last_words_.file < 0) {
    throw std::runtime_error(
        "the Novint Falcon at " + settings_.place +
        " receives no force: libusb does not report the file through which it communicates with "
        "the device, so that the force could not be set to zero if this program hangs; use the "
        "libusb of your Linux distribution");
  }
  watchdog_ = std::make_unique<WatchdogProcess>(&say_last_words, &last_words_, last_words_.file);
  watched_.store(true, std::memory_order_release);
}

void FalconLine::make_ready(FalconPort& port, const std::stop_token& stop) const {
  if (port.begin_frames() == Transfer::done && speaks_frames(port, stop)) return;
  if (stop.stop_requested()) return;  // what it has not said yet is not known
  if (settings_.firmware.empty()) {
    throw std::runtime_error(no_firmware_sentence(settings_.place));
  }
  load_firmware(port, settings_.firmware, stop);
}

// The median, so that a moment's delay does not slow the device down on paper.
double FalconLine::measured_rate_Hz() {
  std::array<std::int64_t, kMeasuredFrames> durations_ns{};
  std::size_t count = 0;
  const std::int64_t began_ns = now_ns();
  std::int64_t last_ns = began_ns;
  while (count < durations_ns.size() && last_ns - began_ns < kMeasuring_ns) {
    (void)exchange();
    const std::int64_t ended_ns = now_ns();
    durations_ns[count++] = ended_ns - last_ns;
    last_ns = ended_ns;
  }
  const auto middle = durations_ns.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(durations_ns.begin(), middle,
                   durations_ns.begin() + static_cast<std::ptrdiff_t>(count));
  return 1e9 / static_cast<double>(std::max<std::int64_t>(*middle, 1));
}

void FalconLine::converse(const std::stop_token& stop) {
  if (settings_.wants_fifo) take_priority(SCHED_FIFO);
  while (!stop.stop_requested()) {
    if (!port_) {
      if (!reopen(stop)) {
        pause(stop, kPauseBetweenSearches);
      } else if (settings_.wants_fifo) {
        take_priority(SCHED_FIFO);
      }
      continue;
    }
    if (!watchdog_->is_there()) watched_.store(false, std::memory_order_release);
    const Transfer ended = exchange();
    if (ended == Transfer::gone || now_ns() - heard_ns_ > kSilence_ns) {
      lose();
    } else if (ended != Transfer::done) {
      pause(stop, kPauseAfterError);
    }
  }
  const Frame zero = frame_of({});
  bool is_at_zero = !port_;
  for (int i = 0; !is_at_zero && i < kPartingFrames; ++i) {
    is_at_zero = port_->write(zero, kPatience) == Transfer::done;
  }
  if (!is_at_zero) leave_to_watchdog();
}

// Its motors may still have the last words, and over this connection they cannot be taken back.
void FalconLine::leave_to_watchdog() noexcept {
  if (watchdog_) watchdog_->leave_to_act();
  port_.reset();  // before the watchdog, which claims the device anew
  watchdog_.reset();
}

bool FalconLine::reopen(const std::stop_token& stop) {
  try {
    return is_reopened(stop);
  } catch (const std::exception&) {
    // It may have been plugged in for a moment only, or there was no memory: the next search tells.
    watchdog_.reset();
    port_.reset();
    return false;
  }
}

bool FalconLine::is_reopened(const std::stop_token& stop) {
  const std::vector<AttachedDevice> attached = attached_falcons(usb_);
  const AttachedDevice* same = found_again(
      {.place = settings_.place, .serial = settings_.serial, .was_alone = was_alone_}, attached);
  if (same == nullptr) return false;
  auto port = std::make_unique<FalconPort>(usb_, same->place);
  make_ready(*port, stop);
  if (stop.stop_requested()) return false;
  port_ = std::move(port);
  begin_watch();
  heard_ns_ = exchanged_ns_ = now_ns();
  connected_.store(true, std::memory_order_release);
  return true;
}

void FalconLine::lose() noexcept {
  connected_.store(false, std::memory_order_release);
  commanded_ns_.store(0, std::memory_order_release);
  // Searching takes its time, and is no business of the servo's neighbours.
  if (settings_.wants_fifo) take_priority(SCHED_OTHER);
  leave_to_watchdog();
  reader_.reset();
  answers_.reset();
}

Command FalconLine::command_at(std::int64_t time_ns) const noexcept {
  if (!answers_.is_homed()) return {.lamp = Lamp::red, .is_homing = true};
  Command command{.lamp = Lamp::green};
  if (!is_watched()) return command;
  const std::int64_t commanded_ns = commanded_ns_.load(std::memory_order_acquire);
  if (time_ns - commanded_ns < kForceLasts_ns) {
    command.motor_words = unpacked(words_.load(std::memory_order_relaxed));
  }
  return command;
}

Transfer FalconLine::exchange() {
  if (now_ns() - exchanged_ns_ > kLongestGap_ns) in_doubt_ = kDoubtfulExchanges;
  if (in_doubt_ > 0) {
    // Otherwise each answer from now on might be the one to a frame before.
    if (is_left_over()) {
      in_doubt_ = kDoubtfulExchanges;
    } else {
      --in_doubt_;
    }
    reader_.reset();
  }
  const std::int64_t began_ns = now_ns();
  exchanged_ns_ = began_ns;
  const Transfer ended = exchange_one(began_ns);
  if (ended != Transfer::done) in_doubt_ = kDoubtfulExchanges;
  return ended;
}

// Takes what comes until the device has nothing to say; whether that was anything.
bool FalconLine::is_left_over() {
  bool is_any = false;
  for (int packets = 0; packets < kMostLeftOver; ++packets) {
    FalconPort::Packet packet{};
    std::size_t count = 0;
    if (port_->read(packet, count, kPatience) != Transfer::done || count == 0) break;
    is_any = true;
  }
  return is_any;
}

Transfer FalconLine::exchange_one(std::int64_t began_ns) {
  if (const Transfer ended = port_->write(frame_of(command_at(began_ns)), kPatience);
      ended != Transfer::done) {
    return ended;
  }
  for (;;) {
    FalconPort::Packet packet{};
    std::size_t count = 0;
    const Transfer ended = port_->read(packet, count, kPatience);
    const std::int64_t ended_ns = now_ns();
    if (ended != Transfer::done) {
      if (ended != Transfer::timed_out) reader_.reset();  // half a frame will never be whole
      return ended;
    }
    // A late answer may be followed by the one to the next frame: the last one counts.
    bool heard = false;
    for (std::size_t i = 0; i < count; ++i) {
      const std::optional<Answer> answer = reader_.take(packet[i]);
      if (!answer) continue;
      heard = true;
      if (const std::optional<Reading> reading = answers_.take(*answer, ended_ns)) {
        heard_ns_ = ended_ns;
        readings_.put(*reading);
      }
    }
    if (heard) return Transfer::done;
    if (ended_ns - began_ns > std::chrono::nanoseconds(kPatience).count()) {
      return Transfer::timed_out;
    }
  }
}

}  // namespace asperity::falcon
