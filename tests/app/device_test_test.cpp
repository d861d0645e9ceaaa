// What is measured of a device is what it is; what is written down of it is read again.

#include "app/tasks/device_test.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "device/simulated_device.h"
#include "results_schema/atomic_file.h"
#include "tests/app/small_study.h"

namespace asperity {
namespace {

DeviceTestOptions stepped() {
  return {.is_simulated = true, .mechanics = StagePacing::stepped, .timing = StagePacing::stepped};
}

DeviceProfile measured(const SimulatedDeviceSettings& settings,
                       const DeviceTestOptions& options = stepped()) {
  VirtualHand hand(HandHabits{}, Random(1));
  SimulatedDevice device(hand, settings);
  return test_device(device, options, {});
}

const DeviceItem& item(const DeviceProfile& profile, const std::string& name) {
  const DeviceItem* const found = profile.item(name);
  if (found == nullptr) throw std::runtime_error("no item " + name);
  return *found;
}

/// Motors that give one force in another's place, or never let go: what safety is there to see.
class DisobedientDevice final : public HapticDevice {
 public:
  DisobedientDevice() : HapticDevice({.name = "disobedient", .peak_force_N = 5.0}, ForceLimits{}) {}
  ~DisobedientDevice() override { zero_force(); }

 private:
  bool do_read(std::int64_t, ProbeState& state) noexcept override {
    state.position_m.x = 0.001 * static_cast<double>(++reads_ % 2);
    return true;
  }
  bool do_send(const Wrench& limited) noexcept override {
    Wrench given = limited;
    given.force_N.x += 0.1;
    gave_only(given);
    return true;
  }
  int reads_ = 0;
};

/// A handle that nothing moves.
class StuckDevice final : public HapticDevice {
 public:
  explicit StuckDevice(int motors = 3)
      : HapticDevice({.name = "stuck",
                      .actuated_degrees_of_freedom = motors,
                      .peak_force_N = motors > 0 ? 5.0 : 0.0},
                     ForceLimits{}) {}
  ~StuckDevice() override { zero_force(); }
  int reads_until_lost = -1;

 private:
  bool do_read(std::int64_t, ProbeState&) noexcept override { return reads_until_lost-- != 0; }
  bool do_send(const Wrench&) noexcept override { return true; }
};

// The hand of the simulated device: 50 g on 300 N/m with 5 N·s/m along the surface and 10 across it.
TEST(DeviceTest, FindsTheMassAndTheDampingOfThePlainDevice) {
  const DeviceProfile profile = measured({});
  const DeviceItem& damping = item(profile, "damping_N_s_per_m");
  ASSERT_EQ(damping.by_axis.size(), 3U) << damping.text;
  EXPECT_NEAR(damping.by_axis[0], 5.0, 0.5);
  EXPECT_NEAR(damping.by_axis[1], 5.0, 0.5);
  EXPECT_NEAR(damping.by_axis[2], 10.0, 1.0);
  const DeviceItem& mass = item(profile, "moving_mass_kg");
  ASSERT_EQ(mass.by_axis.size(), 3U) << mass.text;
  for (const double mass_kg : mass.by_axis) EXPECT_NEAR(mass_kg, 0.050, 0.005);
  EXPECT_NEAR(profile.value("latency_s").value(), 0.0, 0.3e-3);
  EXPECT_LT(profile.value("friction_N").value(), 0.01);
  EXPECT_LT(profile.value("position_resolution_m").value(), 1e-6);
  EXPECT_LT(profile.value("force_resolution_N").value(), 0.005);
  EXPECT_FALSE(profile.has_failed());
}

TEST(DeviceTest, HasEveryItemOnceAndPassesFunctionAndSafetyOfTheSimulatedDevice) {
  const DeviceProfile profile = measured({});
  std::vector<std::string> names = names_of_limits();
  for (const char* const name :
       {"limiter", "zero_after_stop", "zero_after_not_finite", "zero_without_heartbeat"}) {
    EXPECT_EQ(item(profile, name).status, DeviceItem::Status::pass) << item(profile, name).text;
    names.emplace_back(name);
  }
  EXPECT_EQ(profile.items.size(), names.size());
  for (const std::string& name : names) EXPECT_NE(profile.item(name), nullptr) << name;
  EXPECT_FALSE(item(profile, "lateness_p99_s").limit) << "timing is told, not judged";
  EXPECT_EQ(item(profile, "workspace_reached").status, DeviceItem::Status::not_measured);
}

// 50 g on 2000 N/m, 1 N·s/m: √(2000 / 0.05) / 2π = 31.8 Hz, and a peak ten times as high as the mass.
TEST(DeviceTest, FindsAResonance) {
  SimulatedDeviceSettings settings{};
  settings.hand = {
      .damping_N_s_per_m = 1.0, .stiffness_N_per_m = 2000.0, .normal_damping_N_s_per_m = 1.0};
  const DeviceProfile profile = measured(settings);
  const DeviceItem& resonance = item(profile, "resonance_Hz");
  ASSERT_TRUE(resonance.value) << resonance.text;
  EXPECT_NEAR(*resonance.value, 31.8, 3.0);
}

/// What a measurement has to find again of a device that is late, coarse, noisy and stiff to move at once.
SimulatedDeviceSettings imperfect() {
  SimulatedDeviceSettings settings{};
  settings.friction_N = 0.3;
  settings.sensor = {.latency_s = 0.003,
                     .position_noise_m = 10e-6,
                     .position_step_m = 60e-6,
                     .velocity = VelocityWindow{8},
                     .noise_seed = 3};
  return settings;
}

TEST(DeviceTest, RecoversFrictionLatencyAndResolutionOfAnImperfectDevice) {
  const DeviceProfile profile = measured(imperfect());
  const auto near = [&](const char* name, double wanted, double tolerance) {
    const DeviceItem& found = item(profile, name);
    ASSERT_EQ(found.by_axis.size(), 3U) << found.text;
    for (const double value : found.by_axis) EXPECT_NEAR(value, wanted, tolerance) << name;
  };
  near("friction_N", 0.3, 0.15 * 0.3);
  near("latency_s", 0.003, 0.4e-3);
  // A step of 60 µm and a noise of 10 µm have the deviation of a step of √(60² + 12 · 10²) = 69 µm.
  near("position_resolution_m", 69e-6, 0.25 * 69e-6);
  near("moving_mass_kg", 0.050, 0.15 * 0.050);
  const DeviceItem& damping = item(profile, "damping_N_s_per_m");
  ASSERT_EQ(damping.by_axis.size(), 3U);
  EXPECT_NEAR(damping.by_axis[0], 5.0, 1.5);
  EXPECT_NEAR(damping.by_axis[2], 10.0, 2.5);
  // At rest nothing below the friction moves it.
  const double weakest_N = profile.value("force_resolution_N").value();
  EXPECT_GE(weakest_N, 0.3);
  EXPECT_LE(weakest_N, 0.6);
}

// A delay makes a stiff spring swing: without one the same hand holds 8000 N/m.
TEST(DeviceTest, FindsThatALateDeviceHoldsLessStiffness) {
  SimulatedDeviceSettings late{};
  late.sensor.latency_s = 0.003;
  EXPECT_LT(measured(late).value("stiffness_N_per_m").value(),
            0.5 * measured({}).value("stiffness_N_per_m").value());
}

TEST(DeviceTest, SaysWhenMotorsAreTooWeakForTheFriction) {
  SimulatedDeviceSettings weak{};
  weak.friction_N = 1.0;
  weak.saturation_force_N = 0.8;
  const DeviceProfile profile = measured(weak);
  EXPECT_EQ(item(profile, "friction_N").status, DeviceItem::Status::not_measured);
  EXPECT_EQ(item(profile, "force_resolution_N").status, DeviceItem::Status::not_measured);
}

TEST(DeviceTest, FailsAnItemThatDoesNotKeepItsLimit) {
  DeviceTestOptions options = stepped();
  options.limits = {{"moving_mass_kg", 0.010}, {"stiffness_N_per_m", 300.0}};
  const DeviceProfile profile = measured({}, options);
  EXPECT_EQ(item(profile, "moving_mass_kg").status, DeviceItem::Status::fail);
  EXPECT_EQ(item(profile, "stiffness_N_per_m").status, DeviceItem::Status::pass);
  EXPECT_TRUE(profile.has_failed());
}

TEST(DeviceTest, RefusesALimitOnWhatIsNoItem) {
  DeviceTestOptions options = stepped();
  options.limits = {{"fricton_N", 0.1}};
  EXPECT_THROW(measured({}, options), std::invalid_argument);
}

TEST(DeviceTest, SeesMotorsThatDoNotObey) {
  DisobedientDevice device;
  const DeviceProfile profile = test_device(device, stepped(), {});
  EXPECT_EQ(item(profile, "limiter").status, DeviceItem::Status::fail);
  EXPECT_EQ(item(profile, "force_zero_N").status, DeviceItem::Status::fail);
}

TEST(DeviceTest, SaysWhyAHandleThatDoesNotMoveIsNotMeasured) {
  StuckDevice device;
  const DeviceProfile profile = test_device(device, stepped(), {});
  for (const char* const name : {"friction_N", "latency_s", "force_resolution_N"}) {
    EXPECT_EQ(item(profile, name).status, DeviceItem::Status::not_measured) << name;
    EXPECT_NE(item(profile, name).text.find("move"), std::string::npos) << item(profile, name).text;
  }
}

TEST(DeviceTest, LeavesOutTheMechanicsOfADeviceWithoutMotors) {
  StuckDevice device(0);
  const DeviceProfile profile = test_device(device, stepped(), {});
  EXPECT_EQ(item(profile, "friction_N").status, DeviceItem::Status::not_measured);
  EXPECT_EQ(item(profile, "limiter").status, DeviceItem::Status::not_measured);
  EXPECT_EQ(item(profile, "rate_Hz").status, DeviceItem::Status::pass);
  EXPECT_FALSE(profile.has_failed());
}

TEST(DeviceTest, EndsWhenTheDeviceIsLost) {
  StuckDevice device;
  device.reads_until_lost = 3000;
  EXPECT_THROW(test_device(device, stepped(), {}), std::runtime_error);
}

TEST(DeviceTest, LeavesZeroForceWhereItIsStopped) {
  VirtualHand hand(HandHabits{}, Random(1));
  SimulatedDevice device(hand, {});
  std::stop_source stop;
  DeviceTestOptions options = stepped();
  options.tell = [&](const std::string& what, double) {
    if (what.find("sweeps") != std::string::npos) stop.request_stop();
  };
  EXPECT_THROW(test_device(device, options, stop.get_token()), DeviceStageStopped);
}

TEST(DeviceTest, TimesARealThread) {
  DeviceTestOptions options = stepped();
  options.timing = StagePacing::real_time;
  const DeviceProfile profile = measured({}, options);
  EXPECT_GT(profile.value("rate_Hz").value(), 0.0);
  EXPECT_GE(profile.value("lateness_p99_s").value(), profile.value("lateness_p50_s").value());
  EXPECT_NE(profile.scheduling, "none");
}

TEST(DeviceProfile, IsReadAsItWasWritten) {
  DeviceProfile profile = measured({});
  profile.reached_minimum_m = glm::dvec3(-0.1, -0.2, 0.0);
  const std::string text = json_text_of(profile);
  EXPECT_EQ(json_text_of(profile_from_json(text, "here")), text);
}

TEST(DeviceProfile, RefusesWhatIsNoneAndNamesTheFile) {
  try {
    profile_from_json("{\"format\": \"asperity.check/1\"}", "profiles/a.json");
    FAIL() << "it was read";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("profiles/a.json"), std::string::npos);
  }
}

TEST(DeviceProfile, IsFoundAgainInItsStudyTheLatestOfTheSameDevice) {
  const TemporaryFolder folder{};
  std::filesystem::create_directories(folder.path() / "profiles");
  const auto keep = [&](const std::string& serial, const std::string& utc, double rate_Hz) {
    const DeviceProfile profile{
        .name = "falcon", .serial = serial, .measured_utc = utc, .rate_Hz = rate_Hz};
    write_file(profile_path(folder.path(), profile), json_text_of(profile), Overwrite::refuse);
  };
  keep("1", "2026-03-01T10:00:00.000Z", 1.0);
  keep("1", "2026-03-02T09:00:00.000Z", 2.0);
  keep("2", "2026-03-05T10:00:00.000Z", 3.0);
  const auto found = latest_profile(folder.path(), {.name = "falcon", .serial = "1"});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->rate_Hz, 2.0);
  EXPECT_NEAR(age_days(*found, "2026-04-01T09:00:00.000Z"), 30.0, 1e-9);
  EXPECT_FALSE(latest_profile(folder.path(), {.name = "delta"}).has_value());
}

}  // namespace
}  // namespace asperity
