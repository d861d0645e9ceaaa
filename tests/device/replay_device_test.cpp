// A recording given again: the same states at the same distances of time.

#include "device/replay_device.h"

#include <filesystem>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "tests/device/ticks.h"
#include "tests/support/allocation_guard.h"

namespace asperity {
namespace {

std::vector<ProbeState> three_states() {
  std::vector<ProbeState> states(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto step = static_cast<double>(i);
    states[i].time_ns = (100 + 2 * static_cast<std::int64_t>(i)) * kMillisecond_ns;
    states[i].position_m = {0.001 * step, -0.002 * step, 0.1};
    states[i].velocity_m_per_s = {0.5, -1.0, 0.0};
    states[i].buttons = i == 1 ? 4 : 0;
  }
  return states;
}

TEST(ReplayDevice, GivesEachStateWhenItIsDue) {
  const std::vector<ProbeState> states = three_states();
  ReplayDevice device(states);
  const std::int64_t began_ns = 77 * kMillisecond_ns;
  for (const auto& [after_ms, index] : {std::pair{0, 0U}, {1, 0U}, {2, 1U}, {3, 1U}, {4, 2U}}) {
    const ProbeState state = device.read(began_ns + after_ms * kMillisecond_ns).value();
    EXPECT_EQ(state.time_ns, began_ns + after_ms * kMillisecond_ns);
    EXPECT_EQ(state.position_m, states[index].position_m) << after_ms;
    EXPECT_EQ(state.velocity_m_per_s, states[index].velocity_m_per_s);
    EXPECT_EQ(state.buttons, states[index].buttons);
    EXPECT_EQ(device.is_over(), index == 2U);
  }
}

TEST(ReplayDevice, SkipsWhatASlowReaderMisses) {
  ReplayDevice device(three_states());
  device.read(0);
  EXPECT_EQ(device.read(4 * kMillisecond_ns)->position_m, three_states()[2].position_m);
}

TEST(ReplayDevice, RestsAfterTheEnd) {
  ReplayDevice device(three_states());
  device.read(0);
  device.read(4 * kMillisecond_ns);
  const ProbeState state = device.read(5 * kMillisecond_ns).value();
  EXPECT_EQ(state.position_m, three_states()[2].position_m);
  EXPECT_EQ(state.velocity_m_per_s, glm::dvec3(0.0));
}

TEST(ReplayDevice, IsLostAfterTheEndWhereThatWasAskedFor) {
  ReplayDevice device(three_states(), ReplayEnd::lost);
  device.read(0);
  EXPECT_TRUE(device.read(4 * kMillisecond_ns).has_value());
  EXPECT_TRUE(device.push({}, 1e-3).has_value());
  EXPECT_FALSE(device.read(4 * kMillisecond_ns + 1).has_value());
  EXPECT_FALSE(device.push({}, 1e-3).has_value());
}

TEST(ReplayDevice, DescribesWhatWasRecordedAndHasNoMotors) {
  ReplayDevice device(three_states());
  EXPECT_EQ(device.capability().actuated_degrees_of_freedom, 0);
  EXPECT_EQ(device.capability().workspace_minimum_m, glm::dvec3(0.0, -0.004, 0.1));
  EXPECT_EQ(device.capability().workspace_maximum_m, glm::dvec3(0.002, 0.0, 0.1));
  EXPECT_EQ(device.capability().buttons, 3);
  EXPECT_TRUE(device.push({.force_N = {0.0, 0.0, 1.0}}, 1e-3).has_value());
}

TEST(ReplayDevice, BeginsAnewWithEachAttempt) {
  ReplayDevice device(three_states());
  const ProbeState first = device.read(0).value();
  const ProbeState last = device.read(1000 * kMillisecond_ns).value();
  ASSERT_NE(last.position_m, first.position_m);
  device.begin_attempt();
  EXPECT_EQ(device.read(2000 * kMillisecond_ns)->position_m, first.position_m);
  EXPECT_FALSE(device.is_over());
  EXPECT_EQ(device.read(3000 * kMillisecond_ns)->position_m, last.position_m);
}

TEST(ReplayDriver, NeedsARecordingAndSomebodyWhoReadsIt) {
  const DriverRegistry drivers = built_in_drivers();
  EXPECT_NE(drivers.find("replay")->find({}).blocker.find("replay:FILE"), std::string::npos);
  EXPECT_THROW(drivers.open("replay", {}), std::runtime_error);
  EXPECT_THROW(drivers.open("replay:some.rec", {}), std::runtime_error);
  std::filesystem::path asked{};
  const DriverOptions options{.recorded_hand = [&asked](const std::filesystem::path& file) {
    asked = file;
    return three_states();
  }};
  const auto device = drivers.open("replay:my study/a:b.rec", options);
  EXPECT_EQ(asked, "my study/a:b.rec");
  EXPECT_EQ(device->capability().name, "replay");
  EXPECT_NE(device->capability().remarks.find("my study/a:b.rec"), std::string::npos);
}

TEST(ReplayDevice, RefusesWhatIsNoRecording) {
  EXPECT_THROW(ReplayDevice({}), std::invalid_argument);
  std::vector<ProbeState> states = three_states();
  states[2].time_ns = states[1].time_ns;
  EXPECT_THROW(ReplayDevice{states}, std::invalid_argument);
}

TEST(ReplayDevice, DoesNotTouchTheHeap) {
  ReplayDevice device(three_states());
  AllocationGuard guard;
  for (int i = 0; i < 10; ++i) device.read(i * kMillisecond_ns);
  EXPECT_EQ(guard.count(), 0);
}

}  // namespace
}  // namespace asperity
