// Folders are read in order, and refused by name.

#include "results_schema/files/folder_entries.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/resource.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> names_of(const std::filesystem::path& folder,
                                  const std::vector<std::filesystem::directory_entry>& entries) {
  std::vector<std::string> names{};
  for (const auto& entry : entries)
    names.push_back(entry.path().lexically_relative(folder).string());
  return names;
}

TEST(FolderEntries, AreInTheOrderOfTheirNamesAndDoNotFollowLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "b/inner");
  std::ofstream(folder / "b/inner/x") << 1;
  std::ofstream(folder / "c") << 1;
  std::filesystem::create_symlink(folder.path(), folder / "a");
  EXPECT_THAT(names_of(folder.path(), entries_in(folder.path())), ElementsAre("a", "b", "c"));
  EXPECT_THAT(names_of(folder.path(), entries_below(folder.path())),
              ElementsAre("a", "b", "b/inner", "b/inner/x", "c"));
  EXPECT_THAT(entries_below(folder / "none"), IsEmpty());
}

// What else is hidden is content: sharing and copying take it along.
TEST(FolderEntries, OnlyFilesOfDesktopsLeaveAFolderFree) {
  const TemporaryFolder folder;
  EXPECT_TRUE(is_free(folder / "none"));
  for (const char* const name : {".DS_Store", ".directory", ".localized", "._letter.txt"}) {
    std::ofstream(folder / name) << "of a desktop";
  }
  EXPECT_TRUE(is_free(folder.path()));
  for (const char* const name : {".git", ".cache", "._folder"}) {
    std::filesystem::create_directory(folder / name);
    EXPECT_FALSE(is_free(folder.path())) << name;
    std::filesystem::remove(folder / name);
  }
  std::ofstream(folder / ".bashrc") << "of a shell";
  EXPECT_FALSE(is_free(folder.path()));
}

// The iterators of the standard library name no folder when they can open no further one.
TEST(FolderEntries, NameTheFolderThatCannotBeRead) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "inner");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  rlimit none = before;
  none.rlim_cur = 0;
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  const std::string refusal = refusal_of<ResultsError>([&] { entries_below(folder / "inner"); });
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_THAT(refusal, AllOf(HasSubstr((folder / "inner").string()), HasSubstr("ulimit -n")));
}

}  // namespace
}  // namespace asperity
