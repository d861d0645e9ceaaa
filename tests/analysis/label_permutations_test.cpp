// Holds permutations within blocks to ways counted one by one.

#include "analysis/tests/label_permutations.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/tests/profile_comparison.h"
#include "analysis/tests/two_samples.h"

namespace asperity {
namespace {

/// Of all ways in which every block keeps its number of participants of the first group, those with a difference of the means no
/// smaller than the observed one.
double counted_p(const std::vector<double>& numbers, std::size_t first,
                 const std::vector<std::size_t>& blocks) {
  const auto of_first = [&](std::uint32_t way) {
    std::map<std::size_t, int> counts{};
    for (std::size_t i = 0; i < numbers.size(); ++i) counts[blocks[i]] += (way >> i) & 1U ? 1 : 0;
    return counts;
  };
  const auto difference = [&](std::uint32_t way) {
    double sums[2] = {0.0, 0.0};
    for (std::size_t i = 0; i < numbers.size(); ++i) sums[(way >> i) & 1U ? 0 : 1] += numbers[i];
    return std::abs(sums[0] / static_cast<double>(first) -
                    sums[1] / static_cast<double>(numbers.size() - first));
  };
  const std::uint32_t observed = (1U << first) - 1U;
  double ways = 0.0;
  double as_far = 0.0;
  for (std::uint32_t way = 0; way < (1U << numbers.size()); ++way) {
    if (of_first(way) != of_first(observed)) continue;
    ways += 1.0;
    as_far += difference(way) >= difference(observed) - 1e-12 ? 1.0 : 0.0;
  }
  return as_far / ways;
}

TEST(LabelPermutations, CountAllWaysWithinTheBlocks) {
  const std::vector<double> numbers{4.0, 9.5, 1.0, 7.0, 7.5, 3.0, 8.0, 2.0, 5.5, 6.0};
  const std::vector<double> first(numbers.begin(), numbers.begin() + 4);
  const std::vector<double> second(numbers.begin() + 4, numbers.end());
  // Blocks of four, of three, of two, and of a single participant, whose label cannot change.
  for (const auto& blocks :
       {std::vector<std::size_t>{0, 0, 1, 2, 0, 0, 1, 1, 2, 3},
        std::vector<std::size_t>{5, 6, 5, 6, 5, 6, 5, 6, 5, 6}, std::vector<std::size_t>(10, 0)}) {
    EXPECT_NEAR(permutation_test({.first = first, .second = second}, blocks).p,
                counted_p(numbers, 4, blocks), 1e-14);
  }
  EXPECT_EQ(
      permutation_test({.first = first, .second = second}).p,
      permutation_test({.first = first, .second = second}, std::vector<std::size_t>(10, 7)).p);
}

TEST(LabelPermutations, AreTheSameForProfiles) {
  const std::vector<std::vector<double>> first{{1, 2, 5}, {2, 2, 4}, {0, 1, 3}, {2, 0, 3}};
  const std::vector<std::vector<double>> second{{3, 1, 4}, {2, 2, 2}, {4, 0, 3}, {1, 1, 4}};
  const std::vector<std::size_t> blocks{0, 0, 1, 1, 0, 0, 1, 1};
  const double p = compare_profiles(first, second, blocks).p;
  EXPECT_NEAR(p * 36.0, std::round(p * 36.0), 1e-12);
  EXPECT_GE(p, 2.0 / 36.0) << "the mirror image has the same R²";
}

TEST(LabelPermutations, HaveASmallestP) {
  EXPECT_NEAR(smallest_p_of_groups({.first = 4, .second = 4}), 2.0 / 70.0, 1e-15);
  EXPECT_NEAR(smallest_p_of_groups({.first = 3, .second = 4}), 1.0 / 35.0, 1e-15);
  EXPECT_NEAR(smallest_p_of_groups({.first = 13, .second = 12}), 1.0 / 10001.0, 1e-15);
  EXPECT_EQ(smallest_p_of_groups({.first = 0, .second = 4}), 1.0);
  const std::vector<std::size_t> halves{0, 0, 1, 1, 0, 0, 1, 1};
  EXPECT_NEAR(smallest_p_of_groups({.first = 4, .second = 4, .blocks = halves}), 2.0 / 36.0, 1e-15);
  // Without a mirror image: one of three and three of four.
  const std::vector<std::size_t> unequal{0, 1, 1, 1, 0, 0, 1};
  EXPECT_NEAR(smallest_p_of_groups({.first = 4, .second = 3, .blocks = unequal}), 1.0 / 12.0,
              1e-15);
  const std::vector<std::size_t> separate{0, 0, 1, 1};
  EXPECT_EQ(smallest_p_of_groups({.first = 2, .second = 2, .blocks = separate}), 1.0);
}

// Of 40 participants in blocks of four, 6¹⁰ ways; in blocks of two 2²⁰, which are enumerated.
TEST(LabelPermutations, AreDrawnWhereThereAreTooMany) {
  std::vector<double> first(20, 1.0);
  std::vector<double> second(20, 0.0);
  std::vector<std::size_t> fours{};
  std::vector<std::size_t> twos{};
  for (std::size_t i = 0; i < 40; ++i) {
    fours.push_back(i % 20 / 2);
    twos.push_back(i % 20);
  }
  const SplitTest drawn = permutation_test({.first = first, .second = second}, fours);
  EXPECT_FALSE(drawn.exact);
  EXPECT_EQ(drawn.p, 1.0 / (kRandomSplits + 1.0));
  const SplitTest counted = permutation_test({.first = first, .second = second}, twos);
  EXPECT_TRUE(counted.exact);
  EXPECT_EQ(counted.p, std::ldexp(2.0, -20));
}

TEST(LabelPermutations, RefuseABlockTooFew) {
  const std::vector<double> numbers{1.0, 2.0};
  EXPECT_THROW(permutation_test({.first = numbers, .second = numbers}, std::vector<std::size_t>(3)),
               std::invalid_argument);
}

}  // namespace
}  // namespace asperity
