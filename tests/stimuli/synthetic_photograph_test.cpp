// The pipeline's ground truth: photographs of known relief, and what comes back of it.

#include "stimuli/photographs/synthetic_photograph.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/photograph_advice.h"
#include "stimuli/photographs/texture_from_photograph.h"
#include "stimuli/pictures/photograph.h"
#include "tests/stimuli/correlation.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kSurfaces{"cones", "noise", "metal",     "stone",
                                         "wood",  "brick", "sandpaper", "sinusoid"};

HeightField surface(const std::string& kind) { return make_surface(kind, {}, {.pixels = 512}); }

// Through an 8-bit file, as any photograph comes.
GreyImage photograph_of(const HeightField& relief, const PhotographSettings& settings) {
  return decode_photograph(encode_png(synthetic_photograph(relief, settings)), "synthetic").grey;
}

HeightField recovered(const HeightField& relief, const PhotographSettings& settings) {
  return texture_from_photograph(photograph_of(relief, settings), {}, "synthetic").field;
}

std::vector<float> passband(const HeightField& field) {
  return without_long_wavelengths(field, TextureRecipe{}.gaussian_wavelength_m).heights_m();
}

// The slope along the light, positive where the ground falls away from it.
HeightField slope_towards_light(const HeightField& field, double azimuth_rad) {
  const HeightField::Grid& grid = field.grid();
  std::vector<float> slopes;
  for (std::size_t i = 0; i < grid.rows; ++i) {
    for (std::size_t j = 0; j < grid.columns; ++j) {
      const double x_m =
          (static_cast<double>(j) - 0.5 * static_cast<double>(grid.columns - 1)) * grid.pitch_m;
      const double y_m =
          (0.5 * static_cast<double>(grid.rows - 1) - static_cast<double>(i)) * grid.pitch_m;
      const HeightSample at = field.sample(x_m, y_m, Tiling::mirror);
      slopes.push_back(static_cast<float>(-at.slope_x * std::cos(azimuth_rad) -
                                          at.slope_y * std::sin(azimuth_rad)));
    }
  }
  return {grid, slopes};
}

TEST(BrightHeightPhotograph, GivesTheHeightsBackWithTheirSign) {
  for (const std::string& kind : kSurfaces) {
    const HeightField relief = surface(kind);
    const HeightField back = recovered(relief, {.noise_rms = 0.003});
    EXPECT_GT(correlation(back.heights_m(), passband(relief)), 0.9) << kind;
  }
}

TEST(BrightHeightPhotograph, GivesNearlyTheSameUnderALampThreeTimesBrighterOnOneSide) {
  for (const std::string& kind : kSurfaces) {
    const HeightField relief = surface(kind);
    const HeightField even = recovered(relief, {});
    const HeightField uneven = recovered(relief, {.lamp_ratio = 3.0});
    const double truth_even = correlation(even.heights_m(), passband(relief));
    const double truth_uneven = correlation(uneven.heights_m(), passband(relief));
    EXPECT_GT(truth_uneven, 0.9) << kind;
    EXPECT_LT(std::abs(truth_even - truth_uneven), 0.05) << kind;
    EXPECT_GT(correlation(even.heights_m(), uneven.heights_m()), 0.95) << kind;
  }
}

// Light at 45° from +x and from 2 rad. Where the grain is along the light there is no slope to see.
TEST(LambertPhotograph, GivesTheSlopeAlongTheLightAndNotTheHeight) {
  for (const std::string& kind : kSurfaces) {
    for (const double azimuth_rad : {0.0, 2.0}) {
      const HeightField relief = surface(kind);
      const HeightField back = recovered(
          relief, {.photograph_case = PhotographCase::lambert, .light_azimuth_rad = azimuth_rad});
      EXPECT_GT(correlation(back.heights_m(), passband(slope_towards_light(relief, azimuth_rad))),
                0.85)
          << kind << " from " << azimuth_rad;
      EXPECT_LT(std::abs(correlation(back.heights_m(), passband(relief))), 0.3)
          << kind << " from " << azimuth_rad;
    }
  }
}

TEST(LambertPhotograph, IsBrightOnTheSideOfTheLight) {
  // h = 0.1 x rises to the right, away from a light at the left.
  std::vector<float> heights_m;
  for (int k = 0; k < 256; ++k) heights_m.push_back(static_cast<float>(1e-4 * (k % 16)));
  const HeightField slope({.rows = 16, .columns = 16, .pitch_m = 1e-3}, heights_m);
  PhotographSettings settings{.photograph_case = PhotographCase::lambert};
  settings.light_elevation_rad = std::numbers::pi / 4.0;
  const auto middle = [&](double azimuth_rad) {
    settings.light_azimuth_rad = azimuth_rad;
    return static_cast<double>(synthetic_photograph(slope, settings).values[8 * 16 + 8]);
  };
  // n·l/sin ε = (1 ∓ 0.1)/√1.01 for light from the right and the left.
  EXPECT_NEAR(middle(0.0), 0.5 * 0.9 / std::sqrt(1.01), 1e-6);
  EXPECT_NEAR(middle(std::numbers::pi), 0.5 * 1.1 / std::sqrt(1.01), 1e-6);
  EXPECT_NEAR(middle(std::numbers::pi / 2.0), 0.5 / std::sqrt(1.01), 1e-6);
}

TEST(AlbedoPhotograph, GivesNothingOfTheHeights) {
  for (const std::string& kind : kSurfaces) {
    const HeightField relief = surface(kind);
    const HeightField back = recovered(relief, {.photograph_case = PhotographCase::albedo});
    EXPECT_LT(std::abs(correlation(back.heights_m(), passband(relief))), 0.1) << kind;
  }
}

TEST(SyntheticPhotograph, DimsTheRightSideByTheLampRatio) {
  const HeightField flat({.rows = 16, .columns = 33, .pitch_m = 1e-3}, std::vector<float>(16 * 33));
  const GreyImage even = synthetic_photograph(flat, {});
  const GreyImage uneven = synthetic_photograph(flat, {.lamp_ratio = 3.0});
  EXPECT_NEAR(even.values[0], 0.5, 1e-6);
  EXPECT_NEAR(uneven.values[0], 0.5, 1e-6);
  EXPECT_NEAR(uneven.values[32], 0.5 / 3.0, 1e-6);
  EXPECT_NEAR(uneven.values[16], 0.5 * (1.0 + 1.0 / 3.0) / 2.0, 1e-6);
}

TEST(SyntheticPhotograph, AppliesTheCamerasGammaAndNoise) {
  const HeightField flat({.rows = 64, .columns = 64, .pitch_m = 1e-3}, std::vector<float>(64 * 64));
  EXPECT_NEAR(synthetic_photograph(flat, {.gamma = 2.0}).values[5], std::sqrt(0.5), 1e-6);
  const GreyImage noisy = synthetic_photograph(flat, {.noise_rms = 0.05});
  double squares = 0.0;
  for (const float value : noisy.values) squares += std::pow(static_cast<double>(value) - 0.5, 2);
  EXPECT_NEAR(std::sqrt(squares / (64.0 * 64.0)), 0.05, 0.003);
  EXPECT_EQ(noisy.values, synthetic_photograph(flat, {.noise_rms = 0.05}).values);
  EXPECT_NE(noisy.values, synthetic_photograph(flat, {.noise_rms = 0.05, .seed = 2}).values);
}

TEST(SyntheticPhotograph, RefusesSettingsThatNoCameraHas) {
  const HeightField flat({.rows = 2, .columns = 2, .pitch_m = 1e-3}, std::vector<float>(4));
  EXPECT_THROW(synthetic_photograph(flat, {.light_elevation_rad = 0.0}), std::invalid_argument);
  EXPECT_THROW(synthetic_photograph(flat, {.lamp_ratio = 0.0}), std::invalid_argument);
  EXPECT_THROW(synthetic_photograph(flat, {.gamma = NAN}), std::invalid_argument);
  EXPECT_THROW(synthetic_photograph(flat, {.noise_rms = -0.1}), std::invalid_argument);
}

PhotographResemblance seen_in(const HeightField& relief, const PhotographSettings& settings) {
  return resemblances(examine_photograph(photograph_of(relief, settings), {}, "synthetic")).front();
}

TEST(PhotographAdvice, SeesTheDirectionOfOneSidedLight) {
  for (const std::string kind : {"stone", "noise"}) {
    const GreyImage picture = photograph_of(
        surface(kind),
        {.photograph_case = PhotographCase::lambert, .light_azimuth_rad = std::numbers::pi / 3.0});
    const PhotographEvidence evidence = examine_photograph(picture, {}, "synthetic");
    EXPECT_EQ(resemblances(evidence).front(), PhotographResemblance::directed) << kind;
    EXPECT_NEAR(evidence.direction_rad, std::numbers::pi / 3.0, 0.2) << kind;
  }
}

TEST(PhotographAdvice, NamesEveryResemblance) {
  using enum PhotographResemblance;
  EXPECT_EQ(resemblances({.skewness = 2.0, .anisotropy = 0.9}),
            (std::vector{directed, bright_spots}));
  EXPECT_EQ(resemblances({.skewness = -2.0, .anisotropy = 0.0}), std::vector{dark_grooves});
  EXPECT_EQ(resemblances({}), std::vector{nothing_clear});
}

TEST(PhotographAdvice, CannotTellGrainFromOneSidedLight) {
  EXPECT_EQ(seen_in(surface("wood"), {}), PhotographResemblance::directed);
}

TEST(PhotographAdvice, SeesGrainsAndTheirReverse) {
  const HeightField grains = surface("cones");
  EXPECT_EQ(seen_in(grains, {}), PhotographResemblance::bright_spots);
  std::vector<float> turned_m = grains.heights_m();
  for (float& height_m : turned_m) height_m = -height_m;
  EXPECT_EQ(seen_in(HeightField(grains.grid(), turned_m), {}), PhotographResemblance::dark_grooves);
}

TEST(PhotographAdvice, SaysSoWhenThePictureTellsNothing) {
  const HeightField stone = surface("stone");
  EXPECT_EQ(seen_in(stone, {.photograph_case = PhotographCase::albedo}),
            PhotographResemblance::nothing_clear);
  // Honest: even where brightness did follow height, this picture looks like the painted one.
  EXPECT_EQ(seen_in(stone, {}), PhotographResemblance::nothing_clear);
}

TEST(PhotographAdvice, GivesTheNumbersAndWhatCannotBeKnown) {
  const std::string words =
      advice({.skewness = -0.812, .anisotropy = 0.1, .direction_rad = 0.0}).english();
  EXPECT_THAT(words, HasSubstr("Skewness -0.81, anisotropy 0.1"));
  EXPECT_THAT(words, HasSubstr("bright is high: the correct sign is 1. "));
  EXPECT_THAT(words, HasSubstr("One photograph cannot show"));
  EXPECT_THAT(advice({.skewness = 0.0, .anisotropy = 0.6, .direction_rad = 0.785398}).english(),
              HasSubstr("along 45°"));
  // Both observations are told where there are two.
  const std::string both =
      advice({.skewness = 1.1, .anisotropy = 0.6, .direction_rad = -1e-3}).english();
  EXPECT_THAT(both, HasSubstr("along 0°"));
  EXPECT_THAT(both, HasSubstr("if they lie low (light mortar between bricks), it is -1"));
}

}  // namespace
}  // namespace asperity
