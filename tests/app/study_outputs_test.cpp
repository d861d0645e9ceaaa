// The list of what was made of a study.

#include "app/study_files/study_outputs.h"

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

TEST(ListedOutput, IsInTheListFromBeforeItIsMade) {
  MadeUpStudy made;
  ListedOutput listed(made.study(), OutputKind::report, made.beside("report.html"));
  ASSERT_EQ(made.study().outputs().size(), 1U);
  EXPECT_EQ(made.study().outputs()[0].path, made.beside("report.html"));
  EXPECT_EQ(made.study().outputs()[0].made_utc, "") << "it is not complete";
  EXPECT_FALSE(listed.complete());
  ASSERT_EQ(made.study().outputs().size(), 1U);
  EXPECT_EQ(made.study().outputs()[0].made_utc.back(), 'Z');
}

TEST(ListedOutput, LeavesTheListWhereItIsNotMade) {
  MadeUpStudy made;
  { const ListedOutput listed(made.study(), OutputKind::copy, made.beside("copy")); }
  EXPECT_TRUE(made.study().outputs().empty());
}

TEST(ListedOutput, IsNotInTheListOfTheCopyThatItIs) {
  MadeUpStudy made;
  ListedOutput earlier(made.study(), OutputKind::copy, made.beside("earlier"));
  EXPECT_FALSE(earlier.complete());
  ListedOutput listed(made.study(), OutputKind::copy, made.beside("copy"));
  made.study().copy_to(made.beside("copy"));
  EXPECT_FALSE(listed.complete());
  EXPECT_EQ(made.study().outputs().size(), 2U);
  const std::vector<OutputRow> in_copy =
      Study::open(made.beside("copy"), Access::read_only).outputs();
  ASSERT_EQ(in_copy.size(), 1U);
  EXPECT_EQ(in_copy[0].path, made.beside("earlier"));
}

// The folder does not exist, and the data of the participant do.
TEST(ListedOutput, OfAKilledProgramIsReportedWithItsRemains) {
  MadeUpStudy made;
  made.add_virtual("virtual0001", "M");
  Study study = Study::open(made.study().folder(), Access::read_write);
  study.begin_output({.kind = OutputKind::merge, .path = made.beside("merged").string() + '/'});
  const auto reported = [&] { return outputs_of_participant(study, "virtual0001").at(0).path; };
  EXPECT_EQ(reported(), made.beside("merged").string() + '/');
  std::filesystem::create_directory(made.beside("merged.part"));
  EXPECT_EQ(reported(), made.beside("merged.part"));
}

// A simulated participant has no real date: what is there now tells whether they are in it.
TEST(ListedOutput, IsReportedToAVirtualParticipantWhileItIsMade) {
  MadeUpStudy made;
  made.add_virtual("virtual0001", "M");
  const std::filesystem::path copy = made.beside("copy");
  { Study::create(copy, "without anybody"); }
  const auto reported = [&] {
    std::vector<std::string> paths{};
    for (const OutputRow& row : outputs_of_participant(made.study(), "virtual0001")) {
      paths.push_back(row.path);
    }
    return paths;
  };
  ListedOutput listed(made.study(), OutputKind::copy, copy);
  EXPECT_THAT(reported(), testing::ElementsAre(copy.string()))
      << "another one is about to be there";
  EXPECT_FALSE(listed.complete());
  EXPECT_THAT(reported(), testing::IsEmpty());
}

}  // namespace
}  // namespace asperity
