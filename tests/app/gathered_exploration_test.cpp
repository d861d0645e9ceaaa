// The exploration of a study as it is kept: own values by condition, contact times by surface, and little memory.

#include "app/findings/gathering/gathered_exploration.h"

#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <malloc.h>

#include "app/findings/gathering/gathered_answers.h"

namespace asperity {
namespace {

/// Adds answers with their explorations, as a study is read.
class ReadExploration final {
 public:
  ReadExploration() {
    gathered.words.place("");
    gathered.factor_levels.emplace_back();
  }

  void begin_participant() {
    gathered.exploration.end_participant(gathered);
    gathered.people.push_back({.label = "p" + std::to_string(gathered.people.size())});
  }
  /// With a surface for each contact time, which are the items "first", "second" …
  void add_trial(const std::string& texture, const std::vector<double>& contact_s,
                 double force_N = 1.0) {
    const std::uint32_t level = gathered.words.place(texture);
    const auto combination = static_cast<std::uint32_t>(gathered.factor_levels.size());
    gathered.factor_levels.push_back({{"texture", level}});
    gathered.answers.push_back({.person = static_cast<std::uint32_t>(gathered.people.size() - 1),
                                .block = gathered.words.place("main"),
                                .factors = combination,
                                .response_time_s = contact_s.front() + 10.0,
                                .surface_count = static_cast<std::uint16_t>(contact_s.size()),
                                .first_surface = gathered.surfaces.size()});
    std::vector<SessionAnswers::Exploration> explored{};
    for (const double one : contact_s) {
      gathered.surfaces.push_back(
          {.item = gathered.words.place(explored.empty() ? "first" : "second")});
      explored.push_back({.contact_s = one, .force_N = force_N});
    }
    gathered.exploration.add(explored);
  }
  std::vector<OwnValue> own(const ExploredCondition& condition, Explored quantity) {
    const auto values = gathered.exploration.own_values(condition, quantity);
    return {values.begin(), values.end()};
  }
  ExploredCondition with_texture(const std::string& texture) {
    return {.by = ExploredBy::trial, .factor = "texture", .level = gathered.words.place(texture)};
  }
  ExploredCondition of_item(const std::string& item) {
    return {.by = ExploredBy::item, .level = gathered.words.place(item)};
  }

  GatheredAnswers gathered{};
};

TEST(GatheredExploration, KeepsOwnValuesByCondition) {
  ReadExploration read{};
  read.begin_participant();
  read.add_trial("wood", {1.0, 5.0}, 1.0);
  read.add_trial("wood", {2.0, 4.0}, 4.0);
  read.add_trial("metal", {7.0, 9.0}, 2.0);
  read.begin_participant();
  read.add_trial("wood", {8.0, 6.0});
  read.gathered.exploration.end_participant(read.gathered);

  const auto all = read.own({}, Explored::contact_s);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].measurements, 6U);
  EXPECT_EQ(all[0].value, 4.5);  // median of 1, 2, 4, 5, 7, 9
  EXPECT_EQ(all[1].participant, 1U);
  EXPECT_EQ(all[1].value, 7.0);

  const auto wood = read.own(read.with_texture("wood"), Explored::contact_s);
  ASSERT_EQ(wood.size(), 2U);
  EXPECT_EQ(wood[0].measurements, 4U);
  EXPECT_EQ(wood[0].value, 3.0);
  EXPECT_EQ(read.own(read.with_texture("metal"), Explored::contact_s).size(), 1U);
  // A force is averaged: 1, 1, 4, 4 N.
  EXPECT_EQ(read.own(read.with_texture("wood"), Explored::force_N)[0].value, 2.5);
  EXPECT_TRUE(read.own(read.with_texture("wood"), Explored::path_m).empty());

  EXPECT_EQ(read.own(read.of_item("second"), Explored::contact_s)[0].value, 5.0);
  EXPECT_EQ(read.own(read.with_texture("wood"), Explored::response_s)[0].value, 11.5);
  // Two surfaces: the response belongs to neither of them.
  EXPECT_TRUE(read.own(read.of_item("second"), Explored::response_s).empty());
}

TEST(GatheredExploration, AssignsTheResponseTimeToTheOnlySurface) {
  ReadExploration read{};
  read.begin_participant();
  read.add_trial("wood", {1.0});
  read.gathered.exploration.end_participant(read.gathered);
  EXPECT_EQ(read.own(read.of_item("first"), Explored::response_s)[0].value, 11.0);
}

TEST(GatheredExploration, KeepsContactTimesBySurface) {
  ReadExploration read{};
  read.begin_participant();
  read.add_trial("wood", {1.0, 0.0});
  read.begin_participant();
  const std::vector<SessionAnswers::Exploration> not_stored(1);
  read.gathered.exploration.add(not_stored);
  EXPECT_EQ(read.gathered.exploration.contact_s(0), 1.0);
  EXPECT_EQ(read.gathered.exploration.contact_s(1), 0.0);
  EXPECT_EQ(read.gathered.exploration.contact_s(2), std::nullopt);
  EXPECT_FALSE(read.gathered.exploration.empty());
}

TEST(GatheredExploration, LeavesOutLevelsThatAProcedureChose) {
  ReadExploration read{};
  Protocol::Block block{};
  block.drawn = {"texture"};
  read.gathered.blocks.emplace("main", block);
  read.begin_participant();
  read.add_trial("wood", {1.0});
  read.gathered.exploration.end_participant(read.gathered);
  EXPECT_TRUE(read.own(read.with_texture("wood"), Explored::contact_s).empty());
  EXPECT_EQ(read.own({}, Explored::contact_s).size(), 1U);
}

std::size_t allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

// Analyses of a million attempts must not need more than 1 GiB. A surface has nine quantities of 16 bytes; a column of
// doubles and two of floats, which grow by doubling, have at most 32. (With a sanitizer no bytes are counted.)
TEST(GatheredExploration, NeedsAFewBytesForEachSurface) {
  constexpr int kReadParticipants = 100;
  constexpr int kReadTrials = 500;
  constexpr int kReadSurfaces = 3;
  ReadExploration read{};
  read.gathered.answers.reserve(kReadParticipants * kReadTrials);
  read.gathered.surfaces.resize(kReadParticipants * kReadTrials * kReadSurfaces);
  const std::vector<SessionAnswers::Exploration> explored(
      kReadSurfaces, {.contact_s = 2.0, .visits = 1.0, .force_N = 1.0, .speed_m_per_s = 0.1});
  const std::size_t before = allocated_bytes();
  std::size_t surfaces = 0;
  for (int participant = 0; participant < kReadParticipants; ++participant) {
    for (int trial = 0; trial < kReadTrials; ++trial) {
      read.gathered.answers.push_back({.person = static_cast<std::uint32_t>(participant),
                                       .surface_count = kReadSurfaces,
                                       .first_surface = surfaces});
      read.gathered.exploration.add(explored);
      surfaces += kReadSurfaces;
    }
    read.gathered.exploration.end_participant(read.gathered);
  }
  const std::size_t after = allocated_bytes();
  EXPECT_LT(static_cast<double>(after - before) / static_cast<double>(surfaces), 36.0);
  EXPECT_EQ(read.own({}, Explored::contact_s).size(), std::size_t{kReadParticipants});
}

}  // namespace
}  // namespace asperity
