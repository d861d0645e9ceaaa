// What the makers of synthetic surfaces share: canvas, parameters and round elements.

#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "analysis/numbers/random.h"
#include "stimuli/heights/surface_declaration.h"

namespace asperity {

/// Heights in metres before they become a HeightField, row by row, the top row first.
using Heights = std::vector<float>;

struct SurfaceMaker {
  SurfaceDeclaration declaration{};
  /// `values` are complete, and the canvas has been checked.
  Heights (*make)(const ParameterValues& values, const SurfaceCanvas& canvas) = nullptr;
};

std::vector<SurfaceMaker> pattern_makers();
std::vector<SurfaceMaker> material_makers();

/// A parameter with a length in metres.
Parameter length_parameter(std::string_view name, double minimum_m, double maximum_m,
                           double default_m, const Phrase& meaning);
Parameter plain_parameter(std::string_view name, double minimum, double maximum,
                          double default_value, const Phrase& meaning);

double pitch_of(const SurfaceCanvas& canvas) noexcept;

/// Refuses a length of fewer than two pixels, with the name of its parameter.
void require_resolved(const ParameterValues& values, std::string_view name,
                      const SurfaceCanvas& canvas);

/// The position of pixel (row, column), with the origin at the centre of the canvas and y upwards.
struct SurfacePoint {
  double x_m = 0.0;
  double y_m = 0.0;
};
SurfacePoint point_of(const SurfaceCanvas& canvas, std::size_t row, std::size_t column) noexcept;

/// A rotationally symmetric element of a surface, whose height above the ground depends on the distance from its axis.
struct RoundElement {
  SurfacePoint at{};
  double radius_m = 0.0;  ///< at its base
  double height_m = 0.0;
};

/// Raises the heights to those of the element where it is higher, continued periodically across the borders.
/// `profile` maps distance/radius in [0, 1] to a fraction of the height.
template <class Profile>
void raise(Heights& heights_m, const SurfaceCanvas& canvas, const RoundElement& element,
           const Profile& profile) {
  const double pitch_m = pitch_of(canvas);
  const auto pixels = static_cast<std::ptrdiff_t>(canvas.pixels);
  const double middle = 0.5 * static_cast<double>(pixels - 1);
  const double column = element.at.x_m / pitch_m + middle;
  const double row = middle - element.at.y_m / pitch_m;
  const double reach = element.radius_m / pitch_m;
  for (auto i = static_cast<std::ptrdiff_t>(std::ceil(row - reach));
       static_cast<double>(i) <= row + reach; ++i) {
    for (auto j = static_cast<std::ptrdiff_t>(std::ceil(column - reach));
         static_cast<double>(j) <= column + reach; ++j) {
      const double distance =
          std::hypot(static_cast<double>(i) - row, static_cast<double>(j) - column) / reach;
      if (distance > 1.0) continue;
      const std::ptrdiff_t at =
          ((i % pixels + pixels) % pixels) * pixels + (j % pixels + pixels) % pixels;
      float& height_m = heights_m[static_cast<std::size_t>(at)];
      height_m = std::max(height_m, static_cast<float>(element.height_m * profile(distance)));
    }
  }
}

}  // namespace asperity
