// Reliefs of known content, rendered by formula: what each method of shape from shading recovers.

#include "stimuli/photographs/shape_from_shading.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>

#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/synthetic_photograph.h"
#include "stimuli/photographs/texture_from_photograph.h"
#include "stimuli/photographs/texture_method.h"
#include "tests/stimuli/correlation.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using std::numbers::pi;
using ::testing::HasSubstr;

constexpr std::size_t kShadedSide = 128;
constexpr LightDirection kFromRight{.azimuth_rad = 0.0, .elevation_rad = pi / 4.0};

GreyImage picture(const std::function<double(double x, double y)>& value) {
  GreyImage image{kShadedSide, kShadedSide, {}};
  for (std::size_t i = 0; i < kShadedSide; ++i) {
    for (std::size_t j = 0; j < kShadedSide; ++j) {
      // Pixels, from the left and from the bottom edge.
      image.values.push_back(static_cast<float>(
          value(static_cast<double>(j) + 0.5, static_cast<double>(kShadedSide - 1 - i) + 0.5)));
    }
  }
  return image;
}

/// h = cos(k_x x) cos(k_y y) with m and n half waves along the sides, which reflection continues without a step.
struct ShadedWave {
  int m = 0;
  int n = 0;

  double k_x() const { return pi * m / static_cast<double>(kShadedSide); }
  double k_y() const { return pi * n / static_cast<double>(kShadedSide); }
  double height(double x, double y) const { return std::cos(k_x() * x) * std::cos(k_y() * y); }
  double slope_x(double x, double y) const {
    return -k_x() * std::sin(k_x() * x) * std::cos(k_y() * y);
  }
};

/// The relief's part of a wave: Σ z w/Σ w².
double part_of(const GreyImage& relief, const ShadedWave& wave) {
  const GreyImage pattern = picture([&](double x, double y) { return wave.height(x, y); });
  double product = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < pattern.values.size(); ++i) {
    product += static_cast<double>(relief.values[i]) * static_cast<double>(pattern.values[i]);
    square += static_cast<double>(pattern.values[i]) * static_cast<double>(pattern.values[i]);
  }
  return product / square;
}

/// Linear shading, r = 1 − (l·∇h) cot σ, of three waves in light from the right: one along the light, one at 45° to it, one
/// across it.
GreyImage shaded_waves(const LightDirection& light, double amplitude) {
  const double cotangent = 1.0 / std::tan(light.elevation_rad);
  return picture([=](double x, double y) {
    double slope = 0.0;
    for (const ShadedWave& wave : {ShadedWave{20, 0}, ShadedWave{12, 12}, ShadedWave{0, 16}})
      slope += wave.slope_x(x, y);
    return 1.0 - amplitude * slope * cotangent;
  });
}

// ĥ is multiplied by cos²φ/(cos²φ + ε²), φ the angle between the wave and the light.
TEST(ShapeFromShading, PentlandRecoversLinearShadingExceptAcrossTheLight) {
  constexpr double kAmplitude = 0.3;
  for (const double elevation_rad : {0.35, pi / 4.0, 1.1}) {
    const LightDirection light{.azimuth_rad = 0.0, .elevation_rad = elevation_rad};
    const GreyImage relief = relief_by_pentland(shaded_waves(light, kAmplitude), light);
    const double square = kPentlandRegularisation * kPentlandRegularisation;
    // The sines of the slopes are continued evenly, as the brightness is: near the border the wave differs.
    EXPECT_NEAR(part_of(relief, {20, 0}), kAmplitude / (1.0 + square), 0.01 * kAmplitude);
    EXPECT_NEAR(part_of(relief, {12, 12}), kAmplitude * 0.5 / (0.5 + square), 0.04 * kAmplitude);
    EXPECT_NEAR(part_of(relief, {0, 16}), 0.0, 0.01 * kAmplitude);
  }
}

TEST(ShapeFromShading, PentlandRisesTowardsTheLight) {
  // A ramp of one period along x: bright where it faces the light on the right, thus where it falls towards the right.
  const GreyImage lit = shaded_waves(kFromRight, 0.3);
  const LightDirection opposite{.azimuth_rad = pi, .elevation_rad = pi / 4.0};
  const GreyImage right = relief_by_pentland(lit, kFromRight);
  const GreyImage left = relief_by_pentland(lit, opposite);
  EXPECT_NEAR(correlation(right.values, left.values), -1.0, 1e-4);
}

/// r of a matt Gaussian bump: R = (1 + p p_s + q q_s)/√(1 + p² + q²).
GreyImage shaded_bump(const LightDirection& light, double height, double radius) {
  const double cotangent = 1.0 / std::tan(light.elevation_rad);
  return picture([=](double x, double y) {
    const double dx = x - 0.5 * kShadedSide;
    const double dy = y - 0.5 * kShadedSide;
    const double h = height * std::exp(-0.5 * (dx * dx + dy * dy) / (radius * radius));
    const double p = -h * dx / (radius * radius);
    const double q = -h * dy / (radius * radius);
    const double towards = -p * std::cos(light.azimuth_rad) - q * std::sin(light.azimuth_rad);
    return (1.0 + towards * cotangent) / std::sqrt(1.0 + p * p + q * q);
  });
}

// Slopes up to 0.3, a bump of 16 pixels, light from eight directions, the diagonals included, where fixed neighbours fail.
TEST(ShapeFromShading, TsaiShahRecoversAGentleBumpWithACorrelationOfMoreThanNineTenths) {
  constexpr double kRadius = 4.0;
  constexpr double kHeight = 2.0;
  const GreyImage bump = picture([](double x, double y) {
    const double dx = x - 0.5 * kShadedSide;
    const double dy = y - 0.5 * kShadedSide;
    return kHeight * std::exp(-0.5 * (dx * dx + dy * dy) / (kRadius * kRadius));
  });
  for (int direction = 0; direction < 8; ++direction) {
    const LightDirection light{.azimuth_rad = direction * pi / 4.0, .elevation_rad = pi / 4.0};
    const GreyImage relief = relief_by_tsai_shah(shaded_bump(light, kHeight, kRadius), light);
    EXPECT_GT(correlation(relief.values, bump.values), 0.9) << direction * 45 << "°";
  }
}

TEST(ShapeFromShading, TsaiShahLeavesLevelGroundLevel) {
  const GreyImage level = picture([](double, double) { return 1.0; });
  for (const float height : relief_by_tsai_shah(level, kFromRight).values) {
    ASSERT_NEAR(height, 0.0, 1e-6);
  }
}

TextureRecipe lit_recipe(const std::string& method) {
  TextureRecipe recipe{};
  recipe.method = method;
  recipe.width_m = 0.03;
  recipe.light_azimuth_deg = 30.0;
  recipe.light_elevation_deg = 45.0;
  return recipe;
}

// In the passband of the pipeline, where the published method has a correlation of 0 (docs/photographs.md).
TEST(ShapeFromShading, RecoversAStoneInLightFromOneSideWhereBrightnessDoesNot) {
  const HeightField surface =
      make_surface("stone", {}, {.width_m = 0.03, .pixels = 256, .seed = 3});
  const GreyImage photograph =
      synthetic_photograph(surface, {.photograph_case = PhotographCase::lambert,
                                     .light_azimuth_rad = pi / 6.0,
                                     .light_elevation_rad = pi / 4.0});
  const std::vector<float> truth =
      without_long_wavelengths(surface, TextureRecipe{}.gaussian_wavelength_m).heights_m();
  const auto correlation_of = [&](const std::string& method) {
    return correlation(
        texture_from_photograph(photograph, lit_recipe(method), "stone").field.heights_m(), truth);
  };
  EXPECT_LT(std::abs(correlation_of("wu")), 0.1);
  EXPECT_LT(std::abs(correlation_of("brightness")), 0.1);
  EXPECT_GT(correlation_of("pentland"), 0.75);
  EXPECT_GT(correlation_of("tsai_shah"), 0.5);
}

std::string light_refusal(const TextureRecipe& recipe) {
  return refusal_of<std::invalid_argument>([&] {
    texture_from_photograph(picture([](double x, double) { return 0.5 + 0.2 * std::sin(x); }),
                            recipe, "wall.png");
  });
}

TEST(ShapeFromShading, RefusesLightThatIsNotOblique) {
  for (const char* method : {"pentland", "tsai_shah"}) {
    TextureRecipe recipe = lit_recipe(method);
    recipe.light_elevation_deg = 71.0;
    EXPECT_THAT(light_refusal(recipe), testing::AllOf(HasSubstr("light_elevation_deg is 71"),
                                                      HasSubstr(method), HasSubstr("lower light")));
    recipe.light_elevation_deg = 9.0;
    EXPECT_THAT(light_refusal(recipe),
                testing::AllOf(HasSubstr("light_elevation_deg is 9"), HasSubstr("higher light")));
    recipe.light_elevation_deg = 70.0;
    EXPECT_EQ(light_refusal(recipe), "");
  }
  TextureRecipe without_light{};
  without_light.width_m = 0.03;
  without_light.light_elevation_deg = 90.0;  // not used
  EXPECT_EQ(light_refusal(without_light), "");
}

TEST(ShapeFromShading, RefusesWhatContradictsTheLight) {
  TextureRecipe recipe = lit_recipe("pentland");
  recipe.sign = HeightSign::dark_is_high;
  EXPECT_THAT(light_refusal(recipe), HasSubstr("add 180 to light_azimuth_deg"));
  recipe = lit_recipe("pentland");
  recipe.histogram = HistogramTransformation::equalize;
  EXPECT_THAT(light_refusal(recipe), HasSubstr("histogram is equalize"));
  recipe = lit_recipe("horn");
  EXPECT_THAT(light_refusal(recipe),
              testing::AllOf(HasSubstr("method is \"horn\""), HasSubstr("wu brightness pentland")));
}

// A sidecar of an earlier version has no method; that of a published recipe is the one of that version.
TEST(TextureMethod, IsStoredOnlyWhereItIsNotThePublishedOne) {
  const ParameterValues published = parameter_values(TextureRecipe{});
  EXPECT_EQ(published.size(), 9U);
  EXPECT_EQ(published.count("method"), 0U);
  EXPECT_EQ(texture_recipe(published).method, kPublishedMethod);
  EXPECT_EQ(parameter_values(texture_recipe(published)), published);
  const TextureRecipe lit = lit_recipe("tsai_shah");
  const ParameterValues values = parameter_values(lit);
  EXPECT_EQ(choice_of(values, "method"), "tsai_shah");
  EXPECT_EQ(number_of(values, "light_azimuth_deg"), 30.0);
  EXPECT_EQ(parameter_values(texture_recipe(values)), values);
  EXPECT_EQ(parameter_values(lit_recipe("brightness")).count("light_azimuth_deg"), 0U);
}

TEST(TextureMethod, HasASummaryAndTheSourceOfThePublishedOnes) {
  for (const TextureMethod& method : texture_methods()) {
    EXPECT_FALSE(method.summary.empty()) << method.id;
    EXPECT_EQ(method.source.empty(), method.id == "brightness") << method.id;
  }
  EXPECT_EQ(texture_methods().front().id, kPublishedMethod);
}

}  // namespace
}  // namespace asperity
