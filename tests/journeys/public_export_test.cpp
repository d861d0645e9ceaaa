// An export for the public as the command line makes it: what is left out, and the labels that nobody can trace.

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

class PublicExportCommand : public testing::Test {
 protected:
  /// The files of an export with these options, by name.
  std::map<std::string, std::string> files_of(const std::string& name,
                                              const std::vector<std::string>& options) {
    const fs::path out = small_.place() / name;
    std::vector<std::string> arguments{"export", small_.study(), "--out", out, "--public"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = asperity(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return contents_of(out);
  }

  static std::size_t recordings_in(const std::map<std::string, std::string>& files) {
    return static_cast<std::size_t>(std::count_if(files.begin(), files.end(), [](const auto& file) {
      return file.first.find("_physio.tsv.gz") != std::string::npos;
    }));
  }

  SmallStudy small_ = simulated_study(6, 5, {"--recordings", "all"});
};

TEST_F(PublicExportCommand, WritesRecordingsOnlyIfTheyAreNamed) {
  EXPECT_EQ(recordings_in(files_of("all", {"--formats", "all"})), 0U);
  EXPECT_GT(recordings_in(files_of("named", {"--formats", "all,physio"})), 0U);
}

TEST_F(PublicExportCommand, DrawsOtherLabelsInEveryExportAndStoresThemNowhereElse) {
  std::set<std::string> labels{};
  for (const std::string name : {"first", "second"}) {
    const auto files = files_of(name, {"--relabel", "--formats", "all,physio"});
    for (const auto& [file, content] : files) {
      EXPECT_EQ(file.find("virtual00"), std::string::npos) << file;
      EXPECT_EQ(content.find("virtual00"), std::string::npos) << file;
    }
    const std::vector<std::string> drawn = tsv(files.at("participants.tsv")).column("participant");
    EXPECT_EQ(drawn.size(), 6U);
    EXPECT_TRUE(std::is_sorted(drawn.begin(), drawn.end()));
    labels.insert(drawn.begin(), drawn.end());
  }
  EXPECT_GT(labels.size(), 6U);
  std::vector<std::string> traces{};
  for (const auto& [file, content] : contents_of(small_.study())) {
    if (file.ends_with(".rec")) continue;  // compressed
    for (const std::string& label : labels) {
      if (content.find(label) != std::string::npos) traces.push_back(file + ": " + label);
    }
  }
  EXPECT_THAT(traces, IsEmpty());
}

TEST_F(PublicExportCommand, StatesAgesInBands) {
  const auto files = files_of("bands", {"--age-bands"});
  std::map<std::string, int> participants{};
  for (const std::string& band : tsv(files.at("participants.tsv")).column("age_band")) {
    ++participants[band];
  }
  for (const auto& [band, count] : participants) EXPECT_GE(count, 5) << band;
}

TEST_F(PublicExportCommand, ChangesLabelsAndAgesForThePublicOnly) {
  for (const char* const option : {"--relabel", "--age-bands"}) {
    const Outcome outcome =
        asperity({"export", small_.study(), "--out", small_.place() / "out", option});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--public"));
    EXPECT_FALSE(fs::exists(small_.place() / "out"));
  }
}

}  // namespace
}  // namespace asperity::test
