// Output that nobody reads any more.

#include <fcntl.h>
#include <optional>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;

/// A pipe that nobody reads, in place of this file of the child.
void nobody_reads(int file) {
  int ends[2] = {};
  if (::pipe2(ends, O_CLOEXEC) != 0) ::_exit(125);
  ::close(ends[0]);
  ::dup2(ends[1], file);
}

/// Of a program that SIGPIPE has ended, as a shell states it.
constexpr int kUnread = 141;

TEST(OutputThatNobodyReads, EndsACommandSilently) {
  for (const char* const what : {"models", "--help"}) {
    const Outcome unread =
        run({.arguments = {what}, .in_child = [] { nobody_reads(STDOUT_FILENO); }});
    EXPECT_EQ(unread.status, kUnread) << what;
    EXPECT_EQ(unread.err, "") << what;
  }
}

TEST(OutputThatCannotBeWritten, IsAnError) {
  const Outcome full = run({.arguments = {"models"}, .in_child = [] {
                              ::dup2(::open("/dev/full", O_WRONLY), STDOUT_FILENO);
                            }});
  EXPECT_EQ(full.signal, std::nullopt);
  EXPECT_EQ(full.status, 1);
  EXPECT_THAT(full.err, HasSubstr("the output is incomplete"));
}

// What has changed a study is not repeated for what it printed.
TEST(OutputThatNobodyReads, OfACommandWithALastingEffectIsOnStandardError) {
  const SmallStudy small(1);
  const auto unread = [](std::vector<std::string> arguments) {
    return run(
        {.arguments = std::move(arguments), .in_child = [] { nobody_reads(STDOUT_FILENO); }});
  };
  const Outcome simulated = unread({"simulate", small.selection(), "--study", small.study(),
                                    "--participants", "1", "--seed", "1", "--json"});
  EXPECT_EQ(simulated.status, 1);
  EXPECT_THAT(simulated.err, HasSubstr("need not be repeated"));
  EXPECT_THAT(simulated.err, HasSubstr("\"sessions\": 1"));
  const auto tables = exported(small.study(), small.place() / "out");
  EXPECT_EQ(tsv(tables.at("sessions.tsv")).column("state"), std::vector<std::string>{"completed"});

  const Outcome withdrawn =
      unread({"withdraw", small.study(), "virtual0001", "--delete", "--confirm", "virtual0001"});
  EXPECT_EQ(withdrawn.status, 1);
  EXPECT_THAT(withdrawn.err, HasSubstr((small.place() / "out").string())) << "the list of outputs";
}

// As of `2>&1 | head`, once head has seen enough.
TEST(OutputThatNobodyReads, DoesNotEndASession) {
  const SmallStudy small(1);
  const Outcome outcome =
      run({.arguments = {"run", small.selection(), "--study", small.study(), "--participant",
                         "virtual1", "--virtual", "--seed", "1"},
           .in_child = [] { nobody_reads(STDERR_FILENO); }});
  EXPECT_EQ(outcome.signal, std::nullopt);
  EXPECT_EQ(outcome.status, 0);
  const auto tables = exported(small.study(), small.place() / "out");
  EXPECT_EQ(tsv(tables.at("sessions.tsv")).column("state"), std::vector<std::string>{"completed"});
}

}  // namespace
}  // namespace asperity::test
