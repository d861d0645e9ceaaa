// A deletion of a participant's data that is killed at any moment, or that comes while something is made of the study.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <random>

#include <gtest/gtest.h>

#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

using std::chrono::microseconds;

constexpr const char* kLabel = "virtual0002";  // of two

std::vector<std::string> deletion_arguments(const fs::path& study) {
  return {"withdraw", study, kLabel, "--delete", "--confirm", kLabel};
}

/// The files that have the label in their content or name.
std::vector<std::string> files_with_label(const fs::path& folder) {
  std::vector<std::string> found{};
  for (const auto& [name, content] : contents_of(folder)) {
    if ((name + content).find(kLabel) != std::string::npos) found.push_back(name);
  }
  return found;
}

void copy_study(const fs::path& from, const fs::path& to) {
  fs::copy(from, to, fs::copy_options::recursive);
}

/// The command again, as it stands: nothing of the participant is left, and nothing is wrong.
void expect_the_end(const fs::path& study) {
  const Outcome again = asperity(deletion_arguments(study));
  if (again.status != 0) {
    EXPECT_EQ(again.status, 1);
    EXPECT_NE(again.err.find("its last deletion"), std::string::npos) << again.err;
    EXPECT_NE(again.err.find("is complete"), std::string::npos) << again.err;
  }
  EXPECT_EQ(files_with_label(study), std::vector<std::string>{});
  const Outcome verified = asperity({"verify", study});
  EXPECT_EQ(verified.status, 0) << verified.out << verified.err;
  EXPECT_EQ(verified.out.find("remark"), std::string::npos) << verified.out;
}

TEST(KilledWithdrawal, IsCompletedByTheSameCommand) {
  const SmallStudy small = simulated_study(2, 3, {"--recordings", "all"});
  const fs::path whole = small.place() / "whole";
  copy_study(small.study(), whole);
  const auto began = std::chrono::steady_clock::now();
  ASSERT_EQ(asperity(deletion_arguments(whole)).status, 0);
  const auto since = [](const std::chrono::steady_clock::time_point& start) {
    return std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - start);
  };
  microseconds duration = since(began);
  const auto expected = exported(whole, small.place() / "expected");

  std::mt19937 random(63);
  constexpr int kKills = 60;
  int killed = 0;
  for (int kill = 0; kill < kKills; ++kill) {
    const fs::path study = small.place() / ("killed_" + std::to_string(kill));
    copy_study(small.study(), study);
    Invocation invocation{};
    invocation.arguments = deletion_arguments(study);
    const auto start = std::chrono::steady_clock::now();
    Program program(invocation);
    program.read_for(microseconds(random() % static_cast<std::uint64_t>(duration.count() + 1)));
    program.send(SIGKILL);
    if (program.finish().signal) {
      ++killed;
    } else {
      duration = std::min(duration, since(start));  // the first one was slower, under another load
    }
    expect_the_end(study);
    ASSERT_FALSE(HasFailure()) << kill;
    if (kill % 10 == 0) {
      const auto tables = exported(study, small.place() / ("tables_" + std::to_string(kill)));
      EXPECT_EQ(tables.at("responses.tsv"), expected.at("responses.tsv"));
      EXPECT_EQ(tables.at("sessions.tsv"), expected.at("sessions.tsv"));
    }
    fs::remove_all(study);
  }
  EXPECT_GT(killed, kKills / 2);
}

constexpr int kKindsOfOutput = 4;

/// The arguments of the output number i of the study, the kinds in turn.
std::vector<std::string> output_arguments(int i, const fs::path& study, const fs::path& made) {
  const std::vector<std::vector<std::string>> commands{
      {"export", study, "--out", made, "--formats", "all"},
      {"copy", study, made},
      {"report", study, "--out", made},
      {"merge", study, "--out", made}};
  return commands.at(static_cast<std::size_t>(i % kKindsOfOutput));
}

/// How long each kind of output takes on this computer, with its present load.
std::vector<microseconds> output_durations(const SmallStudy& small) {
  std::vector<microseconds> durations{};
  for (int kind = 0; kind < kKindsOfOutput; ++kind) {
    const fs::path study = small.place() / ("timed_study_" + std::to_string(kind));
    copy_study(small.study(), study);
    const fs::path made = small.place() / ("timed_" + std::to_string(kind) + ".html");
    const auto began = std::chrono::steady_clock::now();
    EXPECT_EQ(asperity(output_arguments(kind, study, made)).status, 0);
    durations.push_back(
        std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - began));
  }
  return durations;
}

// An output is stopped at any moment, the data are deleted, and the output goes on: it does not contain them, or the
// deletion has named it.
TEST(WithdrawalWhileAnOutputIsMade, LeavesNoOutputThatItDoesNotName) {
  const SmallStudy small = simulated_study(2, 3, {"--recordings", "all"});
  const std::vector<microseconds> durations = output_durations(small);
  std::mt19937 random(64);
  // Some are over, or have not begun to read, when they are stopped: how many depends on the load of the computer.
  constexpr int kOverlapping = 13;
  constexpr int kFewest = 36;
  constexpr int kMost = 144;
  int overlapped = 0;
  for (int i = 0; i < kMost && (i < kFewest || overlapped < kOverlapping); ++i) {
    const fs::path study = small.place() / ("study_" + std::to_string(i));
    copy_study(small.study(), study);
    const fs::path made =
        small.place() / ("made_" + std::to_string(i) + (i % 4 == 2 ? ".html" : ""));
    Invocation invocation{};
    invocation.arguments = output_arguments(i, study, made);
    Program output(invocation);
    const auto& duration = durations.at(static_cast<std::size_t>(i % kKindsOfOutput));
    output.read_for(microseconds(random() % static_cast<std::uint64_t>(duration.count() + 1)));
    output.send(SIGSTOP);
    Invocation withdrawing{};
    withdrawing.arguments = deletion_arguments(study);
    Program withdrawal(withdrawing);
    // Where the output has a snapshot of the log, the deletion waits for it.
    withdrawal.read_for(microseconds(2'000'000));
    output.send(SIGCONT);
    const Outcome withdrawn = withdrawal.finish();
    const Outcome outcome = output.finish();
    // A merge reads the study once more at its end, and refuses one in which a deletion has begun.
    const bool is_refused =
        outcome.status == 1 &&
        outcome.err.find("deletion of a participant's data is not complete") != std::string::npos;
    EXPECT_TRUE(outcome.status == 0 || is_refused) << invocation.arguments[0] << outcome.err;
    EXPECT_FALSE(is_refused && fs::exists(made)) << made;
    const bool is_named = withdrawn.out.find(made.string()) != std::string::npos;
    std::vector<std::string> holding{};
    if (fs::is_directory(made)) {
      holding = files_with_label(made);
    } else if (fs::exists(made) && text_of(made).find(kLabel) != std::string::npos) {
      holding = {made};
    }
    overlapped += is_named ? 1 : 0;
    EXPECT_TRUE(holding.empty() || is_named)
        << invocation.arguments[0] << " has " << holding.front() << "\n"
        << withdrawn.out;
    if (i % 4 == 0) {
      const auto rows_of_label = [&made](const char* name) {
        const std::vector<std::string> labels = tsv(text_of(made / name)).column("participant");
        return std::count(labels.begin(), labels.end(), kLabel);
      };
      const bool is_there = rows_of_label("participants.tsv") > 0;
      for (const char* const name :
           {"sessions.tsv", "trials.tsv", "attempts.tsv", "responses.tsv"}) {
        EXPECT_EQ(rows_of_label(name) > 0, is_there) << name << ": of another moment";
      }
    }
    expect_the_end(study);
    ASSERT_FALSE(HasFailure()) << i;
    fs::remove_all(study);
  }
  EXPECT_GE(overlapped, kOverlapping);
}

TEST(WithdrawalWhileAStudyIsVerified, IsNoDamage) {
  const SmallStudy small = simulated_study(2, 3, {"--recordings", "all"});
  std::mt19937 random(65);
  for (int i = 0; i < 20; ++i) {
    const fs::path study = small.place() / ("study_" + std::to_string(i));
    copy_study(small.study(), study);
    Invocation verifying{};
    verifying.arguments = {"verify", study};
    Program verification(verifying);
    verification.read_for(microseconds(random() % 150'000));
    EXPECT_EQ(asperity(deletion_arguments(study)).status, 0);
    const Outcome verified = verification.finish();
    EXPECT_EQ(verified.status, 0) << verified.err;
    EXPECT_EQ(verified.out.find("estore"), std::string::npos) << verified.out;
    fs::remove_all(study);
  }
}

}  // namespace
}  // namespace asperity::test
