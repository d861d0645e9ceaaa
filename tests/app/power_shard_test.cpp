// A power analysis in shards: any division gives the bytes of the whole, which then has nothing left to simulate but its last study.

#include "app/power/curve/power_shard.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/power/curve/simulate_power.h"
#include "app/shards/table_shard.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

constexpr int kSevenRuns = 7;

PowerOrder order_of_seven_runs() {
  return {.effects = {"order=0", "order=0.5"},
          .participants = {8, 16},
          .seed = 3,
          .runs = kSevenRuns,
          .protocol_sha256 = "aa",
          .assumptions_sha256 = "bb",
          .program = "asperity 0.0.0"};
}

/// A number of its own for each study, and one row or two.
std::vector<SimulatedOutcome> made_up_study(std::size_t effect, int participants,
                                            std::uint64_t seed, std::int64_t run) {
  const double p = 1.0 / (1.0 + static_cast<double>(run) + 10.0 * static_cast<double>(effect) +
                          100.0 * participants + 10000.0 * static_cast<double>(seed));
  std::vector<SimulatedOutcome> outcomes{{.family = "order", .test = "order", .p = p}};
  if (run % 3 == 0) outcomes.push_back({.family = "order", .test = "rare", .p = p / 2.0});
  return outcomes;
}

class PowerShards : public testing::Test {
 protected:
  PowerFiles files_of(const std::string& name) const { return {.folder = folder_ / name}; }

  PowerShard simulate(const PowerOrder& order, const Shard& shard,
                      const std::stop_token& stop = {}) const {
    return simulate_power_shard(order, shard, made_up_study, 2, files_of("out"), stop, {});
  }
  fs::path file_of(const Shard& shard) const {
    return shard_path(files_of("out").studies(), shard);
  }

  TemporaryFolder folder_{};
};

TEST_F(PowerShards, GiveTheBytesOfTheWholeForAnyDivision) {
  const PowerOrder order = order_of_seven_runs();
  const PowerFiles whole = files_of("whole");
  ASSERT_TRUE(simulate_power(order, made_up_study, 1, whole, {}, {}).is_complete);
  for (const int count : {1, 2, 3, kSevenRuns}) {
    std::vector<fs::path> shards{};
    for (int index = count; index >= 1; --index) {
      ASSERT_EQ(simulate(order, {index, count}), PowerShard::simulated);
      shards.push_back(file_of({index, count}));
    }
    const GatheredTable joined = gathered(shards);
    EXPECT_EQ(joined.table, read_file(whole.studies())) << count;
    EXPECT_EQ(joined.whole.declaration, read_file(whole.declaration())) << count;
    // Four studies in each run, a further row for each in the runs 0, 3 and 6.
    EXPECT_EQ(joined.rows, 4U * (kSevenRuns + 3)) << count;
  }
}

TEST_F(PowerShards, LeaveNothingToSimulateWhenTheyAreJoined) {
  const PowerOrder order = order_of_seven_runs();
  simulate(order, {1, 2});
  simulate(order, {2, 2});
  const GatheredTable joined = gathered({file_of({1, 2}), file_of({2, 2})});
  const PowerFiles files = files_of("out");
  write_file(files.declaration(), joined.whole.declaration, Overwrite::refuse);
  write_file(files.studies(), joined.table, Overwrite::refuse);
  std::atomic<int> studies{0};
  const SimulateStudy counting = [&](std::size_t effect, int participants, std::uint64_t seed,
                                     std::int64_t run) {
    ++studies;
    return made_up_study(effect, participants, seed, run);
  };
  const SimulatedPower power = simulate_power(order, counting, 1, files, {}, {});
  EXPECT_TRUE(power.is_complete);
  EXPECT_EQ(power.there, 4 * kSevenRuns);
  EXPECT_EQ(studies, 1);  // the last one, always
  EXPECT_EQ(read_file(files.studies()), joined.table);
}

TEST_F(PowerShards, HaveTheirOwnRunsOnly) {
  simulate(order_of_seven_runs(), {2, 3});
  std::vector<std::size_t> runs{};
  const TableShard second = read_table_shard(file_of({2, 3}));
  for (const auto& [run, rows] : second.lines) {
    runs.push_back(run);
    EXPECT_TRUE(rows.starts_with(std::to_string(run) + '\t')) << rows;
  }
  EXPECT_THAT(runs, ElementsAre(1, 4));
}

TEST_F(PowerShards, AreNotSimulatedAgainNorReplacedByThoseOfOtherInputs) {
  const PowerOrder order = order_of_seven_runs();
  simulate(order, {1, 2});
  const std::string before = read_file(file_of({1, 2}));
  EXPECT_EQ(simulate(order, {1, 2}), PowerShard::stored_before);
  PowerOrder other = order;
  other.seed = 4;
  PowerOrder longer = order;
  longer.runs = kSevenRuns + 1;
  for (const PowerOrder& wrong : {other, longer}) {
    EXPECT_THAT(refusal_of([&] {
                  simulate(wrong, {1, 2});
                }),
                AllOf(HasSubstr(file_of({1, 2}).string()), HasSubstr("of another computation"),
                      HasSubstr("--force")));
  }
  EXPECT_EQ(read_file(file_of({1, 2})), before);
}

TEST_F(PowerShards, AreNotMoreThanTheRuns) {
  EXPECT_THAT(refusal_of<std::invalid_argument>([&] {
                simulate(order_of_seven_runs(), {1, kSevenRuns + 1});
              }),
              HasSubstr("divides 7 runs among 8 shards; divide them among at most 7"));
}

TEST_F(PowerShards, WriteNothingWhenTheyAreStopped) {
  std::stop_source source{};
  source.request_stop();
  EXPECT_EQ(simulate(order_of_seven_runs(), {1, 2}, source.get_token()), PowerShard::stopped);
  EXPECT_TRUE(fs::is_empty(folder_ / "out"));
}

}  // namespace
}  // namespace asperity
