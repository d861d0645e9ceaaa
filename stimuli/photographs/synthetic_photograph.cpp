// Implements the lighting of a known relief.

#include "stimuli/photographs/synthetic_photograph.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"
#include "analysis/numbers/random.h"
#include "stimuli/heights/spectral_noise.h"

namespace asperity {

namespace {

void refuse_outside(const char* name, double value, double low, double high, const char* right) {
  if (value >= low && value <= high) return;
  throw std::invalid_argument(std::string(name) + " is " + number_text(value) + "; it must " +
                              right + ".");
}

void check(const PhotographSettings& settings) {
  refuse_outside("light_elevation_rad", settings.light_elevation_rad, 1e-3,
                 std::numbers::pi / 2.0 + 1e-9, "lie above 0, up to π/2");
  refuse_outside("the magnitude of light_azimuth_rad", std::abs(settings.light_azimuth_rad), 0.0,
                 1e3, "be an angle of at most 1000 rad");
  refuse_outside("lamp_ratio", settings.lamp_ratio, 0.05, 20.0, "lie between 1/20 and 20");
  refuse_outside("gamma", settings.gamma, 0.05, 20.0, "lie between 1/20 and 20");
  refuse_outside("noise_rms", settings.noise_rms, 0.0, 1.0, "lie between 0 and 1");
}

std::vector<float> bright_height(const HeightField& surface) {
  const double range_m = surface.maximum_m() - surface.minimum_m();
  std::vector<float> light;
  light.reserve(surface.heights_m().size());
  for (const float height_m : surface.heights_m()) {
    const double share =
        range_m > 0.0 ? (static_cast<double>(height_m) - surface.minimum_m()) / range_m : 0.5;
    light.push_back(static_cast<float>(0.2 + 0.6 * share));
  }
  return light;
}

std::vector<float> lambert(const HeightField& surface, const PhotographSettings& settings) {
  const HeightField::Grid& grid = surface.grid();
  const double sine = std::sin(settings.light_elevation_rad);
  const double cosine = std::cos(settings.light_elevation_rad);
  const double toward_x = cosine * std::cos(settings.light_azimuth_rad);
  const double toward_y = cosine * std::sin(settings.light_azimuth_rad);
  std::vector<float> light;
  light.reserve(surface.heights_m().size());
  for (std::size_t i = 0; i < grid.rows; ++i) {
    for (std::size_t j = 0; j < grid.columns; ++j) {
      const double x_m =
          (static_cast<double>(j) - 0.5 * static_cast<double>(grid.columns - 1)) * grid.pitch_m;
      const double y_m =
          (0.5 * static_cast<double>(grid.rows - 1) - static_cast<double>(i)) * grid.pitch_m;
      const HeightSample at = surface.sample(x_m, y_m, Tiling::mirror);
      const double toward_light = (sine - at.slope_x * toward_x - at.slope_y * toward_y) /
                                  std::hypot(at.slope_x, at.slope_y, 1.0);
      light.push_back(static_cast<float>(0.5 * std::max(0.0, toward_light) / sine));
    }
  }
  return light;
}

std::vector<float> paint(const HeightField& surface, const PhotographSettings& settings) {
  const HeightField::Grid& grid = surface.grid();
  const std::size_t side = std::max(grid.rows, grid.columns);
  const SurfaceCanvas canvas{
      .width_m = static_cast<double>(side) * grid.pitch_m, .pixels = side, .seed = settings.seed};
  const Heights blots = spectral_noise(canvas, "paint", [](const Wavenumber& at) {
    return amplitude_at({.centre_m = 0.003, .spread = 0.5}, std::hypot(at.x_per_m, at.y_per_m));
  });
  std::vector<float> light;
  light.reserve(surface.heights_m().size());
  for (std::size_t i = 0; i < grid.rows; ++i) {
    for (std::size_t j = 0; j < grid.columns; ++j) {
      light.push_back(std::max(0.0F, 0.5F + 0.15F * blots[i * side + j]));
    }
  }
  return light;
}

std::vector<float> light_on(const HeightField& surface, const PhotographSettings& settings) {
  switch (settings.photograph_case) {
    case PhotographCase::bright_height:
      return bright_height(surface);
    case PhotographCase::lambert:
      return lambert(surface, settings);
    case PhotographCase::albedo:
      return paint(surface, settings);
  }
  return {};
}

}  // namespace

GreyImage synthetic_photograph(const HeightField& surface, const PhotographSettings& settings) {
  check(settings);
  const HeightField::Grid& grid = surface.grid();
  GreyImage picture{grid.rows, grid.columns, light_on(surface, settings)};
  Random noise = Random(settings.seed).split("camera");
  for (std::size_t k = 0; k < picture.values.size(); ++k) {
    const double across =
        static_cast<double>(k % grid.columns) / static_cast<double>(grid.columns - 1);
    const double lamp = 1.0 + across * (1.0 / settings.lamp_ratio - 1.0);
    // Normalises a lamp that is brighter on the right to a maximum of 1.
    const double brightest = std::max(1.0, 1.0 / settings.lamp_ratio);
    double value = static_cast<double>(picture.values[k]) * lamp / brightest;
    if (settings.gamma != 1.0) value = std::pow(value, 1.0 / settings.gamma);
    if (settings.noise_rms > 0.0) value += settings.noise_rms * noise.normal();
    picture.values[k] = static_cast<float>(std::clamp(value, 0.0, 1.0));
  }
  return picture;
}

}  // namespace asperity
