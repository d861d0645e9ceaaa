// Holds the profile of a line and its spectrum to ridges of known height and spacing.

#include "app/gui/workbench/line_profile.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "stimuli/heights/synthetic_surface.h"

namespace asperity {
namespace {

// 50 µm up and down over 2 mm, along 64 mm: half a wave per mm.
HeightField ridges() {
  return make_surface("sinusoid", {{"amplitude_m", 5e-5}, {"spacing_m", 0.002}},
                      {.width_m = 0.064, .pixels = 512, .seed = 1});
}

TEST(LineProfile, IsTheNearestRowInMicrometresOverMillimetres) {
  const HeightField field = ridges();
  const LineProfile profile = profile_along(field, 0.01);
  ASSERT_EQ(profile.heights.y.size(), 512);
  // Row i lies at y = (255.5 − i)·p with p = 0.125 mm: 0.01 m is between 175 and 176.
  for (int j = 0; j < 512; ++j) {
    EXPECT_NEAR(profile.heights.x[j], 0.125 * j, 1e-9);
    EXPECT_EQ(profile.heights.y[j],
              1e6 * static_cast<double>(field.heights_m()[175U * 512U + static_cast<unsigned>(j)]));
  }
  const auto [low, high] = std::minmax_element(profile.heights.y.begin(), profile.heights.y.end());
  EXPECT_NEAR(*high - *low, 100.0, 2.0);  // 16 samples to a wave may miss its crest by 2 %
}

TEST(LineProfile, HasItsPowerAtTheSpacingOfTheRidges) {
  const LineProfile profile = profile_along(ridges(), 0.0);
  const auto strongest = std::max_element(profile.spectrum.y.begin(), profile.spectrum.y.end()) -
                         profile.spectrum.y.begin();
  EXPECT_NEAR(profile.spectrum.x[strongest], 0.5, 1e-9);
  double power_um2 = 0.0;  // of a sine: half of the square of its amplitude
  for (const double density : profile.spectrum.y) power_um2 += density * profile.spectrum.x[0];
  EXPECT_NEAR(power_um2, 0.5 * 50.0 * 50.0, 0.02 * 1250.0);
}

TEST(LineProfile, StaysOnTheReliefWhateverIsPointedAt) {
  const HeightField field = ridges();
  EXPECT_EQ(profile_along(field, 1.0).heights.y, profile_along(field, 0.03194).heights.y);
  EXPECT_EQ(profile_along(field, -1.0).heights.y, profile_along(field, -0.03194).heights.y);
}

}  // namespace
}  // namespace asperity
