// Programs that are run to their end: what they print, and the error of one that fails.

#include "app/processes/finished_command.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::filesystem::path script_in(const TemporaryFolder& folder, const std::string& name,
                                const std::string& text) {
  const std::filesystem::path file = folder / name;
  std::ofstream(file) << "#!/bin/sh\n" << text;
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

TEST(FinishedCommand, PassesEveryArgumentAsItIs) {
  const TemporaryFolder folder;
  const auto program =
      script_in(folder, "arguments", R"(for word; do printf '<%s>\n' "$word"; done)");
  EXPECT_EQ(output_of({program, {"a b", "", "$HOME", "*", "\"'", "--x=1;2"}}, "none"),
            "<a b>\n<>\n<$HOME>\n<*>\n<\"'>\n<--x=1;2>\n");
}

// More than the 64 KiB that a pipe holds, and its reader keeps.
TEST(FinishedCommand, ReturnsALongOutputWhole) {
  const TemporaryFolder folder;
  const auto program = script_in(folder, "long",
                                 "i=0; while [ $i -lt 4000 ]; do\n"
                                 "echo 0123456789012345678901234567890123456789012345678; "
                                 "i=$((i + 1)); done");
  EXPECT_EQ(output_of({program, {}}, "none").size(), 4000U * 50U);
}

TEST(FinishedCommand, NamesCommandStatusFirstLineAndRemedyOfAFailure) {
  const TemporaryFolder folder;
  const auto program = script_in(
      folder, "sbatch", "echo 4711; echo 'error: no partition' >&2; echo more >&2; exit 3");
  EXPECT_EQ(refusal_of([&] {
              output_of({program, {"--partition", "a b"}}, "name another one");
            }),
            "the command \"sbatch --partition \"a b\"\" failed with exit status 3: \"error: no "
            "partition\"; name another one");
}

TEST(FinishedCommand, NamesTheSignalThatEndedAProgram) {
  const TemporaryFolder folder;
  const auto program = script_in(folder, "ends", "kill -9 $$");
  EXPECT_THAT(refusal_of([&] {
                output_of({program, {}}, "repeat it");
              }),
              AllOf(HasSubstr("was ended by signal 9"), HasSubstr("; repeat it")));
}

TEST(FinishedCommand, StatesWhyAProgramCannotBeStarted) {
  const TemporaryFolder folder;
  EXPECT_EQ(refusal_of([&] {
              output_of({folder / "missing", {}}, "install it");
            }),
            "the command \"missing\" cannot be started (No such file or directory); install it");
}

TEST(FinishedCommand, FindsTheFirstExecutableFileOfASearchPath) {
  const TemporaryFolder folder;
  for (const char* const name : {"plain", "first", "second"}) {
    std::filesystem::create_directory(folder / name);
    script_in(folder, std::string(name) + "/squeue", "");
  }
  std::filesystem::permissions(folder / "plain" / "squeue", std::filesystem::perms::owner_read);
  const auto in = [&](const char* name) { return (folder / name).string(); };
  EXPECT_EQ(program_in(in("none") + "::" + in("plain") + ':' + in("first") + ':' + in("second"),
                       "squeue"),
            folder / "first" / "squeue");
  EXPECT_EQ(program_in(in("first"), "sbatch"), std::nullopt);
  EXPECT_EQ(program_in("", "squeue"), std::nullopt);
}

}  // namespace
}  // namespace asperity
