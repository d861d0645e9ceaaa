// A renderer whose tick does not return while a test wants it to hang.

#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <utility>

#include "renderers/force/force_renderer.h"

namespace asperity {

/// Shared with the test, because a tick that hangs can outlive what presented it.
struct Hang {
  std::atomic<bool> is_wanted{false};
  std::atomic<bool> is_under_way{false};

  void pass() noexcept {
    while (is_wanted) {
      is_under_way = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    is_under_way = false;
  }
};

/// Ends the hang where the test fails before it does so.
class HangEnds final {
 public:
  explicit HangEnds(std::shared_ptr<Hang> hang) : hang_(std::move(hang)) {}
  ~HangEnds() { hang_->is_wanted = false; }
  HangEnds(const HangEnds&) = delete;
  HangEnds& operator=(const HangEnds&) = delete;

 private:
  std::shared_ptr<Hang> hang_;
};

/// Pushes upwards whatever the probe does.
class HangingPush final : public ForceRenderer {
 public:
  static constexpr double kForce_N = 1.0;
  explicit HangingPush(std::shared_ptr<Hang> hang) : hang_(std::move(hang)) {}
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState&, double) noexcept override {
    hang_->pass();
    return {.wrench = {.force_N = {0.0, 0.0, kForce_N}}};
  }

 private:
  std::shared_ptr<Hang> hang_;
};

}  // namespace asperity
