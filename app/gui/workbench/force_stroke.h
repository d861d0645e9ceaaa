// One stroke over a relief, felt through several force models at once.

#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/gui/workbench/mouse_hand.h"
#include "renderers/force/force_model.h"

namespace asperity {

/// What it is rendered from, and the renderer.
struct StrokedModel {
  std::string id{};
  RendererInputs inputs{};
  std::unique_ptr<ForceRenderer> renderer{};
};

/// The relief without end, so that no border is felt.
RendererInputs stroke_inputs(std::shared_ptr<const HeightField> field, const Material& material,
                             const ParameterValues& parameters);

/// A field as something that a tool can touch: a plate as large as it. Made when first asked for, which
/// takes seconds where the field is large; from any thread, and then shared.
class FieldPlate final {
 public:
  explicit FieldPlate(std::shared_ptr<const HeightField> field) : field_(std::move(field)) {}
  const std::shared_ptr<const HeightField>& field() const noexcept { return field_; }
  /// Errors: std::invalid_argument for a field of more samples than a plate has texels.
  std::shared_ptr<const TexturedMesh> mesh();

 private:
  std::shared_ptr<const HeightField> field_{};
  std::once_flag made_{};
  std::shared_ptr<const TexturedMesh> mesh_{};
};

/// What a model with two bodies needs besides: the plate, and a ball whose lowest point is the tip.
void add_bodies(RendererInputs& inputs, FieldPlate& plate, double ball_diameter_m);

/// Every model gets the same path, tick by tick, by the rule of the servo loop: the forces are those
/// that `along_path` gives for `path()`.
class ForceStroke final {
 public:
  /// Ends a stroke that is going on.
  void set_models(std::vector<StrokedModel> models, MouseHand hand);
  const std::vector<StrokedModel>& models() const noexcept { return models_; }

  void begin(const glm::dvec2& at_m);
  void aim(const glm::dvec2& at_m) { hand_.aim(at_m); }
  /// Renders what has passed since; time from the beginning of the stroke. Does nothing outside one.
  void advance(std::int64_t until_ns);
  void end() { going_on_ = false; }
  bool is_going_on() const noexcept { return going_on_; }

  /// Of the last stroke.
  const std::vector<ProbeState>& path() const noexcept { return path_; }
  /// By model, in newtons, one for each sample of the path.
  const std::vector<std::vector<glm::dvec3>>& forces_N() const noexcept { return forces_N_; }

 private:
  std::vector<StrokedModel> models_{};
  MouseHand hand_{0.0};
  bool going_on_ = false;
  std::vector<ProbeState> path_{};
  std::vector<std::vector<glm::dvec3>> forces_N_{};
};

}  // namespace asperity
