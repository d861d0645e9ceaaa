// simulate --shard: the studies of all shards have the rows of the undivided one and are merged to it, and no other study is taken for
// one of them.

#include <algorithm>
#include <csignal>
#include <iterator>
#include <map>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kParticipants = 3;
constexpr int kSeed = 7;

/// Shards work in a folder for temporary files, which is that of the test.
class SimulateShards : public testing::Test {
 protected:
  SimulateShards() { fs::create_directory(temporary()); }

  fs::path temporary() const { return small_.place() / "temporary"; }
  fs::path shard_study(int index, int count) const {
    return small_.study().string() + ".shard-" + std::to_string(index) + "-of-" +
           std::to_string(count);
  }
  Invocation invocation(const std::string& shard, int participants = kParticipants,
                        int seed = kSeed) const {
    std::vector<std::string> arguments =
        simulate_arguments(small_, small_.study(), participants, seed);
    arguments.insert(arguments.end(), {"--shard", shard});
    return {.arguments = arguments, .environment = {{"TMPDIR", temporary().string()}}};
  }
  Outcome simulate(int index, int count) const {
    return run(invocation(std::to_string(index) + '/' + std::to_string(count)));
  }

  const SmallStudy small_{1};
};

/// The lines of all rows about participants, sorted, by table and columns.
using Rows = std::map<std::string, std::vector<std::string>>;

void add_rows(const std::map<std::string, std::string>& tables, Rows& rows) {
  for (const auto& [name, text] : tables) {
    std::istringstream lines(text);
    std::string line{};
    std::getline(lines, line);
    if (!name.ends_with(".tsv") || !line.starts_with("participant")) continue;
    std::vector<std::string>& of_table = rows[name + ": " + line];
    while (std::getline(lines, line)) of_table.push_back(line);
    std::sort(of_table.begin(), of_table.end());
  }
}

// Labels, clocks, seeds, plans, forces, responses: every exported column.
TEST_F(SimulateShards, HaveTheRowsOfTheWholeForAnyDivision) {
  const SmallStudy undivided(small_);
  ASSERT_EQ(asperity(simulate_arguments(undivided, undivided.study(), kParticipants, kSeed)).status,
            0);
  Rows whole{};
  add_rows(exported(undivided.study(), undivided.place() / "tables"), whole);
  ASSERT_GE(whole.size(), 8U);
  for (const int count : {1, 2, 3}) {
    Rows joined{};
    for (int index = 1; index <= count; ++index) {
      const Outcome outcome = simulate(index, count);
      ASSERT_EQ(outcome.status, 0) << outcome.err;
      const fs::path study = shard_study(index, count);
      EXPECT_THAT(outcome.out, HasSubstr(study.string() + ": shard "));
      EXPECT_EQ(asperity({"verify", study}).status, 0);
      add_rows(exported(study, study.string() + "_tables"), joined);
    }
    EXPECT_EQ(joined, whole) << count << " shards";
  }
  EXPECT_TRUE(fs::is_empty(temporary()));
}

/// The names of the files that are not in both with the same bytes.
std::vector<std::string> differing_files(const std::map<std::string, std::string>& one,
                                         const std::map<std::string, std::string>& other) {
  std::vector<std::string> names{};
  for (const auto& [name, content] : one) {
    const auto found = other.find(name);
    if (found == other.end() || found->second != content) names.push_back(name);
  }
  for (const auto& [name, content] : other) {
    if (!one.contains(name)) names.push_back(name);
  }
  return names;
}

TEST_F(SimulateShards, AreMergedToTheStudyOfTheWhole) {
  const SmallStudy undivided(small_);
  ASSERT_EQ(asperity(simulate_arguments(undivided, undivided.study(), kParticipants, kSeed)).status,
            0);
  for (const int index : {1, 2}) ASSERT_EQ(simulate(index, 2).status, 0);
  const fs::path merged = small_.place() / "merged" / "study";
  const Outcome outcome =
      asperity({"merge", shard_study(2, 2), shard_study(1, 2), "--out", merged});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.err, Not(HasSubstr("warning")));

  const fs::path merged_whole = undivided.place() / "merged" / "study";
  ASSERT_EQ(asperity({"merge", undivided.study(), "--out", merged_whole}).status, 0);
  const std::map<std::string, std::string> bytes = contents_of(merged);
  EXPECT_TRUE(bytes.contains("study.sqlite"));
  EXPECT_TRUE(bytes.contains("recordings/virtual0001"));
  EXPECT_THAT(differing_files(bytes, contents_of(merged_whole)), IsEmpty());

  const Outcome verified = asperity({"verify", merged});
  EXPECT_EQ(verified.status, 0) << verified.err;
  EXPECT_THAT(verified.out, Not(HasSubstr("remark")));
  EXPECT_THAT(differing_files(exported(merged, small_.place() / "tables"),
                              exported(undivided.study(), undivided.place() / "tables")),
              IsEmpty());
}

TEST_F(SimulateShards, AreMergedOnlyIfNoneIsMissing) {
  ASSERT_EQ(simulate(2, 2).status, 0);
  const std::map<std::string, std::string> before = contents_of(shard_study(2, 2));
  const fs::path merged = small_.place() / "merged";
  const Outcome refused = asperity({"merge", shard_study(2, 2), "--out", merged});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, AllOf(HasSubstr("missing"), HasSubstr(shard_study(1, 2).string())));
  EXPECT_FALSE(fs::exists(merged));
  EXPECT_THAT(differing_files(contents_of(shard_study(2, 2)), before), IsEmpty())
      << "an output is listed that was not made";
}

TEST_F(SimulateShards, HaveTheirOwnParticipantsOnly) {
  const std::map<std::string, std::string> before = contents_of(small_.study());
  ASSERT_EQ(simulate(1, 2).status, 0);
  ASSERT_EQ(simulate(2, 2).status, 0);
  const auto labels = [&](int index) {
    const fs::path tables = small_.place() / ("tables_" + std::to_string(index));
    return tsv(exported(shard_study(index, 2), tables).at("participants.tsv"))
        .column("participant");
  };
  EXPECT_EQ(labels(1), (std::vector<std::string>{"virtual0001", "virtual0003"}));
  EXPECT_EQ(labels(2), (std::vector<std::string>{"virtual0002"}));
  EXPECT_EQ(contents_of(small_.study()), before) << "the study itself has changed";
}

TEST_F(SimulateShards, AreNotSimulatedAgainWhereTheyAreStored) {
  ASSERT_EQ(simulate(2, 2).status, 0);
  const std::map<std::string, std::string> before = contents_of(shard_study(2, 2));
  const Outcome again = simulate(2, 2);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("already simulated by an earlier command"));
  EXPECT_EQ(contents_of(shard_study(2, 2)), before);
}

TEST_F(SimulateShards, AreNotTakenForThoseOfAnotherSimulation) {
  ASSERT_EQ(simulate(2, 2).status, 0);
  const Outcome other_seed = run(invocation("2/2", kParticipants, kSeed + 1));
  EXPECT_EQ(other_seed.status, 1);
  EXPECT_THAT(other_seed.err, AllOf(HasSubstr(shard_study(2, 2).string()),
                                    HasSubstr("of another simulation: the options")));
  const auto expect_refused = [&](const std::vector<std::string>& more, const char* what) {
    Invocation other = invocation("2/2");
    other.arguments.insert(other.arguments.end(), more.begin(), more.end());
    const Outcome refused = run(other);
    EXPECT_EQ(refused.status, 1) << what;
    EXPECT_THAT(refused.err, HasSubstr("of another simulation: the options")) << what;
  };
  expect_refused({"--recordings", "none"}, "recordings");
  const fs::path texture = small_.study() / "stimuli" / "walnut.png";
  const std::string relief = text_of(texture);
  fs::copy_file(small_.study() / "stimuli" / "slate.png", texture,
                fs::copy_options::overwrite_existing);
  expect_refused({}, "stimuli");
  write_text(texture, relief);
  write_text(small_.selection(), text_of(small_.selection()) + '\n');
  expect_refused({}, "protocol");
  fs::create_directory(shard_study(1, 2));
  const Outcome taken = simulate(1, 2);
  EXPECT_EQ(taken.status, 1);
  EXPECT_THAT(taken.err,
              HasSubstr(shard_study(1, 2).string() + " exists and is not a shard of a simulation"));
}

TEST_F(SimulateShards, AreNotTakenForCompleteWhereTheyWereChanged) {
  ASSERT_EQ(simulate(2, 2).status, 0);
  const fs::path checksum = shard_study(2, 2) / "study.sqlite.sha256";
  std::string text = text_of(checksum);
  text[0] = text[0] == '0' ? '1' : '0';
  write_text(checksum, text);
  const Outcome refused = simulate(2, 2);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, AllOf(HasSubstr(shard_study(2, 2).string()), HasSubstr("checksum")));
}

TEST_F(SimulateShards, NeedAStudyWithoutParticipantsAndAParticipantEach) {
  const Outcome many = run(invocation("1/4"));
  EXPECT_EQ(many.status, 1);
  EXPECT_THAT(many.err, HasSubstr("divides 3 participants among 4 shards"));
  ASSERT_EQ(asperity(simulate_arguments(small_, small_.study(), 1, kSeed)).status, 0);
  const Outcome with_participants = simulate(1, 2);
  EXPECT_EQ(with_participants.status, 1);
  EXPECT_THAT(with_participants.err, HasSubstr("has participants already"));
  EXPECT_FALSE(fs::exists(shard_study(1, 2)));
}

// A task was killed while it copied its study. On a network file system its owner cannot be determined, nor here, without a lock.
TEST_F(SimulateShards, AreStoredNextToWhatAKilledProcessLeft) {
  const fs::path left = shard_study(2, 2).string() + ".part";
  fs::create_directories(left / "content");
  write_text(left / "content" / "study.sqlite", "half of it");
  const Outcome repeated = simulate(2, 2);
  ASSERT_EQ(repeated.status, 0) << repeated.err;
  EXPECT_EQ(asperity({"verify", shard_study(2, 2)}).status, 0);
  EXPECT_EQ(text_of(left / "content" / "study.sqlite"), "half of it") << "it may be of a user";
  std::vector<std::string> names{};
  for (const auto& entry : fs::directory_iterator(small_.place())) {
    names.push_back(entry.path().filename());
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("study", "temporary",
                                                   shard_study(2, 2).filename(), left.filename()));
}

TEST_F(SimulateShards, NameTheFolderForTemporaryFilesThatIsMissing) {
  Invocation shard = invocation("1/2");
  shard.environment = {{"TMPDIR", (small_.place() / "nowhere").string()}};
  const Outcome refused = run(shard);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, AllOf(HasSubstr((small_.place() / "nowhere").string()),
                                 HasSubstr("set TMPDIR to a folder that you may write to")));
}

TEST_F(SimulateShards, LeaveNothingWhenTheyAreStopped) {
  Program program(invocation("1/2", 2000));
  ASSERT_TRUE(program.read_until_told("done virtual0001 1 1 1"));
  program.send(SIGINT);
  const Outcome stopped = program.finish();
  EXPECT_EQ(stopped.status, 1);
  EXPECT_THAT(stopped.err, HasSubstr("shard 1/2 was stopped on request and is not stored"));
  std::vector<std::string> left{};
  for (const auto& entry : fs::directory_iterator(small_.place())) {
    left.push_back(entry.path().filename());
  }
  EXPECT_THAT(left, testing::UnorderedElementsAre("study", "temporary"));
  EXPECT_TRUE(fs::is_empty(temporary()));
}

}  // namespace
}  // namespace asperity::test
