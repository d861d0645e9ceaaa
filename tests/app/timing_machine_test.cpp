// When times on a machine are not those of the program.

#include "app/timing/timing_machine.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(TimingMachine, IsFitWithAReleaseBuildAndLittleLoad) {
  EXPECT_THAT(timing_warnings({.load_per_core = 0.5, .build = "Release"}), IsEmpty());
}

TEST(TimingMachine, WarnsOfAnotherBuildAndOfLoad) {
  EXPECT_THAT(
      timing_warnings({.load_per_core = 0.5, .build = "Debug"}),
      ElementsAre(HasSubstr("the build type Debug, whose ticks take longer; measure with")));
  EXPECT_THAT(timing_warnings({.load_per_core = 1.5, .build = "Release"}),
              ElementsAre(HasSubstr("load average 1.5 per core); end them")));
}

TEST(TimingMachine, NamesTheProcessorAndTheProgram) {
  const TimingMachine machine = this_machine();
  EXPECT_FALSE(machine.processor.empty());
  EXPECT_GE(machine.cores, 1U);
  EXPECT_THAT(machine.program, HasSubstr("asperity 0."));
}

}  // namespace
}  // namespace asperity
