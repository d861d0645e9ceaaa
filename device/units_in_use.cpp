// Which devices this process has open, so that no look at what is attached disturbs them.

#include "device/units_in_use.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "device/pause.h"

namespace asperity {
namespace {

struct Entry {
  const UnitInUse* unit = nullptr;
  std::string driver{};
  AttachedDevice device{};
};

struct UnitList {
  std::mutex looking{};
  std::mutex mutex{};  // for `entries`
  std::vector<Entry> entries{};
};

UnitList& units_of_this_process() {
  // Never destroyed: a device whose maker's thread hangs stays listed to the end of the process.
  static auto* const list = new UnitList;
  return *list;
}

}  // namespace

UnitInUse::UnitInUse(std::string driver, AttachedDevice device) {
  device.remark.clear();
  device.blocker = "This program uses it now. Close the device here, then try again.";
  UnitList& list = units_of_this_process();
  const std::lock_guard lock(list.mutex);
  list.entries.push_back({.unit = this, .driver = std::move(driver), .device = std::move(device)});
}

UnitInUse::~UnitInUse() {
  UnitList& list = units_of_this_process();
  const std::lock_guard lock(list.mutex);
  std::erase_if(list.entries, [this](const Entry& entry) { return entry.unit == this; });
}

std::vector<AttachedDevice> UnitInUse::of(std::string_view driver) {
  UnitList& list = units_of_this_process();
  const std::lock_guard lock(list.mutex);
  std::vector<AttachedDevice> devices;
  for (const Entry& entry : list.entries) {
    if (entry.driver == driver) devices.push_back(entry.device);
  }
  return devices;
}

bool UnitInUse::is_any() {
  UnitList& list = units_of_this_process();
  const std::lock_guard lock(list.mutex);
  return !list.entries.empty();
}

std::mutex& UnitInUse::looking() { return units_of_this_process().looking; }

LetOthersLook::LetOthersLook(std::unique_lock<std::mutex>* alone, std::stop_token stop)
    : alone_(alone), stop_(std::move(stop)) {
  if (alone_ != nullptr) alone_->unlock();
}

LetOthersLook::~LetOthersLook() {
  constexpr std::chrono::milliseconds kBetweenTrials(10);
  if (alone_ == nullptr) return;
  while (!alone_->try_lock() && !stop_.stop_requested()) pause(stop_, kBetweenTrials);
}

}  // namespace asperity
