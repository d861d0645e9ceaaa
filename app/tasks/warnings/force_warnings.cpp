// Presses the probe to increasing depths at several places, and takes the largest mean normal force.

#include "app/tasks/warnings/force_warnings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <set>

#include "analysis/numbers/number_text.h"
#include "device/probe_state.h"
#include "protocols/design/wording.h"

namespace asperity {

namespace {

constexpr std::size_t kPlaces = 16;
constexpr int kDepths = 200;
constexpr double kLeastDepth_m = 0.02;
constexpr double kReached = 0.99;  // within the differences between places of a texture
constexpr double kFar = 2.0;       // times what is reached: Nearness::far

/// The greatest mean normal force over the places, among all depths; or a lower bound of it that is at least `enough_N`: a surface
/// that is touched at rest pushes, so that further places only add to the sum.
double largest_normal_force_N(const PreparedStimulus& stimulus, const Protocol& protocol,
                              double enough_N) {
  const SurfacePatch& patch = stimulus.inputs.patch;
  const double deepest_m =
      std::max(kLeastDepth_m, protocol.force_limit_N / stimulus.inputs.material.stiffness_N_per_m);
  const double radius_m = 0.25 * std::min(patch.extent_m.x, patch.extent_m.y);
  std::vector<double> sums_N(kDepths, 0.0);
  const auto largest_N = [&sums_N] {
    return *std::max_element(sums_N.begin(), sums_N.end()) / static_cast<double>(kPlaces);
  };
  const std::unique_ptr<ForceRenderer> renderer = make_renderer(*stimulus.model, stimulus.inputs);
  for (std::size_t place = 0; place < kPlaces && largest_N() < enough_N; ++place) {
    const double angle_rad = 2.0 * std::numbers::pi * static_cast<double>(place) / kPlaces;
    ProbeState probe{};
    probe.position_m = patch.centre_m +
                       glm::dvec3(place == 0 ? 0.0 : radius_m * std::cos(angle_rad),
                                  place == 0 ? 0.0 : radius_m * std::sin(angle_rad), kLeastDepth_m);
    renderer->reset(probe);
    for (int i = 0; i < kDepths; ++i) {
      probe.time_ns = std::llround(1e9 * (i + 1) / protocol.rate_Hz);
      probe.position_m.z = patch.centre_m.z - deepest_m * (i + 1) / kDepths;
      sums_N[static_cast<std::size_t>(i)] +=
          renderer->tick(probe, 1.0 / protocol.rate_Hz).wrench.force_N.z;
    }
  }
  return largest_N();
}

}  // namespace

std::vector<Diagnostic> warnings_about_forces(const CheckedProtocol& checked,
                                              StimulusBuilder& builder,
                                              const StimuliCourse& course) {
  const Protocol& protocol = checked.protocol;
  std::vector<Diagnostic> warnings{};
  std::set<std::string> reported{};  // one texture stands for the others of a stimulus
  for_each_stimulus_near_limit(
      protocol, checked.trials(), course, [&](const ExploredStimulus& one) {
        const Band& band = one.exploration.normal_force_N;
        const std::optional<double> requested_N = band.target ? band.target : band.minimum;
        const StimulusDescription& stimulus = one.planned.stimulus;
        if (!requested_N || stimulus.surface || stimulus.tool || !builder.can_make(stimulus)) {
          return Nearness::far;
        }
        const std::string where = one.planned.stimulus_template + '\n' + one.exploration.name;
        if (reported.contains(where)) return Nearness::far;
        const double far_N = kFar * kReached * *requested_N;
        const double largest_N =
            largest_normal_force_N(builder.unmatched(stimulus), protocol, far_N);
        const Nearness nearness = largest_N >= far_N ? Nearness::far : Nearness::near;
        if (largest_N >= kReached * *requested_N) return nearness;
        reported.insert(where);
        warnings.push_back(checked.at_stimulus(
            one.planned.stimulus_template,
            phrase("Protocols",
                   "the stimulus %1 exerts at most %2 N at rest, but the exploration %3 requests "
                   "%4 N: the force would be constant and without texture; raise the stiffness or "
                   "the parameter that limits the depth, or request less force")
                .with(in_quotes(stimulus.name), fixed(largest_N, 2),
                      in_quotes(one.exploration.name), number_text(*requested_N))));
        return nearness;
      });
  return warnings;
}

}  // namespace asperity
