// The limits of the force leave every surface of the library's protocols as it is.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/session/attempt_measures.h"
#include "app/session/explored_stimuli.h"
#include "app/session/rig/recorder.h"
#include "app/session/rig/recording_columns.h"
#include "app/session/rig/rig.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/protocol_templates.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/warnings/slew_warnings.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/plan/plan.h"
#include "renderers/built_in_models.h"
#include "renderers/servo/contact.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "tests/app/demo_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// In the place of the photographs of the library, which the demo study does not have, the files of another of its textures.
/// Bodies and solutions of equal force are made once for all protocols.
class LibraryForces : public DemoStudy, public testing::WithParamInterface<LibraryProtocol> {
 protected:
  static void SetUpTestSuite() {
    DemoStudy::SetUpTestSuite();
    const std::filesystem::path stimuli = study_folder() / "stimuli";
    for (const auto& [photograph, texture] :
         {std::pair("gravel", "metal"), std::pair("grass", "wood")}) {
      for (const char* const ending : {".png", ".png.json", "_photo.png"}) {
        std::filesystem::copy_file(stimuli / (std::string(texture) + ending),
                                   stimuli / (std::string(photograph) + ending));
      }
    }
    models_ = std::make_unique<ModelRegistry>(built_in_models());
    builder_ = std::make_unique<StimulusBuilder>(*models_, study_folder());
  }
  static void TearDownTestSuite() {
    builder_.reset();
    models_.reset();
    DemoStudy::TearDownTestSuite();
  }

  static StimulusBuilder& builder() { return *builder_; }
  static Protocol library_protocol() {
    return read_protocol(GetParam().text, std::string(GetParam().name) + ".json",
                         declarations_of(*models_));
  }

 private:
  static inline std::unique_ptr<ModelRegistry> models_{};
  static inline std::unique_ptr<StimulusBuilder> builder_{};
};

/// Strokes at the greatest speed and force that the exploration permits.
HandHabits habits_at_upper_ends(Exploration exploration, const SurfacePatch& patch) {
  for (Band* const band : {&exploration.speed_m_per_s, &exploration.normal_force_N}) {
    if (band->maximum) band->target = band->maximum;
  }
  HandHabits habits = habits_for(exploration, patch);
  habits.speed_variation = 0.0;
  habits.force_variation = 0.0;
  return habits;
}

/// The ticks of a hand that comes down on a surface and strokes it, through the loop, the limits and the device of a
/// simulated session.
std::vector<TickRecord> stroked(const PreparedStimulus& stimulus, const Protocol& protocol,
                                const Exploration& exploration) {
  constexpr std::uint64_t kPresentation = 1;
  constexpr double kContact_s = 1.0;
  constexpr double kLongest_s = 4.0;
  constexpr double kStep_s = 0.1;
  SteppedRig rig(rig_settings_for(protocol, {}), 0);
  Recorder recorder;
  rig.prepare_attempt(habits_at_upper_ends(exploration, stimulus.inputs.patch), Random(1));
  recorder.begin(nullptr, protocol.rate_Hz, rig.records());
  rig.pass(kStep_s, recorder);
  RendererInputs inputs = stimulus.inputs;
  inputs.seed = 1;
  rig.loop().present({kPresentation, make_renderer(*stimulus.model, inputs)});
  recorder.watch(kPresentation);
  rig.hand().stroke();
  for (double passed_s = 0.0; recorder.live().contact_s < kContact_s && passed_s < kLongest_s;
       passed_s += kStep_s) {
    rig.pass(kStep_s, recorder);
  }
  return recorder.finish(rig.records()).records;
}

/// Whether the device received what the surface gave: where the ramp has ended and the greatest force is not exceeded, the
/// same bytes. The simulated device has motors for a force and none for a torque.
bool is_sent_as_rendered(const TickRecord& record) {
  return record.gain != 1.0 || record.has(TickFlag::limited_force) ||
         record.sent.force_N == record.rendered.force_N;
}

// Every surface of a session of the protocol in each of its explorations. Of a parameter that is varied, the lowest level, the
// highest and the one in the middle; AreNotLimitedAtTheUpperEndOfTheBands examines those between them.
TEST_P(LibraryForces, AreSentAsRenderedOnEverySurface) {
  const Protocol protocol = library_protocol();
  int surfaces = 0;
  for_each_stimulus_near_limit(
      protocol, possible_trials(protocol), {}, [&](const ExploredStimulus& one) {
        SCOPED_TRACE(one.planned.stimulus.name + ", " + one.exploration.name);
        const std::vector<TickRecord> records =
            stroked(builder().prepare(one.planned), protocol, one.exploration);
        std::int64_t changed = 0;
        std::int64_t felt = 0;
        for (const TickRecord& record : records) {
          if (!is_sent_as_rendered(record)) ++changed;
          if (measures_hand(record)) ++felt;
        }
        const ServoQualityRow quality = servo_quality_of(records, protocol.rate_Hz, 0);
        EXPECT_EQ(changed, 0);
        EXPECT_EQ(quality.slew_limited_ticks, 0);
        EXPECT_EQ(quality.gaps_in_contact, 0);
        EXPECT_EQ(quality.held_readings, 0);
        EXPECT_GT(felt, 0);
        ++surfaces;
        return Nearness::far;
      });
  EXPECT_GT(surfaces, 0);
}

// Across the borders of surfaces side by side the forces of two renderers blend.
TEST_F(DemoStudy, HasForcesSideBySideThatAreSentAsRendered) {
  constexpr int kAttempts = 2;
  const TemporaryFolder place{};  // other tests expect no session in the shared study
  const std::filesystem::path own_study = place / "study";
  std::filesystem::copy(study, own_study, std::filesystem::copy_options::recursive);
  int done = 0;
  std::stop_source stop{};
  const ModelRegistry models = built_in_models();
  SimulationInputs inputs{};
  inputs.protocols = {protocol_from_template(own_study, {.name = "spacing_jnd"})};
  inputs.study = own_study;
  inputs.recordings = Recordings::all;
  try {
    simulate(inputs, models, stop.get_token(), {}, [&](const AttemptDone&) {
      if (++done == kAttempts) stop.request_stop();
    });
  } catch (const PhrasedError& error) {
    ASSERT_TRUE(stop.stop_requested()) << error.what();
  }
  const Study stored = Study::open(own_study, Access::read_only);
  const SessionRow session = stored.sessions().back();
  std::int64_t ticks_at_full_gain = 0;
  for (const AttemptRow& attempt : stored.attempts(session.id)) {
    EXPECT_EQ(attempt.servo.value().slew_limited_ticks, 0);
    const std::filesystem::path file = own_study / attempt.recording.value().path;
    std::int64_t changed = 0;
    for (const TickRecord& record : records_of(read_recording(file), file)) {
      if (!is_sent_as_rendered(record)) ++changed;
      if (measures_hand(record)) ++ticks_at_full_gain;
    }
    EXPECT_EQ(changed, 0) << "trial " << attempt.trial;
  }
  EXPECT_GT(ticks_at_full_gain, 0);
}

TEST_P(LibraryForces, AreNotLimitedAtTheUpperEndOfTheBands) {
  for (const Diagnostic& warning :
       warnings_about_slew({library_protocol(), std::string(GetParam().name)}, builder())) {
    ADD_FAILURE() << warning.message.english();
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, LibraryForces, testing::ValuesIn(library_protocols()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace asperity
