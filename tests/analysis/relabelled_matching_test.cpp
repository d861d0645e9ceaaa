// Holds the null of participants to counted relabellings, and its test to its size.

#include "analysis/choices/relabelled_matching.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

using Trial = std::vector<MatchedItem>;

Trial permutation_trial(const std::vector<std::size_t>& chosen) {
  Trial trial{};
  for (std::size_t i = 0; i < chosen.size(); ++i) trial.push_back({.felt = i, .chosen = chosen[i]});
  return trial;
}

std::vector<RepeatedTrial> repeated(const std::vector<Trial>& trials) {
  std::vector<RepeatedTrial> each{};
  for (const Trial& trial : trials) each.push_back({.items = trial});
  return each;
}

std::size_t right_in(const std::vector<Trial>& trials) {
  std::size_t right = 0;
  for (const Trial& trial : trials) right += fixed_points(trial);
  return right;
}

/// The same by trying every relabelling of the `items` pictures.
struct Counted {
  std::vector<double> right{};
  std::vector<double> whole{};
};
Counted all_relabellings(const std::vector<Trial>& trials, std::size_t items) {
  std::vector<std::size_t> name(items);
  std::iota(name.begin(), name.end(), std::size_t{0});
  Counted counted{.right = std::vector<double>(trials.size() * items + 1),
                  .whole = std::vector<double>(trials.size() + 1)};
  double all = 0.0;
  do {
    std::size_t right = 0;
    std::size_t whole = 0;
    for (Trial trial : trials) {
      for (MatchedItem& item : trial) {
        if (item.chosen) item.chosen = name[*item.chosen];
      }
      right += fixed_points(trial);
      whole += fixed_points(trial) == trial.size() ? 1U : 0U;
    }
    counted.right[right] += 1.0;
    counted.whole[whole] += 1.0;
    all += 1.0;
  } while (std::next_permutation(name.begin(), name.end()));
  for (double& one : counted.right) one /= all;
  for (double& one : counted.whole) one /= all;
  return counted;
}

void expect_distribution(const IntegerDistribution& got, const std::vector<double>& expected) {
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(got.at(static_cast<std::int64_t>(k)), expected[k], 1e-15) << k;
  }
}

TEST(RelabelledMatching, OfOneTrialIsThatOfFixedPoints) {
  const std::vector<Trial> trials{permutation_trial({1, 0, 2, 3})};
  const RelabelledMatching null(repeated(trials));
  expect_distribution(null.right(), fixed_point_distribution(4));
  EXPECT_DOUBLE_EQ(null.right().smallest_upper_tail(), 1.0 / 24.0);
}

TEST(RelabelledMatching, OfRepeatedTrialsIsThatOfAllRelabellings) {
  Random random(7);
  for (std::size_t items = 1; items <= 5; ++items) {
    std::vector<Trial> trials{};
    std::vector<std::size_t> chosen(items);
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    for (int trial = 0; trial < 4; ++trial) {
      trials.push_back(permutation_trial(chosen));
      if (trial > 0) random.shuffle(std::span(chosen));
    }
    const RelabelledMatching null(repeated(trials));
    const Counted counted = all_relabellings(trials, items);
    expect_distribution(null.right(), counted.right);
    expect_distribution(null.whole().value(), counted.whole);
  }
}

// Three trials with one mapping: 0, 3, 6 or 12 right items, as often as 0, 1, 2 or 4 of one trial.
TEST(RelabelledMatching, OfAKeptMappingIsThatOfOneTrialTimesTheirNumber) {
  const Trial kept = permutation_trial({2, 0, 1, 3});
  const std::vector<RepeatedTrial> trials{{.items = kept, .times = 3}};
  const RelabelledMatching null(trials);
  expect_distribution(null.right(),
                      {9.0 / 24.0, 0, 0, 8.0 / 24.0, 0, 0, 6.0 / 24.0, 0, 0, 0, 0, 0, 1.0 / 24.0});
  expect_distribution(null.whole().value(), {23.0 / 24.0, 0, 0, 1.0 / 24.0});
}

TEST(RelabelledMatching, CountsBlanksAndRepeatedPictures) {
  const std::vector<Trial> trials{
      {{.felt = 0, .chosen = 1}, {.felt = 1, .chosen = 1}, {.felt = 2, .chosen = std::nullopt}},
      permutation_trial({0, 2, 1})};
  const RelabelledMatching null(repeated(trials));
  expect_distribution(null.right(), all_relabellings(trials, 3).right);
  EXPECT_FALSE(null.whole().has_value());
}

TEST(RelabelledMatching, ExchangesOnlyPicturesOfTheSameTrials) {
  const std::vector<Trial> apart{
      permutation_trial({0, 1}),
      {{.felt = 2, .chosen = 2}, {.felt = 3, .chosen = 4}, {.felt = 4, .chosen = 3}}};
  const RelabelledMatching null(repeated(apart));
  expect_distribution(null.right(), sum_of(RelabelledMatching(repeated({apart[0]})).right(),
                                           RelabelledMatching(repeated({apart[1]})).right())
                                        .probability);
  EXPECT_TRUE(null.whole().has_value());
  // 0 and 1 are felt together, 2 without them as well: it is always right where it was chosen for itself.
  const std::vector<Trial> nested{permutation_trial({0, 1}), permutation_trial({1, 0, 2})};
  const RelabelledMatching overlapping(repeated(nested));
  EXPECT_EQ(overlapping.right().at(3), 1.0);
  EXPECT_FALSE(overlapping.whole().has_value());
}

TEST(RelabelledMatching, OfOneItemIsThatOfARandomPicture) {
  const std::vector<Trial> trials{permutation_trial({0, 1, 2}), permutation_trial({0, 2, 1})};
  const RelabelledMatching null(repeated(trials));
  expect_distribution(null.right_of(0), {2.0 / 3.0, 0.0, 1.0 / 3.0});
  expect_distribution(null.right_of(1), {1.0 / 3.0, 2.0 / 3.0});
  EXPECT_FALSE(null.presents(3));
}

TEST(RelabelledMatching, CountsTwelveItemsAndRefusesMore) {
  std::vector<std::size_t> chosen(12);
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  const std::vector<Trial> twelve{permutation_trial(chosen), permutation_trial(chosen)};
  EXPECT_DOUBLE_EQ(RelabelledMatching(repeated(twelve)).right().at(24), whole_chance(12));
  chosen.push_back(12);
  const std::vector<Trial> thirteen{permutation_trial(chosen)};
  EXPECT_THROW(RelabelledMatching(repeated(thirteen)), std::invalid_argument);
}

// 20 guessers who keep one mapping of four pictures through three trials. Counted as 60 independent permutations, the
// test at .05 rejects for 73 right items or more: about .157 of such studies.
TEST(RelabelledMatching, TestsGuessersWhoKeepTheirMappingAtTheNominalSize) {
  constexpr int kStudies = 4000;
  constexpr std::size_t kParticipants = 20;
  const MatchingNull pooled({.items = 4, .assignments = 3 * kParticipants});
  Random random(2);
  std::vector<std::size_t> chosen(4);
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  int rejected = 0;
  int rejected_pooled = 0;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<IntegerDistribution> own{};
    std::size_t right = 0;
    for (std::size_t participant = 0; participant < kParticipants; ++participant) {
      random.shuffle(std::span(chosen));
      const std::vector<Trial> trials(3, permutation_trial(chosen));
      own.push_back(RelabelledMatching(repeated(trials)).right());
      right += right_in(trials);
    }
    rejected += sum_of_all(own).upper_tail(static_cast<std::int64_t>(right)) <= 0.05 ? 1 : 0;
    rejected_pooled += pooled.upper_tail(right) <= 0.05 ? 1 : 0;
  }
  EXPECT_LE(rejected, kStudies * 0.05);
  EXPECT_GE(rejected, kStudies * 0.03);
  EXPECT_GE(rejected_pooled, kStudies * 0.13);
}

}  // namespace
}  // namespace asperity
