// A session of more than a minute in real time: nothing is lost, and what was late is in its rows.

#include <iostream>

#include <gtest/gtest.h>

#include "app/tasks/run_session.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"
#include "tests/app/small_study.h"
#include "tests/support/patient_servo.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

TEST(RealTime, LosesNoRecordInAMinuteAtOneKilohertz) {
  const TemporaryFolder folder;
  const std::filesystem::path study_folder = folder.path() / "study";
  make_small_study(study_folder);
  std::string text = small_protocol();
  const std::string contact = R"("minimum_contact_s": 0.5, "maximum_contact_s": 2)";
  text.replace(text.find(contact), contact.size(),
               R"("minimum_contact_s": 10, "maximum_contact_s": 15)");
  write_file(study_folder / "protocols" / "small.json", text, Overwrite::refuse);
  RunInputs inputs{};
  inputs.protocol = study_folder / "protocols" / "small.json";
  inputs.study = study_folder;
  inputs.participant = "standin";
  inputs.seed = 1;
  inputs.is_virtual = true;
  inputs.pacing = RunPacing::real_time;
  inputs.servo = patient_servo();
  const SessionEnd end = run_session(inputs, built_in_models(), nullptr, {}, {});
  EXPECT_EQ(end.state, SessionState::completed);

  const Study study = Study::open(study_folder, Access::read_only);
  const SessionRow session = study.sessions().front();
  std::int64_t ticks = 0;
  for (const AttemptRow& attempt : study.attempts(session.id)) {
    const ServoQualityRow& servo = attempt.servo.value();
    ticks += servo.ticks;
    EXPECT_EQ(servo.lost_records, 0);
    EXPECT_EQ(servo.fault, "none");
    EXPECT_GE(servo.lateness_maximum_s, servo.lateness_p99_s);
    EXPECT_GE(servo.lateness_p99_s, servo.lateness_p50_s);
    std::cout << "trial " << attempt.trial << ": " << servo.ticks << " ticks, lateness p50 "
              << servo.lateness_p50_s * 1e6 << " µs, p99 " << servo.lateness_p99_s * 1e6
              << " µs, maximum " << servo.lateness_maximum_s * 1e6 << " µs, missed "
              << servo.missed_deadlines << ", lost " << servo.lost_records << " ("
              << session.scheduling << ")\n";
  }
  EXPECT_GE(ticks, 60'000);
}

}  // namespace
}  // namespace asperity
