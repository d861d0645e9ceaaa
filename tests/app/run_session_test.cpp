// The way into a session: who takes part, what was asked before, for which hand.

#include "app/tasks/run_session.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/profiles/device_profile.h"
#include "app/records/session_conditions.h"
#include "app/report/text/study_report.h"
#include "app/tasks/checks/session_checks.h"
#include "app/tasks/protocol_files.h"
#include "app/tasks/session_run.h"
#include "app/tasks/verify/verify_study.h"
#include "app/words/phrase_of_error.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/scripted_session.h"
#include "tests/support/refusal.h"
#include "tests/support/replaced.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

class RunSession : public testing::Test {
 protected:
  RunSession() {
    inputs_.study = folder_.path() / "study";
    make_small_study(inputs_.study);
    inputs_.protocol = inputs_.study / "protocols" / "small.json";
    std::string text = small_protocol();
    text.insert(text.find("\"textures\""), R"("surface": {"centre_m": [0.02, 0, 0]}, )");
    text.replace(text.find("[1, 2, 3]"), 9, "[1]");
    write_file(inputs_.protocol, text, Overwrite::refuse);
    inputs_.participant = "p1";
    inputs_.seed = 5;
    inputs_.mode = SessionMode::pilot;  // a virtual hand holds the simulated device
    inputs_.pacing = RunPacing::stepped;
  }

  SessionEnd run() { return run_session(inputs_, models_, &person_, {}, {}, links_); }
  Study study() const { return Study::open(inputs_.study, Access::read_only); }

  TemporaryFolder folder_{};
  ModelRegistry models_ = built_in_models();
  RunInputs inputs_{};
  ScriptedPerson person_{};
  SessionRequests requests_{};
  SessionLinks links_{.requests = &requests_};
};

TEST_F(RunSession, StoresWhatTheSimulatedDeviceStoodFor) {
  inputs_.device = "simulated:falcon";
  EXPECT_EQ(run().state, SessionState::completed);
  const SessionRow session = study().sessions().at(0);
  EXPECT_EQ(session.device, "simulated in place of Novint Falcon");
  EXPECT_THAT(session.device_json, testing::HasSubstr("\"position_resolution_m\":3.8e-05"));
  EXPECT_THAT(session.device_json,
              testing::HasSubstr("\"slew_limit_N_per_ms\":1.0,\"slew_limit_N_m_per_ms\":0.02"));
  EXPECT_THAT(session.device_json,
              testing::HasSubstr("Properties of the real device that are unknown to this program: "
                                 "continuous force, position noise, friction"));
  inputs_.device = "simulated:gamma.3";
  EXPECT_THROW(run(), std::runtime_error);
}

TEST(DeviceJson, StatesTheLimitsOfTheDeviceInUse) {
  RigSettings settings{};
  settings.limits.slew_N = 0.5;
  settings.limits.slew_N_m = 0.01;
  const SteppedRig rig(settings, 0);
  EXPECT_THAT(device_json(rig.capability(), rig.limits()),
              testing::HasSubstr("\"slew_limit_N_per_ms\":0.5,\"slew_limit_N_m_per_ms\":0.01"));
}

TEST_F(RunSession, StoresParametersAndMaterialThatTheProtocolDoesNotState) {
  EXPECT_EQ(run().state, SessionState::completed);
  const std::vector<AttemptRow> attempts = study().attempts(study().sessions().at(0).id);
  ASSERT_FALSE(attempts.empty());
  for (const PresentationRow& surface : attempts.front().presentations) {
    EXPECT_THAT(surface.parameters_json, testing::HasSubstr(R"("friction_law":"elastoplastic")"));
    EXPECT_EQ(surface.stiffness_N_per_m, 500.0);
    EXPECT_EQ(surface.friction, 0.2);
  }
}

// --- study data come from a device that a participant holds and feels -----------------------------

TEST_F(RunSession, RefusesStudyDataOnADeviceThatAVirtualHandHolds) {
  inputs_.mode = SessionMode::run;
  const std::string refusal = refusal_of<PhrasedError>([&] { run(); });
  EXPECT_THAT(refusal, testing::HasSubstr("a virtual hand holds the device \"simulated"));
  EXPECT_THAT(refusal, testing::HasSubstr("--mode pilot"));
  EXPECT_THAT(refusal, testing::HasSubstr("device.input_only"));
  EXPECT_THAT(person_.forms, testing::IsEmpty());
  EXPECT_TRUE(study().participants().empty());
  EXPECT_TRUE(study().sessions().empty());
  inputs_.is_virtual = true;
  inputs_.participant = "virtual0001";
  EXPECT_EQ(run_session(inputs_, models_, nullptr, {}, {}).state, SessionState::completed)
      << "a virtual participant is nobody's study data";
}

TEST_F(RunSession, StoresThatNothingSounded) {
  EXPECT_EQ(run().state, SessionState::completed);
  std::vector<std::string> noise{};
  for (const EventRow& event : study().events(study().sessions().at(0).id)) {
    if (event.kind == "masking_noise") noise.push_back(event.data_json);
  }
  EXPECT_THAT(noise, testing::ElementsAre(R"({"kind":"none","heard":false})"));
}

TEST_F(RunSession, StatesAndStoresThatASessionIsResumedOnAnotherDevice) {
  person_.at_question = [this](int, const Trial&) -> Reply {
    requests_.stop_after(StopAfter::trial);
    return chooses(0);
  };
  std::string text = small_protocol();
  write_file(inputs_.protocol, text, Overwrite::allow);
  EXPECT_EQ(run().state, SessionState::stopped);
  std::vector<std::string> told{};
  inputs_.resumed = [&](const Phrase& circumstance) { told.push_back(circumstance.english()); };
  inputs_.resume = true;
  EXPECT_EQ(run().state, SessionState::stopped) << "the same device: nothing to state";
  EXPECT_THAT(told, testing::IsEmpty());
  inputs_.device = "simulated:falcon";
  person_.at_question = {};
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(told, testing::ElementsAre(testing::StartsWith(
                        "the session last ran on simulated mass, spring and damper and is resumed "
                        "on simulated in place of Novint Falcon;")));
  const Study stored = study();
  const SessionRow row = stored.sessions().at(0);
  std::vector<std::string> changes{};
  for (const EventRow& event : stored.events(row.id)) {
    if (event.kind == kDeviceChanged) changes.push_back(event.text);
  }
  EXPECT_THAT(changes, testing::ElementsAre("simulated in place of Novint Falcon"));
  const auto stretches = recorded_stretches(row, stored.events(row.id), stored.attempts(row.id));
  ASSERT_EQ(stretches.size(), 3U);
  EXPECT_EQ(stretches[1].device.text, "simulated mass, spring and damper");
  EXPECT_EQ(stretches[2].device.text, "simulated in place of Novint Falcon");
}

TEST_F(RunSession, NeedsADeviceThatWasMeasuredLatelyWhereTheProtocolSaysSoAndStoresWhatItIs) {
  const auto ask_for = [&](const std::string& device) {
    std::string text = small_protocol();
    text.insert(text.find("\"textures\""), "\"device\": {" + device + "}, ");
    text.replace(text.find("[1, 2, 3]"), 9, "[1]");
    write_file(inputs_.protocol, text, Overwrite::allow);
  };
  const auto refusal = [&] { return refusal_of<PhrasedError>([&] { run(); }); };
  std::filesystem::create_directories(inputs_.study / "profiles");
  const auto measure = [&](const std::string& utc) {
    const DeviceProfile profile{
        .name = "simulated",
        .measured_utc = utc,
        .rate_Hz = 1000.0,
        .workspace_minimum_m = glm::dvec3(-1.0),
        .workspace_maximum_m = glm::dvec3(1.0),
        .items = {{.name = "friction_N", .status = DeviceItem::Status::pass, .value = 0.9}}};
    write_file(profile_path(inputs_.study, profile), json_text_of(profile), Overwrite::refuse);
  };
  ask_for(R"("profile_maximum_age_days": 30)");
  EXPECT_THAT(refusal(), testing::HasSubstr("asperity device-test simulated"));
  measure("2025-11-01T10:00:00.000Z");  // sessions on a simulated clock begin on 2026-01-01
  EXPECT_THAT(refusal(), testing::HasSubstr("days old, but the protocol allows at most 30"));
  measure("2025-12-20T10:00:00.000Z");
  EXPECT_EQ(run().state, SessionState::completed);
  std::string kinds{};
  for (const EventRow& event : study().events(study().sessions().at(0).id)) {
    if (event.kind == "rehearsal") {
      EXPECT_THAT(event.text, testing::HasSubstr("0.900 N"));
    }
    kinds += event.kind + ' ';
  }
  EXPECT_THAT(kinds, testing::HasSubstr("device_profile rehearsal"));
  inputs_.participant = "p2";
  ask_for(R"("refuse_rehearsal_warnings": true)");
  EXPECT_THAT(refusal(), testing::HasSubstr("that the device does not meet: "));
  EXPECT_EQ(study().sessions().size(), 1U);
}

TEST_F(RunSession, AsksNobodyAnythingWhereTheProtocolDoesNotTakeTheDevice) {
  for (const char* const refused :
       {R"("profile_maximum_age_days": 30)", R"("refuse_rehearsal_warnings": true)",
        R"("force_limit_N": 19)"}) {
    std::string text = small_protocol();
    text.insert(text.find("\"textures\""), std::string("\"device\": {") + refused + "}, ");
    write_file(inputs_.protocol, text, Overwrite::allow);
    inputs_.device = "simulated:falcon";
    EXPECT_THROW(run(), PhrasedError) << refused;
    EXPECT_THAT(person_.forms, testing::IsEmpty()) << refused;
    EXPECT_TRUE(study().participants().empty()) << refused;
  }
}

/// A profile of the simulated device, whose friction hides textures: there is something to warn of.
void keep_profile_with_friction(const std::filesystem::path& study) {
  const DeviceProfile profile{
      .name = "simulated",
      .measured_utc = "2025-12-20T10:00:00.000Z",
      .rate_Hz = 1000.0,
      .workspace_minimum_m = glm::dvec3(-1.0),
      .workspace_maximum_m = glm::dvec3(1.0),
      .items = {{.name = "friction_N", .status = DeviceItem::Status::pass, .value = 0.9}}};
  std::filesystem::create_directories(study / "profiles");
  write_file(profile_path(study, profile), json_text_of(profile), Overwrite::refuse);
}

TEST_F(RunSession, TellsEveryWarningBeforeAnybodyIsAsked) {
  keep_profile_with_friction(inputs_.study);
  std::size_t told = 0;
  inputs_.rehearsed = [&](const RehearsedDevice& device) {
    told = device.warnings.size();
    EXPECT_THAT(person_.forms, testing::IsEmpty());
  };
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_GT(told, 0U);
  EXPECT_THAT(person_.forms, testing::Not(testing::IsEmpty()));
}

// What was compared until a stop is no whole comparison, and says neither yes nor no.
TEST_F(RunSession, EndsAtOnceWhenStoppedWhileTheDeviceIsCompared) {
  keep_profile_with_friction(inputs_.study);
  int told = 0;
  inputs_.rehearsed = [&](const RehearsedDevice&) { ++told; };
  std::stop_source source;
  inputs_.comparing = [&source](double) { source.request_stop(); };
  EXPECT_THROW(run_session(inputs_, models_, &person_, source.get_token(), {}, links_),
               RespondentGone);
  EXPECT_TRUE(source.stop_requested());
  EXPECT_EQ(told, 0);
  EXPECT_THAT(person_.forms, testing::IsEmpty());
  EXPECT_TRUE(study().sessions().empty());
}

TEST_F(RunSession, DoesNotRepeatTheComparisonThatTheChecklistHasMade) {
  keep_profile_with_friction(inputs_.study);
  const auto memory = std::make_shared<RehearsalMemory>();
  const CheckInputs checked{.study = inputs_.study,
                            .protocol = inputs_.protocol,
                            .participant = inputs_.participant,
                            .mode = inputs_.mode,
                            .pacing = inputs_.pacing,
                            .rehearsal = memory};
  int told = 0;
  check_session(checked, models_, {}, [&told](double) { ++told; });
  EXPECT_GT(told, 0);
  told = 0;
  inputs_.comparing = [&told](double) { ++told; };
  std::size_t warnings = 0;
  inputs_.rehearsed = [&](const RehearsedDevice& device) { warnings = device.warnings.size(); };
  inputs_.rehearsal = memory;
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_EQ(told, 0);
  EXPECT_GT(warnings, 0U);
  inputs_.participant = "p2";
  inputs_.rehearsal = nullptr;
  run();
  EXPECT_GT(told, 0);
}

TEST_F(RunSession, AsksForConsentUnlessThePersonHasGivenIt) {
  run();
  EXPECT_THAT(person_.forms, testing::Contains("consent"));
  inputs_.participant = "p2";
  inputs_.consent = "I take part.";
  inputs_.new_person = ParticipantRow{.label = "p2", .age_years = 31.0};
  person_.forms.clear();
  run();
  EXPECT_THAT(person_.forms, testing::Not(testing::Contains("consent")));
  const ParticipantRow stored = study().participant("p2").value();
  EXPECT_EQ(stored.age_years, 31.0);
  EXPECT_FALSE(stored.created_utc.empty());
  EXPECT_TRUE(study().sessions().at(1).consent_utc);
}

TEST_F(RunSession, RefusesANewPersonOfAnotherLabel) {
  inputs_.new_person = ParticipantRow{.label = "p2"};
  EXPECT_THROW(run(), std::runtime_error);
  EXPECT_TRUE(study().participants().empty());
}

FormAnswer think_forever(const Question&, const Wait& wait) {
  for (;;) wait(1.0);
}

TEST_F(RunSession, EndsAtOnceWhenAbortedWhileConsentIsAsked) {
  person_.at_form = think_forever;
  requests_.abort("the window was closed");
  EXPECT_THROW(run(), RespondentGone);
  EXPECT_TRUE(study().participants().empty());
  EXPECT_TRUE(study().sessions().empty());
}

TEST_F(RunSession, EndsAtOnceWhenStoppedWhileConsentIsAsked) {
  std::stop_source source;
  person_.at_form = [&source](const Question& question, const Wait& wait) {
    source.request_stop();
    return think_forever(question, wait);
  };
  EXPECT_THROW(run_session(inputs_, models_, &person_, source.get_token(), {}), RespondentGone);
}

TEST_F(RunSession, StoresThatItWasMirroredAndReplaysSo) {
  inputs_.mirrored = true;
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_TRUE(study().sessions().front().mirrored);
  // Every recorded force is rendered again, where the hand met it.
  Study stored = study();
  const VerifyResult verified = verify_study(stored, models_, true, {}, [](double) {});
  EXPECT_THAT(verified.problems, testing::IsEmpty());
  EXPECT_EQ(verified.recordings_replayed, 1);
}

// Neither bars nor a window: what the protocol asks for is not what happened.
TEST_F(RunSession, HasAReportThatClaimsNoGuidanceWhichNobodySaw) {
  std::string text =
      small_protocol("", R"(, "guidance": "bars", "normal_force_N": {"minimum": 0.5})");
  text.replace(text.find("[1, 2, 3]"), 9, "[1]");
  write_file(inputs_.protocol, text, Overwrite::allow);
  EXPECT_EQ(run().state, SessionState::completed);
  std::string words{};
  const Report report = study_report(study());
  for (const ReportChapter& chapter : report.chapters) {
    for (const ReportSection& section : chapter.sections) {
      for (const ReportPart& part : section.parts) {
        if (const auto* told = std::get_if<ReportText>(&part)) words += told->text + '\n';
      }
    }
  }
  EXPECT_THAT(
      words, testing::HasSubstr("There was no such guidance in the only session (at a terminal)."));
  EXPECT_THAT(words, testing::Not(testing::HasSubstr("Participants were shown")));
}

// --- coming back to an interrupted session ---------------------------------------------------------

/// The small protocol with a check and another text before its trials, and `resume` as given.
std::string protocol_with_texts(const std::string& resume) {
  std::string text = small_protocol();
  const std::string first = R"({"screen": "Welcome."}, )";
  text.insert(text.find(first) + first.size(), R"({"check": "device"}, {"screen": "The keys."}, )");
  text.insert(text.find("\"flow\""), resume);
  return text;
}

class ResumedSession : public RunSession {
 protected:
  /// Stopped after its first trial; what is read from then on is of the resumed session.
  void interrupt(const std::string& protocol) {
    write_file(inputs_.protocol, protocol, Overwrite::allow);
    person_.at_question = [this](int, const Trial&) -> Reply {
      requests_.stop_after(StopAfter::trial);
      return chooses(0);
    };
    requests_.note("a note of the first stretch");
    ASSERT_EQ(run().state, SessionState::stopped);
    person_.at_question = {};
    person_.texts.clear();
    inputs_.resume = true;
  }
};

constexpr const char* kContinues =
    "The session continues where it was interrupted. Confirm when you are ready.";

TEST_F(ResumedSession, BeginsWithTheLastTextTheChecksAndAScreenToStartFrom) {
  interrupt(protocol_with_texts(""));
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(person_.texts, testing::ElementsAre("The keys.", kContinues, "Thank you."));
  std::vector<std::string> kinds{};
  for (const EventRow& event : study().events(study().sessions().at(0).id)) {
    if (event.kind == "session_resumed" || event.kind == "check_passed") {
      kinds.push_back(event.kind);
    }
  }
  EXPECT_THAT(kinds, testing::ElementsAre("check_passed", "session_resumed", "check_passed"));
}

TEST_F(ResumedSession, BeginsWithTheTextsOfTheProtocol) {
  interrupt(protocol_with_texts(R"("resume": {"screens": ["Welcome back.", "Sit as before."]}, )"));
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(person_.texts,
              testing::ElementsAre("Welcome back.", "Sit as before.", kContinues, "Thank you."));
}

TEST_F(ResumedSession, BeginsWithNoTextWhereTheProtocolWantsNone) {
  interrupt(protocol_with_texts(R"("resume": {"screens": []}, )"));
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(person_.texts, testing::ElementsAre(kContinues, "Thank you."));
}

// It is read before the session, and not again when the session is resumed.
TEST_F(ResumedSession, HasTheConsentOnceAsTheParticipantReadIt) {
  inputs_.consent = "I take part in three trials.";
  interrupt(replaced(protocol_with_texts(""), "I take part of my own free will.",
                     "I take part in {trials} trials."));
  EXPECT_EQ(run().state, SessionState::completed);
  std::vector<std::string> read{};
  for (const EventRow& event : study().events(study().sessions().at(0).id)) {
    if (event.kind == "text_as_read") read.push_back(event.text);
  }
  EXPECT_THAT(read, testing::ElementsAre("I take part in three trials."));
}

TEST_F(ResumedSession, HasTheEarlierNotesAndTime) {
  interrupt(protocol_with_texts(""));
  SessionMonitor monitor{};
  links_.monitor = &monitor;
  EXPECT_EQ(run().state, SessionState::completed);
  const std::shared_ptr<const SessionFacts> facts = monitor.facts();
  EXPECT_THAT(facts->earlier_notes, testing::ElementsAre(Phrase("a note of the first stretch")));
  EXPECT_GT(facts->earlier_s, 0.5) << "the trial that was done";
}

TEST_F(ResumedSession, NeedsAReasonWhereItIsOlderThanTheProtocolHasIt) {
  write_file(inputs_.protocol, protocol_with_texts(R"("resume": {"maximum_age_hours": 24}, )"),
             Overwrite::allow);
  {
    const Protocol protocol = load_protocol(inputs_.protocol, models_, inputs_.study);
    Study store = Study::open(inputs_.study, Access::read_write);
    store.add_participant({.label = "p1", .created_utc = "2026-01-01T00:00:00.000Z"});
    const SteppedRig rig(rig_settings_for(protocol, {}), 0);
    const OpenSession session = begin_session(store, protocol, "p1",
                                              {.mode = SessionMode::pilot,
                                               .seed = 5,
                                               .pacing = "real_time",
                                               .scheduling = "none",
                                               .device = rig.capability(),
                                               .started_utc = "2026-01-01T00:00:00.000Z",
                                               .clock_zero_ns = 1'000'000'000},
                                              this_program());
    store.end_session(session.row.id, SessionState::stopped, "2026-01-01T00:10:00.000Z");
  }
  inputs_.pacing = RunPacing::real_time;
  inputs_.resume = true;
  const std::string refusal = refusal_of<PhrasedError>([&] { run(); });
  EXPECT_THAT(refusal, testing::HasSubstr("the session last ran"));
  EXPECT_THAT(refusal, testing::HasSubstr("within 24 h"));
  EXPECT_THAT(refusal, testing::HasSubstr("--late-reason"));
  EXPECT_EQ(study().sessions().at(0).state, SessionState::stopped);

  inputs_.late_reason = "was ill for a week";
  requests_.stop_after(StopAfter::trial);
  EXPECT_EQ(run().state, SessionState::stopped);
  std::vector<EventRow> late{};
  for (const EventRow& event : study().events(study().sessions().at(0).id)) {
    if (event.kind == kResumedLate) late.push_back(event);
  }
  ASSERT_EQ(late.size(), 1U);
  EXPECT_EQ(late[0].text, "was ill for a week");
  EXPECT_THAT(late[0].data_json, testing::HasSubstr("\"maximum_age_hours\":24.0"));
}

TEST_F(RunSession, IsNotGoneOnWithWhereTheProtocolEndedIt) {
  write_file(inputs_.protocol, practised_protocol("end_session"), Overwrite::allow);
  person_.at_question = [](int, const Trial& trial) { return incorrect_reply(trial); };
  EXPECT_TRUE(run().as_the_protocol_says);
  inputs_.resume = true;
  EXPECT_THROW(run(), std::runtime_error);
  inputs_.resume = false;
  // And another one does not wait for the first to be resumed.
  EXPECT_TRUE(run().as_the_protocol_says);
  EXPECT_EQ(study().sessions().size(), 2U);
}

}  // namespace
}  // namespace asperity
