// Runs the parts of a test in their order; later parts use the results of earlier ones.

#include "app/device_bench/device_test.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "app/device_bench/test/device_test_parts.h"
#include "app/session/rig/clock.h"
#include "app/study_files/program.h"
#include "device/refusal.h"

namespace asperity {
namespace {

DeviceProfile measured_profile(HapticDevice& device, const DeviceTestOptions& options,
                               const std::stop_token& stop) {
  DeviceTestRun run(device, options, stop);
  measure_timing(run);
  check_safety(run);
  const Sweeps sweeps = measure_sweeps(run);
  const ByAxis mass_kg = measure_pushes(run, sweeps);
  measure_tones(run, sweeps);
  measure_springs(run, sweeps);
  measure_small_pushes(run, sweeps, mass_kg);
  measure_workspace(run);
  run.profile().force_N = run.has_motors() ? run.force_N() : 0.0;
  leave_out_unknown(run.profile());
  return std::move(run.profile());
}

}  // namespace

DeviceProfile test_device(HapticDevice& device, const DeviceTestOptions& options,
                          const std::stop_token& stop) {
  require_positive("rate_Hz", options.rate_Hz);
  require_positive("force_N", options.force_N);
  for (const auto& [name, limit] : options.limits) {
    const DeviceQuantity* const quantity = device_quantity(name);
    if (quantity == nullptr || !quantity->takes_limit) {
      std::string all{};
      for (const DeviceQuantity& one : device_quantities()) {
        if (!one.takes_limit) continue;
        all += (all.empty() ? "" : ", ") + std::string(one.name);
      }
      throw std::invalid_argument("no limit can be set for the item \"" + name +
                                  "\"; choose one of: " + all);
    }
  }
  DeviceProfile profile = measured_profile(device, options, stop);
  const DeviceCapability& capability = device.capability();
  const ProgramIdentity& program = this_program();
  profile.name = capability.name;
  profile.serial = capability.serial;
  profile.workspace_minimum_m = capability.workspace_minimum_m;
  profile.workspace_maximum_m = capability.workspace_maximum_m;
  profile.is_simulated = options.is_simulated;
  profile.measured_utc = SystemClock(0).utc();
  profile.program_version = program.version;
  profile.program_commit = program.commit;
  profile.rate_Hz = options.rate_Hz;
  return profile;
}

}  // namespace asperity
