// A Falcon that is unplugged now and then, for as long as a session.

#include <gtest/gtest.h>

#include "tests/device/falcon_run.h"

namespace asperity {
namespace {

TEST(FalconForLong, LosesNothingInAMinuteWithThreeUnplugs) {
  EmulatedBus bus;
  run_in_real_time(bus, std::chrono::minutes(1), 3);
}

TEST(FalconForLong, LosesNothingInTenMinutesWithTwentyUnplugs) {
  EmulatedBus bus;
  run_in_real_time(bus, std::chrono::minutes(10), 20);
}

}  // namespace
}  // namespace asperity
