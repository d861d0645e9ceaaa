// A written file is the old one or the new one.

#include "results_schema/atomic_file.h"

#include <algorithm>
#include <iterator>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "results_schema/study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

std::ptrdiff_t files_in(const TemporaryFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

TEST(AtomicFile, HoldsWhatWasWritten) {
  const TemporaryFolder folder;
  const std::string content("a\0b\r\n", 5);
  write_file(folder / "file", content, Overwrite::refuse);
  EXPECT_EQ(read_file(folder / "file"), content);
  EXPECT_EQ(files_in(folder), 1);
}

TEST(AtomicFile, RefusesToOverwriteUnlessTold) {
  const TemporaryFolder folder;
  write_file(folder / "file", "old", Overwrite::refuse);
  EXPECT_THROW(write_file(folder / "file", "new", Overwrite::refuse), ResultsError);
  EXPECT_EQ(read_file(folder / "file"), "old");
  write_file(folder / "file", "new", Overwrite::allow);
  EXPECT_EQ(read_file(folder / "file"), "new");
  EXPECT_EQ(files_in(folder), 1);
}

TEST(AtomicFile, NamesAMissingFolder) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal_of<ResultsError>(
                  [&] { write_file(folder.path() / "absent" / "file", "x", Overwrite::allow); }),
              testing::HasSubstr("there is no folder"));
}

TEST(AtomicFile, RefusesToReplaceAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "file");
  EXPECT_THROW(write_file(folder / "file", "x", Overwrite::allow), ResultsError);
  EXPECT_THROW(read_file(folder / "file"), ResultsError);
  EXPECT_EQ(files_in(folder), 1);
}

// A limit on the size of files fails a write in its middle, as a full disk does.
TEST(AtomicFile, LeavesTheOldFileAndNothingElseWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  write_file(folder / "file", "old", Overwrite::refuse);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = ::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = refusal_of<ResultsError>(
      [&] { write_file(folder / "file", std::string(5000, 'x'), Overwrite::allow); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, old_handler);
  EXPECT_NE(message.find("disk is full"), std::string::npos) << message;
  EXPECT_EQ(read_file(folder / "file"), "old");
  EXPECT_EQ(files_in(folder), 1);
}

TEST(AtomicFile, NamesAnAbsentFile) {
  const TemporaryFolder folder;
  try {
    read_file(folder / "absent");
    FAIL();
  } catch (const ResultsError& error) {
    EXPECT_EQ(error.path(), folder / "absent");
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos);
  }
}

}  // namespace
}  // namespace asperity
