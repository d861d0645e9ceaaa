// How fine the detail of a texture is, where it can be felt.

#pragma once

#include "stimuli/meshes/textured_mesh.h"

namespace asperity {

/// The finest waves of a texture whose displacements are `gain` times as large, in metres: the detail
/// that samples further apart than an eighth of it pass over.
///
/// Force follows slope, so what counts is slope². Replacing the relief by chords of length s loses a
/// share L(s) of it: where two chords of length ℓ become one of 2ℓ, half the difference of their slopes,
/// squared, which is
///
///     (h(x + ℓ) − 2 h(x) + h(x − ℓ))² / (2ℓ)²,     h and ℓ in m,
///
/// in all directions |∇∇h|²·ℓ²/4, summed over ℓ = 1, 2, 4, … texels, by s² in between. The finest wave is
/// 8 s where L is 1 − sinc²(π/8), 5 %: what chords of λ/8 lose of a grating of wavelength λ, so it is λ
/// then. Of a mixture it is the length of waves that together with all finer ones hold some 5 % of
/// slope²; finer ones of less share do not count.
///
/// Lengths are true ones on every face, along the shortest ways between its texels, however slender it
/// is. Over each face the mean of the second differences is the bend of the shape, where a texture makes
/// a faceted body round, and no loss; neither is what rounding to steps of the atlas adds. An RMS slope of
/// 0.5 % counts neither as a loss nor, on a whole face, as relief. Of waves that are longer than a face is wide the bend is most, so they are told too long.
///
/// One value for the whole body: a texture that is fine at one end is told to be as fine everywhere.
///
/// Infinite where there is no detail.
double finest_wave_m(const TexturedMesh& mesh, double gain);

}  // namespace asperity
