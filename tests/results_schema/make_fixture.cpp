// Makes the study of tests/results_schema/fixtures/ for the current schema version: run once per
// version. Usage: asperity_make_fixture_study FOLDER

#include <cstdio>

#include "results_schema/atomic_file.h"
#include "results_schema/recording.h"
#include "tests/results_schema/rows_for_tests.h"

namespace {

/// A code whose argument has arguments.
asperity::StoredWords not_explored() {
  return {"not explored as instructed: normal force of surface 2",
          R"({"code":"exploration_not_compliant","arguments":[{"code":"quantity_of_surface",)"
          R"("arguments":[{"code":"normal_force_N"},"2"]}]})"};
}

}  // namespace

int main(int count, char** arguments) {
  using namespace asperity;
  if (count != 2) {
    std::fputs("usage: asperity_make_fixture_study FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  Study study = Study::create(folder, "fixture");
  write_file(folder / "stimuli" / "metal.txt", "not a picture\n", Overwrite::refuse);
  study.add_participant(some_participant("P01"));
  study.add_participant({.label = "P02", .created_utc = "2026-03-01T09:00:00Z"});
  SessionRow session = some_session(study.add_protocol(some_protocol()));
  session.files = {
      {.path = "stimuli/metal.txt", .sha256 = sha256_of("not a picture\n"), .bytes = 14}};
  session.mirrored = true;
  session.expected_trials = 7;
  const std::int64_t id = study.add_session(session, some_plan(2));
  PlannedTrialRow of_track = some_plan(3).back();
  of_track.phase = "practice";
  of_track.track = 2;
  of_track.step = 1;
  PlannedTrialRow easy = some_plan(4).back();
  easy.phase = "practice";
  easy.repetition = 0;
  easy.is_catch = true;
  study.add_trials(id, {of_track, easy});
  study.begin_segment(id, 1'000'000'000);
  study.add_session_answer(id, {.question = "hand", .answer = "left", .source = "virtual"});

  AttemptRow aborted = some_attempt(1);
  aborted.outcome = AttemptOutcome::aborted;
  aborted.valid = false;
  aborted.invalid_reason = joined(not_explored(), set_aside_because("the participant sneezed"));
  study.add_attempt(id, aborted);
  for (int trial = 1; trial <= 2; ++trial) {
    AttemptRow attempt = some_attempt(trial, trial == 1 ? 2 : 1);
    RecordingWriter writer(
        folder, "recordings/P01-1-" + std::to_string(trial) + ".asprec",
        {.rate_Hz = 10.0,
         .columns = {{.name = "x_m", .unit = "m", .meaning = "position"},
                     {.name = "force_N", .unit = "N", .meaning = "force on the hand"}}});
    for (int i = 0; i < 25; ++i) {
      const float values[] = {0.01F * static_cast<float>(i), 1.0F + static_cast<float>(trial)};
      writer.append(attempt.onset_ns + std::int64_t{100'000'000} * i, values);
    }
    attempt.recording = writer.finish();
    study.add_attempt(id, attempt);
  }
  AttemptRow refresher = some_attempt(3);
  refresher.purpose = AttemptPurpose::refresher;
  study.add_attempt(id, refresher);
  study.add_event(id, {.time_ns = 9'000'000'000, .kind = "note", .text = "done"});
  const StoredWords repeated = set_aside_because("the participant sneezed");
  study.add_event(id, {.time_ns = 9'000'000'000,
                       .kind = "trial_repeated",
                       .text = repeated.text,
                       .data_json = R"({"trial":1,"attempt":1})",
                       .text_json = repeated.json});
  study.end_segment(id, 1, 9'000'000'000, "completed");
  study.end_session(id, SessionState::completed, "2026-03-01T09:30:00Z");
  study.add_decision(id, {.trial = 2,
                          .attempt = 1,
                          .verdict = Verdict::exclude,
                          .reason = "sneezed",
                          .decided_by = "someone",
                          .decided_utc = "2026-03-02T09:00:00Z"});
  study.remember_solution("key", R"({"A_m":0.0001})");
  return 0;
}
