// Declares the displacement of an elastic half-space under a uniformly loaded square.

#pragma once

namespace asperity {

/// The normal displacement of the surface at (x, y), in sides of the square, under a uniform pressure of E* on the square of
/// side 1 about the origin; times the side in metres it is in metres. For another pressure p it is multiplied by p/E*.
///
///   π·u = (x+½)·ln[((y+½) + r₊₊)/((y−½) + r₊₋)] + (y+½)·ln[((x+½) + r₊₊)/((x−½) + r₋₊)]
///       + (x−½)·ln[((y−½) + r₋₋)/((y+½) + r₋₊)] + (y−½)·ln[((x−½) + r₋₋)/((x+½) + r₊₋)]
///
/// with r_ab the distance to the corner (∓½, ∓½), here written with the signs of x ± ½ and y ± ½. It is the integral of the
/// displacement under a point load, u = F/(πE*r) [Love 1929; Johnson 1985, eq. 3.25]. Each logarithm is computed as
/// asinh(b/a), which is exact on the axes as well.
double love_displacement(double x, double y) noexcept;

}  // namespace asperity
