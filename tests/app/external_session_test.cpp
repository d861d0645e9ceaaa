// Sessions whose levels an external program states: the same levels as a built-in procedure where it has the same rule, resumed after
// an interruption anywhere, and held where the program fails.

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/types.h>
#include <sys/wait.h>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/processes/child_process.h"
#include "app/session/levels/supplied_steps.h"
#include "app/tasks/session_run.h"
#include "app/tasks/unfinished_session.h"
#include "app/words/event_kinds.h"
#include "app/words/phrase_of_error.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Two interleaved tracks in each of two conditions, and a trial of a fixed block after them.
std::string tracks_with(const std::string& procedure) {
  return R"({
  "format": "asperity.protocol/1", "kind": "discrimination", "design": "improved", "name": "tracks",
  "version": "1.0.0", "title": "Tracks",
  "consent": {"version": "1.0", "statement": "I take part of my own free will."},
  "factors": {"stroking": {"levels": ["short", "long"]}},
  "stimuli": {"grating": {"model": "sinusoid", "parameters": {"amplitude_m": 5e-5, "wavelength_m": 0.0025}}},
  "explorations": {"short": {"minimum_contact_s": 0.1, "maximum_contact_s": 2},
                   "long": {"minimum_contact_s": 0.15, "maximum_contact_s": 2}},
  "blocks": {
    "tracks": {
      "crossed": ["stroking"], "exploration": {"factor": "stroking"},
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard",
               "levels_percent": {"lowest": 5, "highest": 100, "step": 5}},
      "procedure": )" +
         procedure + R"(,
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "positions": "balanced", "pause_before_trial_s": 0, "pause_between_surfaces_s": 0,
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}},
    "after": {
      "phase": "practice", "exploration": "short", "pause_before_trial_s": 0,
      "vary": {"parameter": "amplitude_m", "of": "comparison", "relative_to": "standard", "levels_ratio": [2]},
      "presented": [{"role": "standard", "stimulus": "grating"}, {"role": "comparison", "stimulus": "grating"}],
      "question": {"name": "rougher", "prompt": "Which is rougher?", "judgement": "performance"}}},
  "flow": [{"run": "tracks"}, {"run": "after"}]})";
}

/// Trials of each track, and of a session with these tracks.
constexpr int kTrialsOfLongTrack = 6;
constexpr int kStatedTrials = 8;
constexpr int kAllTrials = 9;

std::string staircase() {
  return R"({"method": "transformed_up_down", "down": 1, "up": 1, "steps": [20, 10, 5], "start": 50,
        "stop": {"trials": )" +
         std::to_string(kTrialsOfLongTrack) + R"(}, "tracks": [{}, {}]})";
}

std::string external_staircase(int trials) {
  return R"({"method": "external", "stop": {"trials": )" + std::to_string(trials) +
         R"(}, "tracks": [{}, {}], "settings": {"start": 50, "steps": [4, 2, 1]}})";
}

/// The program of docs/formats/external.md.
std::string documented_program() {
  const std::string page =
      read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/formats/external.md");
  const std::string begin = "```python\n";
  const std::size_t from = page.find(begin) + begin.size();
  return page.substr(from, page.find("```", from) - from);
}

class ExternalSession : public ResumableSession {
 protected:
  void SetUp() override {
    begin(tracks_with(external_staircase(2)));
    write_program(documented_program());
    proportion_correct_ = 0.6;
  }

  void write_program(const std::string& text) { std::ofstream(script()) << text; }
  std::filesystem::path script() const { return folder_ / "program.py"; }
  ConductorSettings settings() const override {
    ExternalProgram program{.file = "/usr/bin/env", .arguments = {"python3", script().string()}};
    program.arguments.insert(program.arguments.end(), arguments_.begin(), arguments_.end());
    return {.record = false, .level_program = program};
  }

  std::vector<EventRow> events_of_kind(const std::string& kind) const {
    std::vector<EventRow> events = study_->events(session_.row.id);
    std::erase_if(events, [&kind](const EventRow& event) { return event.kind != kind; });
    return events;
  }

  std::string log() const {
    return read_file(folder_.path() / "study" / "logs" / session_.row.participant /
                     "session-01_external.log");
  }

  std::vector<std::string> arguments_{};  ///< further ones of the program
};

TEST_F(ExternalSession, OfTheDocumentedProgramHasTheLevelsOfTheSameStaircase) {
  std::vector<std::vector<std::string>> plans{};
  for (const std::string& procedure : {external_staircase(kTrialsOfLongTrack), staircase()}) {
    protocol_ = read_small_protocol(models_, tracks_with(procedure));
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      plans.push_back(uninterrupted(seed));
      EXPECT_EQ(plans.back().size(), 25U);
      EXPECT_EQ(verified_trials(), 25U);
    }
  }
  for (std::size_t seed = 0; seed < 3; ++seed) EXPECT_EQ(plans[seed], plans[seed + 3]);
}

TEST_F(ExternalSession, ContinuesWithTheSameLevelsAfterAnInterruptionAnywhere) {
  protocol_ = read_small_protocol(models_, tracks_with(external_staircase(kTrialsOfLongTrack)));
  EXPECT_EQ(same_plan_after_interruptions(2).size(), 25U);
}

/// What it receives, one line each, is in its log.
constexpr const char* kWritesDown = R"(
import json, sys
for line in sys.stdin:
    sys.stderr.write(line)
    if "ask" in json.loads(line):
        print('{"level": 37}', flush=True)
sys.stderr.write("closed\n")
)";

TEST_F(ExternalSession, TellsAProgramThatIsStartedAgainTheEarlierResponses) {
  write_program(kWritesDown);
  start(1);
  ASSERT_EQ(run_attempts(3).state, SessionState::stopped);
  const std::string before = log();
  EXPECT_THAT(before, AllOf(HasSubstr(R"("asperity":1,"begin")"), HasSubstr(R"("most_trials":2)"),
                            HasSubstr(R"("settings":{"start":50,"steps":[4,2,1]})"),
                            HasSubstr(R"("factors":{"stroking":")"), HasSubstr("closed"),
                            testing::Not(HasSubstr("replayed"))));
  ASSERT_EQ(resume().state, SessionState::completed);
  const std::string after = log().substr(before.size());
  std::size_t replayed = 0;
  for (std::size_t at = after.find("replayed"); at != std::string::npos;
       at = after.find("replayed", at + 1)) {
    ++replayed;
  }
  EXPECT_EQ(replayed, 3U);
  EXPECT_THAT(after, HasSubstr(R"("level":35)")) << "as presented";
  // Every response of the block, also the last one.
  std::size_t told = 0;
  for (std::size_t at = after.find("\"tell\""); at != std::string::npos;
       at = after.find("\"tell\"", at + 1)) {
    ++told;
  }
  EXPECT_EQ(told, static_cast<std::size_t>(kStatedTrials));
}

TEST_F(ExternalSession, StoresTheProgramAndWhatItStated) {
  write_program(kWritesDown);
  start(1);
  ASSERT_EQ(run_attempts(2).state, SessionState::stopped);
  const std::vector<EventRow> programs = events_of_kind(kExternalProgram);
  ASSERT_EQ(programs.size(), 1U);
  EXPECT_EQ(programs.front().text, "env");
  EXPECT_THAT(programs.front().data_json,
              AllOf(HasSubstr(R"("program":"env")"), HasSubstr(sha256_of_file("/usr/bin/env")),
                    HasSubstr(sha256_of_file(script())), HasSubstr("\"python3\"")));
  const std::vector<EventRow> levels = events_of_kind(kExternalLevel);
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_THAT(levels.front().data_json,
              AllOf(HasSubstr(R"("stated":37.0)"), HasSubstr(R"("level":35.0)")));
}

/// States one level of each track, and then its end.
constexpr const char* kEndsAtOnce = R"(
import json, sys
for line in sys.stdin:
    message = json.loads(line)
    if "ask" in message:
        print('{"end": true}' if message["ask"]["step"] > 1 else '{"level": 50}', flush=True)
)";

TEST_F(ExternalSession, EndsATrackWhenTheProgramEndsIt) {
  write_program(kEndsAtOnce);
  EXPECT_EQ(same_plan_after_interruptions(1).size(), 5U) << "four tracks, and the trial after them";
}

TEST_F(ExternalSession, KeepsCatchTrialsWhereTheyAre) {
  std::string text = external_staircase(4);
  text.insert(1, R"("catch_trials": {"level": 100, "every": 4}, )");
  protocol_ = read_small_protocol(models_, tracks_with(text));
  EXPECT_GT(same_plan_after_interruptions(4).size(), 18U)
      << "4 · 4 trials, the one after them, and catch trials";
}

TEST_F(ExternalSession, PresentsTheLevelOfASkippedTrialAgainWithoutAsking) {
  start(1);
  person_.at_question = [this](int question, const Trial& trial) {
    if (question == 2) conductor_->requests().skip("the sample broke");
    if (question == 2) return feels_again(1);
    return correct_reply(trial);
  };
  EXPECT_EQ(run_attempts().state, SessionState::completed);
  EXPECT_EQ(stored_plan().size(), static_cast<std::size_t>(kAllTrials) + 1);
  EXPECT_EQ(events_of_kind(kExternalLevel).size(), static_cast<std::size_t>(kStatedTrials));
  EXPECT_EQ(verified_trials(), static_cast<std::size_t>(kAllTrials) + 1);
}

TEST_F(ExternalSession, IsResumedWhereTheTrialOfAStatedLevelWasNotYetStored) {
  for (const int position : {0, 5}) {
    start(2);
    if (position == 0) {
      study_->end_session(session_.row.id, SessionState::stopped, "2026-01-01T00:00:00.000Z");
    } else {
      ASSERT_EQ(run_attempts(position).state, SessionState::stopped);
    }
    const OpenSession stopped = reopen(*study_, protocol_, stored_session());
    const LevelRequest request = stopped.course->requested().value();
    study_->add_event(session_.row.id,
                      {.time_ns = last_time_ns(*study_, stopped.row) + 1,
                       .kind = kExternalLevel,
                       .data_json = json_of(SuppliedStep{.block_ordinal = request.block_ordinal,
                                                         .of = request.of,
                                                         .step = NextLevel{80.0},
                                                         .stated = 81.0})});
    EXPECT_EQ(verified_trials(), static_cast<std::size_t>(position));
    EXPECT_EQ(resume().state, SessionState::completed);
    const Plan plan = verified_plan();
    ASSERT_EQ(plan.trials.size(), static_cast<std::size_t>(kAllTrials));
    EXPECT_EQ(
        std::get<double>(plan.trials[static_cast<std::size_t>(position)].factors.at("amplitude_m")),
        9e-5);
  }
}

TEST_F(ExternalSession, IsFoundChangedWhereAStoredLevelWasChangedOrRemoved) {
  const auto changed = [this](const std::string& change) {
    start(2);
    EXPECT_EQ(run_attempts().state, SessionState::completed);
    change_store("DROP TRIGGER IF EXISTS event_no_update; UPDATE event SET " + change +
                 " WHERE id = (SELECT max(id) FROM event WHERE kind = 'external_level')");
    try {
      verified_trials();
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string("nothing found");
  };
  EXPECT_THAT(changed(R"(data_json = replace(data_json, '"step":2', '"step":1'))"),
              HasSubstr("comes next"));
  EXPECT_THAT(changed("data_json = replace(data_json, '\"stated\":', '\"stated\":10')"),
              HasSubstr("nearest to the one that the program stated"));
  EXPECT_THAT(changed("data_json = '{}'"), HasSubstr("cannot be read"));
  EXPECT_THAT(changed("kind = 'note'"), HasSubstr("not stored"));
}

// --- failures -----------------------------------------------------------------------------------

struct Failure {
  std::string name{};
  std::string program{};
  std::string message{};
};

/// Each states the level of the first trial, and then fails once; started again it works. `%` is replaced by its failure.
constexpr const char* kFailsOnce = R"(
import json, os, signal, sys, time
mark = sys.argv[0] + ".failed"
asked = 0
for line in sys.stdin:
    if "ask" not in json.loads(line):
        continue
    asked += 1
    if asked == 3 and not os.path.exists(mark):
        open(mark, "w").close()
        %
    print('{"level": 50}', flush=True)
)";

const std::vector<Failure>& failures() {
  static const std::vector<Failure> kFailures{
      {"ends", R"(sys.exit("no more"))", "it ended with status 1, \"no more\""},
      {"is killed", "os.kill(os.getpid(), signal.SIGKILL)", "signal 9 ended it"},
      {"hangs", "time.sleep(60)", "did not answer within 2 s"},
      {"closes its output", "os.close(1); time.sleep(60)", "it closed its standard output"},
      {"writes nonsense", R"(print("fifty", flush=True); continue)", "answered \"fifty\""},
      {"writes another object", R"(print('{"levels": 50}', flush=True); continue)",
       "answered \"{\"levels\""},
      {"states two levels", R"(print('{"level": 5, "level": 20}', flush=True); continue)",
       "answered \"{\"level\": 5, \"level\": 20}\""},
      {"states no number", R"(print('{"level": "50"}', flush=True); continue)", "answered"},
      {"is out of range", R"(print('{"level": 101}', flush=True); continue)",
       "stated the level 101, but the levels of the block lie between 5 and 100"},
      {"reports a problem", R"(print('{"error": "no data"}', flush=True); continue)",
       "reports a problem: no data"},
      {"writes two lines", R"(print('{"level": 50}\n{"level": 55}', flush=True); continue)",
       "more than the one line"},
      {"writes without end", "\n        while True: os.write(1, b'x' * 4096)",
       "bytes without the end of a line"},
      {"writes lines without end", "\n        while True: os.write(1, b'y\\n' * 4096)",
       "more than the one line"}};
  return kFailures;
}

std::string failing_program(const Failure& failure) {
  std::string text = kFailsOnce;
  return text.replace(text.find('%'), 1, failure.program);
}

TEST_F(ExternalSession, WaitsForTheExperimenterAfterEveryFailureAndContinues) {
  links_.experimenter_is_there = true;
  for (const Failure& failure : failures()) {
    SCOPED_TRACE(failure.name);
    const bool hangs = failure.name == "hangs";
    std::string text = external_staircase(2);
    if (hangs) text.insert(1, R"("answer_within_s": 2, )");
    protocol_ = read_small_protocol(models_, tracks_with(text));
    write_program(failing_program(failure));
    std::filesystem::remove(script().string() + ".failed");
    person_.faults_heard.clear();
    start(1);
    person_.at_fault = [] { return Respondent::AfterFault::go_on; };
    EXPECT_EQ(run_attempts().state, SessionState::completed);
    EXPECT_EQ(attempts().size(), static_cast<std::size_t>(kAllTrials)) << "nothing was repeated";
    EXPECT_EQ(verified_trials(), static_cast<std::size_t>(kAllTrials));
    const std::size_t failed = person_.faults_heard.size();
    // On a busy machine an interpreter may need longer than two seconds for its start as well.
    EXPECT_TRUE(failed == 1 || (hangs && failed > 1)) << failed;
    EXPECT_EQ(events_of_kind(kExternalFailure).size(), failed);
    EXPECT_EQ(events_of_kind(kExternalProgram).size(), failed + 1);
    EXPECT_THAT(person_.faults_heard.front(),
                AllOf(HasSubstr("external program env"), HasSubstr(failure.message),
                      HasSubstr("Fix the problem, then resume")));
  }
}

TEST_F(ExternalSession, StopsAfterAFailureWithoutAnExperimenterAndIsResumed) {
  write_program(failing_program(failures().front()));
  start(1);
  const SessionEnd end = run_attempts();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(),
              AllOf(HasSubstr("the levels could not be determined"), HasSubstr("no more")));
  EXPECT_EQ(attempts().size(), 2U);
  EXPECT_EQ(resume().state, SessionState::completed);
  EXPECT_EQ(attempts().size(), static_cast<std::size_t>(kAllTrials));
}

/// A regular file that no one can read from its beginning.
constexpr const char* kUnreadable = "/proc/self/mem";

TEST_F(ExternalSession, WaitsWhereAFileOfTheProgramCannotBeRead) {
  links_.experimenter_is_there = true;
  start(1);
  arguments_ = {kUnreadable};
  person_.at_fault = [this] {
    arguments_.clear();
    return Respondent::AfterFault::end;
  };
  const SessionEnd end = run_attempts();
  EXPECT_EQ(end.state, SessionState::stopped);
  ASSERT_EQ(person_.faults_heard.size(), 1U);
  EXPECT_THAT(person_.faults_heard.front(),
              AllOf(HasSubstr("the file /proc/self/mem cannot be read"),
                    HasSubstr("Fix the problem, then resume")));
  EXPECT_EQ(events_of_kind(kExternalFailure).size(), 1U);
  EXPECT_THAT(events_of_kind(kExternalProgram), IsEmpty()) << "it was not started";
  EXPECT_EQ(resume().state, SessionState::completed);
}

TEST_F(ExternalSession, IsResumedWithoutTheProgramOnceEveryLevelIsStored) {
  for (const int position : {kStatedTrials - 1, kStatedTrials}) {
    SCOPED_TRACE(position);
    start(2);
    ASSERT_EQ(run_attempts(position).state, SessionState::stopped);
    const std::string& label = session_.row.participant;
    const auto unfinished = unfinished_of(unfinished_sessions(*study_, protocol_), label, {});
    ASSERT_TRUE(unfinished);
    EXPECT_EQ(unfinished->lacks_levels, position < kStatedTrials);
    SessionRun session_run{};
    session_run.participant = study_->participant(label).value();
    session_run.unfinished = unfinished->row;
    make_rig({});
    rig_->move_clock_to(last_time_ns(*study_, unfinished->row));
    const auto resume_without = [&] {
      return run_on_rig(*study_, protocol_, *builder_, this_program(), session_run, *rig_, &person_,
                        {}, {})
          .state;
    };
    if (unfinished->lacks_levels) {
      EXPECT_THROW(resume_without(), PhrasedError);
      EXPECT_EQ(stored_session().state, SessionState::stopped);
    } else {
      EXPECT_EQ(resume_without(), SessionState::completed);
      EXPECT_EQ(verified_trials(), static_cast<std::size_t>(kAllTrials));
    }
  }
}

TEST_F(ExternalSession, IsStoppedByTheExperimenterWhileItWaits) {
  write_program("raise SystemExit('not installed')\n");
  links_.experimenter_is_there = true;
  start(1);
  person_.at_fault = [] { return Respondent::AfterFault::end; };
  const SessionEnd end = run_attempts();
  EXPECT_EQ(end.state, SessionState::stopped);
  EXPECT_THAT(end.reason.english(), HasSubstr("not installed"));
  EXPECT_THAT(attempts(), IsEmpty());
  write_program(documented_program());
  EXPECT_EQ(resume().state, SessionState::completed);
}

/// Writes more than a pipe holds after its statement of a level, and then makes a file.
constexpr const char* kWarnsAfterAnswering = R"(
import json, sys
asked = 0
for line in sys.stdin:
    if "ask" not in json.loads(line):
        continue
    asked += 1
    print('{"level": 50}', flush=True)
    sys.stderr.write("w" * 300000)
    sys.stderr.flush()
    open(sys.argv[0] + ".warned" + str(asked), "w").close()
)";

TEST_F(ExternalSession, ReadsTheErrorsOfAProgramDuringATrial) {
  write_program(kWarnsAfterAnswering);
  start(1);
  bool has_warned = false;
  person_.at_ask = [this, &has_warned](const Wait& wait) {
    // The session's time stands still for the program, which needs some of the machine's.
    constexpr int kMostLooks = 400;
    const std::string mark = script().string() + ".warned1";
    for (int look = 0; look < kMostLooks && !std::filesystem::exists(mark); ++look) {
      std::this_thread::sleep_for(std::chrono::milliseconds(25));
      wait(0.02);
    }
    has_warned = std::filesystem::exists(mark);
    return chooses(0);
  };
  ASSERT_EQ(run_attempts(1).state, SessionState::stopped);
  EXPECT_TRUE(has_warned);
  EXPECT_GE(log().size(), 300'000U);
}

/// Writes to its standard error once its input is closed.
constexpr const char* kTakesLeave = R"(
import json, sys
for line in sys.stdin:
    if "ask" in json.loads(line):
        print('{"level": 50}', flush=True)
sys.stderr.write("goodbye\n")
)";

TEST_F(ExternalSession, StoresItsEndAlsoWhereTheErrorsOfAProgramCannotBeKept) {
  write_program(kTakesLeave);
  for (const int trials : {3, 1000}) {  // the program is ended with the session, and with its block
    SCOPED_TRACE(trials);
    start(1);
    const std::filesystem::path logs = folder_.path() / "study" / "logs";
    std::filesystem::create_directories(logs);
    std::ofstream(logs / session_.row.participant) << "not a folder";
    const SessionState state =
        trials < kAllTrials ? SessionState::stopped : SessionState::completed;
    EXPECT_EQ(run_attempts(trials).state, state);
    EXPECT_EQ(stored_session().state, state);
    EXPECT_EQ(
        events_of_kind(state == SessionState::completed ? "session_completed" : "session_stopped")
            .size(),
        1U);
    const std::vector<EventRow> failures = events_of_kind(kExternalFailure);
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_THAT(failures.front().text,
                AllOf(HasSubstr("cannot be kept"), HasSubstr(session_.row.participant)));
  }
}

TEST_F(ExternalSession, KeepsTheErrorsOfAProgramForATerminalThatDoesNotObeyThem) {
  write_program(R"(
import json, sys
for line in sys.stdin:
    if "ask" in json.loads(line):
        sys.stderr.write("\x1b[31mred\tink\n")
        sys.stderr.flush()
        print('{"level": 50}', flush=True)
)");
  start(1);
  run_attempts(1);
  EXPECT_THAT(log(), testing::StartsWith("\\u001b[31mred\tink\n"));
}

TEST_F(ExternalSession, LimitsWhatItKeepsOfTheErrorsOfAProgram) {
  write_program(R"(
import json, sys
for line in sys.stdin:
    if "ask" in json.loads(line):
        sys.stderr.write("z" * 3000000)
        sys.stderr.flush()
        print('{"level": 50}', flush=True)
)");
  start(1);
  ASSERT_EQ(run_attempts(2).state, SessionState::stopped);
  EXPECT_LT(log().size(), 1'200'000U);
  EXPECT_THAT(log(), HasSubstr("further output is not kept"));
}

TEST(ChildProcess, KeepsTheIdentifierOfAProcessThatHasEndedUntilItsGroupIsEnded) {
  pid_t process = 0;
  {
    ChildProcess child("/bin/sh", {"-c", "echo $$; exit 3"});
    constexpr int kMostLooks = 1000;
    for (int look = 0; look < kMostLooks && !child.has_ended(); ++look) child.pump(0.1);
    ASSERT_EQ(child.ending().how, ChildProcess::End::exited);
    EXPECT_EQ(child.ending().number, 3);
    process = std::stoi(child.output());
    EXPECT_EQ(::kill(process, 0), 0) << "not reaped";
  }
  int status = 0;
  EXPECT_EQ(::waitpid(process, &status, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD) << "reaped";
}

TEST(ExternalProgram, IsRefusedWhereASessionCannotUseIt) {
  const ModelRegistry models = built_in_models();
  const Protocol needs = read_small_protocol(models, tracks_with(external_staircase(2)));
  const Protocol has_own = read_small_protocol(models, tracks_with(staircase()));
  const auto complaint = [](const Protocol& protocol, std::optional<ExternalProgram> program) {
    const auto found = complaint_about_program(protocol, program);
    return found ? found->english() : std::string();
  };
  EXPECT_THAT(complaint(needs, {}), HasSubstr("--external PROGRAM"));
  EXPECT_EQ(complaint(has_own, {}), "");
  EXPECT_THAT(complaint(has_own, ExternalProgram{.file = "/usr/bin/env"}),
              HasSubstr("takes no levels from an external program"));
  EXPECT_THAT(complaint(needs, ExternalProgram{.file = "/nowhere/staircase"}),
              HasSubstr("does not exist"));
  EXPECT_THAT(complaint(needs, ExternalProgram{.file = "/usr/bin"}), HasSubstr("is not a file"));
  EXPECT_THAT(complaint(needs, ExternalProgram{.file = "/etc/passwd"}),
              HasSubstr("cannot be executed"));
  EXPECT_EQ(complaint(needs, ExternalProgram{.file = "/usr/bin/env"}), "");
  EXPECT_NO_THROW(require_program(needs, ExternalProgram{.file = "/usr/bin/env"}));
  EXPECT_THROW(
      require_program(needs, ExternalProgram{.file = "/usr/bin/env", .arguments = {kUnreadable}}),
      PhrasedError);
}

}  // namespace
}  // namespace asperity
