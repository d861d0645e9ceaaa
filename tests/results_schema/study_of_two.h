// A study of two participants, of whom one withdraws.

#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/recording.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace asperity {

inline const WithdrawalRow kDeletion{.data = WithdrawnData::deleted,
                                     .reason = WithdrawalReason::consent_withdrawn,
                                     .decided_by = "R. Keeper"};
inline const WithdrawalRow kKept{.data = WithdrawnData::kept, .decided_by = "R. Keeper"};

/// Two participants with a completed session each: what is stated of one can be distinguished from the other.
class StudyOfTwo : public testing::Test {
 protected:
  StudyOfTwo() {
    Study study = Study::create(path_, "fixture");
    const std::int64_t protocol = study.add_protocol(some_protocol());
    for (const std::string label : {"Wanda7", "Stays1"}) {
      ParticipantRow participant = some_participant(label);
      participant.is_virtual = false;
      participant.created_utc = "2001-02-03T04:05:06Z";
      participant.answers_json = R"({"hand":"secret)" + label + R"("})";
      study.add_participant(participant);
      SessionRow session = some_session(protocol);
      session.participant = label;
      session.mode = SessionMode::run;
      session.counterbalance_row = label == "Wanda7" ? 1 : 0;
      const std::int64_t id = study.add_session(session, some_plan(2));
      study.begin_segment(id, 1'000'000'000);
      study.add_session_answer(
          id, {.question = "why", .answer = "free words of " + label, .source = "keyboard"});
      study.add_event(id, {.time_ns = 2, .kind = "note", .text = label + " sneezed"});
      for (int trial = 1; trial <= 2; ++trial) {
        AttemptRow attempt = some_attempt(trial);
        attempt.responses.at(0).answer = "answer of " + label;
        const std::string name = "recordings/" + label + "/1-" + std::to_string(trial) + ".asprec";
        RecordingWriter writer(
            path_, name,
            {.rate_Hz = 10.0, .columns = {{.name = "x_m", .unit = "m", .meaning = label}}});
        const float x_m = 0.5F;
        writer.append(2'000'000'000, &x_m);
        attempt.recording = writer.finish();
        study.add_attempt(id, attempt);
      }
      study.add_decision(id, {.trial = 1,
                              .attempt = 1,
                              .verdict = Verdict::flag,
                              .reason = "odd of " + label,
                              .decided_by = "R. Keeper"});
      study.end_segment(id, 1, 5'000'000'000, "completed");
      study.end_session(id, SessionState::completed, "2026-01-01T10:00:00Z");
      write_file(path_ / ("sheet-" + label + ".png"), label, Overwrite::refuse);
    }
    write_file(path_ / "study.sqlite.version-4", "Wanda7 as an older program left it",
               Overwrite::refuse);
    // As a session leaves it that was killed.
    std::filesystem::create_directory(path_ / "locks");
    write_file(path_ / "locks" / "session-Wanda7.lock", "", Overwrite::refuse);
    write_file(path_ / "sheet-Wanda7.png.4711-0.tmp", "half a sheet", Overwrite::refuse);
    std::filesystem::create_directories(path_ / "logs" / "Wanda7");
    write_file(path_ / "logs" / "Wanda7" / "session-01.txt", "its words", Overwrite::refuse);
  }

  /// The files of the folder that hold the words, in their content or name.
  std::vector<std::string> files_with(const std::string& words) const {
    std::vector<std::string> found{};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path_)) {
      const std::string name = entry.path().lexically_relative(path_).string();
      std::string content = name;
      if (entry.is_regular_file()) {
        std::ifstream file(entry.path(), std::ios::binary);
        content.append(std::istreambuf_iterator<char>(file), {});
      }
      if (content.find(words) != std::string::npos) found.push_back(name);
    }
    return found;
  }

  /// The command again, after whatever interrupted it: nothing is left of the one, and nothing is changed of the other.
  void expect_the_end_when_repeated() const {
    try {
      open().withdraw("Wanda7", kDeletion);
    } catch (const ResultsError& error) {
      EXPECT_NE(std::string(error.what()).find("has no participant Wanda7; its last deletion"),
                std::string::npos)
          << error.what();
    }
    EXPECT_EQ(files_with("Wanda7"), std::vector<std::string>{});
    const Study study = Study::open(path_, Access::read_only);
    EXPECT_EQ(study.verify({}), std::vector<std::string>{});
    EXPECT_EQ(study.leftovers(), std::vector<std::string>{});
    ASSERT_EQ(study.sessions().size(), 1U);
    EXPECT_EQ(study.attempts(study.sessions().front().id).size(), 2U);
    EXPECT_EQ(study.withdrawals().size(), 1U);
  }

  Study open() const { return Study::open(path_, Access::read_write); }

  TemporaryFolder folder_{};
  std::filesystem::path path_ = folder_ / "study";
};

}  // namespace asperity
