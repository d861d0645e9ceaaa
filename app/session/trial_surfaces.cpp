// Makes one renderer per surface, or one for all where surfaces lie side by side.

#include "app/session/trial_surfaces.h"

#include <utility>

namespace asperity {

std::unique_ptr<AdjacentPatches> side_by_side(const Trial& trial, const Layout& layout,
                                              std::span<const AdjacentPatch> surfaces) {
  const SurfacePatch& workspace = trial.presentations.front().stimulus.patch;
  return std::make_unique<AdjacentPatches>(surfaces, layout.of(workspace), trial.flat, kBlend_m);
}

TrialSurfaces::TrialSurfaces(const Trial& trial, const Layout& layout,
                             const PrepareStimulus& prepare, const Random& random)
    : is_shared_(trial.arrangement.surfaces == Arrangement::Surfaces::side_by_side) {
  std::vector<AdjacentPatch> patches{};
  for (const PlannedPresentation& planned : trial.presentations) {
    const auto position = static_cast<std::uint64_t>(planned.position);
    Surface surface{};
    surface.stimulus = prepare(planned);
    RendererInputs& inputs = surface.stimulus.inputs;
    inputs.seed = random.split("renderer").split(position).bits();
    inputs.patch = layout.of(planned);
    const ForceModel& model = *surface.stimulus.model;
    if (is_shared_) {
      patches.push_back({&model, inputs});
    } else {
      surface.presentation = {position, make_renderer(model, inputs)};
    }
    surfaces_.push_back(std::move(surface));
  }
  if (!is_shared_) return;
  std::unique_ptr<AdjacentPatches> renderer = side_by_side(trial, layout, patches);
  patches_ = renderer.get();
  shared_ = {kSideBySide, std::move(renderer)};
}

RendererInputs TrialSurfaces::inputs_as_felt(std::size_t surface) const {
  const RendererInputs& inputs = surfaces_.at(surface).stimulus.inputs;
  return is_shared_ ? without_border(inputs) : inputs;
}

std::span<const NamedCount> TrialSurfaces::limits(std::size_t surface) const {
  const ForceRenderer* const renderer = renderer_of(surface);
  return renderer == nullptr ? std::span<const NamedCount>{} : renderer->limits();
}

std::string_view TrialSurfaces::error(std::size_t surface) const {
  const ForceRenderer* const renderer = renderer_of(surface);
  return renderer == nullptr ? std::string_view{} : renderer->error();
}

const ForceRenderer* TrialSurfaces::renderer_of(std::size_t surface) const {
  if (!has(surface)) return nullptr;
  return is_shared_ ? &patches_->renderer_of(surface)
                    : surfaces_.at(surface).presentation.renderer.get();
}

Presentation& TrialSurfaces::presentation_of(std::size_t surface) {
  return is_shared_ ? shared_ : surfaces_.at(surface).presentation;
}

Presentation TrialSurfaces::take(std::size_t surface) {
  Presentation& held = presentation_of(surface);
  return {held.id, std::move(held.renderer)};
}

void TrialSurfaces::put_back(Presentation presentation) {
  if (presentation.renderer == nullptr) return;
  presentation_of(is_shared_ ? 0 : static_cast<std::size_t>(presentation.id - 1)) =
      std::move(presentation);
}

bool TrialSurfaces::has(std::size_t surface) const {
  return (is_shared_ ? shared_ : surfaces_.at(surface).presentation).renderer != nullptr;
}

}  // namespace asperity
