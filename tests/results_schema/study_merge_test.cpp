// The union of the studies of two stations: its rows and files, and what is not merged.

#include "results_schema/merge/study_merge.h"

#include <algorithm>
#include <stop_token>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/part_files.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "tests/results_schema/failing_vfs.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kCreated_utc = "2026-02-01T08:00:00.000Z";

/// What `sql` selects, a line for each row. Changes the study where `sql` does, and takes away its checksum.
std::vector<std::string> query(const std::filesystem::path& study, const std::string& sql) {
  std::vector<std::string> lines;
  sqlite3* handle = nullptr;
  sqlite3_open((study / "study.sqlite").c_str(), &handle);
  const auto add_line = [](void* all, int columns, char** values, char**) {
    std::string line;
    for (int i = 0; i < columns; ++i) line += std::string(values[i] ? values[i] : "NULL") + '|';
    static_cast<std::vector<std::string>*>(all)->push_back(line);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), add_line, &lines, nullptr), SQLITE_OK)
      << sqlite3_errmsg(handle);
  sqlite3_close(handle);
  return lines;
}

void change(const std::filesystem::path& study, const std::string& sql) {
  query(study, sql);
  std::filesystem::remove(study / "study.sqlite.sha256");
}

/// A person with a completed session in which there is a row of every table. Times and seeds depend on the label, as those
/// of people do on the moment.
void add_person(Study& study, const std::string& label) {
  const std::string number = std::to_string(std::stoi(label.substr(1)));
  const std::string utc = "2026-03-01T09:00:00.00" + number.substr(0, 1) + "Z";
  ParticipantRow person = some_participant(label);
  person.is_virtual = false;
  person.created_utc = utc;
  study.add_participant(person);
  SessionRow session = some_session(study.add_protocol(some_protocol()), label);
  session.mode = SessionMode::run;
  session.seed = "7" + number;
  session.files = {{.path = "stimuli/metal.png", .sha256 = sha256_of("pixels"), .bytes = 6}};
  const std::int64_t id = study.add_session(session, some_plan(2));
  study.begin_segment(id, 1'000'000'000);
  const auto add_attempt = [&](AttemptRow attempt) {
    const std::string name = "recordings/" + label + "/session-01-" +
                             std::to_string(attempt.trial) + '-' + std::to_string(attempt.attempt) +
                             ".asprec";
    RecordingWriter writer(study.folder(), name, {.rate_Hz = 10.0, .columns = {{.name = "x_m"}}});
    const float x_m = 0.5F;
    writer.append(2'000'000'000, &x_m);
    attempt.recording = writer.finish();
    study.add_attempt(id, attempt);
  };
  const auto decide = [&](std::optional<int> trial, Verdict verdict, const std::string& utc_of) {
    study.add_decision(id, {.trial = trial,
                            .attempt = trial,
                            .verdict = verdict,
                            .reason = "odd",
                            .decided_by = "R. Keeper",
                            .decided_utc = utc_of});
  };
  add_attempt(some_attempt(1));
  decide(1, Verdict::flag, utc);
  decide(1, Verdict::set_aside, utc);
  add_attempt(some_attempt(1, 2));
  add_attempt(some_attempt(2));
  decide({}, Verdict::exclude, utc);
  decide({}, Verdict::include, utc);
  study.add_session_answer(id, {.question = "why", .answer = "so", .source = "keyboard"});
  study.add_event(id, {.time_ns = 2, .kind = "unblinded", .text = "asked by " + label});
  study.add_event(id, {.time_ns = 3,
                       .kind = "external_program",
                       .text = "levels",
                       .data_json = R"({"log":"logs/)" + label + R"(/session-01.txt"})"});
  study.end_segment(id, 1, 9'000'000'000, "completed");
  study.end_session(id, SessionState::completed, "2026-03-01T10:00:00Z");
  std::filesystem::create_directories(study.folder() / "logs" / label);
  write_file(study.folder() / "logs" / label / "session-01.txt", "words", Overwrite::refuse);
}

/// A closed study with these people.
std::filesystem::path station(const std::filesystem::path& folder,
                              const std::vector<std::string>& labels) {
  {
    Study study = Study::create(folder, folder.filename().string());
    write_file(folder / "stimuli" / "metal.png", "pixels", Overwrite::refuse);
    for (const std::string& label : labels) add_person(study, label);
    study.remember_solution("k", "1");
  }
  change(folder, std::string("UPDATE study SET created_utc = '") + kCreated_utc + "'");
  { Study::open(folder, Access::read_write); }  // which leaves a checksum
  return folder;
}

/// An open session of a person, as a program leaves it that is running or was killed.
void begin_session(const std::filesystem::path& folder, const std::string& label) {
  Study study = Study::open(folder, Access::read_write);
  SessionRow session = some_session(study.protocols()[0].id, label);
  session.mode = SessionMode::run;
  study.add_session(session, some_plan(2));
}

class StudyMerge : public testing::Test {
 protected:
  std::string refusal(const std::vector<MergeSource>& sources, const MergeSettings& settings = {}) {
    const std::string why =
        refusal_of<ResultsError>([&] { Study::merge(sources, merged_, settings); });
    EXPECT_FALSE(std::filesystem::exists(merged_));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "merged.part"));
    return why;
  }
  std::vector<std::string> problems() const {
    const Study study = Study::open(merged_, Access::read_only);
    std::vector<std::string> all = study.verify({});
    for (const std::string& leftover : study.leftovers()) all.push_back(leftover);
    return all;
  }

  TemporaryFolder folder_{};
  std::filesystem::path merged_ = folder_ / "merged";
  std::filesystem::path a_ = station(folder_ / "a", {"P1", "P3"});
  std::filesystem::path b_ = station(folder_ / "b", {"P2"});
};

/// The rows of a table without the keys that only connect rows, and without the origins of sessions.
std::vector<std::string> rows_of(const std::filesystem::path& study, const std::string& table) {
  std::string columns;
  for (const std::string& line :
       query(study, "SELECT name FROM pragma_table_info('" + table + "')")) {
    const std::string column = line.substr(0, line.size() - 1);
    if (column == "id" || column.ends_with("_id")) continue;
    columns += (columns.empty() ? "" : ", ") + column;
  }
  const std::string where = table == "event" ? " WHERE kind <> 'merged'" : "";
  std::vector<std::string> rows = query(study, "SELECT " + columns + " FROM " + table + where);
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST_F(StudyMerge, HasTheRowsOfOneStudyWithAllParticipants) {
  const std::filesystem::path whole = station(folder_ / "whole", {"P1", "P2", "P3"});
  const MergedCounts counts = Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
  EXPECT_EQ(counts.participants, 3);
  EXPECT_EQ(counts.sessions, 3);
  EXPECT_EQ(counts.incomplete_sessions, 0);
  EXPECT_EQ(counts.attempts, 9);
  EXPECT_EQ(counts.recordings, 9);
  EXPECT_THAT(problems(), IsEmpty());
  int tables = 0;
  for (const std::string& line :
       query(whole, "SELECT name FROM sqlite_master WHERE type = 'table'")) {
    const std::string table = line.substr(0, line.size() - 1);
    // Of the study itself: see the tests on its statements, outputs and withdrawals.
    if (table == "study" || table == "author" || table == "output" || table == "withdrawal")
      continue;
    EXPECT_FALSE(rows_of(whole, table).empty()) << table << ": add a row of it to add_person";
    EXPECT_EQ(rows_of(merged_, table), rows_of(whole, table)) << table;
    ++tables;
  }
  EXPECT_GE(tables, 18);
  for (const char* const view : {"tidy_attempt", "tidy_presentation", "tidy_response"}) {
    const std::string all = std::string("SELECT * FROM ") + view;
    EXPECT_EQ(query(merged_, all), query(whole, all)) << view;
  }
  const std::string decisions =
      "SELECT label, trial, attempt, verdict FROM decision JOIN session ON session.id = session_id "
      "JOIN participant ON participant.id = participant_id ORDER BY label, decision.id";
  EXPECT_EQ(query(merged_, decisions), query(whole, decisions));
}

TEST_F(StudyMerge, IsTheSameFileWhateverTheOrderAndTheDivision) {
  // Virtual participants: a session of a person states from which study it is.
  const auto virtual_station = [this](const std::string& name, const std::vector<int>& numbers) {
    const std::filesystem::path folder = folder_ / name;
    {
      Study study = Study::create(folder, name);
      for (const int number : numbers) {
        const std::string label = "virtual000" + std::to_string(number);
        study.add_participant(some_participant(label));
        SessionRow session = some_session(study.add_protocol(some_protocol()), label);
        session.seed = std::to_string(number);
        const std::int64_t id = study.add_session(session, some_plan(3));
        study.begin_segment(id, 1'000'000'000);
        for (int trial = 1; trial <= 3; ++trial) study.add_attempt(id, some_attempt(trial));
        study.remember_solution("of " + label, "1");
      }
    }
    return folder;
  };
  const auto first = virtual_station("first", {3, 1});
  const auto second = virtual_station("second", {2, 4});
  const auto whole = virtual_station("both", {4, 2, 3, 1});
  const auto file = [this](const std::string& place, const std::vector<MergeSource>& sources) {
    Study::merge(sources, folder_ / place / "merged", {});
    return read_file(folder_ / place / "merged" / "study.sqlite");
  };
  const std::string content = file("one", {{first}, {second}});
  EXPECT_GT(content.size(), 50'000U);
  EXPECT_TRUE(file("two", {{second}, {first}}) == content) << "of the other order";
  EXPECT_TRUE(file("three", {{whole}}) == content) << "of the whole";
}

TEST_F(StudyMerge, CarriesFilesUnderThePrefixedLabels) {
  const std::filesystem::path other = station(folder_ / "c", {"P4"});
  write_file(other / "sheet-P4.png", "sheet", Overwrite::refuse);
  change(other, "UPDATE study SET created_utc = '2026-02-02T08:00:00.000Z'");
  Study::merge(std::vector<MergeSource>{{a_}, {other, "x"}}, merged_, {});
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_EQ(query(merged_, "SELECT label FROM participant ORDER BY id"),
            (std::vector<std::string>{"P1|", "P3|", "xP4|"}));
  EXPECT_EQ(read_recording(merged_ / "recordings/xP4/session-01-2-1.asprec").time_ns.size(), 1U);
  EXPECT_EQ(read_file(merged_ / "logs/xP4/session-01.txt"), "words");
  EXPECT_EQ(read_file(merged_ / "stimuli/metal.png"), "pixels");
  EXPECT_EQ(query(merged_,
                  "SELECT data_json FROM event WHERE kind = 'external_program' "
                  "ORDER BY id DESC LIMIT 1"),
            std::vector<std::string>{R"({"log":"logs/xP4/session-01.txt"}|)"});
  // A deletion finds all of them.
  Study::open(merged_, Access::read_write)
      .withdraw("xP4", {.data = WithdrawnData::deleted, .decided_by = "R. Keeper"});
  for (const auto& entry : std::filesystem::recursive_directory_iterator(merged_)) {
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("P4")));
  }
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(StudyMerge, StatesFromWhichStudyEachSessionOfAPersonIs) {
  Study::merge(std::vector<MergeSource>{{b_}, {a_}}, merged_, {});
  EXPECT_EQ(
      query(merged_,
            "SELECT label, event.time_ns, text, data_json FROM event "
            "JOIN session ON session.id = session_id JOIN participant ON participant.id = "
            "participant_id "
            "WHERE kind = 'merged' ORDER BY label"),
      (std::vector<std::string>{
          R"(P1|9000000000|a|{"study":"a","created_utc":"2026-02-01T08:00:00.000Z","source":1,"session_id":1}|)",
          R"(P2|9000000000|b|{"study":"b","created_utc":"2026-02-01T08:00:00.000Z","source":2,"session_id":1}|)",
          R"(P3|9000000000|a|{"study":"a","created_utc":"2026-02-01T08:00:00.000Z","source":1,"session_id":2}|)"}));
}

TEST_F(StudyMerge, IsCreatedWhenTheFirstOfItsStudiesWas) {
  change(b_, "UPDATE study SET created_utc = '2026-02-02T08:00:00.000Z'");
  Study::merge(std::vector<MergeSource>{{b_}, {a_}}, merged_, {});
  EXPECT_EQ(query(merged_, "SELECT created_utc FROM study"),
            std::vector<std::string>{std::string(kCreated_utc) + '|'});
}

TEST_F(StudyMerge, KeepsWithdrawals) {
  { Study::open(a_, Access::read_write).withdraw("P3", {.decided_by = "R. Keeper"}); }
  Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
  Study study = Study::open(merged_, Access::read_write);
  EXPECT_TRUE(study.participant("P3")->withdrawn);
  EXPECT_FALSE(study.participant("P2")->withdrawn);
  EXPECT_EQ(
      query(merged_,
            "SELECT p.label FROM withdrawal AS w JOIN participant AS p ON p.id = participant_id"),
      std::vector<std::string>{"P3|"});
  for (const SessionRow& session : study.sessions()) {
    EXPECT_EQ(session.excluded.has_value(), session.participant == "P3") << session.participant;
  }
  EXPECT_TRUE(study.outputs().empty()) << "those of a study are made of it";
}

// Which one is kept of two solutions of one problem does not depend on the order of the studies.
TEST_F(StudyMerge, KeepsTheLesserOfTwoSolutionsOfAProblem) {
  { Study::open(a_, Access::read_write).remember_solution("shared", "2"); }
  { Study::open(b_, Access::read_write).remember_solution("shared", "1"); }
  for (const auto& [first, second] : {std::pair{a_, b_}, std::pair{b_, a_}}) {
    Study::merge(std::vector<MergeSource>{{first}, {second}}, merged_, {});
    EXPECT_EQ(query(merged_, "SELECT solution_json FROM solution WHERE key = 'shared'"),
              std::vector<std::string>{"1|"});
    std::filesystem::remove_all(merged_);
  }
}

TEST_F(StudyMerge, CarriesASessionThatCanBeResumed) {
  begin_session(b_, "P2");
  const MergedCounts counts = Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
  EXPECT_EQ(counts.incomplete_sessions, 1);
  Study study = Study::open(merged_, Access::read_write);
  EXPECT_EQ(study.mark_crashed_sessions().size(), 1U);
  EXPECT_EQ(study.sessions()[2].state, SessionState::crashed);
}

/// A station with one participant, who is none of the other stations'.
std::filesystem::path station_of_another(const std::filesystem::path& folder,
                                         const std::string& label) {
  station(folder, {label});
  change(folder, "UPDATE participant SET created_utc = '2026-04-05T06:07:08.009Z', age_years = 50");
  change(folder,
         "DROP TRIGGER session_only_changes_state; DROP TRIGGER session_completed_stays;"
         "UPDATE session SET seed = '5'");
  return folder;
}

TEST_F(StudyMerge, RefusesALabelThatTwoPeopleHave) {
  const std::filesystem::path other = station_of_another(folder_ / "c", "P2");
  EXPECT_THAT(refusal({{b_}, {other}}),
              AllOf(HasSubstr("both have a participant P2, added to " + b_.string() +
                              " at 2026-03-01T09:00:00.002Z and to " + other.string() +
                              " at 2026-04-05T06:07:08.009Z"),
                    HasSubstr("--prefix " + other.string() + "=B")));
  EXPECT_NO_THROW(Study::merge(std::vector<MergeSource>{{b_}, {other, "B"}}, merged_, {}));
  EXPECT_EQ(Study::open(merged_, Access::read_only).participants().size(), 2U);
}

// One person at two stations, or two people whom a table would take for one.
TEST_F(StudyMerge, RefusesLabelsThatDifferOnlyInCaseOrLeadingZeros) {
  const std::filesystem::path other = station_of_another(folder_ / "c", "p02");
  EXPECT_THAT(refusal({{b_}, {other}}),
              AllOf(HasSubstr("they have the participants P2 and p02, whose labels differ only in "
                              "letter case or leading zeros, added to " +
                              b_.string()),
                    HasSubstr("--prefix " + other.string() + "=B")));
  EXPECT_NO_THROW(Study::merge(std::vector<MergeSource>{{b_}, {other, "B"}}, merged_, {}));
}

TEST_F(StudyMerge, RefusesTwoCopiesOfAStudyUnderWhateverLabels) {
  const std::filesystem::path copy = folder_ / "copy";
  Study::open(a_, Access::read_only).copy_to(copy);
  const auto says_copies =
      AllOf(HasSubstr("the studies " + a_.string() + " and " + copy.string()),
            HasSubstr("both contain the same session, P1/1"), HasSubstr("copies of one study"));
  EXPECT_THAT(refusal({{a_}, {copy}}), says_copies);
  EXPECT_THAT(refusal({{a_}, {copy, "x"}}), says_copies);
  EXPECT_THAT(refusal({{a_}, {a_}}), HasSubstr("they are the same folder"));
}

TEST_F(StudyMerge, RefusesCopiesWithAParticipantWhoHasNoSession) {
  const std::filesystem::path other = folder_ / "c";
  {
    Study study = Study::create(other, "c");
    study.add_participant({.label = "P8", .created_utc = "2026-03-04T05:06:07.008Z"});
  }
  Study::open(other, Access::read_only).copy_to(folder_ / "d");
  EXPECT_THAT(refusal({{other}, {folder_ / "d", "x"}}),
              HasSubstr("both contain the same participant, P8"));
}

TEST_F(StudyMerge, RefusesTwoMergesOfACommonStudy) {
  const std::filesystem::path other = station(folder_ / "c", {"P4"});
  Study::merge(std::vector<MergeSource>{{a_, "x"}, {b_}}, folder_ / "d1", {});
  Study::merge(std::vector<MergeSource>{{a_}, {other}}, folder_ / "d2", {});
  EXPECT_THAT(refusal({{folder_ / "d1"}, {folder_ / "d2"}}),
              HasSubstr("both contain the same session, xP1/1 and P1/1"));
}

TEST_F(StudyMerge, MergesStudiesThatWereCopiedBeforeTheirFirstSessions) {
  const std::filesystem::path other = folder_ / "c";
  { Study::create(other, "c"); }
  Study::open(other, Access::read_only).copy_to(folder_ / "d");
  for (const char* const name : {"c", "d"}) {
    write_file(folder_ / name / "stimuli" / "metal.png", "pixels", Overwrite::refuse);
    Study study = Study::open(folder_ / name, Access::read_write);
    add_person(study, std::string(name) == "c" ? "P5" : "P6");
  }
  EXPECT_EQ(Study::merge(std::vector<MergeSource>{{folder_ / "c"}, {folder_ / "d"}}, merged_, {})
                .participants,
            2);
}

TEST_F(StudyMerge, HasAWithdrawalThatTheStudiesHaveInCommonOnce) {
  const std::filesystem::path other = station(folder_ / "c", {"P4"});
  {
    Study::open(other, Access::read_write)
        .withdraw("P4", {.data = WithdrawnData::deleted, .decided_by = "R. Keeper"});
  }
  Study::open(other, Access::read_only).copy_to(folder_ / "d");
  for (const auto& [name, label] : {std::pair{"c", "P5"}, std::pair{"d", "P6"}}) {
    Study study = Study::open(folder_ / name, Access::read_write);
    add_person(study, label);
  }
  Study::merge(std::vector<MergeSource>{{folder_ / "c"}, {folder_ / "d"}}, merged_, {});
  EXPECT_EQ(Study::open(merged_, Access::read_only).withdrawals().size(), 1U);
}

TEST_F(StudyMerge, RefusesCopiesOfWhichOneLacksADeletion) {
  // Of both studies the same creation is stored, as of copies.
  {
    Study::open(a_, Access::read_write)
        .withdraw("P3", {.data = WithdrawnData::deleted,
                         .decided_by = "R. Keeper",
                         .withdrawn_utc = "2026-05-06T07:08:09.010Z"});
  }
  EXPECT_THAT(refusal({{a_}, {b_}}), AllOf(HasSubstr("deleted from " + a_.string() +
                                                     " at 2026-05-06T07:08:09.010Z, but not "
                                                     "from " +
                                                     b_.string()),
                                           HasSubstr("--deletions-checked")));
  Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_,
               {.deletions_in_copies = DeletionsInCopies::checked});
  EXPECT_EQ(Study::open(merged_, Access::read_only).withdrawals().size(), 1U);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(StudyMerge, LeavesNothingWhereItIsStopped) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {.stop = stop.get_token()}),
      ResultsError);
  EXPECT_FALSE(std::filesystem::exists(merged_));
  EXPECT_FALSE(std::filesystem::exists(merged_.string() + ".part"));
}

TEST_F(StudyMerge, RefusesFilesThatDiffer) {
  write_file(a_ / "protocols" / "note.txt", "one", Overwrite::refuse);
  write_file(b_ / "protocols" / "note.txt", "other", Overwrite::refuse);
  EXPECT_THAT(refusal({{a_}, {b_}}),
              HasSubstr("the files " + (a_ / "protocols/note.txt").string() + " and " +
                        (b_ / "protocols/note.txt").string() + " differ"));
  write_file(b_ / "protocols" / "note.txt", "one", Overwrite::allow);
  Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
  EXPECT_EQ(read_file(merged_ / "protocols" / "note.txt"), "one");
}

// The parts differ in them, and the whole is none of the parts.
TEST_F(StudyMerge, LeavesOutTheFilesThatStateAPart) {
  for (const char* const name : {kShardFile, kDealFile}) {
    write_file(a_ / name, "one", Overwrite::refuse);
    write_file(b_ / name, "other", Overwrite::refuse);
    write_file(a_ / "protocols" / name, "of a user", Overwrite::refuse);
  }
  Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
  for (const char* const name : {kShardFile, kDealFile}) {
    EXPECT_FALSE(std::filesystem::exists(merged_ / name)) << name;
    EXPECT_EQ(read_file(merged_ / "protocols" / name), "of a user");
    EXPECT_EQ(read_file(a_ / name), "one") << "of the study itself";
  }
}

TEST_F(StudyMerge, RefusesWhatHasChanged) {
  write_file(b_ / "recordings/P2/session-01-1-1.asprec", "other", Overwrite::allow);
  EXPECT_THAT(refusal({{a_}, {b_}}),
              AllOf(HasSubstr("the study " + b_.string() + " cannot be merged"),
                    HasSubstr("recordings/P2/session-01-1-1.asprec has changed")));
  std::string content = read_file(a_ / "study.sqlite");
  const std::size_t place = content.find("asked by P1");
  ASSERT_NE(place, std::string::npos);
  content[place] = 'A';
  write_file(a_ / "study.sqlite", content, Overwrite::allow);
  EXPECT_THAT(refusal({{a_}, {b_}}), AllOf(HasSubstr("the study " + a_.string()),
                                           HasSubstr("study.sqlite has changed since")));
}

TEST_F(StudyMerge, RefusesADatabaseThatIsDamagedOrALink) {
  const std::filesystem::path file = b_ / "study.sqlite";
  const std::string whole = read_file(file);
  std::string damaged = whole;
  const std::size_t page = damaged.find("asked by P2") / 4096 * 4096;
  damaged.replace(page, 100, std::string(100, '\xff'));
  write_file(file, damaged, Overwrite::allow);
  EXPECT_THAT(refusal({{a_}, {b_}}),
              AllOf(HasSubstr("the study " + b_.string() + " cannot be merged"),
                    HasSubstr("study.sqlite is damaged, and rows may be missing")));
  write_file(folder_ / "elsewhere.sqlite", whole, Overwrite::refuse);
  std::filesystem::remove(file);
  std::filesystem::create_symlink(folder_ / "elsewhere.sqlite", file);
  EXPECT_THAT(refusal({{a_}, {b_}}), HasSubstr("symbolic link"));
}

TEST_F(StudyMerge, RefusesAProtocolThatAnotherProgramChanged) {
  const std::string drop = "DROP TRIGGER protocol_no_update;";
  change(b_, drop + "UPDATE protocol SET version = '9'");
  EXPECT_THAT(refusal({{a_}, {b_}}),
              AllOf(HasSubstr("the studies " + a_.string() + " and " + b_.string()),
                    HasSubstr("they state different things of the protocol file")));
  change(a_, drop + "UPDATE protocol SET source = source || ' '");
  EXPECT_THAT(refusal({{a_}, {b_}}),
              AllOf(HasSubstr("the study " + a_.string()),
                    HasSubstr("does not have the stored SHA-256; restore the study from a copy")));
}

TEST_F(StudyMerge, StatesWhatTheStudiesStateOfThemselves) {
  const auto state = [](const std::filesystem::path& study, const StudyMetadata& metadata) {
    Study::open(study, Access::read_write).set_metadata(metadata);
  };
  state(a_, {.authors = {"Rossi, Ada"}, .license = "CC0-1.0"});
  state(b_, {.authors = {"Weber, Bo"}});
  EXPECT_THAT(
      refusal({{a_}, {b_}}),
      HasSubstr("they state different authors, \"Rossi, Ada\" and \"Weber, Bo\". State what "
                "holds for the merged study with --author"));
  Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_,
               {.metadata = {.authors = {"Rossi, Ada", "Weber, Bo"}}});
  const Study study = Study::open(merged_, Access::read_only);
  EXPECT_EQ(study.metadata(),
            (StudyMetadata{.authors = {"Rossi, Ada", "Weber, Bo"}, .license = "CC0-1.0"}));
  EXPECT_EQ(study.name(), "merged");
}

TEST_F(StudyMerge, RefusesARunningSessionAndAnIncompleteDeletion) {
  begin_session(b_, "P2");
  {
    const StudyLock lock(b_, Study::session_lock_name("P2"));
    EXPECT_THAT(refusal({{a_}, {b_}}), HasSubstr("its session P2/2 is running"));
  }
  change(a_,
         "INSERT INTO withdrawal (data, is_virtual, reason, decided_by, withdrawn_utc, sessions, "
         "attempts, answers, recordings, label) VALUES ('deleted', 0, 'other', 'R. Keeper', "
         "'2026-05-06T07:08:09Z', 1, 1, 1, 1, 'P9')");
  EXPECT_THAT(refusal({{a_}, {b_}}),
              HasSubstr("the deletion of a participant's data is not complete"));
}

TEST_F(StudyMerge, NeedsAFolderThatIsNotThere) {
  std::filesystem::create_directory(folder_ / "there");
  const auto refused = [this](const std::filesystem::path& to) {
    return refusal_of<ResultsError>([&] {
      Study::merge(std::vector<MergeSource>{{a_}, {b_}}, to, {});
    });
  };
  EXPECT_THAT(refused(folder_ / "there"), HasSubstr("already exists; name a new folder"));
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "there"));
  EXPECT_THAT(refused(a_ / "merged"), HasSubstr("would be in its folder"));
  EXPECT_THAT(refusal({{a_, "x-"}}), HasSubstr("is not permitted as a prefix"));
  EXPECT_THAT(refusal({{a_, std::string(31, 'x')}}), HasSubstr("Choose a shorter prefix"));
  EXPECT_THAT(refusal({{a_}, {folder_ / "nowhere"}}), HasSubstr("there is no folder"));
}

// A job that is run again, after it had succeeded.
TEST_F(StudyMerge, AcceptsTheStudyThatAnEarlierMergeOfTheSameStudiesMade) {
  const std::vector<MergeSource> sources{{a_}, {b_}};
  EXPECT_FALSE(Study::merge(sources, merged_, {}).was_there);
  const auto refused = [&] {
    const std::string why = refusal_of<ResultsError>([&] { Study::merge(sources, merged_, {}); });
    EXPECT_FALSE(std::filesystem::exists(folder_ / "merged.part"));
    return why;
  };
  const auto written = std::filesystem::last_write_time(merged_ / "study.sqlite");
  const MergedCounts again = Study::merge(std::vector<MergeSource>{{b_}, {a_}}, merged_, {});
  EXPECT_TRUE(again.was_there);
  EXPECT_EQ(again.participants, 3);
  EXPECT_EQ(std::filesystem::last_write_time(merged_ / "study.sqlite"), written);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "merged.part"));

  // With another file, or without the data of a participant who withdrew.
  const std::filesystem::path log = merged_ / "logs" / "P1" / "session-01.txt";
  write_file(log, "other", Overwrite::allow);
  EXPECT_THAT(refused(), HasSubstr("not the merge of these studies as they are now"));
  write_file(log, "words", Overwrite::allow);
  EXPECT_THAT(refused(), IsEmpty());
  Study::open(merged_, Access::read_write)
      .withdraw("P1", {.data = WithdrawnData::deleted,
                       .reason = WithdrawalReason::other,
                       .decided_by = "R. Keeper"});
  EXPECT_THAT(refused(), AllOf(HasSubstr(merged_.string() + ", which already exists"),
                               HasSubstr("name a new folder")));
  EXPECT_FALSE(Study::open(merged_, Access::read_only).participant("P1"));
}

class InterruptedMerge : public StudyMerge {};

// The disk fails at one operation of the database after another: the merge is complete or absent.
TEST_F(InterruptedMerge, LeavesNothingWhereTheDiskFails) {
  int failures = 0;
  for (int n = 1;; n += 17) {
    FailingVfs disk;
    disk.fail_from(n, FailingVfs::Fault::disk_full);
    const std::string why = refusal_of<ResultsError>([&] {
      Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
    });
    const bool has_failed = disk.has_failed();
    disk.heal();
    ASSERT_EQ(std::filesystem::exists(merged_), why.empty()) << n;
    ASSERT_FALSE(std::filesystem::exists(folder_ / "merged.part")) << n;
    // After the last row only what need not be there can fail.
    if (why.empty()) {
      ASSERT_THAT(problems(), IsEmpty()) << n;
    }
    if (!has_failed) break;
    std::filesystem::remove_all(merged_);
    ++failures;
    ASSERT_LT(n, 5000);
  }
  EXPECT_GT(failures, 5);
  EXPECT_THAT(Study::open(a_, Access::read_only).verify({}), IsEmpty());
}

TEST_F(InterruptedMerge, IsRepeatedAfterItWasKilled) {
  for (const int n : {3, 15, 40}) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      FailingVfs disk;
      disk.fail_from(n, FailingVfs::Fault::killed);
      Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status)) << n;
    EXPECT_FALSE(std::filesystem::exists(merged_)) << n;
  }
  Study::merge(std::vector<MergeSource>{{a_}, {b_}}, merged_, {});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "merged.part"));
  EXPECT_THAT(problems(), IsEmpty());
}

}  // namespace
}  // namespace asperity
