// Declares the drag that a law of friction gives a texture, compared with that of Coulomb.

#pragma once

#include "renderers/force/force_model.h"

namespace asperity {

/// Strokes to and fro along x through the patch's centre, at constant speed and at the height at which the plane alone would
/// give the normal force. There is no yielding hand or device.
struct SlidingStrokes {
  double speed_m_per_s = 0.060;
  double normal_force_N = 1.0;
  double length_m =
      0.040;  ///< or, if that is more, four times the path behind a reversal that is left out (SlidingDrag)
  int strokes = 12;  ///< the first two are dropped
  double rate_Hz = 1000.0;
};

/// The friction along the strokes. Its parts begin 2·μF̄_n/σ behind each reversal, where an adhesion of the stiffness σ has
/// turned round, with μF̄_n from Coulomb's drag and σ the stiffness of the law near rest (0 without one).
struct SlidingDrag {
  double mean_N = 0.0;
  double coulomb_N = 0.0;  ///< mean μ·F_n(t), from the drag of `rounded` at this speed
  double modulation =
      1.0;  ///< regression of the drag's variation on that of Coulomb, from three times this distance on;
            ///< 1 where Coulomb's does not vary
};

/// The drag of a stimulus with its law. Friction is the difference to the same stimulus without friction, against the
/// direction of motion; forces of the texture along the surface do not count. The border of the patch is removed and
/// its texture repeats, as in TextureForcePath.
///
/// Errors: as make_renderer; std::invalid_argument for strokes that are not positive or for a model whose friction does not have the laws of friction.h.
SlidingDrag sliding_drag(const ForceModel& model, const RendererInputs& inputs,
                         const SlidingStrokes& strokes = {});

}  // namespace asperity
