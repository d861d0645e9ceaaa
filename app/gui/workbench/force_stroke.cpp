// Renders the relief, for some models as a plate, at 1 kHz along the path of the mouse hand.

#include "app/gui/workbench/force_stroke.h"

#include <algorithm>
#include <utility>

#include "renderers/servo/servo_time.h"
#include "stimuli/meshes/solid_body.h"

namespace asperity {

namespace {

constexpr double kStrokeRate_Hz = 1000.0;
constexpr double kPlateThickness_m = 0.02;  // more than the deepest hand
constexpr std::int64_t kLongestStroke_ns = 60'000'000'000;

}  // namespace

RendererInputs stroke_inputs(std::shared_ptr<const HeightField> field, const Material& material,
                             const ParameterValues& parameters) {
  RendererInputs inputs{};
  inputs.parameters = parameters;
  inputs.material = material;
  inputs.patch.extent_m = {1e3, 1e3};
  inputs.patch.edge_width_m = 1e-3;
  inputs.patch.tiling = Tiling::mirror;
  inputs.height_field = std::move(field);
  inputs.seed = 1;
  return inputs;
}

std::shared_ptr<const TexturedMesh> FieldPlate::mesh() {
  std::call_once(made_, [this] {
    mesh_ = std::make_shared<const TexturedMesh>(body_mesh(
        PlateShape{{field_->width_m(), field_->length_m(), kPlateThickness_m}}, field_.get()));
  });
  return mesh_;
}

void add_bodies(RendererInputs& inputs, FieldPlate& plate, double ball_diameter_m) {
  inputs.surface = plate.mesh();
  inputs.tool = std::make_shared<const TexturedMesh>(
      placed(body_mesh(SphereShape{.diameter_m = ball_diameter_m}, nullptr), BodyRole::tool));
}

void ForceStroke::set_models(std::vector<StrokedModel> models, MouseHand hand) {
  models_ = std::move(models);
  hand_ = std::move(hand);
  going_on_ = false;
  path_.clear();
  forces_N_.assign(models_.size(), {});
}

void ForceStroke::begin(const glm::dvec2& at_m) {
  hand_.begin(at_m);
  path_.clear();
  forces_N_.assign(models_.size(), {});
  going_on_ = true;
  advance(0);
}

void ForceStroke::advance(std::int64_t until_ns) {
  if (!going_on_) return;
  // A button that got stuck must not fill the memory.
  for (const ProbeState& probe : hand_.advance(std::min(until_ns, kLongestStroke_ns))) {
    const double dt_s = path_.empty()
                            ? 1.0 / kStrokeRate_Hz
                            : clamped_dt_s(path_.back().time_ns, probe.time_ns, kStrokeRate_Hz);
    for (std::size_t m = 0; m < models_.size(); ++m) {
      ForceRenderer& renderer = *models_[m].renderer;
      if (path_.empty()) renderer.reset(probe);
      forces_N_[m].push_back(renderer.tick(probe, dt_s).wrench.force_N);
    }
    path_.push_back(probe);
  }
}

}  // namespace asperity
