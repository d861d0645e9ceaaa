// Tests the checklist before a session with real studies.

#include "app/tasks/checks/session_checks.h"

#include <algorithm>
#include <chrono>
#include <fstream>

#include <gtest/gtest.h>

#include "app/session/rig/clock.h"
#include "app/tasks/checks/disk_check.h"
#include "app/tasks/checks/noise_check.h"
#include "app/tasks/checks/protocol_check.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/unfinished_session.h"
#include "app/words/utc_time.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/hashes/short_hash.h"
#include "results_schema/study.h"
#include "tests/app/scripted_session.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using State = SessionCheck::State;

class SessionChecks : public testing::Test {
 protected:
  void SetUp() override {
    make_small_study(study);
    write_protocol(small_protocol());
    inputs.study = study;
    inputs.protocol = study / "protocols" / "small.json";
    inputs.participant = "P001";
    inputs.screens = 2;
    inputs.pacing = RunPacing::stepped;  // where the loop matters it runs in real time
  }

  void write_protocol(const std::string& text) {
    std::filesystem::create_directories(study / "protocols");
    write_file(study / "protocols" / "small.json", text, Overwrite::allow);
  }

  /// The small protocol with masking noise.
  void ask_for_noise() {
    std::string text = small_protocol();
    text.replace(text.find("\"textures\""), 0,
                 R"("environment": {"masking_noise": {"kind": "pink", "level_dBA": 65}}, )");
    write_protocol(text);
  }

  SessionCheck check(const std::string& id) {
    const std::vector<SessionCheck> checks = check_session(inputs, models, {});
    const auto found = std::find_if(checks.begin(), checks.end(),
                                    [&id](const auto& line) { return line.id == id; });
    return found == checks.end() ? SessionCheck{.id = "absent"} : *found;
  }

  SessionEnd run_virtual(bool resume, const std::stop_token& stop = {}) {
    const RunInputs run{.protocol = inputs.protocol,
                        .study = study,
                        .participant = "virtual0001",
                        .seed = 3,
                        .mode = SessionMode::simulate,
                        .resume = resume,
                        .is_virtual = true,
                        .pacing = RunPacing::stepped};
    return run_session(run, models, nullptr, stop, {});
  }

  TemporaryFolder folder{};
  std::filesystem::path study = folder.path() / "study";
  ModelRegistry models = built_in_models();
  CheckInputs inputs{};
};

TEST_F(SessionChecks, SayInOrderThatASmallStudyIsReady) {
  inputs.mode = SessionMode::pilot;
  inputs.pacing = RunPacing::real_time;
  const std::vector<SessionCheck> checks = check_session(inputs, models, {});
  std::vector<std::string> ids{};
  for (const SessionCheck& line : checks) {
    ids.push_back(line.id);
    EXPECT_FALSE(line.text.empty() && line.warnings.empty()) << line.id;
    if (line.id == "rate") continue;  // a busy machine may be late
    if (line.id == "protocol_warnings") continue;
    EXPECT_EQ(line.state, State::fine) << line.id << ": " << line.text.english();
    EXPECT_TRUE(line.remedy.empty()) << line.id;
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"protocol", "protocol_warnings", "participant", "study",
                                           "disk", "stimuli", "device", "calibration", "force_zero",
                                           "rate", "screens", "masking_noise"}));
}

TEST_F(SessionChecks, NameWhatCheckWarnsOf) {
  const SessionCheck warned = check("protocol_warnings");
  EXPECT_EQ(warned.state, State::look);
  ASSERT_EQ(warned.warnings.size(), 1U);
  EXPECT_NE(warned.warnings[0].message.english().find("question uses the factor \"go\""), std::string::npos)
      << warned.warnings[0].message.english();
  EXPECT_FALSE(warned.remedy.empty());
  std::string text = small_protocol();
  const std::string crossed = R"("crossed": ["go"])";
  text.replace(text.find(crossed), crossed.size(), R"("repetitions": 3)");
  const std::string levels = R"(, "go": {"levels": [1, 2, 3]})";
  text.replace(text.find(levels), levels.size(), "");
  write_protocol(text);
  EXPECT_EQ(check("protocol").state, State::fine) << check("protocol").text.english();
  EXPECT_EQ(check("protocol_warnings").id, "absent");
}

TEST_F(SessionChecks, RunTheLoopInRealTimeAndFindNoForce) {
  inputs.pacing = RunPacing::real_time;
  const SessionCheck zero = check("force_zero");
  EXPECT_EQ(zero.state, State::fine);
  EXPECT_EQ(zero.text.english().find("Exactly 0 N was sent in "), 0U) << zero.text.english();
  EXPECT_NE(check("rate").text.english().find("of 1000 Hz; period p99 "), std::string::npos);
}

TEST_F(SessionChecks, NeedNoLoopInAFastSimulation) {
  EXPECT_NE(check("rate").text.english().find("Not needed"), std::string::npos);
  EXPECT_EQ(check("rate").state, State::fine);
}

TEST_F(SessionChecks, RefuseAProtocolThatChangedSinceItWasChosen) {
  inputs.protocol_sha256 = sha256_of(small_protocol());
  EXPECT_EQ(check("protocol").state, State::fine);
  write_protocol(small_protocol() + "\n");
  const SessionCheck changed = check("protocol");
  EXPECT_EQ(changed.state, State::stop);
  EXPECT_NE(changed.text.english().find(short_hash(inputs.protocol_sha256)), std::string::npos);
  EXPECT_NE(changed.text.english().find(short_hash(sha256_of(small_protocol() + "\n"))),
            std::string::npos);
  EXPECT_THROW(require_unchanged(inputs.protocol, inputs.protocol_sha256),
               ProtocolChangedSinceCheck);
}

TEST_F(SessionChecks, StopAtAProtocolThatIsNotValid) {
  write_protocol("{");
  const std::vector<SessionCheck> checks = check_session(inputs, models, {});
  ASSERT_EQ(checks.size(), 1U);
  EXPECT_EQ(checks.front().id, "protocol");
  EXPECT_EQ(checks.front().state, State::stop);
  EXPECT_EQ(checks.front().text.english(),
            inputs.protocol.filename().string() +
                ", line 1: the text ends before the JSON is complete; close every quotation mark "
                "and bracket.");
}

TEST_F(SessionChecks, NameTheHolderOfAParticipantWhoseSessionRuns) {
  const StudyLock elsewhere(study, Study::session_lock_name("P001"));
  const SessionCheck held = check("participant");
  EXPECT_EQ(held.state, State::stop);
  EXPECT_NE(held.text.english().find("A session of P001 is running in process "), std::string::npos)
      << held.text.english();
  EXPECT_NE(held.text.english().find(" on host "), std::string::npos);
}

TEST_F(SessionChecks, RefuseLabelsThatCannotBe) {
  inputs.participant = "no spaces";
  EXPECT_EQ(check("participant").state, State::stop);
  inputs.participant = "";
  EXPECT_EQ(check("participant").state, State::stop);
  inputs.participant = "virtual0001";  // in Run: not for a person
  EXPECT_EQ(check("participant").state, State::stop);
}

TEST_F(SessionChecks, FindTheUnfinishedSessionThatCanGoOn) {
  inputs.participant = "virtual0001";
  inputs.mode = SessionMode::simulate;
  inputs.resume = true;
  EXPECT_EQ(check("participant").state, State::stop);  // nothing to go on with yet
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(run_virtual(false, stop.get_token()).state, SessionState::stopped);
  EXPECT_EQ(check("participant").state, State::fine);
  EXPECT_EQ(check("stimuli").state, State::fine);

  // The same bytes but one: the session began with another file.
  std::ofstream(study / "stimuli" / "grain_photo.png", std::ios::app) << ' ';
  const SessionCheck changed = check("stimuli");
  EXPECT_EQ(changed.state, State::stop);
  EXPECT_NE(changed.text.english().find("grain_photo.png has changed since session 1 began"),
            std::string::npos)
      << changed.text.english();
}

TEST_F(SessionChecks, KnowThatASessionWhichTheProtocolEndedIsOver) {
  write_protocol(practised_protocol("end_session"));
  const Protocol protocol = load_protocol(inputs.protocol, models, study);
  {
    Study store = Study::open(study, Access::read_write);
    store.add_participant({.label = "P001", .created_utc = "2026-01-01T00:00:00.000Z"});
    const SessionConditions conditions{.seed = 1,
                                       .pacing = "stepped",
                                       .scheduling = "none",
                                       .device = {.name = "simulated"},
                                       .started_utc = "2026-01-01T00:00:00.000Z"};
    const std::int64_t id =
        begin_session(store, protocol, "P001", conditions, this_program()).row.id;
    EXPECT_TRUE(unfinished_of(unfinished_sessions(store, protocol), "P001", {}));
    store.add_event(id, {0, "criterion_not_met", "practice", "null"});
    store.end_session(id, SessionState::stopped, "2026-01-01T01:00:00.000Z");
    EXPECT_FALSE(unfinished_of(unfinished_sessions(store, protocol), "P001", {}));
  }
  EXPECT_NE(check("participant").text.english().find("(1 of 1)"), std::string::npos)
      << check("participant").text.english();
  inputs.resume = true;
  EXPECT_NE(check("participant").text.english().find("no unfinished session"), std::string::npos);
}

TEST_F(SessionChecks, TellOneUnfinishedSessionFromAnother) {
  const Protocol protocol = load_protocol(inputs.protocol, models, study);
  std::vector<std::int64_t> ids{};
  {
    Study store = Study::open(study, Access::read_write);
    store.add_participant({.label = "P001", .created_utc = "2026-01-01T00:00:00.000Z"});
    for (const SessionMode mode : {SessionMode::pilot, SessionMode::run}) {
      const SessionConditions conditions{.mode = mode,
                                         .seed = 1,
                                         .pacing = "real_time",
                                         .scheduling = "none",
                                         .device = {.name = "simulated"},
                                         .started_utc = "2026-01-01T00:00:00.000Z"};
      ids.push_back(begin_session(store, protocol, "P001", conditions, this_program()).row.id);
      store.end_session(ids.back(), SessionState::stopped, "2026-01-01T01:00:00.000Z");
    }
    EXPECT_EQ(unfinished_of(unfinished_sessions(store, protocol), "P001", ids[0])->row.mode,
              SessionMode::pilot);
    EXPECT_EQ(unfinished_of(unfinished_sessions(store, protocol), "P001", ids[1])->row.mode,
              SessionMode::run);
    EXPECT_EQ(unfinished_of(unfinished_sessions(store, protocol), "P001", {})->row.id, ids[1]);
    EXPECT_FALSE(unfinished_of(unfinished_sessions(store, protocol), "P002", ids[0]));
  }
  inputs.resume = true;
  inputs.mode = SessionMode::pilot;
  inputs.resumed_session = ids[0];
  EXPECT_NE(check("participant").text.english().find("Session 1 can be resumed"), std::string::npos)
      << check("participant").text.english();
}

TEST_F(SessionChecks, StateWhatTheStudyHoldsOfALabelBeforeANewSession) {
  const auto expect_noticed = [this](State state, const std::string& text,
                                     const std::string& remedy) {
    const SessionCheck line = check("participant");
    EXPECT_EQ(line.state, state) << line.text.english();
    EXPECT_EQ(line.text.english(), text);
    EXPECT_EQ(line.remedy.english(), remedy);
  };
  const auto add_completed = [this](SessionMode mode) {
    const Protocol protocol = load_protocol(inputs.protocol, models, study);
    Study store = Study::open(study, Access::read_write);
    if (!store.participant("P001")) {
      store.add_participant({.label = "P001", .created_utc = SystemClock(0).utc()});
    }
    const SessionConditions conditions{.mode = mode,
                                       .seed = 1,
                                       .pacing = "real_time",
                                       .scheduling = "none",
                                       .device = {.name = "simulated"},
                                       .started_utc = "2026-01-01T00:00:00.000Z"};
    const std::int64_t id =
        begin_session(store, protocol, "P001", conditions, this_program()).row.id;
    store.end_session(id, SessionState::completed, SystemClock(0).utc());
  };
  std::string twice = small_protocol();
  twice.replace(twice.find("\"consent\""), 0, R"("participants": {"sessions": 2}, )");
  write_protocol(twice);
  EXPECT_EQ(check("participant").state, State::fine);

  add_completed(SessionMode::pilot);
  expect_noticed(State::look,
                 "P001 has completed session 1 of this protocol (pilot data, version 1.0.0, less "
                 "than an hour ago); a further session begins.",
                 "For another participant, use another label.");
  inputs.participant = "p001";
  expect_noticed(State::look,
                 "p001 is a new participant; P001, whose label differs only in letter case or "
                 "leading zeros, is in the study already (added less than an hour ago).",
                 "If P001 is meant, use that label.");
  inputs.participant = "P001";
  add_completed(SessionMode::run);
  expect_noticed(
      State::fine,
      "P001 has completed 1 of 2 planned sessions of this protocol, the latest less than an "
      "hour ago.",
      "");

  // A later version of the protocol plans its own sessions, and its participant knows the task.
  std::string later = twice;
  later.replace(later.find("1.0.0"), 5, "1.1.0");
  write_protocol(later);
  expect_noticed(State::look,
                 "P001 has completed session 2 of this protocol (study data, version 1.0.0, less "
                 "than an hour ago); a further session begins.",
                 "For another participant, use another label.");
}

TEST_F(SessionChecks, HoldStimuliToTheirSidecars) {
  EXPECT_EQ(check("stimuli").state, State::fine);
  std::ofstream(study / "stimuli" / "grain.png", std::ios::app) << ' ';
  const SessionCheck changed = check("stimuli");
  EXPECT_EQ(changed.state, State::stop);
  EXPECT_NE(changed.text.english().find("grain.png"), std::string::npos) << changed.text.english();
  std::filesystem::remove(study / "stimuli" / "grain.png");
  EXPECT_EQ(check("stimuli").state, State::stop);
}

/// The built-in models, of which "stochastic" stands for this build of a plug-in.
ModelRegistry with_build(const std::string& sha256) {
  ModelRegistry models{};
  const ModelRegistry built_in = built_in_models();
  for (ForceModel model : built_in.models()) {
    if (model.declaration.id == "stochastic") model.plugin = PluginOrigin{"noise.so", sha256};
    models.add(std::move(model));
  }
  return models;
}

TEST_F(SessionChecks, WarnOfAttemptsWithAnotherBuildOfAPlugin) {
  const std::string former(64, 'a');
  const std::string loaded(64, 'b');
  models = with_build(former);
  run_virtual(false);
  inputs.mode = SessionMode::simulate;
  EXPECT_EQ(check("stimuli").state, State::fine);
  models = with_build(loaded);
  const SessionCheck warned = check("stimuli");
  EXPECT_EQ(warned.state, State::look);
  EXPECT_NE(warned.text.english().find(former), std::string::npos) << warned.text.english();
  EXPECT_NE(warned.text.english().find(loaded), std::string::npos);
  EXPECT_NE(warned.remedy.english().find("Raise the version"), std::string::npos);
  inputs.mode = SessionMode::run;
  EXPECT_EQ(check("stimuli").state, State::fine) << "analysed separately";
}

TEST_F(SessionChecks, RefuseWhatTheDeviceCannotDo) {
  std::string text = small_protocol();
  text.replace(text.find("\"textures\""), 0, R"("device": {"force_limit_N": 12}, )");
  write_protocol(text);
  const SessionCheck weak = check("device");
  EXPECT_EQ(weak.state, State::stop);
  EXPECT_NE(weak.text.english().find("force_limit_N"), std::string::npos) << weak.text.english();
}

TEST_F(SessionChecks, CompareWithWhatTheSimulatedDeviceStandsFor) {
  inputs.mode = SessionMode::pilot;
  inputs.device = "simulated:delta.3";
  EXPECT_NE(check("device").text.english().find("exerts up to 20.0 N at up to 4000 Hz"),
            std::string::npos)
      << check("device").text.english();
  inputs.device = "simulated:falcon";
  EXPECT_EQ(check("device").state, State::fine);
  std::string text = small_protocol();
  text.replace(text.find("\"textures\""), 0, R"("device": {"force_limit_N": 9}, )");
  write_protocol(text);
  EXPECT_EQ(check("device").state, State::stop);
  inputs.device = "simulated";
  EXPECT_EQ(check("device").state, State::fine);
  inputs.device = "simulated:gamma.3";
  EXPECT_NE(check("device").text.english().find("falcon, delta.3"), std::string::npos);
}

// What a virtual hand strokes, and what nobody feels, are no study data.
TEST_F(SessionChecks, RefuseStudyDataOfADeviceThatNobodyFeels) {
  for (const char* const device : {"simulated", "simulated:falcon", "mouse"}) {
    inputs.device = device;
    inputs.mode = SessionMode::run;
    const SessionCheck line = check("device");
    EXPECT_EQ(line.state, State::stop) << device;
    EXPECT_NE(line.remedy.english().find("in Pilot"), std::string::npos) << device;
    EXPECT_EQ(line.remedy.english().find("--"), std::string::npos) << "an option of a command";
    EXPECT_NE(line.remedy.english().find("device.input_only"), std::string::npos) << device;
    inputs.mode = SessionMode::pilot;
    EXPECT_EQ(check("device").state, State::fine) << device;
  }
}

TEST_F(SessionChecks, TakeAMouseForStudyDataWhereTheProtocolNeedsNoForce) {
  std::string text = small_protocol();
  text.replace(text.find("\"textures\""), 0, R"("device": {"input_only": true}, )");
  write_protocol(text);
  inputs.mode = SessionMode::run;
  inputs.device = "mouse";
  EXPECT_EQ(check("device").state, State::fine) << check("device").text.english();
  EXPECT_NE(check("device").text.english().find("the participant feels nothing"),
            std::string::npos);
  inputs.device = "simulated";
  EXPECT_EQ(check("device").state, State::stop) << "a virtual hand is nobody's";
  EXPECT_EQ(check("device").remedy.english().find("device.input_only"), std::string::npos)
      << "it is set";
}

/// As when somebody has pressed "Try this device".
std::shared_ptr<TriedDevice> tried_falcon() {
  TriedDevice tried{.device = "falcon:A7", .rate_Hz = 1000.0};
  tried.capability = {.name = "falcon",
                      .model = "Novint Falcon",
                      .serial = "A7",
                      .peak_force_N = 9.0,
                      .maximum_rate_Hz = 1000.0};
  tried.quality.ticks = 300;
  tried.quality.period_mean_s = 0.001;
  return std::make_shared<TriedDevice>(tried);
}

TEST_F(SessionChecks, NeedAnAttachedDeviceToBeTriedByAPersonsWish) {
  inputs.device = "falcon:A7";
  inputs.pacing = RunPacing::real_time;
  EXPECT_EQ(check("device").state, State::stop);
  EXPECT_NE(check("device").text.english().find("“falcon:A7” has not been tried"),
            std::string::npos);
  inputs.device_name = "Novint Falcon (A7)";
  EXPECT_NE(check("device").text.english().find("“Novint Falcon (A7)” has not been tried"),
            std::string::npos);
  EXPECT_EQ(check("force_zero").id, "absent");
  EXPECT_EQ(check("rate").id, "absent");

  inputs.tried = tried_falcon();
  EXPECT_EQ(check("device").state, State::fine) << check("device").text.english();
  EXPECT_NE(check("device").text.english().find("“Novint Falcon (A7)” exerts up to 9.0 N"),
            std::string::npos);
  EXPECT_EQ(check("force_zero").text.english(), "Exactly 0 N was sent in 300 ticks.");
  EXPECT_EQ(check("rate").state, State::fine);

  auto pushes = tried_falcon();
  pushes->strongest_N = 0.2;
  inputs.tried = pushes;
  EXPECT_EQ(check("force_zero").state, State::stop);

  auto refused = std::make_shared<TriedDevice>(TriedDevice{.failure = "It has no power."});
  inputs.tried = refused;
  EXPECT_EQ(check("device").text.english(), "It has no power.");
  EXPECT_EQ(check("force_zero").id, "absent");

  inputs.tried = tried_falcon();
  inputs.device_blocker = "It is used by another program.";
  EXPECT_EQ(check("device").state, State::stop);
  EXPECT_EQ(check("device").text.english(), "It is used by another program.");
}

TEST_F(SessionChecks, SayThatAnAttachedDeviceWithoutMotorsGivesNoForce) {
  TriedDevice tried = *tried_falcon();
  tried.device = inputs.device = "spacemouse:SM042";
  tried.capability = {.name = "spacemouse",
                      .model = "3Dconnexion SpaceMouse Compact",
                      .serial = "SM042",
                      .sensed_degrees_of_freedom = 6,
                      .actuated_degrees_of_freedom = 0};
  inputs.tried = std::make_shared<TriedDevice>(tried);
  inputs.pacing = RunPacing::real_time;
  inputs.mode = SessionMode::pilot;
  EXPECT_EQ(check("device").state, State::fine) << "whatever force the protocol asks for";
  EXPECT_NE(check("device").text.english().find("the participant feels nothing"),
            std::string::npos);
  EXPECT_EQ(check("calibration").text.english(), "Not needed: the device exerts no force.");
  inputs.mode = SessionMode::run;
  EXPECT_EQ(check("device").state, State::stop);
  EXPECT_NE(check("device").remedy.english().find("device.input_only"), std::string::npos);
}

class RehearsedChecks : public SessionChecks {
 protected:
  void SetUp() override {
    SessionChecks::SetUp();
    inputs.device = "falcon:A7";
    inputs.tried = tried_falcon();
    inputs.rehearsal = std::make_shared<RehearsalMemory>();
    ask_for("");
  }
  /// `days` ago.
  void measure(double days, double friction_N, const std::string& in_place_of = "",
               const std::vector<DeviceTrait>& not_known = {}) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto now_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
    DeviceProfile profile{
        .name = in_place_of.empty() ? "falcon" : "simulated",
        .model = in_place_of,
        .serial = in_place_of.empty() ? "A7" : "",
        .is_simulated = !in_place_of.empty(),
        .measured_utc = utc_text(now_ns - static_cast<std::int64_t>(days * 86400.0 * 1e9)),
        .rate_Hz = 1000.0,
        .workspace_minimum_m = glm::dvec3(-reach_m),
        .workspace_maximum_m = glm::dvec3(reach_m),
        .items = {{.name = "friction_N", .status = DeviceItem::Status::pass, .value = friction_N}},
        .not_known = not_known};
    leave_out_unknown(profile);
    std::filesystem::create_directories(study / "profiles");
    write_file(profile_path(study, profile), json_text_of(profile), Overwrite::allow);
  }
  std::vector<SessionCheck> rehearsed() {
    std::vector<SessionCheck> lines = check_session(inputs, models, {}, [this](double) { ++told; });
    std::erase_if(lines, [](const SessionCheck& line) { return line.id != "rehearsal"; });
    return lines;
  }
  /// Of surfaces without friction: that of the others is beyond what a Falcon renders.
  void ask_for(const std::string& of_device) {
    std::string text = small_protocol();
    text.insert(text.find("\"textures\""),
                "\"material\": {\"friction\": 0}, \"device\": {" + of_device + "}, ");
    write_protocol(text);
  }

  double reach_m = 1.0;  ///< of the profile
  int told = 0;          ///< of the comparison's progress
};

TEST_F(RehearsedChecks, SayHowADeviceIsMeasuredThatNobodyHasMeasured) {
  EXPECT_EQ(check("calibration").state, State::look);
  EXPECT_NE(
      check("calibration").remedy.english().find("asperity device-test \"falcon:A7\" --study"),
      std::string::npos);
  EXPECT_TRUE(rehearsed().empty());
  ask_for(R"("profile_maximum_age_days": 30)");
  EXPECT_EQ(check("calibration").state, State::stop) << "as the session would refuse it";
  inputs.driver_options.library = "/opt/sdk.so";
  EXPECT_NE(check("calibration").text.english().find("--library /opt/sdk.so --study"),
            std::string::npos)
      << check("calibration").text.english();
}

TEST_F(RehearsedChecks, TellTheAgeOfTheProfileAndEveryWarningWithBothNumbers) {
  measure(12.0, 0.0);
  EXPECT_EQ(check("calibration").state, State::fine);
  EXPECT_EQ(check("calibration").text.english(),
            "Measured 12 days ago; every stimulus is within the capabilities of the device.");
  measure(0.1, 0.9);
  EXPECT_EQ(check("calibration").text.english(),
            "Measured 2 hours ago; some stimuli exceed the capabilities of the device.");
  const std::vector<SessionCheck> lines = rehearsed();
  ASSERT_EQ(lines.size(), 1U) << "one kind of warning is one line";
  EXPECT_EQ(lines.front().state, State::look);
  EXPECT_NE(lines.front().text.english().find("the device's own friction is 0.900 N"),
            std::string::npos)
      << lines.front().text.english();
}

TEST_F(RehearsedChecks, TellWhatIsNotKnownOfTheDeviceThatASimulatedOneStandsFor) {
  inputs.device = "simulated:delta.3";
  inputs.tried = nullptr;
  EXPECT_EQ(check("calibration").state, State::look) << "nobody has looked at it";
  EXPECT_NE(check("calibration").text.english().find("no profile of this device"),
            std::string::npos)
      << check("calibration").text.english();
  measure(0.1, 0.9, "in place of delta.3", {DeviceTrait::friction, DeviceTrait::damping});
  EXPECT_EQ(check("calibration").state, State::look);
  EXPECT_EQ(check("calibration").text.english(),
            "Measured 2 hours ago; every stimulus is within the known capabilities of the device. "
            "Unknown for delta.3 and not compared: friction, damping.");
  ask_for(R"("limits": {"friction_N": 0.1})");
  const std::string limited = check("calibration").text.english();
  EXPECT_NE(limited.find("is within the known capabilities of the device, but the device does not "
                         "meet the protocol's "
                         "limits. Unknown for delta.3"),
            std::string::npos)
      << limited;
  EXPECT_EQ(check("calibration").state, State::look);
  inputs.device = "simulated";
  EXPECT_EQ(check("calibration").state, State::fine) << "it stands for none";
}

// Nobody knows a lambda.7's workspace; a session keeps to the one that its driver tells.
TEST_F(RehearsedChecks, CallNothingUncomparedThatWasCompared) {
  inputs.device = "simulated:lambda.7";
  inputs.tried = nullptr;
  measure(0.1, 0.0, "in place of lambda.7", {DeviceTrait::workspace, DeviceTrait::peak_force});
  EXPECT_EQ(check("calibration").text.english(),
            "Measured 2 hours ago; every stimulus is within the capabilities of the device.");
  EXPECT_EQ(check("calibration").state, State::fine);
  reach_m = 0.001;
  measure(0.1, 0.0, "in place of lambda.7", {DeviceTrait::workspace, DeviceTrait::friction});
  const std::string text = check("calibration").text.english();
  EXPECT_TRUE(text.ends_with("and not compared: friction.")) << text;
  ASSERT_FALSE(rehearsed().empty());
  EXPECT_NE(rehearsed().front().text.english().find("The surface lies from"), std::string::npos);
}

TEST_F(RehearsedChecks, RefuseWhatTheProtocolRefuses) {
  ask_for(R"("profile_maximum_age_days": 30)");
  measure(31.0, 0.0);
  EXPECT_EQ(check("calibration").state, State::stop);
  EXPECT_NE(check("calibration").text.english().find("31.0 days old"), std::string::npos);
  measure(1.0, 0.9);
  EXPECT_EQ(check("calibration").state, State::fine);
  ask_for(R"("refuse_rehearsal_warnings": true)");
  EXPECT_EQ(check("calibration").state, State::stop);
  EXPECT_NE(check("calibration").text.english().find("0.900 N"), std::string::npos);
  inputs.mode = SessionMode::simulate;
  inputs.participant = "virtual0001";
  inputs.device = "simulated";
  EXPECT_EQ(check("calibration").state, State::fine) << "no participant feels it";
}

TEST_F(RehearsedChecks, TellWhichLimitsOfTheProtocolTheDeviceDoesNotKeep) {
  ask_for(R"("limits": {"friction_N": 0.0001, "latency_s": 0.01})");
  measure(1.0, 0.0002);
  EXPECT_EQ(check("calibration").text.english(),
            "Measured 24 hours ago; every stimulus is within the capabilities of the device, but "
            "the device does not meet the protocol's limits.");
  const std::vector<SessionCheck> lines = rehearsed();
  ASSERT_EQ(lines.size(), 2U) << "each limit is one line";
  EXPECT_EQ(lines[0].text.english(),
            "The protocol requires a device whose friction_N is at most 0.000100; the measured "
            "value is 0.000200. Choose another device, or relax the requirement in the protocol.");
  EXPECT_NE(lines[1].text.english().find("latency_s"), std::string::npos);
  ask_for(R"("limits": {"friction_N": 0.0001}, "refuse_rehearsal_warnings": true)");
  EXPECT_EQ(check("calibration").state, State::stop);
  EXPECT_NE(check("calibration").text.english().find("0.000200"), std::string::npos)
      << check("calibration").text.english();
}

// Which matters more than a limit.
TEST_F(RehearsedChecks, TellAFailedStopThoughALimitIsBrokenToo) {
  ask_for(R"("limits": {"friction_N": 0.0001})");
  measure(1.0, 0.0002);
  EXPECT_EQ(check("calibration").text.english().find("failed an item"), std::string::npos);
  DeviceProfile profile = latest_profile(study, {.name = "falcon", .serial = "A7"}).value();
  profile.items.push_back({.name = "zero_after_stop", .status = DeviceItem::Status::fail});
  write_file(profile_path(study, profile), json_text_of(profile), Overwrite::allow);
  EXPECT_EQ(check("calibration").state, State::look);
  EXPECT_NE(check("calibration").text.english().find("failed an item"), std::string::npos)
      << check("calibration").text.english();
}

TEST_F(RehearsedChecks, CompareAnewOnlyWhereSomethingHasChanged) {
  measure(2.0, 0.9);
  rehearsed();
  EXPECT_GT(told, 0);
  told = 0;
  inputs.participant = "P002";
  EXPECT_EQ(rehearsed().size(), 1U) << "it is known";
  EXPECT_EQ(told, 0) << "and not computed";
  measure(1.0, 0.0);
  EXPECT_TRUE(rehearsed().empty()) << "it was measured again";
  EXPECT_GT(told, 0);
  told = 0;
  write_protocol(small_protocol() + "\n");
  rehearsed();
  EXPECT_GT(told, 0) << "it is another protocol";
}

TEST_F(RehearsedChecks, SayThatASessionLastRanOnAnotherDevice) {
  std::stop_source stop;
  stop.request_stop();
  run_virtual(false, stop.get_token());
  inputs.participant = "virtual0001";
  inputs.mode = SessionMode::simulate;
  inputs.resume = true;
  EXPECT_NE(check("device").text.english().find("last ran on “simulated"), std::string::npos)
      << check("device").text.english();
  inputs.device = "simulated";
  inputs.tried = nullptr;
  EXPECT_EQ(check("device").text.english().find("last ran on"), std::string::npos);
}

TEST_F(SessionChecks, WantRoomForTwoSessions) {
  EXPECT_EQ(disk_check({.wanted_bytes = 1e9, .free_bytes = 2e9}).state, State::fine);
  EXPECT_EQ(disk_check({.wanted_bytes = 1e9, .free_bytes = 1.9e9}).state, State::look);
  const SessionCheck full = disk_check({.wanted_bytes = 1e9, .free_bytes = 3e8});
  EXPECT_EQ(full.state, State::stop);
  EXPECT_EQ(full.text.english(), "300 MB free; this session requires at most 1.0 GB.");
}

TEST_F(SessionChecks, ExpectTheBytesThatAWholeSessionWouldRecord) {
  const Protocol protocol = read_small_protocol(models, small_protocol());
  const double total_s = cost_of(protocol, make_plan(protocol, {1, 0})).total_s;
  // 8 bytes of time and 32 floats, a thousand times a second.
  EXPECT_DOUBLE_EQ(recording_bytes(protocol), total_s * 1000.0 * (8 + 32 * 4));
}

TEST_F(SessionChecks, SayThatOneScreenShowsBothWindows) {
  inputs.screens = 1;
  EXPECT_EQ(check("screens").state, State::look);
  inputs.mode = SessionMode::simulate;
  EXPECT_EQ(check("screens").state, State::fine);
}

TEST_F(SessionChecks, HoldTheNoiseToTheDeclaredLevelInARun) {
  ask_for_noise();
  // Nobody hears it: a run has to get it from another source, and somebody to answer for that.
  EXPECT_EQ(check("masking_noise").state, State::stop);
  EXPECT_NE(check("masking_noise").text.english().find("no sound output"), std::string::npos);
  EXPECT_NE(check("masking_noise").remedy.english().find("from another source"), std::string::npos);
  inputs.noise.measured_dBA = 65.0;
  EXPECT_EQ(check("masking_noise").state, State::stop);
  inputs.noise.verified_by = "MW";
  EXPECT_EQ(check("masking_noise").state, State::look);
  EXPECT_EQ(check("masking_noise").text.english(),
            "There is no sound output here; the noise comes from another source, 65.0 dB(A) at the "
            "ear, verified by MW.");
  inputs.noise.measured_dBA = 70.0;
  EXPECT_EQ(check("masking_noise").state, State::stop);
  inputs.noise = {};
  inputs.mode = SessionMode::pilot;
  EXPECT_EQ(check("masking_noise").state, State::look);
  inputs.mode = SessionMode::run;

  inputs.sound_card = true;
  EXPECT_EQ(check("masking_noise").state, State::stop);  // not measured
  inputs.noise.measured_dBA = 66.9;
  EXPECT_EQ(check("masking_noise").state, State::stop);  // by whom?
  inputs.noise.verified_by = "MW";
  EXPECT_EQ(check("masking_noise").state, State::fine);
  inputs.noise.measured_dBA = 67.1;
  EXPECT_EQ(check("masking_noise").state, State::stop);
  inputs.mode = SessionMode::pilot;
  EXPECT_EQ(check("masking_noise").state, State::look);
}

TEST_F(SessionChecks, SayThatNobodyHearsTheCuesOfABlindfoldSession) {
  std::string text = small_protocol();
  text.insert(text.find("\"textures\""), R"("environment": {"vision": "blindfold"}, )");
  text.replace(text.find("\"photograph\""), 12, "\"memory\"");  // nothing is seen to compare with
  write_protocol(text);
  EXPECT_EQ(check("masking_noise").state, State::look) << check("protocol").text.english();
  EXPECT_NE(check("masking_noise").text.english().find("hears no cues"), std::string::npos);
  inputs.mode = SessionMode::simulate;
  EXPECT_EQ(check("masking_noise").state, State::fine);
  inputs.mode = SessionMode::run;
  inputs.sound_card = true;
  EXPECT_EQ(check("masking_noise").state, State::fine);
}

TEST_F(SessionChecks, RefuseARunWhoseGuidingTonesNobodyHears) {
  write_protocol(
      small_protocol("", R"(, "guidance": "tones", "normal_force_N": {"minimum": 0.5})"));
  EXPECT_EQ(check("masking_noise").state, State::stop) << check("protocol").text.english();
  EXPECT_NE(check("masking_noise")
                .text.english()
                .find("silence would indicate that force and speed are correct"),
            std::string::npos);
  inputs.mode = SessionMode::pilot;
  EXPECT_EQ(check("masking_noise").state, State::look);
  inputs.mode = SessionMode::simulate;
  EXPECT_EQ(check("masking_noise").state, State::fine);
  inputs.mode = SessionMode::run;
  inputs.sound_card = true;
  EXPECT_EQ(check("masking_noise").state, State::fine);
}

TEST_F(SessionChecks, ReadTheNoiseThatAProtocolDeclares) {
  ask_for_noise();
  const MaskingNoise noise =
      declared_noise(read_small_protocol(models, read_file(study / "protocols" / "small.json")));
  EXPECT_EQ(noise.kind, MaskingNoise::Kind::pink);
  EXPECT_EQ(noise.declared_dBA, 65.0);
}

TEST_F(SessionChecks, WarnWhereOtherUsersCanReadTheStudy) {
  using std::filesystem::perms;
  const perms open = perms::owner_all | perms::others_read | perms::others_exec;
  EXPECT_EQ(check("study").state, State::fine);
  std::filesystem::permissions(folder.path(), open);
  std::filesystem::permissions(study, open);
  const SessionCheck warning = check("study");
  EXPECT_EQ(warning.state, State::look);
  EXPECT_NE(warning.text.english().find("Every user of this computer can read it"),
            std::string::npos)
      << warning.text.english();
  EXPECT_EQ(warning.remedy.english(),
            "To keep other users out, run: chmod o-rwx " + study.string());
  std::filesystem::permissions(study, perms::owner_all);
  EXPECT_EQ(check("study").state, State::fine);
}

TEST_F(SessionChecks, RefuseAStudyThatCannotBeWritten) {
  // A file where the folder of the locks has to be: refused to every user, root included.
  std::filesystem::remove_all(study / "locks");
  std::ofstream(study / "locks") << "not a folder";
  const SessionCheck check_line = check("study");
  EXPECT_EQ(check_line.state, State::stop);
  EXPECT_NE(check_line.text.english().find("locks"), std::string::npos)
      << check_line.text.english();
}

}  // namespace
}  // namespace asperity
