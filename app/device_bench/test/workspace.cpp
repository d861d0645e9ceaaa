// Records the corners of the workspace that the user reaches with the handle.

#include <algorithm>

#include <glm/common.hpp>

#include "analysis/numbers/number_text.h"
#include "app/device_bench/test/device_test_parts.h"
#include "app/words/device_remarks.h"

namespace asperity {
namespace {

constexpr const char* kWorkspace = "workspace_reached";

}  // namespace

void measure_workspace(DeviceTestRun& run) {
  if (!(run.options().workspace_s > 0.0)) {
    run.judge(kWorkspace, {}, phrase_of(DeviceRemark::nobody_moved_it));
    return;
  }
  run.announce(DeviceTestPart::workspace,
               "now move the handle along all borders of its workspace, for " +
                   fixed(run.options().workspace_s, 0) + " s",
               0.99);
  const StageRecord record = run.move({.duration_s = run.options().workspace_s});
  if (record.ticks.empty()) {
    run.judge(kWorkspace, {}, phrase_of(DeviceRemark::no_readings));
    return;
  }
  glm::dvec3 low_m = record.ticks.front().probe.position_m;
  glm::dvec3 high_m = low_m;
  for (const TickRecord& tick : record.ticks) {
    low_m = glm::min(low_m, tick.probe.position_m);
    high_m = glm::max(high_m, tick.probe.position_m);
  }
  run.profile().reached_minimum_m = low_m;
  run.profile().reached_maximum_m = high_m;
  const DeviceCapability& capability = run.device().capability();
  const glm::dvec3 share =
      (high_m - low_m) / (capability.workspace_maximum_m - capability.workspace_minimum_m);
  run.judge(kWorkspace, std::min({share.x, share.y, share.z}),
            phrase_of(DeviceRemark::share_reached), {share.x, share.y, share.z});
}

}  // namespace asperity
