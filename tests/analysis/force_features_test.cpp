// Holds the features of a force record to surfaces whose spectrum is known.

#include "analysis/signals/force_features.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/numbers/random.h"

namespace asperity {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
const double kFloor = std::log(kFeltRatio);

struct Record {
  std::vector<double> time_s{};
  std::vector<double> travel_m{};
  std::vector<double> normal_N{};
  std::vector<double> lateral_N{};

  FeltForce felt() const { return {time_s, travel_m, normal_N, lateral_N}; }
};

using Surface = std::function<double(double x_m)>;  // texture force at a place, in newtons

// To-and-fro strokes over 60 mm with 1 N and friction 0.2, sampled at 1 kHz. The force is the
// surface's at the place, so the travel axis sees it mirrored after each reversal.
struct Stroke {
  double speed_m_per_s = 0.06;
  double duration_s = 5.0;
  double start_m = 0.0;
  double drift_N = 0.0;    // slow swell of the normal force
  double landing_s = 0.0;  // the force rises from 0 in this time
};

Record felt_on(const Surface& surface, const Stroke& stroke) {
  Record record;
  constexpr double kLength_m = 0.06;
  const auto count = static_cast<int>(std::lround(stroke.duration_s * 1000.0));
  for (int i = 0; i < count; ++i) {
    const double time_s = i * 1e-3;
    // The speed swells by a third within a second, as people's does.
    const double travel_m =
        stroke.speed_m_per_s * (time_s + 0.33 / kTwoPi * (1.0 - std::cos(kTwoPi * time_s)));
    const double phase = std::fmod(travel_m + stroke.start_m, 2.0 * kLength_m);
    const double x_m = phase < kLength_m ? phase : 2.0 * kLength_m - phase;
    const double landed = stroke.landing_s > 0.0 ? std::min(1.0, time_s / stroke.landing_s) : 1.0;
    const double normal_N =
        landed * (1.0 + surface(x_m) + stroke.drift_N * std::sin(kTwoPi * 0.4 * time_s));
    record.time_s.push_back(time_s);
    record.travel_m.push_back(travel_m);
    record.normal_N.push_back(normal_N);
    record.lateral_N.push_back(0.2 * normal_N);
  }
  return record;
}

Surface sinusoid(double wavelength_m, double amplitude_N) {
  return [=](double x_m) { return amplitude_N * std::sin(kTwoPi * x_m / wavelength_m); };
}

// A surface of a hundred waves with random phases, equal power per octave times a tilt.
Surface rough(std::uint64_t seed, double tilt) {
  Random random(seed);
  std::vector<double> wave_per_m;
  std::vector<double> phase;
  std::vector<double> amplitude_N;
  for (int i = 0; i < 100; ++i) {
    const double wavelength_m = 12e-3 * std::pow(0.02, random.uniform());
    wave_per_m.push_back(1.0 / wavelength_m);
    phase.push_back(kTwoPi * random.uniform());
    amplitude_N.push_back(0.02 * std::pow(wavelength_m / 1e-3, tilt));
  }
  return [=](double x_m) {
    double sum_N = 0.0;
    for (std::size_t i = 0; i < wave_per_m.size(); ++i) {
      sum_N += amplitude_N[i] * std::sin(kTwoPi * wave_per_m[i] * x_m + phase[i]);
    }
    return sum_N;
  };
}

std::size_t greatest_band(const ForceFeatures& features) {
  const auto& spectrum = features.spectrum;
  return static_cast<std::size_t>(std::max_element(spectrum.begin(), spectrum.end()) -
                                  spectrum.begin());
}

TEST(ForceFeatures, HasHalfOctaveBandsFromTenMillimetres) {
  const auto borders_m = feature_band_borders_m();
  ASSERT_EQ(borders_m.size(), kFeatureBands + 1);
  EXPECT_DOUBLE_EQ(borders_m.front(), 10e-3);
  EXPECT_DOUBLE_EQ(borders_m.back(), 0.3125e-3);
  for (std::size_t i = 1; i < borders_m.size(); ++i) {
    EXPECT_NEAR(borders_m[i - 1] / borders_m[i], std::numbers::sqrt2, 1e-12);
  }
}

// The wave in the middle of each band, at three speeds. The shortest two need samples closer than
// half a wavelength: at 120 mm/s with its swell these are 0.16 mm apart.
TEST(ForceFeatures, PeaksInTheBandOfASinusoidAtAnySpeed) {
  const auto borders_m = feature_band_borders_m();
  for (const double speed_m_per_s : {0.03, 0.06, 0.12}) {
    for (std::size_t band = 0; band < kFeatureBands; ++band) {
      const double wavelength_m = std::sqrt(borders_m[band] * borders_m[band + 1]);
      const Record record = felt_on(sinusoid(wavelength_m, 0.1), {.speed_m_per_s = speed_m_per_s});
      EXPECT_EQ(greatest_band(force_features(record.felt())), band)
          << wavelength_m << " m at " << speed_m_per_s << " m/s";
    }
  }
}

// 0.1 N of amplitude on 1 N is an RMS of 0.0707; its friction at 0.2 has 0.01414.
TEST(ForceFeatures, MeasuresSizeAndRoughnessRelativeToTheMeanForce) {
  const ForceFeatures features =
      force_features(felt_on(sinusoid(2e-3, 0.1), {.duration_s = 10.0}).felt());
  EXPECT_NEAR(features.size, std::log(0.0707), 0.02);
  EXPECT_NEAR(features.roughness, std::log(0.01414), 0.02);
}

// 1.05 mm is the middle of a band. It keeps the power of the wave but for the average over 0.1 mm
// (1.5 %) and the skirts of the window. Each band has what nobody feels on top.
TEST(ForceFeatures, PutsTheWholePowerOfASinusoidInItsBands) {
  const ForceFeatures features =
      force_features(felt_on(sinusoid(1.05e-3, 0.1), {.duration_s = 10.0}).felt());
  EXPECT_NEAR(features.spectrum[6], std::log(0.0707), 0.05);
  double power = 0.0;
  for (const double ln_ratio : features.spectrum) {
    power += std::exp(2.0 * ln_ratio) - kFeltRatio * kFeltRatio;
  }
  EXPECT_NEAR(0.5 * std::log(power), features.size, 0.001);
}

// White noise of 0.1 N from sample to sample, one sample per 0.1 mm: the average over a cell is
// that of the two samples at its ends, with the gain cos(π·f·Δ). So a band from f₁ to f₂ has the
// power ∫ 2·σ²·Δ·cos²(π·f·Δ) df = σ²·Δ·(f₂ − f₁) + σ²/(2π)·(sin 2πf₂Δ − sin 2πf₁Δ).
TEST(ForceFeatures, ShareWhiteNoiseByTheWidthOfTheBands) {
  constexpr double kCell_m = 0.1e-3;
  constexpr double kSigma_N = 0.1;
  Record record;
  Random random(9);
  for (int i = 0; i < 200000; ++i) {
    record.time_s.push_back(i * 1e-3);
    record.travel_m.push_back(i * kCell_m);
    record.normal_N.push_back(1.0 + kSigma_N * random.normal());
    record.lateral_N.push_back(0.0);
  }
  const ForceFeatures features = force_features(record.felt());
  const auto borders_m = feature_band_borders_m();
  for (std::size_t band = 0; band < kFeatureBands; ++band) {
    const double low = kCell_m / borders_m[band];
    const double high = kCell_m / borders_m[band + 1];
    const double share = high - low + (std::sin(kTwoPi * high) - std::sin(kTwoPi * low)) / kTwoPi;
    EXPECT_NEAR(features.spectrum[band], std::log(kSigma_N * std::sqrt(share)), 0.05) << band;
  }
}

// At 10 mm/s ten samples fall into a cell: noise in time of 0.05 N is 0.0158 N in cells, of which
// the bands hold 62 %.
TEST(ForceFeatures, AverageWhatIsQuickerThanACell) {
  Record record;
  Random random(10);
  for (int i = 0; i < 40000; ++i) {
    record.time_s.push_back(i * 1e-3);
    record.travel_m.push_back(i * 1e-5);
    record.normal_N.push_back(1.0 + 0.05 * random.normal());
    record.lateral_N.push_back(0.0);
  }
  EXPECT_NEAR(force_features(record.felt()).size, std::log(0.0158 * std::sqrt(0.62)), 0.1);
}

TEST(ForceFeatures, AreTheSameWhenAllForcesGrow) {
  Record record = felt_on(rough(3, 0.0), {});
  const ForceFeatures once = force_features(record.felt());
  for (double& force_N : record.normal_N) {
    force_N *= 4.0;
  }
  for (double& force_N : record.lateral_N) {
    force_N *= 4.0;
  }
  EXPECT_LT(squared_distance(once, force_features(record.felt())), 1e-20);
}

TEST(ForceFeatures, AreCloseForOneSurfaceAndFarForAnother) {
  const std::vector<double> tilts{-0.5, 0.0, 0.5};
  std::vector<ForceFeatures> slow;
  std::vector<ForceFeatures> quick;
  for (std::size_t i = 0; i < tilts.size(); ++i) {
    const Surface surface = rough(100 + i, tilts[i]);
    slow.push_back(force_features(felt_on(surface, {.speed_m_per_s = 0.05}).felt()));
    quick.push_back(force_features(
        felt_on(surface,
                {.speed_m_per_s = 0.1, .duration_s = 4.0, .start_m = 0.017, .drift_N = 0.1})
            .felt()));
  }
  double farthest_same = 0.0;
  double nearest_other = std::numeric_limits<double>::infinity();
  for (std::size_t a = 0; a < tilts.size(); ++a) {
    for (std::size_t b = 0; b < tilts.size(); ++b) {
      const double apart = squared_distance(slow[a], quick[b]);
      if (a == b) {
        farthest_same = std::max(farthest_same, apart);
      } else {
        nearest_other = std::min(nearest_other, apart);
      }
    }
  }
  EXPECT_LT(5.0 * farthest_same, nearest_other);
}

// Without the texture nothing is left: a slow swell of half a newton and a landing are the hand's.
TEST(ForceFeatures, DoNotTakeTheHandForTheSurface) {
  const Surface flat = [](double) { return 0.0; };
  const ForceFeatures features =
      force_features(felt_on(flat, {.drift_N = 0.5, .landing_s = 0.05}).felt());
  EXPECT_LT(features.size, std::log(1.1 * kFeltRatio));
  EXPECT_LT(features.roughness, std::log(1.1 * kFeltRatio));
}

// √(r² + r²) is 0.35 above either in the logarithm; a tenth of it is 0.005 above.
TEST(ForceFeatures, FadeIntoTheFloorSmoothly) {
  const auto size_of = [](double rms_N) {
    const double amplitude_N = std::numbers::sqrt2 * rms_N;
    return force_features(felt_on(sinusoid(2e-3, amplitude_N), {.duration_s = 10.0}).felt()).size;
  };
  EXPECT_NEAR(size_of(kFeltRatio), kFloor + 0.5 * std::log(2.0), 0.02);
  EXPECT_NEAR(size_of(0.1 * kFeltRatio), kFloor + 0.005, 0.002);
}

TEST(ForceFeatures, BridgeNoLift) {
  // Two contacts, and between them 0.5 s in the air in which the place changed and the force fell
  // to half: the same surface as in one contact at either force.
  Record two = felt_on(sinusoid(2e-3, 0.1), {});
  const Record second = felt_on(sinusoid(2e-3, 0.1), {.start_m = 0.031});
  for (std::size_t i = 0; i < second.time_s.size(); ++i) {
    two.time_s.push_back(second.time_s[i] + 5.5);
    two.travel_m.push_back(second.travel_m[i] + 0.4);
    two.normal_N.push_back(second.normal_N[i] + 1.0);
    two.lateral_N.push_back(second.lateral_N[i]);
  }
  // Mean 1.5 N, texture RMS 0.0707 N.
  EXPECT_NEAR(force_features(two.felt()).size, std::log(0.0707 / 1.5), 0.02);
}

TEST(ForceFeatures, IgnoreAHandThatStandsStill) {
  Record record = felt_on(sinusoid(2e-3, 0.1), {});
  Record paused;
  Random random(7);
  double pause_s = 0.0;
  for (std::size_t i = 0; i < record.time_s.size(); ++i) {
    if (i == 2500) {
      for (int k = 0; k < 1000; ++k) {
        paused.time_s.push_back(record.time_s[i] + k * 1e-3);
        paused.travel_m.push_back(record.travel_m[i]);
        paused.normal_N.push_back(record.normal_N[i] + 0.1 * random.normal());
        paused.lateral_N.push_back(record.lateral_N[i]);
      }
      pause_s = 1.0;
    }
    paused.time_s.push_back(record.time_s[i] + pause_s);
    paused.travel_m.push_back(record.travel_m[i]);
    paused.normal_N.push_back(record.normal_N[i]);
    paused.lateral_N.push_back(record.lateral_N[i]);
  }
  EXPECT_NEAR(force_features(paused.felt()).spectrum[4], force_features(record.felt()).spectrum[4],
              0.02);
}

TEST(ForceFeatures, AreAtTheirFloorWithoutEnoughContact) {
  const auto all_at_floor = [](const ForceFeatures& features) {
    return features.size == kFloor && features.roughness == kFloor &&
           std::all_of(features.spectrum.begin(), features.spectrum.end(),
                       [](double value) { return value == kFloor; });
  };
  EXPECT_TRUE(all_at_floor(force_features({})));
  EXPECT_TRUE(all_at_floor(force_features(
      felt_on(sinusoid(2e-3, 0.1), {.speed_m_per_s = 0.05, .duration_s = 1.0}).felt())));
  EXPECT_FALSE(all_at_floor(force_features(
      felt_on(sinusoid(2e-3, 0.1), {.speed_m_per_s = 0.05, .duration_s = 1.5}).felt())));
}

TEST(ForceFeatures, RefuseWhatIsNoRecord) {
  Record record = felt_on(sinusoid(2e-3, 0.1), {});
  Record shorter = record;
  shorter.normal_N.pop_back();
  EXPECT_THROW(force_features(shorter.felt()), std::invalid_argument);
  Record broken = record;
  broken.lateral_N[10] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(force_features(broken.felt()), std::invalid_argument);
  Record backwards = record;
  backwards.travel_m[10] = 0.0;
  EXPECT_THROW(force_features(backwards.felt()), std::invalid_argument);
}

// Bands one apart add 1/kFeatureBands each, size and roughness 1 each: 1 + 4 + 9.
TEST(ForceFeatures, WeighBandsByTheirNumber) {
  ForceFeatures a;
  ForceFeatures b;
  b.spectrum.fill(1.0);
  b.size = 2.0;
  b.roughness = 3.0;
  EXPECT_NEAR(squared_distance(a, b), 14.0, 1e-12);
}

}  // namespace
}  // namespace asperity
