// The pipeline's arithmetic: what it keeps of a wave, at which size, and what it refuses.

#include "stimuli/photographs/texture_from_photograph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/stimuli/correlation.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t kSide = 400;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

// With γ = 1 the homomorphic filter does nothing, and the rest is linear.
TextureRecipe linear_recipe() {
  TextureRecipe recipe;
  recipe.gamma_low = 1.0;
  recipe.gamma_high = 1.0;
  return recipe;
}

// Brightness 0.5 + 0.2 cos along x, with crests at the left edge, so that reflection continues it.
GreyImage waves(double wavelength_m, double width_m, std::size_t rows = kSide) {
  GreyImage image{rows, kSide, {}};
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < kSide; ++j) {
      const double x_m = (static_cast<double>(j) + 0.5) * width_m / kSide;
      image.values.push_back(static_cast<float>(0.5 + 0.2 * std::cos(kTwoPi * x_m / wavelength_m)));
    }
  }
  return image;
}

double amplitude(const GreyImage& image) {
  const auto [low, high] = std::minmax_element(image.values.begin(), image.values.end());
  return 0.5 * (static_cast<double>(*high) - static_cast<double>(*low));
}

std::string texture_refusal(const GreyImage& image, const TextureRecipe& recipe) {
  return refusal_of<std::invalid_argument>(
      [&] { texture_from_photograph(image, recipe, "wall.png"); });
}

GreyImage transposed(const GreyImage& image) {
  GreyImage result{image.columns, image.rows, std::vector<float>(image.values.size())};
  for (std::size_t i = 0; i < image.rows; ++i) {
    for (std::size_t j = 0; j < image.columns; ++j) {
      result.values[j * image.rows + i] = image.values[i * image.columns + j];
    }
  }
  return result;
}

// H_g(ν) = exp(−½ ν² λ_g²): at the cut-off e^−½, at half of it e^−2, at twice of it e^−⅛; along x
// and along y.
TEST(TextureFromPhotograph, PassesWavesThroughItsLowPassAsTheFormulaSays) {
  const TextureRecipe recipe = linear_recipe();
  for (const double ratio : {0.5, 1.0, 2.0}) {
    const GreyImage along_x = waves(ratio * recipe.gaussian_wavelength_m, 0.10);
    for (const GreyImage& image : {along_x, transposed(along_x)}) {
      const PhotographTexture texture = texture_from_photograph(image, recipe, "waves");
      EXPECT_NEAR(amplitude(texture.evened), amplitude(texture.grey), 1e-5);
      EXPECT_NEAR(amplitude(texture.low_pass) / amplitude(texture.grey),
                  std::exp(-0.5 / (ratio * ratio)), 1e-3);
    }
  }
}

// Small waves around b = 0.5 in the logarithm: H_h(ν) = γ_L + (γ_H − γ_L)(1 − exp(−ν² λ_h²)), so
// at the cut-off 0.5 + 1.5 (1 − e^−1) = 1.448, far below it γ_H = 2. The mean is raised to the
// power γ_L: 0.5^½.
TEST(TextureFromPhotograph, RaisesContrastAsTheHomomorphicFormulaSays) {
  const TextureRecipe recipe;
  for (const auto& [ratio, factor] :
       {std::pair{1.0, 0.5 + 1.5 * (1.0 - std::exp(-1.0))}, std::pair{0.25, 2.0}}) {
    GreyImage image = waves(ratio * recipe.homomorphic_wavelength_m, 0.10);
    for (float& value : image.values) value = 0.5F + 0.02F * (value - 0.5F);
    const PhotographTexture texture = texture_from_photograph(image, recipe, "waves");
    const double level = 0.5 + 1.0 / 255.0;
    EXPECT_NEAR(amplitude(texture.evened) / amplitude(texture.grey),
                factor * std::sqrt(level) / level, 2e-3);
  }
}

// Two waves of equal brightness, at λ_g/2 and λ_g/4: 1 − H_g passes both nearly whole (1 − e^−2, 1 − e^−8), and a tilt p
// makes the ratio of their heights 2ᵖ times as large.
TEST(TextureFromPhotograph, AttenuatesShortWavesByTheTilt) {
  TextureRecipe recipe = linear_recipe();
  const auto height_of = [&recipe](double part) {
    const GreyImage along_x = waves(part * recipe.gaussian_wavelength_m, 0.10);
    GreyImage both = waves(0.25 * recipe.gaussian_wavelength_m, 0.10);
    for (std::size_t i = 0; i < both.values.size(); ++i) {
      both.values[i] = 0.5F * (both.values[i] + along_x.values[i]);
    }
    return both;
  };
  const GreyImage two = height_of(0.5);
  const auto ratio_at = [&](double tilt) {
    recipe.spectral_tilt = tilt;
    const HeightField field = texture_from_photograph(two, recipe, "waves").field;
    const auto part_of = [&](double wavelength_m) {
      double cosine = 0.0;
      double sine = 0.0;
      for (std::size_t j = 0; j < field.grid().columns; ++j) {
        const double phase = 2.0 * std::numbers::pi * (static_cast<double>(j) + 0.5) *
                             field.grid().pitch_m / wavelength_m;
        cosine += static_cast<double>(field.heights_m()[j]) * std::cos(phase);
        sine += static_cast<double>(field.heights_m()[j]) * std::sin(phase);
      }
      return std::hypot(cosine, sine);
    };
    return part_of(0.5 * recipe.gaussian_wavelength_m) /
           part_of(0.25 * recipe.gaussian_wavelength_m);
  };
  const double untilted = ratio_at(0.0);
  EXPECT_NEAR(untilted, (1.0 - std::exp(-2.0)) / (1.0 - std::exp(-8.0)), 2e-3);
  EXPECT_NEAR(ratio_at(0.5) / untilted, std::sqrt(2.0), 2e-3);
  EXPECT_NEAR(ratio_at(1.0) / untilted, 2.0, 2e-3);
}

TEST(TextureFromPhotograph, ScalesToTheAskedRmsWithMeanZeroAndTheWidthsPitch) {
  TextureRecipe recipe;
  recipe.rms_m = 3e-5;
  recipe.width_m = 0.05;
  const HeightField field = texture_from_photograph(waves(0.003, 0.05), recipe, "waves").field;
  EXPECT_NEAR(field.rms_m(), 3e-5, 1e-9);
  EXPECT_NEAR(field.mean_m(), 0.0, 1e-10);
  EXPECT_DOUBLE_EQ(field.grid().pitch_m, 0.05 / kSide);
}

TEST(TextureFromPhotograph, MakesBrightHighUnlessTheSignIsTurned) {
  const GreyImage image = waves(0.004, 0.10);
  TextureRecipe recipe;
  const HeightField high = texture_from_photograph(image, recipe, "waves").field;
  recipe.sign = HeightSign::dark_is_high;
  const HeightField low = texture_from_photograph(image, recipe, "waves").field;
  EXPECT_GT(correlation(high.heights_m(), image.values), 0.95);
  EXPECT_NEAR(correlation(high.heights_m(), low.heights_m()), -1.0, 1e-6);
}

// A bright left and a dark right half: without reflection the right half would look at the left
// one's brightness across the border, and the border would become a cliff as high as the step.
TEST(TextureFromPhotograph, DoesNotLookAcrossTheBorder) {
  GreyImage image{kSide, kSide, {}};
  for (std::size_t i = 0; i < kSide; ++i) {
    for (std::size_t j = 0; j < kSide; ++j) image.values.push_back(j < kSide / 2 ? 0.8F : 0.2F);
  }
  const PhotographTexture texture = texture_from_photograph(image, linear_recipe(), "step");
  EXPECT_NEAR(texture.low_pass.values[kSide * 200], 0.8, 1e-3);
  EXPECT_NEAR(texture.low_pass.values[kSide * 200 + kSide - 1], 0.2, 1e-3);
}

// 397 is a prime: the transform has to go by another size.
TEST(TextureFromPhotograph, TakesAnyShapeOfPicture) {
  const TextureRecipe recipe = linear_recipe();
  for (const std::size_t rows : {std::size_t{16}, std::size_t{397}, std::size_t{1200}}) {
    const PhotographTexture texture =
        texture_from_photograph(waves(0.004, 0.10, rows), recipe, "waves");
    EXPECT_EQ(texture.field.grid().rows, rows);
    EXPECT_EQ(texture.field.grid().columns, kSide);
    // Alike in all rows, as the picture is.
    EXPECT_NEAR(texture.field.heights_m()[7], texture.field.heights_m()[(rows - 1) * kSide + 7],
                1e-8);
  }
}

TEST(TextureFromPhotograph, EqualizesBrightnessToItsShareOfPixels) {
  GreyImage image{16, 16, {}};
  for (int i = 0; i < 256; ++i) image.values.push_back(i < 64 ? 0.1F : i < 192 ? 0.2F : 0.9F);
  TextureRecipe recipe;
  recipe.width_m = 0.01;
  recipe.histogram = HistogramTransformation::equalize;
  const GreyImage grey = texture_from_photograph(image, recipe, "three").grey;
  EXPECT_NEAR(grey.values[0], 0.125, 1e-6);    // the middle of the lowest quarter
  EXPECT_NEAR(grey.values[100], 0.5, 1e-6);    // of the next half
  EXPECT_NEAR(grey.values[255], 0.875, 1e-6);  // of the highest quarter
}

TEST(TextureFromPhotograph, GivesTheSameHeightsEveryTime) {
  const GreyImage image = waves(0.0037, 0.10);
  EXPECT_EQ(texture_from_photograph(image, {}, "a").field.heights_m(),
            texture_from_photograph(image, {}, "b").field.heights_m());
}

TEST(TextureFromPhotograph, RefusesAPictureWithoutContrast) {
  for (const float level : {0.0F, 0.3F, 1.0F}) {
    const GreyImage flat{128, 128, std::vector<float>(128 * 128, level)};
    EXPECT_THAT(texture_refusal(flat, {}), HasSubstr("wall.png has no contrast"));
  }
  GreyImage broken = waves(0.004, 0.10);
  broken.values[5] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(texture_refusal(broken, {}), HasSubstr("no contrast"));
}

TEST(TextureFromPhotograph, RefusesAPictureThatIsTooSmall) {
  const GreyImage small{15, 64, std::vector<float>(15 * 64, 0.5F)};
  EXPECT_THAT(texture_refusal(small, {}),
              HasSubstr("wall.png is 64 by 15 pixels; a texture needs at least"));
}

TEST(TextureFromPhotograph, RefusesAFieldOfTheRecipeByItsName) {
  const GreyImage image = waves(0.004, 0.10);
  const auto refusal_with = [&](auto change) {
    TextureRecipe recipe;
    change(recipe);
    return texture_refusal(image, recipe);
  };
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.width_m = 0.0; }), HasSubstr("width_m is 0"));
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.width_m = NAN; }), HasSubstr("width_m is"));
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.gamma_low = -1.0; }), HasSubstr("gamma_low"));
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.gamma_high = NAN; }), HasSubstr("gamma_high"));
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.rms_m = -1e-4; }), HasSubstr("rms_m"));
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.spectral_tilt = 1.5; }),
              HasSubstr("spectral_tilt is 1.5; it must be a number from 0 to 1"));
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.homomorphic_wavelength_m = 0.0; }),
              HasSubstr("homomorphic_wavelength_m"));
  EXPECT_THAT(refusal_with([](TextureRecipe& r) { r.gaussian_wavelength_m = NAN; }),
              HasSubstr("gaussian_wavelength_m"));
  // 400 pixels over 0.1 m: two pixels are 0.5 mm.
  EXPECT_THAT(
      refusal_with([](TextureRecipe& r) { r.gaussian_wavelength_m = 4e-4; }),
      HasSubstr("wavelengths shorter than two pixels, 5e-04 m. Choose a longer wavelength."));
}

// A hand explores at most a metre, and what is wider was meant in another unit.
TEST(TextureFromPhotograph, RefusesAWidthThatNoHandExplores) {
  const auto refusal_of_width = [](double width_m, std::size_t columns) {
    const GreyImage image{16, columns, std::vector<float>(16 * columns, 0.5F)};
    TextureRecipe recipe;
    recipe.width_m = width_m;
    return texture_refusal(image, recipe);
  };
  EXPECT_THAT(refusal_of_width(4.0, 8000),
              HasSubstr("width_m is 4 m; it must be a number from 0.001 to 1 m; lengths are in "
                        "metres: 4 mm is 0.004. It is the width of the surface in wall.png, from "
                        "its left to its right edge: 4 cm are 0.04 m."));
  EXPECT_THAT(refusal_of_width(100.0, 8000), HasSubstr("100 mm is 0.1. It is the width"));
  EXPECT_THAT(refusal_of_width(0.0009, 8000), HasSubstr("it must be a number from 0.001 to 1 m"));
  EXPECT_THAT(refusal_of_width(0.9, 600),
              HasSubstr("width_m is 0.9 m: each of the 600 pixels of wall.png would be 1.5 mm of "
                        "the surface, and pixels larger than 1 mm cannot represent a texture."));
  EXPECT_THAT(refusal_of_width(0.6, 600), HasSubstr("no contrast")) << "1 mm is acceptable";
}

TEST(TextureRecipe, IsWrittenUnderTheNamesOfTheCommandLine) {
  const ParameterValues values = parameter_values({});
  EXPECT_EQ(number_of(values, "width_m"), 0.10);
  EXPECT_EQ(number_of(values, "gaussian_wavelength_m"), 0.005);
  EXPECT_EQ(number_of(values, "sign"), 1.0);
  EXPECT_EQ(choice_of(values, "histogram"), "none");
}

TEST(WithoutLongWavelengths, KeepsWhatTheGaussianHighPassKeeps) {
  GreyImage image = waves(0.005, 0.10);
  const HeightField field({.rows = kSide, .columns = kSide, .pitch_m = 0.10 / kSide}, image.values);
  const HeightField rest = without_long_wavelengths(field, 0.005);
  EXPECT_NEAR(rest.rms_m() / field.rms_m(), 1.0 - std::exp(-0.5), 2e-3);
  EXPECT_NEAR(rest.mean_m(), 0.0, 1e-6);
}

}  // namespace
}  // namespace asperity
