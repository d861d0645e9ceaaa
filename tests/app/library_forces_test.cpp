// The limits of the force leave every protocol of the library as it is.

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/records/recorded_attempt.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/protocol_templates.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/warnings/slew_warnings.h"
#include "app/words/phrase.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "results_schema/study.h"
#include "tests/app/demo_study.h"

namespace asperity {
namespace {

/// In the place of the photographs of the library, which the demo study does not have, the files of another of its textures.
class LibraryForces : public DemoStudy, public testing::WithParamInterface<LibraryProtocol> {
 protected:
  void SetUp() override {
    for (const auto& [photograph, texture] :
         {std::pair("brick", "stone"), std::pair("gravel", "metal"), std::pair("grass", "wood")}) {
      for (const char* const ending : {".png", ".png.json", "_photo.png"}) {
        std::filesystem::copy_file(study / "stimuli" / (std::string(texture) + ending),
                                   study / "stimuli" / (std::string(photograph) + ending),
                                   std::filesystem::copy_options::skip_existing);
      }
    }
  }

  const ModelRegistry models = built_in_models();
};

/// Whether the device received what the surface gave: where the ramp has ended, the same bytes. The simulated device has
/// motors for a force and none for a torque.
bool is_sent_as_rendered(const TickRecord& record) {
  return record.gain != 1.0 || record.sent.force_N == record.rendered.force_N;
}

TEST_P(LibraryForces, AreSentAsRenderedInASimulatedSession) {
  constexpr int kAttempts = 2;
  int done = 0;
  std::stop_source stop{};
  SimulationInputs inputs{};
  inputs.protocols = {protocol_from_template(study, GetParam().name)};
  inputs.study = study;
  inputs.recordings = Recordings::all;
  try {
    simulate(inputs, models, stop.get_token(), {}, [&](const AttemptDone&) {
      if (++done == kAttempts) stop.request_stop();
    });
  } catch (const PhrasedError& error) {
    ASSERT_TRUE(stop.stop_requested()) << error.what();
  }

  const Study stored = Study::open(study, Access::read_only);
  const SessionRow session = stored.sessions().back();
  const Plan plan = plan_of(stored, session, models);
  StimulusBuilder builder(models, study);
  std::int64_t ticks_at_full_gain = 0;
  for (const AttemptRow& attempt : stored.attempts(session.id)) {
    if (attempt.servo) {
      EXPECT_EQ(attempt.servo->slew_limited_ticks, 0);
      EXPECT_EQ(attempt.servo->gaps_in_contact, 0);
      EXPECT_EQ(attempt.servo->held_readings, 0);
    }
    const Trial& trial = plan.trials.at(static_cast<std::size_t>(attempt.trial - 1));
    std::int64_t changed = 0;
    for (const TickRecord& record :
         recorded_attempt(study, session, trial, attempt, builder).records) {
      if (!is_sent_as_rendered(record)) ++changed;
      if (record.gain == 1.0 && record.penetration_m > 0.0) ++ticks_at_full_gain;
    }
    EXPECT_EQ(changed, 0) << "trial " << attempt.trial;
  }
  EXPECT_GT(ticks_at_full_gain, 0);
}

TEST_P(LibraryForces, AreNotLimitedAtTheUpperEndOfTheBands) {
  const Protocol protocol = read_protocol(GetParam().text, std::string(GetParam().name) + ".json",
                                          declarations_of(models));
  StimulusBuilder builder(models, study);
  for (const Diagnostic& warning :
       warnings_about_slew({protocol, std::string(GetParam().name)}, builder)) {
    ADD_FAILURE() << warning.message;
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, LibraryForces, testing::ValuesIn(library_protocols()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace asperity
