// Implements the lateral force of a slope.

#include "renderers/models/lateral_gradient.h"

#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

class LateralGradient final : public ForceRenderer {
 public:
  explicit LateralGradient(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        field_(inputs.height_field),
        per_slope_N_(-number_of(inputs.parameters, "gain_N") * inputs.patch.motion_scale) {}

  void reset(const ProbeState&) noexcept override {}

  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return {};
    const HeightSample h = field_->sample(point.x_m, point.y_m, contact_.patch().tiling);
    const double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    return contact_.force(
        point, probe,
        {.texture_N = {per_slope_N_ * h.slope_x, per_slope_N_ * h.slope_y, normal_N},
         .normal_N = normal_N,
         .penetration_m = penetration_m});
  }

 private:
  SurfaceContact contact_;
  std::shared_ptr<const HeightField> field_;
  double per_slope_N_ = 0.0;
};

}  // namespace

ForceModel lateral_gradient_model() {
  ModelDeclaration declaration{
      .id = "lateral_gradient",
      .version = "1",
      .summary = "A flat plate with a lateral force proportional to the slope of the texture",
      .source = "Minsky (1995), Computational haptics: the Sandpaper system, PhD thesis, MIT",
      .needs_height_field = true,
      .feels_applied_force = false,
      .amplitude_parameter = "gain_N",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {{.name = "gain_N",
                             .kind = ParameterKind::number,
                             .unit = "N",
                             .minimum = 0.0,
                             .maximum = 50.0,
                             .choices = {},
                             .default_value = 1.0,
                             .meaning = "Force K along the surface at a slope of 1"},
                            friction_speed_parameter()};
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<LateralGradient>(inputs);
          },
          .suggested_by = {},
          .conservative_with = ParameterValues{},
          .band = band_of_height_field,
          .band_formula = kBandOfHeightField};
}

}  // namespace asperity
