// A limit for calls into the drivers of devices, which a thread of its own watches.

#include "app/cli/call_limit.h"

#include <cstdlib>
#include <utility>

#include "app/cli/output/terminal.h"

namespace asperity {

CallLimit::CallLimit(std::string device)
    : device_(std::move(device)),
      watcher_([this](const std::stop_token& ended) { watch(ended); }) {}

void CallLimit::begin(std::string call, std::chrono::seconds limit) {
  const std::lock_guard lock(mutex_);
  call_ = Call{
      .name = std::move(call), .limit = limit, .latest = std::chrono::steady_clock::now() + limit};
  changed_.notify_all();
}

void CallLimit::end() {
  const std::lock_guard lock(mutex_);
  call_.reset();
  changed_.notify_all();
}

void CallLimit::watch(const std::stop_token& ended) {
  std::unique_lock lock(mutex_);
  while (!ended.stop_requested()) {
    if (!call_) {
      changed_.wait(lock, ended, [this] { return call_.has_value(); });
      continue;
    }
    const auto latest = call_->latest;
    const bool has_changed = changed_.wait_until(
        lock, ended, latest, [this, latest] { return !call_ || call_->latest != latest; });
    if (has_changed || ended.stop_requested()) continue;
    say("asperity: the device " + device_ + " does not respond: its driver has not returned from " +
        call_->name + " for " + std::to_string(call_->limit.count()) +
        " s. Switch the device off, check its cables, then switch it on and try again");
    std::_Exit(1);
  }
}

}  // namespace asperity
