// The limits of the force leave every protocol of the library as it is.

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/records/recorded_attempt.h"
#include "app/session/stimulus_builder.h"
#include "app/tasks/protocol_templates.h"
#include "app/tasks/simulation.h"
#include "app/tasks/slew_warnings.h"
#include "app/words/phrase.h"
#include "protocols/file/library_protocols.h"
#include "protocols/file/protocol_reader.h"
#include "renderers/built_in_models.h"
#include "results_schema/study.h"
#include "tests/app/demo_study.h"

namespace asperity {
namespace {

class LibraryForces : public DemoStudy, public testing::WithParamInterface<LibraryProtocol> {
 protected:
  const ModelRegistry models = built_in_models();
};

/// Whether the device received what the surface gave: where the ramp has ended, the same bytes.
bool is_sent_as_rendered(const TickRecord& record) {
  return record.gain != 1.0 || (record.sent.force_N == record.rendered.force_N &&
                                record.sent.torque_N_m == record.rendered.torque_N_m);
}

TEST_P(LibraryForces, AreSentAsRenderedInASimulatedSession) {
  constexpr int kAttempts = 6;
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
    }
    const Trial& trial = plan.trials.at(static_cast<std::size_t>(attempt.trial - 1));
    for (const TickRecord& record :
         recorded_attempt(stored, session, trial, attempt, builder).records) {
      ASSERT_FALSE(record.has(TickFlag::reading_held));
      ASSERT_TRUE(is_sent_as_rendered(record));
      if (record.gain == 1.0 && record.penetration_m > 0.0) ++ticks_at_full_gain;
    }
  }
  EXPECT_GT(ticks_at_full_gain, 0);
}

TEST_P(LibraryForces, AreNotLimitedAtTheUpperEndOfTheBands) {
  const Protocol protocol = read_protocol(GetParam().text, std::string(GetParam().name) + ".json",
                                          declarations_of(models));
  StimulusBuilder builder(models, study);
  for (const Diagnostic& warning :
       warnings_about_slew(protocol, std::string(GetParam().name), builder)) {
    ADD_FAILURE() << warning.message;
  }
}

INSTANTIATE_TEST_SUITE_P(Protocols, LibraryForces, testing::ValuesIn(library_protocols()),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace asperity
