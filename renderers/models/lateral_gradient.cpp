// Implements the lateral force of a slope.

#include "renderers/models/lateral_gradient.h"

#include "renderers/force/contact_fade.h"
#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

constexpr double kUnit_N = 1.0;  // the normal force at which both laws are equal

class LateralGradient final : public ForceRenderer {
 public:
  explicit LateralGradient(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        field_(inputs.height_field),
        per_slope_N_(-number_of(inputs.parameters, "gain_N") * inputs.patch.motion_scale),
        by_force_(choice_of(inputs.parameters, "law") == "force") {}

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    const HeightSample h = field_->sample(point.x_m, point.y_m, contact_.patch().tiling);
    const double normal_N = contact_.material().stiffness_N_per_m * penetration_m;
    const double per_slope_N =
        per_slope_N_ * (by_force_ ? normal_N / kUnit_N : contact_fade(penetration_m));
    return contact_.force(
        point, probe,
        {.texture_N = {per_slope_N * h.slope_x, per_slope_N * h.slope_y, normal_N},
         .normal_N = normal_N,
         .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  std::shared_ptr<const HeightField> field_;
  double per_slope_N_ = 0.0;
  bool by_force_ = false;
};

}  // namespace

ForceModel lateral_gradient_model() {
  ModelDeclaration declaration{
      .id = "lateral_gradient",
      .version = "2",
      .summary = phrase(
          "Models", "A flat plate with a lateral force proportional to the slope of the texture"),
      .source = "Minsky (1995), Computational haptics: the Sandpaper system, PhD thesis, MIT",
      .needs_height_field = true,
      .feels_applied_force = false,
      .amplitude_parameter = "gain_N",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      number_parameter("gain_N", "N", 0.0, 50.0, 1.0,
                       phrase("Models",
                              "Force K along the surface at a slope of 1; with the law "
                              "force, at a normal force of 1 N")),
      choice_parameter("law", {"constant", "force"},
                       phrase("Models",
                              "constant: the force along the surface does not depend on "
                              "how hard the hand presses, as in the source; force: it is "
                              "proportional to the normal force"))};
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<LateralGradient>(inputs);
          },
          .suggested_by = {},
          .conservative_with = ParameterValues{{"law", std::string("constant")}},
          .feels_applied_force_with = ParameterValues{{"law", std::string("force")}},
          .band = band_of_height_field,
          .band_formula = kBandOfHeightField};
}

}  // namespace asperity
