// Implements the rigid tip on an elastic foundation.

#include "renderers/models/winkler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "renderers/elastic/surface_dent.h"
#include "renderers/force/indentation_law.h"
#include "renderers/force/layers.h"
#include "renderers/models/tip_contact.h"

namespace asperity {
namespace {

class Winkler final : public ForceRenderer, public IndentationLaw, public DentsSurface {
 public:
  explicit Winkler(const RendererInputs& inputs)
      : tip_(inputs),
        shape_(tip_shape_of(inputs.parameters)),
        foundation_N_per_m3_(number_of(inputs.parameters, "foundation_N_per_m3")) {}

  void reset(const ProbeState& first) noexcept override {
    tip_.reset();
    touched_ = nullptr;
    at_m_ = glm::dvec2(first.position_m);
  }

  RenderedTick tick(const ProbeState& probe, double dt_s) noexcept override {
    const PressedTip::Overlap* const overlap = tip_.overlap(probe);
    touched_ = overlap != nullptr && overlap->deepest_m > 0.0 ? overlap : nullptr;
    at_m_ = glm::dvec2(probe.position_m);
    if (touched_ == nullptr) return tip_.no_contact();
    count();
    return tip_.force(probe, overlap->depth_m, foundation_N_per_m3_ * tip_.cell_m() * tip_.cell_m(),
                      nullptr, dt_s);
  }

  Friction* friction() noexcept override { return tip_.friction(); }
  TipOnCharts* tip() noexcept override { return &tip_; }
  std::span<const NamedCount> limits() const noexcept override { return limits_; }

  std::optional<SurfaceDent> dent() const override {
    if (touched_ == nullptr) return {};
    SurfaceDent dent{.centre_m = at_m_, .cell_m = tip_.cell_m(), .depth_m = touched_->depth_m};
    for (double& depth_m : dent.depth_m) depth_m = std::max(0.0, depth_m);
    return dent;
  }

  double indentation_stiffness_N_per_m(double force_N) const override {
    const double per_depth = std::numbers::pi * shape_.radius_m * foundation_N_per_m3_;
    return shape_.end == TipEnd::flat ? per_depth * shape_.radius_m
                                      : 2.0 * std::sqrt(per_depth * force_N);
  }
  std::optional<Phrase> indentation_problem(double) const override { return {}; }

 private:
  enum Limit : std::size_t { contact, cell_border };

  void count() noexcept {
    ++limits_[contact].ticks;
    for (std::size_t i = 0; i < kCells; ++i) {
      if (!is_at_border(i) || !(touched_->depth_m[i] > 0.0)) continue;
      ++limits_[cell_border].ticks;
      return;
    }
  }

  TipContact tip_;
  PressedTip::Shape shape_{};
  double foundation_N_per_m3_ = 0.0;
  const PressedTip::Overlap* touched_ = nullptr;  ///< of the last tick
  glm::dvec2 at_m_{0.0};
  std::array<NamedCount, 2> limits_{{{.name = "contact"}, {.name = "cell_border"}}};
};

}  // namespace

ForceModel winkler_model() {
  ModelDeclaration declaration{
      .id = "winkler",
      .version = "2",
      .summary = phrase("Models", "A rigid tip on a textured bed of springs"),
      .source = "Johnson (1985), Contact mechanics, section 4.3",
      .needs_height_field = true,
      .amplitude_parameter = "height_scale",
      .replay_tolerance_N = 1e-9,
      .parameters = {}};
  add_tip_parameters(declaration.parameters);
  declaration.parameters.push_back(number_parameter(
      "foundation_N_per_m3", "N/m3", 1e4, 1e11, 3e7,
      phrase("Models",
             "Pressure per depth; the default is as stiff under a flat end of 3 mm as "
             "elastic_halfspace with its defaults")));
  add_layer_parameters(declaration.parameters);
  return {.declaration = std::move(declaration),
          .make = [](const RendererInputs& inputs) -> std::unique_ptr<ForceRenderer> {
            return std::make_unique<Winkler>(inputs);
          },
          .suggested_by = {},
          .conservative_with = ParameterValues{},
          .band = band_of_tip,
          .band_formula = kBandOfTip};
}

}  // namespace asperity
