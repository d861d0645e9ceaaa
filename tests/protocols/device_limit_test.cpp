// A limit from a command line is one that a protocol could have.

#include "protocols/file/device_limit.h"

#include <limits>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Optional;

TEST(DeviceLimit, IsRefusedWhereAProtocolRefusesIt) {
  const auto complaint = [](const char* item, double limit) -> std::optional<std::string> {
    const auto found = complaint_about({.item = item, .limit = limit}, 1000.0);
    return found ? std::optional(found->english()) : std::nullopt;
  };
  EXPECT_EQ(complaint("friction_N", 0.2), std::nullopt);
  EXPECT_EQ(complaint("missed_deadlines", 3.0), std::nullopt);
  EXPECT_EQ(complaint("rate_Hz", 1000.0), std::nullopt);
  EXPECT_NE(complaint("force_zero_N", 1.0), std::nullopt) << "it is kept or not";
  EXPECT_THAT(complaint("fricton_N", 1.0), Optional(HasSubstr("did you mean \"friction_N\"?")));
  EXPECT_THAT(complaint("friction_N", -1.0), Optional(HasSubstr("at least 0")));
  EXPECT_NE(complaint("missed_deadlines", 2.5), std::nullopt);
  EXPECT_NE(complaint("resonance_Hz", 99999.0), std::nullopt);
  EXPECT_THAT(complaint("rate_Hz", 1500.0), Optional(HasSubstr("cannot reach")));
  for (const double none :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(complaint("friction_N", none), Optional(HasSubstr("finite")));
  }
}

}  // namespace
}  // namespace asperity
