// What asperity new prints: the study, and the rule about versions.

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity::test {
namespace {

/// "0.2.0", of "asperity 0.2.0 (commit …)".
std::string version_of_program() {
  const std::string line = asperity({"--version"}).out;
  const std::size_t from = std::string("asperity ").size();
  return line.substr(from, line.find(' ', from) - from);
}

TEST(New, PrintsTheStudyAndThatItIsFinishedWithThisVersion) {
  const TemporaryFolder folder;
  const std::string study = folder / "study";
  const std::string rule = "\nThis is version " + version_of_program() +
                           ". Before 1.0.0, finish a study with the version that began it; the "
                           "package of each version stays available.\n";
  const Outcome made = asperity({"new", study});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.out, "created the study " + study + rule);
  EXPECT_EQ(made.err, "");
  const auto files = contents_of(study);
  const Outcome again = asperity({"new", study});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.out, "an earlier command created the unused study " + study + rule);
  EXPECT_TRUE(contents_of(study) == files);
}

}  // namespace
}  // namespace asperity::test
