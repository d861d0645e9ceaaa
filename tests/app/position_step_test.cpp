// The position step of a device: what is felt of it, and the path of a hand that rests.

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/numbers/random.h"
#include "app/device_bench/compared_device.h"
#include "app/session/stimulus_builder.h"
#include "app/study_files/parameter_json.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/verify/verify_study.h"
#include "protocols/file/library_protocols.h"
#include "tests/app/protocol_in_study.h"
#include "tests/app/small_study.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr const char* kToday = "2026-01-31T10:00:00.000Z";
constexpr double kFalconStep_m = 38e-6;

/// One trial: noise along the path of the hand, in two surfaces.
constexpr const char* kProtocolOfPaths = R"({
  "format": "asperity.protocol/1",
  "kind": "selection",
  "design": "improved",
  "name": "paths",
  "version": "1.0.0",
  "title": "Which one is rougher?",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "realism_standard": "memory",
  "material": {"stiffness_N_per_m": 500},
  "factors": {"noise": {"levels": [0.02, 0.05]}},
  "stimuli": {
    "path": {"model": "stochastic",
             "parameters": {"index": "distance", "noise_sd_N": {"factor": "noise"}}}
  },
  "explorations": {"short": {"minimum_contact_s": 0.3, "maximum_contact_s": 2}},
  "blocks": {
    "main": {
      "presented": [{"stimulus": "path", "with": {"noise": 0.02}, "item": "fine"},
                    {"stimulus": "path", "with": {"noise": 0.05}, "item": "coarse"}],
      "question": {"name": "rougher", "prompt": "Which surface felt rougher?"},
      "exploration": "short"
    }
  },
  "flow": [{"run": "main"}]
})";

class PositionStep : public ProtocolInStudy {
 protected:
  PositionStep() : ProtocolInStudy("paths.json") {
    make_small_study(study_);
    write_file(protocol_, kProtocolOfPaths, Overwrite::refuse);
  }

  std::vector<std::string> warnings_on(const std::string& device) const {
    const DeviceComparison comparison = compare_with(sought_device(device, {}, built_in_drivers()),
                                                     load_protocol(protocol_, models_, study_),
                                                     "paths.json", study_, kToday, models_);
    std::vector<std::string> sentences{};
    for (const Diagnostic& warning : comparison.warnings)
      sentences.push_back(warning.message.english());
    return sentences;
  }
  void set_stiffness(const std::string& stiffness) {
    std::string text = kProtocolOfPaths;
    const std::string from = R"("stiffness_N_per_m": 500)";
    text.replace(text.find(from), from.size(), R"("stiffness_N_per_m": )" + stiffness);
    write_file(protocol_, text, Overwrite::allow);
  }
  /// The stored position steps of the surfaces of a simulated session, which is verified and replayed.
  std::set<double> stored_steps_on(const std::string& device) {
    SimulationInputs inputs{};
    inputs.protocols = {protocol_};
    inputs.study = study_;
    inputs.device = device;
    inputs.recordings = Recordings::all;
    EXPECT_EQ(simulate(inputs, models_, {}, {}, {}).sessions, 1);
    Study opened = Study::open(study_, Access::read_only);
    const VerifyResult verified = verify_study(opened, models_, true, {}, [](double) {});
    EXPECT_THAT(verified.problems, IsEmpty());
    EXPECT_EQ(verified.recordings_replayed, 1);
    std::set<double> steps_m{};
    const std::vector<AttemptRow> attempts = opened.attempts(opened.sessions().at(0).id);
    for (const PresentationRow& felt : attempts.at(0).presentations) {
      steps_m.insert(number_of(parameter_values_in(felt.parameters_json), "device_step_m"));
    }
    return steps_m;
  }
};

// 38 µm · 2000 N/m = 76 mN, at 500 N/m 19 mN; 20 mN / 38 µm = 526 N/m.
TEST_F(PositionStep, IsWarnedOfWhereItIsFeltThroughTheStiffness) {
  const auto felt = HasSubstr("one step changes the force by");
  set_stiffness("2000");
  const auto of_2000 = AllOf(HasSubstr("in steps of 38.0 µm"),
                             HasSubstr("2000 N/m, one step changes the force by "
                                       "76.0 mN"),
                             HasSubstr("the threshold is about 20.0 mN"),
                             HasSubstr("Set stiffness_N_per_m to 520 or"));
  EXPECT_THAT(warnings_on("simulated:falcon"), Contains(of_2000).Times(1));
  EXPECT_THAT(warnings_on("falcon"), Contains(of_2000)) << "its driver declares the step";
  EXPECT_THAT(warnings_on("simulated:ideal,position_step_m=38e-6"), Contains(of_2000));
  EXPECT_THAT(warnings_on("simulated"), Each(Not(felt)));
  EXPECT_THAT(warnings_on("simulated:delta.3"), Each(Not(felt))) << "its step is unknown";
  const auto is_the_exception = HasSubstr("position steps, no stimulus and no limit");
  EXPECT_THAT(warnings_on("simulated:falcon"), Contains(is_the_exception));
  EXPECT_THAT(warnings_on("simulated:delta.3"), Each(Not(is_the_exception)));
  set_stiffness("530");
  EXPECT_THAT(warnings_on("simulated:falcon"), Contains(felt));
  for (const char* const stiffness : {"520", "500"}) {
    set_stiffness(stiffness);
    EXPECT_THAT(warnings_on("simulated:falcon"), Each(Not(felt))) << stiffness;
  }
}

TEST_F(PositionStep, IsComparedAsMeasuredWhereThereIsAProfile) {
  DeviceProfile profile{.name = "simulated",
                        .model = "in place of Novint Falcon",
                        .is_simulated = true,
                        .measured_utc = "2026-01-30T10:00:00.000Z",
                        .rate_Hz = 1000.0,
                        .workspace_minimum_m = glm::dvec3(-1.0),
                        .workspace_maximum_m = glm::dvec3(1.0)};
  profile.items = {
      {.name = "position_resolution_m", .status = DeviceItem::Status::pass, .value = 60e-6}};
  std::filesystem::create_directories(study_ / "profiles");
  write_file(profile_path(study_, profile), json_text_of(profile), Overwrite::refuse);
  EXPECT_THAT(warnings_on("simulated:falcon"),
              Contains(AllOf(HasSubstr("in steps of 60.0 µm"), HasSubstr("by 30.0 mN"))));
}

// The tool of bodies behind a virtual coupling does not move within a tick: 38 µm · 1000 N/m.
TEST(LibraryProtocols, HaveAFeltPositionStepOnAFalconBehindTheCouplingOnly) {
  const ModelRegistry models = built_in_models();
  const SoughtDevice falcon = sought_device("simulated:falcon", {}, built_in_drivers());
  std::set<std::string> warned{};
  std::set<std::string> coupled{};
  for (const LibraryProtocol& library : library_protocols()) {
    const Protocol protocol = read_small_protocol(models, std::string(library.text));
    const DeviceComparison comparison =
        compare_with(falcon, protocol, "library.json", std::nullopt, kToday, models);
    for (const Diagnostic& warning : comparison.warnings) {
      if (warning.message.english().find("one step changes the force by") == std::string::npos)
        continue;
      EXPECT_THAT(warning.message.english(),
                  HasSubstr("coupling_stiffness_N_per_m to 520 or less"));
      warned.emplace(library.name);
    }
    StimulusBuilder without_files(models, {});
    for (const Trial& trial : possible_trials(protocol)) {
      for (const PlannedPresentation& planned : trial.presentations) {
        if (planned.stimulus.tool && without_files.can_make(planned.stimulus)) {
          coupled.emplace(library.name);
        }
      }
    }
  }
  EXPECT_EQ(warned, coupled);
}

TEST_F(PositionStep, IsWarnedOfWhereATextureOfThePathWouldNeedItAndItIsUnknown) {
  const auto unknown = AllOf(HasSubstr("follows the path of the hand, and the position step of the "
                                       "device is unknown"),
                             HasSubstr("set device_step_m"));
  EXPECT_THAT(warnings_on("simulated:delta.3"), Contains(unknown));
  EXPECT_THAT(warnings_on("simulated:falcon"), Each(Not(unknown)));
  EXPECT_THAT(warnings_on("simulated"), Each(Not(unknown)));
  EXPECT_THAT(warnings_on("mouse"), Each(Not(unknown)));
  replace_in_protocol(R"("index": "distance")", R"("index": "distance", "device_step_m": 0.00001)");
  EXPECT_THAT(warnings_on("simulated:delta.3"), Each(Not(unknown))) << "it is stated";
  replace_in_protocol(R"("index": "distance", "device_step_m": 0.00001)", R"("index": "time")");
  EXPECT_THAT(warnings_on("simulated:delta.3"), Each(Not(unknown))) << "noise in time has no path";
}

// Readings of a hand at rest near the border of two steps. Without the device's step every count is a way.
TEST_F(PositionStep, OfADeviceLetsAHandAtRestFeelNoNoise) {
  const StimulusDescription noise{
      .name = "noise",
      .model = "stochastic",
      .parameters = {{"index", std::string("distance")}, {"noise_sd_N", 0.05}},
      .material = {.stiffness_N_per_m = 500.0, .friction = 0.0},
      .patch = {.extent_m = {0.1, 0.1}}};
  const auto rms_at_rest_N = [&](StimulusBuilder& builder) {
    const PreparedStimulus prepared = builder.unmatched(noise);
    const auto renderer = make_renderer(*prepared.model, prepared.inputs);
    Random flicker(7);
    ProbeState probe{.position_m = {0.0, 0.0, -0.002}};
    renderer->reset(probe);
    double squares = 0.0;
    constexpr int kTicks = 20'000;
    for (int tick = 1; tick <= kTicks; ++tick) {
      probe.time_ns = tick * 1'000'000LL;
      probe.position_m.x = kFalconStep_m * (static_cast<double>(flicker.below(3)) - 1.0);
      probe.position_m.y = kFalconStep_m * (static_cast<double>(flicker.below(3)) - 1.0);
      squares += std::pow(renderer->tick(probe, 1e-3).wrench.force_N.z - 1.0, 2);
    }
    return std::sqrt(squares / kTicks);
  };
  StimulusBuilder unknown(models_, {});
  EXPECT_GT(rms_at_rest_N(unknown), 0.030);
  StimulusBuilder on_falcon(models_, {});
  on_falcon.assume_position_step(kFalconStep_m);
  EXPECT_EQ(rms_at_rest_N(on_falcon), 0.0);
}

// The dead zone of 76 µm changes the RMS of the noise by 0.3 % at 60 mm/s. A stimulus is the same on every device of a study.
TEST_F(PositionStep, DoesNotChangeAnAmplitudeOfEqualForce) {
  PlannedPresentation planned{};
  planned.stimulus = {.name = "noise",
                      .model = "stochastic",
                      .parameters = {{"index", std::string("distance")}},
                      .material = {.stiffness_N_per_m = 500.0, .friction = 0.2},
                      .patch = {.extent_m = {0.1, 0.1}}};
  planned.equal_force = EqualForce{.rms_N = 0.08};
  Study opened = Study::open(study_, Access::read_write);
  const auto prepared_on = [&](double step_m) {
    StimulusBuilder builder(models_, study_);
    builder.assume_position_step(step_m);
    return builder.prepare(planned, &opened).inputs.parameters;
  };
  const ParameterValues ideal = prepared_on(0.0);
  ParameterValues on_falcon = prepared_on(kFalconStep_m);
  EXPECT_EQ(number_of(on_falcon, "device_step_m"), kFalconStep_m);
  EXPECT_NE(number_of(ideal, "noise_sd_N"), 0.05) << "the default: was solved";
  on_falcon["device_step_m"] = 0.0;
  EXPECT_EQ(on_falcon, ideal);
  planned.stimulus.parameters["device_step_m"] = kFalconStep_m;
  EXPECT_NE(number_of(prepared_on(0.0), "noise_sd_N"), number_of(ideal, "noise_sd_N"))
      << "a stated step is a part of the stimulus";
}

TEST_F(PositionStep, OfTheDeviceIsStoredWithEverySurfaceThatUsesIt) {
  EXPECT_EQ(stored_steps_on("simulated:falcon"), std::set<double>{kFalconStep_m});
}

TEST_F(PositionStep, OfADeviceWithoutStepsIsNone) {
  EXPECT_EQ(stored_steps_on("simulated"), std::set<double>{0.0});
}

TEST_F(PositionStep, ThatTheProtocolStatesIsKept) {
  replace_in_protocol(R"("index": "distance")", R"("index": "distance", "device_step_m": 0.00001)");
  EXPECT_EQ(stored_steps_on("simulated:falcon"), std::set<double>{10e-6});
}

}  // namespace
}  // namespace asperity
