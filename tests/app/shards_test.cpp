// A computation in shards: any division gives the bytes of the whole, and what does not belong together is refused.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/shards/study_shard.h"
#include "app/shards/table_shard.h"
#include "app/sweep/sweep_shard.h"
#include "renderers/built_in_models.h"
#include "results_schema/part_files.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

TEST(Shard, HasEveryItemOnceWithTheOthers) {
  for (const int count : {1, 2, 3, 7}) {
    std::vector<int> owners(20, 0);
    for (int index = 1; index <= count; ++index) {
      const Shard shard{index, count};
      std::size_t items = 0;
      for (std::size_t item = 0; item < owners.size(); ++item) {
        if (!shard.has(item)) continue;
        ++owners[item];
        ++items;
      }
      EXPECT_EQ(shard.number_of(owners.size()), items) << text_of(shard);
    }
    EXPECT_THAT(owners, testing::Each(1)) << count;
  }
}

TEST(Shard, IsReadAsItIsWritten) {
  EXPECT_EQ(shard_in("3/7"), (Shard{3, 7}));
  EXPECT_EQ(text_of(Shard{3, 7}), "3/7");
  EXPECT_EQ(shard_in("1/1"), Shard{});
  for (const char* const wrong : {"", "3", "3/", "/7", "0/7", "8/7", "-1/7", "+1/7", "1/7 ", " 1/7",
                                  "1/7/2", "1.0/7", "1/1001", "99999999999/99999999999"}) {
    EXPECT_FALSE(shard_in(wrong)) << wrong;
  }
}

TEST(Shard, IsNamedAfterTheWhole) {
  EXPECT_EQ(shard_path("a/sweep.tsv", {3, 7}), "a/sweep.tsv.shard-3-of-7");
  EXPECT_EQ(shard_path("studies/mine/", {1, 2}), "studies/mine.shard-1-of-2");
}

/// Seven spacings under two probes.
SweepOrder small_order() {
  static const ModelRegistry kModels = built_in_models();
  SweepOrder order{.varied = VariedQuantity::applied_force, .values = {0.5, 1.0}};
  order.stroke.model = kModels.find("bump_map");
  order.spacings_m = logarithmic_spacings(0.001, 0.004, 7);
  order.texture = {.kind = "sinusoid", .values = {{"amplitude_m", 1e-4}}};
  return order;
}

const std::function<void(double)> kNobody{};

std::string text_in(const fs::path& file) { return read_file(file); }

class SweepShards : public testing::Test {
 protected:
  fs::path compute(const SweepOrder& order, const Shard& shard,
                   Overwrite overwrite = Overwrite::refuse) const {
    const SweepFile file{.out = folder_ / "sweep.tsv", .overwrite = overwrite};
    EXPECT_TRUE(sweep_into_shard(order, shard, file, {}, kNobody).is_complete);
    return shard_path(file.out, shard);
  }
  std::vector<fs::path> compute_all(const SweepOrder& order, int count) const {
    std::vector<fs::path> files{};
    for (int index = 1; index <= count; ++index) files.push_back(compute(order, {index, count}));
    return files;
  }

  TemporaryFolder folder_{};
};

TEST_F(SweepShards, GiveTheBytesOfTheWholeForAnyDivision) {
  const SweepOrder order = small_order();
  const fs::path whole = folder_ / "whole.tsv";
  ASSERT_TRUE(sweep_into_file(order, {.out = whole}, {}, kNobody).is_complete);
  for (const int count : {1, 2, 3, 7}) {
    std::vector<fs::path> files = compute_all(order, count);
    std::reverse(files.begin(), files.end());
    const GatheredTable joined = gathered(files);
    EXPECT_EQ(joined.table, text_in(whole)) << count;
    EXPECT_EQ(joined.whole.declaration, text_in(declaration_beside(whole))) << count;
    EXPECT_EQ(joined.shards, count);
  }
}

TEST_F(SweepShards, ComputeTheirOwnSpacingsOnly) {
  const TableShard second = read_table_shard(compute(small_order(), {2, 3}));
  // Spacings 1 and 4 of 7, for both forces.
  std::vector<std::size_t> numbers{};
  for (const auto& [number, lines] : second.lines) numbers.push_back(number);
  EXPECT_EQ(numbers, (std::vector<std::size_t>{1, 4, 8, 11}));
  EXPECT_EQ(second.identity.whole.results, 14U);
}

TEST_F(SweepShards, AreNotComputedAgainWhereTheyAreStored) {
  const fs::path file = compute(small_order(), {1, 2});
  const auto written = fs::last_write_time(file);
  const std::string before = text_in(file);
  const Sweep repeated =
      sweep_into_shard(small_order(), {1, 2}, {.out = folder_ / "sweep.tsv"}, {}, kNobody);
  EXPECT_TRUE(repeated.is_complete);
  EXPECT_TRUE(repeated.rows.empty());
  EXPECT_EQ(fs::last_write_time(file), written);
  EXPECT_EQ(text_in(compute(small_order(), {1, 2}, Overwrite::allow)), before);
}

TEST_F(SweepShards, AreNotReplacedByThoseOfAnotherSweep) {
  const fs::path file = compute(small_order(), {1, 2});
  SweepOrder other = small_order();
  other.stroke.speed_m_per_s = 0.05;
  const SweepFile out{.out = folder_ / "sweep.tsv"};
  EXPECT_THAT(
      refusal_of([&] {
        sweep_into_shard(other, {1, 2}, out, {}, kNobody);
      }),
      AllOf(HasSubstr(file.string()), HasSubstr("of another computation"), HasSubstr("--force")));
}

TEST_F(SweepShards, AreNotMoreThanTheSpacings) {
  const SweepFile out{.out = folder_ / "sweep.tsv"};
  EXPECT_THAT(refusal_of([&] {
                sweep_into_shard(small_order(), {1, 8}, out, {}, kNobody);
              }),
              HasSubstr("divides 7 spacings among 8 shards; divide them among at most 7"));
}

TEST_F(SweepShards, WriteNothingWhenTheyAreStopped) {
  std::stop_source source{};
  source.request_stop();
  const SweepFile out{.out = folder_ / "sweep.tsv"};
  const Sweep stopped = sweep_into_shard(small_order(), {1, 2}, out, source.get_token(), kNobody);
  EXPECT_FALSE(stopped.is_complete);
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

/// Shards of a table with the rows 0 to 4, without a computation.
class TableShards : public testing::Test {
 protected:
  static constexpr std::size_t kRows = 5;

  static TableShard shard_of(const Shard& shard, const std::string& declaration = "{}\n",
                             const std::string& program = "asperity 1") {
    Table table{.columns = {"name"}};
    std::vector<std::size_t> numbers{};
    for (std::size_t row = 0; row < kRows; ++row) {
      if (!shard.has(row)) continue;
      numbers.push_back(row);
      table.rows.push_back({"row " + std::to_string(row)});
    }
    return table_shard(
        {{.command = "made_up", .declaration = declaration, .results = kRows, .program = program},
         shard},
        table, numbers);
  }
  fs::path stored(const std::string& name, const TableShard& shard) const {
    store(folder_ / name, shard, Overwrite::refuse);
    return folder_ / name;
  }
  fs::path written(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  TemporaryFolder folder_{};
};

TEST_F(TableShards, AreJoinedInTheOrderOfTheirRows) {
  const fs::path two = stored("two", shard_of({2, 2}));
  const fs::path one = stored("one", shard_of({1, 2}));
  EXPECT_EQ(gathered({two, one}).table, "name\nrow 0\nrow 1\nrow 2\nrow 3\nrow 4\n");
}

TEST_F(TableShards, HaveSeveralRowsOfAResult) {
  const auto part = [](const Shard& shard, const std::vector<std::size_t>& numbers) {
    Table table{.columns = {"name"}};
    for (std::size_t row = 0; row < numbers.size(); ++row) {
      table.rows.push_back({std::to_string(numbers[row]) + ", row " + std::to_string(row)});
    }
    return table_shard({{.command = "made_up", .declaration = "{}", .results = 3}, shard}, table,
                       numbers);
  };
  const TableShard first = part({1, 2}, {0, 0, 2});
  const fs::path one = stored("one", first);
  EXPECT_EQ(read_table_shard(one), first);
  const GatheredTable joined = gathered({stored("two", part({2, 2}, {1, 1})), one});
  EXPECT_EQ(joined.table, "name\n0, row 0\n0, row 1\n1, row 0\n1, row 1\n2, row 2\n");
  EXPECT_EQ(joined.rows, 5U);
}

TEST_F(TableShards, AreReadAsTheyWereStored) {
  const TableShard shard = shard_of({2, 3}, "{\n  \"a tab\": \"\\t\", \"é\": 0.1\n}\n");
  EXPECT_EQ(read_table_shard(stored("shard", shard)), shard);
}

TEST_F(TableShards, ThatAreMissingAreNamed) {
  const fs::path whole = folder_ / "sweep.tsv";
  const fs::path second = shard_path(whole, {2, 4});
  store(second, shard_of({2, 4}), Overwrite::refuse);
  EXPECT_THAT(refusal_of([&] { (void)gathered({second}); }),
              AllOf(HasSubstr("missing: "), HasSubstr(shard_path(whole, {1, 4}).string()),
                    Not(HasSubstr(second.string())), HasSubstr(shard_path(whole, {3, 4}).string()),
                    HasSubstr(shard_path(whole, {4, 4}).string())));
  EXPECT_THAT(refusal_of([&] {
                (void)gathered({stored("renamed", shard_of({1, 3}))});
              }),
              HasSubstr("missing: shard 2/3 and shard 3/3"));
}

TEST_F(TableShards, HaveAllResultsOfTheWhole) {
  TableShard one = shard_of({1, 2});
  one.lines.erase(2);
  const fs::path incomplete = stored("one", one);
  const fs::path two = stored("two", shard_of({2, 2}));
  EXPECT_THAT(refusal_of([&] {
                (void)gathered({incomplete, two});
              }),
              HasSubstr("the shards have 4 of 5 results"));
}

TEST_F(TableShards, OfOtherComputationsAreNamed) {
  const fs::path one = stored("one", shard_of({1, 2}));
  const auto refused_with = [&](const fs::path& other) {
    return refusal_of([&] { (void)gathered({one, other}); });
  };
  const auto naming = [&](const fs::path& other, const std::string& why) {
    return HasSubstr(other.string() + " does not belong to the computation of " + one.string() +
                     ": " + why);
  };
  const fs::path options = stored("options", shard_of({2, 2}, "{\"seed\": 2}\n"));
  EXPECT_THAT(refused_with(options), naming(options, "the options"));
  const fs::path program = stored("program", shard_of({2, 2}, "{}\n", "asperity 2"));
  EXPECT_THAT(refused_with(program),
              naming(program, "it was computed by asperity 2, not by asperity 1"));
  const fs::path division = stored("division", shard_of({2, 3}));
  EXPECT_THAT(refused_with(division), naming(division, "it is shard 2/3, not one of 2"));
}

// Any single byte, and every length.
TEST_F(TableShards, ThatAreDamagedAreNamed) {
  const std::string text = text_of(shard_of({1, 1}));
  ASSERT_EQ(gathered({written("whole", text)}).whole.results, kRows);
  for (std::size_t place = 0; place < text.size(); ++place) {
    std::string changed = text;
    changed[place] = static_cast<char>(changed[place] ^ 1);
    const fs::path file = written("changed", changed);
    EXPECT_THAT(refusal_of([&] { (void)gathered({file}); }),
                AllOf(HasSubstr(file.string()), HasSubstr("damaged")))
        << place;
    const fs::path cut = written("cut", text.substr(0, place));
    EXPECT_THAT(refusal_of([&] { (void)gathered({cut}); }),
                AllOf(HasSubstr(cut.string()), HasSubstr("damaged")))
        << place;
  }
}

TEST_F(TableShards, MayBeNamedTwiceWithTheSameBytesOnly) {
  const fs::path one = stored("one", shard_of({1, 2}));
  const fs::path copy = stored("copy", shard_of({1, 2}));
  const fs::path two = stored("two", shard_of({2, 2}));
  EXPECT_EQ(gathered({one, two, copy}).table, gathered({one, two}).table);
  TableShard changed = shard_of({1, 2});
  changed.lines[2] = "another row\n";
  const fs::path other = stored("other", changed);
  EXPECT_THAT(refusal_of([&] {
                (void)gathered({one, two, other});
              }),
              AllOf(HasSubstr(one.string()), HasSubstr(other.string()),
                    HasSubstr("are both shard 1/2 and differ")));
}

TEST_F(TableShards, AreStoredTwiceWithTheSameBytesOnly) {
  const fs::path file = stored("shard", shard_of({1, 2}));
  const std::string before = text_in(file);
  store(file, shard_of({1, 2}), Overwrite::refuse);
  TableShard changed = shard_of({1, 2});
  changed.lines[2] = "another row\n";
  EXPECT_THAT(refusal_of([&] { store(file, changed, Overwrite::refuse); }),
              AllOf(HasSubstr(file.string()), HasSubstr("other bytes")));
  EXPECT_EQ(text_in(file), before);
  store(file, changed, Overwrite::allow);
  EXPECT_EQ(read_table_shard(file), changed);
}

/// Folders that state which shard of a simulation they are, without rows.
class StudyShards : public testing::Test {
 protected:
  static ShardIdentity shard_of(const Shard& shard, const std::string& declaration = "{}") {
    return {.whole = {.command = "simulate",
                      .declaration = declaration,
                      .results = 9,
                      .program = "asperity 1"},
            .shard = shard};
  }
  fs::path marked(const std::string& name, const ShardIdentity& identity) const {
    fs::create_directory(folder_ / name);
    write_study_shard(folder_ / name, identity);
    return folder_ / name;
  }

  TemporaryFolder folder_{};
};

TEST_F(StudyShards, StateWhatTheyAre) {
  const ShardIdentity identity = shard_of({2, 3}, "{\"seed\": \"18446744073709551615\"}");
  EXPECT_EQ(study_shard(marked("a", identity)), identity);
  EXPECT_EQ(study_shard(folder_.path()), std::nullopt);
}

TEST_F(StudyShards, AreRefusedWhereWhatTheyStateWasChanged) {
  const fs::path study = marked("a", shard_of({2, 3}));
  const fs::path file = study / kShardFile;
  const std::string text = text_in(file);
  const auto refused_with = [&](const std::string& before, const std::string& after) {
    std::string changed = text;
    changed.replace(changed.find(before), before.size(), after);
    std::ofstream(file, std::ios::binary) << changed;
    return refusal_of([&] { (void)study_shard(study); });
  };
  for (const auto& [before, after] :
       {std::pair{"\"simulate\"", "\"sweep\""}, std::pair{": 9", ": 8"},
        std::pair{": 9", ": \"9\""}, std::pair{"\"shard\": 2", "\"shard\": 4"},
        std::pair{"\"of\"", "\"off\""}}) {
    EXPECT_THAT(refused_with(before, after), AllOf(HasSubstr(file.string()), HasSubstr("damaged")))
        << after;
  }
  EXPECT_THAT(refused_with("shard/1", "shard/2"), HasSubstr("does not have the format"));
}

TEST_F(StudyShards, AreMergedOnlyIfAllAreThereOnce) {
  const fs::path station = folder_ / "station";
  fs::create_directory(station);
  const fs::path one = marked("study.shard-1-of-3", shard_of({1, 3}));
  const fs::path two = marked("study.shard-2-of-3", shard_of({2, 3}));
  const fs::path three = folder_ / "study.shard-3-of-3";
  EXPECT_THAT(refusal_of([&] {
                require_complete_divisions({one, station, two});
              }),
              AllOf(HasSubstr("missing of the simulation of " + one.string()),
                    HasSubstr(three.string()), Not(HasSubstr(two.string()))));
  marked("study.shard-3-of-3", shard_of({3, 3}));
  require_complete_divisions({three, one, station, two});
  require_complete_divisions({station});
  const fs::path again = marked("again", shard_of({2, 3}));
  EXPECT_THAT(
      refusal_of([&] {
        require_complete_divisions({one, two, three, again});
      }),
      AllOf(HasSubstr(two.string()), HasSubstr(again.string()), HasSubstr("are both shard 2/3")));
  // Computed by another program, in place of the one that is missing.
  const fs::path two_of_two = marked(
      "b.shard-2-of-2",
      {.whole = {.command = "simulate", .declaration = "{}", .results = 9, .program = "asperity 2"},
       .shard = {2, 2}});
  const fs::path one_of_two = marked("b.shard-1-of-2", shard_of({1, 2}));
  EXPECT_THAT(
      refusal_of([&] {
        require_complete_divisions({one_of_two, two_of_two});
      }),
      HasSubstr(two_of_two.string() + " is shard 2/2 of another simulation: it was computed "
                                      "by asperity 2, not by asperity 1; simulate"));
  // Of another simulation: its first shard is missing.
  const fs::path foreign = marked("other.shard-2-of-2", shard_of({2, 2}, "{\"seed\": 2}"));
  EXPECT_THAT(refusal_of([&] {
                require_complete_divisions({one, two, three, foreign});
              }),
              HasSubstr((folder_ / "other.shard-1-of-2").string()));
}

}  // namespace
}  // namespace asperity
