// Compares the steps of varied levels with the noise of the force on a device.

#include "app/session/rehearsal/level_rehearsal.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "protocols/design/json_pointer.h"
#include "protocols/plan/plan.h"

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

/// The stiffnesses of the surfaces of a block whose heights its levels are; empty where they are not heights.
std::vector<double> stiffnesses_of_varied_heights(const std::vector<Trial>& possible,
                                                  const Protocol::Block& block,
                                                  const ModelRegistry& models) {
  std::vector<double> stiffnesses{};
  if (!block.vary || block.vary->unit != "m") return stiffnesses;
  for (const Trial& trial : possible) {
    if (trial.block != block.name) continue;
    for (const PlannedPresentation& planned : trial.presentations) {
      if (planned.role != block.vary->role) continue;
      const ForceModel* const model = models.find(planned.stimulus.model);
      if (model == nullptr || model->declaration.amplitude_parameter != block.vary->parameter) {
        continue;
      }
      stiffnesses.push_back(planned.stimulus.material.stiffness_N_per_m);
    }
  }
  return stiffnesses;
}

}  // namespace

std::vector<RehearsalWarning> level_warnings(const Protocol& protocol, const DeviceProfile& profile,
                                             const ModelRegistry& models) {
  const double noise_m = std::max(profile.value("position_noise_m").value_or(0.0),
                                  profile.value("position_resolution_m").value_or(0.0));
  const std::vector<Trial> possible = possible_trials(protocol);
  std::vector<RehearsalWarning> warnings{};
  for (const auto& [name, block] : protocol.blocks) {
    const std::vector<double> stiffnesses = stiffnesses_of_varied_heights(possible, block, models);
    if (stiffnesses.empty()) continue;
    // Step and noise are proportional to the stiffness: their ratio is the same for all of them.
    const double stiffness_N_per_m = *std::min_element(stiffnesses.begin(), stiffnesses.end());
    const double noise_N = noise_m * stiffness_N_per_m;
    const std::optional<double> step_m = smallest_step(*block.vary);
    if (!step_m) continue;
    const double step_N = *step_m * stiffness_N_per_m;
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
