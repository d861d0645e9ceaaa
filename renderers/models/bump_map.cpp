// Implements the plate with a perturbed normal.

#include "renderers/models/bump_map.h"

#include <algorithm>
#include <cmath>

#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

class BumpMap final : public ForceRenderer {
 public:
  explicit BumpMap(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        field_(inputs.height_field),
        height_scale_(number_of(inputs.parameters, "height_scale")),
        depth_scale_(number_of(inputs.parameters, "depth_scale")),
        face_m_(choice_of(inputs.parameters, "face") == "crest"
                    ? height_scale_ * (field_->maximum_m() - field_->minimum_m())
                    : 0.0) {}

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const double depth_m = face_m_ - point.height_m;
    if (point.gain == 0.0 || !(depth_m > 0.0)) return contact_.no_contact();
    const HeightSample h = field_->sample(point.x_m, point.y_m, contact_.patch().tiling);
    const double raised_m =
        depth_scale_ * height_scale_ * std::max(0.0, h.height_m - field_->minimum_m());
    const double per_slope = height_scale_ * contact_.patch().motion_scale;
    const double slope_x = per_slope * h.slope_x;
    const double slope_y = per_slope * h.slope_y;
    // Of the depth, the part that is felt along the perturbed normal; the rest is along that of the plate.
    const double along_bump_m = std::min(depth_m, raised_m);
    const double upright_m = along_bump_m / std::sqrt(1.0 + slope_x * slope_x + slope_y * slope_y);
    const double k = contact_.material().stiffness_N_per_m;
    const glm::dvec3 force_N{-k * upright_m * slope_x, -k * upright_m * slope_y,
                             k * (depth_m - along_bump_m + upright_m)};
    return contact_.force(point, probe,
                          {.texture_N = force_N, .normal_N = force_N.z, .penetration_m = depth_m},
                          dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  std::shared_ptr<const HeightField> field_;
  double height_scale_ = 1.0;
  double depth_scale_ = 1.0;
  double face_m_ = 0.0;
};

}  // namespace

ForceModel bump_map_model() {
  ModelDeclaration declaration{
      .id = "bump_map",
      .version = "1",
      .summary =
          phrase("Models", "A flat plate whose normal is perturbed by the slope of the texture"),
      .source =
          "Ho, Basdogan, Srinivasan (1999), Efficient point-based rendering techniques for haptic "
          "display of virtual objects, Presence 8(5)",
      .needs_height_field = true,
      .amplitude_parameter = "height_scale",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      number_parameter("height_scale", "1", 0.0, 100.0, 1.0,
                       phrase("Models", "Factor applied to the heights of the field")),
      number_parameter(
          "depth_scale", "1", 0.0, 1.0, 1.0,
          phrase("Models",
                 "Depth K down to which the force is along the perturbed normal, as a multiple of "
                 "the height of the texture above its lowest point")),
      choice_parameter(
          "face", {"mean", "crest"},
          phrase("Models",
                 "mean: contact begins at the plane; crest: contact begins above the plane, by "
                 "the height of the texture from its lowest to its highest point"))};
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<BumpMap>(inputs);
          },
          .suggested_by = {},
          .band = band_of_height_field,
          .band_formula = kBandOfHeightField};
}

}  // namespace asperity
