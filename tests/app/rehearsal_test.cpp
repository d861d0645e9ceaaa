// A plan against a device: what is beyond it is said with both numbers, and nothing else is said.

#include "app/session/rehearsal/rehearsal.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/study_files/height_field_files.h"
#include "protocols/file/library_protocols.h"
#include "renderers/built_in_models.h"
#include "renderers/force/force_model.h"
#include "renderers/force/surface_contact.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

DeviceItem numbered(const std::string& name, double value) {
  return {.name = name, .status = DeviceItem::Status::pass, .value = value};
}

/// Better than any texture asks for.
DeviceProfile ideal() {
  return {.name = "ideal",
          .rate_Hz = 1000.0,
          .workspace_minimum_m = glm::dvec3(-1.0),
          .workspace_maximum_m = glm::dvec3(1.0),
          .items = {numbered("friction_N", 0.0), numbered("force_resolution_N", 0.0),
                    numbered("position_resolution_m", 1e-9), numbered("damping_N_s_per_m", 1e6)}};
}

DeviceProfile with_item(DeviceProfile profile, const std::string& name, double value) {
  std::erase_if(profile.items, [&](const DeviceItem& item) { return item.name == name; });
  profile.items.push_back(numbered(name, value));
  return profile;
}

std::string replaced_everywhere(std::string text, const std::string& from, const std::string& to) {
  EXPECT_NE(text.find(from), std::string::npos) << from;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
  return text;
}

/// Twice one stimulus of the texture, 500 N/m, force limit 5 N, at up to 0.2 m/s; `device` for members of the
/// protocol's.
std::string one_stimulus(const std::string& model, const std::string& parameters,
                         const std::string& device = "") {
  std::string text = small_protocol("", R"(, "speed_m_per_s": {"target": 0.1, "maximum": 0.2})");
  text = replaced_everywhere(
      text, R"("rendered": {"model": {"factor": "model"}, "texture": "grain"})",
      R"("rendered": {"model": {"factor": "model"}, "texture": "grain", "parameters": {)" +
          parameters + "}}");
  text = replaced_everywhere(text, R"({"levels": ["height_map", "stochastic"]})",
                             R"({"levels": [")" + model + R"("]})");
  for (const auto& [item, from] : {std::pair{"one", "height_map"}, {"two", "stochastic"}}) {
    const std::string stimulus = R"({"stimulus": "rendered", )";
    text = replaced_everywhere(
        text, stimulus + R"("with": {"model": ")" + from + R"("}})",
        stimulus + R"("item": ")" + item + R"(", "with": {"model": ")" + model + R"("}})");
  }
  return replaced_everywhere(text, R"("textures")", R"("device": {)" + device + R"(}, "textures")");
}

/// One grating of 0.5 mm amplitude and 2 mm wavelength that pushes along its normal.
std::string grating_protocol(const std::string& device = "") {
  return one_stimulus(
      "sinusoid",
      R"("amplitude_m": 0.0005, "wavelength_m": 0.002, "force_direction": "local_normal")", device);
}

/// A block with a relief on its lower side on a plate with one: gratings along x of 0.05 mm and 0.2 mm. The block's
/// stands out far enough for its rim, which has none, to touch nothing.
struct TwoGratings {
  double block_wave_m = 2e-3;  ///< that of the plate is 2 mm
  const char* parameters = R"("coupling": "none")";

  std::string block_file() const {
    return "block_" + std::to_string(std::lround(1e6 * block_wave_m)) + ".png";
  }
};

/// 1 N, 40 mm/s at most, strokes of 8 mm; 500 N/m, force limit 5 N.
std::string bodies_protocol(const TwoGratings& gratings) {
  return std::string(R"({
  "format": "asperity.protocol/1", "kind": "selection", "design": "improved",
  "name": "bodies", "version": "1.0.0", "title": "Which one is rougher?",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "realism_standard": "memory",
  "surface": {"extent_m": [0.02, 0.02]},
  "textures": {"plates": {"height_field": "stimuli/plate.png"},
               "blocks": {"height_field": "stimuli/)") +
         gratings.block_file() + R"("}},
  "factors": {"held": {"levels": ["block", "same"]}},
  "bodies": {
    "plate": {"shape": "plate", "size_m": [0.026, 0.02, 0.006]},
    "block": {"shape": "box", "size_m": [0.012, 0.012, 0.006], "texture": "blocks"},
    "same": {"shape": "box", "size_m": [0.012, 0.012, 0.006], "texture": "blocks"}
  },
  "stimuli": {"felt": {"model": "pd_gradient", "texture": "plates", "surface": "plate",
    "tool": {"factor": "held"}, "parameters": {"cell_m": 0.00005, "step_m": 0.00005, )" +
         gratings.parameters + R"(}}},
  "explorations": {"short": {"stroke_length_m": {"target": 0.008}, "normal_force_N": {"target": 1.0},
    "speed_m_per_s": {"target": 0.034, "maximum": 0.04}, "minimum_contact_s": 0.3, "maximum_contact_s": 2}},
  "blocks": {"main": {
    "presented": [{"stimulus": "felt", "with": {"held": "block"}, "item": "one"},
                  {"stimulus": "felt", "with": {"held": "same"}, "item": "other"}],
    "question": {"name": "rougher", "prompt": "Which one is rougher?"},
    "exploration": "short"}},
  "flow": [{"run": "main"}]
})";
}

/// The same force at every depth: it jumps at contact and has no stiffness anywhere.
class RehearsedBlow final : public ForceRenderer {
 public:
  void reset(const ProbeState&) noexcept override {}
  RenderedTick tick(const ProbeState& probe, double) noexcept override {
    if (!(probe.position_m.z < 0.0)) return {};
    return {.wrench = {.force_N = {0.0, 0.0, 7.0}}, .penetration_m = -probe.position_m.z};
  }
};

/// One study for all tests, whose files stay as they are made, and what has been built from it.
struct RehearsedStudy {
  RehearsedStudy() {
    make_small_study(study);
    ForceModel blow{};
    blow.declaration = {.id = "blow", .version = "1", .parameters = {friction_speed_parameter()}};
    blow.make = [](const RendererInputs&) { return std::make_unique<RehearsedBlow>(); };
    models.add(std::move(blow));
  }

  TemporaryFolder folder{};
  std::filesystem::path study = folder / "study";
  ModelRegistry models = built_in_models();
  StimulusBuilder builder{models, study};
};

class DeviceRehearsalTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { made_ = std::make_unique<RehearsedStudy>(); }
  static void TearDownTestSuite() { made_.reset(); }

  static Protocol read(const std::string& protocol) {
    return read_small_protocol(made_->models, protocol);
  }
  std::vector<RehearsalWarning> warnings(const std::string& protocol,
                                         const DeviceProfile& profile) {
    return rehearse_on_device(read(protocol), profile, made_->builder);
  }
  /// The only one of its kind, first seen.
  std::optional<RehearsalWarning> one(const std::string& protocol, const DeviceProfile& profile,
                                      const std::string& id) {
    const auto all = warnings(protocol, profile);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& w) { return w.id == id; });
    if (found == all.end()) return {};
    return *found;
  }

  /// Puts them into the study.
  std::string bodies(const TwoGratings& gratings) {
    const auto save = [](const std::string& name, double amplitude_m, double wave_m,
                         double raised_m) {
      const std::filesystem::path file = made_->study / "stimuli" / name;
      if (std::filesystem::exists(file)) return;
      constexpr std::size_t kSamples = 200;
      constexpr double kPitch_m = 1e-4;
      std::vector<float> heights_m(kSamples * kSamples);
      for (std::size_t i = 0; i < heights_m.size(); ++i) {
        const double x_m = (static_cast<double>(i % kSamples) - 0.5 * (kSamples - 1.0)) * kPitch_m;
        heights_m[i] = static_cast<float>(
            raised_m + amplitude_m * std::cos(2.0 * std::numbers::pi * x_m / wave_m));
      }
      save_height_field(file, HeightField({kSamples, kSamples, kPitch_m}, std::move(heights_m)),
                        {.kind = "sinusoid"}, Overwrite::refuse);
    };
    save("plate.png", 2e-4, 2e-3, 0.0);
    save(gratings.block_file(), 5e-5, gratings.block_wave_m, 1e-4);
    return bodies_protocol(gratings);
  }

  static inline std::unique_ptr<RehearsedStudy> made_{};
};

TEST_F(DeviceRehearsalTest, SaysNothingOfADeviceThatCanDoAll) {
  for (const std::string& text : {small_protocol(), grating_protocol()}) {
    for (const RehearsalWarning& warning : warnings(text, ideal())) {
      ADD_FAILURE() << warning.id << ": " << warning.text.english();
    }
  }
}

// The limitation that the chapter names itself: the friction of a DELTA against the forces of its textures.
TEST_F(DeviceRehearsalTest, WarnsOfFrictionAboveTheForceOfATextureWithBothNumbers) {
  const auto found = one(small_protocol(), with_item(ideal(), "friction_N", 0.8), "friction");
  ASSERT_TRUE(found);
  EXPECT_LT(found->asked, 0.8);
  EXPECT_GT(found->asked, 0.0);
  EXPECT_EQ(found->device, 0.8);
  EXPECT_EQ(found->pointer, "/stimuli/rendered");
  EXPECT_NE(found->text.english().find("0.800 N"), std::string::npos) << found->text.english();
  EXPECT_NE(found->text.english().find("N RMS"), std::string::npos);
  // At just less friction than the texture's force it is felt.
  for (const RehearsalWarning& warning :
       warnings(grating_protocol(), with_item(ideal(), "friction_N", 0.01))) {
    ADD_FAILURE() << warning.text.english();
  }
}

TEST_F(DeviceRehearsalTest, WarnsOfAForceThatIsTooWeakToMoveTheDeviceWithBothNumbers) {
  const auto found =
      one(small_protocol(), with_item(ideal(), "force_resolution_N", 0.8), "force_resolution");
  ASSERT_TRUE(found);
  EXPECT_LT(found->asked, 0.8);
  EXPECT_GT(found->asked, 0.0);
  EXPECT_EQ(found->device, 0.8);
  EXPECT_NE(found->text.english().find("0.800 N"), std::string::npos) << found->text.english();
  EXPECT_FALSE(
      one(grating_protocol(), with_item(ideal(), "force_resolution_N", 0.01), "force_resolution"));
}

// Nothing is hidden where nothing is, and the smallest force is told with its digits.
TEST_F(DeviceRehearsalTest, ComparesNoForceOfAStimulusWithoutTexture) {
  const DeviceProfile sticky =
      with_item(with_item(ideal(), "friction_N", 0.8), "force_resolution_N", 0.8);
  for (const char* const id : {"friction", "force_resolution"}) {
    EXPECT_FALSE(one(one_stimulus("height_map", R"("height_scale": 0)"), sticky, id)) << id;
    EXPECT_FALSE(one(one_stimulus("sinusoid", R"("amplitude_m": 0)"), sticky, id)) << id;
    EXPECT_FALSE(one(one_stimulus("stochastic", R"("noise_sd_N": 0)"), sticky, id)) << id;
  }
  const auto faint = one(one_stimulus("sinusoid", R"("amplitude_m": 1e-10)"), sticky, "friction");
  ASSERT_TRUE(faint);
  EXPECT_EQ(faint->text.english().find("0.000000 N"), std::string::npos) << faint->text.english();
}

TEST_F(DeviceRehearsalTest, WarnsOfPositionsInStepsAboveATexture) {
  const auto high = one(grating_protocol(), with_item(ideal(), "position_resolution_m", 0.6e-3),
                        "position_resolution");
  ASSERT_TRUE(high);
  EXPECT_NEAR(high->asked, 0.5e-3, 1e-12);
  EXPECT_NE(high->text.english().find("an amplitude of 500 µm (√2 times its RMS)"),
            std::string::npos)
      << high->text.english() << ": from trough to crest it is 1000 µm high";
  EXPECT_TRUE(
      one(grating_protocol(), with_item(ideal(), "position_resolution_m", 1.1e-3), "wavelength"));
  EXPECT_FALSE(
      one(grating_protocol(), with_item(ideal(), "position_resolution_m", 0.9e-3), "wavelength"));
}

// 0.2 m/s over waves of 2 mm: 100 of them a second. At what rate the device was measured does not matter.
TEST_F(DeviceRehearsalTest, WarnsOfWavesFasterThanHalfTheProtocolsRateOrTheResonance) {
  for (const double measured_Hz : {100.0, 1000.0, 8000.0}) {
    DeviceProfile device = ideal();
    device.rate_Hz = measured_Hz;
    const auto found = one(grating_protocol(R"("rate_Hz": 190)"), device, "bandwidth");
    ASSERT_TRUE(found) << measured_Hz;
    EXPECT_NEAR(found->asked, 100.0, 1e-9);
    EXPECT_NEAR(found->device, 95.0, 1e-9);
    EXPECT_FALSE(one(grating_protocol(R"("rate_Hz": 210)"), device, "bandwidth")) << measured_Hz;
  }
  EXPECT_TRUE(one(grating_protocol(), with_item(ideal(), "resonance_Hz", 80.0), "bandwidth"));
  EXPECT_FALSE(one(grating_protocol(), with_item(ideal(), "resonance_Hz", 120.0), "bandwidth"));
}

TEST_F(DeviceRehearsalTest, SaysNothingOfWavesWhereThereAreNone) {
  DeviceProfile coarse = with_item(ideal(), "position_resolution_m", 1.0);
  coarse = with_item(coarse, "resonance_Hz", 1e-3);
  const auto waves = [&](const std::string& protocol) {
    std::string ids{};
    for (const RehearsalWarning& warning : warnings(protocol, coarse)) {
      if (warning.id != "position_step") ids += warning.id + ' ';  // felt through the stiffness
    }
    return ids;
  };
  EXPECT_EQ(waves(one_stimulus("height_map", "")), "position_resolution wavelength bandwidth ");
  EXPECT_EQ(waves(one_stimulus("stochastic", "")), "") << "noise is in time";
  EXPECT_EQ(waves(one_stimulus("height_map", R"("height_scale": 0)")), "") << "flat";
  EXPECT_EQ(waves(one_stimulus("sinusoid", R"("amplitude_m": 0)")), "") << "flat";
  EXPECT_EQ(waves(one_stimulus("lateral_gradient", R"("gain_N": 0)")), "") << "flat";
}

// In a trough, where the slope is 0, δ∇∇δ·k = F_max·A·(2π/λ)² = 5 N · 0.5 mm · (3142 / m)² = 24.7 kN/m; a plain
// plate of 500 N/m has 0.5 kN/m. Slopes of up to π/2 beside it add nothing there.
TEST_F(DeviceRehearsalTest, WarnsOfATextureThatIsStifferThanTheDeviceHolds) {
  const double trough_N_per_m = 5.0 * 0.5e-3 * std::pow(2.0 * std::numbers::pi / 2e-3, 2);
  const auto found =
      one(grating_protocol(), with_item(ideal(), "damping_N_s_per_m", 5.0), "stiffness");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->asked, trough_N_per_m, 0.01 * trough_N_per_m);
  EXPECT_NEAR(found->device, 2.0 * 5.0 * 1000.0, 1e-6);
  EXPECT_NE(found->text.english().find("At the force limit of 5.00 N"), std::string::npos)
      << found->text.english();
  EXPECT_TRUE(
      one(grating_protocol(), with_item(ideal(), "stiffness_N_per_m", 2000.0), "stiffness"));
  EXPECT_FALSE(one(grating_protocol(), with_item(ideal(), "damping_N_s_per_m", 13.0), "stiffness"));
}

/// What it is called stiff, by a device that holds nothing.
TEST_F(DeviceRehearsalTest, TakesTheStiffnessOfEveryModelFromItsOwnForces) {
  const DeviceProfile weak = with_item(ideal(), "damping_N_s_per_m", 1e-6);
  const auto stiffness = [&](const std::string& model, const std::string& parameters) {
    const auto found = one(one_stimulus(model, parameters), weak, "stiffness");
    return found ? found->asked : 0.0;
  };
  const double upright_N_per_m =
      250.0 * (1.0 + std::sqrt(1.0 + std::pow(2.0 * std::numbers::pi * 0.5 / 2.0, 2)));
  EXPECT_NEAR(stiffness("sinusoid", R"("amplitude_m": 0.0005, "wavelength_m": 0.002)"),
              upright_N_per_m, 0.002 * upright_N_per_m)
      << "it pushes up whatever its slope";
  EXPECT_NEAR(stiffness("stochastic", R"("noise_sd_N": 0.05)"), 500.0, 0.1) << "a plate";
  EXPECT_NEAR(stiffness("height_map", R"("height_scale": 0)"), 500.0, 0.1) << "a plate";
  const double half = stiffness("lateral_gradient", R"("gain_N": 25)");
  EXPECT_NEAR(half, 0.5 * stiffness("lateral_gradient", R"("gain_N": 50)"), 0.01 * half);
}

// A flat end of 3 mm on E* = 133 kPa: 2E*R = 800 N/m, and directly after a change of depth 1.2 times as much.
TEST_F(DeviceRehearsalTest, ForetellsTheStiffnessOfASoftSurfaceInClosedForm) {
  const auto damped = [](double damping_N_s_per_m) {
    DeviceProfile device = ideal();
    device.items = {numbered("damping_N_s_per_m", damping_N_s_per_m)};
    return device;
  };
  const std::string protocol = one_stimulus("elastic_halfspace", R"("tip": "flat")");
  const auto found = one(protocol, damped(0.4), "stiffness");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->asked, 960.0, 1e-6);
  EXPECT_NEAR(found->device, 800.0, 1e-6);
  EXPECT_FALSE(one(protocol, damped(0.5), "stiffness"));
  // A ball: 2 · 1.2 · E* · (3·5 N·R/(4E*))^(1/3)
  const auto ball = one(one_stimulus("elastic_halfspace", ""), damped(0.4), "stiffness");
  ASSERT_TRUE(ball);
  const double reduced_Pa = 1e5 / 0.75;
  EXPECT_NEAR(ball->asked, 2.4 * reduced_Pa * std::cbrt(0.75 * 5.0 * 0.003 / reduced_Pa), 1e-6);
}

TEST_F(DeviceRehearsalTest, NamesTheForceOfAStimulusThatNeverReachesTheLimit) {
  const DeviceProfile weak = with_item(ideal(), "damping_N_s_per_m", 1e-6);
  const auto found =
      one(one_stimulus("height_map", R"("lateral_gradient_gain": 1)"), weak, "stiffness");
  ASSERT_TRUE(found);  // 500 N/m and no deeper than 3 mm
  EXPECT_NE(found->text.english().find("exerts at its stiffest place, 1.50 N"), std::string::npos)
      << found->text.english();
  const auto deep =
      one(one_stimulus("height_map", R"("lateral_gradient_gain": 1, "depth_limit_m": 0.05)"), weak,
          "stiffness");
  ASSERT_TRUE(deep);
  EXPECT_NEAR(deep->asked, found->asked * 5.0 / 1.5, 0.02 * deep->asked);
}

// 24.7 kN/m. Held at 1000 Hz: at more as well, at less the share.
TEST_F(DeviceRehearsalTest, TakesTheStiffestSpringForALoopOfTheProtocolsRate) {
  const DeviceProfile device = with_item(ideal(), "stiffness_N_per_m", 4000.0);
  for (const auto& [rate, holds_N_per_m] :
       {std::pair{"500", 2000.0}, {"1000", 4000.0}, {"2000", 4000.0}}) {
    const auto found =
        one(grating_protocol(std::string(R"("rate_Hz": )") + rate), device, "stiffness");
    ASSERT_TRUE(found) << rate;
    EXPECT_NEAR(found->device, holds_N_per_m, 1e-6) << rate;
  }
}

// It tried no stiffer one at 1000 Hz, which says nothing there; at 500 Hz half of it is all that is known to be held.
TEST_F(DeviceRehearsalTest, TakesTheStiffestSpringThatWasTriedForALimitOfASlowerLoop) {
  const DeviceProfile device = with_item(ideal(), "stiffness_N_per_m", 8000.0);
  EXPECT_FALSE(one(grating_protocol(R"("rate_Hz": 1000)"), device, "stiffness"));
  const auto found = one(grating_protocol(R"("rate_Hz": 500)"), device, "stiffness");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->device, 4000.0, 1e-6);
}

TEST_F(DeviceRehearsalTest, SaysSoWhereItCannotFindHowStiffAStimulusIs) {
  DeviceProfile device = ideal();
  device.items = {numbered("damping_N_s_per_m", 5.0)};
  const auto found = one(one_stimulus("blow", ""), device, "not_rehearsed");
  ASSERT_TRUE(found);
  EXPECT_NE(found->text.english().find("could not be determined"), std::string::npos)
      << found->text.english();
}

TEST_F(DeviceRehearsalTest, WarnsOfASurfaceBeyondTheWorkspaceAndBelievesWhatWasReached) {
  DeviceProfile small = ideal();
  small.workspace_minimum_m = glm::dvec3(-0.04);
  small.workspace_maximum_m = glm::dvec3(0.04);
  const auto found = one(small_protocol(), small, "workspace");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->asked, 0.01, 1e-9) << found->text.english();
  small.reached_minimum_m = glm::dvec3(-0.06);
  small.reached_maximum_m = glm::dvec3(0.06);
  EXPECT_FALSE(one(small_protocol(), small, "workspace"));
}

// Gratings of a and b, both 2π/κ long: H = √(a² + b² + 2ab·cos κx), whose troughs are κ²·ab/(a − b) round. With
// a = 0.2 mm and b = 0.05 mm that is 658/m, at 5 N 3290 N/m. Either alone would be 2467 or 9870 N/m.
constexpr TwoGratings kMeeting{};
constexpr double kMeetingPerMetre = 2.0 * std::numbers::pi / 2e-3;
double meeting_m(double x_m) {
  return std::sqrt(2e-4 * 2e-4 + 5e-5 * 5e-5 +
                   2.0 * 2e-4 * 5e-5 * std::cos(kMeetingPerMetre * x_m));
}

TEST_F(DeviceRehearsalTest, TakesTheStiffnessOfTwoTexturesFromHowTheyMeet) {
  const double trough_N_per_m =
      5.0 * kMeetingPerMetre * kMeetingPerMetre * 2e-4 * 5e-5 / (2e-4 - 5e-5);
  const auto found =
      one(bodies(kMeeting), with_item(ideal(), "damping_N_s_per_m", 1.0), "stiffness");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->asked, trough_N_per_m, 0.05 * trough_N_per_m);
  EXPECT_FALSE(one(bodies(kMeeting), with_item(ideal(), "damping_N_s_per_m", 1.9), "stiffness"));
}

// The model itself: 0.3 mm to either side of a trough it pushes back as −kδ·H′, whose slope in the trough is told. (The
// model's samples are 50 µm apart: its slopes are good to a few hundredths, and nearer by that is all of them.)
TEST_F(DeviceRehearsalTest, AgreesWithTheForceOfTwoBodiesThemselves) {
  const std::string protocol =
      replaced_everywhere(bodies(kMeeting), R"("realism_standard")",
                          R"("device": {"force_limit_N": 1}, "realism_standard")");
  const PreparedStimulus felt =
      made_->builder.unmatched(possible_trials(read(protocol)).at(0).presentations.at(0).stimulus);
  const auto renderer = make_renderer(*felt.model, felt.inputs);
  constexpr double kTrough_m = 1e-3;
  constexpr double kBeside_m = 3e-4;
  constexpr double kRaised_m = 1e-4;  // of the block's relief, towards the plate
  constexpr double kDepth_m = 2e-3;   // 1 N
  const auto force_N = [&](double x_m) {
    ProbeState probe{.position_m = felt.inputs.patch.centre_m};
    probe.position_m.x += x_m;
    probe.position_m.z += meeting_m(kTrough_m) + kRaised_m - kDepth_m;
    renderer->reset(probe);
    return renderer->tick(probe, 1e-3).wrench.force_N;
  };
  EXPECT_NEAR(force_N(kTrough_m).z, 1.0, 0.01);
  const double model_N = force_N(kTrough_m - kBeside_m).x - force_N(kTrough_m + kBeside_m).x;
  const double beside_m = kTrough_m + kBeside_m;
  const double slope =
      -2e-4 * 5e-5 * kMeetingPerMetre * std::sin(kMeetingPerMetre * beside_m) / meeting_m(beside_m);
  const double depth_m = kDepth_m + meeting_m(beside_m) - meeting_m(kTrough_m);
  EXPECT_NEAR(model_N, 2.0 * 500.0 * depth_m * slope, 0.08 * model_N);
  const auto told = one(protocol, with_item(ideal(), "damping_N_s_per_m", 1e-6), "stiffness");
  ASSERT_TRUE(told);
  const double trough_N_per_m =
      1.0 * kMeetingPerMetre * kMeetingPerMetre * 2e-4 * 5e-5 / (2e-4 - 5e-5);
  EXPECT_NEAR(told->asked, trough_N_per_m, 0.03 * trough_N_per_m);
}

// 1000 N/m and 1 N s/m, unless the stimulus has others: 1000 N/m · 1 ms/2 + 1 N s/m, whatever the contact.
TEST_F(DeviceRehearsalTest, ComparesTheSpringAndTheDamperOfACouplingWithTheDevicesDamping) {
  TwoGratings coupled = kMeeting;
  coupled.parameters = R"("coupling": "virtual")";
  const auto damped = [](double damping_N_s_per_m) {
    return with_item(ideal(), "damping_N_s_per_m", damping_N_s_per_m);
  };
  const auto found = one(bodies(coupled), damped(1.4), "coupling");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->asked, 1.5, 1e-9);
  EXPECT_NEAR(found->device, 1.4, 1e-9);
  EXPECT_NE(found->text.english().find("requires a device with a damping of 1.50 N s/m at 1000 Hz"),
            std::string::npos)
      << found->text.english();
  EXPECT_FALSE(one(bodies(coupled), damped(1.6), "coupling"));
  EXPECT_FALSE(one(bodies(coupled), damped(0.1), "stiffness")) << "the device feels the coupling";
  coupled.parameters = R"("coupling": "virtual", "coupling_damping_N_s_per_m": 0)";
  EXPECT_FALSE(one(bodies(coupled), damped(0.6), "coupling"));
  EXPECT_TRUE(one(bodies(coupled), damped(0.4), "coupling"));
}

// 3290 N/m and 2 N s/m at 1 kHz: as a spring of 7290 N/m.
TEST_F(DeviceRehearsalTest, AddsTheContactDampingToTheStiffnessOfTwoBodies) {
  TwoGratings damped = kMeeting;
  damped.parameters = R"("coupling": "none", "contact_damping_N_s_per_m": 2)";
  const auto found = one(bodies(damped), with_item(ideal(), "damping_N_s_per_m", 2.0), "stiffness");
  ASSERT_TRUE(found) << "the spring alone asks for 1.65 N s/m";
  EXPECT_NEAR(found->asked, 3290.0 + 4000.0, 0.05 * 3290.0);
  EXPECT_NE(found->text.english().find("The contact damping of 2.00 N s/m accounts for 4000 N/m"),
            std::string::npos)
      << found->text.english();
  EXPECT_FALSE(one(bodies(damped), with_item(ideal(), "damping_N_s_per_m", 3.8), "stiffness"));
}

/// The small study's stroke with another force.
std::string pressed_with(const std::string& force, const std::string& parameters) {
  return replaced_everywhere(
      one_stimulus("sinusoid", parameters + R"(, "friction_law": "rounded")"),
      R"("speed_m_per_s": {)", R"("normal_force_N": {)" + force + R"(}, "speed_m_per_s": {)");
}

DeviceProfile of_50_grams() { return with_item(ideal(), "moving_mass_kg", 0.05); }

// B = 0.2 · F/v₀ against 2m/T = 100 N s/m; ideal() has no delay.
TEST_F(DeviceRehearsalTest, WarnsOfFrictionThatIsTooSteepADamperAndNamesTheSpeedThatWouldDo) {
  const auto found = one(pressed_with(R"("target": 1, "maximum": 3)",
                                      R"("amplitude_m": 1e-5, "friction_speed_m_per_s": 0.005)"),
                         of_50_grams(), "friction_damping");
  ASSERT_TRUE(found) << "120 N s/m";
  EXPECT_NEAR(found->asked, 120.0, 1e-9);
  EXPECT_NEAR(found->device, 100.0, 1e-9);
  EXPECT_EQ(found->pointer, "/stimuli/rendered");
  const std::string text = found->text.english();
  for (const char* const part :
       {"a damper of 120 N s/m at a normal force of 3.00 N",
        "At 1000 Hz the device vibrates if the damping exceeds 100 N s/m",
        "a moving mass of 50.0 g", "Set friction_speed_m_per_s to 0.00600 or more",
        "limit the normal force to 2.50 N"}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  // The remedies that it names.
  EXPECT_FALSE(one(
      pressed_with(R"("maximum": 3)", R"("amplitude_m": 1e-5, "friction_speed_m_per_s": 0.006)"),
      of_50_grams(), "friction_damping"));
  EXPECT_FALSE(one(
      pressed_with(R"("maximum": 2.5)", R"("amplitude_m": 1e-5, "friction_speed_m_per_s": 0.005)"),
      of_50_grams(), "friction_damping"));
}

// 120 N/m · (T/2 + 20 ms + 2T/(e^0.4 − 1)) = 2.95 N s/m.
TEST_F(DeviceRehearsalTest, WarnsOfFrictionThatIsASpringWithMoreDelayThanTheDampingAllows) {
  const std::string protocol = one_stimulus("sinusoid", R"("amplitude_m": 1e-5)");
  const DeviceProfile late = with_item(of_50_grams(), "latency_s", 0.02);
  const auto damped = [&](double along_N_s_per_m) {
    DeviceProfile device = with_item(late, "damping_N_s_per_m", 2.0);
    device.items.back().by_axis = {along_N_s_per_m + 1.0, along_N_s_per_m, 2.0};
    return device;
  };
  const auto found = one(protocol, damped(2.9), "friction_stiffness");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->asked, 120.0 * (0.0205 + 2e-3 / std::expm1(0.4)), 1e-9);
  EXPECT_EQ(found->device, 2.9);
  const std::string text = found->text.english();
  for (const char* const part : {"acts as a spring of 120 N/m whose force is delayed by 24.1 ms",
                                 "At 1000 Hz this requires a damping of 2.95 N s/m, but the "
                                 "damping of the device along the surface is 2.90 N s/m",
                                 "Set friction_stiffness_N_per_m to 110 or less."}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
  EXPECT_FALSE(one(protocol, damped(3.0), "friction_stiffness"));
  EXPECT_FALSE(
      one(one_stimulus("sinusoid", R"("amplitude_m": 1e-5, "friction_stiffness_N_per_m": 110)"),
          damped(2.9), "friction_stiffness"))
      << "the remedy";
  EXPECT_FALSE(one(one_stimulus("sinusoid", R"("amplitude_m": 1e-5, "friction_law": "rounded")"),
                   damped(0.1), "friction_stiffness"));
}

// A law that assumes 50 g and 4.5 ms, on 5 g and 4.5 ms: the bound of the law is 3.92/(1 + 0.078), that of the device 1.56.
TEST_F(DeviceRehearsalTest, WarnsOfFrictionThatIsBoundedForAHeavierDevice) {
  const auto rubbing = [](const std::string& more) {
    return one_stimulus("sinusoid", R"("amplitude_m": 1e-5, "friction_law": "bounded")" + more);
  };
  const DeviceProfile light =
      with_item(with_item(ideal(), "moving_mass_kg", 0.005), "latency_s", 0.0045);
  const auto found = one(rubbing(""), light, "friction_damping");
  ASSERT_TRUE(found);
  EXPECT_NE(found->text.english().find(
                "Set friction_mass_kg to 0.00500 or less and friction_delay_s to 0.00450 or more."),
            std::string::npos)
      << found->text.english();
  EXPECT_FALSE(one(rubbing(R"(, "friction_mass_kg": 0.005)"), light, "friction_damping"));
  EXPECT_FALSE(one(rubbing(""), with_item(of_50_grams(), "latency_s", 0.0045), "friction_damping"));
}

TEST_F(DeviceRehearsalTest, DoesNotWarnOfFrictionWithTheDefaultLaw) {
  const DeviceProfile late = with_item(of_50_grams(), "latency_s", 0.1);
  EXPECT_FALSE(one(one_stimulus("sinusoid", R"("amplitude_m": 1e-5)"), late, "friction_damping"));
  EXPECT_TRUE(one(one_stimulus("sinusoid", R"("amplitude_m": 1e-5, "friction_law": "rounded")"),
                  late, "friction_damping"));
}

TEST_F(DeviceRehearsalTest, TakesTheDelayOfTheVelocityIntoAccount) {
  const std::string protocol = pressed_with(R"("target": 1)", R"("amplitude_m": 1e-5)");
  EXPECT_FALSE(one(protocol, of_50_grams(), "friction_damping")) << "20 of 100 N s/m";
  const auto late =
      one(protocol, with_item(of_50_grams(), "latency_s", 0.0045), "friction_damping");
  ASSERT_TRUE(late);
  EXPECT_NEAR(late->device, 100.0 * std::sin(std::numbers::pi / 20.0), 1e-9);
  DeviceProfile falcon = with_item(of_50_grams(), "latency_s", 0.001);
  falcon.name = "falcon";  // whose velocity is a line through eight readings
  const auto estimated = one(protocol, falcon, "friction_damping");
  ASSERT_TRUE(estimated);
  EXPECT_NEAR(estimated->device, late->device, 1e-9);
}

TEST_F(DeviceRehearsalTest, SaysThatNoFrictionSpeedWouldDoWhereNoneDoes) {
  const auto found = one(pressed_with(R"("target": 3)", R"("amplitude_m": 1e-5)"),
                         with_item(of_50_grams(), "latency_s", 0.1), "friction_damping");
  ASSERT_TRUE(found);
  EXPECT_NE(found->text.english().find("lower the friction of the surface; even the greatest"),
            std::string::npos)
      << found->text.english();
}

// 20 N s/m in the tool's own implicit step: the device feels the coupling.
TEST_F(DeviceRehearsalTest, ComparesTheFrictionOfTwoBodiesOnlyWithoutACoupling) {
  const DeviceProfile late = with_item(of_50_grams(), "latency_s", 0.02);
  EXPECT_TRUE(one(bodies(kMeeting), late, "friction_damping"));
  TwoGratings coupled = kMeeting;
  coupled.parameters = R"("coupling": "virtual")";
  EXPECT_FALSE(one(bodies(coupled), late, "friction_damping"));
}

// 50 g and 10 N s/m across the surface, as the simulated device has them.
TEST_F(DeviceRehearsalTest, ForetellsThatAStiffGratingOfFixedDirectionIsOutOfContact) {
  DeviceProfile device = of_50_grams();
  std::erase_if(device.items,
                [](const DeviceItem& item) { return item.name == "damping_N_s_per_m"; });
  const std::string grating = R"("amplitude_m": 0.0005, "wavelength_m": 0.002)";
  const auto at = [&](const std::string& stiffness) {
    std::string protocol = pressed_with(R"("target": 1)", grating);
    return replaced_everywhere(
        protocol, R"("textures")",
        R"("material": {"stiffness_N_per_m": )" + stiffness + R"(}, "textures")");
  };
  EXPECT_FALSE(one(at("2000"), device, "contact")) << "its damping was not measured";
  device.items.push_back({.name = "damping_N_s_per_m",
                          .status = DeviceItem::Status::pass,
                          .value = 5.0,
                          .by_axis = {5.0, 5.0, 10.0}});
  const auto found = one(at("2000"), device, "contact");
  ASSERT_TRUE(found);
  EXPECT_GT(found->asked, 0.1);
  EXPECT_NE(found->text.english().find("50.0 g with a damping of 10.0 N s/m"), std::string::npos)
      << found->text.english();
  EXPECT_FALSE(one(at("500"), device, "contact"));
}

// Over a wave: the normal force is kδ with δ = H − Z and a mean of 1 N, that along the stroke −kδ·H′.
TEST_F(DeviceRehearsalTest, TakesTheForceAndTheHeightOfTwoTexturesFromHowTheyMeet) {
  constexpr int kSamples = 1000;
  constexpr double kStiffness_N_per_m = 500.0;
  double mean_m = 0.0;
  for (int i = 0; i < kSamples; ++i) mean_m += meeting_m(2e-3 * i / kSamples) / kSamples;
  double height2_m2 = 0.0;
  double force2_N2 = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double x_m = 2e-3 * i / kSamples;
    const double above_m = meeting_m(x_m) - mean_m;
    const double slope =
        -2e-4 * 5e-5 * kMeetingPerMetre * std::sin(kMeetingPerMetre * x_m) / meeting_m(x_m);
    const double normal_N = 1.0 + kStiffness_N_per_m * above_m;
    height2_m2 += above_m * above_m / kSamples;
    force2_N2 += (std::pow(normal_N - 1.0, 2) + std::pow(normal_N * slope, 2)) / kSamples;
  }
  const auto rubbed = one(bodies(kMeeting), with_item(ideal(), "friction_N", 5.0), "friction");
  ASSERT_TRUE(rubbed);
  EXPECT_NEAR(rubbed->asked, std::sqrt(force2_N2), 0.1 * std::sqrt(force2_N2));
  const double amplitude_m = std::sqrt(2.0 * height2_m2);
  const auto coarse = one(bodies(kMeeting), with_item(ideal(), "position_resolution_m", 1e-4),
                          "position_resolution");
  ASSERT_TRUE(coarse);
  EXPECT_NEAR(coarse->asked, amplitude_m, 0.05 * amplitude_m);
}

// 40 mm/s over waves of 1 mm: 40 of them a second. Those of the plate alone are twice as long.
TEST_F(DeviceRehearsalTest, TakesTheFinestWavesOfTwoTextures) {
  TwoGratings finer = kMeeting;
  finer.block_wave_m = 1e-3;
  const auto found = one(bodies(finer), with_item(ideal(), "resonance_Hz", 30.0), "bandwidth");
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->asked, 40.0, 6.0);  // the rim is a little finer
  EXPECT_TRUE(
      one(bodies(finer), with_item(ideal(), "position_resolution_m", 0.7e-3), "wavelength"));
  EXPECT_FALSE(
      one(bodies(kMeeting), with_item(ideal(), "position_resolution_m", 0.7e-3), "wavelength"));
}

TEST_F(DeviceRehearsalTest, ComparesEveryToolOfAStimulus) {
  std::string protocol = bodies(kMeeting);
  const std::string textured =
      R"("block": {"shape": "box", "size_m": [0.012, 0.012, 0.006], "texture": "blocks"})";
  protocol.replace(protocol.find(textured), textured.size(),
                   R"("block": {"shape": "box", "size_m": [0.012, 0.012, 0.006]})");
  EXPECT_TRUE(one(protocol, with_item(ideal(), "damping_N_s_per_m", 0.3), "stiffness"))
      << "the first one is flat, and rides over the plate's waves";
}

TEST_F(DeviceRehearsalTest, SaysNothingOfTwoBodiesOnADeviceThatCanDoAll) {
  for (const RehearsalWarning& warning : warnings(bodies(kMeeting), ideal())) {
    ADD_FAILURE() << warning.id << ": " << warning.text.english();
  }
}

TEST_F(DeviceRehearsalTest, SaysNothingOfWhatWasNotMeasured) {
  DeviceProfile unknown = ideal();
  unknown.items.clear();
  EXPECT_TRUE(warnings(small_protocol(), unknown).empty());
}

// A comparison that is added, or falls away, has to be in the list of those that need to be known.
TEST_F(DeviceRehearsalTest, ComparesStimuliWithWhatItSaysAndNothingElse) {
  for (const DeviceQuantity& quantity : device_quantities()) {
    if (!quantity.trait) continue;
    // A mass may be too light as well. Mass and latency are compared with the friction that is a damper.
    const std::string rubbing =
        one_stimulus("sinusoid", R"("amplitude_m": 0.0005, "wavelength_m": 0.002, )"
                                 R"("force_direction": "local_normal", "friction_law": "rounded")");
    const auto is_warned_of = [&](double value) {
      return !warnings(rubbing, with_item(ideal(), quantity.name, value)).empty();
    };
    EXPECT_EQ(is_warned_of(1e3) || is_warned_of(1e-3), !not_compared({*quantity.trait}).empty())
        << quantity.name;
  }
  DeviceProfile narrow = ideal();
  narrow.workspace_maximum_m = glm::dvec3(0.001);
  narrow.not_known = {DeviceTrait::workspace, DeviceTrait::peak_force};
  EXPECT_TRUE(one(grating_protocol(), narrow, "workspace")) << "as the driver tells it";
  EXPECT_TRUE(not_compared(narrow.not_known).empty());
  EXPECT_EQ(not_compared({DeviceTrait::damping, DeviceTrait::workspace, DeviceTrait::friction}),
            (std::vector{DeviceTrait::friction, DeviceTrait::damping}));
}

std::string with_limits(const std::string& limits) {
  return grating_protocol("\"limits\": {" + limits + "}");
}

TEST_F(DeviceRehearsalTest, WarnsOfAnItemOnTheWrongSideOfTheProtocolsLimitWithBothNumbers) {
  const std::string protocol = with_limits(R"("latency_s": 0.003, "workspace_reached": 0.9)");
  DeviceProfile device = with_item(ideal(), "latency_s", 0.003);
  device = with_item(device, "workspace_reached", 0.9);
  EXPECT_TRUE(warnings(protocol, device).empty()) << "at the limit it is kept";
  const auto late = one(protocol, with_item(device, "latency_s", 0.0031), "limit_latency_s");
  ASSERT_TRUE(late);
  EXPECT_EQ(late->asked, 0.003);
  EXPECT_EQ(late->device, 0.0031);
  EXPECT_NE(
      late->text.english().find("latency_s is at most 0.00300; the measured value is 0.00310"),
      std::string::npos)
      << late->text.english();
  const auto small =
      one(protocol, with_item(device, "workspace_reached", 0.89), "limit_workspace_reached");
  ASSERT_TRUE(small);
  EXPECT_NE(small->text.english().find("at least 0.900; the measured value is 0.890"),
            std::string::npos)
      << small->text.english();
}

TEST_F(DeviceRehearsalTest, WarnsOfALimitOnWhatWasNotMeasuredUnlessItIsAResonance) {
  const std::string protocol = with_limits(R"("latency_s": 0.003, "resonance_Hz": 50)");
  const auto all = warnings(protocol, ideal());
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all.front().id, "unmeasured_latency_s");
  EXPECT_NE(all.front().text.english().find("0.00300, but this quantity was not measured"),
            std::string::npos)
      << all.front().text.english();
  EXPECT_EQ(all.front().pointer, "/device/limits/latency_s");
  DeviceProfile stand_in = ideal();
  stand_in.not_known = {DeviceTrait::resonance};
  EXPECT_TRUE(one(protocol, stand_in, "unmeasured_resonance_Hz"))
      << "nobody knows whether there is one";
}

TEST_F(DeviceRehearsalTest, HoldsNoSimulatedDeviceToALimitOfItsTiming) {
  const std::string protocol = with_limits(R"("lateness_p99_s": 0.0001, "friction_N": 0.1)");
  DeviceProfile device = with_item(ideal(), "lateness_p99_s", 0.5);
  EXPECT_TRUE(one(protocol, device, "limit_lateness_p99_s"));
  device.is_simulated = true;
  EXPECT_TRUE(warnings(protocol, device).empty());
  EXPECT_TRUE(one(protocol, with_item(device, "friction_N", 0.2), "limit_friction_N"));
}

// The table lists by hand what device-test measures; what is exactly zero or not has no limit to choose.
TEST(ProtocolLimits, AreAnyNumberThatADeviceIsMeasuredByButTheForceOfNothing) {
  const auto& known =
      protocol_schema().at("/properties/device/properties/limits/properties"_json_pointer);
  std::set<std::string> measured{};
  for (const DeviceQuantity& quantity : device_quantities()) {
    if (std::string(quantity.name) == "force_zero_N") continue;
    measured.insert(quantity.name);
    const std::string meaning = known.value(quantity.name, nlohmann::json::object())
                                    .value("description", std::string("no such key"));
    const bool at_most = quantity.bound == DeviceItem::Bound::at_most;
    const std::vector<std::string> words =
        at_most ? std::vector<std::string>{"Largest", "Longest", "Upper limit"}
                : std::vector<std::string>{"Lowest", "Lower limit", "Smallest"};
    EXPECT_TRUE(
        std::any_of(words.begin(), words.end(),
                    [&meaning](const std::string& word) { return meaning.starts_with(word); }))
        << quantity.name << ": " << meaning;
  }
  EXPECT_EQ(known.size(), measured.size());
}

}  // namespace
}  // namespace asperity
