// simulate --shard: the studies of all shards have the rows of the undivided one, and no other study is taken for one of them.

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
