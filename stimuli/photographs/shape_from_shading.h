// Declares the recovery of a relief from its shading in light from one side.

#pragma once

#include <string>

#include "stimuli/pictures/grey_image.h"

namespace asperity {

/// The direction of a distant light source.
struct LightDirection {
  double azimuth_rad = 0.0;    ///< of the source, from +x (right) towards +y (up)
  double elevation_rad = 0.0;  ///< above the plane of the picture
};

/// The elevations for which shape from shading is permitted, in degrees.
///
/// For slopes s along the light and t across it, the brightness relative to level ground is, to second order,
///
///     r = 1 − s cot σ − ½ (s² + t²)      (σ: elevation)
///
/// The linear term determines the slope with its sign, the quadratic one does not. For slopes with a standard deviation of
/// m along each axis, the standard deviations of the two terms are m cot σ and m². They are equal for m = cot σ: 0.36, a
/// slope of 20°, at 70°. Above 70° the linear solution therefore fails for reliefs that are not nearly flat, and at 90°
/// there is no linear term. Below 10°, slopes steeper than 0.18 cast shadows, which none of the methods considers.
inline constexpr double kLowestLight_deg = 10.0;
inline constexpr double kHighestLight_deg = 70.0;

/// Throws std::invalid_argument, naming the angle, the reason and the remedy, for an elevation outside this range or an
/// azimuth that is not finite.
void check_light(double azimuth_deg, double elevation_deg, const std::string& method);

/// The linear solution [Pentland 1990] for a matt surface of one colour.
///
/// `relative_light` is r, the brightness divided by that of level ground. Result: heights in pixels, mean 0.
///
/// With the unit vector l towards the light in the plane, the linear term above gives the slope along the light,
/// l·∇h = (1 − r) tan σ. Its Fourier transform is i 2π (ν·l) ĥ, so that ĥ = ℱ[(1 − r) tan σ] / (i 2π ν·l). Waves whose
/// crests are parallel to the light (ν·l = 0) have no shading and cannot be recovered. The division is therefore
/// regularised as in a Wiener filter:
///
///     ĥ = −i (ν·l) / (2π ((ν·l)² + ε² |ν|²)) · ℱ[(1 − r) tan σ],    ε = 0.1
///
/// A wave at the angle φ from the light keeps cos²φ/(cos²φ + ε²) of its amplitude: 99 % along the light, 98 % at 45°, 75 %
/// at 80°, half at 84.3°, none at 90°.
GreyImage relief_by_pentland(const GreyImage& relative_light, const LightDirection& light);

inline constexpr double kPentlandRegularisation = 0.1;  // ε

/// The number of iterations of `relief_by_tsai_shah` at each size.
inline constexpr int kTsaiShahIterations = 100;

/// The linear approximation of the discrete reflectance [Tsai 1994] for a matt surface of one colour.
///
/// Argument and result: those of `relief_by_pentland`. With (p_s, q_s) = −cot σ (cos α, sin α), the relative brightness of
/// a matt surface with slopes p and q is R = (1 + p p_s + q q_s)/√(1 + p² + q²). The slopes are differences of
/// neighbouring pixels, p = ±(Z − Z_x), q = ±(Z − Z_y), so that each pixel has one equation, f(Z) = r − R = 0, which is
/// solved by Newton's method with the neighbours of the previous iteration:
///
///     Z ← Z − ½ f f_Z/(f_Z² + w²),    f_Z = −(±R_p ± R_q),    w = 0.1 (|p_s| + |q_s|)
///
/// Four details differ from the publication. The neighbours are those towards the light, so that the contributions of p
/// and q to f_Z have the same sign at level ground; with fixed neighbours, f_Z is 0 for light along one of the diagonals.
/// The regularisation w bounds the step where a slope faces the light. The factor ½ attenuates the errors that the full
/// step only moves: for small slopes and light along x, the error of a wave with ω radians per pixel is multiplied by
/// (1 + e^(−iω))/2 in each iteration, with the magnitude cos ω/2, in place of e^(−iω), with the magnitude 1. After n
/// iterations the magnitude is about exp(−n ω²/8): with n = 100, waves shorter than 14 pixels have errors below 10 %, and
/// waves longer than 50 pixels would be mostly missing. The iterations therefore begin with the result for the picture at
/// half the size, which is computed in the same way, down to 16 pixels a side.
///
/// Of the iterations at each size, the one with the least RMS of f is used.
GreyImage relief_by_tsai_shah(const GreyImage& relative_light, const LightDirection& light);

}  // namespace asperity
