// The simulated probe: presses, strokes, settles, fails on cue.

#include "device/simulated_device.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr HandHabits kSteady{.speed_variation = 0.0, .force_variation = 0.0, .drift_m = 0.0};
constexpr double kFriction = 0.2;

std::int64_t nanoseconds(double duration_s) { return std::llround(1e9 * duration_s); }

// A plate of stiffness `stiffness_N_per_m` at z = 0 with Coulomb friction, smooth around rest.
glm::dvec3 plate_N(const ProbeState& probe, double stiffness_N_per_m) {
  const double normal_N = stiffness_N_per_m * std::max(0.0, -probe.position_m.z);
  const glm::dvec3 along = {probe.velocity_m_per_s.x, probe.velocity_m_per_s.y, 0.0};
  const double speed_m_per_s = glm::length(along);
  const double friction_N = kFriction * normal_N * std::tanh(speed_m_per_s / 0.005);
  const glm::dvec3 against = speed_m_per_s > 0.0 ? along / speed_m_per_s : glm::dvec3(0.0);
  return glm::dvec3(0.0, 0.0, normal_N) - friction_N * against;
}

struct Sample {
  double time_s = 0.0;
  ProbeState probe{};
  glm::dvec3 force_N{0.0};
};

using Force = std::function<glm::dvec3(const ProbeState& probe, double time_s)>;

// Reads and pushes at `rate_Hz`, from `from_s` to `to_s`.
std::vector<Sample> run(HapticDevice& device, double rate_Hz, double from_s, double to_s,
                        const Force& force) {
  std::vector<Sample> samples;
  const double dt_s = 1.0 / rate_Hz;
  for (int tick = 0; from_s + tick * dt_s < to_s; ++tick) {
    Sample sample{.time_s = from_s + tick * dt_s};
    sample.probe = device.read(nanoseconds(sample.time_s)).value();
    const glm::dvec3 wanted_N = force(sample.probe, sample.time_s);
    sample.force_N = device.push({.force_N = wanted_N}, dt_s).value().wrench.force_N;
    samples.push_back(sample);
  }
  return samples;
}

Force plate(double stiffness_N_per_m) {
  return [stiffness_N_per_m](const ProbeState& probe, double) {
    return plate_N(probe, stiffness_N_per_m);
  };
}

glm::dvec3 nothing(const ProbeState&, double) { return glm::dvec3(0.0); }

struct Contact {
  double stiffness_N_per_m = 500.0;
  double rate_Hz = 1000.0;
};

class OnAPlate : public testing::TestWithParam<Contact> {};

INSTANTIATE_TEST_SUITE_P(SimulatedDevice, OnAPlate,
                         testing::Values(Contact{200.0, 500.0}, Contact{500.0, 500.0},
                                         Contact{3000.0, 500.0}, Contact{200.0, 1000.0},
                                         Contact{500.0, 1000.0}, Contact{1000.0, 1000.0},
                                         Contact{3000.0, 1000.0}, Contact{500.0, 4000.0},
                                         Contact{200.0, 10000.0}, Contact{3000.0, 10000.0}),
                         [](const testing::TestParamInfo<Contact>& contact) {
                           return std::to_string(std::lround(contact.param.stiffness_N_per_m)) +
                                  "NPerMAt" + std::to_string(std::lround(contact.param.rate_Hz)) +
                                  "Hz";
                         });

TEST_P(OnAPlate, PressesSteadilyWithTheWantedForce) {
  VirtualHand hand(kSteady, Random(1));
  SimulatedDevice device(hand, {});
  hand.stroke();
  const auto samples =
      run(device, GetParam().rate_Hz, 0.0, 4.0, plate(GetParam().stiffness_N_per_m));
  for (const Sample& sample : samples) {
    if (sample.time_s > 1.0) {  // down and settled
      ASSERT_NEAR(sample.force_N.z, 1.0, 0.005) << "at " << sample.time_s << " s";
    }
  }
}

TEST_P(OnAPlate, StaysInContactOnceItHasTouched) {
  VirtualHand hand(kSteady, Random(1));
  SimulatedDevice device(hand, {});
  hand.stroke();
  double highest_N = 0.0;
  double touched_s = std::numeric_limits<double>::infinity();
  for (const Sample& sample :
       run(device, GetParam().rate_Hz, 0.0, 2.0, plate(GetParam().stiffness_N_per_m))) {
    highest_N = std::max(highest_N, sample.force_N.z);
    if (sample.force_N.z > 0.0) {
      touched_s = std::min(touched_s, sample.time_s);
    } else {
      // A hard plate may throw the probe up once before the hand presses.
      ASSERT_LT(sample.time_s, touched_s + 0.05);
    }
  }
  EXPECT_LT(touched_s, 0.3);
  EXPECT_LT(highest_N, 1.05);
}

TEST_P(OnAPlate, SettlesWhereTheHoldAndThePlateBalance) {
  // The lifted hand holds the probe 3 mm below the top of a plate:
  // k_hand (z_hand − z) + k (z_top − z) = 0.
  VirtualHand hand(kSteady, Random(1));
  SimulatedDevice device(hand, {});
  const double top_m = 0.013;
  const double k = GetParam().stiffness_N_per_m;
  const auto samples =
      run(device, GetParam().rate_Hz, 0.0, 3.0, [k, top_m](const ProbeState& probe, double) {
        return glm::dvec3(0.0, 0.0, k * std::max(0.0, top_m - probe.position_m.z));
      });
  const double balance_m = (300.0 * 0.010 + k * top_m) / (300.0 + k);
  EXPECT_NEAR(samples.back().probe.position_m.z, balance_m, 1e-7);
  EXPECT_NEAR(samples.back().probe.velocity_m_per_s.z, 0.0, 1e-6);
}

TEST(SimulatedDevice, PressesWithTheMeanOfAVaryingForce) {
  VirtualHand hand(HandHabits{}, Random(2));
  SimulatedDevice device(hand, {});
  hand.stroke();
  double sum_N = 0.0;
  int count = 0;
  for (const Sample& sample : run(device, 1000.0, 0.0, 60.0, plate(500.0))) {
    if (sample.time_s > 1.0) {
      sum_N += sample.force_N.z;
      ++count;
    }
  }
  EXPECT_NEAR(sum_N / count, 1.0, 0.04);  // three standard errors of 10 % over 65 strokes
}

TEST(SimulatedDevice, ReachesTheStrokesSpeedAgainstFriction) {
  for (const double speed_m_per_s : {0.060, 0.080}) {
    HandHabits habits = kSteady;
    habits.speed_m_per_s = speed_m_per_s;
    VirtualHand hand(habits, Random(3));
    SimulatedDevice device(hand, {});
    hand.stroke();
    int middle = 0;
    for (const Sample& sample : run(device, 1000.0, 0.0, 6.0, plate(500.0))) {
      const ProbeState& probe = sample.probe;
      if (sample.time_s > 2.0 && std::abs(probe.position_m.x) < 0.015) {
        ASSERT_NEAR(std::abs(probe.velocity_m_per_s.x), speed_m_per_s, 0.02 * speed_m_per_s);
        ++middle;
      }
    }
    EXPECT_GT(middle, 1000);
  }
}

TEST(SimulatedDevice, NeitherLagsNorLeadsASteadyHand) {
  // At a constant speed without friction the spring and the damper are both at rest.
  VirtualHand hand(kSteady, Random(3));
  VirtualHand same_hand(kSteady, Random(3));
  SimulatedDevice device(hand, {});
  hand.stroke();
  same_hand.stroke();
  int middle = 0;
  for (const Sample& sample : run(device, 1000.0, 0.0, 3.0, nothing)) {
    const HandIntent intent = same_hand.intent(nanoseconds(sample.time_s));
    if (!intent.lifted && std::abs(intent.position_m.x) < 0.005) {
      ASSERT_NEAR(sample.probe.position_m.x, intent.position_m.x, 1e-6);
      ++middle;
    }
  }
  EXPECT_GT(middle, 100);
}

TEST(SimulatedDevice, ReportsTheVelocityOfTheMass) {
  // With one step per read the way between two reads is the velocity times the time.
  VirtualHand hand(HandHabits{}, Random(4));
  SimulatedDevice device(hand, {.substeps = 1});
  hand.stroke();
  const auto samples = run(device, 1000.0, 0.0, 3.0, plate(1000.0));
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const glm::dvec3 way_m = samples[i].probe.position_m - samples[i - 1].probe.position_m;
    ASSERT_LT(glm::distance(way_m, 1e-3 * samples[i].probe.velocity_m_per_s), 1e-15);
  }
}

TEST(SimulatedDevice, FollowsNewtonsLawWhenPushed) {
  // A push of 2 N on 0.05 kg for a time short against the hold's: v = F/m·t·(1 − b t/2m + …).
  VirtualHand hand(kSteady, Random(4));
  SimulatedDevice device(hand, {});
  device.set_limits({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  const auto samples = run(device, 10'000.0, 0.0, 0.00105,
                           [](const ProbeState&, double) { return glm::dvec3(0.0, 2.0, 0.0); });
  const double t = 1e-3;
  const double expected_m_per_s = 2.0 / 0.050 * t * (1.0 - 5.0 * t / (2.0 * 0.050));
  EXPECT_NEAR(samples.back().probe.velocity_m_per_s.y, expected_m_per_s, 0.005 * expected_m_per_s);
}

TEST(SimulatedDevice, LosesEnergyWhenTheHandIsLeftAlone) {
  const HandMechanics mechanics{};
  for (const double rate_Hz : {500.0, 1000.0, 10'000.0}) {
    VirtualHand hand(kSteady, Random(5));
    SimulatedDevice device(hand, {});
    const glm::dvec3 hold_m = hand.intent(0).position_m;
    run(device, rate_Hz, 0.0, 0.03,
        [](const ProbeState&, double) { return glm::dvec3(3.0, -2.0, 3.0); });
    device.zero_force();
    double last_J = std::numeric_limits<double>::infinity();
    double first_J = 0.0;
    for (const Sample& sample : run(device, rate_Hz, 0.03, 1.0, nothing)) {
      const glm::dvec3 stretch_m = sample.probe.position_m - hold_m;
      const glm::dvec3 v = sample.probe.velocity_m_per_s;
      const double energy_J = 0.5 * mechanics.mass_kg * glm::dot(v, v) +
                              0.5 * mechanics.stiffness_N_per_m * glm::dot(stretch_m, stretch_m);
      ASSERT_LE(energy_J, last_J);
      first_J = first_J == 0.0 ? energy_J : first_J;
      last_J = energy_J;
    }
    EXPECT_GT(first_J, 1e-3);
    EXPECT_LT(last_J, 1e-12);
  }
}

TEST(SimulatedDevice, EnduresAForceAtTheLimitThatSwitchesOnAndOff) {
  for (const double rate_Hz : {500.0, 1000.0, 10'000.0}) {
    for (const double switching_Hz : {1.0, 6.0, 12.3, 40.0, 250.0}) {
      for (const glm::dvec3& texture_N :
           {glm::dvec3(5.0, 0.0, 0.0), glm::dvec3(0.0, 0.0, 5.0), glm::dvec3(0.0, 0.0, -4.0)}) {
        VirtualHand hand(kSteady, Random(6));
        SimulatedDevice device(hand, {});
        hand.stroke();
        double lowest_m = 1.0;
        double highest_m = -1.0;
        double widest_m = 0.0;
        double fastest_m_per_s = 0.0;
        for (const Sample& sample :
             run(device, rate_Hz, 0.0, 3.0, [&](const ProbeState&probe, double time_s) {
               const bool on = std::fmod(time_s * switching_Hz, 1.0) < 0.5;
               const bool touches = probe.position_m.z < 0.0;
               return plate_N(probe, 1000.0) + (on && touches ? texture_N : glm::dvec3(0.0));
             })) {
          lowest_m = std::min(lowest_m, sample.probe.position_m.z);
          highest_m = std::max(highest_m, sample.probe.position_m.z);
          widest_m = std::max(widest_m, std::abs(sample.probe.position_m.x));
          fastest_m_per_s = std::max(fastest_m_per_s, glm::length(sample.probe.velocity_m_per_s));
        }
        // 1 N of the hand and 4 N of the texture press 5 mm deep; twice that is a swing, not a
        // tunnel. 5 N pull the hold 17 mm aside, and it may swing by half of that again.
        EXPECT_GT(lowest_m, -0.010);
        EXPECT_LT(highest_m, 0.0101);
        EXPECT_LT(widest_m, 0.030 + 0.025);
        EXPECT_LT(fastest_m_per_s, 1.0);
      }
    }
  }
}

TEST(SimulatedDevice, StopsAtItsReachWhereThereIsNoSurface) {
  VirtualHand hand(kSteady, Random(7));
  SimulatedDevice device(hand, {});
  hand.stroke();
  const auto samples = run(device, 1000.0, 0.0, 3.0, nothing);
  EXPECT_NEAR(samples.back().probe.position_m.z, -0.020 - 1.0 / 300.0, 1e-6);
}

TEST(SimulatedDevice, LeavesThePlateWhenTheHandLifts) {
  VirtualHand hand(kSteady, Random(7));
  SimulatedDevice device(hand, {});
  hand.stroke();
  run(device, 1000.0, 0.0, 2.0, plate(500.0));
  hand.lift();
  const auto samples = run(device, 1000.0, 2.0, 3.0, plate(500.0));
  EXPECT_EQ(samples[400].force_N, glm::dvec3(0.0));
  EXPECT_NEAR(samples.back().probe.position_m.z, 0.010, 1e-6);
}

TEST(SimulatedDevice, IsMovedInTheSameWayEachTimeThatTheHandComesDown) {
  VirtualHand hand(HandHabits{}, Random(31));
  SimulatedDevice device(hand, {});
  std::int64_t tick = 0;
  const auto moved = [&](int ticks) {
    std::vector<ProbeState> states;
    for (int i = 0; i < ticks; ++i) {
      states.push_back(device.read(kTick_ns * ++tick).value());
      device.push({.force_N = plate_N(states.back(), 500.0)}, 1e-3);
    }
    return states;
  };
  moved(1);
  std::vector<ProbeState> first;
  for (const int ticks : {900, 1430, 2777, 900}) {
    while (!hand.is_ready()) moved(1);
    hand.stroke();
    const std::vector<ProbeState> visit = moved(ticks);
    if (first.empty()) first = visit;
    for (std::size_t i = 0; i < first.size(); ++i) {
      ASSERT_EQ(visit[i].position_m, first[i].position_m) << i;
      ASSERT_EQ(visit[i].velocity_m_per_s, first[i].velocity_m_per_s) << i;
    }
    hand.lift();
    moved(1);
  }
}

TEST(SimulatedDevice, MovesTheSameBitForBitFromTheSameSeedAndCalls) {
  const auto moved = [](std::uint64_t seed, std::int64_t epoch_ns) {
    VirtualHand hand(HandHabits{}, Random(seed));
    SimulatedDevice device(hand, {});
    hand.stroke();
    std::vector<glm::dvec3> positions_m;
    for (int tick = 0; tick < 5000; ++tick) {
      const ProbeState probe = device.read(epoch_ns + kTick_ns * tick).value();
      positions_m.push_back(probe.position_m);
      device.push({.force_N = plate_N(probe, 500.0)}, 1e-3);
    }
    return positions_m;
  };
  EXPECT_EQ(moved(1, 0), moved(1, 0));
  EXPECT_EQ(moved(1, 0), moved(1, 1'700'000'000'000'000'000));  // it knows no clock
  EXPECT_NE(moved(1, 0), moved(2, 0));
}

TEST(SimulatedDevice, MovesAlikeSteppedAndAtTheUnevenTimesOfARealClock) {
  const auto moved = [](double jitter_s) {
    VirtualHand hand(kSteady, Random(8));
    SimulatedDevice device(hand, {});
    hand.stroke();
    Random jitter(9);
    std::int64_t last_ns = 0;
    ProbeState probe{};
    for (int tick = 0; tick <= 4000; ++tick) {
      const double late_s = tick == 4000 ? 0.0 : jitter_s * jitter.uniform();
      const std::int64_t now_ns = nanoseconds(1e-3 * tick + late_s);
      probe = device.read(now_ns).value();
      device.push({.force_N = plate_N(probe, 500.0)},
                  1e-9 * static_cast<double>(std::max<std::int64_t>(1, now_ns - last_ns)));
      last_ns = now_ns;
    }
    return probe.position_m;
  };
  EXPECT_LT(glm::distance(moved(0.0), moved(0.4e-3)), 20e-6);
}

TEST(SimulatedDevice, DoesNotJumpAfterALongGap) {
  VirtualHand hand(kSteady, Random(10));
  SimulatedDevice device(hand, {});
  hand.stroke();
  const ProbeState before = run(device, 1000.0, 0.0, 2.0, plate(500.0)).back().probe;
  const auto after = run(device, 1000.0, 60.0, 61.0, plate(500.0));
  // 0.1 s of a stroke, and of a hand that is held by the last force.
  EXPECT_LT(glm::distance(before.position_m, after.front().probe.position_m), 0.012);
  EXPECT_EQ(after.front().probe.time_ns, nanoseconds(60.0));
  EXPECT_NEAR(after.back().force_N.z, 1.0, 0.01);
}

TEST(SimulatedDevice, StandsStillInALongGap) {
  VirtualHand hand(kSteady, Random(10));
  SimulatedDevice device(hand, {});
  hand.stroke();
  run(device, 1000.0, 0.0, 2.0, plate(500.0));
  device.zero_force();
  // Nothing holds the hand: in 0.1 s it sinks from −2 mm at 1 N / 10 N·s/m, in 10 s to its reach.
  EXPECT_GT(device.read(nanoseconds(12.0)).value().position_m.z, -0.002 - 0.1 * 0.1);
}

TEST(SimulatedDevice, StepsThroughAShortGapAsIfItHadBeenRead) {
  const auto swings = [](int gap_ms) {
    VirtualHand hand(kSteady, Random(10));
    SimulatedDevice device(hand, {.substeps = 1});
    run(device, 1000.0, 0.0, 0.1, [](const ProbeState&, double) { return glm::dvec3(3.0); });
    device.zero_force();
    ProbeState probe{};
    for (int tick = 100 + gap_ms; tick <= 150; tick += gap_ms) {
      probe = device.read(kTick_ns * tick).value();
    }
    return probe.position_m;
  };
  EXPECT_LT(glm::distance(swings(1), swings(50)), 1e-12);
}

TEST(SimulatedDevice, AnswersNothingWhileItIsLostOnCue) {
  VirtualHand hand(kSteady, Random(11));
  SimulatedDevice device(
      hand, {.faults = {{.kind = ScriptedFault::Kind::lost, .at_s = 0.5, .duration_s = 0.25}}});
  hand.stroke();
  const std::int64_t epoch_ns = 777;
  for (int tick = 0; tick < 1000; ++tick) {
    const auto probe = device.read(epoch_ns + kTick_ns * tick);
    const auto sent = device.push({.force_N = {0.0, 0.0, 0.5}}, 1e-3);
    const bool lost = tick >= 500 && tick < 750;
    ASSERT_EQ(probe.has_value(), !lost) << "tick " << tick;
    ASSERT_EQ(sent.has_value(), !lost) << "tick " << tick;
  }
}

TEST(SimulatedDevice, StaysLostForEverWithoutADuration) {
  VirtualHand hand(kSteady, Random(11));
  SimulatedDevice device(hand, {.faults = {{.kind = ScriptedFault::Kind::lost, .at_s = 0.5}}});
  EXPECT_TRUE(device.read(0).has_value());
  EXPECT_TRUE(device.read(nanoseconds(0.499)).has_value());
  EXPECT_FALSE(device.read(nanoseconds(0.5)).has_value());
  EXPECT_FALSE(device.read(nanoseconds(5000.0)).has_value());
}

TEST(SimulatedDevice, HasItsMotorsAtZeroWhileItIsLost) {
  VirtualHand hand(kSteady, Random(11));
  SimulatedDevice device(
      hand, {.faults = {{.kind = ScriptedFault::Kind::lost, .at_s = 0.5, .duration_s = 0.5}}});
  const double x_m = run(device, 1000.0, 0.0, 0.499,
                         [](const ProbeState&, double) { return glm::dvec3(3.0, 0.0, 0.0); })
                         .back()
                         .probe.position_m.x;
  EXPECT_NEAR(x_m, -0.030 + 3.0 / 300.0, 1e-4);
  for (int tick = 500; tick < 1000; ++tick) {
    EXPECT_FALSE(device.read(kTick_ns * tick).has_value());
  }
  EXPECT_NEAR(device.read(nanoseconds(1.0)).value().position_m.x, -0.030, 1e-4);
}

TEST(SimulatedDevice, AnswersWithAPositionThatIsNotANumberOnCueAndRecovers) {
  VirtualHand hand(kSteady, Random(12));
  SimulatedDevice device(
      hand, {.faults = {{.kind = ScriptedFault::Kind::nan, .at_s = 0.002, .duration_s = 0.001}}});
  EXPECT_TRUE(std::isfinite(device.read(nanoseconds(0.001)).value().position_m.x));
  EXPECT_TRUE(std::isfinite(device.read(nanoseconds(0.0029)).value().position_m.x));
  EXPECT_TRUE(std::isnan(device.read(nanoseconds(0.003)).value().position_m.x));
  EXPECT_TRUE(std::isnan(device.read(nanoseconds(0.0035)).value().position_m.z));
  EXPECT_TRUE(std::isfinite(device.read(nanoseconds(0.004)).value().position_m.x));
}

TEST(SimulatedDevice, SleepsOnceForAStallWhereItIsToldHow) {
  std::vector<double> slept_s;
  VirtualHand hand(kSteady, Random(13));
  SimulatedDevice device(
      hand, {.faults = {{.kind = ScriptedFault::Kind::stall, .at_s = 0.0, .duration_s = 0.1},
                        {.kind = ScriptedFault::Kind::stall, .at_s = 0.01, .duration_s = 0.2}},
             .sleep = [&slept_s](double duration_s) { slept_s.push_back(duration_s); }});
  device.read(5);
  EXPECT_EQ(slept_s, std::vector<double>({0.1}));
  device.read(5 + nanoseconds(0.009));
  EXPECT_EQ(slept_s.size(), 1U);
  device.read(5 + nanoseconds(0.011));  // late, and yet not forgotten
  EXPECT_EQ(slept_s, std::vector<double>({0.1, 0.2}));
  device.read(5 + nanoseconds(0.012));
  EXPECT_EQ(slept_s.size(), 2U);
}

TEST(SimulatedDevice, MovesOnThroughAStallWhenStepped) {
  VirtualHand hand(kSteady, Random(13));
  VirtualHand same_hand(kSteady, Random(13));
  SimulatedDevice stalled(
      hand, {.faults = {{.kind = ScriptedFault::Kind::stall, .at_s = 0.1, .duration_s = 9.0}}});
  SimulatedDevice plain(same_hand, {});
  hand.stroke();
  same_hand.stroke();
  EXPECT_EQ(run(stalled, 1000.0, 0.0, 1.0, plate(500.0)).back().probe.position_m,
            run(plain, 1000.0, 0.0, 1.0, plate(500.0)).back().probe.position_m);
}

TEST(SimulatedDevice, IsMovedByAForceAndByTheHandAfterARest) {
  VirtualHand hand(kSteady, Random(14));
  SimulatedDevice device(hand, {});
  const ProbeState rests = run(device, 1000.0, 0.0, 1.0, nothing).back().probe;
  EXPECT_EQ(run(device, 1000.0, 1.0, 1.1, nothing).back().probe.position_m, rests.position_m);
  const auto push = [](const ProbeState&, double) { return glm::dvec3(0.0, 4.0, 0.0); };
  const ProbeState pushed = run(device, 1000.0, 1.1, 1.6, push).back().probe;
  EXPECT_NEAR(pushed.position_m.y - rests.position_m.y, 4.0 / 300.0, 1e-4);
  EXPECT_EQ(run(device, 1000.0, 1.6, 3.0, nothing).back().probe.position_m, rests.position_m);
  hand.stroke();
  EXPECT_LT(run(device, 1000.0, 3.0, 3.1, nothing).back().probe.position_m.z, rests.position_m.z);
}

TEST(SimulatedDevice, LetsTheProbeGoAtZeroForce) {
  VirtualHand hand(kSteady, Random(14));
  SimulatedDevice device(hand, {});
  run(device, 1000.0, 0.0, 0.5,
      [](const ProbeState&, double) { return glm::dvec3(0.0, 4.0, 0.0); });
  EXPECT_NEAR(device.read(nanoseconds(0.5)).value().position_m.y, 4.0 / 300.0, 1e-4);
  device.zero_force();
  for (int tick = 501; tick < 1500; ++tick) {
    device.read(kTick_ns * tick);
  }
  EXPECT_NEAR(device.read(nanoseconds(1.5)).value().position_m.y, 0.0, 1e-6);
}

TEST(SimulatedDevice, ReadsTheButtonsThatTheHandHoldsDown) {
  VirtualHand hand(HandHabits{}, Random(18));
  SimulatedDevice device(hand, {});
  EXPECT_EQ(device.capability().buttons, 2);
  EXPECT_EQ(device.read(0).value().buttons, 0U);
  hand.press(1);
  EXPECT_EQ(device.read(kTick_ns).value().buttons, 1U);
  hand.press(2);
  EXPECT_EQ(device.read(2 * kTick_ns).value().buttons, 3U);
  hand.release(1);
  EXPECT_EQ(device.read(3 * kTick_ns).value().buttons, 2U);
  hand.release(2);
  EXPECT_EQ(device.read(4 * kTick_ns).value().buttons, 0U);
}

TEST(SimulatedDevice, SeesAPressThatFallsBetweenTwoReadingsOnce) {
  VirtualHand hand(HandHabits{}, Random(19));
  SimulatedDevice device(hand, {});
  device.read(0);
  hand.press(2);
  hand.release(2);
  EXPECT_EQ(device.read(kTick_ns).value().buttons, 2U);
  EXPECT_EQ(device.read(2 * kTick_ns).value().buttons, 0U);
}

TEST(SimulatedDevice, MovesTheSameWhateverButtonsArePressed) {
  VirtualHand still(HandHabits{}, Random(20));
  VirtualHand pressing(HandHabits{}, Random(20));
  still.stroke();
  pressing.stroke();
  pressing.press(1);
  SimulatedDevice one(still, {});
  SimulatedDevice other(pressing, {});
  EXPECT_EQ(run(one, 1000.0, 0.0, 1.0, plate(500.0)).back().probe.position_m,
            run(other, 1000.0, 0.0, 1.0, plate(500.0)).back().probe.position_m);
}

TEST(VirtualHandButtons, RefusesAButtonThatIsNotThere) {
  VirtualHand hand(HandHabits{}, Random(21));
  EXPECT_THROW(hand.press(0), std::invalid_argument);
  EXPECT_THROW(hand.release(3), std::invalid_argument);
}

TEST(SimulatedDevice, SaysWhatItCanDoAndLowersLimitsToIt) {
  VirtualHand hand(HandHabits{}, Random(15));
  SimulatedDevice strong(hand, {});
  EXPECT_EQ(strong.capability().name, "simulated");
  EXPECT_EQ(strong.capability().maximum_rate_Hz, 10'000.0);
  EXPECT_EQ(strong.capability().pacing, Pacing::ours);
  EXPECT_EQ(strong.limits().force_N, 5.0);
  SimulatedDevice weak(hand, {.peak_force_N = 3.0});
  EXPECT_EQ(weak.limits().force_N, 3.0);
  weak.set_limits({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  weak.read(0);
  const auto sent = weak.push({.force_N = {0.0, 0.0, 5.0}}, 1e-3);
  EXPECT_LE(glm::length(sent.value().wrench.force_N), 3.0);
  EXPECT_TRUE(sent->has(LimitReason::force));
}

// A golden trace: recordings that were made with a device without imperfections replay for ever.
TEST(SimulatedDevice, WithoutImperfectionsMovesAsItAlwaysDid) {
  VirtualHand hand(HandHabits{}, Random(22));
  SimulatedDevice device(hand, {});
  hand.stroke();
  std::uint64_t trace = 0xcbf29ce484222325U;  // FNV-1a, a word at a time
  for (int tick = 0; tick < 5000; ++tick) {
    const ProbeState probe = device.read(kTick_ns * tick).value();
    for (int axis = 0; axis < 3; ++axis) {
      trace = (trace ^ std::bit_cast<std::uint64_t>(probe.position_m[axis])) * 0x100000001b3U;
      trace = (trace ^ std::bit_cast<std::uint64_t>(probe.velocity_m_per_s[axis])) * 0x100000001b3U;
    }
    // No function of libm in it, so that the bits are the same everywhere.
    const double normal_N = 500.0 * std::max(0.0, -probe.position_m.z);
    device.push({.force_N = {-0.5 * probe.velocity_m_per_s.x * normal_N, 0.0, normal_N}}, 1e-3);
  }
  EXPECT_EQ(trace, 0xd0cea499f3eec838U);
}

// Strokes on a plate without friction of its own, and the hand that holds the probe.
struct Stroke {
  std::vector<Sample> samples{};
  std::vector<HandIntent> intents{};
};
Stroke stroked(const SimulatedDeviceSettings& settings, const HandHabits& habits, double to_s) {
  VirtualHand hand(habits, Random(23));
  VirtualHand same_hand(habits, Random(23));
  SimulatedDevice device(hand, settings);
  hand.stroke();
  same_hand.stroke();
  Stroke stroke;
  stroke.samples = run(device, 1000.0, 0.0, to_s, [](const ProbeState& probe, double) {
    return glm::dvec3(0.0, 0.0, 500.0 * std::max(0.0, -probe.position_m.z));
  });
  for (const Sample& sample : stroke.samples) {
    stroke.intents.push_back(same_hand.intent(nanoseconds(sample.time_s)));
  }
  return stroke;
}

bool is_steady(const Sample& sample, const HandIntent& intent) {
  return sample.time_s > 1.0 && !intent.lifted && glm::length(intent.position_m) < 0.010;
}

TEST(SimulatedDevice, DoesNotMoveForAForceBelowItsFriction) {
  VirtualHand hand(kSteady, Random(24));
  SimulatedDevice device(hand, {.friction_N = 0.3});
  const glm::dvec3 start_m = device.read(0).value().position_m;
  const glm::dvec3 push_N = 0.299 * glm::normalize(glm::dvec3(1.0, -2.0, 0.5));
  const auto samples =
      run(device, 1000.0, 0.001, 1.0, [&](const ProbeState&, double) { return push_N; });
  EXPECT_EQ(samples.back().probe.position_m, start_m);
  EXPECT_EQ(samples.back().probe.velocity_m_per_s, glm::dvec3(0.0));
  const auto stronger =
      run(device, 1000.0, 1.0, 2.0, [&](const ProbeState&, double) { return 1.01 * push_N; });
  EXPECT_NE(stronger.back().probe.position_m, start_m);
}

TEST(SimulatedDevice, StopsWhereFrictionBearsWhatIsLeftOfTheForce) {
  // At rest |F − k x| ≤ f.
  VirtualHand hand(kSteady, Random(24));
  SimulatedDevice device(hand, {.friction_N = 0.3});
  const glm::dvec3 start_m = device.read(0).value().position_m;
  const glm::dvec3 push_N(2.0, 1.0, -1.0);
  const auto samples =
      run(device, 1000.0, 0.001, 2.0, [&](const ProbeState&, double) { return push_N; });
  EXPECT_EQ(samples.back().probe.velocity_m_per_s, glm::dvec3(0.0));
  const glm::dvec3 way_m = samples.back().probe.position_m - start_m;
  EXPECT_LE(glm::length(push_N - 300.0 * way_m), 0.3);
  EXPECT_GT(glm::length(way_m), 2.0 / 300.0);
}

TEST(SimulatedDevice, TrailsAStrokingHandByItsFrictionInAnyDirection) {
  // The hold's spring bears the friction: k (x_hand − x) = f.
  for (const double direction_rad : {0.0, 0.7, 2.0}) {
    HandHabits habits = kSteady;
    habits.direction_rad = direction_rad;
    const Stroke stroke = stroked({.friction_N = 0.3}, habits, 4.0);
    int steady = 0;
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
      if (!is_steady(stroke.samples[i], stroke.intents[i])) continue;
      const glm::dvec3 way_m = stroke.intents[i].position_m - stroke.samples[i].probe.position_m;
      ASSERT_NEAR(std::hypot(way_m.x, way_m.y), 0.3 / 300.0, 2e-6);
      ++steady;
    }
    EXPECT_GT(steady, 500);
  }
}

TEST(SimulatedDevice, WithFrictionStaysSteadyAtEveryRate) {
  for (const double rate_Hz : {500.0, 1000.0, 10'000.0}) {
    VirtualHand hand(kSteady, Random(25));
    SimulatedDevice device(hand, {.friction_N = 0.3});
    hand.stroke();
    for (const Sample& sample : run(device, rate_Hz, 0.0, 3.0, plate(1000.0))) {
      if (sample.time_s > 1.5) {
        ASSERT_NEAR(sample.force_N.z, 1.0, 0.31) << sample.time_s;
      }
    }
  }
}

TEST(SimulatedDevice, GivesNoMoreThanItsMotorsWhenTheySaturate) {
  VirtualHand hand(kSteady, Random(26));
  SimulatedDevice device(hand, {.saturation_force_N = 2.0});
  device.set_limits({.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  device.read(0);
  const LimitedWrench within = device.push({.force_N = {0.0, 1.9, 0.0}}, 1e-3).value();
  EXPECT_EQ(within.wrench.force_N, glm::dvec3(0.0, 1.9, 0.0));
  EXPECT_EQ(within.reasons, 0);
  const LimitedWrench beyond = device.push({.force_N = {0.0, 3.0, 4.0}}, 1e-3).value();
  EXPECT_NEAR(glm::length(beyond.wrench.force_N), 2.0, 1e-12);
  EXPECT_NEAR(beyond.wrench.force_N.y / beyond.wrench.force_N.z, 0.75, 1e-12);
  EXPECT_TRUE(beyond.has(LimitReason::force));
  // And so much is what the hand feels: it yields by F/k.
  const auto samples = run(device, 1000.0, 0.001, 1.0,
                           [](const ProbeState&, double) { return glm::dvec3(0.0, 4.0, 0.0); });
  EXPECT_NEAR(samples.back().probe.position_m.y, 2.0 / 300.0, 1e-6);
}

TEST(SimulatedDevice, ReadsAMovingHandLateBySpeedTimesLatency) {
  // 3.4 ms is between two readings, 60 ms would be too much.
  const Stroke stroke = stroked({.sensor = {.latency_s = 0.0034}}, kSteady, 4.0);
  int steady = 0;
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    if (!is_steady(stroke.samples[i], stroke.intents[i])) continue;
    const HandIntent& intent = stroke.intents[i];
    const glm::dvec3 late_m = intent.position_m - stroke.samples[i].probe.position_m;
    ASSERT_NEAR(late_m.x, 0.0034 * intent.velocity_m_per_s.x, 2e-6);
    ASSERT_NEAR(stroke.samples[i].probe.velocity_m_per_s.x, intent.velocity_m_per_s.x, 1e-4);
    ++steady;
  }
  EXPECT_GT(steady, 500);
}

TEST(SimulatedDevice, WithImperfectionsMovesTheSameFromTheSameSeeds) {
  const auto moved = [](std::uint64_t noise_seed) {
    const SimulatedDeviceSettings settings{.friction_N = 0.1,
                                           .sensor = {.latency_s = 0.001,
                                                      .position_noise_m = 5e-6,
                                                      .position_step_m = 38e-6,
                                                      .velocity = VelocityWindow{},
                                                      .noise_seed = noise_seed}};
    std::vector<glm::dvec3> positions_m;
    for (const Sample& sample : stroked(settings, HandHabits{}, 2.0).samples) {
      positions_m.push_back(sample.probe.position_m);
    }
    return positions_m;
  };
  EXPECT_EQ(moved(1), moved(1));
  EXPECT_NE(moved(1), moved(2));
}

TEST(SimulatedDevice, RefusesASettingThatIsOutOfRangeByName) {
  VirtualHand hand(HandHabits{}, Random(16));
  const auto refused_field = [&hand](const SimulatedDeviceSettings& settings) {
    const std::string refusal =
        refusal_of<std::invalid_argument>([&] { SimulatedDevice device(hand, settings); });
    return refusal.substr(0, refusal.find(' '));
  };
  EXPECT_EQ(refused_field({}), "");
  EXPECT_EQ(refused_field({.hand = {.mass_kg = 0.0}}), "mass_kg");
  EXPECT_EQ(refused_field({.hand = {.damping_N_s_per_m = -1.0}}), "damping_N_s_per_m");
  EXPECT_EQ(refused_field({.hand = {.stiffness_N_per_m = 0.0}}), "stiffness_N_per_m");
  EXPECT_EQ(refused_field({.hand = {.normal_damping_N_s_per_m = 0.0}}), "normal_damping_N_s_per_m");
  EXPECT_EQ(refused_field({.hand = {.reach_m = 0.0}}), "reach_m");
  EXPECT_EQ(refused_field({.faults = {{.at_s = -1.0}}}), "at_s");
  EXPECT_EQ(refused_field({.faults = {{.duration_s = -1.0}}}), "duration_s");
  EXPECT_EQ(refused_field({.substeps = 0}), "substeps");
  EXPECT_EQ(refused_field({.peak_force_N = 0.0}), "peak_force_N");
  EXPECT_EQ(refused_field({.saturation_force_N = -1.0}), "saturation_force_N");
  EXPECT_EQ(refused_field({.friction_N = -1.0}), "friction_N");
  EXPECT_EQ(refused_field({.sensor = {.latency_s = -1.0}}), "latency_s");
  EXPECT_EQ(refused_field({.sensor = {.latency_s = 0.051}}), "latency_s");
  EXPECT_EQ(refused_field({.sensor = {.position_noise_m = -1.0}}), "position_noise_m");
  EXPECT_EQ(refused_field({.sensor = {.position_step_m = -1.0}}), "position_step_m");
  EXPECT_EQ(refused_field({.sensor = {.velocity = VelocityWindow{.samples = 1}}}), "samples");
}

TEST(SimulatedDevice, DoesNotTouchTheHeap) {
  VirtualHand hand(HandHabits{}, Random(17));
  SimulatedDevice device(
      hand, {.faults = {{.kind = ScriptedFault::Kind::lost, .at_s = 1.0, .duration_s = 0.1},
                        {.kind = ScriptedFault::Kind::nan, .at_s = 1.5, .duration_s = 0.1}},
             .saturation_force_N = 0.9,
             .friction_N = 0.1,
             .sensor = {.latency_s = 0.01,
                        .position_noise_m = 1e-6,
                        .position_step_m = 1e-6,
                        .velocity = VelocityWindow{}}});
  hand.stroke();
  AllocationGuard guard;
  for (int tick = 0; tick < 3000; ++tick) {
    const auto probe = device.read(kTick_ns * tick);
    device.push({.force_N = plate_N(probe.value_or(ProbeState{}), 500.0)}, 1e-3);
  }
  device.zero_force();
  EXPECT_EQ(guard.count(), 0);
}

// As the watch does while a tick hangs: the probe is held by the hand alone until the next push.
TEST(SimulatedDevice, ExertsNoForceFromThePointAtWhichItWasZeroedFromOutside) {
  VirtualHand hand(kSteady, Random(1));
  SimulatedDevice device(hand, {});
  const auto push = [](const ProbeState&, double) { return glm::dvec3{0.0, 0.0, 1.0}; };
  run(device, 1000.0, 0.0, 0.4, push);
  const double pushed_m = device.read(nanoseconds(0.4)).value().position_m.z;
  device.zero_force_from_outside();
  const double held_m = device.read(nanoseconds(0.44)).value().position_m.z;
  EXPECT_LT(held_m, pushed_m - 1e-4);
  run(device, 1000.0, 0.441, 0.8, push);
  EXPECT_NEAR(device.read(nanoseconds(0.8)).value().position_m.z, pushed_m, 1e-5);
}

}  // namespace
}  // namespace asperity
