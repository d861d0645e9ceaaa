// The reports of one SpaceMouse, awaited on a thread of its own.

#include "device/spacemouse/spacemouse_line.h"

#include <chrono>
#include <mutex>
#include <utility>

#include "device/monotonic_clock.h"
#include "device/pause.h"

namespace asperity::spacemouse {
namespace {

constexpr std::chrono::milliseconds kBetweenSearches{200};

}  // namespace

SpaceMouseLine::SpaceMouseLine(LineSettings settings) : settings_(std::move(settings)) {
  was_alone_ = attached().size() == 1;
  open(settings_.place);
  thread_ = std::jthread([this](const std::stop_token& stop) { listen(stop); });
}

// The thread is the last member: stopped and joined first.
SpaceMouseLine::~SpaceMouseLine() = default;

std::vector<AttachedDevice> SpaceMouseLine::attached() const {
  std::vector<AttachedDevice> attached = attached_spacemice(usb_);
  std::erase_if(attached,
                [this](const AttachedDevice& one) { return one.model != settings_.model; });
  return attached;
}

void SpaceMouseLine::open(const std::string& place) {
  port_ = std::make_unique<SpaceMousePort>(usb_, place);
  in_use_ = std::make_unique<UnitInUse>(
      kSpaceMouse,
      AttachedDevice{.model = settings_.model, .serial = settings_.serial, .place = place});
  connected_.store(true, std::memory_order_release);
}

bool SpaceMouseLine::reopen() {
  // Somebody looks for devices, or opens one: there is a next time.
  const std::unique_lock alone(UnitInUse::looking(), std::try_to_lock);
  if (!alone.owns_lock()) return false;
  try {
    const std::vector<AttachedDevice> found = attached();
    const AttachedDevice* same = found_again(
        {.place = settings_.place, .serial = settings_.serial, .was_alone = was_alone_}, found);
    if (same == nullptr) return false;
    open(same->place);
    return true;
  } catch (const std::exception&) {
    // It may have been plugged in for a moment only, or there was no memory: the next search tells.
    port_.reset();
    return false;
  }
}

void SpaceMouseLine::listen(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (!port_) {
      if (!reopen()) pause(stop, kBetweenSearches);
      continue;
    }
    SpaceMousePort::Report report{};
    std::size_t count = 0;
    switch (port_->read(report, count)) {
      case SpaceMousePort::Read::nothing:
        break;
      case SpaceMousePort::Read::gone:
        lose();
        break;
      case SpaceMousePort::Read::report: {
        const CapReader::Told told = reader_.take({report.data(), count});
        if (told == CapReader::Told::nothing) break;
        if (told == CapReader::Told::motion) moved_ns_ = monotonic_now_ns();
        reports_.put({.cap = reader_.cap(), .moved_ns = moved_ns_});
        break;
      }
    }
  }
}

void SpaceMouseLine::lose() noexcept {
  reader_.reset();
  reports_.put({.cap = reader_.cap(), .moved_ns = moved_ns_});
  connected_.store(false, std::memory_order_release);
  port_.reset();
  in_use_.reset();
}

}  // namespace asperity::spacemouse
