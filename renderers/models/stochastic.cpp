// Implements noise at a rate that is independent of the servo's.

#include "renderers/models/stochastic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "analysis/random.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

class Stochastic final : public ForceRenderer {
 public:
  explicit Stochastic(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        noise_(Random(inputs.seed).split("stochastic")),
        mean_N_(number_of(inputs.parameters, "noise_mean_N")),
        sd_N_(number_of(inputs.parameters, "noise_sd_N")),
        rate_Hz_(number_of(inputs.parameters, "noise_rate_Hz")),
        threshold_m_per_s_(number_of(inputs.parameters, "velocity_threshold_m_per_s")) {}

  void reset(const ProbeState& first) noexcept override {
    first_ns_ = first.time_ns;
    step_ = 0;
    held_ = noise_.split(step_).normal();
  }

  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return {};
    double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const glm::dvec3& v = probe.velocity_m_per_s;
    if (std::sqrt(v.x * v.x + v.y * v.y) >= threshold_m_per_s_) {
      normal_N = std::max(0.0, normal_N + mean_N_ + sd_N_ * noise_at(probe.time_ns));
    }
    return contact_.force(
        point, probe,
        {.texture_N = {0.0, 0.0, normal_N}, .normal_N = normal_N, .penetration_m = penetration_m});
  }

 private:
  double noise_at(std::int64_t time_ns) noexcept {
    // Multiplication precedes division: the result is exact wherever a step begins on a whole nanosecond.
    const double steps = static_cast<double>(time_ns - first_ns_) * rate_Hz_ / 1e9;
    const auto step = static_cast<std::uint64_t>(std::max(0.0, std::floor(steps + 0.5)));
    if (step != step_) {
      step_ = step;
      held_ = noise_.split(step).normal();
    }
    return held_;
  }

  SurfaceContact contact_;
  Random noise_;
  double mean_N_ = 0.0;
  double sd_N_ = 0.0;
  double rate_Hz_ = 0.0;
  double threshold_m_per_s_ = 0.0;
  std::int64_t first_ns_ = 0;
  std::uint64_t step_ = 0;
  double held_ = 0.0;
};

}  // namespace

ForceModel stochastic_model() {
  ModelDeclaration declaration{
      .id = "stochastic",
      .version = "1",
      .summary = "A flat plate with white noise on its normal force while the hand moves",
      .source =
          "Siira, Pai (1996), Haptic texturing - a stochastic approach, as restated by Wu, "
          "Song, Zou (2009)",
      .needs_height_field = false,
      .amplitude_parameter = "noise_sd_N",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      {.name = "noise_sd_N",
       .kind = ParameterKind::number,
       .unit = "N",
       .minimum = 0.0,
       .maximum = 5.0,
       .choices = {},
       .default_value = 0.05,
       .meaning = "Standard deviation sigma of the noise"},
      {.name = "noise_mean_N",
       .kind = ParameterKind::number,
       .unit = "N",
       .minimum = -5.0,
       .maximum = 5.0,
       .choices = {},
       .default_value = 0.0,
       .meaning = "Mean of the noise; 0 for a texture whose mean height is removed"},
      {.name = "noise_rate_Hz",
       .kind = ParameterKind::number,
       .unit = "Hz",
       .minimum = 10.0,
       .maximum = 10000.0,
       .choices = {},
       .default_value = 1000.0,
       .meaning = "Rate at which the noise takes a new value, independent of the servo rate"},
      {.name = "velocity_threshold_m_per_s",
       .kind = ParameterKind::number,
       .unit = "m/s",
       .minimum = 0.0,
       .maximum = 0.1,
       .choices = {},
       .default_value = 0.005,
       .meaning = "Speed along the surface below which there is no noise"},
      friction_speed_parameter()};
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<Stochastic>(inputs);
          },
          .suggested_by =
              [](const HeightField& field, const Material& material) {
                return ParameterValues{{"noise_sd_N", material.stiffness_N_per_m * field.rms_m()},
                                       {"noise_mean_N", 0.0}};
              },
          .moves_by_itself_with = ParameterValues{{"velocity_threshold_m_per_s", 0.0}},
          .band =
              [](const RendererInputs& inputs) {
                return TextureBand{.time_Hz = 0.5 * number_of(inputs.parameters, "noise_rate_Hz")};
              },
          .band_formula = "noise_rate_Hz/2"};
}

}  // namespace asperity
