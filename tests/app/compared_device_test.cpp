// What check says of a device: with what it was compared, what was not and why, and what a session would refuse.

#include "app/device_bench/compared_device.h"

#include <set>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/profiles/device_profile.h"
#include "protocols/file/library_protocols.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Status = DeviceItem::Status;

constexpr const char* kNow = "2026-01-31T10:00:00.000Z";
constexpr const char* kYesterday = "2026-01-30T10:00:00.000Z";

/// Drivers with one kind of device, of which these are attached.
DriverRegistry drivers_with(const std::vector<AttachedDevice>& attached) {
  DriverRegistry drivers{};
  drivers.add({.id = "arm", .find = [attached](const DriverOptions&) {
                 return DriverSurvey{.attached = attached};
               }});
  return drivers;
}

class ComparedDevice : public testing::Test {
 protected:
  ComparedDevice() { make_small_study(study); }

  void ask_for(const std::string& of_device) {
    std::string text = small_protocol();
    text.insert(text.find("\"textures\""), "\"device\": {" + of_device + "}, ");
    protocol = read_small_protocol(models, text);
  }
  void keep(DeviceProfile profile) const {
    if (profile.measured_utc.empty()) profile.measured_utc = kYesterday;
    std::filesystem::create_directories(study / "profiles");
    write_file(profile_path(study, profile), json_text_of(profile), Overwrite::allow);
  }
  /// Of a device that is better than the stimuli ask for.
  static DeviceProfile good(const std::string& model = "mass, spring and damper") {
    return {.name = "simulated",
            .model = model,
            .is_simulated = true,
            .rate_Hz = 1e5,
            .workspace_minimum_m = glm::dvec3(-1.0),
            .workspace_maximum_m = glm::dvec3(1.0),
            .items = {{.name = "friction_N", .status = Status::pass, .value = 0.0}}};
  }
  DeviceComparison compared(const std::string& device,
                            const DriverRegistry& drivers = built_in_drivers()) const {
    return compare_with(sought_device(device, {}, drivers), protocol, "small.json", study, kNow,
                        models);
  }

  static std::vector<std::string> warnings(const DeviceComparison& comparison) {
    std::vector<std::string> sentences{};
    for (const Diagnostic& warning : comparison.warnings)
      sentences.push_back(warning.message.english());
    return sentences;
  }

  /// The law that acts as a damper near rest.
  void use_rounded_friction() {
    for (auto& [name, stimulus] : protocol.stimuli) {
      stimulus.parameters["friction_law"].value = std::string("rounded");
    }
  }

  TemporaryFolder folder{};
  std::filesystem::path study = folder.path() / "study";
  ModelRegistry models = built_in_models();
  Protocol protocol = read_small_protocol(models, small_protocol());
};

TEST_F(ComparedDevice, IsSaidToHaveNoProfileAndHowItGetsOneAsItWasNamed) {
  const std::string command =
      "measure the device with asperity device-test simulated:falcon --study " + study.string();
  EXPECT_THAT(warnings(compared("simulated:falcon")), Contains(HasSubstr(command)));
  EXPECT_TRUE(compared("simulated:falcon").refusal.empty()) << "nothing asks for one";
  keep(good("in place of Novint Falcon"));
  EXPECT_THAT(warnings(compared("simulated:falcon")), Each(Not(HasSubstr("no profile"))));
  EXPECT_THAT(compared("simulated:falcon").compared,
              HasSubstr("the profile of \"simulated:falcon\", measured on 2026-01-30"));
  EXPECT_THAT(warnings(compared("simulated")), Contains(HasSubstr("no profile")))
      << "that of a stand-in is not that of the ideal device";
  const DeviceComparison nowhere = compare_with(sought_device("simulated", {}, built_in_drivers()),
                                                protocol, "small.json", std::nullopt, kNow, models);
  EXPECT_THAT(warnings(nowhere), Contains(HasSubstr("--study")));
}

TEST_F(ComparedDevice, IsSaidNotToBeThere) {
  EXPECT_THAT(warnings(compared("arm", drivers_with({}))),
              Contains(HasSubstr("no arm is attached")));
  const DriverRegistry two =
      drivers_with({{.model = "arm", .serial = "7"}, {.model = "arm", .serial = "8"}});
  EXPECT_THAT(warnings(compared("arm:9", two)),
              Contains(HasSubstr("no arm has the serial number or place \"9\"")));
  EXPECT_THAT(warnings(compared("arm", two)), Contains(HasSubstr("2 devices are attached (arm)")));
  EXPECT_THAT(warnings(compared("arm:8", two)), Each(Not(HasSubstr("no session"))));
  EXPECT_THAT(warnings(compared("arm:8", two)),
              Contains(HasSubstr("no profile of the attached device arm 8")));
}

TEST_F(ComparedDevice, ThatGivesNoForceIsSaidToBeComparedWithNothing) {
  EXPECT_THAT(warnings(compared("mouse")), Contains(HasSubstr("exerts no force")));
  EXPECT_THAT(warnings(compared("mouse")), Each(Not(HasSubstr("device-test"))));
  EXPECT_THAT(compared("replay:" + (study / "nofile").string()).refusal.english(),
              HasSubstr("nofile"));
}

TEST_F(ComparedDevice, IsSaidToLackWhatItsProfileLacks) {
  keep(good());
  EXPECT_THAT(
      warnings(compared("simulated")),
      Contains(HasSubstr("no value for force_resolution_N, position_resolution_m, "
                         "damping_N_s_per_m, stiffness_N_per_m, latency_s, moving_mass_kg")));
}

// No measurement of the virtual hand tells of the real one.
TEST_F(ComparedDevice, ThatStandsForARealOneIsSaidNotToBeKnownWhereNobodyTells) {
  const std::string not_known =
      "these properties of delta.3, which \"simulated:delta.3\" models, are unknown: friction, "
      "force resolution, position resolution, damping, moving mass, stiffest spring, resonance; no "
      "stimulus was compared";
  EXPECT_THAT(warnings(compared("simulated:delta.3")), Contains(HasSubstr(not_known)));
  EXPECT_THAT(
      warnings(compared("simulated:falcon")),
      Contains(HasSubstr("friction, force resolution, damping, moving mass, stiffest spring, "
                         "resonance;")))
      << "its steps are";
  EXPECT_THAT(warnings(compared("simulated")), Each(Not(HasSubstr("unknown"))));
  EXPECT_THAT(warnings(compared("simulated:lambda.7")),
              Contains(HasSubstr("are unknown: friction, force resolution, position resolution, "
                                 "damping, moving mass, stiffest spring, resonance; no stimulus")))
      << "nor is its workspace, but what its driver tells is compared";
}

// 20 N s/m, at the latency and the velocity window of a Falcon. That its mass is unknown is
// no reason to be silent, with a study and without one.
TEST_F(ComparedDevice, IsComparedWithFrictionBeforeItWasMeasured) {
  use_rounded_friction();
  const auto buzz = HasSubstr("acts as a damper of 20.0 N s/m at a normal force of 1.00 N");
  const auto assumed = HasSubstr(
      "assumes a moving mass of 50.0 g, which was not measured, and a "
      "velocity delayed by 4.50 ms");
  EXPECT_THAT(warnings(compared("simulated:falcon")), Contains(AllOf(buzz, assumed)));
  EXPECT_THAT(warnings(compared("simulated")), Each(Not(buzz))) << "its limit is 100 N s/m";
  EXPECT_THAT(warnings(compared("simulated:delta.3")), Each(Not(buzz))) << "28 N s/m";
  EXPECT_THAT(warnings(compare_with(sought_device("simulated:falcon", {}, built_in_drivers()),
                                    protocol, "small.json", std::nullopt, kNow, models)),
              Contains(buzz));
  EXPECT_THAT(warnings(compared("mouse")), Each(Not(buzz)));
}

// 2m/T = 100 N s/m at 50 g without a delay, 2 · 0.01 kg/1 ms = 20 at 10 g.
TEST_F(ComparedDevice, IsComparedWithFrictionByThePropertiesThatItWasGiven) {
  use_rounded_friction();
  const auto buzz = HasSubstr("acts as a damper of 20.0 N s/m at a normal force of 1.00 N");
  EXPECT_THAT(warnings(compared("simulated:falcon,mass_kg=0.2")), Each(Not(buzz)));
  EXPECT_THAT(
      warnings(compared("simulated:falcon,mass_kg=0.06")),
      Contains(AllOf(buzz, HasSubstr("This holds for a moving mass of 60.0 g and a velocity "
                                     "delayed by 4.50 ms"))));
  EXPECT_THAT(warnings(compared("simulated:falcon,velocity_samples=0")), Each(Not(buzz)));
  EXPECT_THAT(warnings(compared("simulated:ideal,mass_kg=0.009")), Contains(buzz));
  EXPECT_THAT(warnings(compared("simulated:ideal,velocity_samples=8,latency_s=0.001")),
              Contains(buzz));
}

// A spring of 5000 N/m with the latency of a Falcon and the low-passes: 5000 · (0.5 + 1 + 4.07) ms = 27.8 N s/m.
TEST_F(ComparedDevice, IsSaidNotToBeComparedWithAdhesionWhereItsDampingIsUnknown) {
  for (auto& [name, stimulus] : protocol.stimuli) {
    stimulus.parameters["friction_law"].value = std::string("proxy");
    stimulus.parameters["friction_stiffness_N_per_m"].value = 5000.0;
  }
  const auto unknown = HasSubstr(
      "The friction of \"rendered\" was not compared with the device. Near rest, it acts as a "
      "spring that requires a damping of 27.8 N s/m at 1000 Hz, and the damping of the device is "
      "unknown.");
  EXPECT_THAT(warnings(compared("simulated:falcon")), Contains(unknown));
  EXPECT_THAT(warnings(compared("simulated:falcon")), Each(Not(HasSubstr("except for friction"))));
  const auto vibrates = HasSubstr(
      "whose force is delayed by 5.07 ms. At 1000 Hz this requires a damping of 27.8 N s/m, but "
      "the damping of the device along the surface is 1.00 N s/m");
  const DeviceComparison given = compared("simulated:falcon,damping_N_s_per_m=1");
  EXPECT_THAT(warnings(given), Contains(vibrates));
  EXPECT_THAT(warnings(given), Each(Not(unknown)));
  EXPECT_THAT(warnings(given), Contains(HasSubstr("except for friction")));
  EXPECT_THAT(warnings(compared("simulated:falcon,damping_N_s_per_m=28")), Each(Not(vibrates)));
  EXPECT_THAT(warnings(compared("mouse")), Each(Not(unknown)));
  // Measured without a damping.
  keep(good("in place of Novint Falcon"));
  EXPECT_THAT(warnings(compared("simulated:falcon")), Contains(HasSubstr("was not compared")));
}

TEST_F(ComparedDevice, HasTheProfileOfTheSamePropertiesOnly) {
  const std::string falcon = "in place of Novint Falcon";
  keep(good(falcon));
  EXPECT_THAT(warnings(compared("simulated:falcon,mass_kg=0.2")),
              Contains(HasSubstr("no profile of \"simulated:falcon,mass_kg=0.2\"")));
  keep(good(falcon + " with mass_kg=0.2"));
  EXPECT_THAT(warnings(compared("simulated:falcon,mass_kg=0.20")),
              Each(Not(HasSubstr("no profile"))));
}

// Measured, its own mass counts, and the lag of the velocity that its driver estimates.
TEST_F(ComparedDevice, IsComparedWithFrictionByItsOwnMassAndItsDriversVelocity) {
  use_rounded_friction();
  DeviceProfile falcon{.name = "falcon",
                       .model = "Novint Falcon",
                       .serial = "7",
                       .rate_Hz = 1000.0,
                       .workspace_minimum_m = glm::dvec3(-1.0),
                       .workspace_maximum_m = glm::dvec3(1.0),
                       .items = {{.name = "moving_mass_kg", .status = Status::pass, .value = 0.06},
                                 {.name = "latency_s", .status = Status::pass, .value = 0.001}}};
  keep(falcon);
  const auto buzz = HasSubstr("Near rest, the friction of \"rendered_grain_height_map\"");
  EXPECT_THAT(warnings(compared("falcon:7")),
              Contains(AllOf(
                  buzz, HasSubstr("a moving mass of 60.0 g and a velocity delayed by 4.50 ms"))));
  falcon.items.front().value = 0.07;
  keep(falcon);
  EXPECT_THAT(warnings(compared("falcon:7")), Each(Not(buzz))) << "21.9 N s/m";
}

TEST_F(ComparedDevice, IsWarnedOfWhereTheProtocolAsksForIt) {
  DeviceProfile sticky = good();
  sticky.items.front().value = 0.9;
  sticky.workspace_maximum_m = glm::dvec3(0.001);
  keep(sticky);
  ask_for(R"("limits": {"friction_N": 0.1})");
  const auto place_of = [this](const std::string& text) {
    const DeviceComparison comparison = compared("simulated");
    for (const Diagnostic& warning : comparison.warnings) {
      if (warning.message.english().find(text) == std::string::npos) continue;
      EXPECT_EQ(warning.file, "small.json");
      std::size_t begin = 0;
      for (int line = 1; line < warning.line; ++line) {
        begin = protocol.source.find('\n', begin) + 1;
      }
      const std::string found =
          protocol.source.substr(begin + static_cast<std::size_t>(warning.column) - 1, 12);
      return warning.pointer + ' ' + found.substr(0, found.find('"', 1) + 1);
    }
    return "no \"" + text + '"';
  };
  EXPECT_EQ(place_of("own friction"), "/stimuli/rendered \"rendered\"");
  EXPECT_EQ(place_of("requires a device whose friction_N"),
            "/device/limits/friction_N \"friction_N\"");
  EXPECT_EQ(place_of("The surface lies").substr(0, 8), "/surface");
  EXPECT_EQ(place_of("has no value for"), "/device \"device\"");
}

TEST_F(ComparedDevice, IsRefusedAsASessionRefusesIt) {
  ask_for(R"("profile_maximum_age_days": 30)");
  EXPECT_THAT(compared("simulated:falcon").refusal.english(),
              HasSubstr("device-test simulated:falcon --study"));
  DeviceProfile profile = good("in place of Novint Falcon");
  profile.measured_utc = "2025-12-01T10:00:00.000Z";
  keep(profile);
  EXPECT_THAT(compared("simulated:falcon").refusal.english(), HasSubstr("61.0 days old"));
  keep(good("in place of Novint Falcon"));
  EXPECT_EQ(compared("simulated:falcon").refusal.english(), "");
  profile.measured_utc = "2031-01-01T10:00:00.000Z";
  keep(profile);
  EXPECT_THAT(compared("simulated:falcon").refusal.english(), HasSubstr("in the future"));
}

TEST_F(ComparedDevice, IsRefusedWithoutAProfileWhereWarningsAreRefused) {
  ask_for(R"("refuse_rehearsal_warnings": true)");
  EXPECT_THAT(compared("simulated").refusal.english(), HasSubstr("the study has no profile of"));
  EXPECT_EQ(compared("mouse").refusal.english(), "")
      << "whoever chooses it knows that nothing is felt";
  keep(good());
  EXPECT_EQ(compared("simulated").refusal.english(), "");
  DeviceProfile sticky = good();
  sticky.items.front().value = 0.9;
  keep(sticky);
  EXPECT_THAT(compared("simulated").refusal.english(),
              HasSubstr("requirements of the protocol that the device does not meet:"));
  EXPECT_THAT(warnings(compared("simulated")), Contains(HasSubstr("0.900 N")));
}

// Another protocol held it to another limit.
TEST_F(ComparedDevice, IsHeldToTheLimitsOfThisProtocol) {
  DeviceProfile profile = good();
  profile.items.push_back(
      {.name = "damping_N_s_per_m", .status = Status::fail, .value = 5.0, .limit = 6.0});
  keep(profile);
  ask_for(R"("profile_maximum_age_days": 30)");
  EXPECT_EQ(compared("simulated").refusal.english(), "");
  ask_for(R"("profile_maximum_age_days": 30, "limits": {"damping_N_s_per_m": 5.5})");
  EXPECT_THAT(compared("simulated").refusal.english(), HasSubstr("failed damping_N_s_per_m"));
  ask_for(R"("profile_maximum_age_days": 30)");
  profile.items.push_back(
      {.name = "force_zero_N", .status = Status::pass, .value = 0.5, .limit = 1.0});
  keep(profile);
  EXPECT_THAT(compared("simulated").refusal.english(), HasSubstr("failed force_zero_N"))
      << "no limit excuses a push";
  profile.items.back() = {.name = "zero_after_stop", .status = Status::fail};
  keep(profile);
  EXPECT_THAT(compared("simulated").refusal.english(), HasSubstr("failed zero_after_stop"));
}

// It was tried, and there is not even a number.
TEST_F(ComparedDevice, IsRefusedForWhatFailedWithoutANumber) {
  DeviceProfile profile = good();
  profile.items.push_back({.name = "latency_s", .status = Status::not_measured});
  keep(profile);
  ask_for(R"("profile_maximum_age_days": 30)");
  EXPECT_EQ(compared("simulated").refusal.english(), "");
  profile.items.back().status = Status::fail;
  keep(profile);
  EXPECT_THAT(compared("simulated").refusal.english(), HasSubstr("failed latency_s"));
}

// Pressed as hard as their explorations accept, 2.5 N, friction of 0.2 is a damper of 50 N s/m. Bodies are behind a
// virtual coupling.
// With the law `rounded`; the default is not a damper (FrictionStroke measures it).
TEST(LibraryProtocols, BuzzOnADelayedVelocityWhereTheyRenderPointsWithRoundedFriction) {
  const ModelRegistry models = built_in_models();
  const auto warned_on = [&](const std::string& device, bool is_rounded) {
    const SoughtDevice sought = sought_device(device, {}, built_in_drivers());
    std::set<std::string> names{};
    for (const LibraryProtocol& library : library_protocols()) {
      Protocol protocol = read_small_protocol(models, std::string(library.text));
      for (auto& [name, stimulus] : protocol.stimuli) {
        if (is_rounded && protocol.bodies.empty()) {
          stimulus.parameters["friction_law"].value = std::string("rounded");
        }
      }
      const DeviceComparison comparison =
          compare_with(sought, protocol, "library.json", std::nullopt, kNow, models);
      for (const Diagnostic& warning : comparison.warnings) {
        if (warning.message.english().find("Near rest, the friction of") != std::string::npos) {
          names.emplace(library.name);
        }
      }
    }
    return names;
  };
  std::set<std::string> of_points{};
  for (const LibraryProtocol& library : library_protocols()) {
    if (read_small_protocol(models, std::string(library.text)).bodies.empty()) {
      of_points.emplace(library.name);
    }
  }
  EXPECT_GT(of_points.size(), 5U);
  EXPECT_EQ(warned_on("simulated", true), std::set<std::string>{});
  EXPECT_EQ(warned_on("simulated:falcon", true), of_points);
  std::set<std::string> pressed_hard = of_points;
  pressed_hard.erase("realism_of_models");  // 1.25 N: a damper of 25 N s/m
  EXPECT_EQ(warned_on("simulated:delta.3", true), pressed_hard);
  EXPECT_EQ(warned_on("simulated:falcon", false), std::set<std::string>{});
}

// The comparison of amplitude_jnd has 50 levels in its main block and two in practice; the standard has the same friction.
TEST(LibraryProtocols, WarnOfTheFrictionOfAllLevelsOnce) {
  const ModelRegistry models = built_in_models();
  const auto library =
      std::find_if(library_protocols().begin(), library_protocols().end(),
                   [](const LibraryProtocol& one) { return one.name == "amplitude_jnd"; });
  ASSERT_NE(library, library_protocols().end());
  Protocol protocol = read_small_protocol(models, std::string(library->text));
  for (auto& [name, stimulus] : protocol.stimuli) {
    stimulus.parameters["friction_law"].value = std::string("rounded");
  }
  const DeviceComparison comparison =
      compare_with(sought_device("simulated:falcon", {}, built_in_drivers()), protocol,
                   "library.json", std::nullopt, kNow, models);
  std::vector<std::string> of_friction{};
  for (const Diagnostic& warning : comparison.warnings) {
    if (warning.message.english().find("Near rest, the friction of") != std::string::npos) {
      of_friction.push_back(warning.message.english());
    }
  }
  ASSERT_EQ(of_friction.size(), 1U);
  EXPECT_THAT(of_friction.front(), HasSubstr("The same applies to"));
  EXPECT_THAT(of_friction.front(), HasSubstr("levels of amplitude_m ("));
}

TEST(FailedItem, IsOneOnTheUsualLimitsOfTheProtocolsRate) {
  const DeviceProfile profile{
      .name = "falcon",
      .rate_Hz = 1000.0,
      .items = {{.name = "rate_Hz", .status = Status::fail, .value = 900.0, .limit = 950.0}}};
  Protocol protocol{};
  protocol.rate_Hz = 1000.0;
  EXPECT_NE(failed_item(profile, protocol), nullptr);
  protocol.rate_Hz = 500.0;
  EXPECT_EQ(failed_item(profile, protocol), nullptr);
}

TEST(KeptProfile, HasWhatItStandsForInItsName) {
  DeviceProfile profile{.name = "simulated",
                        .model = "in place of delta.3",
                        .measured_utc = "2026-01-30T10:00:00.000Z"};
  EXPECT_EQ(profile_path("", profile), "profiles/simulated-delta_3-20260130T100000Z.json");
  profile.model = "hand and probe";
  EXPECT_EQ(profile_path("", profile), "profiles/simulated-20260130T100000Z.json");
}

TEST(KeptProfile, IsRefusedWithNumbersThatNoMeasurementGives) {
  DeviceProfile profile{
      .name = "arm",
      .measured_utc = kYesterday,
      .rate_Hz = 1000.0,
      .items = {{.name = "stiffness_N_per_m", .status = Status::pass, .value = -5.0}}};
  const auto refusal = [&] {
    return refusal_of<std::runtime_error>(
        [&] { (void)profile_from_json(json_text_of(profile), "arm.json"); });
  };
  EXPECT_THAT(refusal(), HasSubstr("stiffness_N_per_m is -5"));
  profile.items.front() = {.name = "stifness_N_per_m", .status = Status::pass, .value = 5.0};
  EXPECT_THAT(refusal(), HasSubstr("stifness_N_per_m\" is unknown to this program"));
  profile.items.clear();
  profile.rate_Hz = 0.0;
  EXPECT_THAT(refusal(), HasSubstr("rate_Hz is 0"));
}

TEST(WantedDevice, IsMeasuredByACommandThatAShellTakes) {
  EXPECT_EQ(command_to_measure({.asked = "falcon:usb 1-2", .options = " --firmware f.bin"},
                               "/home/a b/study"),
            "asperity device-test \"falcon:usb 1-2\" --firmware f.bin --study \"/home/a b/study\"");
  EXPECT_EQ(command_to_measure({.which = {.name = "arm", .serial = "7"}}, "s"),
            "asperity device-test arm:7 --study s");
}

}  // namespace
}  // namespace asperity
