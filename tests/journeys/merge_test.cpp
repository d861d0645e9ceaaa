// The studies of two stations as one: the same analysis, and a withdrawal that names it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// The study without a participant, at another place.
fs::path station_without(const SmallStudy& small, const std::string& name,
                         const std::string& label) {
  const fs::path station = small.place() / name;
  fs::copy(small.study(), station, fs::copy_options::recursive);
  const Outcome outcome = asperity({"withdraw", station, label, "--delete", "--confirm", label});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return station;
}

TEST(Merge, GivesTheAnalysisOfOneStudyWithAllParticipants) {
  const SmallStudy small = simulated_study(2, 3, {"--recordings", "all"});
  const fs::path first = station_without(small, "first", "virtual0002");
  const fs::path second = station_without(small, "second", "virtual0001");
  // Of the same name, which an analysis states.
  const fs::path merged = small.place() / "merged" / "study";
  const Outcome refused = asperity({"merge", second, first, "--out", merged});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("copied from one study"), HasSubstr(first.string()),
                                 HasSubstr(second.string()), HasSubstr("--deletions-checked")));
  EXPECT_FALSE(fs::exists(merged));

  const Outcome outcome =
      asperity({"merge", second, first, "--out", merged, "--deletions-checked"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("merged 2 studies into " + merged.string() +
                                     ": 2 participants, 4 sessions, "));
  const Outcome verified = asperity({"verify", merged, "--replay"});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_THAT(verified.out, Not(HasSubstr("remark")));
  EXPECT_EQ(exported(merged, small.place() / "of_merged"),
            exported(small.study(), small.place() / "of_whole"));
  const Outcome analysis = asperity({"analyze", merged, "--json"});
  EXPECT_EQ(analysis.status, 0) << analysis.err;
  EXPECT_EQ(analysis.out, asperity({"analyze", small.study(), "--json"}).out);

  const Outcome withdrawn = asperity({"withdraw", first, "virtual0001"});
  EXPECT_EQ(withdrawn.status, 0) << withdrawn.err;
  EXPECT_THAT(withdrawn.out, HasSubstr("merged study  " + merged.string()));
  const Outcome deleted =
      asperity({"withdraw", merged, "virtual0001", "--delete", "--confirm", "virtual0001"});
  EXPECT_EQ(deleted.status, 0) << deleted.err;
  EXPECT_EQ(asperity({"verify", merged}).status, 0);
}

TEST(Merge, RefusesEqualLabelsUnlessOneIsPrefixed) {
  const SmallStudy first = simulated_study(1, 3);
  const SmallStudy second = simulated_study(1, 4);
  const fs::path merged = first.place() / "merged";
  const Outcome refused = asperity({"merge", first.study(), second.study(), "--out", merged});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("both have a participant virtual0001"),
                                 HasSubstr("--prefix " + second.study().string() + "=B")));
  EXPECT_FALSE(fs::exists(merged));
  const Outcome outcome =
      asperity({"merge", first.study(), second.study(), "--out", merged, "--prefix",
                first.study().string() + "=," + second.study().string() + "/=B"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(
      tsv(exported(merged, first.place() / "tables").at("participants.tsv")).column("participant"),
      ElementsAre("Bvirtual0001", "virtual0001"));
  // Under the other label too.
  EXPECT_THAT(asperity({"withdraw", second.study(), "virtual0001"}).out,
              HasSubstr("merged study  " + merged.string()));
}

TEST(Merge, TakesPrefixesOfItsStudiesOnly) {
  const SmallStudy small;
  const fs::path merged = small.place() / "merged";
  const auto refused = [&](const std::string& prefix) {
    const Outcome outcome = asperity({"merge", small.study(), "--out", merged, "--prefix", prefix});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_FALSE(fs::exists(merged));
    return outcome.err;
  };
  EXPECT_THAT(refused("B"), HasSubstr("write STUDY=PREFIX"));
  EXPECT_THAT(refused("elsewhere=B"), HasSubstr("\"elsewhere\", which is not one of the studies"));
}

}  // namespace
}  // namespace asperity::test
