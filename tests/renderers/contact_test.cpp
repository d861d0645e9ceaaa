// When a probe is in contact with a surface.

#include "renderers/servo/contact.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TickRecord rendered_tick(double penetration_m, double gain) {
  TickRecord record{};
  record.presentation = 2;
  record.flags = static_cast<std::uint32_t>(TickFlag::presenting);
  record.penetration_m = penetration_m;
  record.gain = gain;
  return record;
}

TEST(Contact, IsAPenetrationAboveZero) {
  EXPECT_TRUE(is_in_contact(rendered_tick(1e-9, 1.0)));
  EXPECT_FALSE(is_in_contact(rendered_tick(0.0, 1.0)));
  EXPECT_FALSE(is_in_contact(rendered_tick(std::numeric_limits<double>::quiet_NaN(), 1.0)));
  EXPECT_TRUE(is_in_contact(RenderedTick{.penetration_m = 1e-9}));
  EXPECT_FALSE(is_in_contact(RenderedTick{}));
}

TEST(Contact, RequiresThatASurfaceWasRendered) {
  TickRecord record = rendered_tick(1e-3, 1.0);
  record.flags = 0;
  EXPECT_FALSE(is_in_contact(record));
  EXPECT_FALSE(is_rendered(record, 2));
  EXPECT_FALSE(measures_hand(record));
}

TEST(Contact, BelongsToOnePresentation) {
  EXPECT_TRUE(is_in_contact(rendered_tick(1e-3, 1.0), 2));
  EXPECT_FALSE(is_in_contact(rendered_tick(1e-3, 1.0), 1));
  EXPECT_TRUE(is_rendered(rendered_tick(0.0, 1.0), 2));
  EXPECT_FALSE(is_rendered(rendered_tick(0.0, 1.0), 1));
}

TEST(Contact, MeasuresTheHandAtFullGainOnly) {
  EXPECT_TRUE(measures_hand(rendered_tick(1e-3, 1.0)));
  EXPECT_FALSE(measures_hand(rendered_tick(1e-3, 0.999)));
  EXPECT_FALSE(measures_hand(rendered_tick(0.0, 1.0)));
}

// A gap that ends a contact for the filter may be a crest, and one that ends a touch may be a skip.
TEST(Contact, ContinuesOverLongerGapsTheMoreTheQuestionAllows) {
  EXPECT_LT(kUnbroken_ticks / 1000.0, kLift_s);
  EXPECT_LT(kLift_s, kSkip_s);
}

}  // namespace
}  // namespace asperity
