// The rules stand in the file: what is forbidden is refused to every tool, whatever it has switched
// off.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "results_schema/study.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

const std::string kNow = "2026-01-01T00:00:00Z";
const std::string kHash = "'" + std::string(64, 'a') + "'";

/// Another program's connection, with SQLite's defaults or worse.
class ForeignTool {
 public:
  ForeignTool(const std::filesystem::path& study, bool careful) {
    sqlite3_open_v2((study / "study.sqlite").c_str(), &handle_, SQLITE_OPEN_READWRITE, nullptr);
    EXPECT_EQ(run(careful ? "PRAGMA foreign_keys = ON; PRAGMA recursive_triggers = ON;"
                          : "PRAGMA foreign_keys = OFF; PRAGMA recursive_triggers = OFF;"),
              "");
  }
  ~ForeignTool() { sqlite3_close(handle_); }
  ForeignTool(const ForeignTool&) = delete;
  ForeignTool& operator=(const ForeignTool&) = delete;

  /// The refusal, or nothing.
  std::string run(const std::string& sql) {
    if (sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK) return "";
    return sqlite3_errmsg(handle_);
  }

  /// The first column of every row, empty where it is missing.
  std::vector<std::string> column(const std::string& sql) {
    std::vector<std::string> cells;
    const auto append = [](void* target, int, char** values, char**) {
      static_cast<std::vector<std::string>*>(target)->emplace_back(values[0] != nullptr ? values[0]
                                                                                        : "");
      return 0;
    };
    EXPECT_EQ(sqlite3_exec(handle_, sql.c_str(), append, &cells, nullptr), SQLITE_OK)
        << sqlite3_errmsg(handle_);
    return cells;
  }

 private:
  sqlite3* handle_ = nullptr;
};

/// A study with three sessions, the last one completed: attempt 1 is invalid, 2 is the valid one of
/// trial 1, both of session 1.
void fill(const std::filesystem::path& folder) {
  auto [study, session_id] = study_with_session(folder, 2);
  AttemptRow invalid = some_attempt(1);
  invalid.outcome = AttemptOutcome::not_compliant;
  invalid.valid = false;
  invalid.invalid_reason = "force out of band";
  study.add_attempt(session_id, invalid);
  AttemptRow valid = some_attempt(1, 2);
  valid.recording = RecordingRow{.path = "recordings/r",
                                 .format = "asperity.recording/1",
                                 .sha256 = std::string(64, 'b'),
                                 .records = 1,
                                 .bytes = 1};
  study.add_attempt(session_id, valid);
  study.add_event(session_id, {.time_ns = 1, .kind = "note"});
  study.add_session_answer(session_id, {.question = "q", .answer = "a", .source = "keyboard"});
  SessionRow files = some_session(1);
  files.files = {{.path = "stimuli/a", .sha256 = std::string(64, 'c'), .bytes = 1}};
  const std::int64_t second = study.add_session(files, some_plan(1));
  study.begin_segment(second, 0);
  study.end_segment(second, 1, 1, "pause");
  study.begin_segment(second, 2);
  AttemptRow of_second = some_attempt(1);
  of_second.segment = 2;
  study.add_attempt(second, of_second);
  study.end_session(second, SessionState::stopped, kNow);
  study.add_participant({.label = "Person"});
  study.end_output(study.begin_output({.kind = OutputKind::report, .path = "/report.pdf"}));
  study.add_participant({.label = "Withdrawn"});
  study.withdraw("Withdrawn", {.data = WithdrawnData::deleted, .decided_by = "somebody"});
  const std::int64_t completed = study.add_session(some_session(1), some_plan(1));
  study.begin_segment(completed, 0);
  study.end_session(completed, SessionState::completed, "2026-03-01T10:00:00Z");
  study.add_decision(session_id, {.trial = 1,
                                  .attempt = 1,
                                  .verdict = Verdict::flag,
                                  .reason = "a noise outside",
                                  .decided_utc = kNow});
}

struct Forbidden {
  const char* what;
  std::string sql;
};

const std::string kServoValues =
    ", 1000, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 'none', 0, 0, 0)";

/// Without the codes of its reasons.
std::string attempt(const std::string& values) {
  return "INSERT INTO attempt SELECT *, NULL, NULL, 'trial' FROM (VALUES " + values + ")";
}
std::string session(const std::string& participant, const std::string& ordinal,
                    const std::string& mode, const std::string& group = "group_level") {
  return "INSERT INTO session SELECT NULL, " + participant + ", " + ordinal + ", protocol_id, " +
         mode +
         ", state, seed, generator, counterbalance_row, program_version, program_commit, "
         "program_build, program_sha256, instruction_set, os, device, device_json, pacing, "
         "scheduling, rate_Hz, started_utc, clock_zero_ns, ended_utc, consent_version, "
         "consent_utc, observer_json, mirrored, " +
         group + ", expected_trials FROM session WHERE id = 1";
}

std::string decision(const std::string& values) {
  return "INSERT INTO decision VALUES (" + values + ", 'because', '', '" + kNow + "', NULL)";
}

std::vector<Forbidden> forbidden_statements() {
  return {
      {"update decision", "UPDATE decision SET verdict = 'exclude'"},
      {"delete decision", "DELETE FROM decision"},
      {"decision replaced", "INSERT OR REPLACE" + decision("1, 1, 1, 1, 'include'").substr(6)},
      {"decision about no session", decision("NULL, 99, NULL, NULL, 'exclude'")},
      {"decision about no attempt", decision("NULL, 1, 1, 7, 'exclude'")},
      {"unknown verdict", decision("NULL, 1, 1, 1, 'forget'")},
      {"whole session set aside", decision("NULL, 1, NULL, NULL, 'set_aside'")},
      {"attempt without its trial", decision("NULL, 1, NULL, 1, 'exclude'")},
      {"decision without a reason",
       "INSERT INTO decision VALUES (NULL, 1, 1, 1, 'exclude', '', '', '" + kNow + "', NULL)"},
      {"set aside in a session that is over", decision("NULL, 2, 1, 1, 'set_aside'")},
      {"other layout", "UPDATE session SET mirrored = 1 WHERE id = 1"},
      {"second valid attempt", attempt("(9,1,1,3,1,'answered',1,NULL,0,NULL,0,1)")},
      {"invalid without reason", attempt("(9,1,2,1,1,'aborted',0,NULL,0,NULL,0,1)")},
      {"valid with a reason why not", attempt("(9,1,2,1,1,'answered',1,'x',0,NULL,0,1)")},
      {"flagged without reason", attempt("(9,1,2,1,1,'answered',1,NULL,1,NULL,0,1)")},
      {"aborted and valid", attempt("(9,1,2,1,1,'aborted',1,NULL,0,NULL,0,1)")},
      {"unknown outcome", attempt("(9,1,2,1,1,'happy',0,'x',0,NULL,0,1)")},
      {"over before it began", attempt("(9,1,2,1,1,'answered',1,NULL,0,NULL,2,1)")},
      {"segment of no session", attempt("(9,1,2,1,7,'answered',1,NULL,0,NULL,0,1)")},
      {"segment of another session", attempt("(9,1,2,1,2,'answered',1,NULL,0,NULL,0,1)")},
      {"unplanned trial", attempt("(9,1,99,1,1,'answered',1,NULL,0,NULL,0,1)")},
      {"trial of another session", attempt("(9,2,2,1,1,'answered',1,NULL,0,NULL,0,1)")},
      {"attempt id taken by replacing",
       "INSERT OR REPLACE INTO attempt VALUES "
       "(2,1,2,1,1,'answered',1,NULL,0,NULL,0,1,NULL,NULL,'trial')"},
      {"attempt replaced by its key",
       "INSERT OR REPLACE INTO attempt VALUES "
       "(9,1,1,2,1,'aborted',0,'x',0,NULL,0,1,NULL,NULL,'trial')"},
      {"valid attempt replaced",
       "INSERT OR REPLACE INTO attempt VALUES "
       "(9,1,1,3,1,'answered',1,NULL,0,NULL,0,1,NULL,NULL,'trial')"},
      {"attempt upserted",
       "INSERT INTO attempt VALUES (2,1,1,2,1,'answered',1,NULL,0,NULL,0,1,NULL,NULL,'trial') "
       "ON CONFLICT DO UPDATE SET flagged = 0, flag_reason = NULL"},
      {"update attempt", "UPDATE attempt SET valid = 0, invalid_reason = 'x' WHERE id = 2"},
      {"update or replace attempt", "UPDATE OR REPLACE attempt SET id = 1 WHERE id = 2"},
      {"delete attempt", "DELETE FROM attempt WHERE id = 1"},
      {"update presentation", "UPDATE presentation SET item = 'Z'"},
      {"delete presentation", "DELETE FROM presentation"},
      {"replace presentation",
       "INSERT OR REPLACE INTO presentation VALUES "
       "(2,1,'r','i','s','m','1','t','{}','1',NULL,NULL,NULL,0,NULL,NULL,500,0,0,0)"},
      {"presentation of no attempt",
       "INSERT INTO presentation VALUES "
       "(99,1,'r','i','s','m','1','t','{}','1',NULL,NULL,NULL,0,NULL,NULL,500,0,0,0)"},
      {"text in a number",
       "INSERT INTO presentation VALUES "
       "(2,3,'r','i','s','m','1','t','{}','1',NULL,NULL,NULL,'long',NULL,NULL,500,0,0,0)"},
      {"parameters that are not JSON",
       "INSERT INTO presentation VALUES "
       "(2,3,'r','i','s','m','1','t','{','1',NULL,NULL,NULL,0,NULL,NULL,500,0,0,0)"},
      {"fewer gaps than none",
       "INSERT INTO presentation VALUES "
       "(2,3,'r','i','s','m','1','t','{}','1',NULL,NULL,NULL,0,NULL,NULL,500,0,0,-1)"},
      {"update presentation_asset", "UPDATE presentation_asset SET role = 'other'"},
      {"delete presentation_asset", "DELETE FROM presentation_asset"},
      {"replace presentation_asset",
       "INSERT OR REPLACE INTO presentation_asset VALUES (2,1,'tool','" + std::string(64, 'a') +
           "')"},
      {"presentation_asset of no presentation",
       "INSERT INTO presentation_asset VALUES (2,9,'tool','" + std::string(64, 'a') + "')"},
      {"an asset's hash that is none",
       "INSERT INTO presentation_asset VALUES (2,2,'tool','stone')"},
      {"an asset without a role",
       "INSERT INTO presentation_asset VALUES (2,2,'','" + std::string(64, 'a') + "')"},
      {"update model_limit", "UPDATE model_limit SET ticks = 0"},
      {"delete model_limit", "DELETE FROM model_limit"},
      {"replace model_limit", "INSERT OR REPLACE INTO model_limit VALUES (2,1,'folded',7)"},
      {"model_limit of no presentation", "INSERT INTO model_limit VALUES (2,9,'folded',7)"},
      {"fewer ticks than none", "INSERT INTO model_limit VALUES (2,1,'other',-1)"},
      {"update response", "UPDATE response SET answer = 'A'"},
      {"delete response", "DELETE FROM response"},
      {"replace response",
       "INSERT OR REPLACE INTO response VALUES "
       "(NULL,2,'which',1,'A',NULL,NULL,'[]',0,NULL,NULL,'keyboard')"},
      {"replace response by id",
       "INSERT OR REPLACE INTO response VALUES "
       "(1,2,'other',1,'A',NULL,NULL,'[]',0,NULL,NULL,'keyboard')"},
      {"response of no attempt",
       "INSERT INTO response VALUES "
       "(NULL,99,'which',1,'A',NULL,NULL,'[]',0,NULL,NULL,'keyboard')"},
      {"negative reaction time",
       "INSERT INTO response VALUES "
       "(NULL,2,'new',1,'A',NULL,NULL,'[]',0,-0.1,NULL,'keyboard')"},
      {"response without source",
       "INSERT INTO response VALUES (NULL,2,'new',1,'A',NULL,NULL,'[]',0,NULL,NULL,'')"},
      {"neither right nor wrong",
       "INSERT INTO response VALUES (NULL,2,'new',1,'A',NULL,2,'[]',0,NULL,NULL,'keyboard')"},
      {"update servo_quality", "UPDATE servo_quality SET lost_records = 0"},
      {"delete servo_quality", "DELETE FROM servo_quality"},
      {"replace servo_quality", "INSERT OR REPLACE INTO servo_quality VALUES (2" + kServoValues},
      {"servo_quality of no attempt", "INSERT INTO servo_quality VALUES (99" + kServoValues},
      {"update compliance", "UPDATE compliance SET passed = 1"},
      {"delete compliance", "DELETE FROM compliance"},
      {"replace compliance",
       "INSERT OR REPLACE INTO compliance VALUES "
       "(NULL,2,1,'contact_s',NULL,NULL,0,0,0,0,0,NULL,NULL)"},
      {"compliance of no attempt",
       "INSERT INTO compliance VALUES (NULL,99,1,'contact_s',NULL,NULL,0,0,0,0,0,NULL,NULL)"},
      {"compliance of an unknown quantity",
       "INSERT INTO compliance VALUES (NULL,2,1,'mood',NULL,NULL,0,0,0,0,0,NULL,NULL)"},
      {"fraction above 1",
       "INSERT INTO compliance VALUES (NULL,2,2,'contact_s',NULL,NULL,0,0,0,0,0,1.5,NULL)"},
      {"update visit", "UPDATE visit SET contact_s = 1"},
      {"delete visit", "DELETE FROM visit"},
      {"replace visit", "INSERT OR REPLACE INTO visit VALUES (2,1,1,0,1,1,0,NULL,NULL,0,0)"},
      {"visit of no presentation", "INSERT INTO visit VALUES (2,9,1,0,1,1,0,NULL,NULL,0,0)"},
      {"visit without contact", "INSERT INTO visit VALUES (2,1,7,0,1,0,0,NULL,NULL,0,0)"},
      {"visit that ends before it begins",
       "INSERT INTO visit VALUES (2,1,7,1,0,1,0,NULL,NULL,0,0)"},
      {"spread of a force without its mean",
       "INSERT INTO visit VALUES (2,1,7,0,1,1,0,NULL,0.1,0,0)"},
      {"update instability", "UPDATE instability SET buzz = 0"},
      {"delete instability", "DELETE FROM instability"},
      {"replace instability",
       "INSERT OR REPLACE INTO instability VALUES "
       "(2,1,NULL,NULL,NULL,'too_short',NULL,NULL,NULL,NULL,NULL,'too_short',NULL,NULL,'no_crests'"
       ")"},
      {"instability of no presentation",
       "INSERT INTO instability VALUES "
       "(2,9,NULL,NULL,NULL,'too_short',NULL,NULL,NULL,NULL,NULL,'too_short',NULL,NULL,'no_crests'"
       ")"},
      {"neither a buzz nor the reason why there is none",
       "INSERT INTO instability VALUES "
       "(2,2,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'too_short',NULL,NULL,'no_crests')"},
      {"a buzz and a reason why there is none",
       "INSERT INTO instability VALUES "
       "(2,2,0.1,0.01,7,'too_short',NULL,NULL,NULL,NULL,NULL,'too_short',NULL,NULL,'no_crests')"},
      {"a buzz without its force",
       "INSERT INTO instability VALUES "
       "(2,2,0.1,NULL,7,NULL,NULL,NULL,NULL,NULL,NULL,'too_short',NULL,NULL,'no_crests')"},
      {"a share of crests above 1",
       "INSERT INTO instability VALUES "
       "(2,2,NULL,NULL,NULL,'too_short',NULL,NULL,NULL,NULL,NULL,'too_short',1.5,1,NULL)"},
      {"update recording", "UPDATE recording SET path = 'recordings/other'"},
      {"delete recording", "DELETE FROM recording"},
      {"replace recording",
       "INSERT OR REPLACE INTO recording VALUES (2,'n','f'," + kHash + ",1,1)"},
      {"recording of the same path",
       "INSERT OR REPLACE INTO recording VALUES (1,'recordings/r','f'," + kHash + ",1,1)"},
      {"recording with a bad hash", "INSERT INTO recording VALUES (1,'n','f','XYZ',1,1)"},
      {"recording of no attempt", "INSERT INTO recording VALUES (99,'n','f'," + kHash + ",1,1)"},
      {"update event", "UPDATE event SET text = 'x'"},
      {"delete event", "DELETE FROM event"},
      {"replace event", "INSERT OR REPLACE INTO event VALUES (1,1,NULL,0,'k','','null',NULL)"},
      {"event of no session", "INSERT INTO event VALUES (NULL,99,NULL,0,'k','','null',NULL)"},
      {"event of an attempt of another session",
       "INSERT INTO event VALUES (NULL,2,1,0,'k','','null',NULL)"},
      {"update session_answer", "UPDATE session_answer SET answer = 'b'"},
      {"delete session_answer", "DELETE FROM session_answer"},
      {"replace session_answer",
       "INSERT OR REPLACE INTO session_answer VALUES "
       "(NULL,1,'q',1,'b',NULL,NULL,'[]',0,NULL,NULL,'keyboard')"},
      {"session_answer of no session",
       "INSERT INTO session_answer VALUES (NULL,99,'q',1,'b',NULL,NULL,'[]',0,NULL,NULL,'k')"},
      {"update trial", "UPDATE trial SET plan_json = '{}'"},
      {"delete trial", "DELETE FROM trial"},
      {"replace trial",
       "INSERT OR REPLACE INTO trial VALUES (1,1,'b',1,'main',1,'{}','{}',NULL,NULL,0)"},
      {"trial that is not JSON",
       "INSERT INTO trial VALUES (1,9,'b',1,'main',1,'{','{}',NULL,NULL,0)"},
      {"trial of no session",
       "INSERT INTO trial VALUES (99,1,'b',1,'main',1,'{}','{}',NULL,NULL,0)"},
      {"step without a track", "INSERT INTO trial VALUES (1,9,'b',1,'main',1,'{}','{}',NULL,1,0)"},
      {"step zero", "INSERT INTO trial VALUES (1,9,'b',1,'main',1,'{}','{}',1,0,0)"},
      {"catch trial of a track", "INSERT INTO trial VALUES (1,9,'b',1,'main',0,'{}','{}',1,1,1)"},
      {"catch trial with a repetition",
       "INSERT INTO trial VALUES (1,9,'b',1,'main',1,'{}','{}',NULL,NULL,1)"},
      {"catch trial of a third kind",
       "INSERT INTO trial VALUES (1,9,'b',1,'main',0,'{}','{}',NULL,NULL,2)"},
      {"attempt for no purpose",
       "INSERT INTO attempt VALUES (9,1,1,3,1,'aborted',0,'x',0,NULL,0,1,NULL,NULL,'fun')"},
      {"refresher of a main trial",
       "INSERT INTO attempt VALUES (9,1,1,3,1,'aborted',0,'x',0,NULL,0,1,NULL,NULL,'refresher')"},
      {"track zero", "INSERT INTO trial VALUES (1,9,'b',1,'main',1,'{}','{}',0,1,0)"},
      {"expected trials of a session", "UPDATE session SET expected_trials = 3 WHERE id = 1"},
      {"update protocol", "UPDATE protocol SET source = ''"},
      {"delete protocol", "DELETE FROM protocol"},
      {"replace protocol",
       "INSERT OR REPLACE INTO protocol VALUES (1,'n','v','k','d'," + kHash + ",'')"},
      {"update session_file", "UPDATE session_file SET sha256 = " + kHash},
      {"delete session_file", "DELETE FROM session_file"},
      {"replace session_file",
       "INSERT OR REPLACE INTO session_file VALUES (2,'stimuli/a'," + kHash + ",1)"},
      {"session_file of no session",
       "INSERT INTO session_file VALUES (99,'stimuli/a'," + kHash + ",1)"},
      {"same label twice",
       "INSERT INTO participant VALUES "
       "(NULL,'P01',0,NULL,NULL,NULL,'{}','2026-01-01T00:00:00Z',0)"},
      {"participant replaced",
       "INSERT OR REPLACE INTO participant VALUES "
       "(NULL,'P01',0,NULL,NULL,NULL,'{}','2026-01-01T00:00:00Z',0)"},
      {"label with a space",
       "INSERT INTO participant VALUES (NULL,'P "
       "1',0,NULL,NULL,NULL,'{}','2026-01-01T00:00:00Z',0)"},
      {"empty label",
       "INSERT INTO participant VALUES (NULL,'',0,NULL,NULL,NULL,'{}','2026-01-01T00:00:00Z',0)"},
      {"withdrawn no more",
       "UPDATE participant SET withdrawn = 1 WHERE label = 'Person'; "
       "UPDATE participant SET withdrawn = 0 WHERE label = 'Person'"},
      {"session of a withdrawn participant", session("2", "1", "'run'")},
      {"update output", "UPDATE output SET path = '/elsewhere'"},
      {"blank the path of an output without a withdrawal", "UPDATE output SET path = ''"},
      {"complete an output again", "UPDATE output SET made_utc = '2027-01-01T00:00:00Z'"},
      {"incomplete output again", "UPDATE output SET made_utc = NULL"},
      {"output without a path",
       "INSERT INTO output VALUES (NULL,'report','','0','2026-01-01T00:00:00Z')"},
      {"delete output", "DELETE FROM output"},
      {"replace output",
       "INSERT OR REPLACE INTO output VALUES (1,'report','/r','0','2026-01-01T00:00:00Z')"},
      {"output of no kind", "INSERT INTO output VALUES (NULL,'','/r','0','2026-01-01T00:00:00Z')"},
      {"update withdrawal", "UPDATE withdrawal SET sessions = 0"},
      {"label of a withdrawal that is complete", "UPDATE withdrawal SET label = 'P01'"},
      {"label of a withdrawal whose data are kept",
       "INSERT INTO withdrawal VALUES "
       "(NULL,'kept',0,'other','x','2026-01-01T00:00:00Z',0,0,0,0,'P77',2)"},
      {"participant whose data are being deleted",
       "INSERT INTO withdrawal VALUES "
       "(NULL,'deleted',0,'other','x','2026-01-01T00:00:00Z',0,0,0,0,'P77',NULL); "
       "INSERT INTO participant VALUES "
       "(NULL,'P77',0,NULL,NULL,NULL,'{}','2026-01-01T00:00:00Z',0)"},
      {"delete withdrawal", "DELETE FROM withdrawal"},
      {"replace withdrawal",
       "INSERT OR REPLACE INTO withdrawal VALUES "
       "(1,'kept',0,'other','x','2026-01-01T00:00:00Z',0,0,0,0,NULL,1)"},
      {"withdrawal that nobody decided",
       "INSERT INTO withdrawal VALUES "
       "(NULL,'kept',0,'other','','2026-01-01T00:00:00Z',0,0,0,0,NULL,2)"},
      {"withdrawal that keeps nobody's data",
       "INSERT INTO withdrawal VALUES "
       "(NULL,'kept',0,'other','x','2026-01-01T00:00:00Z',0,0,0,0,NULL,NULL)"},
      {"withdrawal of another participant", "UPDATE withdrawal SET participant_id = 2"},
      {"virtual no more", "UPDATE participant SET is_virtual = 0 WHERE label = 'P01'"},
      {"another label", "UPDATE participant SET label = 'P99' WHERE label = 'P01'"},
      {"participant with sessions removed", "DELETE FROM participant WHERE label = 'P01'"},
      {"same session twice", session("1", "1", "mode")},
      {"session replaced", "INSERT OR REPLACE" + session("1", "1", "mode").substr(6)},
      {"session of nobody", session("99", "1", "'run'")},
      {"completed session reopened", "UPDATE session SET state = 'open' WHERE id = 3"},
      {"attempt in a completed session", attempt("(9,3,1,1,1,'answered',1,NULL,0,NULL,0,1)")},
      {"a person simulated", session("2", "1", "'simulate'")},
      {"session in another group", session("1", "9", "mode", "'visual'")},
      {"session in a group without a name", session("2", "9", "'run'", "''")},
      {"group of a session", "UPDATE session SET group_level = 'visual' WHERE id = 1"},
      {"session of an unknown mode", session("1", "9", "'rehearse'")},
      {"another seed", "UPDATE session SET seed = '1' WHERE id = 1"},
      {"another observer", "UPDATE session SET observer_json = '{}' WHERE id = 1"},
      {"completed without an end", "UPDATE session SET state = 'completed' WHERE id = 1"},
      {"unknown state", "UPDATE session SET state = 'paused' WHERE id = 1"},
      {"delete session", "DELETE FROM session WHERE id = 1"},
      {"segment that ends twice",
       "UPDATE segment SET ended_ns = 9 WHERE session_id = 2 AND segment = 1"},
      {"segment that began elsewhere", "UPDATE segment SET started_ns = 0 WHERE session_id = 1"},
      {"delete segment", "DELETE FROM segment"},
      {"replace segment", "INSERT OR REPLACE INTO segment VALUES (1,1,0,NULL,NULL)"},
      {"segment of no session", "INSERT INTO segment VALUES (99,1,0,NULL,NULL)"},
      {"a second study",
       "INSERT INTO study (id, name, created_utc) VALUES (2,'x','2026-01-01T00:00:00Z')"},
  };
}

class Rules : public testing::TestWithParam<bool> {};

TEST_P(Rules, RefuseEveryForbiddenStatement) {
  const TemporaryFolder folder;
  fill(folder / "s");
  ForeignTool tool(folder / "s", GetParam());
  for (const Forbidden& forbidden : forbidden_statements()) {
    const std::string refusal = tool.run(forbidden.sql);
    EXPECT_NE(refusal, "") << forbidden.what;
    // It is refused for what it does, not because the statement of the test is wrong.
    EXPECT_THAT(refusal, testing::AnyOf(testing::HasSubstr("constraint failed"),
                                        testing::HasSubstr("append-only"),
                                        testing::HasSubstr("cannot store"),
                                        testing::ContainsRegex("^(a|an|of|the|there|only) ")))
        << forbidden.what;
  }
  const Study study = Study::open(folder / "s", Access::read_only);
  EXPECT_EQ(study.attempts(1).size(), 2U);
  EXPECT_EQ(study.attempts(1)[1].responses.size(), 2U);
  EXPECT_EQ(study.participant("P01")->is_virtual, true);
}

TEST_P(Rules, AllowWhatIsAsItShouldBe) {
  const TemporaryFolder folder;
  fill(folder / "s");
  ForeignTool tool(folder / "s", GetParam());
  EXPECT_EQ(tool.run(attempt("(9,1,2,1,1,'aborted',0,'x',0,NULL,0,1)")), "");
  EXPECT_EQ(tool.run("INSERT INTO event VALUES (NULL,1,9,0,'k','','null',NULL)"), "");
  EXPECT_EQ(tool.run("UPDATE participant SET age_years = 30 WHERE label = 'P01'"), "");
  EXPECT_EQ(tool.run("DELETE FROM participant WHERE label = 'Person'"), "");
  EXPECT_EQ(tool.run(session("1", "4", "'run'")), "");
  EXPECT_EQ(tool.run("UPDATE session SET state = 'stopped' WHERE id = 1"), "");
  EXPECT_EQ(tool.run("INSERT INTO output VALUES (NULL,'copy','/of/P77','0',NULL)"), "");
  EXPECT_EQ(tool.run("INSERT INTO withdrawal VALUES "
                     "(NULL,'deleted',0,'other','x','2026-01-01T00:00:00Z',0,0,0,0,'P77',NULL)"),
            "");
  EXPECT_EQ(tool.run("UPDATE output SET path = '' WHERE path = '/of/P77'"), "");
  EXPECT_EQ(tool.run("UPDATE withdrawal SET label = NULL WHERE label = 'P77'"), "");
  EXPECT_EQ(tool.run("DELETE FROM output WHERE made_utc IS NULL"), "");
}

// Without any one of the triggers, with everything else switched off, some forbidden statement
// passes: none of them is there for show, and the list above has missed none.
TEST(Trigger, IsEachNeeded) {
  const TemporaryFolder folder;
  fill(folder / "s");
  ForeignTool tool(folder / "s", false);
  const std::vector<std::string> triggers =
      tool.column("SELECT name FROM sqlite_schema WHERE type = 'trigger'");
  ASSERT_GT(triggers.size(), 40U);
  for (const std::string& trigger : triggers) {
    bool passed = false;
    tool.run("BEGIN");
    EXPECT_EQ(tool.run("DROP TRIGGER " + trigger), "");
    for (const Forbidden& forbidden : forbidden_statements()) {
      // A single statement that is refused changes nothing.
      const bool several = forbidden.sql.find(';') != std::string::npos;
      if (several) tool.run("SAVEPOINT before");
      passed = tool.run(forbidden.sql).empty();
      if (passed) break;
      if (several) tool.run("ROLLBACK TO before");
    }
    tool.run("ROLLBACK");
    EXPECT_TRUE(passed) << trigger;
  }
}

INSTANTIATE_TEST_SUITE_P(ForeignTools, Rules, testing::Values(false, true), [](const auto& param) {
  return param.param ? "WithForeignKeysAndRecursiveTriggers" : "WithEverythingSwitchedOff";
});

TEST(TidyViews, CallAnEmergencyStopAnEmergencyStop) {
  const TemporaryFolder folder;
  auto [study, session] = study_with_session(folder / "s", 2);
  for (int trial = 1; trial <= 2; ++trial) {
    AttemptRow attempt = some_attempt(trial, 1);
    attempt.outcome = trial == 1 ? AttemptOutcome::emergency_stop : AttemptOutcome::device_fault;
    attempt.valid = false;
    attempt.invalid_reason = "stopped";
    attempt.servo->fault = trial == 1 ? "emergency_stop" : "device";
    study.add_attempt(session, attempt);
  }
  ForeignTool tool(folder / "s", false);
  EXPECT_THAT(tool.column("SELECT outcome FROM tidy_attempt ORDER BY trial"),
              testing::ElementsAre("emergency_stop", "device_fault"));
}

TEST(TidyViews, GiveOneRowPerThingWithNaturalKeysFirst) {
  const TemporaryFolder folder;
  fill(folder / "s");
  ForeignTool tool(folder / "s", false);
  // onset 2 s on the clock whose zero is at 1 s
  EXPECT_THAT(tool.column("SELECT participant || ' ' || session || ' ' || "
                          "trial || ' ' || attempt || ' ' || outcome || ' ' || onset_s || ' ' || "
                          "duration_s || ' ' || ifnull(recording_path, '-') "
                          "FROM tidy_attempt WHERE session = 1"),
              testing::ElementsAre("P01 1 1 1 not_compliant 1.0 1.5 -",
                                   "P01 1 1 2 answered 1.0 1.5 recordings/r"));
  EXPECT_THAT(tool.column("SELECT attempt || question || answer FROM tidy_response "
                          "WHERE valid AND session = 1"),
              testing::ElementsAre("2whichB", "2confidencesure"));
  EXPECT_THAT(tool.column("SELECT attempt || position || item FROM tidy_presentation "
                          "WHERE valid AND session = 1"),
              testing::ElementsAre("21A", "22B"));
}

}  // namespace
}  // namespace asperity
