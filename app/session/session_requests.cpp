// Stores requests under a mutex until the session takes them; an emergency stop reaches the rig at once.

#include "app/session/session_requests.h"

#include <stdexcept>
#include <utility>

#include "app/session/rig/rig.h"
#include "app/words/reason.h"

namespace asperity {

namespace {

/// The reason to be stored; never empty.
Phrase given(const Phrase& reason) {
  return reason.empty() ? phrase_of(Reason::none_given) : reason;
}

}  // namespace

void SessionRequests::stop_after(StopAfter what) {
  const std::lock_guard lock(mutex_);
  stop_ = what;
}

void SessionRequests::go_on() {
  const std::lock_guard lock(mutex_);
  stop_.reset();
}

void SessionRequests::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
}

void SessionRequests::resume() {
  const std::lock_guard lock(mutex_);
  paused_ = false;
}

void SessionRequests::repeat_last(const Phrase& reason) {
  const std::lock_guard lock(mutex_);
  repeat_ = given(reason);
}

void SessionRequests::skip(const Phrase& reason) {
  const std::lock_guard lock(mutex_);
  skip_ = given(reason);
}

void SessionRequests::abort(const Phrase& reason) {
  const std::lock_guard lock(mutex_);
  abort_ = given(reason);
}

void SessionRequests::note(const Phrase& text) { remark("note", text); }

void SessionRequests::remark(const std::string& kind, const Phrase& text) {
  const std::lock_guard lock(mutex_);
  remarks_.push_back({rig_ == nullptr ? 0 : rig_->clock().now_ns(), kind, text});
}

void SessionRequests::emergency_stop() noexcept {
  const std::lock_guard lock(mutex_);
  stop_wanted_ = true;
  clear_fault_ = false;  // requested before this stop, and not meant for it
  if (rig_ != nullptr) rig_->emergency_stop();
}

void SessionRequests::press_button(int button) { move_button({button, Move::press}); }

void SessionRequests::release_button(int button) { move_button({button, Move::release}); }

void SessionRequests::move_button(const ButtonMove& wish) {
  if (wish.button < 1 || wish.button > VirtualHand::kButtons) {
    throw std::invalid_argument("button " + std::to_string(wish.button) +
                                " does not exist; choose a button from 1 to " +
                                std::to_string(VirtualHand::kButtons));
  }
  const std::lock_guard lock(mutex_);
  button_moves_.push_back(wish);
}

void SessionRequests::clear_fault() {
  const std::lock_guard lock(mutex_);
  clear_fault_ = true;
  stop_wanted_ = false;
}

void SessionRequests::confirm() {
  const std::lock_guard lock(mutex_);
  confirmed_ = true;
}

SessionRequests::Pending SessionRequests::pending() const {
  const std::lock_guard lock(mutex_);
  return {stop_, paused_, repeat_.has_value()};
}

void SessionRequests::attach(Rig& rig) {
  const std::lock_guard lock(mutex_);
  rig_ = &rig;
  if (stop_wanted_) rig_->emergency_stop();
}

void SessionRequests::detach() {
  const std::lock_guard lock(mutex_);
  rig_ = nullptr;
}

bool SessionRequests::is_paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

bool SessionRequests::take_stop(StopAfter what) {
  const std::lock_guard lock(mutex_);
  if (stop_ != what) return false;
  stop_.reset();
  return true;
}

std::optional<Phrase> SessionRequests::take_repeat() {
  const std::lock_guard lock(mutex_);
  return std::exchange(repeat_, std::nullopt);
}

std::optional<Phrase> SessionRequests::take_skip() {
  const std::lock_guard lock(mutex_);
  return std::exchange(skip_, std::nullopt);
}

std::optional<Phrase> SessionRequests::take_abort() {
  const std::lock_guard lock(mutex_);
  return std::exchange(abort_, std::nullopt);
}

bool SessionRequests::take_confirmation() {
  const std::lock_guard lock(mutex_);
  return std::exchange(confirmed_, false);
}

bool SessionRequests::take_clear_fault() {
  const std::lock_guard lock(mutex_);
  return std::exchange(clear_fault_, false);
}

std::vector<SessionRequests::ButtonMove> SessionRequests::take_button_moves() {
  const std::lock_guard lock(mutex_);
  return std::exchange(button_moves_, {});
}

bool SessionRequests::lift_fault(Fault seen) {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(clear_fault_, false)) return false;
  if (rig_ != nullptr) rig_->clear_fault(seen);
  return true;
}

std::vector<SessionRequests::Remark> SessionRequests::take_remarks() {
  const std::lock_guard lock(mutex_);
  return std::exchange(remarks_, {});
}

}  // namespace asperity
