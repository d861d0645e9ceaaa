// kill -9: what was reported done is there, and the session goes on to the same answers.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <iterator>
#include <random>
#include <set>
#include <sstream>
#include <sys/resource.h>
#include <thread>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"
#include "tests/support/eventually.h"

namespace asperity::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

/// "PARTICIPANT SESSION TRIAL ATTEMPT" of every stored attempt, read from outside.
std::set<std::string> stored_attempts(const fs::path& study) {
  sqlite3* database = nullptr;
  EXPECT_EQ(
      sqlite3_open_v2((study / "study.sqlite").c_str(), &database, SQLITE_OPEN_READWRITE, nullptr),
      SQLITE_OK);
  sqlite3_stmt* statement = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(database,
                               "SELECT p.label || ' ' || s.session || ' ' || a.trial || "
                               "' ' || a.attempt FROM attempt a JOIN session s ON s.id = "
                               "a.session_id JOIN participant p ON p.id = s.participant_id",
                               -1, &statement, nullptr),
            SQLITE_OK)
      << sqlite3_errmsg(database);
  std::set<std::string> stored{};
  while (sqlite3_step(statement) == SQLITE_ROW) {
    stored.insert(reinterpret_cast<const char*>(sqlite3_column_text(statement, 0)));
  }
  sqlite3_finalize(statement);
  sqlite3_close(database);
  return stored;
}

void expect_all_stored(const fs::path& study, const std::vector<std::string>& reported) {
  if (reported.empty()) return;
  const std::set<std::string> stored = stored_attempts(study);
  for (const std::string& attempt : reported) EXPECT_TRUE(stored.contains(attempt)) << attempt;
}

/// What does not hold afterwards is what a dead program had begun to record, and nothing else:
/// a hand's movement is not thrown away.
void expect_sound(const fs::path& study, const std::vector<std::string>& plugin = {}) {
  std::vector<std::string> words{"verify", study};
  words.insert(words.end(), plugin.begin(), plugin.end());
  std::istringstream lines(asperity(words).err);
  for (std::string line{}; std::getline(lines, line);) {
    if (line.rfind("asperity: ", 0) != 0) continue;  // progress
    EXPECT_NE(line.find("left by a program that crashed"), std::string::npos) << line;
  }
}

/// Kills the program `after` its n-th done line; before the first one for n = 0. Returns the attempts
/// that it had reported stored.
std::vector<std::string> killed(const std::vector<std::string>& arguments, std::size_t done_before,
                                microseconds after) {
  Invocation invocation{};
  invocation.arguments = arguments;
  Program program(invocation);
  program.read_until([done_before](const std::string&, const std::string& err) {
    return done_lines(err).size() >= done_before;
  });
  program.read_for(after);
  program.send(SIGKILL);
  return stored_attempts_in(program.finish().err);
}

TEST(Kill, LosesNoTrialOfASimulationThatWasReportedDone) {
  // 2 participants × (2 × 5 selections + 2 × 5 recognitions) = 40 trials.
  const SmallStudy small(5);
  constexpr std::size_t kTrials = 40;
  const fs::path never_killed = small.place() / "never_killed";
  copy_stimuli(small, never_killed);
  ASSERT_EQ(asperity(simulate_arguments(small, never_killed, 2, 5)).status, 0);
  const auto expected = exported(never_killed, small.place() / "expected");

  std::mt19937 random(20);
  int after_the_first_done = 0;
  // Each round kills four times, going on in between, and then lets it finish.
  constexpr int kRounds = 2;
  constexpr int kKills = 4;
  for (int round = 0; round < kRounds; ++round) {
    const fs::path study = small.place() / ("killed_" + std::to_string(round));
    copy_stimuli(small, study);
    std::vector<std::string> arguments = simulate_arguments(small, study, 2, 5);
    arguments.emplace_back("--resume");
    std::vector<std::string> done{};
    for (int kill = 0; kill < kKills; ++kill) {
      const std::size_t more = 1 + random() % (kTrials / kKills - 2);
      const auto said = killed(arguments, more, microseconds(random() % 20'000));
      EXPECT_GE(said.size(), more);
      if (!said.empty()) ++after_the_first_done;
      done.insert(done.end(), said.begin(), said.end());
      expect_all_stored(study, done);
    }
    const Outcome finished = asperity(arguments);
    ASSERT_EQ(finished.status, 0) << finished.err;
    const auto tables = exported(study, small.place() / ("tables_" + std::to_string(round)));
    EXPECT_EQ(tables.at("responses.tsv").size(), expected.at("responses.tsv").size());
    EXPECT_EQ(tsv(tables.at("responses.tsv")).column("answer"),
              tsv(expected.at("responses.tsv")).column("answer"));
    EXPECT_EQ(tables.at("trials.tsv"), expected.at("trials.tsv"));
    expect_sound(study);
  }
  EXPECT_GE(after_the_first_done, 7);
}

TEST(Kill, BeforeTheFirstTrialLeavesAStudyThatContinues) {
  const SmallStudy small(1);
  std::mt19937 random(21);
  for (int i = 0; i < 3; ++i) {
    const fs::path study = small.place() / ("early_" + std::to_string(i));
    copy_stimuli(small, study);
    std::vector<std::string> arguments = simulate_arguments(small, study, 1, 5);
    arguments.emplace_back("--resume");
    expect_all_stored(study, killed(arguments, 0, microseconds(random() % 60'000)));
    const Outcome finished = asperity(arguments);
    ASSERT_EQ(finished.status, 0) << finished.err;
    EXPECT_EQ(stored_attempts(study).size(), 4U);
    expect_sound(study);
  }
}

TEST(Kill, LosesNoTrialOfAVirtualRun) {
  const SmallStudy small(15);  // 30 trials
  const auto arguments = [&small](const fs::path& study, bool resume) {
    std::vector<std::string> words{"run",      small.selection(), "--study", study, "--participant",
                                   "standin1", "--virtual",       "--seed",  "9"};
    if (resume) words.emplace_back("--resume");
    return words;
  };
  const fs::path never_killed = small.place() / "never_killed";
  copy_stimuli(small, never_killed);
  ASSERT_EQ(asperity(arguments(never_killed, false)).status, 0);
  const auto expected = exported(never_killed, small.place() / "expected");

  std::mt19937 random(22);
  const fs::path study = small.study();
  std::vector<std::string> done{};
  for (int kill = 0; kill < 3; ++kill) {
    const auto said =
        killed(arguments(study, kill > 0), 1 + random() % 3, microseconds(random() % 20'000));
    EXPECT_GE(said.size(), 1U);
    done.insert(done.end(), said.begin(), said.end());
    expect_all_stored(study, done);
  }
  const Outcome finished = asperity(arguments(study, true));
  ASSERT_EQ(finished.status, 0) << finished.err;
  const auto tables = exported(study, small.place() / "tables");
  EXPECT_EQ(tsv(tables.at("responses.tsv")).column("answer"),
            tsv(expected.at("responses.tsv")).column("answer"));
  EXPECT_EQ(tsv(tables.at("sessions.tsv")).column("state"), std::vector<std::string>{"completed"});
}

// A failed assertion ends the program at once, in the tick in which it fails. That the motors then have no force, the tests of
// the drivers show with SIGABRT.
TEST(FailedAssertion, LosesNoTrialThatWasReportedDoneAndTheSessionContinues) {
  const SmallStudy small(1);
  const fs::path protocol = small.place() / "faulty.json";
  write_text(protocol, faulty_discrimination().dump());
  const auto run_with = [&](const std::string& plugin, const std::vector<std::string>& more) {
    std::vector<std::string> words{"run",
                                   protocol,
                                   "--study",
                                   small.study(),
                                   "--participant",
                                   "hand1",
                                   "--mode",
                                   "pilot",
                                   "--virtual",
                                   "--seed",
                                   "5",
                                   "--plugin",
                                   ASPERITY_FAULTY_PLUGINS "/" + plugin};
    words.insert(words.end(), more.begin(), more.end());
    return asperity(words);
  };
  const Outcome failed = run_with("faulty_assertion.so", {});
  EXPECT_EQ(failed.signal, SIGABRT) << failed.err;
  EXPECT_NE(failed.err.find("Assertion '"), std::string::npos) << failed.err;
  const std::vector<std::string> done = stored_attempts_in(failed.err);
  EXPECT_GE(done.size(), 1U) << failed.err;
  expect_all_stored(small.study(), done);
  expect_sound(small.study(), {"--plugin", ASPERITY_FAULTY_PLUGINS "/faulty_assertion.so"});

  // The same plug-in without the fault.
  const Outcome finished = run_with("faulty_none.so", {"--resume"});
  ASSERT_EQ(finished.status, 0) << finished.err;
  const auto tables = exported(small.study(), small.place() / "tables");
  EXPECT_EQ(tsv(tables.at("sessions.tsv")).column("state"), std::vector<std::string>{"completed"});
  expect_all_stored(small.study(), done);
}

TEST(Interrupt, StopsASimulationAfterItsTrialAndSaysHowToGoOn) {
  const SmallStudy small(40);
  std::vector<std::string> arguments = simulate_arguments(small, small.study(), 2, 5);
  Invocation invocation{};
  invocation.arguments = arguments;
  Program program(invocation);
  program.read_until(
      [](const std::string&, const std::string& err) { return done_lines(err).size() >= 2; });
  program.send(SIGINT);
  const Outcome stopped = program.finish();
  EXPECT_EQ(stopped.status, 1);
  EXPECT_NE(stopped.err.find("--resume"), std::string::npos) << stopped.err;
  const std::vector<std::string> done = stored_attempts_in(stopped.err);
  EXPECT_LT(done.size(), 160U);
  EXPECT_EQ(stored_attempts(small.study()), std::set<std::string>(done.begin(), done.end()));

  // The same arguments once more would add other participants next to those that are not complete.
  const Outcome again = asperity(arguments);
  EXPECT_EQ(again.status, 1);
  EXPECT_NE(again.err.find(
                "to complete it, add --resume; to add further participants, use another --seed"),
            std::string::npos)
      << again.err;
  EXPECT_EQ(stored_attempts(small.study()), std::set<std::string>(done.begin(), done.end()));
}

// As a debugger does, or a computer that is suspended.
TEST(StoppedProgram, RepeatsTheTrialInWhoseContactItStoodStill) {
  const SmallStudy small(50);
  Invocation invocation{};
  invocation.arguments = {"run",           small.selection(), "--study",   small.study(),
                          "--participant", "standin1",        "--virtual", "--realtime"};
  Program program(invocation);
  const auto is_repeated = [](const std::string&, const std::string& err) {
    return err.find("is repeated: the servo loop stalled for more than 50 ms.\n") !=
           std::string::npos;
  };
  ASSERT_TRUE(program.read_until([](const std::string&, const std::string& err) {
    return !done_lines(err).empty();
  })) << program.err();
  // Between two contacts it is no fault: once more then.
  constexpr int kMostStops = 200;
  for (int i = 0; i < kMostStops && !is_repeated(program.out(), program.err()); ++i) {
    program.send(SIGSTOP);
    std::this_thread::sleep_for(milliseconds(100));
    program.send(SIGCONT);
    program.read_for(milliseconds(100));
  }
  EXPECT_TRUE(program.read_until(is_repeated)) << program.err();
  EXPECT_NE(program.err().find(" 1 device_fault\n"), std::string::npos) << program.err();
  EXPECT_EQ(done_lines(program.err()).front(), "done standin1 1 1 1");
}

// Some forty files: wherever it is killed, nothing has the name of the study yet.
TEST(KilledNewStudy, IsNotInTheWayOfTheNext) {
  const TemporaryFolder folder;
  const fs::path study = folder / "study";
  Program making(Invocation{.arguments = {"new", study, "--demo"}});
  const auto has_begun = [&] {
    return fs::exists(study / "study.sqlite") ||
           fs::exists(folder / "study.part/content/study.sqlite");
  };
  ASSERT_TRUE(eventually(has_begun));
  making.send(SIGKILL);
  making.finish();
  EXPECT_FALSE(fs::exists(study));
  const Outcome next = asperity({"new", study});
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(NewStudyOnAFullDisk, CanBeMadeByTheSameCommand) {
  int failures = 0;
  for (const rlim_t most_bytes : {0UL, 1'000UL, 20'000UL, 100'000UL, 200'000UL, 300'000UL}) {
    for (const bool is_there : {false, true}) {
      const TemporaryFolder folder;
      const fs::path study = folder / "study";
      if (is_there) fs::create_directory(study);
      Invocation limited{.arguments = {"new", study, "--author", "Field, A."}};
      limited.in_child = [most_bytes] {
        std::signal(SIGXFSZ, SIG_IGN);  // the write fails
        const rlimit limit{most_bytes, most_bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
      };
      if (run(limited).status != 0) {
        ++failures;
        EXPECT_EQ(fs::exists(study), is_there);
        EXPECT_TRUE(!is_there || fs::is_empty(study));
      }
      const Outcome again = asperity({"new", study, "--author", "Field, A."});
      EXPECT_EQ(again.status, 0) << most_bytes << ": " << again.err;
      EXPECT_EQ(asperity({"verify", study}).status, 0);
      EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
    }
  }
  EXPECT_GE(failures, 6);
}

// Between the renaming and its end: the study has its name, and the folder in which it was made is left.
TEST(KilledNewStudy, IsCompletedByTheSameCommandOnly) {
  const SmallStudy small(1);
  const fs::path study = small.place() / "new";
  const auto make = [&study](const std::string& author) {
    return asperity({"new", study, "--author", author});
  };
  ASSERT_EQ(make("Field, A.").status, 0);
  fs::create_directory(small.place() / "new.part");
  write_text(small.place() / "new.part/lock", "");
  const auto before = contents_of(study);
  const Outcome same = make("Field, A.");
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_FALSE(fs::exists(small.place() / "new.part"));
  EXPECT_TRUE(contents_of(study) == before);
  EXPECT_EQ(make("Other, B.").status, 1);
  EXPECT_EQ(asperity({"new", study, "--demo", "--author", "Field, A."}).status, 1);
  write_text(study / "protocols/mine.json", "{}");
  EXPECT_EQ(make("Field, A.").status, 1);
  EXPECT_EQ(text_of(study / "protocols/mine.json"), "{}");
}

}  // namespace
}  // namespace asperity::test
