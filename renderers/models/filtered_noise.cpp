// Implements coloured noise along the path of the hand.

#include "renderers/models/filtered_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "analysis/words/phrased_error.h"
#include "renderers/force/layers.h"
#include "renderers/force/path_clock.h"
#include "renderers/force/recursive_noise.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

/// a₁ and a₂ of y_j = a₁·y_{j−1} + a₂·y_{j−2} + …
std::vector<double> recursion_of(const ParameterValues& parameters) {
  const double r = number_of(parameters, "pole_radius");
  const double peak_m = number_of(parameters, "peak_wavelength_m");
  const double length_m = number_of(parameters, "noise_length_m");
  if (peak_m <= 0.0) return {r};
  if (peak_m < 2.0 * length_m) {
    throw PhrasedRefusal(
        phrase("Models",
               "filtered_noise: peak_wavelength_m is %1; it must be at least twice "
               "noise_length_m, %2, or 0 for a low-pass")
            .with(number_text(peak_m), number_text(2.0 * length_m)));
  }
  return {2.0 * r * std::cos(2.0 * std::numbers::pi * length_m / peak_m), -r * r};
}

class FilteredNoise final : public ForceRenderer {
 public:
  explicit FilteredNoise(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        noise_N_({.coefficients = recursion_of(inputs.parameters),
                  .sd = number_of(inputs.parameters, "noise_sd_N"),
                  .steps_per_m =
                      inputs.patch.motion_scale / number_of(inputs.parameters, "noise_length_m")},
                 Random(inputs.seed).split("filtered_noise")),
        reference_N_(number_of(inputs.parameters, "reference_force_N")),
        rest_speed_m_per_s_(number_of(inputs.parameters, "friction_speed_m_per_s")),
        clock_(number_of(inputs.parameters, "device_step_m")) {}

  void reset(const ProbeState& first) noexcept override {
    contact_.reset();
    clock_.reset(first.position_m);
    noise_N_.reset();
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const double noise_N = noise_N_.advance(clock_.advance(probe.position_m));
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    const double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const glm::dvec3& v = probe.velocity_m_per_s;
    const double per_speed_N =
        noise_N * std::min(1.0, normal_N / reference_N_) /
        std::sqrt(v.x * v.x + v.y * v.y + rest_speed_m_per_s_ * rest_speed_m_per_s_);
    return contact_.force(point, probe,
                          {.texture_N = {per_speed_N * v.x, per_speed_N * v.y, normal_N},
                           .normal_N = normal_N,
                           .penetration_m = penetration_m},
                          dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  RecursiveNoise noise_N_;
  double reference_N_ = 0.0;
  double rest_speed_m_per_s_ = 0.0;
  PathClock clock_;
};

TextureBand band_of_path_noise(const RendererInputs& inputs) {
  return {.per_m =
              0.5 * inputs.patch.motion_scale / number_of(inputs.parameters, "noise_length_m")};
}

}  // namespace

ForceModel filtered_noise_model() {
  ModelDeclaration declaration{
      .id = "filtered_noise",
      .version = "1",
      .summary = phrase("Models", "A flat plate with filtered noise along the direction of motion"),
      .source = "Fritz, Barner (1996), Stochastic models for haptic texture",
      .needs_height_field = false,
      .amplitude_parameter = "noise_sd_N",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      number_parameter("noise_sd_N", "N", 0.0, 5.0, 0.05,
                       phrase("Models", "Standard deviation sigma of the filtered noise")),
      number_parameter("noise_length_m", "m", 5e-5, 0.01, 1e-4,
                       phrase("Models", "Length of path after which the noise takes a new value")),
      number_parameter("pole_radius", "1", 0.0, 0.999, 0.8,
                       phrase("Models", "Radius r of the poles of the filter; 0: white noise")),
      number_parameter("peak_wavelength_m", "m", 0.0, 0.1, 0.0,
                       phrase("Models",
                              "Wavelength of the resonance of two poles; 0: one pole, which gives "
                              "a low-pass filter")),
      number_parameter(
          "reference_force_N", "N", 0.01, 10.0, 0.5,
          phrase("Models", "Normal force below which the texture force decreases in proportion")),
      device_step_parameter()};
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<FilteredNoise>(inputs);
          },
          .suggested_by =
              [](const HeightField& field, const Material& material) {
                return ParameterValues{{"noise_sd_N", material.stiffness_N_per_m * field.rms_m()}};
              },
          .band = band_of_path_noise,
          .band_formula = "v/(2*noise_length_m)"};
}

}  // namespace asperity
