// Names the true size of a test where simulated studies without an effect show that it is not 5 %.

#include "app/power/curve/true_size.h"

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Of 1000 studies with 20 participants: three standard errors are 2.07 percentage points.
std::string text_of(std::uint64_t significant, const std::string& test = "right") {
  const PowerCurve curve{.effect = "sensitivity=0", .family = "right, textures", .test = test};
  return true_size_text(curve, {.power = {.participants = 20,
                                          .power = static_cast<double>(significant) / 1000.0,
                                          .interval = {.low = 0.0211, .high = 0.0879}},
                                .studies = 1000,
                                .significant = significant});
}

TEST(TrueSize, IsNamedWhereItDiffersByThreeStandardErrors) {
  EXPECT_EQ(text_of(29),
            "without an effect, the test right is significant in 2.9 % of the studies with 20 "
            "participants, 95 % Monte-Carlo CI [2.1, 8.8]: its true size is below the level of "
            "significance");
  EXPECT_EQ(text_of(30), "");
  EXPECT_EQ(text_of(50), "");
  EXPECT_EQ(text_of(70), "");
  EXPECT_EQ(text_of(71, ""),
            "without an effect, the family right, textures is significant in 7.1 % of the studies "
            "with 20 participants, 95 % Monte-Carlo CI [2.1, 8.8]: its true size exceeds the level "
            "of significance");
}

}  // namespace
}  // namespace asperity
