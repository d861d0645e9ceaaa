// Implements the grating and its three directions of force.

#include "renderers/models/sinusoid.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "analysis/signals/spectrum.h"
#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

class Sinusoid final : public ForceRenderer {
 public:
  explicit Sinusoid(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        amplitude_m_(number_of(inputs.parameters, "amplitude_m")),
        wave_number_rad_per_m_(2.0 * std::numbers::pi /
                               number_of(inputs.parameters, "wavelength_m")),
        along_x_(std::cos(number_of(inputs.parameters, "direction_rad"))),
        along_y_(std::sin(number_of(inputs.parameters, "direction_rad"))),
        local_normal_(choice_of(inputs.parameters, "force_direction") == "local_normal"),
        gradient_(choice_of(inputs.parameters, "force_direction") == "gradient") {}

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    if (point.gain == 0.0 || point.height_m >= 2.0 * amplitude_m_)
      return contact_.no_contact();  // above the crests
    const double phase_rad = wave_number_rad_per_m_ * (along_x_ * point.x_m + along_y_ * point.y_m);
    const double penetration_m = amplitude_m_ * std::sin(phase_rad) + amplitude_m_ - point.height_m;
    if (!(penetration_m > 0.0)) return contact_.no_contact();
    const double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    glm::dvec3 force_N{0.0, 0.0, normal_N};
    if (local_normal_ || gradient_) {
      const double slope = amplitude_m_ * wave_number_rad_per_m_ * std::cos(phase_rad) *
                           contact_.patch().motion_scale;
      const double per_slope_N = gradient_ ? normal_N : normal_N / std::sqrt(1.0 + slope * slope);
      force_N = per_slope_N * glm::dvec3{-slope * along_x_, -slope * along_y_, 1.0};
    }
    return contact_.force(
        point, probe, {.texture_N = force_N, .normal_N = force_N.z, .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  double amplitude_m_ = 0.0;
  double wave_number_rad_per_m_ = 0.0;
  double along_x_ = 1.0;
  double along_y_ = 0.0;
  bool local_normal_ = false;
  bool gradient_ = false;
};

}  // namespace

ForceModel sinusoid_model() {
  ModelDeclaration declaration{
      .id = "sinusoid",
      .version = "2",
      .summary = phrase("Models", "A sinusoidal grating, felt through a spring"),
      .source =
          "Wu, Song, Zou (2009), equation 4; after Choi, Tan (2004), Perceived instability "
          "of virtual haptic texture",
      .needs_height_field = false,
      .amplitude_parameter = "amplitude_m",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      number_parameter("amplitude_m", "m", 0.0, 0.005, 0.0001,
                       phrase("Models", "Amplitude A: half the height from trough to crest")),
      number_parameter("wavelength_m", "m", 1e-5, 0.1, 0.002, phrase("Models", "Wavelength L")),
      number_parameter(
          "direction_rad", "rad", -std::numbers::pi, std::numbers::pi, 0.0,
          phrase("Models", "Direction in which the height varies, from +x towards +y")),
      choice_parameter(
          "force_direction", {"fixed", "local_normal", "gradient"},
          phrase(
              "Models",
              "fixed: along the normal of the plane, as in the source; local_normal: along that of "
              "the grating; gradient: the negative gradient of the energy of the spring"))};
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<Sinusoid>(inputs);
          },
          .suggested_by =
              [](const HeightField& field, const Material&) {
                ParameterValues suggested{{"amplitude_m", std::numbers::sqrt2 * field.rms_m()}};
                const std::optional<double> wavelength_m =
                    dominant_wavelength_m({.heights_m = field.heights_m(),
                                           .rows = field.grid().rows,
                                           .columns = field.grid().columns,
                                           .pitch_m = field.grid().pitch_m});
                if (wavelength_m) suggested["wavelength_m"] = *wavelength_m;
                return suggested;
              },
          .conservative_with = ParameterValues{{"force_direction", std::string("gradient")}},
          .band =
              [](const RendererInputs& inputs) {
                return TextureBand{.per_m = inputs.patch.motion_scale /
                                            number_of(inputs.parameters, "wavelength_m")};
              },
          .crest_phase =
              [](const RendererInputs& inputs, const glm::dvec3& position_m) {
                const glm::dvec2 point_m = on_texture(inputs.patch, position_m);
                const double direction_rad = number_of(inputs.parameters, "direction_rad");
                const double along_m =
                    point_m.x * std::cos(direction_rad) + point_m.y * std::sin(direction_rad);
                // sin has its crest a quarter of a cycle after 0.
                const double cycles = along_m / number_of(inputs.parameters, "wavelength_m") - 0.25;
                return cycles - std::round(cycles);
              },
          .band_formula = "v/wavelength_m"};
}

}  // namespace asperity
