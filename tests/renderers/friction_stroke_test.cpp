// Friction under a hand that strokes on simulated devices, at the settings of the library's protocols.

#include "renderers/offline/friction_stroke.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <tuple>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "device/simulated_models.h"
#include "renderers/built_in_models.h"
#include "renderers/models/sinusoid.h"

namespace asperity {
namespace {

constexpr std::array kRealDevices{"simulated", "simulated:falcon", "simulated:delta.3"};
constexpr double kGreatestBurst_N = 0.005;
constexpr double kGreatestSteady_N = 0.001;
constexpr double kFalconSteady_N = 0.002;

/// Friction, normal force, stiffness, speed and rate of a protocol's strokes.
struct StrokeSetting {
  double friction = 0.2;
  double force_N = 1.0;
  double stiffness_N_per_m = 500.0;
  double speed_m_per_s = 0.06;
  double rate_Hz = 1000.0;

  auto operator<=>(const StrokeSetting&) const = default;
};

/// Whether a text of the protocol is the id of a model that touches with a point.
bool names_point_model(const nlohmann::json& part, const ModelRegistry& models) {
  if (part.is_string()) {
    const ForceModel* const model = models.find(part.get<std::string>());
    return model != nullptr && !model->declaration.needs_bodies;
  }
  return part.is_structured() &&
         std::any_of(part.begin(), part.end(), [&models](const nlohmann::json& inner) {
           return names_point_model(inner, models);
         });
}

/// Those of the library with a model that takes part in the laws of friction: one that touches with a point.
std::set<StrokeSetting> settings_of_library() {
  const ModelRegistry models = built_in_models();
  std::set<StrokeSetting> settings{};
  for (const auto& file : std::filesystem::directory_iterator(
           std::filesystem::path(ASPERITY_SOURCE_DIR) / "protocols/library")) {
    const std::filesystem::path name = file.path().filename();
    if (name.extension() != ".json" || name.stem().has_extension()) continue;  // a translation
    std::ifstream in(file.path());
    const nlohmann::json protocol = nlohmann::json::parse(in);
    if (!names_point_model(protocol.at("stimuli"), models) &&
        !names_point_model(protocol.at("factors"), models)) {
      continue;
    }
    for (const auto& exploration : protocol.at("explorations")) {
      if (!exploration.contains("speed_m_per_s")) continue;  // the hand presses without a stroke
      settings.insert(
          {.friction = protocol.at("material").at("friction").get<double>(),
           .force_N = exploration.at("normal_force_N").at("target").get<double>(),
           .stiffness_N_per_m = protocol.at("material").at("stiffness_N_per_m").get<double>(),
           .speed_m_per_s = exploration.at("speed_m_per_s").at("target").get<double>(),
           .rate_Hz = protocol.at("device").at("rate_Hz").get<double>()});
    }
  }
  return settings;
}

StrokeVibration vibration_of(const std::string& law, const std::string& device,
                             const StrokeSetting& setting) {
  return stroke_vibration(
      sinusoid_model(),
      {.parameters = {{"amplitude_m", 1e-6}, {"friction_law", law}},
       .material = {.stiffness_N_per_m = setting.stiffness_N_per_m, .friction = setting.friction}},
      {.device = simulated_settings(device).value(),
       .hand = {.speed_m_per_s = setting.speed_m_per_s, .normal_force_N = setting.force_N},
       .rate_Hz = setting.rate_Hz});
}

// The table of docs/models/limits.md: 0.19 N at each reversal on simulated:falcon with these values, and nothing on the ideal
// device.
TEST(FrictionStroke, ShowsTheBurstsOfTheRoundedLaw) {
  const StrokeVibration falcon = vibration_of("rounded", "simulated:falcon", {});
  EXPECT_NEAR(falcon.burst_N, 0.19, 0.02);
  EXPECT_LT(vibration_of("rounded", "simulated", {}).burst_N, kGreatestBurst_N);
  const StrokeSetting strong{.friction = 0.8, .force_N = 1.0};
  EXPECT_GT(vibration_of("rounded", "simulated:delta.3", strong).burst_N, 0.1);
  EXPECT_GT(vibration_of("rounded", "simulated:falcon", strong).burst_N, 1.0);
}

TEST(FrictionStroke, IsCleanAtTheSettingsOfTheLibrary) {
  const std::set<StrokeSetting> settings = settings_of_library();
  ASSERT_FALSE(settings.empty());
  for (const StrokeSetting& setting : settings) {
    for (const std::string device : kRealDevices) {
      for (const std::string law : {"elastoplastic", "dahl"}) {
        const StrokeVibration vibration = vibration_of(law, device, setting);
        // The drag follows the position steps of the Falcon, also in the steady part.
        const bool shows_steps = law == "elastoplastic" && device == "simulated:falcon";
        ASSERT_TRUE(vibration.has_steady_part);
        EXPECT_LE(vibration.burst_N, kGreatestBurst_N)
            << law << ' ' << device << ' ' << setting.speed_m_per_s;
        EXPECT_LE(vibration.steady_rms_N, shows_steps ? kFalconSteady_N : kGreatestSteady_N)
            << law << ' ' << device << ' ' << setting.force_N;
        EXPECT_NEAR(vibration.drag_share, setting.friction, 0.02 * setting.friction)
            << "still friction: " << law << ' ' << device;
      }
    }
  }
}

// Around the library's settings: lighter, harder, faster, another hand.
TEST(FrictionStroke, IsCleanWithDahlAroundTheSettingsOfTheLibrary) {
  for (const StrokeSetting& setting :
       {StrokeSetting{.force_N = 0.5}, StrokeSetting{.force_N = 2.0},
        StrokeSetting{.speed_m_per_s = 0.03}, StrokeSetting{.speed_m_per_s = 0.1}}) {
    for (const std::string device : kRealDevices) {
      const StrokeVibration vibration = vibration_of("dahl", device, setting);
      EXPECT_LE(vibration.burst_N, kGreatestBurst_N) << device << ' ' << setting.speed_m_per_s;
      EXPECT_LE(vibration.steady_rms_N, kGreatestSteady_N) << device << ' ' << setting.force_N;
    }
  }
}

// A position step of the Falcon, 38 µm at 500 N/m, is a step of the normal force of 19 mN and, as the drag follows it within 0.5
// ms, of 3.8 mN.
TEST(FrictionStroke, IsCleanWithElastoplasticUpTo60MmPerSecondAtEveryRate) {
  for (const double speed_m_per_s : {0.03, 0.06}) {
    for (const double force_N : {0.5, 1.0, 2.0}) {
      for (const double rate_Hz : {500.0, 1000.0, 2000.0, 4000.0}) {
        const StrokeSetting setting{
            .force_N = force_N, .speed_m_per_s = speed_m_per_s, .rate_Hz = rate_Hz};
        const StrokeVibration falcon = vibration_of("elastoplastic", "simulated:falcon", setting);
        ASSERT_TRUE(falcon.has_steady_part);
        EXPECT_LE(falcon.burst_N, kGreatestBurst_N)
            << speed_m_per_s << ' ' << force_N << ' ' << rate_Hz;
        EXPECT_LE(falcon.steady_rms_N, kFalconSteady_N) << force_N << ' ' << rate_Hz;
        EXPECT_NEAR(falcon.drag_share, setting.friction, 0.02 * setting.friction) << rate_Hz;
      }
    }
  }
}

TEST(FrictionStroke, IsCleanWithElastoplasticOnDevicesWithoutPositionSteps) {
  for (const StrokeSetting& setting :
       {StrokeSetting{}, StrokeSetting{.force_N = 0.5}, StrokeSetting{.force_N = 2.0},
        StrokeSetting{.speed_m_per_s = 0.03}, StrokeSetting{.speed_m_per_s = 0.1}}) {
    for (const std::string device : {"simulated", "simulated:delta.3"}) {
      const StrokeVibration vibration = vibration_of("elastoplastic", device, setting);
      EXPECT_LE(vibration.burst_N, kGreatestBurst_N) << device << ' ' << setting.speed_m_per_s;
      EXPECT_LE(vibration.steady_rms_N, kGreatestSteady_N) << device << ' ' << setting.force_N;
      EXPECT_NEAR(vibration.drag_share, setting.friction, 0.01 * setting.friction) << device;
    }
  }
}

// The law itself has 4.4 mN at 1 N and 5.3 mN at 0.5 N: it turns round within 3.3 mm and 1.7 mm.
TEST(FrictionStroke, StaysBelowEightMillinewtonsWithElastoplasticAt100MmPerSecond) {
  for (const double force_N : {0.5, 1.0, 2.0}) {
    const StrokeSetting setting{.force_N = force_N, .speed_m_per_s = 0.1};
    EXPECT_LE(vibration_of("elastoplastic", "simulated:falcon", setting).burst_N, 0.008) << force_N;
  }
}

std::string with_hand_damping(const std::string& device, const std::string& damping_N_s_per_m) {
  return device + (device.find(':') == std::string::npos ? ":ideal" : "") +
         ",damping_N_s_per_m=" + damping_N_s_per_m;
}

// The second table of docs/models/friction.md: dahl requires 0.67 N s/m at most (0.55 without latency).
TEST(FrictionStroke, IsCleanWithDahlUnderALightHandOfTheRequiredDamping) {
  for (const StrokeSetting& setting :
       {StrokeSetting{}, StrokeSetting{.force_N = 0.5}, StrokeSetting{.force_N = 2.0},
        StrokeSetting{.speed_m_per_s = 0.03}}) {
    for (const std::string device : kRealDevices) {
      const StrokeVibration vibration =
          vibration_of("dahl", with_hand_damping(device, "1"), setting);
      EXPECT_LE(vibration.burst_N, kGreatestBurst_N) << device << ' ' << setting.speed_m_per_s;
      EXPECT_LE(vibration.steady_rms_N, kGreatestSteady_N) << device << ' ' << setting.force_N;
    }
  }
}

TEST(FrictionStroke, VibratesWithSpringsUnderAHandOfLessThanTheRequiredDamping) {
  const StrokeSetting strong{.friction = 0.8, .force_N = 1.0};
  for (const std::string device : kRealDevices) {
    for (const std::string law : {"proxy", "dahl"}) {
      const StrokeVibration vibration = vibration_of(law, with_hand_damping(device, "0.1"), strong);
      EXPECT_GT(vibration.burst_N, 0.03) << law << ' ' << device;
      EXPECT_GT(vibration.steady_rms_N, 0.01) << law << ' ' << device;
    }
  }
  // It brakes the hand itself.
  EXPECT_LE(vibration_of("bounded", with_hand_damping("simulated", "0.1"), strong).burst_N, 0.001);
}

}  // namespace
}  // namespace asperity
