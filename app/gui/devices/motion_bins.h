// What a device does while it is measured, thinned for a picture.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/device_bench/device_test.h"
#include "renderers/servo/tick_record.h"

namespace asperity {

/// The extremes of a few ticks along x, y and z.
struct MotionBin {
  DeviceTestPart part = DeviceTestPart::timing;
  int stage = 0;  ///< counts the parts, and the axes of a part, from 1
  std::int64_t begins_ns = 0;
  std::array<double, 3> position_minimum_m{};
  std::array<double, 3> position_maximum_m{};
  std::array<double, 3> force_minimum_N{};  ///< as sent
  std::array<double, 3> force_maximum_N{};
};

/// Gathers ticks into bins, so that a picture shows the peaks of a fast motion and costs as much as a slow one.
class MotionBins final {
 public:
  static constexpr std::int64_t kBin_ns = 8'000'000;

  /// What comes now is another part, or another axis of one.
  void begin_stage(DeviceTestPart part) {
    part_ = part;
    ++stage_;
  }
  void add(std::span<const TickRecord> ticks) {
    for (const TickRecord& tick : ticks) add(tick);
  }
  /// The bins since the last call, without the one that is being filled.
  std::vector<MotionBin> take() {
    if (bins_.empty()) return {};
    std::vector<MotionBin> taken(bins_.begin(), bins_.end() - 1);
    bins_.erase(bins_.begin(), bins_.end() - 1);
    return taken;
  }

 private:
  /// Nobody looks at more than the last seconds.
  static constexpr std::size_t kMost = 4096;

  void add(const TickRecord& tick) {
    const std::int64_t time_ns = tick.probe.time_ns;
    const bool anew = bins_.empty() || bins_.back().stage != stage_ ||
                      time_ns < bins_.back().begins_ns ||
                      time_ns >= bins_.back().begins_ns + kBin_ns;
    if (anew && bins_.size() >= kMost) bins_.erase(bins_.begin(), bins_.begin() + kMost / 2);
    if (anew) bins_.push_back({.part = part_, .stage = stage_, .begins_ns = time_ns});
    MotionBin& bin = bins_.back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<int>(axis);
      const double position_m = tick.probe.position_m[at];
      const double force_N = tick.sent.force_N[at];
      if (anew || position_m < bin.position_minimum_m[axis])
        bin.position_minimum_m[axis] = position_m;
      if (anew || position_m > bin.position_maximum_m[axis])
        bin.position_maximum_m[axis] = position_m;
      if (anew || force_N < bin.force_minimum_N[axis]) bin.force_minimum_N[axis] = force_N;
      if (anew || force_N > bin.force_maximum_N[axis]) bin.force_maximum_N[axis] = force_N;
    }
  }

  std::vector<MotionBin> bins_{};
  DeviceTestPart part_ = DeviceTestPart::timing;
  int stage_ = 0;
};

}  // namespace asperity
