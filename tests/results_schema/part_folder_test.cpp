// A folder in the making is nobody's but its maker's, and leaves nothing behind.

#include "results_schema/files/part_folder.h"

#include <filesystem>
#include <memory>
#include <string>
#include <sys/resource.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/results_schema/rename_watch.h"
#include "tests/results_schema/sync_watch.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/waiting_child.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A process that has begun to make a folder.
WaitingChild maker_of(const std::filesystem::path& target) {
  return WaitingChild([&target] {
    auto part = std::make_unique<PartFolder>(target, 0700);
    write_file(part->content() / "half.txt", "half", Overwrite::refuse);
    return part;
  });
}

std::size_t entries_in(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(PartFolder, TakesItsPlaceOrLeavesNothing) {
  const TemporaryFolder folder;
  for (const bool finishes : {false, true}) {
    PartFolder part(folder / "new/out", 0700);
    write_file(part.content() / "a.txt", "a", Overwrite::refuse);
    EXPECT_FALSE(std::filesystem::exists(folder / "new/out"));
    const SyncWatch watch;
    if (finishes) part.take_place();
    EXPECT_EQ(watch.synced().contains(folder / "new"), finishes);
  }
  EXPECT_EQ(read_file(folder / "new/out/a.txt"), "a");
  EXPECT_EQ(std::filesystem::status(folder / "new/out").permissions(),
            std::filesystem::perms::owner_all);
  EXPECT_EQ(entries_in(folder / "new"), 1U);
  EXPECT_EQ(entries_in(folder / "new/out"), 1U);
  PartFolder again(folder / "new/out/", 0700);
  EXPECT_THAT(refusal_of<ResultsError>([&] { again.take_place(); }), HasSubstr("File exists"));
  EXPECT_EQ(read_file(folder / "new/out/a.txt"), "a");
}

TEST(PartFolder, NamesInAnErrorTheFolderThatIsMade) {
  const TemporaryFolder folder;
  const PartFolder part(folder / "out", 0700);
  const std::filesystem::path of_content = part.content() / "a.txt";
  const ResultsError about =
      part.about_target(ResultsError(of_content.string() + " cannot be written", of_content, 28));
  EXPECT_EQ(about.what(), (folder / "out/a.txt").string() + " cannot be written");
  EXPECT_EQ(about.path(), folder / "out");
  EXPECT_EQ(about.code(), 28);
  const ResultsError of_another = part.about_target(ResultsError("b cannot be read", "b"));
  EXPECT_STREQ(of_another.what(), "b cannot be read");
  EXPECT_EQ(of_another.path(), "b");
}

TEST(PartFolder, RemovesWhatAKilledProgramLeft) {
  const TemporaryFolder folder;
  WaitingChild maker = maker_of(folder / "out");
  const std::string refusal = refusal_of<ResultsError>([&] { PartFolder(folder / "out", 0700); });
  EXPECT_THAT(refusal, AllOf(HasSubstr((folder / "out").string() + " is being written by process " +
                                       std::to_string(maker.process())),
                             HasSubstr("wait until it has finished")));
  EXPECT_TRUE(std::filesystem::exists(folder / "out.part/content/half.txt"));
  maker.kill();
  {
    PartFolder part(folder / "out", 0700);
    EXPECT_TRUE(std::filesystem::is_empty(part.content()));
    part.take_place();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out.part"));
  std::filesystem::create_directory(folder / "next.part");  // killed before it had a lock
  EXPECT_NO_THROW(PartFolder(folder / "next", 0700));
  EXPECT_FALSE(std::filesystem::exists(folder / "next.part"));
}

// A program with too many open files can remove the lock, but not list the content of a folder.
TEST(PartFolder, KeepsItsLockWhereItsContentCannotBeRemoved) {
  const TemporaryFolder folder;
  auto part = std::make_unique<PartFolder>(folder / "out", 0700);
  write_file(part->content() / "half.txt", "half", Overwrite::refuse);
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit none = before;
  none.rlim_cur = 0;
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  part.reset();
  setrlimit(RLIMIT_NOFILE, &before);
  EXPECT_TRUE(std::filesystem::exists(folder / "out.part/content/half.txt"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out.part/lock"));
  PartFolder(folder / "out", 0700).take_place();
  EXPECT_EQ(entries_in(folder.path()), 1U);
}

TEST(PartFolder, TouchesNothingThatItMayNotHaveMade) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a.part");
  write_file(folder / "a.part/study.sqlite", "mine", Overwrite::refuse);
  write_file(folder / "b.part", "mine", Overwrite::refuse);
  std::filesystem::create_directory_symlink(folder / "a.part", folder / "c.part");
  for (const char* const name : {"a", "b", "c"}) {
    EXPECT_THAT(refusal_of<ResultsError>([&] { PartFolder(folder / name, 0700); }),
                AllOf(HasSubstr((folder / name).string() + ".part already exists"),
                      HasSubstr("Remove or rename it")));
  }
  EXPECT_EQ(read_file(folder / "a.part/study.sqlite"), "mine");
  EXPECT_EQ(read_file(folder / "b.part"), "mine");
  EXPECT_EQ(entries_in(folder / "a.part"), 1U);
}

// A program that is killed after any of its steps leaves the old folder or the new one.
TEST(PartFolder, ReplacesAFolderInOneStep) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "out");
  write_file(folder / "out/a.txt", "old", Overwrite::refuse);
  {
    PartFolder part(folder / "out", 0700);
    write_file(part.content() / "a.txt", "new", Overwrite::refuse);
    const RenameWatch watch(folder / "out/a.txt");
    part.take_place(Overwrite::allow);
    EXPECT_GE(watch.renamings(), 1);
    EXPECT_EQ(watch.times_missing(), 0);
  }
  EXPECT_EQ(read_file(folder / "out/a.txt"), "new");
  EXPECT_EQ(entries_in(folder.path()), 1U);
}

TEST(KilledStudyMaker, LeavesNothingInTheWayOfTheNext) {
  const TemporaryFolder folder;
  maker_of(folder / "s").kill();
  { Study::create(folder / "s", "x"); }
  maker_of(folder / "copy").kill();
  Study::open(folder / "s", Access::read_only).copy_to(folder / "copy");
  EXPECT_EQ(Study::open(folder / "copy", Access::read_only).name(), "x");
  EXPECT_EQ(entries_in(folder.path()), 2U);
}

}  // namespace
}  // namespace asperity
