// A study gives back what was put into it, and refuses what is no study.

#include "results_schema/study.h"

#include <atomic>
#include <fstream>
#include <thread>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/hashes/sha256.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/results_schema/sync_watch.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(Study, IsMadeInANewOrAnEmptyFolder) {
  const TemporaryFolder folder;
  Study study = Study::create(folder.path() / "a" / "b", "one");
  EXPECT_EQ(study.name(), "one");
  EXPECT_EQ(study.access(), Access::read_write);
  EXPECT_TRUE(Study::exists(study.folder()));
  std::filesystem::create_directory(folder / "empty");
  EXPECT_EQ(Study::create(folder / "empty", "two").name(), "two");
  std::filesystem::create_directory(folder / "seen");
  std::ofstream(folder / "seen/.DS_Store") << "of a desktop";
  EXPECT_EQ(Study::create(folder / "seen", "three").name(), "three");
}

TEST(Study, IsNotMadeInAFolderThatHoldsSomething) {
  const TemporaryFolder folder;
  std::ofstream(folder / "letter.txt") << "dear";
  EXPECT_THAT(refusal_of<ResultsError>([&] { Study::create(folder.path(), "x"); }),
              HasSubstr("is not empty"));
  EXPECT_THAT(refusal_of<ResultsError>([&] { Study::create(folder / "letter.txt", "x"); }),
              HasSubstr("it is a file"));
  for (const char* const hidden : {"repository/.git", "home/.cache"}) {
    std::filesystem::create_directories(folder / hidden);
    const std::filesystem::path parent = (folder / hidden).parent_path();
    EXPECT_THAT(refusal_of<ResultsError>([&] { Study::create(parent, "x"); }),
                HasSubstr("is not empty"));
    EXPECT_FALSE(Study::exists(parent));
  }
  EXPECT_FALSE(Study::exists(folder.path()));
  EXPECT_THROW(Study::create(folder / "nameless", ""), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder / "nameless"));
}

// The second program removes nothing of the first.
TEST(Study, IsMadeOnceWhereTwoFindTheFolderEmpty) {
  for (int time = 0; time < 20; ++time) {
    const TemporaryFolder folder;
    std::atomic<int> made = 0;
    const auto make = [&] {
      if (refusal_of<ResultsError>([&] { Study::create(folder.path(), "x"); }).empty()) ++made;
    };
    {
      const std::jthread one(make);
      const std::jthread other(make);
    }
    EXPECT_EQ(made.load(), 1);
    EXPECT_EQ(Study::open(folder.path(), Access::read_only).name(), "x");
  }
}

// Each commit: the first in a log also syncs the beginning of the log, whatever is asked of the others.
TEST(Study, HasSyncedAnAttemptWhenItReturns) {
  const TemporaryFolder folder;
  StudyWithSession made = study_with_session(folder / "s", 3);
  for (int trial = 1; trial <= 3; ++trial) {
    const SyncWatch watch;
    made.study.add_attempt(made.session_id, some_attempt(trial));
    EXPECT_THAT(watch.synced(), testing::Contains(folder / "s/study.sqlite-wal")) << trial;
  }
}

TEST(Study, GivesBackParticipantsByLabel) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  study.add_participant(some_participant("P02"));
  study.add_participant({.label = "P01"});
  const std::vector<ParticipantRow> rows = study.participants();
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].label, "P01");
  EXPECT_FALSE(rows[0].is_virtual);
  EXPECT_EQ(rows[0].age_years, std::nullopt);
  EXPECT_THAT(rows[0].created_utc, testing::MatchesRegex("....-..-..T..:..:.*Z"));
  const ParticipantRow wanted = some_participant("P02");
  EXPECT_TRUE(rows[1].is_virtual);
  EXPECT_EQ(rows[1].age_years, wanted.age_years);
  EXPECT_EQ(rows[1].sex, wanted.sex);
  EXPECT_EQ(rows[1].handedness, wanted.handedness);
  EXPECT_EQ(rows[1].answers_json, wanted.answers_json);
  EXPECT_EQ(rows[1].created_utc, wanted.created_utc);
  EXPECT_EQ(study.participant("P02")->label, "P02");
  EXPECT_EQ(study.participant("P03"), std::nullopt);
}

TEST(Study, RefusesALabelThatIsNotLettersAndDigits) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  for (const std::string& label : {std::string(), std::string("../x"), std::string("a'; DROP"),
                                   std::string("a b"), std::string("é"), std::string(33, 'a')}) {
    EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_participant({.label = label}); }),
                HasSubstr("1 to 32 letters and digits"))
        << label;
  }
  study.add_participant({.label = std::string(32, 'a')});
  EXPECT_THAT(
      refusal_of<ResultsError>([&] { study.add_participant({.label = std::string(32, 'a')}); }),
      HasSubstr("there is a participant of this label"));
}

TEST(Study, KeepsAProtocolOncePerContent) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  const std::string source("{\"name\": \"ü\"}\r\n\0", 17);
  const std::int64_t id = study.add_protocol(some_protocol(source));
  EXPECT_EQ(study.add_protocol(some_protocol(source)), id);
  EXPECT_NE(study.add_protocol(some_protocol(source + " ")), id);
  EXPECT_EQ(study.protocols().size(), 2U);
  const ProtocolRow row = study.protocol(id);
  EXPECT_EQ(row.source, source);
  EXPECT_EQ(row.source_sha256, sha256_of(source));
  EXPECT_EQ(row.kind, "selection");
  EXPECT_EQ(row.design, "chapter");
  ProtocolRow wrong = some_protocol();
  wrong.source += "x";
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_protocol(wrong); }),
              HasSubstr("does not have the SHA-256"));
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.protocol(99); }), HasSubstr("has no protocol"));
}

TEST(Study, GivesBackASessionWithItsFilesAndPlan) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  study.add_participant(some_participant());
  SessionRow wanted = some_session(study.add_protocol(some_protocol()));
  wanted.files = {{.path = "stimuli/a.png", .sha256 = sha256_of("a"), .bytes = 1},
                  {.path = "stimuli/b.png", .sha256 = sha256_of("b"), .bytes = 2}};
  wanted.mirrored = true;
  const std::int64_t id = study.add_session(wanted, some_plan(2));
  const SessionRow row = study.session(id);
  EXPECT_EQ(row.id, id);
  EXPECT_EQ(row.participant, "P01");
  EXPECT_EQ(row.session, 1);
  EXPECT_EQ(row.protocol_id, wanted.protocol_id);
  EXPECT_EQ(row.mode, SessionMode::simulate);
  EXPECT_EQ(row.state, SessionState::open);
  EXPECT_EQ(row.seed, wanted.seed);
  EXPECT_EQ(row.generator, wanted.generator);
  EXPECT_EQ(row.counterbalance_row, 2);
  EXPECT_EQ(row.group_level, "haptic");
  EXPECT_TRUE(row.mirrored);
  EXPECT_EQ(row.expected_trials, std::nullopt);
  EXPECT_EQ(row.program_version, wanted.program_version);
  EXPECT_EQ(row.program_commit, wanted.program_commit);
  EXPECT_EQ(row.program_build, wanted.program_build);
  EXPECT_EQ(row.program_sha256, wanted.program_sha256);
  EXPECT_EQ(row.instruction_set, wanted.instruction_set);
  EXPECT_EQ(row.os, wanted.os);
  EXPECT_EQ(row.device, wanted.device);
  EXPECT_EQ(row.device_json, wanted.device_json);
  EXPECT_EQ(row.pacing, wanted.pacing);
  EXPECT_EQ(row.scheduling, wanted.scheduling);
  EXPECT_EQ(row.rate_Hz, wanted.rate_Hz);
  EXPECT_EQ(row.started_utc, wanted.started_utc);
  EXPECT_EQ(row.clock_zero_ns, wanted.clock_zero_ns);
  EXPECT_EQ(row.ended_utc, std::nullopt);
  EXPECT_EQ(row.consent_version, wanted.consent_version);
  EXPECT_EQ(row.consent_utc, wanted.consent_utc);
  EXPECT_EQ(row.observer_json, wanted.observer_json);
  ASSERT_EQ(row.files.size(), 2U);
  EXPECT_EQ(row.files[1].path, "stimuli/b.png");
  EXPECT_EQ(row.files[1].sha256, sha256_of("b"));
  EXPECT_EQ(row.files[1].bytes, 2);
  const std::vector<PlannedTrialRow> plan = study.plan(id);
  ASSERT_EQ(plan.size(), 2U);
  EXPECT_EQ(plan[1].trial, 2);
  EXPECT_EQ(plan[1].block, "main");
  EXPECT_EQ(plan[1].block_ordinal, 1);
  EXPECT_EQ(plan[1].phase, "main");
  EXPECT_EQ(plan[1].repetition, 1);
  EXPECT_EQ(plan[1].factors_json, R"({"texture":"metal"})");
  EXPECT_EQ(plan[1].plan_json, R"({"trial":2})");
}

TEST(Study, GivesBackTheTrialsOfAProcedureAndRefreshers) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  study.add_participant(some_participant());
  SessionRow session = some_session(study.add_protocol(some_protocol()));
  session.expected_trials = 7;
  const std::int64_t id = study.add_session(session, some_plan(1));
  std::vector<PlannedTrialRow> added = some_plan(3);
  added.erase(added.begin());
  for (PlannedTrialRow& trial : added) trial.phase = "practice";
  added[0].track = 2;
  added[0].step = 1;
  added[1].repetition = 0;
  added[1].is_catch = true;
  study.add_trials(id, added);
  EXPECT_EQ(study.session(id).expected_trials, 7);
  const std::vector<PlannedTrialRow> plan = study.plan(id);
  ASSERT_EQ(plan.size(), 3U);
  EXPECT_FALSE(plan[0].track);
  EXPECT_EQ(plan[1].track, 2);
  EXPECT_EQ(plan[1].step, 1);
  EXPECT_FALSE(plan[1].is_catch);
  EXPECT_TRUE(plan[2].is_catch);

  study.begin_segment(id, 0);
  study.add_attempt(id, some_attempt(2));
  AttemptRow refresher = some_attempt(2, 2);
  refresher.purpose = AttemptPurpose::refresher;
  study.add_attempt(id, refresher);
  const std::vector<AttemptRow> attempts = study.attempts(id);
  ASSERT_EQ(attempts.size(), 2U);
  EXPECT_EQ(attempts[0].purpose, AttemptPurpose::trial);
  EXPECT_EQ(attempts[1].purpose, AttemptPurpose::refresher);
}

TEST(Study, NumbersTheSessionsOfAParticipant) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  study.add_participant(some_participant("B"));
  study.add_participant(some_participant("A"));
  const std::int64_t protocol_id = study.add_protocol(some_protocol());
  study.add_session(some_session(protocol_id, "B"), some_plan(1));
  study.add_session(some_session(protocol_id, "A"), some_plan(1));
  SessionRow second = some_session(protocol_id, "B");
  second.session = 3;
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_session(second, {}); }),
              HasSubstr("has session 2 as the next one of participant B, not session "));
  second.session = 2;
  study.add_session(second, some_plan(1));
  EXPECT_THAT(
      refusal_of<ResultsError>([&] { study.add_session(some_session(protocol_id, "C"), {}); }),
      HasSubstr("has no participant C"));
  std::vector<std::string> order;
  for (const SessionRow& row : study.sessions()) {
    order.push_back(row.participant + std::to_string(row.session));
  }
  EXPECT_THAT(order, ElementsAre("A1", "B1", "B2"));
}

TEST(Study, AddsASessionWithItsWholePlanOrNotAtAll) {
  const TemporaryFolder folder;
  Study study = Study::create(folder / "s", "x");
  study.add_participant(some_participant());
  const SessionRow session = some_session(study.add_protocol(some_protocol()));
  std::vector<PlannedTrialRow> plan = some_plan(3);
  plan[2].trial = 2;
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_session(session, plan); }),
              HasSubstr("trial"));
  plan = some_plan(3);
  plan[2].plan_json = "{";
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_session(session, plan); }),
              HasSubstr("plan_json"));
  SessionRow outside = session;
  outside.files = {{.path = "../a.png", .sha256 = sha256_of("a"), .bytes = 1}};
  EXPECT_THAT(refusal_of<ResultsError>([&] { study.add_session(outside, {}); }),
              HasSubstr("not a path inside"));
  EXPECT_TRUE(study.sessions().empty());
}

TEST(Study, GivesBackAnAttemptWithAllThatHangsOnIt) {
  const TemporaryFolder folder;
  auto [study, session_id] = study_with_session(folder / "s", 1);
  AttemptRow wanted = some_attempt(1);
  wanted.recording = RecordingRow{.path = "recordings/a",
                                  .format = "asperity.recording/1",
                                  .sha256 = sha256_of("r"),
                                  .records = 1500,
                                  .bytes = 4000};
  const std::int64_t id = study.add_attempt(session_id, wanted);
  const std::vector<AttemptRow> rows = study.attempts(session_id);
  ASSERT_EQ(rows.size(), 1U);
  const AttemptRow& row = rows[0];
  EXPECT_EQ(row.id, id);
  EXPECT_EQ(row.trial, 1);
  EXPECT_EQ(row.attempt, 1);
  EXPECT_EQ(row.segment, 1);
  EXPECT_EQ(row.outcome, AttemptOutcome::answered);
  EXPECT_TRUE(row.valid);
  EXPECT_EQ(row.invalid_reason, std::nullopt);
  EXPECT_TRUE(row.flagged);
  EXPECT_EQ(row.flag_reason, wanted.flag_reason);
  EXPECT_EQ(row.onset_ns, wanted.onset_ns);
  EXPECT_EQ(row.offset_ns, wanted.offset_ns);

  ASSERT_EQ(row.presentations.size(), 2U);
  const PresentationRow& first = row.presentations[0];
  EXPECT_EQ(first.position, 1);
  EXPECT_EQ(first.role, "alternative");
  EXPECT_EQ(first.item, "A");
  EXPECT_EQ(first.stimulus, "metal");
  EXPECT_EQ(first.model, "height_map");
  EXPECT_EQ(first.model_version, "1");
  EXPECT_EQ(first.texture, "stimuli/metal.png");
  EXPECT_EQ(first.parameters_json, R"({"height_scale":1.5})");
  EXPECT_EQ(first.assets, wanted.presentations[0].assets);
  EXPECT_EQ(asset_sha256(first.assets, "tool"), sha256_of("ball"));
  EXPECT_EQ(asset_sha256(first.assets, "toolbox"), std::nullopt);
  ASSERT_EQ(first.limits.size(), 2U);
  EXPECT_EQ(first.limits[1].kind, "too_fast");
  EXPECT_EQ(first.limits[1].ticks, 12);
  EXPECT_EQ(first.visits, some_attempt(1).presentations[0].visits);
  EXPECT_EQ(first.stiffness_N_per_m, 450.0);
  EXPECT_EQ(first.friction, 0.25);
  EXPECT_EQ(first.raised_m, 0.001);
  EXPECT_TRUE(row.presentations[1].assets.empty());
  EXPECT_TRUE(row.presentations[1].limits.empty());
  EXPECT_TRUE(row.presentations[1].visits.empty());
  EXPECT_EQ(first.instability, wanted.presentations[0].instability);
  EXPECT_TRUE(first.instability);
  EXPECT_FALSE(row.presentations[1].instability);
  EXPECT_EQ(first.seed, "17");
  EXPECT_EQ(first.onset_ns, wanted.onset_ns);
  EXPECT_EQ(first.contact_ns, wanted.onset_ns + 1);
  EXPECT_EQ(first.offset_ns, wanted.offset_ns);
  EXPECT_EQ(first.contact_s, 1.25);
  EXPECT_EQ(first.gaps_in_contact, 4);
  EXPECT_EQ(first.matched_texture_force_N, 0.1);
  EXPECT_EQ(first.achieved_texture_force_N, 0.09);
  EXPECT_EQ(row.presentations[1].onset_ns, std::nullopt);

  ASSERT_EQ(row.responses.size(), 2U);
  const ResponseRow& response = row.responses[0];
  EXPECT_EQ(response.question, "which");
  EXPECT_EQ(response.item, 1);
  EXPECT_EQ(response.answer, "B");
  EXPECT_EQ(response.answer_number, 2.0);
  EXPECT_EQ(response.correct, true);
  EXPECT_EQ(response.options_json, R"(["A","B"])");
  EXPECT_EQ(response.time_ns, wanted.offset_ns);
  EXPECT_EQ(response.from_contact_s, 1.5);
  EXPECT_EQ(response.from_cue_s, 0.5);
  EXPECT_EQ(response.source, "virtual");
  EXPECT_EQ(row.responses[1].question, "confidence");  // in the order in which they were given

  ASSERT_TRUE(row.servo);
  EXPECT_EQ(row.servo->rate_Hz, 1000.0);
  EXPECT_EQ(row.servo->ticks, 1500);
  EXPECT_EQ(row.servo->period_mean_s, 0.001);
  EXPECT_EQ(row.servo->period_sd_s, 0.002);
  EXPECT_EQ(row.servo->period_p50_s, 0.003);
  EXPECT_EQ(row.servo->period_p99_s, 0.004);
  EXPECT_EQ(row.servo->period_p99_9_s, 0.005);
  EXPECT_EQ(row.servo->period_maximum_s, 0.006);
  EXPECT_EQ(row.servo->lateness_p50_s, 0.007);
  EXPECT_EQ(row.servo->lateness_p99_s, 0.008);
  EXPECT_EQ(row.servo->lateness_maximum_s, 0.009);
  EXPECT_EQ(row.servo->execution_p99_s, 0.010);
  EXPECT_EQ(row.servo->execution_maximum_s, 0.011);
  EXPECT_EQ(row.servo->missed_deadlines, 9);
  EXPECT_EQ(row.servo->missed_in_contact, 1);
  EXPECT_EQ(row.servo->gaps_in_contact, 6);
  EXPECT_EQ(row.servo->held_readings, 7);
  EXPECT_EQ(row.servo->saturated_ticks, 2);
  EXPECT_EQ(row.servo->slew_limited_ticks, 3);
  EXPECT_EQ(row.servo->not_finite_ticks, 4);
  EXPECT_EQ(row.servo->lost_records, 5);
  EXPECT_EQ(row.servo->fault, "late");

  ASSERT_EQ(row.compliance.size(), 2U);
  const ComplianceRow& force = row.compliance[0];
  EXPECT_EQ(force.position, 1);
  EXPECT_EQ(force.quantity, "normal_force_N");
  EXPECT_EQ(force.minimum, 0.5);
  EXPECT_EQ(force.maximum, 1.5);
  EXPECT_EQ(force.mean, 1.0);
  EXPECT_EQ(force.sd, 0.1);
  EXPECT_EQ(force.p05, 0.8);
  EXPECT_EQ(force.p50, 1.01);
  EXPECT_EQ(force.p95, 1.2);
  EXPECT_EQ(force.fraction_in_band, 0.97);
  EXPECT_EQ(force.passed, true);
  EXPECT_EQ(row.compliance[1].passed, std::nullopt);

  ASSERT_TRUE(row.recording);
  EXPECT_EQ(row.recording->path, "recordings/a");
  EXPECT_EQ(row.recording->format, "asperity.recording/1");
  EXPECT_EQ(row.recording->sha256, sha256_of("r"));
  EXPECT_EQ(row.recording->records, 1500);
  EXPECT_EQ(row.recording->bytes, 4000);

  ASSERT_EQ(row.events.size(), 2U);
  EXPECT_EQ(row.events[0].time_ns, 5);
  EXPECT_EQ(row.events[0].kind, "contact");
  EXPECT_EQ(row.events[0].text, "first");
  EXPECT_EQ(row.events[0].data_json, R"({"z":1})");

  EXPECT_EQ(study.attempt(id)->responses.size(), 2U);
  EXPECT_EQ(study.attempt(id + 1), std::nullopt);
  EXPECT_EQ(study.session_of(id), session_id);
  EXPECT_THAT(refusal_of<ResultsError>([&, &s = study] { s.session_of(id + 1); }),
              HasSubstr("has no attempt"));
}

TEST(Study, OrdersAttemptsByTrialAndAttemptNotByTheirWriting) {
  const TemporaryFolder folder;
  auto [study, session_id] = study_with_session(folder / "s", 3);
  AttemptRow aborted = some_attempt(1);
  aborted.outcome = AttemptOutcome::aborted;
  aborted.valid = false;
  aborted.invalid_reason = "the participant stopped";
  study.add_attempt(session_id, aborted);
  study.add_attempt(session_id, some_attempt(3));
  study.add_attempt(session_id, some_attempt(2));
  study.add_attempt(session_id, some_attempt(1, 2));
  std::vector<std::string> order;
  for (const AttemptRow& row : study.attempts(session_id)) {
    order.push_back(std::to_string(row.trial) + "." + std::to_string(row.attempt));
    EXPECT_EQ(row.responses.size(), 2U);
    EXPECT_EQ(row.responses[0].time_ns, row.offset_ns);  // hung on the right one
    const bool is_aborted = row.trial == 1 && row.attempt == 1;
    EXPECT_EQ(row.outcome, is_aborted ? AttemptOutcome::aborted : AttemptOutcome::answered);
  }
  EXPECT_THAT(order, ElementsAre("1.1", "1.2", "2.1", "3.1"));
}

TEST(Study, AddsAnAttemptWithEverythingOrNotAtAll) {
  const TemporaryFolder folder;
  auto [study, session_id] = study_with_session(folder / "s", 1);
  AttemptRow attempt = some_attempt(1);
  attempt.events[1].data_json = "not json";  // the last row of all
  EXPECT_THAT(
      refusal_of<ResultsError>([&, &s = study, id = session_id] { s.add_attempt(id, attempt); }),
      HasSubstr("json_valid(data_json)"));
  EXPECT_TRUE(study.attempts(session_id).empty());
  study.add_attempt(session_id, some_attempt(1));
}

TEST(Study, SegmentsAndSessionsEndAndGoOn) {
  const TemporaryFolder folder;
  auto [study, session_id] = study_with_session(folder / "s", 1);
  study.end_segment(session_id, 1, 3'000'000'000, "stopped");
  EXPECT_EQ(study.begin_segment(session_id, 4'000'000'000), 2);
  study.end_session(session_id, SessionState::stopped, "2026-03-01T10:00:00Z");
  EXPECT_EQ(study.session(session_id).state, SessionState::stopped);
  EXPECT_EQ(study.session(session_id).ended_utc, "2026-03-01T10:00:00Z");
  const auto refused = [&, &s = study](auto what) {
    return refusal_of<ResultsError>([&] { what(s); });
  };
  const std::int64_t id = session_id;
  EXPECT_THAT(refused([&](Study& s) { s.begin_segment(id, 5); }),
              HasSubstr("reopen it before it is resumed"));
  EXPECT_THAT(refused([&](Study& s) { s.add_attempt(id, some_attempt(1)); }), HasSubstr("open"));
  EXPECT_THAT(refused([&](Study& s) { s.end_segment(id, 7, 5, "x"); }), HasSubstr("no segment 7"));
  study.reopen_session(session_id);
  EXPECT_EQ(study.session(session_id).state, SessionState::open);
  EXPECT_EQ(study.session(session_id).ended_utc, std::nullopt);
  study.end_session(session_id, SessionState::completed, "2026-03-01T11:00:00Z");
  EXPECT_THAT(refused([&](Study& s) { s.reopen_session(id); }),
              HasSubstr("in the state \"completed\""));
  EXPECT_THAT(refused([&](Study& s) { s.end_session(id, SessionState::stopped, ""); }),
              HasSubstr("already"));
  EXPECT_THROW(study.end_session(id, SessionState::open, ""), std::invalid_argument);
  EXPECT_THAT(refused([&](Study& s) { s.session(99); }), HasSubstr("has no session"));
}

TEST(Study, KeepsAnswersEventsAndSolutions) {
  const TemporaryFolder folder;
  auto [study, session_id] = study_with_session(folder / "s", 1);
  study.add_session_answer(session_id,
                           {.question = "age", .answer = "34", .time_ns = 2, .source = "keyboard"});
  study.add_session_answer(
      session_id, {.question = "hand", .answer = "left", .time_ns = 1, .source = "keyboard"});
  ASSERT_EQ(study.session_answers(session_id).size(), 2U);
  EXPECT_EQ(study.session_answers(session_id)[0].answer, "left");
  study.add_attempt(session_id, some_attempt(1));
  study.add_event(session_id, {.time_ns = 9, .kind = "note", .text = "late"});
  study.add_event(session_id, {.time_ns = 3, .kind = "pause"});
  ASSERT_EQ(study.events(session_id).size(), 2U);  // the attempt's own are in its row
  EXPECT_EQ(study.events(session_id)[0].kind, "pause");
  EXPECT_EQ(study.events(session_id)[1].text, "late");
  EXPECT_EQ(study.solution("k"), std::nullopt);
  study.remember_solution("k", "1");
  study.remember_solution("k", "2");
  EXPECT_EQ(study.solution("k"), "1");
}

}  // namespace
}  // namespace asperity
