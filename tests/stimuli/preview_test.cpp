// Pictures for people: light from the upper left, one scale, nothing lost in the strip.

#include "stimuli/photographs/preview.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace asperity {
namespace {

// A round hill in the middle of 64 × 64.
HeightField hill(double height_m) {
  std::vector<float> heights_m;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const double distance = std::hypot(i - 31.5, j - 31.5) / 16.0;
      heights_m.push_back(static_cast<float>(height_m * std::exp(-distance * distance)));
    }
  }
  return {{.rows = 64, .columns = 64, .pitch_m = 1e-3}, heights_m};
}

float at(const GreyImage& image, std::size_t row, std::size_t column) {
  return image.values[row * image.columns + column];
}

TEST(ShadedRelief, IsBrightOnTheUpperLeftOfAHillAndDarkOnTheLowerRight) {
  const GreyImage relief = shaded_relief(hill(1e-3));
  EXPECT_GT(at(relief, 23, 23), 0.8F);
  EXPECT_LT(at(relief, 40, 40), 0.2F);
  EXPECT_NEAR(at(relief, 23, 40), 0.5, 0.02);
}

TEST(ShadedRelief, IsTheSlopeOfTheInterpolantTowardsTheLight) {
  const HeightField field = hill(1e-3);
  const GreyImage relief = shaded_relief(field);
  std::vector<double> facing;
  double squares = 0.0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const HeightSample slope =
          field.sample((j - 31.5) * 1e-3, (31.5 - i) * 1e-3, Tiling::bounded);
      facing.push_back(slope.slope_x - slope.slope_y);
      squares += facing.back() * facing.back();
    }
  }
  const double rms = std::sqrt(squares / 4096.0);
  for (std::size_t k = 0; k < facing.size(); ++k) {
    EXPECT_NEAR(relief.values[k], std::clamp(0.5 + 0.2 * facing[k] / rms, 0.0, 1.0), 1e-6);
  }
}

TEST(ShadedRelief, LooksTheSameWhateverTheAmplitude) {
  const GreyImage low = shaded_relief(hill(1e-6));
  const GreyImage high = shaded_relief(hill(1e-3));
  for (std::size_t k = 0; k < low.values.size(); ++k)
    EXPECT_NEAR(low.values[k], high.values[k], 1e-3);
}

TEST(ShadedRelief, IsMidGreyWhereThereIsNone) {
  const HeightField flat({.rows = 4, .columns = 4, .pitch_m = 1.0}, std::vector<float>(16, 1.0F));
  EXPECT_EQ(shaded_relief(flat).values, std::vector<float>(16, 0.5F));
  EXPECT_EQ(height_picture(flat).values, std::vector<float>(16, 0.5F));
}

TEST(HeightPicture, IsBrightWhereItIsHigh) {
  const GreyImage picture = height_picture(hill(1e-3));
  EXPECT_EQ(at(picture, 31, 31), 1.0F);
  EXPECT_EQ(at(picture, 0, 0), 0.0F);
}

TEST(SideBySide, ScalesPicturesToOneHeightWithGapsBetween) {
  const std::vector<GreyImage> pictures{{2, 2, {0.1F, 0.1F, 0.1F, 0.1F}},
                                        {4, 8, std::vector<float>(32, 0.7F)}};
  const GreyImage strip = side_by_side(pictures, 8);
  EXPECT_EQ(strip.rows, 8u);
  EXPECT_EQ(strip.columns, 8u + 6u + 16u);
  EXPECT_NEAR(at(strip, 4, 4), 0.1, 1e-6);
  EXPECT_NEAR(at(strip, 4, 10), 1.0, 1e-6);
  EXPECT_NEAR(at(strip, 4, 20), 0.7, 1e-6);
  EXPECT_THROW(side_by_side({}, 8), std::invalid_argument);
  EXPECT_THROW(side_by_side(pictures, 0), std::invalid_argument);
}

TEST(TextureSteps, ShowsFiveStepsOfOneTexture) {
  const GreyImage photograph = height_picture(hill(1e-3));
  TextureRecipe recipe;
  recipe.width_m = 0.064;
  const GreyImage strip = texture_steps(texture_from_photograph(photograph, recipe, "hill"), 32);
  EXPECT_EQ(strip.rows, 32u);
  EXPECT_EQ(strip.columns, 5u * 32u + 4u * 6u);
}

}  // namespace
}  // namespace asperity
