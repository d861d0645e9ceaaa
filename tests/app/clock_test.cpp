// Times as they are stored.

#include "app/session/rig/clock.h"

#include <gtest/gtest.h>

#include "app/words/utc_time.h"

namespace asperity {
namespace {

TEST(UtcText, IsADateAndATimeWithMilliseconds) {
  EXPECT_EQ(utc_text(0), "1970-01-01T00:00:00.000Z");
  EXPECT_EQ(utc_text(1'767'225'600'042'999'999), "2026-01-01T00:00:00.042Z");
}

// What a machine shows whose clock has lost its battery, in a zone west of Greenwich.
TEST(UtcText, CountsMillisecondsForwardBefore1970Too) {
  EXPECT_EQ(utc_text(-1), "1969-12-31T23:59:59.999Z");
  EXPECT_EQ(utc_text(-758'000'000), "1969-12-31T23:59:59.242Z");
  EXPECT_EQ(utc_text(-1'000'000'000), "1969-12-31T23:59:59.000Z");
  EXPECT_EQ(utc_text(-31'535'997'758'000'000), "1969-01-01T00:00:02.242Z");
}

}  // namespace
}  // namespace asperity
