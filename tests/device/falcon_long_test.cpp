// A Falcon that is unplugged now and then, for as long as a session.

#include <gtest/gtest.h>

#include "tests/device/falcon_run.h"

namespace asperity {
namespace {

TEST(FalconForLong, LosesNothingInTenMinutesWithTwentyUnplugs) {
  EmulatedBus bus;
  run_with_unplugs(bus, std::chrono::minutes(10), 20);
}

}  // namespace
}  // namespace asperity
