// The first part of the depth, over which textures fade in.

#include "renderers/force/contact_fade.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace asperity {
namespace {

// u²(3 − 2u) at a quarter, half and three quarters of 0.1 mm.
TEST(ContactFade, RisesFromNothingToAllWithinATenthOfAMillimetre) {
  EXPECT_EQ(contact_fade(-1e-3), 0.0);
  EXPECT_EQ(contact_fade(0.0), 0.0);
  EXPECT_NEAR(contact_fade(25e-6), 0.15625, 1e-12);
  EXPECT_NEAR(contact_fade(50e-6), 0.5, 1e-12);
  EXPECT_NEAR(contact_fade(75e-6), 0.84375, 1e-12);
  EXPECT_EQ(contact_fade(1e-4), 1.0);
  EXPECT_EQ(contact_fade(1.0), 1.0);
}

// By at most 1.5·v·T/w₀ in a tick, and by nearly as much in the middle: three quarters at 50 mm/s and 1 kHz, wherever the first
// tick of the contact is.
TEST(ContactFade, GrowsInATickByNoMoreThanTheHandComesDown) {
  for (const double step_m : {1e-6, 5e-6, 20e-6, 50e-6}) {
    double largest = 0.0;
    for (double first_m = 0.0; first_m < 1.1e-4; first_m += 1e-7) {
      largest = std::max(largest, contact_fade(first_m) - contact_fade(first_m - step_m));
    }
    EXPECT_LE(largest, 1.5 * step_m / kContactFade_m);
    EXPECT_GT(largest, 1.3 * step_m / kContactFade_m);
  }
}

}  // namespace
}  // namespace asperity
