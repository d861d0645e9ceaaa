// The surfaces of an attempt: their renderers, alone or side by side.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/numbers/random.h"
#include "app/session/layout.h"
#include "app/session/stimulus_builder.h"
#include "protocols/plan/plan.h"
#include "renderers/force/adjacent_patches.h"
#include "renderers/servo/servo_loop.h"

namespace asperity {

/// The renderer of surfaces side by side; `surfaces` have the patches of the trial, in the layout of the session.
///
/// Errors: as AdjacentPatches.
std::unique_ptr<AdjacentPatches> side_by_side(const Trial& trial, const Layout& layout,
                                              std::span<const AdjacentPatch> surfaces);

/// Prepares the stimulus of a planned presentation.
using PrepareStimulus = std::function<PreparedStimulus(const PlannedPresentation&)>;

/// Prepares the surfaces of an attempt, hands their presentations to the loop and takes them back. The id of a
/// presentation is the position of the surface; side by side all surfaces share one, kSideBySide.
///
/// Errors: the constructor throws those of `prepare` and of the force models.
class TrialSurfaces final {
 public:
  /// `random`: the stream of the attempt, for models that draw random numbers.
  TrialSurfaces(const Trial& trial, const Layout& layout, const PrepareStimulus& prepare,
                const Random& random);

  std::size_t size() const noexcept { return surfaces_.size(); }
  const PreparedStimulus& stimulus(std::size_t surface) const {
    return surfaces_.at(surface).stimulus;
  }
  std::uint64_t seed(std::size_t surface) const {
    return surfaces_.at(surface).stimulus.inputs.seed;
  }
  /// The inputs of the force on the surface while the probe is on it: without a border side by side.
  RendererInputs inputs_as_felt(std::size_t surface) const;
  /// Empty while the loop has the renderer.
  std::span<const NamedCount> limits(std::size_t surface) const;
  /// ForceRenderer::error; empty while the loop has the renderer.
  std::string_view error(std::size_t surface) const;

  std::uint64_t id_of(std::size_t surface) const noexcept {
    return is_shared_ ? kSideBySide : static_cast<std::uint64_t>(surface) + 1;
  }
  /// Gives away the presentation that contains the surface, for the loop.
  Presentation take(std::size_t surface);
  /// Takes a collected presentation back; one without a renderer is ignored.
  void put_back(Presentation presentation);
  bool has(std::size_t surface) const;

 private:
  struct Surface {
    PreparedStimulus stimulus{};
    Presentation presentation{};  ///< renderer null while the loop has it, and side by side
  };

  Presentation& presentation_of(std::size_t surface);
  /// Null while the loop has it.
  const ForceRenderer* renderer_of(std::size_t surface) const;

  bool is_shared_ = false;
  std::vector<Surface> surfaces_{};
  Presentation shared_{};
  const AdjacentPatches* patches_ = nullptr;  ///< the renderer of `shared_`
};

}  // namespace asperity
