// The list of drivers: names, and which of the attached devices is meant.

#include "device/drivers.h"

#include <algorithm>
#include <atomic>
#include <semaphore>
#include <stdexcept>
#include <stop_token>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "device/falcon/falcon_device.h"
#include "device/openhaptics/openhaptics_device.h"
#include "device/simulated_models.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Drivers, OpenTheSimulatedDeviceInTheHandThatIsGiven) {
  VirtualHand hand(HandHabits{}, Random(1));
  const DriverRegistry drivers = built_in_drivers();
  const auto device = drivers.open("simulated", {.hand = &hand});
  EXPECT_EQ(device->capability().name, "simulated");
  EXPECT_TRUE(device->read(0).has_value());
}

TEST(Drivers, OpenTheSimulatedDeviceInPlaceOfARealOne) {
  VirtualHand hand(HandHabits{}, Random(1));
  const DriverRegistry drivers = built_in_drivers();
  const auto falcon = drivers.open("simulated:falcon", {.hand = &hand});
  EXPECT_EQ(falcon->capability().name, "simulated");
  EXPECT_EQ(falcon->capability().model, "in place of Novint Falcon");
  EXPECT_EQ(falcon->capability().peak_force_N, falcon_capability().peak_force_N);
  EXPECT_EQ(falcon->capability().position_resolution_m, falcon_capability().position_resolution_m);
  EXPECT_EQ(falcon->capability().maximum_rate_Hz, 1000.0);
  EXPECT_THAT(
      falcon->capability().remarks,
      HasSubstr("Properties of the real device that are unknown to this program: continuous"));
  const auto delta = drivers.open("simulated:delta.3", {.hand = &hand});
  EXPECT_EQ(delta->capability().peak_force_N, 20.0);
  EXPECT_EQ(delta->capability().workspace_maximum_m, glm::dvec3(0.15));
  EXPECT_EQ(delta->limits().force_N, ForceLimits{}.force_N);
  EXPECT_THAT(refusal_of([&] { drivers.open("simulated:gamma.3", {.hand = &hand}); }),
              HasSubstr("has no model \"gamma.3\"; choose one of: falcon, delta.3"));
}

TEST(SimulatedModels, HaveAHandThatStaysInTheirWorkspace) {
  for (const std::string& model : simulated_models()) {
    const SimulatedDeviceSettings settings = simulated_settings("simulated:" + model).value();
    VirtualHand hand(HandHabits{}, Random(2));
    SimulatedDevice device(hand, settings);
    hand.stroke();
    const DeviceCapability& can = device.capability();
    for (int tick = 0; tick < 3000; ++tick) {
      const ProbeState probe = device.read(1'000'000LL * tick).value();
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_GE(probe.position_m[axis], can.workspace_minimum_m[axis]) << model;
        ASSERT_LE(probe.position_m[axis], can.workspace_maximum_m[axis]) << model;
      }
      device.push({.force_N = {0.0, 0.0, 500.0 * std::max(0.0, -probe.position_m.z)}}, 1e-3);
    }
  }
}

// What nobody tells of a real one is that of no real one, whatever the virtual hand has.
TEST(SimulatedModels, DeclareOfEachTraitWhetherItIsKnown) {
  const auto is_known = [](const std::string& model, DeviceTrait trait) {
    const auto missing = simulated_settings("simulated:" + model).value().stands_for->not_known;
    return std::find(missing.begin(), missing.end(), trait) == missing.end();
  };
  for (const std::string& model : simulated_models()) {
    EXPECT_TRUE(is_known(model, DeviceTrait::latency)) << model;
    for (const DeviceTrait trait :
         {DeviceTrait::position_noise, DeviceTrait::damping, DeviceTrait::resonance,
          DeviceTrait::stiffness, DeviceTrait::force_resolution}) {
      EXPECT_FALSE(is_known(model, trait)) << model << ' ' << name_of(trait);
    }
    for (const DeviceTrait trait : {DeviceTrait::friction, DeviceTrait::moving_mass}) {
      EXPECT_EQ(is_known(model, trait), model == "touch") << model << ' ' << name_of(trait);
    }
    const DeviceCapability real = simulated_settings("simulated:" + model)->stands_for.value();
    EXPECT_EQ(is_known(model, DeviceTrait::position_step), real.position_resolution_m > 0.0)
        << model;
    EXPECT_EQ(is_known(model, DeviceTrait::continuous_force), real.continuous_force_N > 0.0)
        << model;
    EXPECT_EQ(not_known_of(real.model), real.not_known) << model;
    EXPECT_EQ("in place of " + std::string(model_stood_for(real.model)), real.model);
  }
  EXPECT_TRUE(is_known("delta.3", DeviceTrait::workspace));
  EXPECT_FALSE(is_known("lambda.7", DeviceTrait::workspace)) << "it has those of sigma.7";
  EXPECT_FALSE(is_known("lambda.7", DeviceTrait::peak_force));
  VirtualHand hand(HandHabits{}, Random(1));
  const SimulatedDevice plain(hand, {});
  EXPECT_TRUE(plain.capability().not_known.empty()) << "ideal by its own declaration";
  EXPECT_TRUE(not_known_of(plain.capability().model).empty());
  EXPECT_TRUE(not_known_of("delta.3").empty()) << "the real one";
  EXPECT_EQ(model_stood_for("in place of delta.3"), "delta.3");
  EXPECT_EQ(model_stood_for("delta.3"), "") << "it stands for none";
}

TEST(SimulatedModels, AreNamedAfterTheSimulatedDeviceOnly) {
  EXPECT_TRUE(simulated_settings("simulated").has_value());
  EXPECT_FALSE(simulated_settings("simulated").value().stands_for.has_value());
  EXPECT_FALSE(simulated_settings("simulated2").has_value());
  EXPECT_FALSE(simulated_settings("falcon").has_value());
  EXPECT_THROW(simulated_settings("simulated:"), std::runtime_error);
}

// [3D Systems]: 160 × 120 × 70 mm (width, height, depth), 3.3 N, 0.88 N continuous, 450 dpi, 0.26 N, 45 g.
TEST(SimulatedModels, IncludeATouchWithTheFiguresOfItsMaker) {
  const SimulatedDeviceSettings touch = simulated_settings("simulated:touch").value();
  VirtualHand hand(HandHabits{}, Random(1));
  const DeviceCapability capability = SimulatedDevice(hand, touch).capability();
  EXPECT_EQ(capability.model, "in place of Touch");
  const glm::dvec3 size_m = capability.workspace_maximum_m - capability.workspace_minimum_m;
  EXPECT_EQ(size_m, glm::dvec3(0.160, 0.070, 0.120)) << "y points away from the participant";
  EXPECT_EQ(capability.peak_force_N, 3.3);
  EXPECT_EQ(capability.continuous_force_N, 0.88);
  EXPECT_NEAR(capability.position_resolution_m, 0.0254 / 450.0, 2e-6);
  EXPECT_EQ(touch.sensor.position_step_m, capability.position_resolution_m);
  EXPECT_EQ(touch.friction_N, 0.26);
  EXPECT_EQ(touch.hand.mass_kg, 0.045);
  EXPECT_EQ(touch.sensor.velocity.value().samples, openhaptics_driver().velocity.value().samples);
  EXPECT_THAT(capability.not_known,
              ElementsAre(DeviceTrait::position_noise, DeviceTrait::damping, DeviceTrait::resonance,
                          DeviceTrait::stiffness, DeviceTrait::force_resolution));
  EXPECT_EQ(simulated_settings("simulated:touch,friction_N=0.1")->friction_N, 0.1);
}

TEST(SimulatedModels, TakeThePropertiesOfARealArm) {
  const SimulatedDeviceSettings plain = simulated_settings("simulated:falcon").value();
  const SimulatedDeviceSettings arm =
      simulated_settings(
          "simulated:falcon,mass_kg=0.2,damping_N_s_per_m=0.5,normal_damping_N_s_per_m=2,"
          "stiffness_N_per_m=150,friction_N=0.3,latency_s=0.002,position_step_m=1e-5,"
          "position_noise_m=2e-6,velocity_samples=5")
          .value();
  EXPECT_EQ(arm.hand.mass_kg, 0.2);
  EXPECT_EQ(arm.hand.damping_N_s_per_m, 0.5);
  EXPECT_EQ(arm.hand.normal_damping_N_s_per_m, 2.0);
  EXPECT_EQ(arm.hand.stiffness_N_per_m, 150.0);
  EXPECT_EQ(arm.friction_N, 0.3);
  EXPECT_EQ(arm.sensor.latency_s, 0.002);
  EXPECT_EQ(arm.sensor.position_step_m, 1e-5);
  EXPECT_EQ(arm.sensor.position_noise_m, 2e-6);
  EXPECT_EQ(arm.sensor.velocity.value().samples, 5);
  EXPECT_EQ(arm.peak_force_N, plain.peak_force_N);
  const auto knows = [](const SimulatedDeviceSettings& settings, DeviceTrait trait) {
    const std::vector<DeviceTrait>& missing = settings.stands_for->not_known;
    return std::find(missing.begin(), missing.end(), trait) == missing.end();
  };
  EXPECT_FALSE(knows(plain, DeviceTrait::damping));
  EXPECT_TRUE(knows(arm, DeviceTrait::damping));
  EXPECT_FALSE(knows(arm, DeviceTrait::resonance));
  // A session stores the capability.
  VirtualHand hand(HandHabits{}, Random(1));
  const auto device =
      built_in_drivers().open("simulated:falcon,mass_kg=0.2", {.hand = &hand})->capability();
  EXPECT_EQ(device.model, "in place of Novint Falcon with mass_kg=0.2");
  EXPECT_THAT(device.remarks, HasSubstr("Given for this simulation: mass_kg=0.2."));
  EXPECT_FALSE(simulated_settings("simulated:delta.3,velocity_samples=0")->sensor.velocity);
}

// A profile and a session name a device by its model only.
TEST(SimulatedModels, AreFoundWithTheirPropertiesByTheModelOfTheirCapability) {
  const auto capability = [](const std::string& device) {
    VirtualHand hand(HandHabits{}, Random(1));
    return SimulatedDevice(hand, simulated_settings(device).value()).capability();
  };
  const DeviceCapability falcon = capability("simulated:falcon");
  const DeviceCapability given = capability("simulated:falcon,velocity_samples=0,mass_kg=0.20");
  EXPECT_NE(given.model, falcon.model) << "a profile of one is none of the other";
  EXPECT_EQ(given.model, capability("simulated:falcon,mass_kg=0.2,velocity_samples=0").model);
  EXPECT_EQ(properties_given_in(given), "mass_kg=0.2,velocity_samples=0");
  EXPECT_EQ(properties_given_in(falcon), "");
  EXPECT_EQ(model_stood_for(given.model), "Novint Falcon");
  EXPECT_EQ(not_known_of(given.model), given.not_known);
  EXPECT_EQ(not_known_of(given.model).size() + 1, falcon.not_known.size());
  EXPECT_TRUE(velocity_window_of("simulated", falcon.model));
  EXPECT_FALSE(velocity_window_of("simulated", given.model));
  EXPECT_EQ(settings_of_model(given.model)->hand.mass_kg, 0.2);
  const DeviceCapability ideal = capability("simulated:ideal,velocity_samples=5");
  EXPECT_EQ(velocity_window_of("simulated", ideal.model)->samples, 5);
  EXPECT_FALSE(velocity_window_of("simulated", capability("simulated").model));
  EXPECT_FALSE(settings_of_model("Novint Falcon")) << "the real one";
  EXPECT_FALSE(settings_of_model("in place of Novint Falcon with colour=1"));
}

TEST(SimulatedModels, IncludeTheIdealOneWithPropertiesOfAnArm) {
  const SimulatedDeviceSettings arm = simulated_settings("simulated:ideal,mass_kg=0.2").value();
  EXPECT_EQ(arm.hand.mass_kg, 0.2);
  EXPECT_FALSE(arm.sensor.velocity);
  VirtualHand hand(HandHabits{}, Random(1));
  const DeviceCapability ideal = SimulatedDevice(hand, {}).capability();
  const DeviceCapability capability = SimulatedDevice(hand, arm).capability();
  EXPECT_EQ(capability.model, ideal.model + " with mass_kg=0.2");
  EXPECT_EQ(capability.maximum_rate_Hz, ideal.maximum_rate_Hz);
  EXPECT_TRUE(capability.not_known.empty());
}

TEST(SimulatedModels, RefusePropertiesThatTheyDoNotHave) {
  const auto refusal = [](const char* name) {
    return refusal_of([name] { (void)simulated_settings(name); });
  };
  EXPECT_THAT(refusal("simulated:falcon,colour=1"),
              HasSubstr("has no property \"colour\"; choose one of"));
  EXPECT_THAT(refusal("simulated:falcon,mass_kg"), HasSubstr("must be a number"));
  EXPECT_THAT(refusal("simulated:falcon,mass_kg=heavy"), HasSubstr("is \"heavy\"; it must be"));
  EXPECT_THAT(refusal("simulated:falcon,"),
              HasSubstr("a comma after the model of the simulated device has no property after it; "
                        "remove the comma, or add one of: mass_kg"));
  EXPECT_THAT(refusal("simulated:falcon,mass_kg=0.2,"), HasSubstr("a comma after \"mass_kg=0.2\""));
  EXPECT_THAT(refusal("simulated:falcon,,mass_kg=0.2"), HasSubstr("a comma after the model"));
  EXPECT_THAT(refusal("simulated:falcon,mass_kg=0.2,mass_kg=0.3"),
              HasSubstr("mass_kg of the simulated device is given twice; give it once"));
  EXPECT_THAT(refusal("simulated:delta.3,velocity_samples=2.5"), HasSubstr("from 2 to 64"));
  EXPECT_THAT(refusal("simulated:falcon,mass_kg=0"), HasSubstr("mass_kg"));
  EXPECT_THAT(refusal("simulated:falcon,latency_s=1"), HasSubstr("latency_s"));
}

// What is said before one is opened has to be so once it is.
TEST(Drivers, KnowWhetherTheirDevicesHaveMotors) {
  VirtualHand hand(HandHabits{}, Random(1));
  LatestValue<PointerSample> pointer{};
  const DriverOptions options{
      .hand = &hand,
      .recorded_hand =
          [](const std::filesystem::path&) {
            return std::vector<ProbeState>{{.time_ns = 0}, {.time_ns = 1'000'000}};
          },
      .pointer = &pointer};
  const DriverRegistry drivers = built_in_drivers();
  for (const char* name : {"simulated", "mouse", "replay:some.ahr"}) {
    const auto device = drivers.open(name, options);
    EXPECT_EQ(drivers.find(device->capability().name)->has_motors,
              device->capability().actuated_degrees_of_freedom > 0)
        << name;
  }
}

TEST(Drivers, FindTheSimulatedDeviceEverywhere) {
  const DriverRegistry drivers = built_in_drivers();
  const DriverSurvey survey = drivers.drivers().front().find({});
  ASSERT_EQ(survey.attached.size(), 1U);
  EXPECT_TRUE(survey.attached.front().is_usable());
}

TEST(Drivers, NameAllWhenOneIsAskedForThatThereIsNot) {
  const DriverRegistry drivers = built_in_drivers();
  EXPECT_THAT(refusal_of([&] { drivers.open("falkon:17", {}); }),
              HasSubstr("there is no device \"falkon\"; choose one of: simulated"));
}

TEST(Drivers, RefuseIdsThatAreTakenOrCannotBeTyped) {
  DriverRegistry drivers;
  drivers.add({.id = "one_2"});
  EXPECT_THROW(drivers.add({.id = "one_2"}), std::invalid_argument);
  for (const char* id : {"", "2one", "One", "one two", "one:2"}) {
    EXPECT_THROW(drivers.add({.id = id}), std::invalid_argument) << id;
  }
}

TEST(Drivers, HandTheSerialNumberOn) {
  std::string asked = "nothing";
  DriverRegistry drivers;
  drivers.add({.id = "one", .open = [&](const std::string& which, const DriverOptions&) {
                 asked = which;
                 return std::unique_ptr<HapticDevice>();
               }});
  drivers.open("one:usb 1-2:7", {});
  EXPECT_EQ(asked, "usb 1-2:7");
  drivers.open("one", {});
  EXPECT_EQ(asked, "");
}

// A look would find a device that is being opened free, or close what it has opened only to ask its name.
TEST(Drivers, AreAskedOneThingAtATimeWhicheverRegistryAsks) {
  constexpr int kTurns = 10'000;
  std::atomic<bool> is_opening{false};
  std::atomic<bool> was_opening{false};
  std::atomic<bool> has_looked{false};
  std::binary_semaphore has_begun{0};
  std::binary_semaphore may_end{0};
  const Driver driver{.id = "one",
                      .find =
                          [&](const DriverOptions&) {
                            was_opening = is_opening.load();
                            return DriverSurvey{};
                          },
                      .open =
                          [&](const std::string&, const DriverOptions&) {
                            is_opening = true;
                            has_begun.release();
                            may_end.acquire();
                            is_opening = false;
                            return std::unique_ptr<HapticDevice>();
                          }};
  DriverRegistry opens;
  opens.add(driver);
  DriverRegistry looks;
  looks.add(driver);
  std::thread opening([&] { opens.open("one", {}); });
  has_begun.acquire();
  std::thread looking([&] {
    looks.survey(looks.drivers().front(), {});
    has_looked = true;
  });
  for (int turn = 0; turn < kTurns && !has_looked; ++turn) std::this_thread::yield();
  EXPECT_FALSE(has_looked);
  may_end.release();
  opening.join();
  looking.join();
  EXPECT_TRUE(has_looked);
  EXPECT_FALSE(was_opening);
}

TEST(Drivers, AreOpenedNoMoreWhereSomebodyStopsWhileAnotherLooks) {
  std::stop_source stop;
  bool is_opened = false;
  DriverRegistry opens;
  opens.add({.id = "one", .open = [&](const std::string&, const DriverOptions&) {
               is_opened = true;
               return std::unique_ptr<HapticDevice>();
             }});
  DriverRegistry looks;
  looks.add({.id = "other", .find = [&](const DriverOptions&) {
               std::jthread opening([&] {
                 EXPECT_THROW(opens.open("one", {.stop = stop.get_token()}), OpeningStopped);
               });
               stop.request_stop();
               opening.join();  // which the look would wait for in vain
               return DriverSurvey{};
             }});
  looks.survey(looks.drivers().front(), {});
  EXPECT_FALSE(is_opened);
}

TEST(Drivers, AreLookedIntoNoMoreWhereSomebodyStopsWhileAnotherOpens) {
  std::stop_source stop;
  bool has_looked = false;
  DriverRegistry looks;
  looks.add({.id = "one", .find = [&](const DriverOptions&) {
               has_looked = true;
               return DriverSurvey{};
             }});
  DriverRegistry opens;
  opens.add({.id = "other", .open = [&](const std::string&, const DriverOptions&) {
               std::jthread looking([&] {
                 EXPECT_THROW(looks.survey(looks.drivers().front(), {.stop = stop.get_token()}),
                              LookStopped);
               });
               stop.request_stop();
               looking.join();  // which the opening would wait for in vain
               return std::unique_ptr<HapticDevice>();
             }});
  opens.open("other", {});
  EXPECT_FALSE(has_looked);
}

// Of what was not asked to its end nobody knows whether it is there.
TEST(Drivers, TellNothingOfALookThatWasStopped) {
  std::stop_source stop;
  DriverRegistry drivers;
  drivers.add({.id = "slow", .find = [&](const DriverOptions&) {
                 stop.request_stop();
                 return DriverSurvey{.blocker = "nobody answered"};
               }});
  EXPECT_THROW(drivers.survey(drivers.drivers().front(), {.stop = stop.get_token()}), LookStopped);
}

// A driver that hears of no stop is done with its work all the same; nobody wants the device any more.
TEST(Drivers, LetGoOfADeviceThatIsOpenWhenTheStopHasCome) {
  VirtualHand hand(HandHabits{}, Random(1));
  std::stop_source stop;
  DriverRegistry drivers;
  drivers.add({.id = "slow", .open = [&](const std::string&, const DriverOptions&) {
                 stop.request_stop();
                 return std::make_unique<SimulatedDevice>(hand, SimulatedDeviceSettings{});
               }});
  EXPECT_THROW(drivers.open("slow", {.stop = stop.get_token()}), OpeningStopped);
}

TEST(ChooseAttached, TakesTheOnlyOneOrTheOneThatIsNamed) {
  const std::vector<AttachedDevice> two{{.serial = "A", .place = "usb 1-1"},
                                        {.serial = "B", .place = "usb 1-2"}};
  EXPECT_EQ(choose_attached("Thing", {two[0]}, "").serial, "A");
  EXPECT_EQ(choose_attached("Thing", two, "B").serial, "B");
  EXPECT_EQ(choose_attached("Thing", two, "usb 1-1").serial, "A");
}

TEST(ChooseAttached, SaysWhichThereAre) {
  const std::vector<AttachedDevice> two{{.serial = "A", .place = "usb 1-1"}, {.place = "usb 1-2"}};
  EXPECT_THAT(refusal_of([] { choose_attached("Thing", {}, ""); }),
              HasSubstr("no Thing is attached"));
  EXPECT_THAT(refusal_of([&] { choose_attached("Thing", two, ""); }),
              HasSubstr("serial A at usb 1-1; at usb 1-2"));
  EXPECT_THAT(refusal_of([&] { choose_attached("Thing", two, "C"); }),
              HasSubstr("no Thing has the serial number or place \"C\""));
}

TEST(ChooseAttached, RefusesWithTheBlocker) {
  EXPECT_EQ(refusal_of([] { choose_attached("Thing", {{.blocker = "It has no power."}}, ""); }),
            "It has no power.");
}

}  // namespace
}  // namespace asperity
