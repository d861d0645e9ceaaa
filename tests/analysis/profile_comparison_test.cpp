// Holds the permutation test of profiles to divisions counted by hand, and to an independent count of all of them.

#include "analysis/tests/profile_comparison.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

using Group = std::vector<std::vector<double>>;

/// R² from its definition, and the proportion of all divisions with at least this R².
ProfileComparison counted(const Group& first, const Group& second) {
  Group all = first;
  all.insert(all.end(), second.begin(), second.end());
  const std::size_t items = all.front().size();
  for (auto& profile : all) {
    double mean = 0.0;
    for (const double number : profile) mean += number / static_cast<double>(items);
    for (double& number : profile) number -= mean;
  }
  const auto r2_of = [&](std::uint32_t in_first) {
    double between = 0.0;
    double total = 0.0;
    for (std::size_t j = 0; j < items; ++j) {
      double sums[2] = {0.0, 0.0};
      double sizes[2] = {0.0, 0.0};
      for (std::size_t i = 0; i < all.size(); ++i) {
        const std::size_t group = (in_first >> i) & 1U ? 0 : 1;
        sums[group] += all[i][j];
        sizes[group] += 1.0;
      }
      const double mean = (sums[0] + sums[1]) / static_cast<double>(all.size());
      for (std::size_t i = 0; i < all.size(); ++i) {
        total += (all[i][j] - mean) * (all[i][j] - mean);
        const std::size_t group = (in_first >> i) & 1U ? 0 : 1;
        between += std::pow(sums[group] / sizes[group] - mean, 2);
      }
    }
    return between / total;
  };
  const std::uint32_t observed = (1U << first.size()) - 1U;
  double ways = 0.0;
  double as_far = 0.0;
  for (std::uint32_t division = 0; division < (1U << all.size()); ++division) {
    if (std::popcount(division) != static_cast<int>(first.size())) continue;
    ways += 1.0;
    as_far += r2_of(division) >= r2_of(observed) - 1e-12 ? 1.0 : 0.0;
  }
  return {.r2 = r2_of(observed), .p = as_far / ways};
}

// Without their means the first are (3, −3), (2, −2), (2.5, −2.5) twice and the second their negative: between the groups
// 8·2·2.5² = 100, within them 4·(0.5² + 0.5²) = 2. Of 70 divisions this one and its mirror image have the largest R².
TEST(ProfileComparison, IsTheProportionOfTheSquaresBetweenTheGroups) {
  const Group first{{7, 1}, {6, 2}, {7, 2}, {6, 1}};
  const Group second{{1, 7}, {2, 6}, {2, 7}, {1, 6}};
  const ProfileComparison compared = compare_profiles(first, second);
  EXPECT_NEAR(compared.r2, 100.0 / 102.0, 1e-14);
  EXPECT_NEAR(compared.p, 2.0 / 70.0, 1e-14);
  EXPECT_TRUE(compared.exact);
}

TEST(ProfileComparison, CountsAllDivisionsOfGroupsOfAnySize) {
  Random random(7);
  for (const std::size_t size : {2U, 3U, 5U}) {
    Group first{};
    Group second{};
    for (std::size_t i = 0; i < size; ++i)
      first.push_back({random.normal(), 1.0, 2.0 * random.normal()});
    for (std::size_t i = 0; i < 4; ++i)
      second.push_back({0.5 + random.normal(), 0.3, random.normal()});
    const ProfileComparison compared = compare_profiles(first, second);
    const ProfileComparison expected = counted(first, second);
    EXPECT_NEAR(compared.r2, expected.r2, 1e-12) << size;
    EXPECT_NEAR(compared.p, expected.p, 1e-12) << size;
  }
}

// Level and unit are not what is compared.
TEST(ProfileComparison, IsTheSameAtAnyLevelAndInAnyUnit) {
  const Group first{{1, 2, 5}, {2, 2, 4}, {0, 1, 3}};
  const Group second{{3, 1, 4}, {2, 2, 2}, {4, 0, 3}};
  const ProfileComparison compared = compare_profiles(first, second);
  for (const double unit : {1e-15 / 3.0, 0.1, 1e12 / 3.0}) {
    Group other = first;
    Group others = second;
    double level = -1000.0;
    for (Group* const group : {&other, &others}) {
      for (auto& profile : *group) {
        level += 300.0;
        for (double& number : profile) number = (number + level) * unit;
      }
    }
    const ProfileComparison same = compare_profiles(other, others);
    EXPECT_NEAR(same.r2, compared.r2, 1e-9) << unit;
    EXPECT_EQ(same.p, compared.p) << unit;
  }
}

// Of two participants both divisions have the same R², also where they hardly differ and rounding makes one of them the greater.
TEST(ProfileComparison, OfTwoParticipantsIsNeverSignificant) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    Group first{{}};
    Group second{{}};
    for (const double form : {1000.0, -400.0, 30.0}) {
      first.front().push_back(form + 1e-3 * random.normal());
      second.front().push_back(form + 1e-3 * random.normal());
    }
    EXPECT_EQ(compare_profiles(first, second).p, 1.0);
  }
}

TEST(ProfileComparison, OfEqualProfilesIsNotDefined) {
  const Group same{{0.1, 0.3, 0.7}, {1.1, 1.3, 1.7}};
  EXPECT_TRUE(std::isnan(compare_profiles(same, same).r2));
  EXPECT_EQ(compare_profiles(same, same).p, 1.0);
}

// With 13 participants in each group there are too many divisions: p is that of 10 000 random ones and the observed one.
TEST(ProfileComparison, DrawsDivisionsWhereThereAreTooMany) {
  Group first{};
  Group second{};
  for (std::size_t i = 0; i < 13; ++i) {
    first.push_back({1.0 + 0.01 * static_cast<double>(i), 0.0});
    second.push_back({0.0, 1.0 + 0.01 * static_cast<double>(i)});
  }
  const ProfileComparison compared = compare_profiles(first, second);
  EXPECT_FALSE(compared.exact);
  EXPECT_NEAR(compared.p, 1.0 / 10001.0, 1e-15);
}

TEST(ProfileComparison, RefusesGroupsThatItCannotCompare) {
  const Group pair{{1, 2}};
  EXPECT_THROW(compare_profiles(Group{}, pair), std::invalid_argument);
  EXPECT_THROW(compare_profiles(pair, Group{{1, 2, 3}}), std::invalid_argument);
  EXPECT_THROW(compare_profiles(Group{{1}}, Group{{2}}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
