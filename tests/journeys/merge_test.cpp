// The studies of two stations as one: the same analysis, and a withdrawal that names it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "results_schema/study.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

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
  const Outcome again = asperity({"merge", second, first, "--out", merged, "--deletions-checked"});
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("already merged by an earlier command: 2 studies into "));
  EXPECT_EQ(Study::open(first, Access::read_only).outputs().size(), 1U);
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

/// The study of a station with one participant, at a place that was dealt to it.
fs::path station_with(const fs::path& study, const std::string& label, int place) {
  EXPECT_EQ(asperity({"new", study}).status, 0);
  EXPECT_EQ(asperity({"metadata", study, "--deal", std::to_string(place) + "-12"}).status, 0);
  Study station = Study::open(study, Access::read_write);
  station.add_participant({.label = label, .created_utc = "2026-03-01T09:00:00.000Z"});
  SessionRow session = some_session(station.add_protocol(some_protocol()), label);
  session.mode = SessionMode::run;
  session.seed = std::to_string(int{label.front()});  // those of people differ
  const std::string number = std::to_string(place);
  station.add_event(station.add_session(session, some_plan(1)),
                    {session.clock_zero_ns, kDealtEvent, number, "{\"place\":" + number + "}"});
  return study;
}

// The places that were dealt are those of a station, and the study of all stations has none.
TEST(Merge, WarnsOfPlacesThatTwoStationsHave) {
  const TemporaryFolder folder;
  const fs::path a = station_with(folder / "a", "A01", 1);
  const fs::path b = station_with(folder / "b", "B01", 2);
  const Outcome clean = asperity({"merge", a, b, "--out", folder / "clean"});
  EXPECT_EQ(clean.status, 0) << clean.err;
  EXPECT_THAT(clean.err, Not(HasSubstr("same places")));
  EXPECT_THAT(clean.err, HasSubstr("warning: 2 sessions are not complete: resume in the study of "
                                   "the station and merge again"));
  EXPECT_FALSE(fs::exists(folder / "clean" / "deal.json"));
  const fs::path c = station_with(folder / "c", "C01", 1);
  const Outcome warned = asperity({"merge", a, b, c, "--out", folder / "warned"});
  EXPECT_EQ(warned.status, 0) << warned.err;
  EXPECT_THAT(warned.err,
              HasSubstr("warning: participants of different stations have the same places of the "
                        "protocol selection: 1 (A01 and C01). "));
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
