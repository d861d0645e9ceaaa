// The relief of a material scan, from maps of a relief that is known by formula.

#include "stimuli/measured/normal_map.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/support/refusal.h"

namespace asperity {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

constexpr std::size_t kColumns = 160;
constexpr std::size_t kRows = 120;
constexpr double kPitch_m = 1e-4;
constexpr double kWidth_m = kColumns * kPitch_m;

/// A cosine with m half waves across and n down, which reflection continues without a step.
struct ScannedWave {
  double amplitude_m = 0.0;
  int m = 0;
  int n = 0;

  double k_x() const { return pi * m / kWidth_m; }
  double k_y() const { return pi * n / (kRows * kPitch_m); }
  /// 1/wavelength
  double wavenumber() const { return std::hypot(k_x(), k_y()) / (2.0 * pi); }
};

// Wavelengths of 8, 4.9, 1.6, 0.98 and 0.75 mm.
const std::vector<ScannedWave> kWaves{
    {2e-4, 4, 0}, {1e-4, 3, 4}, {5e-5, 20, 0}, {3e-5, 10, 23}, {2e-5, 0, 32}};

/// A sum over the waves at every pixel, y upwards from the bottom edge.
std::vector<double> sum_of_waves(
    const std::function<double(const ScannedWave&, double x_m, double y_m)>& part) {
  std::vector<double> sums{};
  for (std::size_t i = 0; i < kRows; ++i) {
    for (std::size_t j = 0; j < kColumns; ++j) {
      const double x_m = (static_cast<double>(j) + 0.5) * kPitch_m;
      const double y_m = (static_cast<double>(kRows - 1 - i) + 0.5) * kPitch_m;
      double sum = 0.0;
      for (const ScannedWave& wave : kWaves) sum += part(wave, x_m, y_m);
      sums.push_back(sum);
    }
  }
  return sums;
}

std::vector<double> relief_m() {
  return sum_of_waves([](const ScannedWave& wave, double x_m, double y_m) {
    return wave.amplitude_m * std::cos(wave.k_x() * x_m) * std::cos(wave.k_y() * y_m);
  });
}

constexpr double kRange_m = 1e-3;

/// The relief's long waves, exp(−½ ν² λ²) of each: what a coarse displacement map has.
GreyImage displacement(double cutoff_m) {
  const std::vector<double> heights_m =
      sum_of_waves([cutoff_m](const ScannedWave& wave, double x_m, double y_m) {
        const double ratio = wave.wavenumber() * cutoff_m;
        return wave.amplitude_m * std::exp(-0.5 * ratio * ratio) * std::cos(wave.k_x() * x_m) *
               std::cos(wave.k_y() * y_m);
      });
  GreyImage map{kRows, kColumns, {}};
  for (const double height_m : heights_m) {
    map.values.push_back(static_cast<float>(0.5 + height_m / kRange_m));
  }
  return map;
}

ColorPlanes normals(NormalConvention convention) {
  const std::vector<double> p = sum_of_waves([](const ScannedWave& wave, double x_m, double y_m) {
    return -wave.amplitude_m * wave.k_x() * std::sin(wave.k_x() * x_m) * std::cos(wave.k_y() * y_m);
  });
  const std::vector<double> q = sum_of_waves([](const ScannedWave& wave, double x_m, double y_m) {
    return -wave.amplitude_m * wave.k_y() * std::cos(wave.k_x() * x_m) * std::sin(wave.k_y() * y_m);
  });
  ColorPlanes map{};
  for (GreyImage& plane : map) plane = {kRows, kColumns, {}};
  const double up = convention == NormalConvention::opengl ? 1.0 : -1.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double length = std::sqrt(1.0 + p[i] * p[i] + q[i] * q[i]);
    map[0].values.push_back(static_cast<float>(0.5 * (1.0 - p[i] / length)));
    map[1].values.push_back(static_cast<float>(0.5 * (1.0 - up * q[i] / length)));
    map[2].values.push_back(static_cast<float>(0.5 * (1.0 + 1.0 / length)));
  }
  return map;
}

ScanRecipe recipe_with(NormalConvention convention) {
  return {.width_m = kWidth_m,
          .height_range_m = kRange_m,
          .crossover_wavelength_m = 3e-3,
          .convention = convention};
}

/// RMS of the difference of two reliefs over the RMS of the second, without their means.
double relative_error(const std::vector<float>& found, const std::vector<double>& wanted,
                      double unit_m) {
  double mean = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    mean +=
        (static_cast<double>(found[i]) * unit_m - wanted[i]) / static_cast<double>(wanted.size());
  }
  double errors = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double error = static_cast<double>(found[i]) * unit_m - wanted[i] - mean;
    errors += error * error;
    squares += wanted[i] * wanted[i];
  }
  return std::sqrt(errors / squares);
}

TEST(NormalMap, IntegratesToTheRelief) {
  for (const NormalConvention convention : {NormalConvention::opengl, NormalConvention::directx}) {
    const GreyImage heights =
        integrated_slopes(slopes_of_normal_map(normals(convention), convention));
    EXPECT_LT(relative_error(heights.values, relief_m(), kPitch_m), 1e-3);
  }
}

// The displacement map has lost the waves below 1 mm: of the wave of 1.6 mm it has 82 %.
TEST(NormalMap, IsFusedWithACoarseDisplacementMapToTheRelief) {
  for (const NormalConvention convention : {NormalConvention::opengl, NormalConvention::directx}) {
    const FusedRelief relief = fused_relief(displacement(1e-3), normals(convention),
                                            recipe_with(convention), "d.png", "n.png");
    EXPECT_LT(relative_error(relief.field.heights_m(), relief_m(), 1.0), 0.02);
    EXPECT_GT(relief.agreement, 0.99);
    EXPECT_LT(relief.agreement_of_other_convention, 0.9);
    // The displacement map has lost a part of the wave of 1.6 mm.
    EXPECT_NEAR(relief.amplitude_ratio, 1.06, 0.02);
    EXPECT_DOUBLE_EQ(relief.field.grid().pitch_m, kPitch_m);
  }
}

// Displacements of four levels, whose steps are coarser than the detail: the normals give the waves below 3 mm.
TEST(NormalMap, ReplacesTheStepsOfACoarselyQuantisedDisplacementMap) {
  GreyImage coarse = displacement(1e-3);
  for (float& level : coarse.values) level = std::round(level * 16.0F) / 16.0F;
  const std::vector<float> alone = [&] {
    std::vector<float> heights_m = coarse.values;
    for (float& level : heights_m) level *= static_cast<float>(kRange_m);
    return heights_m;
  }();
  const FusedRelief relief = fused_relief(coarse, normals(NormalConvention::opengl),
                                          recipe_with(NormalConvention::opengl), "d.png", "n.png");
  const double before = relative_error(alone, relief_m(), 1.0);
  const double after = relative_error(relief.field.heights_m(), relief_m(), 1.0);
  EXPECT_GT(before, 0.1);
  EXPECT_LT(after, 0.3 * before);
}

TEST(NormalMap, AgreesBetterWithItsOwnConvention) {
  const FusedRelief relief = fused_relief(displacement(1e-3), normals(NormalConvention::directx),
                                          recipe_with(NormalConvention::opengl), "d.png", "n.png");
  EXPECT_LT(relief.agreement, relief.agreement_of_other_convention);
}

TEST(NormalMap, BoundsTheSlopeOfANormalInThePlane) {
  ColorPlanes map{};
  map[0] = {1, 2, {1.0F, 0.5F}};
  map[1] = {1, 2, {0.5F, 0.5F}};
  map[2] = {1, 2, {0.5F, 1.0F}};
  const ComplexPicture slopes = slopes_of_normal_map(map, NormalConvention::opengl);
  EXPECT_NEAR(slopes.values[0].real(), -10.0F, 1e-5F);
  EXPECT_EQ(slopes.values[1], std::complex<float>(0.0F, 0.0F));
}

std::string scan_refusal(const ScanRecipe& recipe, const GreyImage& heights) {
  return refusal_of<std::invalid_argument>(
      [&] { fused_relief(heights, normals(NormalConvention::opengl), recipe, "d.png", "n.png"); });
}

TEST(NormalMap, RefusesWhatCannotBeFused) {
  const ScanRecipe recipe = recipe_with(NormalConvention::opengl);
  EXPECT_THAT(scan_refusal(recipe, {16, 20, std::vector<float>(320)}),
              testing::AllOf(HasSubstr("n.png is 160 by 120 pixels"), HasSubstr("d.png 20 by 16")));
  EXPECT_THAT(scan_refusal(recipe, {8, 20, std::vector<float>(160)}),
              HasSubstr("at least 16 by 16"));
  const auto changed = [&](const std::function<void(ScanRecipe&)>& change) {
    ScanRecipe other = recipe;
    change(other);
    return scan_refusal(other, displacement(1e-3));
  };
  EXPECT_THAT(changed([](ScanRecipe& r) { r.height_range_m = -1e-3; }),
              HasSubstr("height_range_m is -0.001"));
  EXPECT_THAT(changed([](ScanRecipe& r) { r.crossover_wavelength_m = 1e-4; }),
              HasSubstr("crossover_wavelength_m is 1e-04; it must be from two pixels"));
  EXPECT_THAT(changed([](ScanRecipe& r) { r.crossover_wavelength_m = 0.5; }),
              HasSubstr("to the width of the surface"));
  EXPECT_THAT(changed([](ScanRecipe& r) { r.width_m = 0.5; }),
              HasSubstr("3.125 mm of the surface"));
}

}  // namespace
}  // namespace asperity
