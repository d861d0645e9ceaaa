// Holds the generator to published answers, to its own golden numbers, and to its distributions.

#include "analysis/numbers/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

namespace asperity {
namespace {

using Words = std::array<std::uint32_t, 4>;

// The three known answers that come with the reference implementation of [Salmon 2011].
TEST(Philox, GivesThePublishedAnswers) {
  EXPECT_EQ(philox4x32_10({0, 0, 0, 0}, {0, 0}),
            (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(
      philox4x32_10({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
      (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(
      philox4x32_10({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
      (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, DrawsTwoNumbersFromEachBlockLowWordFirst) {
  Random random(0);
  EXPECT_EQ(random.bits(), 0xe169c58d6627e8d5U);
  EXPECT_EQ(random.bits(), 0x9b00dbd8bc57ac4cU);
  const Words second = philox4x32_10({1, 0, 0, 0}, {0, 0});
  EXPECT_EQ(random.bits(), (std::uint64_t{second[1]} << 32) | second[0]);
}

TEST(Random, DrawsAgainWhatItsSeedDrew) {
  Random a(42);
  Random b(42);
  Random c(43);
  const std::uint64_t first = a.bits();
  EXPECT_EQ(first, b.bits());
  EXPECT_NE(first, c.bits());
}

// Golden numbers: whoever changes one of these changes every stored session, and kName with it.
TEST(Random, KeepsItsGoldenNumbers) {
  Random random = Random(20240229).split("golden").split(7);
  EXPECT_EQ(random.bits(), 0x01cba323ee050125U);
  EXPECT_EQ(random.uniform(), 0x1.93109618a915cp-2);
  EXPECT_EQ(random.normal(), 0x1.0683e2da18964p-1);
  EXPECT_EQ(random.normal(), 0x1.9fdfc1acaf093p-1);
  EXPECT_EQ(random.below(1000), 357U);
  std::array<int, 8> order{0, 1, 2, 3, 4, 5, 6, 7};
  random.shuffle(std::span<int>(order));
  EXPECT_EQ(order, (std::array<int, 8>{1, 5, 6, 0, 7, 4, 2, 3}));
}

TEST(Random, KeepsTheBitsOfItsNormalNumbers) {
  EXPECT_EQ(upper_normal_quantile(0.3), 0x1.0c7e39582c5fap-1);
  EXPECT_EQ(upper_normal_quantile(0.01), 0x1.29c5c4630ff0ep+1);
  EXPECT_EQ(upper_normal_quantile(1e-13), 0x1.d652ace3a013p+2);
  Random random(1);
  std::uint64_t folded = 0;
  for (int i = 0; i < 100000; ++i) {
    folded = folded * 31 + std::bit_cast<std::uint64_t>(random.normal());
  }
  EXPECT_EQ(folded, 0xae2a7e4c11fedf32U);
}

TEST(Random, SplitsWithoutMovingItself) {
  Random parent(1);
  Random untouched(1);
  Random child = parent.split("hand");
  child.bits();
  EXPECT_EQ(parent.bits(), untouched.bits());
}

TEST(Random, SplitsTheSameWhateverTheParentHasDrawn) {
  Random parent(1);
  const std::uint64_t before = parent.split("hand").bits();
  parent.bits();
  EXPECT_EQ(parent.split("hand").bits(), before);
}

TEST(Random, TellsNamesNumbersAndTheirOrderApart) {
  const Random root(1);
  std::set<std::uint64_t> firsts;
  firsts.insert(Random(root).bits());
  firsts.insert(root.split("a").bits());
  firsts.insert(root.split("b").bits());
  firsts.insert(root.split("").bits());
  firsts.insert(root.split("ab").bits());
  firsts.insert(root.split("a").split("b").bits());
  firsts.insert(root.split("b").split("a").bits());
  firsts.insert(root.split(0).bits());
  firsts.insert(root.split(1).bits());
  firsts.insert(root.split(std::uint64_t{1} << 32).bits());
  firsts.insert(root.split(std::string_view("\0\0\0\0\0\0\0\0", 8)).bits());
  EXPECT_EQ(firsts.size(), 11U);
}

TEST(Random, GivesAHundredThousandDifferentStreams) {
  const Random root(1);
  std::set<std::uint64_t> firsts;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    firsts.insert(root.split(i).bits());
  }
  EXPECT_EQ(firsts.size(), 100000U);
}

// Neighbouring streams and neighbouring seeds are as good as unrelated: over n pairs the
// correlation has a standard deviation of 1/√n, and five of them are allowed.
TEST(Random, HasUncorrelatedStreams) {
  constexpr int kPairs = 100000;
  const auto correlation = [](Random a, Random b) {
    double sum = 0.0;
    for (int i = 0; i < kPairs; ++i) {
      sum += (a.uniform() - 0.5) * (b.uniform() - 0.5) * 12.0;
    }
    return sum / kPairs;
  };
  const double allowed = 5.0 / std::sqrt(kPairs);
  const Random root(5);
  EXPECT_LT(std::abs(correlation(root.split(0), root.split(1))), allowed);
  EXPECT_LT(std::abs(correlation(root.split("plan"), root.split("hand"))), allowed);
  EXPECT_LT(std::abs(correlation(root, root.split("plan"))), allowed);
  EXPECT_LT(std::abs(correlation(Random(5), Random(6))), allowed);
  Random later(5);
  later.bits();
  EXPECT_LT(std::abs(correlation(Random(5), later)), allowed);
  // One number drawn from each of many streams is a random sequence too.
  double sum = 0.0;
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    sum += (root.split(i).uniform() - 0.5) * (root.split(i + 1).uniform() - 0.5) * 12.0;
  }
  EXPECT_LT(std::abs(sum / kPairs), allowed);
}

double chi_squared_p(const std::vector<int>& counts) {
  const double expected =
      std::accumulate(counts.begin(), counts.end(), 0.0) / static_cast<double>(counts.size());
  double chi2 = 0.0;
  for (const int count : counts) {
    chi2 += (count - expected) * (count - expected) / expected;
  }
  const boost::math::chi_squared distribution(static_cast<double>(counts.size()) - 1.0);
  return boost::math::cdf(boost::math::complement(distribution, chi2));
}

// Neither too uneven nor too even.
void expect_plausible(double p) {
  EXPECT_GT(p, 1e-4);
  EXPECT_LT(p, 1.0 - 1e-4);
}

TEST(Random, IsUniformInEveryByteAndInUniform) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Random random(seed);
    std::vector<std::vector<int>> bytes(8, std::vector<int>(256));
    std::vector<int> cells(1000);
    for (int i = 0; i < 200000; ++i) {
      const std::uint64_t drawn = random.bits();
      for (std::size_t byte = 0; byte < 8; ++byte) {
        ++bytes[byte][(drawn >> (8 * byte)) & 0xff];
      }
      const double uniform = random.uniform();
      ASSERT_GE(uniform, 0.0);
      ASSERT_LT(uniform, 1.0);
      ++cells[static_cast<std::size_t>(uniform * 1000.0)];
    }
    for (const auto& counts : bytes) {
      expect_plausible(chi_squared_p(counts));
    }
    expect_plausible(chi_squared_p(cells));
  }
}

TEST(Random, DrawsBelowNWithoutBias) {
  for (const std::uint64_t n : {2U, 3U, 7U, 24U}) {
    Random random = Random(11).split(n);
    std::vector<int> counts(n);
    for (int i = 0; i < 100000; ++i) {
      const std::uint64_t drawn = random.below(n);
      ASSERT_LT(drawn, n);
      ++counts[drawn];
    }
    expect_plausible(chi_squared_p(counts));
  }
  EXPECT_EQ(Random(1).below(1), 0U);
}

// n = 3·2⁶²: multiply-and-shift without rejection would draw every third number twice as often, so
// that numbers with remainder 0 modulo 3 make up half of all.
TEST(Random, RejectsWhatWouldBeUnfairForAHugeN) {
  constexpr std::uint64_t kN = std::uint64_t{3} << 62;
  Random random(12);
  std::vector<int> counts(3);
  for (int i = 0; i < 30000; ++i) {
    ++counts[random.below(kN) % 3];
  }
  expect_plausible(chi_squared_p(counts));
}

TEST(Random, ShufflesIntoEveryOrderEquallyOften) {
  Random random(13);
  std::vector<int> counts(24);
  for (int i = 0; i < 48000; ++i) {
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    random.shuffle(std::span<std::size_t>(order));
    std::size_t rank = 0;
    for (std::size_t a = 0; a < 4; ++a) {
      std::size_t smaller_later = 0;
      for (std::size_t b = a + 1; b < 4; ++b) {
        smaller_later += order[b] < order[a] ? 1U : 0U;
      }
      rank = rank * (4 - a) + smaller_later;
    }
    ++counts[rank];
  }
  expect_plausible(chi_squared_p(counts));
}

// Standard errors of the moments of n standard normal numbers: 1/√n, √(2/n), √(15/n), √(96/n).
TEST(Random, HasTheMomentsOfTheNormalDistribution) {
  constexpr int kDraws = 1000000;
  Random random(17);
  double m1 = 0.0;
  double m2 = 0.0;
  double m3 = 0.0;
  double m4 = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double z = random.normal();
    m1 += z;
    m2 += z * z;
    m3 += z * z * z;
    m4 += z * z * z * z;
  }
  const double unit = 1.0 / std::sqrt(kDraws);
  EXPECT_NEAR(m1 / kDraws, 0.0, 4.0 * unit);
  EXPECT_NEAR(m2 / kDraws, 1.0, 4.0 * std::sqrt(2.0) * unit);
  EXPECT_NEAR(m3 / kDraws, 0.0, 4.0 * std::sqrt(15.0) * unit);
  EXPECT_NEAR(m4 / kDraws, 3.0, 4.0 * std::sqrt(96.0) * unit);
}

// Kolmogorov–Smirnov: the greatest distance times √n exceeds 1.95 in one of a thousand samples.
TEST(Random, FollowsTheNormalDistributionFunction) {
  for (const std::uint64_t seed : {19U, 23U, 29U}) {
    constexpr std::size_t kDraws = 100000;
    Random random(seed);
    std::vector<double> z(kDraws);
    std::generate(z.begin(), z.end(), [&random] { return random.normal(); });
    std::sort(z.begin(), z.end());
    const boost::math::normal normal;
    double distance = 0.0;
    for (std::size_t i = 0; i < kDraws; ++i) {
      const double p = boost::math::cdf(normal, z[i]);
      distance = std::max(
          {distance, p - static_cast<double>(i) / kDraws, static_cast<double>(i + 1) / kDraws - p});
    }
    EXPECT_LT(distance * std::sqrt(kDraws), 1.95);
  }
}

// All three rational functions, and their borders at 0.425 from the middle and tail = e⁻²⁵.
TEST(Random, InvertsTheNormalDistributionToTheLastDigits) {
  const boost::math::normal normal;
  for (double tail = 0.5; tail >= 0x1p-54; tail *= 0.99) {
    const double expected = boost::math::quantile(boost::math::complement(normal, tail));
    EXPECT_NEAR(upper_normal_quantile(tail), expected, 1e-16 + 1e-15 * expected) << tail;
  }
}

// Each normal number is the quantile of the bits it was made of: 52 for the tail, one for the sign.
TEST(Random, MakesANormalNumberOfOneDraw) {
  Random bits(31);
  Random normals(31);
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t drawn = bits.bits();
    const double size = upper_normal_quantile((static_cast<double>(drawn >> 12) + 0.5) * 0x1p-53);
    EXPECT_EQ(normals.normal(), (drawn & 1U) != 0 ? -size : size);
  }
}

}  // namespace
}  // namespace asperity
