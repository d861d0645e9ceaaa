// A device that fails in real time: what is finished stays, the force is gone, the session goes on.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/device_bench/measure_device.h"
#include "app/session/rig/recording_columns.h"
#include "app/session/session_course.h"
#include "app/session/session_requests.h"
#include "app/tasks/run_session.h"
#include "app/words/coded_phrases.h"
#include "device/pause.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/small_study.h"
#include "tests/support/patience.h"
#include "tests/support/patient_servo.h"
#include "tests/support/refusal.h"
#include "tests/support/scripted_device.h"
#include "tests/support/scripted_person.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

/// Two trials of two short contacts.
std::string quick_protocol() {
  std::string text =
      small_protocol(R"(, "pause_before_trial_s": 0, "pause_between_surfaces_s": 0)");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  replace("\"minimum_contact_s\": 0.5", "\"minimum_contact_s\": 0.2");
  replace("[1, 2, 3]", "[1, 2]");
  // A machine that is busy with other tests is no subject here.
  replace("\"realism_standard\"",
          "\"device\": {\"maximum_missed_deadlines\": 100000, \"maximum_gaps_in_contact\": 100000, "
          "\"maximum_lost_records\": 100000},"
          "\"realism_standard\"");
  return text;
}

/// Real time is to be spent on the surfaces.
constexpr PersonPace kQuick{.reading_s = 0.0, .answering_s = 0.05};

struct Failing {
  ScriptedFault::Kind kind = ScriptedFault::Kind::lost;
  std::string name{};  ///< as stored
};

/// When the first surface of the second trial has been felt for 0.2 s: the same session on a
/// simulated clock says so.
double moment_s(RunInputs inputs, const ModelRegistry& models) {
  const TemporaryFolder folder{};
  inputs.study = folder.path() / "study";
  make_small_study(inputs.study);
  inputs.pacing = RunPacing::stepped;
  ScriptedPerson person(kQuick);
  run_session(inputs, models, &person, {}, {});
  const Study study = Study::open(inputs.study, Access::read_only);
  const SessionRow session = study.sessions().at(0);
  const AttemptRow second = study.attempts(session.id).at(1);
  return static_cast<double>(*second.presentations.at(0).contact_ns - session.clock_zero_ns) *
             1e-9 +
         0.2;
}

class DeviceFault : public testing::TestWithParam<Failing> {};

TEST_P(DeviceFault, InRealTimeLosesNothingThatIsFinished) {
  const TemporaryFolder folder{};
  const auto study_folder = folder.path() / "study";
  make_small_study(study_folder);
  write_file(study_folder / "protocols" / "small.json", quick_protocol(), Overwrite::refuse);
  const ModelRegistry models = built_in_models();
  RunInputs inputs{};
  inputs.protocol = study_folder / "protocols" / "small.json";
  inputs.study = study_folder;
  inputs.participant = "standin1";
  inputs.mode = SessionMode::pilot;
  inputs.seed = 5;
  inputs.pacing = RunPacing::real_time;
  inputs.servo = patient_servo();
  ScriptedPerson person(kQuick);
  const double at_s = moment_s(inputs, models);
  inputs.faults = {{.kind = GetParam().kind, .at_s = at_s}};
  int done = 0;
  const SessionEnd end =
      run_session(inputs, models, &person, {}, [&done](const AttemptDone&) { ++done; });
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(),
              testing::HasSubstr(coded_phrases().at(GetParam().name).english()))
      << end.reason.english();
  EXPECT_THAT(end.reason.english(), testing::HasSubstr("a fault occurred in trial"));
  {
    const Study study = Study::open(study_folder, Access::read_only);
    const SessionRow session = study.sessions().at(0);
    EXPECT_EQ(session.state, SessionState::stopped);
    const std::vector<AttemptRow> attempts = study.attempts(session.id);
    ASSERT_EQ(attempts.size(), static_cast<std::size_t>(done));
    // The second, as in simulated time; a machine that is busy enough is still at the first.
    if (attempts.size() != 1 || attempts[0].valid) {
      ASSERT_EQ(attempts.size(), 2U);
    }
    const AttemptRow& failed = attempts.back();
    EXPECT_EQ(failed.outcome, AttemptOutcome::device_fault);
    EXPECT_FALSE(failed.valid);
    EXPECT_EQ(failed.servo->fault, GetParam().name);
    EXPECT_EQ(codes_of(failed.invalid_reason.value()), GetParam().name);
    for (std::size_t i = 0; i + 1 < attempts.size(); ++i) EXPECT_TRUE(attempts[i].valid);
    // Nothing is sent any more once the fault is known.
    const auto records = records_of(read_recording(study_folder / failed.recording->path));
    bool is_over = false;
    for (const TickRecord& record : records) {
      is_over = is_over || record.has(TickFlag::fault_latched);
      if (is_over) {
        EXPECT_EQ(record.sent.force_N, glm::dvec3{0.0});
      }
    }
    EXPECT_TRUE(is_over);
  }
  inputs.faults.clear();
  inputs.resume = true;
  EXPECT_EQ(run_session(inputs, models, &person, {}, {}).state, SessionState::completed);
  const Study study = Study::open(study_folder, Access::read_only);
  int valid = 0;
  for (const AttemptRow& attempt : study.attempts(study.sessions().at(0).id)) {
    if (attempt.valid) ++valid;
  }
  EXPECT_EQ(valid, 2);
}

// The first trial takes a little over a second: the fault comes in the second one, or in the first
// on a machine that was slow to begin.
INSTANTIATE_TEST_SUITE_P(Each, DeviceFault,
                         testing::Values(Failing{ScriptedFault::Kind::lost, "device_lost"},
                                         Failing{ScriptedFault::Kind::nan, "not_finite"}),
                         [](const auto& each) { return each.param.name; });

// A device that responds, with positions that jumped, must not be reported as one that does not respond.
TEST(PositionJump, HasItsOwnReason) {
  const auto code = [](const ServoStatus& status) {
    return std::string(interruption_by(status).reason.code());
  };
  EXPECT_EQ(code({.fault = Fault::device_lost, .position_jumped = true}), "position_jumped");
  EXPECT_EQ(code({.fault = Fault::device_lost}), "device_lost");
}

TEST(DeviceStall, IsCountedAndDoesNotEndTheSession) {
  const TemporaryFolder folder{};
  RunInputs inputs{};
  inputs.study = folder.path() / "study";
  make_small_study(inputs.study);
  inputs.protocol = folder.path() / "small.json";
  write_file(inputs.protocol, quick_protocol(), Overwrite::refuse);
  inputs.participant = "standin1";
  inputs.mode = SessionMode::pilot;
  inputs.seed = 5;
  inputs.pacing = RunPacing::real_time;
  inputs.servo = patient_servo();
  const ModelRegistry models = built_in_models();
  ScriptedPerson person(kQuick);
  const double at_s = moment_s(inputs, models);
  // On a busy machine the session is later than planned: of several one falls into an attempt, whichever.
  for (int i = 0; i < 8; ++i) {
    inputs.faults.push_back(
        {.kind = ScriptedFault::Kind::stall, .at_s = at_s + 0.4 * i, .duration_s = 0.15});
  }
  const SessionEnd end = run_session(inputs, models, &person, {}, {});
  const Study study = Study::open(inputs.study, Access::read_only);
  const std::vector<AttemptRow> attempts = study.attempts(study.sessions().at(0).id);
  const auto counts_it = [](const AttemptRow& attempt) {
    return attempt.servo && attempt.servo->missed_deadlines >= 1 &&
           attempt.servo->period_maximum_s >= 0.15;
  };
  EXPECT_TRUE(std::any_of(attempts.begin(), attempts.end(), counts_it));
  EXPECT_EQ(end.state, SessionState::completed) << end.reason.english();
}

/// Swings through the surface by itself, as a device in a person's hand does.
std::unique_ptr<HapticDevice> swinging_device() {
  auto device = std::make_unique<ScriptedDevice>(
      DeviceCapability{.name = "swinging", .serial = "42", .peak_force_N = 6.0});
  device->at_read = [](ProbeState& state) {
    const double turn = 2.0 * std::numbers::pi * 1e-9 * static_cast<double>(state.time_ns);
    state.position_m = {0.010 * std::sin(turn), 0.0, 0.002 * std::sin(1.3 * turn)};
    state.velocity_m_per_s = {0.010 * 2.0 * std::numbers::pi * std::cos(turn), 0.0, 0.0};
  };
  return device;
}

TEST(NamedDevice, RunsTheSessionAndIsStoredWithIt) {
  const TemporaryFolder folder{};
  RunInputs inputs{};
  inputs.study = folder.path() / "study";
  make_small_study(inputs.study);
  inputs.protocol = folder.path() / "small.json";
  write_file(inputs.protocol, quick_protocol(), Overwrite::refuse);
  inputs.participant = "standin1";
  inputs.mode = SessionMode::pilot;
  inputs.seed = 5;
  inputs.pacing = RunPacing::real_time;
  inputs.servo = patient_servo();
  inputs.device = "swinging:42";
  inputs.driver_options.firmware = "some.bin";
  std::string which;
  std::filesystem::path firmware;
  DriverRegistry drivers;
  drivers.add(
      {.id = "swinging", .open = [&](const std::string& asked, const DriverOptions& options) {
         which = asked;
         firmware = options.firmware;
         return swinging_device();
       }});
  const ModelRegistry models = built_in_models();
  ScriptedPerson person(kQuick);
  const SessionEnd end = run_session(inputs, models, &person, {}, {}, {}, drivers);
  EXPECT_EQ(end.state, SessionState::completed) << end.reason.english();
  EXPECT_EQ(which, "42");
  EXPECT_EQ(firmware, "some.bin");
  const Study study = Study::open(inputs.study, Access::read_only);
  const SessionRow session = study.sessions().at(0);
  EXPECT_NE(session.device.find("swinging"), std::string::npos) << session.device;
}

TEST(NamedDevice, IsNotOpenedForASessionWhileADeviceIsMeasuredForTheStudy) {
  const TemporaryFolder folder{};
  RunInputs inputs{};
  inputs.study = folder.path() / "study";
  make_small_study(inputs.study);
  inputs.protocol = folder.path() / "small.json";
  write_file(inputs.protocol, quick_protocol(), Overwrite::refuse);
  inputs.participant = "standin1";
  inputs.mode = SessionMode::pilot;
  inputs.pacing = RunPacing::real_time;
  inputs.servo = patient_servo();
  inputs.device = "swinging";
  int openings = 0;
  DriverRegistry drivers;
  drivers.add({.id = "swinging", .open = [&](const std::string&, const DriverOptions&) {
                 ++openings;
                 return swinging_device();
               }});
  const ModelRegistry models = built_in_models();
  ScriptedPerson person(kQuick);
  const MeasuringLock measuring(inputs.study);
  EXPECT_THAT(
      refusal_of<PhrasedError>([&] { run_session(inputs, models, &person, {}, {}, {}, drivers); }),
      testing::HasSubstr("A device is being measured"));
  EXPECT_EQ(openings, 0);
  EXPECT_TRUE(Study::open(inputs.study, Access::read_only).sessions().empty());
}

// A file with another name than a lock can have refused every measurement, for ever, without saying which it was.
TEST(MeasuringLock, IsHadWhateverElseLiesInTheFolderOfLocks) {
  const TemporaryFolder folder{};
  const std::filesystem::path study = folder.path() / "study";
  make_small_study(study);
  std::ofstream(study / "locks" / "session-P1 (copy).lock") << "process 1 on host x";
  EXPECT_NO_THROW(MeasuringLock{study});
  const StudyLock session(study, Study::session_lock_name("P1"));
  EXPECT_THROW(MeasuringLock{study}, PhrasedError);
}

TEST(RecordedHand, MovesInASessionAsItOnceMovedAndFeelsNothing) {
  const TemporaryFolder folder{};
  const ModelRegistry models = built_in_models();
  const auto run = [&](const std::string& name, const std::string& protocol,
                       const std::string& device) {
    RunInputs inputs{};
    inputs.study = folder.path() / name;
    make_small_study(inputs.study);
    inputs.protocol = folder.path() / (name + ".json");
    write_file(inputs.protocol, protocol, Overwrite::refuse);
    inputs.participant = "anna";
    inputs.mode = SessionMode::pilot;
    inputs.seed = 5;
    inputs.pacing = RunPacing::real_time;
    inputs.servo = patient_servo();
    inputs.device = device;
    ScriptedPerson person(kQuick);
    SessionRequests requests{};
    // The hand may come a tick late for what the protocol asks: that is not what is tested.
    const std::jthread limit([&requests](const std::stop_token& ended) {
      pause(ended, kPatience);
      requests.abort("it took too long");
    });
    run_session(inputs, models, &person, {}, {}, {.requests = &requests});
    const Study study = Study::open(inputs.study, Access::read_only);
    const AttemptRow first = study.attempts(study.sessions().at(0).id).at(0);
    return study.folder() / first.recording->path;
  };
  // Twice as long in contact as is asked of it then.
  std::string longer = quick_protocol();
  const std::string contact = "\"minimum_contact_s\": 0.2";
  longer.replace(longer.find(contact), contact.size(), "\"minimum_contact_s\": 0.5");
  const std::filesystem::path file = run("recorded", longer, "simulated");
  const auto recorded = records_of(read_recording(file));
  const auto moved =
      records_of(read_recording(run("moved", quick_protocol(), "replay:" + file.string())));
  std::set<std::array<double, 3>> places{};
  for (const TickRecord& tick : recorded) {
    places.insert({tick.probe.position_m.x, tick.probe.position_m.y, tick.probe.position_m.z});
  }
  std::set<std::array<double, 3>> met{};
  double meant_N = 0.0;
  ASSERT_GT(moved.size(), 300U);
  // Its first ticks may be of the hand as it rested before the attempt.
  for (const TickRecord& tick : moved) {
    const glm::dvec3& place = tick.probe.position_m;
    ASSERT_TRUE(places.contains({place.x, place.y, place.z})) << place.x << ' ' << place.z;
    met.insert({place.x, place.y, place.z});
    EXPECT_EQ(tick.sent.force_N, glm::dvec3(0.0));
    meant_N = std::max(meant_N, glm::length(tick.rendered.force_N));
  }
  EXPECT_GT(met.size(), 200U);  // it moved
  EXPECT_GT(meant_N, 0.0);      // over a surface
}

TEST(NamedDevice, IsNotForVirtualParticipants) {
  const TemporaryFolder folder{};
  RunInputs inputs{};
  inputs.study = folder.path() / "study";
  make_small_study(inputs.study);
  inputs.participant = "virtual1";
  inputs.is_virtual = true;
  inputs.device = "falcon";
  EXPECT_THROW(run_session(inputs, built_in_models(), nullptr, {}, {}), std::runtime_error);
}

}  // namespace
}  // namespace asperity
