// A written file is the old one or the new one.

#include "results_schema/files/atomic_file.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "tests/results_schema/rename_watch.h"
#include "tests/results_schema/sync_watch.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

std::ptrdiff_t files_in(const TemporaryFolder& folder) {
  return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

/// The folder, and files in it whose names begin with these and have further characters.
testing::Matcher<std::set<std::filesystem::path>> synced_as(
    const TemporaryFolder& folder, const std::vector<std::string>& beginnings) {
  std::vector<testing::Matcher<std::filesystem::path>> paths{folder.path()};
  for (const std::string& beginning : beginnings) {
    paths.push_back(
        testing::ResultOf([](const std::filesystem::path& path) { return path.string(); },
                          testing::AllOf(testing::StartsWith((folder / beginning).string()),
                                         testing::EndsWith(".tmp"))));
  }
  return testing::UnorderedElementsAreArray(paths);
}

TEST(AtomicFile, HoldsWhatWasWritten) {
  const TemporaryFolder folder;
  const std::string content("a\0b\r\n", 5);
  write_file(folder / "file", content, Overwrite::refuse);
  EXPECT_EQ(read_file(folder / "file"), content);
  EXPECT_EQ(files_in(folder), 1);
}

// The content first, while the file still has another name; then the name.
TEST(AtomicFile, IsOnTheDiskBeforeItGetsItsName) {
  for (const bool is_new : {true, false}) {
    const TemporaryFolder folder;
    if (!is_new) write_file(folder / "file", "old", Overwrite::refuse);
    const SyncWatch watch;
    write_file(folder / "file", "new", is_new ? Overwrite::refuse : Overwrite::allow);
    EXPECT_THAT(watch.synced(), synced_as(folder, {"file."}));
  }
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

TEST(AtomicFile, RefusesToOverwriteOnAFileSystemThatCannotRenameToAFreeNameOnly) {
  const RenameWithoutFlags without;
  const TemporaryFolder folder;
  write_file(folder / "file", "old", Overwrite::refuse);
  EXPECT_THROW(write_file(folder / "file", "new", Overwrite::refuse), ResultsError);
  EXPECT_EQ(read_file(folder / "file"), "old");
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

// The temporary name has to be found room for.
TEST(AtomicFile, HasANameAsLongAsTheFileSystemTakes) {
  const TemporaryFolder folder;
  for (const std::size_t length : {245U, 255U}) {
    const std::string name(length, 'n');
    write_file(folder / name, "long", Overwrite::refuse);
    EXPECT_EQ(read_file(folder / name), "long");
    write_file(folder / name, "again", Overwrite::allow);
    EXPECT_EQ(read_file(folder / name), "again");
  }
  EXPECT_EQ(files_in(folder), 2);
}

TEST(FilesWrittenTogether, AreThereWithEachOtherOrAsTheyWere) {
  const TemporaryFolder folder;
  write_files_together({{folder / "a", "1"}, {folder / "b", "2"}}, Overwrite::refuse);
  EXPECT_EQ(read_file(folder / "a") + read_file(folder / "b"), "12");
  write_files_together({{folder / "a", "3"}, {folder / "b", "4"}}, Overwrite::allow);
  EXPECT_EQ(read_file(folder / "a") + read_file(folder / "b"), "34");
  // The third cannot get a name that the second has taken: all that was done is undone.
  EXPECT_THROW(write_files_together({{folder / "c", "5"}, {folder / "b", "6"}, {folder / "b", "7"}},
                                    Overwrite::allow),
               ResultsError);
  EXPECT_EQ(read_file(folder / "a") + read_file(folder / "b"), "34");
  EXPECT_EQ(files_in(folder), 2);
}

TEST(FilesWrittenTogether, AreOnTheDiskBeforeTheyGetTheirNames) {
  const TemporaryFolder folder;
  const SyncWatch watch;
  write_files_together({{folder / "a", "1"}, {folder / "b", "2"}}, Overwrite::refuse);
  EXPECT_THAT(watch.synced(), synced_as(folder, {"a.", "b."}));
}

TEST(FilesWrittenTogether, AreCompletedByTheSameCall) {
  const TemporaryFolder folder;
  const std::vector<NewFile> files{{folder / "a", "1"}, {folder / "b", "2"}};
  write_file(folder / "a", "1", Overwrite::refuse);  // by one that did not come to its end
  write_files_together(files, Overwrite::refuse);
  EXPECT_EQ(read_file(folder / "b"), "2");
  EXPECT_THROW(write_files_together(files, Overwrite::refuse), ResultsError);
  std::filesystem::remove(folder / "b");
  write_file(folder / "a", "other", Overwrite::allow);
  EXPECT_THROW(write_files_together(files, Overwrite::refuse), ResultsError);
  EXPECT_EQ(read_file(folder / "a"), "other");
  EXPECT_EQ(files_in(folder), 1);
}

// A pipe that nobody writes to would be waited for without end, and a device may have no end.
TEST(AtomicFile, RefusesToReadAtOnceWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const auto& read : {+[](const std::filesystem::path& path) { read_file(path); },
                           +[](const std::filesystem::path& path) { sha256_of_file(path); }}) {
    EXPECT_THAT(refusal_of<ResultsError>([&] { read(folder / "pipe"); }),
                testing::AllOf(HasSubstr((folder / "pipe").string()), HasSubstr("it is a pipe"),
                               HasSubstr("save its content to a file")));
    EXPECT_THAT(refusal_of<ResultsError>([&] { read("/dev/zero"); }),
                testing::AllOf(HasSubstr("/dev/zero"), HasSubstr("it is a device")));
    EXPECT_THAT(refusal_of<ResultsError>([&] { read(folder.path()); }), HasSubstr("directory"));
  }
}

TEST(AtomicFile, RefusesToReadMoreThanItsKindMayHave) {
  const TemporaryFolder folder;
  write_file(folder / "file", "", Overwrite::refuse);
  std::filesystem::resize_file(folder / "file", kProtocolFile.most_bytes);
  EXPECT_EQ(read_file(folder / "file", kProtocolFile).size(), kProtocolFile.most_bytes);
  std::filesystem::resize_file(folder / "file", kProtocolFile.most_bytes + 1);
  EXPECT_THAT(refusal_of<ResultsError>([&] { read_file(folder / "file", kProtocolFile); }),
              testing::AllOf(HasSubstr((folder / "file").string()),
                             HasSubstr("larger than 4 MiB, the maximum size of a protocol")));
  EXPECT_EQ(read_file(folder / "file").size(), kProtocolFile.most_bytes + 1);
}

TEST(AtomicFile, ReadsAFileOfTheKernelWhoseSizeIsUnknown) {
  EXPECT_THAT(read_file("/proc/self/status"), HasSubstr("Pid:"));
  EXPECT_THAT(refusal_of<ResultsError>([] {
                read_file("/proc/self/status", {"a crumb", 10});
              }),
              HasSubstr("larger than 10 bytes"));
}

}  // namespace
}  // namespace asperity
