// The recommended method and the warning about the sign, for photographs of known surfaces.

#include "stimuli/photographs/photograph_advice.h"

#include <numbers>

#include <gmock/gmock.h>

#include "stimuli/heights/synthetic_surface.h"
#include "stimuli/photographs/synthetic_photograph.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

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

TEST(PhotographAdvice, RecommendsAMethodForTheLightThatTheUserStates) {
  EXPECT_STREQ(recommended_method(PhotographLight::even).method, "brightness");
  EXPECT_EQ(recommended_method(PhotographLight::even).spectral_tilt, 0.5);
  EXPECT_STREQ(recommended_method(PhotographLight::one_lamp).method, "pentland");
  EXPECT_EQ(recommended_method(PhotographLight::one_lamp).spectral_tilt, 0.0);
}

// Measured surfaces under one lamp had an anisotropy of 0.14 to 0.24, and a grain has a greater one in any light: the number
// decides nothing, and the question is the same for every picture.
TEST(PhotographAdvice, AsksAboutTheLightWhateverTheAnisotropy) {
  for (const double anisotropy : {0.0, 0.14, 0.24, 0.9}) {
    EXPECT_THAT(
        recommendation_text({.anisotropy = anisotropy, .direction_rad = std::numbers::pi / 3.0},
                            {}),
        testing::AllOf(
            StartsWith("Did the light come from one lamp at the side?"),
            HasSubstr("If not, recommended: --method brightness --spectral-tilt 0.5, because"),
            HasSubstr("If so, recommended: --method pentland --light-azimuth-deg A"),
            HasSubstr("along 60° and -120°")))
        << anisotropy;
  }
}

TEST(PhotographAdvice, ConfirmsTheRecommendedMethodWhereItIsSet) {
  TextureRecipe recipe{};
  recipe.method = "brightness";
  recipe.spectral_tilt = 0.5;
  const std::string set = recommendation_text({}, recipe);
  EXPECT_THAT(set, HasSubstr("If not, the method is the recommended one"));
  EXPECT_THAT(set, HasSubstr("If so, recommended: --method pentland"));
  recipe.spectral_tilt = 0.0;
  EXPECT_THAT(recommendation_text({}, recipe),
              HasSubstr("If not, recommended: --method brightness --spectral-tilt 0.5"));
}

TEST(PhotographAdvice, HasTheDirectionOfTheLampOrTheOppositeOne) {
  EXPECT_NEAR(direction_deg(evidence_of(PhotographCase::lambert)), 60.0, 5.0);
  EXPECT_EQ(opposite_deg(60.0), -120.0);
  EXPECT_EQ(opposite_deg(-30.0), 150.0);
  EXPECT_EQ(opposite_deg(0.0), 180.0);
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
