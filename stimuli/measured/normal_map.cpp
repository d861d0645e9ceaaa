// Implements the integration of normal maps and their fusion with displacement maps.

#include "stimuli/measured/normal_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "analysis/numbers/number_text.h"
#include "stimuli/pictures/bands.h"
#include "stimuli/pictures/picture_filter.h"

namespace asperity {

namespace {

constexpr float kLeastNormalZ = 0.1F;
constexpr std::size_t kSmallestMapSide = 16;
constexpr double kLargestMapPitch_m = 1e-3;  // as for photographs

void refuse_value(const char* field, double value, const std::string& problem) {
  throw std::invalid_argument(std::string(field) + " is " + number_text(value) + "; " + problem);
}

void check_scan(const GreyImage& displacement, const ColorPlanes& normals, const ScanRecipe& recipe,
                const std::string& displacement_name, const std::string& normals_name) {
  const auto size_of = [](const GreyImage& picture) {
    return std::to_string(picture.columns) + " by " + std::to_string(picture.rows) + " pixels";
  };
  if (displacement.rows < kSmallestMapSide || displacement.columns < kSmallestMapSide) {
    throw std::invalid_argument(displacement_name + " is " + size_of(displacement) +
                                "; a texture needs at least 16 by 16. Use larger maps.");
  }
  if (normals[0].rows != displacement.rows || normals[0].columns != displacement.columns) {
    throw std::invalid_argument(normals_name + " is " + size_of(normals[0]) + " and " +
                                displacement_name + " " + size_of(displacement) +
                                "; both must be equal in size. Scale one of them.");
  }
  for (const auto& [field, value] :
       {std::pair{"width_m", recipe.width_m}, std::pair{"height_range_m", recipe.height_range_m},
        std::pair{"crossover_wavelength_m", recipe.crossover_wavelength_m}}) {
    if (!std::isfinite(value) || value <= 0.0) {
      refuse_value(field, value, "it must be a positive number.");
    }
  }
  const double pitch_m = recipe.width_m / static_cast<double>(displacement.columns);
  if (pitch_m > kLargestMapPitch_m) {
    refuse_value("width_m", recipe.width_m,
                 "each of the " + std::to_string(displacement.columns) + " pixels of " +
                     displacement_name + " would be " + number_text(pitch_m * 1e3) +
                     " mm of the surface, and pixels larger than 1 mm cannot represent a texture. "
                     "Use maps with more pixels, or a smaller part of them.");
  }
  if (recipe.crossover_wavelength_m < 2.0 * pitch_m ||
      recipe.crossover_wavelength_m > recipe.width_m) {
    refuse_value("crossover_wavelength_m", recipe.crossover_wavelength_m,
                 "it must be from two pixels, " + number_text(2.0 * pitch_m) +
                     " m, to the width of the surface, " + number_text(recipe.width_m) + " m.");
  }
}

GreyImage low_pass_of(const GreyImage& picture, double cutoff) {
  return PictureSpectrum(picture, cutoff, usual_threads()).filtered({});
}

/// The waves between half and twice the cut-off.
GreyImage around(const GreyImage& picture, double cutoff) {
  GreyImage band = low_pass_of(picture, 0.5 * cutoff);
  const GreyImage below = low_pass_of(picture, 2.0 * cutoff);
  for (std::size_t i = 0; i < band.values.size(); ++i) band.values[i] -= below.values[i];
  return band;
}

/// Sums of products of two pictures, whose means are nearly 0.
double product(const GreyImage& a, const GreyImage& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    sum += static_cast<double>(a.values[i]) * static_cast<double>(b.values[i]);
  }
  return sum;
}

double normalised(double ab, double aa, double bb) {
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : 0.0;
}

}  // namespace

const char* name_of(NormalConvention convention) noexcept {
  return convention == NormalConvention::opengl ? "opengl" : "directx";
}

ComplexPicture slopes_of_normal_map(const ColorPlanes& map, NormalConvention convention) {
  ComplexPicture slopes{map[0].rows, map[0].columns, {}};
  slopes.values.reserve(map[0].values.size());
  const float up = convention == NormalConvention::opengl ? 1.0F : -1.0F;
  for (std::size_t i = 0; i < map[0].values.size(); ++i) {
    const float n_x = 2.0F * map[0].values[i] - 1.0F;
    const float n_y = up * (2.0F * map[1].values[i] - 1.0F);
    const float n_z = std::max(kLeastNormalZ, 2.0F * map[2].values[i] - 1.0F);
    slopes.values.emplace_back(-n_x / n_z, -n_y / n_z);
  }
  return slopes;
}

GreyImage integrated_slopes(ComplexPicture slopes) {
  std::complex<double> mean{};
  for (const std::complex<float>& slope : slopes.values) mean += std::complex<double>(slope);
  mean /= static_cast<double>(slopes.values.size());
  for (std::complex<float>& slope : slopes.values) slope -= std::complex<float>(mean);
  const ComplexPicture heights = reflected_filter(
      slopes, {.across = Reflection::odd}, {.down = Reflection::odd},
      [](double nu_x, double nu_y) -> std::complex<double> {
        const double square = nu_x * nu_x + nu_y * nu_y;
        if (square == 0.0) return 0.0;
        return std::complex<double>(-nu_y, -nu_x) / (2.0 * std::numbers::pi * square);
      });
  GreyImage result{heights.rows, heights.columns, {}};
  result.values.reserve(heights.values.size());
  double sum = 0.0;
  for (const std::complex<float>& height : heights.values) {
    result.values.push_back(height.real());
    sum += static_cast<double>(height.real());
  }
  const auto level = static_cast<float>(sum / static_cast<double>(result.values.size()));
  for (float& height : result.values) height -= level;
  return result;
}

FusedRelief fused_relief(const GreyImage& displacement, const ColorPlanes& normals,
                         const ScanRecipe& recipe, const std::string& displacement_name,
                         const std::string& normals_name) {
  check_scan(displacement, normals, recipe, displacement_name, normals_name);
  const double pitch_m = recipe.width_m / static_cast<double>(displacement.columns);
  const double cutoff = recipe.crossover_wavelength_m / pitch_m;
  ComplexPicture slopes = slopes_of_normal_map(normals, recipe.convention);
  ComplexPicture others = slopes;
  for (std::complex<float>& slope : others.values) slope = std::conj(slope);
  // All heights in units of the distance between pixels.
  GreyImage detail = integrated_slopes(std::move(slopes));
  GreyImage shape = displacement;
  for (float& level : shape.values) level *= static_cast<float>(recipe.height_range_m / pitch_m);

  const GreyImage of_shape = around(shape, cutoff);
  const GreyImage of_detail = around(detail, cutoff);
  const GreyImage of_other = around(integrated_slopes(std::move(others)), cutoff);
  const double shape_power = product(of_shape, of_shape);
  const double detail_power = product(of_detail, of_detail);

  const GreyImage shape_low = low_pass_of(shape, cutoff);
  const GreyImage detail_low = low_pass_of(detail, cutoff);
  std::vector<float> heights_m(detail.values.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    heights_m[i] = static_cast<float>(pitch_m) *
                   (shape_low.values[i] + (detail.values[i] - detail_low.values[i]));
    sum += static_cast<double>(heights_m[i]);
  }
  const auto mean_m = static_cast<float>(sum / static_cast<double>(heights_m.size()));
  for (float& height_m : heights_m) height_m -= mean_m;
  return {
      .field = {{.rows = displacement.rows, .columns = displacement.columns, .pitch_m = pitch_m},
                std::move(heights_m)},
      .agreement = normalised(product(of_shape, of_detail), shape_power, detail_power),
      .agreement_of_other_convention =
          normalised(product(of_shape, of_other), shape_power, product(of_other, of_other)),
      .amplitude_ratio = shape_power > 0.0 ? std::sqrt(detail_power / shape_power) : 0.0};
}

ParameterValues parameter_values(const ScanRecipe& recipe) {
  return {{"width_m", recipe.width_m},
          {"height_range_m", recipe.height_range_m},
          {"crossover_wavelength_m", recipe.crossover_wavelength_m},
          {"normals_convention", std::string(name_of(recipe.convention))}};
}

}  // namespace asperity
