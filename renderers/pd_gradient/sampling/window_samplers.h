// The samplers for windows of every width that a contact may have, made before the first tick.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "renderers/pd_gradient/loops/instruction_set.h"
#include "renderers/pd_gradient/sampling/cached_penetration.h"
#include "renderers/pd_gradient/sampling/penetration.h"
#include "stimuli/properties/parameter.h"

namespace asperity {

/// Whether heights stay for the next ticks, or are sampled anew in each.
enum class Heights { kept, sampled };

/// How finely a contact is sampled, whatever its width.
struct WindowSampling {
  MaximumLaw law{};
  double cell_m = 1e-4;
  int most_samples = 256;  ///< of a window, each way
  Heights heights = Heights::kept;
};

/// What of a sampling cannot be together, by the names of its fields: a step that is not 1, 2, 4 or 8
/// cells, or fewer samples than one window takes with it. Errors: std::invalid_argument for a cell,
/// step or τ that is not positive.
std::optional<ParameterConflict> conflict_in(const WindowSampling& sampling);

/// A window of the declared cell and step for every width.
///
/// Cell and step are lengths and stay what they are; what grows with a contact is the number of
/// samples N, in multiples of 32 times the step in cells (of 32 for the smooth maximum), and the
/// window is N cells wide: as wide as the contact or up to 32 steps wider. A window of more than
/// `most_samples` gets cells of twice, four times, … the length, and, once a cell is longer than the
/// step, a step of one cell: the tangential force of fine detail is then too small, and
/// `Window::is_coarse` says so.
///
/// On the grid: a cell and a step of λ/8, 64 samples over 8 wavelengths λ, is off by 11 % along u and v,
/// 4.5 % in tilts and 12 % about n (bench/penetration_depth --accuracy) and keeps 90 % of a grating's
/// tangential force. With λ/12 it keeps 95 %.
///
/// Errors: std::invalid_argument for a cell or step that is not positive, and for what
/// `conflict_in` finds.
///
/// Heights are kept for ten contacts at a time in a window of up to 128 samples, for fewer in wider
/// ones, and for two in a coarse one; more are sampled anew in every tick.
///
/// Real-time: `evaluate` and `reset` do not allocate, lock or throw.
class WindowSamplers final {
 public:
  struct Window {
    CachedPenetration sampler;
    /// Its step (its cell, for the smooth maximum) is not the declared one.
    bool is_coarse = false;
  };

  /// Up to `widest_m`, with as many triangles as `most_triangles` in a window.
  WindowSamplers(const WindowSampling& sampling, double widest_m, std::size_t most_triangles,
                 InstructionSet instructions);

  /// The narrowest window that holds that width; the widest for all wider ones.
  Window& window_for(double width_m) noexcept;

  /// Forgets all heights.
  void reset() noexcept;

 private:
  std::vector<Window> windows_{};
};

}  // namespace asperity
