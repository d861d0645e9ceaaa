// The progress of a command where standard error is no terminal.

#include <chrono>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "app/cli/output/terminal.h"

namespace asperity {
namespace {

std::string lines_of(std::optional<std::chrono::steady_clock::duration> between) {
  testing::internal::CaptureStderr();
  {
    Progress progress("checking", between);
    for (const double fraction : {0.0, 0.05, 0.12, 0.19, 0.47}) progress.show(fraction);
  }
  return testing::internal::GetCapturedStderr();
}

TEST(ShownProgress, IsALineEveryTenth) {
  EXPECT_EQ(lines_of({}), "checking: 0 %\nchecking: 10 %\nchecking: 40 %\n");
}

TEST(ShownProgress, IsNoLineBeforeTheTimeBetweenLinesHasPassed) {
  EXPECT_EQ(lines_of(std::chrono::hours(1)), "");
  EXPECT_EQ(lines_of(std::chrono::seconds(0)),
            "checking: 0 %\nchecking: 5 %\nchecking: 12 %\nchecking: 19 %\nchecking: 47 %\n");
}

}  // namespace
}  // namespace asperity
