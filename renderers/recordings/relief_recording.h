// Declares the recording of a texture that is computed from a relief.

#pragma once

#include <vector>

#include "renderers/recordings/texture_recording.h"
#include "stimuli/heights/height_field.h"

namespace asperity {

/// The strokes of a recording from a relief.
struct ReliefStrokes {
  std::vector<double> speeds_m_per_s{0.03, 0.06, 0.12};
  double normal_N = 1.0;
  double rate_Hz = 1000.0;
};

/// The recording of a point that slides without friction over a relief under a constant normal force N.
///
///   F_i = N·(h(x_{i+1}) − h(x_i))/d        against the motion, d = v/f the way of a sample [m]
///
/// Each speed v has three strokes along +x, over the whole width of the field at a quarter, half and three quarters of its
/// length. F is N times the slope, averaged over d, so that nothing above half the sampling rate f aliases much.
/// There is no mass and no damping: the speeds differ only in what their sampling resolves.
///
/// Errors: std::invalid_argument for a speed, force or rate that is not positive, and for a field that is too narrow
/// for 64 samples of a stroke.
TextureRecording recording_of_relief(const HeightField& field, const ReliefStrokes& strokes = {});

}  // namespace asperity
