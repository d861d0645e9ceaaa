// Declares the wavelength of the finest perceptible detail of a texture, and the curvature of its crests.

#pragma once

#include <limits>

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The wavelength of the finest waves of a texture with displacements multiplied by `gain`, in metres: samples at a
/// distance of more than an eighth of it miss this detail.
///
/// Force depends on slope, so the relevant quantity is slope². Replacing the relief by chords of length s loses a
/// fraction L(s) of it. The loss of replacing two chords of length ℓ by one of 2ℓ is the square of half the difference
/// of their slopes,
///
///     (h(x + ℓ) − 2 h(x) + h(x − ℓ))² / (2ℓ)²,     h and ℓ in m,
///
/// in all directions |∇∇h|²·ℓ²/4, summed over ℓ = 1, 2, 4, … texels, and interpolated by s². The finest wave is 8 s for
/// the s at which L is 1 − sinc²(π/8), 5 %. This is the loss of chords of λ/8 on a grating of wavelength λ, for which
/// the result is therefore λ. For a mixture it is the wavelength at which this wave and all finer ones contain
/// approximately 5 % of slope²; finer waves with a smaller proportion do not count.
///
/// Lengths are measured on each face, along the shortest steps between its texels, even for slender faces. The mean of
/// the second differences over a face is the curvature of the shape, where a texture makes a faceted body round, and
/// does not count as a loss; nor does the rounding to steps of the atlas. An RMS slope of 0.5 % counts neither as a
/// loss nor, on a whole face, as relief. For waves longer than the width of a face most of the second difference is
/// curvature, so their wavelength is overestimated.
///
/// There is one value for the whole body: a texture that is fine at one end is treated as equally fine everywhere.
///
/// Infinity if there is no detail.
double finest_wave_m(const TexturedMesh& mesh, double gain);

/// The finest waves of a texture, and the curvature of crests that have these waves.
struct FineWaves {
  double finest_m = std::numeric_limits<double>::infinity();  ///< finest_wave_m
  /// √2·(2π/λ)·S with λ the finest wave and S the RMS slope of the faces with relief; 0 without detail. For a grating
  /// of amplitude A this is A·(2π/λ)², the curvature of its crests. For a mixture it is √2 times approximately the RMS
  /// second derivative, because λ is the wavelength at which slope² is lost as on a grating; the sharpest crests have two
  /// to three times this curvature.
  double crest_per_m = 0.0;
};

/// Both, in the time of one. `gain` as for finest_wave_m.
FineWaves fine_waves_of(const TexturedMesh& mesh, double gain);

}  // namespace asperity
