// Implements the displacement under a loaded square.

#include "renderers/elastic/love_kernel.h"

#include <cmath>
#include <numbers>

namespace asperity {
namespace {

/// a·asinh(b/a), the integral of a·ln(b + √(a² + b²)) up to terms that cancel between corners; 0 for a = 0.
double corner(double a, double b) noexcept {
  return a == 0.0 ? 0.0 : a * std::asinh(b / std::abs(a));
}

}  // namespace

double love_displacement(double x, double y) noexcept {
  const double right = x + 0.5;
  const double left = x - 0.5;
  const double above = y + 0.5;
  const double below = y - 0.5;
  return (corner(right, above) - corner(right, below) + corner(above, right) - corner(above, left) +
          corner(left, below) - corner(left, above) + corner(below, left) - corner(below, right)) /
         std::numbers::pi;
}

}  // namespace asperity
