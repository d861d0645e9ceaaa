// Takes the nearest row of heights, and computes its spectrum by Welch's method.

#include "app/gui/workbench/line_profile.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/signals/spectrum.h"
#include "app/gui/look/theme.h"

namespace asperity {

LineProfile profile_along(const HeightField& field, double y_m) {
  const HeightField::Grid& grid = field.grid();
  const double row_at = 0.5 * static_cast<double>(grid.rows - 1) - y_m / grid.pitch_m;
  const auto row = static_cast<std::size_t>(
      std::clamp(std::round(row_at), 0.0, static_cast<double>(grid.rows - 1)));
  const float* heights_m = field.heights_m().data() + row * grid.columns;
  LineProfile profile{};
  profile.heights.color = profile.spectrum.color = series_color(5);
  std::vector<double> heights_um{};
  for (std::size_t j = 0; j < grid.columns; ++j) {
    heights_um.push_back(1e6 * static_cast<double>(heights_m[j]));
    profile.heights.x.push_back(1e3 * grid.pitch_m * static_cast<double>(j));
    profile.heights.y.push_back(heights_um.back());
  }
  // Half the line in a window: three of them, and waves down to half its length.
  const PowerSpectrum spectrum = welch_spectrum(
      heights_um,
      {.rate_Hz = 1e-3 / grid.pitch_m, .length = std::max<std::size_t>(2, grid.columns / 2)});
  for (std::size_t k = 1; k < spectrum.density.size(); ++k) {
    profile.spectrum.x.push_back(static_cast<double>(k) * spectrum.spacing_Hz);
    profile.spectrum.y.push_back(spectrum.density[k]);
  }
  return profile;
}

}  // namespace asperity
