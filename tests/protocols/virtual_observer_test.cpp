// A virtual participant judges by what it feels, and by nothing else.

#include "protocols/observer/virtual_observer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include <boost/math/distributions/binomial.hpp>

namespace asperity {
namespace {

ForceFeatures features(double level) {
  ForceFeatures result{};
  result.spectrum.fill(level);
  result.size = level;
  result.roughness = level;
  return result;
}

ObserverDeclaration ideal() {
  ObserverDeclaration declaration{};
  declaration.expectation = ObserverDeclaration::Expectation::true_surface;
  declaration.feature_noise = 0.0;
  declaration.position_bias = 0.0;
  declaration.lapse = 0.0;
  return declaration;
}

/// Bounds that a binomial count leaves once in a million at either side.
std::pair<double, double> bounds(int trials, double probability) {
  const boost::math::binomial_distribution<double> law(trials, probability);
  return {boost::math::quantile(law, 1e-6),
          boost::math::quantile(boost::math::complement(law, 1e-6))};
}

const std::vector<ForceFeatures> kFour{features(-4.0), features(-3.0), features(-2.0),
                                       features(-1.0)};

ForceFeatures felt_with(double roughness) {
  ForceFeatures features{};
  features.roughness = roughness;
  features.size = -1.0;
  return features;
}

TEST(VirtualObserver, ComparesMagnitudesAndTiesWhereTheyAreClose) {
  ObserverDeclaration exact{.feature_noise = 0.0, .lapse = 0.0};
  VirtualObserver observer(exact, Random(1));
  EXPECT_EQ(observer.compare(felt_with(-1.0), felt_with(-0.8), 0.1), std::size_t{1});
  EXPECT_EQ(observer.compare(felt_with(-0.8), felt_with(-1.0), 0.1), std::size_t{0});
  EXPECT_EQ(observer.compare(felt_with(-1.0), felt_with(-0.95), 0.1), std::nullopt);
  EXPECT_EQ(observer.compare(felt_with(-1.0), felt_with(-0.95), 0.0), std::size_t{1});
  exact.position_bias = 0.5;
  EXPECT_EQ(VirtualObserver(exact, Random(1)).compare(felt_with(-1.0), felt_with(-0.8), 0.1),
            std::size_t{0});
  const ObserverDeclaration deaf{.deaf = true};
  VirtualObserver guessing(deaf, Random(1));
  int first = 0;
  for (int i = 0; i < 1000; ++i) {
    first += guessing.compare(felt_with(-4.0), felt_with(-0.1), 0.1) == std::size_t{0} ? 1 : 0;
  }
  const auto [low, high] = bounds(1000, 0.5);
  EXPECT_GE(first, low);
  EXPECT_LE(first, high);
}

// Φ(0.2/(√2·0.2)) = Φ(0.7071) = 0.7602; 0.1/2 + 0.9·0.7602 = 0.7342
TEST(VirtualObserver, DistinguishesAsOftenAsItsNoiseAndLapsesImply) {
  const ObserverDeclaration noisy{.feature_noise = 0.2, .lapse = 0.1};
  EXPECT_NEAR(distinguished_proportion(noisy, 0.2), 0.7342, 5e-5);
  constexpr int kTrials = 4000;
  VirtualObserver observer(noisy, Random(3));
  int second = 0;
  for (int i = 0; i < kTrials; ++i) {
    second += observer.compare(felt_with(-1.0), felt_with(-0.8), 0.0) == std::size_t{1} ? 1 : 0;
  }
  const auto [low, high] = bounds(kTrials, distinguished_proportion(noisy, 0.2));
  EXPECT_GE(second, low);
  EXPECT_LE(second, high);
  EXPECT_EQ(distinguished_proportion(noisy, 0.0), 0.5);
  EXPECT_EQ(distinguished_proportion({.deaf = true}, 1.0), 0.5);
  EXPECT_EQ(distinguished_proportion({.feature_noise = 0.0, .lapse = 0.0}, 1e-9), 1.0);
}

// |x|/√2σ of a normal x with mean 0 is below its median 0.6745 as often as above it.
TEST(VirtualObserver, IsAsOftenCertainAsUncertainWithoutADifference) {
  const ObserverDeclaration noisy{.feature_noise = 0.2, .lapse = 0.0};
  constexpr int kTrials = 4000;
  const auto [low, high] = bounds(kTrials, 0.25);
  const auto expect_quarters = [&](const std::function<void(VirtualObserver&)>& decide) {
    VirtualObserver observer(noisy, Random(3));
    std::array<int, 4> quarters{};
    for (int i = 0; i < kTrials; ++i) {
      decide(observer);
      ASSERT_TRUE(observer.certainty());
      ++quarters.at(static_cast<std::size_t>(4.0 * *observer.certainty()));
    }
    for (const int count : quarters) {
      EXPECT_GE(count, low);
      EXPECT_LE(count, high);
    }
  };
  expect_quarters([](VirtualObserver& observer) {
    (void)observer.compare(felt_with(-1.0), felt_with(-1.0), 0.0);
  });
  expect_quarters([](VirtualObserver& observer) { (void)observer.exceeds(felt_with(-1.0), -1.0); });
}

// 2·Φ(0.2/(√2·0.2)) − 1 = 0.5205 where the noise happens to be 0; on average the certainty grows with the difference.
TEST(VirtualObserver, IsMoreCertainFartherFromItsCriterion) {
  const ObserverDeclaration noisy{.feature_noise = 0.2, .lapse = 0.0};
  const auto mean_certainty = [&](const std::function<void(VirtualObserver&)>& decide) {
    VirtualObserver observer(noisy, Random(5));
    double sum = 0.0;
    for (int i = 0; i < 500; ++i) {
      decide(observer);
      sum += observer.certainty().value();
    }
    return sum / 500.0;
  };
  const auto comparing = [&](double difference) {
    return mean_certainty([difference](VirtualObserver& observer) {
      (void)observer.compare(felt_with(-1.0), felt_with(-1.0 + difference), 0.0);
    });
  };
  EXPECT_LT(comparing(0.0), comparing(0.3));
  EXPECT_LT(comparing(0.3), comparing(1.0));
  const auto exceeding = [&](double magnitude) {
    return mean_certainty([magnitude](VirtualObserver& observer) {
      (void)observer.exceeds(felt_with(magnitude), -1.0);
    });
  };
  EXPECT_LT(exceeding(-1.0), exceeding(-0.7));
  EXPECT_LT(exceeding(-1.0), exceeding(-1.3)) << "on both sides";
  const auto differing = [&](double difference) {
    return mean_certainty([difference](VirtualObserver& observer) {
      (void)observer.differ(felt_with(-1.0), felt_with(-1.0 + difference), 0.5);
    });
  };
  EXPECT_LT(differing(0.5), differing(0.0)) << "of \"same\"";
  EXPECT_LT(differing(0.5), differing(1.2)) << "of \"different\"";
}

TEST(VirtualObserver, HasNoCertaintyInALapseAndFullCertaintyWithoutNoise) {
  VirtualObserver exact({.feature_noise = 0.0, .lapse = 0.0}, Random(1));
  EXPECT_FALSE(exact.certainty()) << "before a decision";
  (void)exact.compare(felt_with(-1.0), felt_with(-0.9), 0.0);
  EXPECT_EQ(exact.certainty(), 1.0);
  (void)exact.compare(felt_with(-1.0), felt_with(-1.0), 0.0);
  EXPECT_EQ(exact.certainty(), 0.0);
  VirtualObserver lapsing({.feature_noise = 0.1, .lapse = 0.5}, Random(1));
  int without = 0;
  for (int i = 0; i < 100; ++i) {
    (void)lapsing.differ(felt_with(-1.0), felt_with(-0.9), 0.05);
    without += lapsing.certainty() ? 0 : 1;
  }
  EXPECT_GT(without, 30) << "a lapse has no certainty, nor that of the decision before it";
  EXPECT_LT(without, 70);
}

TEST(VirtualObserver, SaysNumbersThatGrowWithThePowerOfTheFeltForce) {
  ObserverDeclaration exact{.feature_noise = 0.0, .lapse = 0.0};
  exact.magnitude.exponent = 2.0;
  const NumberHabit habit{.modulus = 100.0, .digits = 2};
  VirtualObserver observer(exact, Random(1));
  EXPECT_EQ(observer.estimate(felt_with(0.0), habit), 100.0);
  EXPECT_EQ(observer.estimate(felt_with(std::log(0.5)), habit), 25.0);
  EXPECT_EQ(observer.estimate(felt_with(std::log(0.0123)), habit), 0.015);  // 0.015129
  exact.magnitude_of = ObserverDeclaration::MagnitudeOf::normal_force;
  EXPECT_EQ(VirtualObserver(exact, Random(1)).estimate(felt_with(0.0), habit), 14.0);  // 100/e²
}

// 100·a² for accelerations that are far above the threshold; below it, less roughness is not felt.
TEST(VirtualObserver, SaysNumbersThatGrowWithHowAHeldToolIsShaken) {
  ObserverDeclaration exact{.feature_noise = 0.0, .lapse = 0.0};
  exact.magnitude_of = ObserverDeclaration::MagnitudeOf::held_tool;
  exact.magnitude.exponent = 2.0;
  const NumberHabit habit{.modulus = 100.0, .digits = 2};
  const auto number_of = [&](double shaking_m_per_s2) {
    ForceFeatures felt = felt_with(-3.0);  // shares of the normal force are nothing to it
    felt.shaking_m_per_s2 = shaking_m_per_s2;
    return VirtualObserver(exact, Random(1)).estimate(felt, habit);
  };
  EXPECT_EQ(number_of(1.0), 100.0);
  EXPECT_EQ(number_of(3.0), 900.0);
  EXPECT_EQ(number_of(0.5), 25.0);
  EXPECT_EQ(number_of(0.0), 0.066);  // 100·½·((2π·175 Hz)²·0.03 µm)²
  EXPECT_EQ(number_of(0.001), 0.066);
}

// 100·c² for a compliance of c mm/N; a surface that was not felt is as hard as 100 N/mm.
TEST(VirtualObserver, SaysNumbersThatGrowWithTheComplianceOfASurface) {
  ObserverDeclaration exact{.feature_noise = 0.0, .lapse = 0.0};
  exact.magnitude_of = ObserverDeclaration::MagnitudeOf::compliance;
  exact.magnitude.exponent = 2.0;
  const auto number_of = [&](double compliance_m_per_N) {
    ForceFeatures felt = felt_with(-3.0);
    felt.compliance_m_per_N = compliance_m_per_N;
    return VirtualObserver(exact, Random(1)).estimate(felt, {.modulus = 100.0, .digits = 2});
  };
  EXPECT_EQ(number_of(1e-3), 100.0);
  EXPECT_EQ(number_of(3e-3), 900.0);
  EXPECT_EQ(number_of(0.0), 0.01);
}

// With "effect": "decreases" the harder of two bodies is chosen, with the noise of any other magnitude.
TEST(VirtualObserver, ChoosesTheHarderOfTwoBodies) {
  ObserverDeclaration noisy{.feature_noise = 0.1, .lapse = 0.0};
  noisy.magnitude_of = ObserverDeclaration::MagnitudeOf::compliance;
  noisy.discrimination.magnitude_decreases = true;
  VirtualObserver observer(noisy, Random(4));
  ForceFeatures soft{};
  soft.compliance_m_per_N = 1.2e-3;
  ForceFeatures hard{};
  hard.compliance_m_per_N = 1.0e-3;
  constexpr int kTrials = 4000;
  int correct = 0;
  for (int i = 0; i < kTrials; ++i) {
    correct += observer.compare(soft, hard, 0.0) == std::size_t{1} ? 1 : 0;
  }
  const auto [low, high] = bounds(kTrials, distinguished_proportion(noisy, std::log(1.2)));
  EXPECT_GE(correct, low);
  EXPECT_LE(correct, high);
}

TEST(VirtualObserver, HasNumberHabitsOfThePerson) {
  std::set<double> moduli{};
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const NumberHabit habit = number_habit_of(Random(seed));
    EXPECT_GE(habit.modulus, 10.0);
    EXPECT_LT(habit.modulus, 1000.0);
    moduli.insert(habit.modulus);
  }
  EXPECT_EQ(moduli.size(), 20U);
}

TEST(VirtualObserver, WithoutNoiseSelectsTheNearestWhereverItIs) {
  VirtualObserver observer(ideal(), Random(1));
  for (std::size_t nearest = 0; nearest < 4; ++nearest) {
    for (int i = 0; i < 50; ++i) {
      EXPECT_EQ(observer.select(kFour, features(-4.0 + 0.3 + static_cast<double>(nearest))),
                nearest);
    }
  }
}

TEST(VirtualObserver, WithoutNoiseRecognisesTheNearest) {
  VirtualObserver observer(ideal(), Random(1));
  for (std::size_t nearest = 0; nearest < 4; ++nearest) {
    EXPECT_EQ(observer.recognise(features(-4.2 + static_cast<double>(nearest)), kFour), nearest);
  }
}

TEST(VirtualObserver, MatchesAsAWholeAndNotOneByOne) {
  // Felt 0 and 1 are both nearest to expectation 0, but only one of them can have it. As a whole
  // (0→1, 1→0) costs 0.6² + 0.1² and (0→0, 1→1) costs 0.4² + 1.1²: the greedy choice for felt 0
  // is the worse one. Features here differ in size alone.
  const auto of_size = [](double size) {
    ForceFeatures result{};
    result.size = size;
    return result;
  };
  VirtualObserver observer(ideal(), Random(1));
  const std::vector<ForceFeatures> felt{of_size(0.4), of_size(-0.1)};
  const std::vector<ForceFeatures> expected{of_size(0.0), of_size(1.0)};
  EXPECT_EQ(observer.match(felt, expected), (std::vector<std::size_t>{1, 0}));
  const std::vector<ForceFeatures> shuffled{kFour[2], kFour[0], kFour[3], kFour[1]};
  EXPECT_EQ(observer.match(shuffled, kFour), (std::vector<std::size_t>{2, 0, 3, 1}));
}

TEST(VirtualObserver, DeafAnswersUniformly) {
  ObserverDeclaration declaration = ideal();
  declaration.deaf = true;
  VirtualObserver observer(declaration, Random(20260101));
  constexpr int kTrials = 6000;
  std::map<std::size_t, int> selected{};
  std::map<std::size_t, int> recognised{};
  std::map<std::vector<std::size_t>, int> matched{};
  for (int i = 0; i < kTrials; ++i) {
    ++selected[observer.select(kFour, features(-4.0))];
    ++recognised[observer.recognise(features(-4.0), kFour)];
    ++matched[observer.match(kFour, kFour)];
  }
  const auto [low, high] = bounds(kTrials, 0.25);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GE(selected[i], low);
    EXPECT_LE(selected[i], high);
    EXPECT_GE(recognised[i], low);
    EXPECT_LE(recognised[i], high);
  }
  EXPECT_EQ(matched.size(), 24U);
  const auto [low_match, high_match] = bounds(kTrials, 1.0 / 24.0);
  for (const auto& [order, count] : matched) {
    EXPECT_GE(count, low_match);
    EXPECT_LE(count, high_match);
  }
}

TEST(VirtualObserver, EqualEvidenceIsDecidedByChance) {
  VirtualObserver observer(ideal(), Random(5));
  const std::vector<ForceFeatures> same(3, features(-2.0));
  constexpr int kTrials = 3000;
  std::map<std::size_t, int> counts{};
  std::map<std::vector<std::size_t>, int> orders{};
  for (int i = 0; i < kTrials; ++i) {
    ++counts[observer.select(same, features(-1.0))];
    ++orders[observer.match(same, same)];
  }
  const auto [low, high] = bounds(kTrials, 1.0 / 3.0);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GE(counts[i], low);
    EXPECT_LE(counts[i], high);
  }
  EXPECT_EQ(orders.size(), 6U);
}

TEST(VirtualObserver, LapsesAsOftenAsDeclared) {
  ObserverDeclaration declaration = ideal();
  declaration.lapse = 0.2;
  VirtualObserver observer(declaration, Random(7));
  constexpr int kTrials = 10000;
  int wrong = 0;
  for (int i = 0; i < kTrials; ++i) wrong += observer.recognise(kFour[1], kFour) != 1 ? 1 : 0;
  // A guess among four is wrong three times in four: 0.2 · 3/4 = 0.15.
  const auto [low, high] = bounds(kTrials, 0.15);
  EXPECT_GE(wrong, low);
  EXPECT_LE(wrong, high);
}

TEST(VirtualObserver, NoiseErrsAsOftenAsTheNormalLawSays) {
  // Two expectations that differ by 1 in size alone, noise 0.5: the judgement is wrong when the
  // noise passes the middle, 0.5, which a normal number with deviation 0.5 does with probability
  // Φ(−1) = 0.158655.
  ForceFeatures near{};
  ForceFeatures far{};
  far.size = 1.0;
  ObserverDeclaration declaration = ideal();
  declaration.feature_noise = 0.5;
  VirtualObserver observer(declaration, Random(11));
  const std::vector<ForceFeatures> expected{near, far};
  constexpr int kTrials = 10000;
  int wrong = 0;
  for (int i = 0; i < kTrials; ++i) wrong += observer.recognise(near, expected) != 0 ? 1 : 0;
  const auto [low, high] = bounds(kTrials, 0.158655);
  EXPECT_GE(wrong, low);
  EXPECT_LE(wrong, high);
  // The same along the spectrum, where a difference of √10 · 1/√10 in every band is 1 as well.
  ForceFeatures other{};
  other.spectrum.fill(1.0);
  const std::vector<ForceFeatures> spectra{near, other};
  wrong = 0;
  for (int i = 0; i < kTrials; ++i) wrong += observer.recognise(near, spectra) != 0 ? 1 : 0;
  EXPECT_GE(wrong, low);
  EXPECT_LE(wrong, high);
}

TEST(VirtualObserver, BiasFavoursTheFirst) {
  ObserverDeclaration declaration = ideal();
  declaration.position_bias = 10.0;
  VirtualObserver observer(declaration, Random(3));
  EXPECT_EQ(observer.select(kFour, features(-2.0)), 0U);
  EXPECT_EQ(observer.recognise(features(-2.0), kFour), 0U);
}

TEST(VirtualObserver, IsTheSameForTheSameSeed) {
  ObserverDeclaration declaration = ideal();
  declaration.feature_noise = 1.0;
  declaration.lapse = 0.3;
  VirtualObserver a(declaration, Random(9));
  VirtualObserver b(declaration, Random(9));
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(a.match(kFour, kFour), b.match(kFour, kFour));
    EXPECT_EQ(a.response_time_s(), b.response_time_s());
  }
}

TEST(VirtualObserver, TakesAPlausibleTimeToAnswer) {
  VirtualObserver observer(ideal(), Random(13));
  double sum_s = 0.0;
  constexpr int kTrials = 10000;
  for (int i = 0; i < kTrials; ++i) {
    const double time_s = observer.response_time_s();
    ASSERT_GE(time_s, 0.6);
    ASSERT_LT(time_s, 60.0);
    sum_s += time_s;
  }
  // 0.6 s plus an exponential time of mean 1.2 s, whose mean of 10 000 deviates by 0.012 s.
  EXPECT_NEAR(sum_s / kTrials, 1.8, 0.06);
}

TEST(VirtualObserver, RefusesQuestionsThatAreNone) {
  VirtualObserver observer(ideal(), Random(1));
  const std::vector<ForceFeatures> nothing{};
  const std::vector<ForceFeatures> nine(9, features(0.0));
  EXPECT_THROW((void)observer.select(nothing, features(0.0)), std::invalid_argument);
  EXPECT_THROW((void)observer.recognise(features(0.0), nothing), std::invalid_argument);
  EXPECT_THROW((void)observer.match(nine, nine), std::invalid_argument);
  EXPECT_THROW((void)observer.match(kFour, nine), std::invalid_argument);
  EXPECT_THROW((void)observer.guess(0), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
