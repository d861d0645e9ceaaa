// What is measured of a device is what it is; what is written down of it is read again.

#include "app/device_bench/device_test.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/device_bench/device_bench.h"
#include "app/device_bench/measure_device.h"
#include "app/profiles/profile_verdict.h"
#include "app/words/coded_phrases.h"
#include "app/words/device_remarks.h"
#include "app/words/reason.h"
#include "device/simulated_device.h"
#include "device/simulated_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/support/calling_device.h"
#include "tests/support/hanging_push.h"
#include "tests/support/refusal.h"
#include "tests/support/scripted_device.h"
#include "tests/support/temporary_folder.h"

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

/// Of the plain simulated device, measured once in this process.
const DeviceProfile& plain_profile() {
  static const DeviceProfile kProfile = measured({});
  return kProfile;
}

const DeviceItem& item(const DeviceProfile& profile, const std::string& name) {
  const DeviceItem* const found = profile.item(name);
  if (found == nullptr) throw std::runtime_error("no item " + name);
  return *found;
}

/// Of a handle that nothing moves.
const DeviceCapability kStuck{.name = "stuck", .peak_force_N = 5.0};

// The hand of the simulated device: 50 g on 300 N/m with 5 N s/m along the surface and 10 across it.
TEST(DeviceTest, FindsTheMassAndTheDampingOfThePlainDevice) {
  const DeviceProfile& profile = plain_profile();
  const DeviceItem& damping = item(profile, "damping_N_s_per_m");
  ASSERT_EQ(damping.by_axis.size(), 3U) << damping.text.english();
  EXPECT_NEAR(damping.by_axis[0], 5.0, 0.5);
  EXPECT_NEAR(damping.by_axis[1], 5.0, 0.5);
  EXPECT_NEAR(damping.by_axis[2], 10.0, 1.0);
  const DeviceItem& mass = item(profile, "moving_mass_kg");
  ASSERT_EQ(mass.by_axis.size(), 3U) << mass.text.english();
  for (const double mass_kg : mass.by_axis) EXPECT_NEAR(mass_kg, 0.050, 0.005);
  EXPECT_NEAR(profile.value("latency_s").value(), 0.0, 0.3e-3);
  EXPECT_LT(profile.value("friction_N").value(), 0.01);
  EXPECT_LT(profile.value("position_resolution_m").value(), 1e-6);
  EXPECT_LT(profile.value("force_resolution_N").value(), 0.005);
  EXPECT_FALSE(profile.has_failed());
}

// In real time: nothing else can be waited for.
TEST(DeviceTest, EndsWhereACallIntoTheDriverDoesNotReturn) {
  for (const bool is_sending : {false, true}) {
    const auto hang = std::make_shared<Hang>();
    const HangEnds at_the_end(hang);
    hang->is_wanted = true;
    const auto later = [hang, ticks = std::make_shared<int>(0)] {
      if (++*ticks > 100) hang->pass();
    };
    // Never destroyed, as its user has to see to.
    static auto& left_behind = *new std::vector<std::unique_ptr<ScriptedDevice>>;
    ScriptedDevice& device =
        *left_behind.emplace_back(std::make_unique<ScriptedDevice>(DeviceCapability{
            .name = "hanging", .model = "Hanger", .serial = "7", .peak_force_N = 5.0}));
    if (is_sending) {
      device.at_send = [later](const Wrench&) { later(); };
    } else {
      device.at_read = [later](ProbeState&) { later(); };
    }
    const auto began = std::chrono::steady_clock::now();
    const std::string refusal =
        refusal_of<DriverHangs>([&] { test_device(device, DeviceTestOptions{}, {}); });
    EXPECT_LT(std::chrono::steady_clock::now() - began, 2 * DeviceBench::kLongestHang);
    EXPECT_THAT(refusal, testing::HasSubstr("the device Hanger 7 does not respond: its driver has "
                                            "not returned from " +
                                            std::string(is_sending ? "sending the force"
                                                                   : "reading the position") +
                                            " for more than a second. Switch the device off"));
  }
}

TEST(DeviceTest, HasEveryItemOnceAndPassesFunctionAndSafetyOfTheSimulatedDevice) {
  const DeviceProfile& profile = plain_profile();
  std::vector<std::string> names{};
  for (const DeviceQuantity& quantity : device_quantities()) names.emplace_back(quantity.name);
  for (const char* const name :
       {"limiter", "zero_after_stop", "zero_after_not_finite", "zero_without_heartbeat"}) {
    EXPECT_EQ(item(profile, name).status, DeviceItem::Status::pass)
        << item(profile, name).text.english();
    names.emplace_back(name);
  }
  EXPECT_EQ(profile.items.size(), names.size());
  for (const std::string& name : names) EXPECT_NE(profile.item(name), nullptr) << name;
  EXPECT_FALSE(item(profile, "lateness_p99_s").limit) << "timing is told, not judged";
  EXPECT_EQ(item(profile, "workspace_reached").status, DeviceItem::Status::not_measured);
}

/// Of a simulated model of this device, measured once in this process.
const DeviceProfile& in_place_of(const std::string& model) {
  static std::map<std::string, DeviceProfile> profiles{};
  const auto known = profiles.find(model);
  if (known != profiles.end()) return known->second;
  return profiles[model] = measured(simulated_settings("simulated:" + model).value());
}

// The numbers of its virtual hand are no delta.3's.
TEST(DeviceTest, LeavesOutOfAStandInWhatIsNotKnownOfTheRealOne) {
  std::vector<DeviceTestPart> parts{};
  DeviceTestOptions options = stepped();
  options.tell = [&parts](const DeviceTestNews& news) { parts.push_back(news.part); };
  options.limits = {{"friction_N", 0.5}};
  const DeviceProfile delta = measured(simulated_settings("simulated:delta.3").value(), options);
  for (const char* const name :
       {"position_noise_m", "friction_N", "damping_N_s_per_m", "position_resolution_m",
        "moving_mass_kg", "resonance_Hz", "stiffness_N_per_m", "force_resolution_N"}) {
    EXPECT_EQ(item(delta, name).status, DeviceItem::Status::not_measured) << name;
    EXPECT_FALSE(item(delta, name).value) << name;
    EXPECT_TRUE(item(delta, name).by_axis.empty()) << name;
    EXPECT_EQ(item(delta, name).text.english(),
              "Unknown for delta.3, which the simulated device models; measure the real device.");
  }
  EXPECT_EQ(item(delta, "friction_N").limit, 0.5) << "it is open whether it is kept";
  EXPECT_TRUE(delta.responses.empty()) << "they are its virtual hand's";
  for (const DeviceTestPart part :
       {DeviceTestPart::tones, DeviceTestPart::springs, DeviceTestPart::small_pushes}) {
    EXPECT_EQ(std::count(parts.begin(), parts.end(), part), 0);
  }
  EXPECT_NEAR(delta.value("latency_s").value(), 0.25e-3, 0.3e-3) << "it is known";
  EXPECT_FALSE(delta.has_failed());
  const DeviceProfile& falcon = in_place_of("falcon");
  EXPECT_NEAR(falcon.value("position_resolution_m").value(), 38e-6, 0.25 * 38e-6);
  EXPECT_FALSE(falcon.value("friction_N"));
}

// Emulated devices pass function and safety; their timing is only told.
TEST(DeviceTest, PassesFunctionAndSafetyOfEveryStandInAndOnlyTellsItsTiming) {
  for (const std::string& model : simulated_models()) {
    const DeviceProfile& profile = in_place_of(model);
    for (const char* const name : {"force_zero_N", "limiter", "zero_after_stop",
                                   "zero_after_not_finite", "zero_without_heartbeat"}) {
      EXPECT_EQ(item(profile, name).status, DeviceItem::Status::pass) << model << ' ' << name;
    }
    for (const char* const name : {"rate_Hz", "lateness_p99_s", "missed_deadlines"}) {
      EXPECT_TRUE(item(profile, name).is_only_told()) << model << ' ' << name;
    }
    EXPECT_FALSE(profile.has_failed()) << model;
  }
}

TEST(DeviceProfile, OfAStandInSaysWhatIsKnownAndIsReadAsItWasWritten) {
  const DeviceProfile& delta = in_place_of("delta.3");
  EXPECT_EQ(what_is_known(delta).english(),
            "Simulated model of delta.3; known: workspace, peak force, rate, latency; unknown: "
            "continuous force, position resolution, position noise, friction, damping, moving "
            "mass, resonance, stiffest spring, force resolution.");
  EXPECT_TRUE(what_is_known(plain_profile()).empty());
  const std::string text = json_text_of(delta);
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["stands_for"]["model"], "delta.3");
  EXPECT_EQ(json["stands_for"]["known"],
            nlohmann::json({"workspace", "peak_force", "rate", "latency"}));
  EXPECT_EQ(json["stands_for"]["not_known"].size(), 9U);
  const DeviceProfile stored = profile_from_json(text, "here");
  EXPECT_EQ(json_text_of(stored), text);
  EXPECT_EQ(stored.not_known, delta.not_known);
  EXPECT_TRUE(stored.is_unknown("friction_N"));
  EXPECT_FALSE(stored.is_unknown("latency_s"));
  EXPECT_FALSE(nlohmann::json::parse(json_text_of(plain_profile())).contains("stands_for"));
}

TEST(DeviceProfile, TellsOfEachItemInTheWordsOfTheTable) {
  DeviceTestOptions options = stepped();
  options.limits = {{"moving_mass_kg", 0.010}, {"damping_N_s_per_m", 1.0}};
  const DeviceProfile profile = measured({}, options);
  const auto json = nlohmann::json::parse(json_text_of(profile));
  const auto told = [&](const std::string& name) {
    for (const auto& one : json["items"]) {
      if (one["name"] == name) {
        return one["status"].get<std::string>() + ", " + one["result"].get<std::string>();
      }
    }
    return std::string("no item");
  };
  EXPECT_EQ(told("friction_N"), "pass, no limit");
  EXPECT_EQ(told("damping_N_s_per_m"), "pass, pass");
  EXPECT_EQ(told("limiter"), "pass, pass") << "it is kept or not";
  EXPECT_EQ(told("moving_mass_kg"), "fail, fail");
  EXPECT_EQ(told("workspace_reached"), "not_measured, not measured");
}

TEST(DeviceProfile, SaysWhichLimitsWereKeptAndWhichNobodyLookedAt) {
  using Status = DeviceItem::Status;
  DeviceProfile profile{.items = {{.name = "friction_N", .status = Status::pass, .value = 0.1},
                                  {.name = "latency_s"}}};
  EXPECT_EQ(verdict_on(profile).english(), "No limit applied to the device.");
  EXPECT_FALSE(profile.has_open_limit());
  const DeviceItem open{.name = "workspace_reached", .limit = 0.8};
  profile.items.push_back(open);
  EXPECT_EQ(verdict_on(profile).english(),
            "Not measured, although a limit applies: workspace_reached. Measure the device again.");
  EXPECT_TRUE(profile.has_open_limit());
  profile.items = {{.name = "limiter", .status = Status::pass}, {.name = "latency_s"}};
  EXPECT_EQ(verdict_on(profile).english(), "The device met every limit.");
  EXPECT_FALSE(profile.has_open_limit()) << "latency has none";
  profile.items.push_back(open);
  EXPECT_EQ(verdict_on(profile).english(),
            "The device met every limit that was measured. Not measured, although a limit applies: "
            "workspace_reached. Measure the device again.");
  EXPECT_EQ(verdict_on(profile, [](const std::string& item) { return '<' + item + '>'; }).english(),
            "The device met every limit that was measured. Not measured, although a limit applies: "
            "<workspace_reached>. Measure the device again.");
  profile.items.front().status = Status::fail;
  EXPECT_EQ(verdict_on(profile).english(),
            "The device did not meet every limit: limiter. Repair it and measure it again, or "
            "choose another device. Not measured, although a limit applies: workspace_reached. "
            "Measure the device again.");
}

// 50 g on 2000 N/m, 1 N s/m: √(2000 / 0.05) / 2π = 31.8 Hz, and a peak ten times as high as the mass.
TEST(DeviceTest, FindsAResonance) {
  SimulatedDeviceSettings settings{};
  settings.hand = {
      .damping_N_s_per_m = 1.0, .stiffness_N_per_m = 2000.0, .normal_damping_N_s_per_m = 1.0};
  const DeviceProfile profile = measured(settings);
  const DeviceItem& resonance = item(profile, "resonance_Hz");
  ASSERT_TRUE(resonance.value) << resonance.text.english();
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

// 0.2 kg with little damping swing for seconds on the springs that pull them and hold them, 300 N/m and 200 or 400.
TEST(DeviceTest, FindsTheDampingAndTheLatencyOfAHeavyDeviceWithLittleDamping) {
  for (const char* const sensors :
       {"", ",latency_s=0.001,position_step_m=3.8e-5,velocity_samples=8"}) {
    for (const double damping_N_s_per_m : {0.1, 0.5, 1.0}) {
      const std::string damping = std::to_string(damping_N_s_per_m);
      const std::string device = "simulated:ideal,mass_kg=0.2,damping_N_s_per_m=" + damping +
                                 ",normal_damping_N_s_per_m=" + damping + sensors;
      const SimulatedDeviceSettings settings = simulated_settings(device).value();
      const DeviceProfile profile = measured(settings);
      const auto near = [&](const char* name, double wanted, double tolerance) {
        const DeviceItem& found = item(profile, name);
        ASSERT_EQ(found.by_axis.size(), 3U) << device << ' ' << found.text.english();
        for (const double value : found.by_axis) {
          EXPECT_NEAR(value, wanted, tolerance) << device << ' ' << name;
        }
      };
      near("damping_N_s_per_m", damping_N_s_per_m, settings.sensor.latency_s > 0.0 ? 0.25 : 0.05);
      near("latency_s", settings.sensor.latency_s, 0.5e-3);
      near("moving_mass_kg", 0.2, 0.02);
      near("friction_N", 0.0, 0.02);
    }
  }
}

// 10 kg on 500 N/m and 12 N s/m: 1.7 s until a motion is a third.
TEST(DeviceTest, DoesNotMeasureWhatDoesNotComeToRest) {
  const DeviceProfile profile =
      measured(simulated_settings(
                   "simulated:ideal,mass_kg=10,damping_N_s_per_m=0.1,normal_damping_N_s_per_m=0.1")
                   .value());
  for (const char* const name : {"latency_s", "moving_mass_kg"}) {
    EXPECT_EQ(item(profile, name).status, DeviceItem::Status::not_measured) << name;
    EXPECT_THAT(item(profile, name).text.english(),
                testing::AnyOf(testing::HasSubstr("the handle kept swinging by"),
                               testing::HasSubstr("did not come to rest within 1.0 s before")))
        << name;
  }
}

TEST(DeviceTest, RecoversFrictionLatencyAndResolutionOfAnImperfectDevice) {
  const DeviceProfile profile = measured(imperfect());
  const auto near = [&](const char* name, double wanted, double tolerance) {
    const DeviceItem& found = item(profile, name);
    ASSERT_EQ(found.by_axis.size(), 3U) << found.text.english();
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
            0.5 * plain_profile().value("stiffness_N_per_m").value());
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
  ScriptedDevice device({.name = "disobedient", .peak_force_N = 5.0});
  device.at_read = [&device](ProbeState& state) {
    state.position_m.x = 0.001 * (device.reads % 2);
  };
  device.at_send = [&device](const Wrench& limited) {
    Wrench given = limited;
    given.force_N.x += 0.1;
    device.gave_only(given);
  };
  const DeviceProfile profile = test_device(device, stepped(), {});
  EXPECT_EQ(item(profile, "limiter").status, DeviceItem::Status::fail);
  EXPECT_EQ(item(profile, "force_zero_N").status, DeviceItem::Status::fail);
}

TEST(DeviceTest, SaysWhyAHandleThatDoesNotMoveIsNotMeasured) {
  ScriptedDevice device(kStuck);
  const DeviceProfile profile = test_device(device, stepped(), {});
  for (const char* const name : {"friction_N", "latency_s", "force_resolution_N"}) {
    EXPECT_EQ(item(profile, name).status, DeviceItem::Status::not_measured) << name;
    const std::string text = item(profile, name).text.english();
    EXPECT_NE(text.find("move"), std::string::npos) << text;
  }
}

TEST(DeviceTest, LeavesOutTheMechanicsOfADeviceWithoutMotors) {
  ScriptedDevice device({.name = "stuck", .actuated_degrees_of_freedom = 0});
  const DeviceProfile profile = test_device(device, stepped(), {});
  EXPECT_EQ(item(profile, "friction_N").status, DeviceItem::Status::not_measured);
  EXPECT_EQ(item(profile, "limiter").status, DeviceItem::Status::not_measured);
  EXPECT_EQ(item(profile, "rate_Hz").status, DeviceItem::Status::pass);
  EXPECT_FALSE(profile.has_failed());
}

std::string loss_of(HapticDevice& device, const DeviceTestOptions& options = stepped()) {
  return refusal_of<std::runtime_error>([&] { test_device(device, options, {}); });
}

TEST(DeviceTest, EndsWhenTheDeviceIsLostAndSaysWhyAndWhatToDo) {
  ScriptedDevice device(kStuck);
  device.at_read = [&device](ProbeState&) { device.answers = device.reads <= 3000; };
  EXPECT_EQ(loss_of(device),
            "the connection to the device was lost during the measurement: the device did not "
            "respond, and its driver reports no cause. Check its cable and its power supply, close "
            "other programs that keep this computer busy, and measure the device again.");
  ScriptedDevice unplugged(kStuck);
  unplugged.at_read = [&unplugged](ProbeState&) { unplugged.answers = unplugged.reads <= 3000; };
  unplugged.trouble_text = "The Stuck 7 is unplugged: plug it in again.";
  EXPECT_EQ(loss_of(unplugged),
            "the connection to the device was lost during the measurement: The Stuck 7 is "
            "unplugged: plug it in again. Fix the problem, then measure the device again.");
}

TEST(DeviceTest, SaysOfAFrozenPoseThatItIsFrozen) {
  ScriptedDevice device(kStuck);
  device.probe.velocity_m_per_s.x = 0.1;
  const std::string loss = loss_of(device);
  EXPECT_NE(loss.find("reports the same position repeatedly"), std::string::npos) << loss;
  EXPECT_NE(loss.find("measure the device again"), std::string::npos) << loss;
}

TEST(DeviceTest, SaysWhyADeviceWasLostThatIsWellOnceItIsStopped) {
  CallingDevice device;
  device.readings_left = 100;
  const std::string loss = loss_of(device, {.mechanics = StagePacing::stepped});
  // A busy machine may keep its thread from calling before it is lost.
  EXPECT_TRUE(loss.find("The Calling 7 is too warm. Fix the problem") != std::string::npos ||
              loss.find("made no call for 50 ms") != std::string::npos)
      << loss;
}

TEST(DeviceTest, SaysOfADeviceThatDoesNotCallThatItDoesNot) {
  CallingDevice device;
  device.is_silent = true;
  const std::string loss = loss_of(device, {.mechanics = StagePacing::stepped});
  EXPECT_NE(loss.find("made no call for 50 ms"), std::string::npos) << loss;
  EXPECT_NE(loss.find("measure the device again"), std::string::npos) << loss;
}

TEST(DeviceTest, LeavesZeroForceWhereItIsStopped) {
  VirtualHand hand(HandHabits{}, Random(1));
  SimulatedDevice device(hand, {});
  std::stop_source stop;
  DeviceTestOptions options = stepped();
  options.tell = [&](const DeviceTestNews& news) {
    if (news.part == DeviceTestPart::sweeps) stop.request_stop();
  };
  EXPECT_THROW(test_device(device, options, stop.get_token()), DeviceStageStopped);
}

TEST(DeviceTest, TellsItsPartsInOrderAndShowsEveryTick) {
  DeviceTestOptions options = stepped();
  std::vector<DeviceTestPart> parts{};
  std::vector<int> sweeps{};
  double done = 0.0;
  options.tell = [&](const DeviceTestNews& news) {
    if (parts.empty() || parts.back() != news.part) parts.push_back(news.part);
    if (news.part == DeviceTestPart::sweeps) sweeps.push_back(news.axis.value());
    EXPECT_GE(news.done, done) << news.what;
    done = news.done;
  };
  std::size_t seen = 0;
  double strongest_N = 0.0;
  options.watch = [&](std::span<const TickRecord> ticks) {
    seen += ticks.size();
    for (const TickRecord& tick : ticks) {
      strongest_N = std::max(strongest_N, glm::length(tick.sent.force_N));
    }
  };
  const DeviceProfile profile = measured({}, options);
  using Part = DeviceTestPart;
  EXPECT_EQ(parts, (std::vector<Part>{Part::timing, Part::safety, Part::sweeps, Part::pushes,
                                      Part::tones, Part::springs, Part::small_pushes}));
  EXPECT_EQ(sweeps, (std::vector<int>{0, 1, 2}));
  EXPECT_GT(seen, 60000U) << "a minute at 1 kHz at least";
  EXPECT_GT(strongest_N, 0.5);
  EXPECT_LE(strongest_N, profile.force_N);
}

// Far above its resonance a handle of 50 g answers as its mass alone: |X/F| = 1 / mω², at 200 Hz
// 1 / (0.05 · (2π · 200)²) = 12.7 µm/N.
TEST(DeviceTest, KeepsTheResponsesToTonesOfEveryAxis) {
  const DeviceProfile& profile = plain_profile();
  ASSERT_EQ(profile.responses.size(), 3U);
  EXPECT_EQ(profile.responses[2].axis, "z");
  for (const AxisResponse& response : profile.responses) {
    ASSERT_EQ(response.tones.size(), 24U);
    EXPECT_NEAR(response.tones.front().frequency_Hz, 8.0, 1e-9);
    EXPECT_NEAR(response.tones.back().frequency_Hz, 200.0, 1e-9);
    EXPECT_NEAR(response.tones.back().response_m_per_N, 12.7e-6, 0.1 * 12.7e-6);
  }
}

TEST(MeasuredDevice, HoldsADeviceToTheProtocolsLimitsUnlessToldOtherwise) {
  MeasureOrder order{};
  order.test.timing = StagePacing::stepped;
  order.test.limits = {{"moving_mass_kg", 0.1}};
  order.protocol_limits = {{"moving_mass_kg", 0.010}, {"friction_N", 0.5}, {"lateness_p99_s", 0.0}};
  VirtualHand hand = hand_to_measure();
  SimulatedDevice device(hand, {});
  const DeviceProfile profile = measure_device(device, order, {}).profile;
  EXPECT_EQ(item(profile, "moving_mass_kg").limit, 0.1);
  EXPECT_EQ(item(profile, "friction_N").limit, 0.5);
  EXPECT_EQ(item(profile, "friction_N").status, DeviceItem::Status::pass);
  EXPECT_FALSE(item(profile, "lateness_p99_s").limit)
      << "the timing of a simulated device is told and not judged";
  EXPECT_FALSE(profile.has_failed());
  EXPECT_EQ(profile_from_json(json_text_of(profile), "here").item("friction_N")->limit, 0.5);
}

TEST(MeasuredDevice, JudgesTheTimingOfAnAttachedOne) {
  ScriptedDevice device(kStuck);
  MeasureOrder order{};
  order.test.timing = StagePacing::stepped;
  order.test.mechanics = StagePacing::stepped;
  order.protocol_limits = {{"rate_Hz", 1001.0}};
  const DeviceProfile profile = measure_device(device, order, {}).profile;
  EXPECT_EQ(item(profile, "rate_Hz").limit, 1001.0);
  EXPECT_EQ(item(profile, "rate_Hz").status, DeviceItem::Status::fail);
  EXPECT_EQ(item(profile, "lateness_p99_s").limit, 0.001) << "its usual one, a period";
}

TEST(MeasuredDevice, IsKeptInTheStudyOnlyWhereItCameToItsEnd) {
  const TemporaryFolder folder{};
  MeasureOrder order{};
  order.test.timing = StagePacing::stepped;
  order.study = folder.path();
  VirtualHand hand = hand_to_measure();
  SimulatedDevice device(hand, {});
  std::stop_source stop{};
  order.test.tell = [&stop](const DeviceTestNews& news) {
    if (news.part == DeviceTestPart::small_pushes && news.axis == 2) stop.request_stop();
  };
  EXPECT_THROW(measure_device(device, order, stop.get_token()), DeviceStageStopped);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "profiles"));
  order.test.tell = {};
  const MeasuredDevice measured = measure_device(device, order, {});
  ASSERT_TRUE(measured.file);
  EXPECT_EQ(read_file(*measured.file), json_text_of(measured.profile));
}

TEST(DeviceTest, TimesARealThread) {
  DeviceTestOptions options = stepped();
  options.timing = StagePacing::real_time;
  const DeviceProfile profile = measured({}, options);
  EXPECT_GT(profile.value("rate_Hz").value(), 0.0);
  EXPECT_GE(profile.value("lateness_p99_s").value(), profile.value("lateness_p50_s").value());
  EXPECT_NE(profile.scheduling, "none");
}

TEST(DeviceTest, SaysThatALoopOf1000HzDoesNotRunOnADeviceThatAnswersAt200) {
  ScriptedDevice device({.name = "slow", .peak_force_N = 5.0});
  device.at_read = [](ProbeState&) { std::this_thread::sleep_for(std::chrono::milliseconds(5)); };
  DeviceTestOptions options{.mechanics = StagePacing::stepped};
  options.tell = [&device](const DeviceTestNews& news) {
    if (news.part != DeviceTestPart::sweeps) return;
    device.at_read = {};  // the rest is stepped, and says nothing here
    EXPECT_EQ(device.last_sent.force_N, glm::dvec3(0.0));
  };
  const DeviceProfile profile = test_device(device, options, {});
  const DeviceItem& rate = item(profile, "rate_Hz");
  EXPECT_NE(rate.status, DeviceItem::Status::pass);
  EXPECT_NE(rate.text.english().find("missed"), std::string::npos) << rate.text.english();
  EXPECT_TRUE(profile.has_failed()) << "it does not do what safety asks for at that rate";
  EXPECT_EQ(item(profile, "zero_without_heartbeat")
                .text.english()
                .find("This is required, and it did not happen: Without a heartbeat"),
            0U);
}

TEST(DeviceProfile, IsReadAsItWasWritten) {
  DeviceProfile profile = plain_profile();
  profile.reached_minimum_m = glm::dvec3(-0.1, -0.2, 0.0);
  const std::string text = json_text_of(profile);
  EXPECT_EQ(json_text_of(profile_from_json(text, "here")), text);
}

// Words of the file are English; a window says them in its own language.
TEST(DeviceProfile, SaysInAnotherLanguageWhatWasStored) {
  const auto spelt_out = [](const char*, const char* words) {
    return "<" + std::string(words) + ">";
  };
  ScriptedDevice stuck(kStuck);
  for (const DeviceProfile& profile :
       {plain_profile(), in_place_of("delta.3"), test_device(stuck, stepped(), {})}) {
    const DeviceProfile stored = profile_from_json(json_text_of(profile), "here");
    for (const DeviceItem& one : profile.items) {
      EXPECT_EQ(item(stored, one.name).text.translated(spelt_out), one.text.translated(spelt_out))
          << one.name;
      EXPECT_TRUE(one.text.can_be_translated()) << one.text.english();
    }
  }
  DeviceItem fault{.name = "latency_s", .text = phrase_of(DeviceRemark::did_not_run)};
  fault.text = fault.text.with(phrase_of(Fault::not_finite));
  EXPECT_EQ(phrase_from(json_of(fault.text)).translated(spelt_out),
            fault.text.translated(spelt_out));
}

TEST(DeviceProfile, RefusesWhatIsNoneAndNamesTheFile) {
  EXPECT_THAT(refusal_of<std::runtime_error>([] {
                profile_from_json("{\"format\": \"asperity.check/1\"}", "profiles/a.json");
              }),
              testing::HasSubstr("profiles/a.json"));
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
  const DeviceProfile later{.name = "omega",
                            .serial = "7",
                            .measured_utc = "2026-03-03T10:00:00.000Z",
                            .rate_Hz = 1000.0,
                            .items = {{.name = "of_a_later_version"}}};
  write_file(profile_path(folder.path(), later), json_text_of(later), Overwrite::refuse);
  EXPECT_TRUE(latest_profile(folder.path(), {.name = "falcon", .serial = "1"}).has_value());
  EXPECT_THROW(latest_profile(folder.path(), {.name = "omega", .serial = "7"}), std::runtime_error);
  // It may be the latest of this device.
  write_file(folder.path() / "profiles" / "broken.json", "{", Overwrite::refuse);
  const KeptProfiles kept = profiles_in(folder.path(), {.name = "falcon", .serial = "1"});
  EXPECT_EQ(kept.profiles.size(), 2U);
  ASSERT_EQ(kept.complaints.size(), 1U);
  EXPECT_NE(kept.complaints.front().find("broken.json"), std::string::npos);
  EXPECT_THROW(latest_profile(folder.path(), {.name = "falcon", .serial = "1"}),
               std::runtime_error);
}

}  // namespace
}  // namespace asperity
