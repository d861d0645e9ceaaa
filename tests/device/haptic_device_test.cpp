// What every driver gets from HapticDevice: limits, lost devices, zero force.

#include "device/haptic_device.h"

#include <limits>
#include <optional>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"
#include "tests/support/scripted_device.h"

namespace asperity {
namespace {

DeviceCapability capability(double peak_force_N) {
  return {.name = "scripted", .peak_force_N = peak_force_N};
}

TEST(HapticDevice, StampsAReadingWithTheTimeItWasAskedFor) {
  ScriptedDevice device(capability(10.0));
  device.probe.position_m = {0.01, 0.02, 0.03};
  const auto state = device.read(42);
  ASSERT_TRUE(state.has_value());
  EXPECT_EQ(state->time_ns, 42);
  EXPECT_EQ(state->position_m, glm::dvec3(0.01, 0.02, 0.03));
}

TEST(HapticDevice, SendsATorqueOnlyToMotorsThatCanTurn) {
  const Wrench wanted{.force_N = {0.0, 0.0, 1.0}, .torque_N_m = {0.0, 0.5, 0.0}};
  DeviceCapability described = capability(10.0);
  for (const int actuated : {3, 6}) {
    described.actuated_degrees_of_freedom = actuated;
    ScriptedDevice device(described, {.slew_N = 1e6, .slew_N_m = 1e6});
    const auto limited = device.push(wanted, kDt_s);
    ASSERT_TRUE(limited.has_value());
    EXPECT_EQ(device.last_sent.force_N, wanted.force_N);
    EXPECT_NEAR(device.last_sent.torque_N_m.y, actuated == 6 ? 0.1 : 0.0, 1e-15);
    EXPECT_EQ(limited->has(LimitReason::torque), actuated == 6);
  }
}

TEST(HapticDevice, SendsOnlyLimitedWrenchesAndSaysWhatItSent) {
  ScriptedDevice device(capability(10.0), {.force_N = 2.0, .torque_N_m = 0.1, .slew_N = 1e6});
  const auto limited = device.push({.force_N = {0.0, 0.0, 50.0}}, kDt_s);
  ASSERT_TRUE(limited.has_value());
  EXPECT_TRUE(limited->has(LimitReason::force));
  EXPECT_EQ(device.sent, 1);
  EXPECT_NEAR(device.last_sent.force_N.z, 2.0, 1e-14);
  EXPECT_EQ(device.last_sent.force_N, limited->wrench.force_N);
  device.push({.force_N = {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}}, kDt_s);
  EXPECT_EQ(device.sent, 2);
  EXPECT_EQ(device.last_sent.force_N, glm::dvec3(0.0));
}

TEST(HapticDevice, LowersAForceLimitAboveItsPeakForce) {
  ScriptedDevice device(capability(3.3), {.force_N = 5.0});
  EXPECT_EQ(device.limits().force_N, 3.3);
  device.set_limits({.force_N = 8.0, .torque_N_m = 0.02, .slew_N = 1e6});
  EXPECT_EQ(device.limits().force_N, 3.3);
  EXPECT_EQ(device.limits().torque_N_m, 0.02);
  device.push({.force_N = {7.0, 0.0, 0.0}}, kDt_s);
  EXPECT_EQ(device.sent, 1);
  EXPECT_LE(glm::length(device.last_sent.force_N), 3.3);
  device.set_limits({.force_N = 1.0});
  EXPECT_EQ(device.limits().force_N, 1.0);
}

TEST(HapticDevice, TellsWhatMotorsAtTheirLimitGave) {
  ScriptedDevice device(capability(10.0), {.force_N = 8.0, .slew_N = 1e6});
  device.at_send = [&device](const Wrench& limited) {
    if (limited.force_N.y > 3.0) device.gave_only({.force_N = {0.0, 3.0, 0.0}});
  };
  const auto limited = device.push({.force_N = {0.0, 6.0, 0.0}}, kDt_s);
  EXPECT_EQ(limited->wrench.force_N, glm::dvec3(0.0, 3.0, 0.0));
  EXPECT_TRUE(limited->has(LimitReason::force));
  const auto next = device.push({.force_N = {0.0, 2.0, 0.0}}, kDt_s);
  EXPECT_EQ(next->wrench.force_N, glm::dvec3(0.0, 2.0, 0.0));
  EXPECT_EQ(next->reasons, 0);
}

TEST(HapticDevice, TellsThatMotorsGaveLessWhereNobodyKnowsHowMuch) {
  ScriptedDevice device(capability(10.0), {.force_N = 8.0, .slew_N = 1e6});
  device.at_send = [&device](const Wrench&) { device.gave_less(); };
  const auto limited = device.push({.force_N = {0.0, 6.0, 0.0}}, kDt_s);
  EXPECT_EQ(limited->wrench.force_N, glm::dvec3(0.0, 6.0, 0.0));
  EXPECT_TRUE(limited->has(LimitReason::force));
  device.at_send = {};
  EXPECT_EQ(device.push({.force_N = {0.0, 6.0, 0.0}}, kDt_s)->reasons, 0);
}

TEST(HapticDevice, SendsNothingWhereThereAreNoMotors) {
  DeviceCapability mouse = capability(0.0);
  mouse.actuated_degrees_of_freedom = 0;
  ScriptedDevice device(mouse);
  const auto limited = device.push({.force_N = {0.0, 0.0, 3.0}}, kDt_s);
  ASSERT_TRUE(limited.has_value());
  EXPECT_EQ(limited->wrench.force_N, glm::dvec3(0.0));  // what the record says was felt
  EXPECT_EQ(limited->reasons, 0);
}

// Pushes for `ticks` milliseconds; the ticks in which it answered.
int answered(ScriptedDevice& device, std::int64_t& tick, int ticks, double force_N) {
  int count = 0;
  for (int i = 0; i < ticks; ++i, ++tick) {
    const bool is_read = device.read(tick * 1'000'000).has_value();
    const bool is_pushed = device.push({.force_N = {0.0, 0.0, force_N}}, kDt_s).has_value();
    EXPECT_EQ(is_read, is_pushed);
    if (is_read) ++count;
  }
  return count;
}

TEST(HapticDevice, DoesNotAnswerWithAPoseThatStaysHoweverItIsPushed) {
  ScriptedDevice device(capability(10.0));
  std::int64_t tick = 0;
  EXPECT_EQ(answered(device, tick, 3000, 1.9), 3000);
  EXPECT_EQ(device.complaint(), "");
  EXPECT_LT(answered(device, tick, 3000, 3.0), 1010);
  device.read(tick * 1'000'000);
  EXPECT_NE(device.complaint().find("the same position repeatedly"), std::string::npos);
  device.trouble_text = "Its lamp is red.";
  EXPECT_NE(device.complaint().find("open it again. Its lamp is red."), std::string::npos);
  EXPECT_EQ(answered(device, tick, 3000, 0.0), 0);  // still not believed
  device.probe.position_m.x += 38e-6;
  EXPECT_EQ(answered(device, tick, 500, 3.0), 500);
  EXPECT_EQ(device.complaint(), "Its lamp is red.");
}

// A hand may rest on a handle without force for as long as it likes.
TEST(HapticDevice, IsPushedNoLongerAfterZeroForce) {
  ScriptedDevice device(capability(10.0), {.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  std::int64_t tick = 0;
  EXPECT_EQ(answered(device, tick, 500, 3.0), 500);
  device.zero_force();
  for (const std::int64_t end = tick + 3000; tick < end; ++tick) {
    ASSERT_TRUE(device.read(tick * 1'000'000).has_value()) << tick;
  }
}

TEST(HapticDevice, TakesAReadingThatIsHeldForNoSignOfAFrozenPose) {
  ScriptedDevice device(capability(10.0));
  device.probe.velocity_m_per_s = {1.0, 0.0, 0.0};
  std::int64_t tick = 0;
  EXPECT_EQ(answered(device, tick, 10, 0.0), 10);
  device.at_read = [&device](ProbeState&) { device.read_again(); };
  EXPECT_EQ(answered(device, tick, 45, 0.0), 45);  // 4.5 cm by the velocity that is held
  EXPECT_EQ(answered(device, tick, 2000, 3.0), 2000);
  EXPECT_EQ(device.complaint(), "");
  device.at_read = {};
  EXPECT_LT(answered(device, tick, 100, 0.0), 30);  // told anew, it is one
}

TEST(HapticDevice, CountsAPushThatPausedBetweenTwoNewReadingsAsPaused) {
  ScriptedDevice device(capability(10.0), {.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  std::int64_t tick = 0;
  device.at_read = [&](ProbeState&) {
    if (tick % 10 != 0) device.read_again();
  };
  for (; tick < 5000; ++tick) {
    EXPECT_TRUE(device.read(tick * 1'000'000).has_value()) << tick;
    device.push({.force_N = {0.0, 0.0, tick % 500 == 255 ? 0.0 : 4.0}}, kDt_s);
  }
}

TEST(HapticDevice, SendsZeroWhileItDoesNotBelieveThePose) {
  ScriptedDevice device(capability(10.0), {.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1e6});
  std::int64_t tick = 0;
  for (; tick < 20; ++tick) {
    device.read(tick * 1'000'000'000);
    device.push({.force_N = {0.0, 0.0, 4.0}}, kDt_s);
  }
  EXPECT_EQ(device.last_sent.force_N, glm::dvec3(0.0));
}

TEST(HapticDevice, BelievesAComputedHandThatRestsToTheLastBit) {
  DeviceCapability computed = capability(10.0);
  computed.may_rest_exactly = true;
  ScriptedDevice device(computed);
  std::int64_t tick = 0;
  EXPECT_EQ(answered(device, tick, 5000, 4.0), 5000);
}

TEST(HapticDevice, TellsOfASilenceUntilHalfASecondAfterItsEndAtWhateverRateItIsRead) {
  for (const std::int64_t rate_Hz : {100, 1000, 4000}) {
    ScriptedDevice device(capability(10.0));
    const std::int64_t period_ns = 1'000'000'000 / rate_Hz;
    std::int64_t now_ns = 7'000'000'000;
    device.read(now_ns);
    EXPECT_FALSE(device.has_fallen_silent());
    for (int silence = 0; silence < 2; ++silence) {
      device.note_silence();
      const std::int64_t over_ns = now_ns += 3'000'000'000;
      for (; now_ns - over_ns < 500'000'000; now_ns += period_ns) {
        device.read(now_ns);
        ASSERT_TRUE(device.has_fallen_silent()) << rate_Hz << " Hz, " << now_ns - over_ns << " ns";
      }
      device.read(now_ns);
      EXPECT_FALSE(device.has_fallen_silent()) << rate_Hz << " Hz";
    }
  }
}

TEST(HapticDevice, TellsOfASilenceThatComesSoonAfterAnotherForAsLong) {
  ScriptedDevice device(capability(10.0));
  device.note_silence();
  device.read(0);
  device.note_silence();
  device.read(400 * kMillisecond_ns);
  device.read(600 * kMillisecond_ns);
  EXPECT_TRUE(device.has_fallen_silent());
  device.read(900 * kMillisecond_ns);
  EXPECT_FALSE(device.has_fallen_silent());
}

TEST(HapticDevice, RefusesMotorsWithoutAPeakForce) {
  EXPECT_THROW(ScriptedDevice(capability(0.0)), std::invalid_argument);
  EXPECT_THROW(ScriptedDevice(capability(std::numeric_limits<double>::quiet_NaN())),
               std::invalid_argument);
}

TEST(HapticDevice, AsksForNoPeakForceWhereThereAreNoMotors) {
  DeviceCapability mouse = capability(0.0);
  mouse.actuated_degrees_of_freedom = 0;
  ScriptedDevice device(mouse, {.force_N = 5.0});
  EXPECT_EQ(device.limits().force_N, 5.0);
}

TEST(HapticDevice, RefusesLimitsThatAreNotPositive) {
  ScriptedDevice device(capability(10.0));
  EXPECT_THROW(device.set_limits({.force_N = -1.0}), std::invalid_argument);
  EXPECT_THROW(device.set_limits({.force_N = std::numeric_limits<double>::quiet_NaN()}),
               std::invalid_argument);
  EXPECT_EQ(device.limits().force_N, 5.0);
}

TEST(HapticDevice, AnswersNothingWhileItIsLostAndRisesFromZeroAfterwards) {
  ScriptedDevice device(capability(10.0), {.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1.0});
  for (int i = 0; i < 4; ++i) {
    device.push({.force_N = {0.0, 0.0, 4.0}}, kDt_s);
  }
  device.answers = device.accepts = false;
  EXPECT_FALSE(device.read(1).has_value());
  EXPECT_FALSE(device.push({.force_N = {0.0, 0.0, 4.0}}, kDt_s).has_value());
  device.answers = device.accepts = true;
  const auto limited = device.push({.force_N = {0.0, 0.0, 4.0}}, kDt_s);
  ASSERT_TRUE(limited.has_value());
  EXPECT_NEAR(limited->wrench.force_N.z, 1.0, 1e-13);
}

TEST(HapticDevice, FallsToZeroForceAtOncePastTheSlewLimit) {
  ScriptedDevice device(capability(10.0), {.force_N = 5.0, .torque_N_m = 0.1, .slew_N = 1.0});
  for (int i = 0; i < 4; ++i) {
    device.push({.force_N = {0.0, 0.0, 4.0}}, kDt_s);
  }
  device.zero_force();
  EXPECT_EQ(device.last_sent.force_N, glm::dvec3(0.0));
  device.push({.force_N = {0.0, 0.0, 4.0}}, kDt_s);
  EXPECT_NEAR(device.last_sent.force_N.z, 1.0, 1e-13);
}

TEST(HapticDevice, DoesNotTouchTheHeap) {
  ScriptedDevice device(capability(10.0));
  AllocationGuard guard;
  device.read(1);
  device.push({.force_N = {9.0, 9.0, 9.0}}, kDt_s);
  device.zero_force();
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
