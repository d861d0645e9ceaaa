// Holds the measures of roughness to records and heights whose values follow from their formulas.

#include "analysis/signals/roughness.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

constexpr double kStrokeRate_Hz = 2000.0;
// (2π·250)²·0.1 µm, worked out in the header.
constexpr double kThreshold_m_per_s2 = 0.24674011;

std::vector<double> tone(double frequency_Hz, double amplitude) {
  std::vector<double> signal(4000);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    signal[i] = 5.0 + amplitude * std::sin(2.0 * std::numbers::pi * frequency_Hz *
                                           static_cast<double>(i) / kStrokeRate_Hz);
  }
  return signal;
}

TEST(RecordRoughness, PutsASinusoidInItsChannel) {
  const RecordRoughness slow = record_roughness(tone(20.0, 2.0), kStrokeRate_Hz);
  EXPECT_NEAR(slow.fa1_power, 2.0, 1e-9);
  EXPECT_NEAR(slow.fa2_power, 0.0, 1e-9);
  EXPECT_NEAR(slow.rms, std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(slow.maximum, 2.0, 1e-9);
  const RecordRoughness quick = record_roughness(tone(300.0, 2.0), kStrokeRate_Hz);
  EXPECT_NEAR(quick.fa1_power, 0.0, 1e-9);
  EXPECT_NEAR(quick.fa2_power, 2.0, 1e-9);
}

TEST(RecordRoughness, GivesItsBordersToOneBandEach) {
  EXPECT_NEAR(record_roughness(tone(5.0, 2.0), kStrokeRate_Hz).fa1_power, 2.0, 1e-9);
  EXPECT_NEAR(record_roughness(tone(50.0, 2.0), kStrokeRate_Hz).fa1_power, 0.0, 1e-9);
  EXPECT_NEAR(record_roughness(tone(50.0, 2.0), kStrokeRate_Hz).fa2_power, 2.0, 1e-9);
  EXPECT_NEAR(record_roughness(tone(500.0, 2.0), kStrokeRate_Hz).fa2_power, 2.0, 1e-9);
  EXPECT_NEAR(record_roughness(tone(501.0, 2.0), kStrokeRate_Hz).fa2_power, 0.0, 1e-9);
}

// 20·log₁₀(√½·amplitude/threshold) far below 300 Hz, 3.01 dB less at 300 Hz.
TEST(AccelerationRoughness, IsInDecibelsOverThreshold) {
  const double amplitude = kThreshold_m_per_s2 * std::numbers::sqrt2 * 10.0;
  EXPECT_NEAR(acceleration_roughness_dB(tone(50.0, amplitude), kStrokeRate_Hz).value(), 20.0, 0.1);
  EXPECT_NEAR(acceleration_roughness_dB(tone(300.0, amplitude), kStrokeRate_Hz).value(), 17.0, 0.1);
}

TEST(AccelerationRoughness, IsAbsentWithoutVibration) {
  EXPECT_FALSE(acceleration_roughness_dB(std::vector<double>(1000, 0.0), kStrokeRate_Hz));
}

TEST(PacinianPower, IsOneForASinusoidAtThreshold) {
  EXPECT_NEAR(pacinian_power(tone(100.0, kThreshold_m_per_s2), kStrokeRate_Hz), 1.0, 1e-6);
  EXPECT_NEAR(pacinian_power(tone(250.0, kThreshold_m_per_s2), kStrokeRate_Hz), 1.0, 1e-6);
  // An octave above, the threshold of acceleration is 2⁴ times as high, and power goes squared.
  EXPECT_NEAR(pacinian_power(tone(500.0, kThreshold_m_per_s2), kStrokeRate_Hz), 1.0 / 256.0, 1e-8);
  EXPECT_NEAR(pacinian_power(tone(20.0, kThreshold_m_per_s2), kStrokeRate_Hz), 0.0, 1e-9);
}

TEST(RecordRoughness, RefusesNothingToMeasure) {
  EXPECT_THROW(record_roughness({}, kStrokeRate_Hz), std::invalid_argument);
  EXPECT_THROW(record_roughness(std::vector<double>(10), 0.0), std::invalid_argument);
  EXPECT_THROW(pacinian_power({}, kStrokeRate_Hz), std::invalid_argument);
  EXPECT_THROW(acceleration_roughness_dB(std::vector<double>(5), kStrokeRate_Hz),
               std::invalid_argument);
  EXPECT_THROW(acceleration_roughness_dB(std::vector<double>(500), 500.0), std::invalid_argument);
}

// A sinusoid of amplitude A: Sa = 2A/π, Sq = A/√2, Ssk = 0, Sku = 3/2.
TEST(HeightRoughness, OfASinusoidFollowsFromItsAmplitude) {
  std::vector<float> heights_m;
  for (int i = 0; i < 10000; ++i) {
    heights_m.push_back(
        static_cast<float>(1e-3 + 2e-5 * std::sin(2.0 * std::numbers::pi * i / 1000.0)));
  }
  const auto roughness = height_roughness(heights_m).value();
  EXPECT_NEAR(roughness.Sa_m, 4e-5 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(roughness.Sq_m, 2e-5 / std::numbers::sqrt2, 1e-9);
  EXPECT_NEAR(roughness.Ssk, 0.0, 1e-4);
  EXPECT_NEAR(roughness.Sku, 1.5, 1e-3);
}

// A tone at the held tool's own threshold, a₀ = (2π·175)²·0.03 µm, is 0 dB; twice as strong 6.02 dB.
// Along and across it counts as √2 of either.
TEST(HeldToolRecord, AddsThePowersOfBothDirections) {
  const double threshold_m_per_s2 = std::pow(2.0 * std::numbers::pi * 175.0, 2) * 0.03e-6;
  EXPECT_NEAR(threshold_m_per_s2, 0.0363, 1e-4);
  HeldToolRecord along(kStrokeRate_Hz);
  HeldToolRecord both(kStrokeRate_Hz);
  for (const double one : tone(100.0, 2.0 * threshold_m_per_s2)) {
    along.add(one, 7.0);
    both.add(one, -one);
  }
  const HeldToolRoughness one = along.roughness();
  EXPECT_NEAR(one.pacinian_dB.value(), 20.0 * std::log10(2.0), 1e-6);
  EXPECT_NEAR(one.max_accel_m_per_s2, 2.0 * threshold_m_per_s2, 1e-6);
  EXPECT_NEAR(one.fa2_m2_per_s4, 2.0 * threshold_m_per_s2 * threshold_m_per_s2, 1e-9);
  EXPECT_NEAR(one.fa1_m2_per_s4, 0.0, 1e-12);
  const HeldToolRoughness two = both.roughness();
  EXPECT_NEAR(two.max_accel_m_per_s2, std::sqrt(2.0) * one.max_accel_m_per_s2, 1e-9);
  EXPECT_NEAR(two.rms_accel_m_per_s2, std::sqrt(2.0) * one.rms_accel_m_per_s2, 1e-9);
  EXPECT_NEAR(two.fa2_m2_per_s4, 2.0 * one.fa2_m2_per_s4, 1e-9);
  EXPECT_NEAR(two.pacinian_dB.value(), one.pacinian_dB.value() + 10.0 * std::log10(2.0), 1e-9);
}

TEST(HeldToolRecord, HasTheSameRmsWithoutSpectra) {
  HeldToolRecord record(kStrokeRate_Hz);
  Random random(7);
  for (int i = 0; i < 1009; ++i) record.add(random.normal(), 0.1, 2.0 * random.normal());
  EXPECT_EQ(record.rms_accel_m_per_s2(), record.roughness().rms_accel_m_per_s2);
  record.clear();
  EXPECT_THROW(record.rms_accel_m_per_s2(), std::invalid_argument);
}

TEST(HeldToolRecord, BeginsAnewWhenItIsCleared) {
  HeldToolRecord record(kStrokeRate_Hz);
  EXPECT_THROW(record.roughness(), std::invalid_argument);
  record.add(100.0, 0.0);
  record.clear();
  for (int i = 0; i < 100; ++i) record.add(3.0, -2.0);
  EXPECT_EQ(record.roughness().max_accel_m_per_s2, 0.0);
  EXPECT_FALSE(record.roughness().pacinian_dB);
  EXPECT_THROW(HeldToolRecord(0.0), std::invalid_argument);
}

// One pit of depth 1 in n = 10: mean −0.1; Sa 0.18, Sq 0.3, Ssk −(0.729 − 9·0.001)/10/0.027 = −8/3,
// Sku (0.6561 + 9·0.0001)/10/0.0081 = 73/9.
TEST(HeightRoughness, SkewsDownwardsForAPit) {
  std::vector<float> heights_m(10, 0.0F);
  heights_m[3] = -1.0F;
  const auto roughness = height_roughness(heights_m).value();
  EXPECT_NEAR(roughness.Sa_m, 0.18, 1e-12);
  EXPECT_NEAR(roughness.Sq_m, 0.3, 1e-12);
  EXPECT_NEAR(roughness.Ssk, -8.0 / 3.0, 1e-12);
  EXPECT_NEAR(roughness.Sku, 73.0 / 9.0, 1e-12);
}

TEST(HeightRoughness, OfNormalHeightsHasAKurtosisOfThree) {
  Random random(1);
  std::vector<float> heights_m(200000);
  for (float& height_m : heights_m) {
    height_m = static_cast<float>(1e-4 * random.normal());
  }
  const auto roughness = height_roughness(heights_m).value();
  EXPECT_NEAR(roughness.Sq_m, 1e-4, 1e-6);
  EXPECT_NEAR(roughness.Ssk, 0.0, 0.03);
  EXPECT_NEAR(roughness.Sku, 3.0, 0.05);
}

TEST(HeightRoughness, IsAbsentOnAPlane) {
  EXPECT_FALSE(height_roughness(std::vector<float>(1000, 0.1F)));
  EXPECT_THROW(height_roughness({}), std::invalid_argument);
}

}  // namespace
}  // namespace asperity
