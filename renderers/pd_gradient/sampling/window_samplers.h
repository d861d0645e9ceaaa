// Declares the samplers for windows of all possible widths, which are made before the first tick.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/loops/instruction_set.h"
#include "renderers/pd_gradient/sampling/cached_penetration.h"
#include "renderers/pd_gradient/sampling/penetration.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// Whether heights are kept for the following ticks or resampled in each.
enum class Heights { kept, sampled };

/// The resolution of the sampling, for contacts of all widths.
struct WindowSampling {
  MaximumLaw law{};
  double cell_m = 1e-4;
  int most_samples = 256;  ///< of a window, in each direction
  Heights heights = Heights::kept;
  /// Hard maximum: how often the cells of a window may be halved where many crests touch (TexturedContacts), until they
  /// are no longer than `fine_enough_m`.
  int most_halvings = 0;
  double fine_enough_m = 0.0;

  bool operator==(const WindowSampling&) const = default;
};

/// The conflict among the values of a sampling, by the names of its fields: a step that is not 1, 2, 4 or 8 cells, or
/// fewer samples than one window needs with this step; nullopt if there is none. Errors: std::invalid_argument for a
/// cell, step or τ that is not positive.
std::optional<ParameterConflict> conflict_in(const WindowSampling& sampling);

/// Stores a sampler with the declared cell and step for every width.
///
/// Cell and step are constant lengths. With the width of a contact the number of samples N grows, in multiples of 32
/// times the step in cells (of 32 for the smooth maximum), and the window is N cells wide: as wide as the contact or up
/// to 32 steps wider. A window of more than `most_samples` gets cells of twice, four times, … the length, and, once a
/// cell is longer than the step, a step of one cell. The tangential force of fine detail is then too small, and
/// `Window::is_coarse` is set.
///
/// Accuracy of the grid: with a cell and a step of λ/8, 64 samples over 8 wavelengths λ, the error is 11 % along u and
/// v, 4.5 % in tilts and 12 % about n (bench/penetration_depth --accuracy), and 90 % of a grating's tangential force is
/// kept. With λ/12 it is 95 %.
///
/// Errors: std::invalid_argument for a cell or step that is not positive, and for conflicts that `conflict_in` finds.
///
/// Heights are kept for ten simultaneous contacts in a window of up to 128 samples, for fewer in wider ones, and for
/// two in a coarse one; those of further contacts are resampled in every tick.
///
/// Real-time: `evaluate` and `reset` do not allocate, lock or throw.
class WindowSamplers final {
 public:
  struct Window {
    CachedPenetration sampler;
    MaximumLaw law{};  ///< with the step of this window
    /// Its step (its cell, for the smooth maximum) is not the declared one.
    bool is_coarse = false;
    /// The same window and step with cells of half, a quarter and an eighth of the length: as many as
    /// `most_halvings`, `fine_enough_m` and `most_samples` permit, with a step of at most 8 cells.
    std::vector<CachedPenetration> finer{};

    /// The sampler with cells that are halved so often.
    CachedPenetration& with(int halvings) noexcept {
      return halvings == 0 ? sampler : finer[static_cast<std::size_t>(halvings - 1)];
    }
  };

  /// Makes samplers up to `widest_m`, with up to `most_triangles` triangles in a window.
  WindowSamplers(const WindowSampling& sampling, double widest_m, std::size_t most_triangles,
                 InstructionSet instructions);

  /// The narrowest window that is at least this wide; the widest window for greater widths.
  Window& window_for(double width_m) noexcept;

  /// Clears all heights.
  void reset() noexcept;

  /// Of all samplers; nearly all of it for kept heights.
  std::size_t bytes() const noexcept;

 private:
  std::vector<Window> windows_{};
};

}  // namespace asperity
