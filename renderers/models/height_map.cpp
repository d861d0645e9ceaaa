// Implements the two laws of the height map.

#include "renderers/models/height_map.h"

#include <algorithm>

#include "renderers/force/layers.h"
#include "renderers/force/surface_contact.h"

namespace asperity {
namespace {

class CorrectedHeightMap final : public ForceRenderer {
 public:
  explicit CorrectedHeightMap(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        field_(inputs.height_field),
        height_scale_(number_of(inputs.parameters, "height_scale")),
        depth_limit_m_(number_of(inputs.parameters, "depth_limit_m")),
        lateral_gain_(number_of(inputs.parameters, "lateral_gradient_gain")) {}

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    if (point.gain == 0.0) return contact_.no_contact();
    const HeightSample d = field_->sample(point.x_m, point.y_m, contact_.patch().tiling);
    const double penetration_m = height_scale_ * d.height_m - point.height_m;
    if (!(penetration_m > 0.0)) return contact_.no_contact();
    const double normal_N =
        contact_.material().stiffness_N_per_m * std::min(penetration_m, depth_limit_m_);
    const double per_slope_N =
        -lateral_gain_ * normal_N * height_scale_ * contact_.patch().motion_scale;
    return contact_.force(
        point, probe,
        {.texture_N = {per_slope_N * d.slope_x, per_slope_N * d.slope_y, normal_N},
         .normal_N = normal_N,
         .penetration_m = penetration_m},
        dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  std::shared_ptr<const HeightField> field_;
  double height_scale_ = 1.0;
  double depth_limit_m_ = 0.0;
  double lateral_gain_ = 0.0;
};

class LiteralHeightMap final : public ForceRenderer {
 public:
  explicit LiteralHeightMap(const RendererInputs& inputs)
      : contact_(inputs.patch, inputs.material, inputs.parameters),
        field_(inputs.height_field),
        texture_N_per_m_(inputs.material.stiffness_N_per_m *
                         number_of(inputs.parameters, "height_scale")),
        k1_N_per_m_(number_of(inputs.parameters, "k1_N_per_m")),
        depth_limit_m_(number_of(inputs.parameters, "depth_limit_m")),
        offset_m_(choice_of(inputs.parameters, "offset") == "subtract_min"
                      ? inputs.height_field->minimum_m()
                      : 0.0) {}

  void reset(const ProbeState&) noexcept override { contact_.reset(); }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PatchPoint point = contact_.locate(probe.position_m);
    const double penetration_m = -point.height_m;
    if (point.gain == 0.0 || !(penetration_m > 0.0)) return contact_.no_contact();
    double force_N = k1_N_per_m_ * std::min(penetration_m, depth_limit_m_);
    if (penetration_m <= depth_limit_m_) {
      const HeightSample d = field_->sample(point.x_m, point.y_m, contact_.patch().tiling);
      force_N += texture_N_per_m_ * (d.height_m - offset_m_);
    }
    // Without a normal force there is no friction: the equations contain none.
    return contact_.force(point, probe,
                          {.texture_N = {0.0, 0.0, force_N}, .penetration_m = penetration_m}, dt_s);
  }

  Friction* friction() noexcept override { return &contact_.friction(); }

 private:
  SurfaceContact contact_;
  std::shared_ptr<const HeightField> field_;
  double texture_N_per_m_ = 0.0;
  double k1_N_per_m_ = 0.0;
  double depth_limit_m_ = 0.0;
  double offset_m_ = 0.0;
};

}  // namespace

ForceModel height_map_model() {
  ModelDeclaration declaration{
      .id = "height_map",
      .version = "1",
      .summary = phrase("Models", "The height map of a photograph, felt through a spring"),
      .source =
          "Wu, Song, Zou (2009), A novel haptic texture display based on image processing, "
          "doi:10.5772/7051",
      .needs_height_field = true,
      .amplitude_parameter = "height_scale",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  declaration.parameters = {
      choice_parameter(
          "law", {"corrected", "literal"},
          phrase("Models",
                 "corrected: the height enters the penetration; literal: equations 1 to 3 of the "
                 "source as printed")),
      number_parameter("height_scale", "1", 0.0, 100.0, 1.0,
                       phrase("Models", "Factor applied to the heights of the field")),
      number_parameter("depth_limit_m", "m", 1e-5, 0.05, 0.003,
                       phrase("Models", "Depth H beyond which the normal force is constant")),
      number_parameter(
          "lateral_gradient_gain", "1", 0.0, 10.0, 0.0,
          phrase("Models",
                 "Force along the surface, -gain times normal force times slope; 1 makes the "
                 "force conservative; corrected law only")),
      choice_parameter(
          "offset", {"none", "subtract_min"},
          phrase("Models",
                 "Literal law only. none: equation 1, which attracts the probe over valleys; "
                 "subtract_min: heights relative to the lowest sample")),
      number_parameter(
          "k1_N_per_m", "N/m", 0.0, 5000.0, 500.0,
          phrase("Models", "Literal law only: k1 of equation 2, the stiffness of the plate"))};
  add_layer_parameters(declaration.parameters);
  const auto make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
    if (choice_of(inputs.parameters, "law") == "literal") {
      return std::make_unique<LiteralHeightMap>(inputs);
    }
    return std::make_unique<CorrectedHeightMap>(inputs);
  };
  return {.declaration = std::move(declaration),
          .make = make,
          .suggested_by = {},
          .conservative_with =
              ParameterValues{{"law", std::string("corrected")}, {"lateral_gradient_gain", 1.0}},
          .band = band_of_height_field,
          .band_formula = kBandOfHeightField};
}

}  // namespace asperity
