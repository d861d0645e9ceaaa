// What asperity new prints: the study, and the rule about versions, which the README and the release notes state as well.

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
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

TEST(New, TakesAnEmptyFolderWithFilesOfADesktopAndNoOther) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "mine");
  std::ofstream(folder / "mine/.DS_Store") << "of a desktop";
  const std::string study = folder / "mine";
  const Outcome made = asperity({"new", study});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, testing::StartsWith("created the study " + study));
  EXPECT_THAT(asperity({"new", study}).out, testing::StartsWith("an earlier command created"));
  EXPECT_TRUE(fs::exists(folder / "mine/.DS_Store"));

  fs::create_directory(folder / "other");
  std::ofstream(folder / "other/letter.txt") << "dear";
  const Outcome refused = asperity({"new", folder / "other"});
  EXPECT_NE(refused.status, 0);
  EXPECT_THAT(refused.err, testing::HasSubstr(std::string(folder / "other") +
                                              ": it is not empty; name a new or an empty folder"));
}

/// A document in one line.
std::string words_of(const char* document) {
  std::istringstream words(text_of(fs::path(ASPERITY_SOURCE_DIR) / document));
  std::string line{};
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

TEST(VersionOfAStudy, IsKeptAccordingToTheReadmeAndTheReleaseNotesToo) {
  const std::string rule =
      "finish a study with the version that began it; the package of each version stays available.";
  EXPECT_THAT(words_of("README.md"), testing::HasSubstr("Before 1.0.0, " + rule));
  EXPECT_THAT(words_of("CHANGELOG.md"), testing::HasSubstr("Until 1.0.0, "));
  EXPECT_THAT(words_of("CHANGELOG.md"), testing::HasSubstr(rule));
}

}  // namespace
}  // namespace asperity::test
