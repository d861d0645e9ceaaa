// Compares the steps of varied levels with the noise of the force on a device.

#include "app/session/rehearsal/level_rehearsal.h"

#include <algorithm>
#include <optional>

#include "protocols/design/json_pointer.h"

namespace asperity {
namespace {

constexpr double kTimesNoise = 3.0;

std::string in_millinewton(double force_N) { return in_three_digits(1e3 * force_N); }
std::string in_micrometres(double height_m) { return in_three_digits(1e6 * height_m); }

/// The smallest distance of two values, the standard included.
std::optional<double> smallest_step(const Dimension& dimension) {
  std::vector<double> values = dimension.values();
  if (dimension.standard) values.push_back(*dimension.standard);
  std::sort(values.begin(), values.end());
  std::optional<double> smallest{};
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = values[i] - values[i - 1];
    if (step > 0.0 && (!smallest || step < *smallest)) smallest = step;
  }
  return smallest;
}

/// Whether the levels are heights of a surface.
bool varies_height(const Protocol& protocol, const Protocol::Block& block,
                   const ModelRegistry& models) {
  if (!block.vary || block.vary->unit != "m") return false;
  return std::any_of(
      block.presented.begin(), block.presented.end(), [&](const Protocol::Presented& presented) {
        const auto stimulus = protocol.stimuli.find(presented.stimulus);
        if (stimulus == protocol.stimuli.end() || !stimulus->second.model.value) return false;
        const ForceModel* const model = models.find(*stimulus->second.model.value);
        return model != nullptr && model->declaration.amplitude_parameter == block.vary->parameter;
      });
}

}  // namespace

std::vector<RehearsalWarning> level_warnings(const Protocol& protocol, const DeviceProfile& profile,
                                             const ModelRegistry& models) {
  const double noise_m = std::max(profile.value("position_noise_m").value_or(0.0),
                                  profile.value("position_resolution_m").value_or(0.0));
  const double noise_N = noise_m * protocol.material.stiffness_N_per_m;
  std::vector<RehearsalWarning> warnings{};
  for (const auto& [name, block] : protocol.blocks) {
    if (!varies_height(protocol, block, models)) continue;
    const std::optional<double> step_m = smallest_step(*block.vary);
    if (!step_m) continue;
    const double step_N = *step_m * protocol.material.stiffness_N_per_m;
    if (step_N >= kTimesNoise * noise_N) continue;
    warnings.push_back(
        {.id = "level_step",
         .pointer = pointer_to("/blocks", name) + "/vary",
         .asked = step_N,
         .device = noise_N,
         .text =
             phrase("Rehearsal",
                    "The smallest step of %1 in block %2 is %3 µm, which changes the force by %4 "
                    "mN, but the force noise of the device at this stiffness is %5 mN. Use "
                    "steps of at least %6 µm, or a device with less position noise.")
                 .with(block.vary->parameter, name, in_micrometres(*step_m), in_millinewton(step_N),
                       in_millinewton(noise_N), in_micrometres(kTimesNoise * noise_m))});
  }
  return warnings;
}

}  // namespace asperity
