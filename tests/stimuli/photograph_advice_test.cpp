// The recommended method and the warning about the sign, for photographs of known surfaces.

#include "stimuli/photographs/photograph_advice.h"

#include <numbers>

#include <gmock/gmock.h>

#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/synthetic_photograph.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;

PhotographEvidence evidence_of(PhotographCase photograph_case) {
  const HeightField surface =
      make_surface("stone", {}, {.width_m = 0.05, .pixels = 256, .seed = 3});
  TextureRecipe recipe{};
  recipe.width_m = 0.05;
  return examine_photograph(
      synthetic_photograph(surface, {.photograph_case = photograph_case,
                                     .light_azimuth_rad = std::numbers::pi / 3.0}),
      recipe, "stone");
}

TEST(PhotographAdvice, RecommendsShapeFromShadingInLightFromOneSide) {
  const MethodRecommendation found = recommended_method(evidence_of(PhotographCase::lambert));
  EXPECT_EQ(found.reason, RecommendationReason::one_direction);
  EXPECT_EQ(found.method, "pentland");
  EXPECT_EQ(found.spectral_tilt, 0.0);
  EXPECT_NEAR(found.direction_deg, 60.0, 5.0);
  EXPECT_GT(found.anisotropy, 0.4);
  MethodRecommendation rounded = found;
  rounded.direction_deg = 60.0;
  EXPECT_THAT(recommendation_text(rounded),
              testing::AllOf(HasSubstr("--method pentland --light-azimuth-deg 60 (or -120"),
                             HasSubstr("--method brightness --spectral-tilt 0.5")));
}

TEST(PhotographAdvice, RecommendsTiltedBrightnessInEvenLight) {
  const MethodRecommendation found = recommended_method(evidence_of(PhotographCase::bright_height));
  EXPECT_EQ(found.reason, RecommendationReason::no_direction);
  EXPECT_EQ(found.method, "brightness");
  EXPECT_EQ(found.spectral_tilt, kRecommendedTilt);
  EXPECT_THAT(recommendation_text(found),
              HasSubstr("--method brightness --spectral-tilt 0.5, because"));
}

TEST(PhotographAdvice, FindsASignThatTheSkewnessContradicts) {
  TextureRecipe recipe{};
  const PhotographEvidence grooves{.skewness = -0.6};
  const PhotographEvidence spots{.skewness = 0.6};
  EXPECT_EQ(contradiction_of_sign(grooves, recipe), std::nullopt);
  EXPECT_EQ(contradiction_of_sign(spots, recipe), SignContradiction::bright_spots_raised);
  EXPECT_EQ(contradiction_of_sign({.skewness = 0.1}, recipe), std::nullopt);
  recipe.sign = HeightSign::dark_is_high;
  EXPECT_EQ(contradiction_of_sign(grooves, recipe), SignContradiction::dark_grooves_raised);
  EXPECT_EQ(contradiction_of_sign(spots, recipe), std::nullopt);
  EXPECT_THAT(contradiction_text(SignContradiction::dark_grooves_raised, grooves),
              testing::AllOf(HasSubstr("skewness -0.6"), HasSubstr("--sign 1")));
  EXPECT_THAT(contradiction_text(SignContradiction::bright_spots_raised, spots),
              testing::AllOf(HasSubstr("skewness 0.6"), HasSubstr("--sign -1")));
}

TEST(PhotographAdvice, LeavesTheSignToTheLightInShapeFromShading) {
  TextureRecipe recipe{};
  recipe.method = "pentland";
  EXPECT_EQ(contradiction_of_sign({.skewness = 1.0}, recipe), std::nullopt);
}

}  // namespace
}  // namespace asperity
