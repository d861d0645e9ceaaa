// Holds a growing file to the lines that were appended, whenever its writer was stopped.

#include "results_schema/files/growing_file.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Pair;

std::vector<std::pair<std::string, std::uint64_t>> lines_of(const GrowingFile& file) {
  std::vector<std::pair<std::string, std::uint64_t>> lines{};
  file.for_each_line(
      [&](std::string_view line, std::uint64_t end) { lines.emplace_back(line, end); });
  return lines;
}

TEST(GrowingFile, GrowsOverSeveralOpenings) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "table.tsv";
  GrowingFile(path).append("run\n0\n");
  GrowingFile(path).append("1\n");
  EXPECT_EQ(read_file(path), "run\n0\n1\n");
}

// The end of a line that was never written, as after a crash.
TEST(GrowingFile, LeavesOutAnIncompleteLineAndCutsIt) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "table.tsv";
  write_file(path, "run\n10\n1", Overwrite::refuse);
  GrowingFile file(path);
  EXPECT_THAT(lines_of(file), ElementsAre(Pair("run", 4U), Pair("10", 7U)));
  file.cut_to(7);
  file.append("11\n");
  EXPECT_EQ(read_file(path), "run\n10\n11\n");
}

// A line that is longer than the piece that is read at once, and one that ends with it.
TEST(GrowingFile, ReadsLinesAcrossPieces) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "table.tsv";
  const std::string first(65535, 'a');
  const std::string second(200000, 'b');
  write_file(path, first + '\n' + second + "\nc\n", Overwrite::refuse);
  EXPECT_THAT(lines_of(GrowingFile(path)),
              ElementsAre(Pair(first, 65536U), Pair(second, 265537U), Pair("c", 265539U)));
}

TEST(GrowingFile, HasOneWriter) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "table.tsv";
  const GrowingFile first(path);
  EXPECT_THAT(refusal_of<ResultsError>([&] { const GrowingFile second(path); }),
              HasSubstr("another program is writing the file " + path.string()));
}

TEST(GrowingFile, RefusesALinkAndAFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink(folder.path() / "elsewhere", folder.path() / "link");
  EXPECT_THROW(GrowingFile(folder.path() / "link"), ResultsError);
  EXPECT_THROW(GrowingFile(folder.path().string()), ResultsError);
}

}  // namespace
}  // namespace asperity
