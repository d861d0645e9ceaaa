// What leaves a study as tables.

#include <algorithm>
#include <filesystem>
#include <set>
#include <stop_token>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/export_study.h"
#include "results_schema/atomic_file.h"
#include "results_schema/sha256.h"
#include "tests/app/made_up_study.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kProtocol = R"({
  "factors": {"spacing_m": {"levels": [0.001, 0.01], "meaning": "distance of the ridges",
                            "unit": "m"}},
  "questions": {"comment": {"prompt": "Anything else?", "form": "text"},
                "hand": {"prompt": "Which hand?", "form": "choice", "options": ["left", "right"]}}
})";

MadeUpTrial some_trial() {
  MadeUpTrial trial{};
  trial.factors_json = R"({"spacing_m": 0.01, "order": "first"})";
  trial.surfaces = {surface_of("stone", "height_map", "stone"),
                    surface_of("sinusoid", "sinusoid", "stone")};
  trial.surfaces[0].parameters_json = R"({"stiffness_N_per_m": 500.0})";
  trial.surfaces[1].parameters_json = R"({"stiffness_N_per_m": 500.0, "amplitude_m": 0.0001})";
  trial.answers = {"stone"};
  trial.right = {"stone"};
  trial.options = {"stone", "wood"};
  return trial;
}

ResponseRow session_answer(const std::string& question, const std::string& answer) {
  ResponseRow response{};
  response.question = question;
  response.answer = answer;
  response.time_ns = 5'500'000'000;
  response.source = "keyboard";
  return response;
}

/// A person and a virtual participant, with a session each.
void fill(MadeUpStudy& made) {
  ParticipantRow person{};
  person.label = "anna";
  person.sex = "F";
  person.answers_json = R"({"comment": "my name is Anna", "hand": "left"})";
  person.created_utc = "2001-02-03T04:05:06Z";
  made.study().add_participant(person);
  made.add_virtual("virtual0001", "M");
  const std::int64_t protocol = made.add_protocol("recognition", "recognition", kProtocol);
  const std::int64_t session = made.add_session("anna", protocol, {some_trial(), some_trial()});
  made.study().add_session_answer(session, session_answer("comment", "=SUM(A1)"));
  made.study().add_session_answer(session, session_answer("hand", "left"));
  made.add_session("virtual0001", protocol, {some_trial()}, SessionMode::simulate);
}

const ExportTable& table_of(const ExportTables& made, const std::string& name) {
  for (const ExportTable& table : made.tables) {
    if (table.name == name) return table;
  }
  throw std::runtime_error("no table " + name);
}

Cell cell_of(const Table& table, std::size_t row, const std::string& column) {
  const auto found = std::find(table.columns.begin(), table.columns.end(), column);
  if (found == table.columns.end()) throw std::runtime_error("no column " + column);
  return table.rows.at(row).at(static_cast<std::size_t>(found - table.columns.begin()));
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names{};
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

std::set<std::pair<std::string, std::string>> columns_in_codebook(const Table& codebook) {
  std::set<std::pair<std::string, std::string>> columns{};
  for (const std::vector<Cell>& row : codebook.rows) {
    columns.insert({std::get<std::string>(row[0]), std::get<std::string>(row[1])});
  }
  return columns;
}

TEST(Export, WritesTheTablesThatAreDocumented) {
  MadeUpStudy made;
  fill(made);
  export_study(made.study(), made.beside("out"), ExportAudience::own, Overwrite::refuse);
  EXPECT_THAT(names_in(made.beside("out")),
              ElementsAre("MANIFEST.tsv", "attempts.tsv", "codebook.tsv", "compliance.tsv",
                          "participants.tsv", "presentations.tsv", "responses.tsv",
                          "servo_quality.tsv", "sessions.tsv", "trials.tsv"));
  EXPECT_THAT(names_in(made.beside("")), ElementsAre("out", "study"));
}

TEST(Export, NamesEveryFileThatItWroteWithItsRows) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  std::vector<std::string> named{};
  for (const ExportedFile& file :
       export_study(made.study(), out, ExportAudience::own, Overwrite::refuse)) {
    named.push_back(file.name);
    EXPECT_EQ(file.rows, read_tsv(read_file(out / file.name), file.name).rows.size()) << file.name;
  }
  std::sort(named.begin(), named.end());
  const auto there = names_in(out);
  EXPECT_EQ(named, std::vector<std::string>(there.begin(), there.end()));
}

TEST(Export, LeavesNothingBehindWhenItIsStopped) {
  MadeUpStudy made;
  fill(made);
  std::stop_source stop{};
  const auto progress = [&stop](double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LT(fraction, 1.0);
    stop.request_stop();
  };
  EXPECT_TRUE(export_study(made.study(), made.beside("out"), ExportAudience::own, Overwrite::refuse,
                           stop.get_token(), progress)
                  .empty());
  EXPECT_TRUE(stop.stop_requested()) << "it tells how far it is";
  EXPECT_THAT(names_in(made.beside("")), ElementsAre("study"));
}

TEST(Export, DescribesEveryColumnInTheCodebookAndNoOther) {
  MadeUpStudy made;
  fill(made);
  for (const ExportAudience audience : {ExportAudience::own, ExportAudience::published}) {
    const std::filesystem::path out =
        made.beside(audience == ExportAudience::own ? "own" : "published");
    export_study(made.study(), out, audience, Overwrite::refuse);
    const Table codebook = read_tsv(read_file(out / "codebook.tsv"), "codebook.tsv");
    std::set<std::pair<std::string, std::string>> columns{};
    for (const std::string& name : names_in(out)) {
      if (name == "codebook.tsv" || name == "MANIFEST.tsv") continue;
      for (const std::string& column : read_tsv(read_file(out / name), name).columns) {
        columns.insert({name, column});
      }
    }
    EXPECT_EQ(columns_in_codebook(codebook), columns);
    EXPECT_EQ(codebook.rows.size(), columns.size());
  }
}

TEST(Export, LeavesNoCellEmptyAndMissesNoneThatTheCodebookPromises) {
  MadeUpStudy made;
  fill(made);
  const ExportTables tables = export_tables(made.study(), ExportAudience::own);
  std::size_t described = 0;
  for (const ExportTable& table : tables.tables) {
    for (const std::string& column : table.table.columns) {
      const std::vector<Cell>& description = tables.codebook.rows.at(described++);
      for (std::size_t row = 0; row < table.table.rows.size(); ++row) {
        const Cell cell = cell_of(table.table, row, column);
        EXPECT_NE(cell, Cell{""}) << column;
        if (description[8] == Cell{"never"}) {
          EXPECT_NE(cell, Cell{}) << column;
        }
      }
    }
  }
  EXPECT_EQ(described, tables.codebook.rows.size());
}

TEST(Export, BeginsEveryTableWithItsKeysAndSaysWhoIsVirtual) {
  MadeUpStudy made;
  fill(made);
  const ExportTables tables = export_tables(made.study(), ExportAudience::own);
  const std::vector<std::string> keys{"participant", "session", "trial", "attempt"};
  const std::map<std::string, std::size_t> depth{
      {"participants", 1},  {"sessions", 2},  {"trials", 3},        {"attempts", 4},
      {"presentations", 4}, {"responses", 4}, {"servo_quality", 4}, {"compliance", 4}};
  for (const ExportTable& table : tables.tables) {
    std::vector<std::string> expected(
        keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(depth.at(table.name)));
    expected.insert(expected.end(), {"virtual", "mode"});
    const std::vector<std::string>& columns = table.table.columns;
    ASSERT_GE(columns.size(), expected.size());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), columns.begin())) << table.name;
  }
  const Table& sessions = table_of(tables, "sessions").table;
  EXPECT_EQ(cell_of(sessions, 0, "virtual"), Cell{std::int64_t{0}});
  EXPECT_EQ(cell_of(sessions, 0, "mode"), Cell{"run"});
  EXPECT_EQ(cell_of(sessions, 1, "virtual"), Cell{std::int64_t{1}});
  EXPECT_EQ(cell_of(sessions, 1, "mode"), Cell{"simulate"});
}

TEST(Export, HasOneRowPerThing) {
  MadeUpStudy made;
  fill(made);
  const ExportTables tables = export_tables(made.study(), ExportAudience::own);
  std::map<std::string, std::size_t> rows{};
  for (const ExportTable& table : tables.tables) rows[table.name] = table.table.rows.size();
  const std::map<std::string, std::size_t> expected{
      {"participants", 2},  {"sessions", 2},  {"trials", 3},        {"attempts", 3},
      {"presentations", 6}, {"responses", 5}, {"servo_quality", 0}, {"compliance", 0}};
  EXPECT_EQ(rows, expected);
}

TEST(Export, GivesEachFactorAColumnWithTheProtocolsWords) {
  MadeUpStudy made;
  fill(made);
  const ExportTables tables = export_tables(made.study(), ExportAudience::own);
  const Table& trials = table_of(tables, "trials").table;
  EXPECT_EQ(cell_of(trials, 0, "factor_spacing_m"), Cell{0.01});
  EXPECT_EQ(cell_of(trials, 0, "factor_order"), Cell{"first"});
  const auto row = std::find_if(
      tables.codebook.rows.begin(), tables.codebook.rows.end(),
      [](const std::vector<Cell>& cells) { return cells[1] == Cell{"factor_spacing_m"}; });
  ASSERT_NE(row, tables.codebook.rows.end());
  EXPECT_EQ((*row)[2], Cell{"distance of the ridges"});
  EXPECT_EQ((*row)[3], Cell{"number"});
  EXPECT_EQ((*row)[4], Cell{"m"});
  EXPECT_EQ((*row)[5], Cell{"0.01"});
}

TEST(Export, GivesEachParameterOfAModelAColumn) {
  MadeUpStudy made;
  fill(made);
  const ExportTables tables = export_tables(made.study(), ExportAudience::own);
  const Table& surfaces = table_of(tables, "presentations").table;
  EXPECT_EQ(cell_of(surfaces, 0, "parameter_amplitude_m"), Cell{});
  EXPECT_EQ(cell_of(surfaces, 1, "parameter_amplitude_m"), Cell{0.0001});
  EXPECT_EQ(cell_of(surfaces, 0, "parameter_stiffness_N_per_m"), Cell{500.0});
  const auto row = std::find_if(tables.codebook.rows.begin(), tables.codebook.rows.end(),
                                [](const std::vector<Cell>& cells) {
                                  return cells[1] == Cell{"parameter_stiffness_N_per_m"};
                                });
  ASSERT_NE(row, tables.codebook.rows.end());
  EXPECT_EQ((*row)[2], Cell{"parameter of the force model as rendered; of: height_map, sinusoid"});
  EXPECT_EQ((*row)[4], Cell{"N/m"});
}

// The made-up session's clock begins at 5 s, its first attempt at 6 s.
TEST(Export, CountsTimeFromTheBeginningOfTheSession) {
  MadeUpStudy made;
  fill(made);
  const ExportTables tables = export_tables(made.study(), ExportAudience::own);
  EXPECT_EQ(cell_of(table_of(tables, "attempts").table, 0, "onset_s"), Cell{1.0});
  EXPECT_EQ(cell_of(table_of(tables, "responses").table, 0, "time_s"), Cell{0.5});
}

TEST(Export, PutsAnswersToTheSessionsQuestionsAmongTheResponses) {
  MadeUpStudy made;
  fill(made);
  const ExportTables tables = export_tables(made.study(), ExportAudience::own);
  const Table& responses = table_of(tables, "responses").table;
  EXPECT_EQ(cell_of(responses, 0, "question"), Cell{"comment"});
  EXPECT_EQ(cell_of(responses, 0, "trial"), Cell{});
  EXPECT_EQ(cell_of(responses, 0, "attempt"), Cell{});
  // Data stay as they are, even where a spreadsheet would take them for a formula.
  EXPECT_EQ(cell_of(responses, 0, "answer"), Cell{"=SUM(A1)"});
  EXPECT_EQ(cell_of(responses, 2, "trial"), Cell{std::int64_t{1}});
}

TEST(Export, IsOrderedByNaturalKeysWhateverTheOrderOfWriting) {
  MadeUpStudy first;
  MadeUpStudy second;
  for (MadeUpStudy* made : {&first, &second}) {
    const bool forwards = made == &first;
    const std::vector<std::string> labels =
        forwards ? std::vector<std::string>{"a", "b"} : std::vector<std::string>{"b", "a"};
    for (const std::string& label : labels) made->add_person(label, "F");
    const std::int64_t protocol = made->add_protocol("recognition", "recognition", kProtocol);
    for (const std::string& label : labels) made->add_session(label, protocol, {some_trial()});
    export_study(made->study(), made->beside("out"), ExportAudience::own, Overwrite::refuse);
  }
  for (const std::string& name : names_in(first.beside("out"))) {
    EXPECT_EQ(read_file(first.beside("out") / name), read_file(second.beside("out") / name))
        << name;
  }
}

TEST(Export, TellsThePublicNeitherDatesNorFreeText) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  export_study(made.study(), out, ExportAudience::published, Overwrite::refuse);
  for (const std::string& name : names_in(out)) {
    const std::string text = read_file(out / name);
    EXPECT_THAT(text, Not(HasSubstr("2001-02-03"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("my name is"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("=SUM"))) << name;
  }
  const Table responses = read_tsv(read_file(out / "responses.tsv"), "responses.tsv");
  EXPECT_EQ(cell_of(responses, 0, "answer"), Cell{});
  EXPECT_EQ(cell_of(responses, 1, "answer"), Cell{"left"});
  EXPECT_EQ(cell_of(responses, 2, "answer"), Cell{"stone"});
  const Table participants = read_tsv(read_file(out / "participants.tsv"), "participants.tsv");
  EXPECT_EQ(cell_of(participants, 0, "answer_hand"), Cell{"left"});
}

TEST(Export, SaysInTheManifestWhatIsThereAndWhatThePublicDoesNotGet) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  export_study(made.study(), out, ExportAudience::published, Overwrite::refuse);
  const Table manifest = read_tsv(read_file(out / "MANIFEST.tsv"), "MANIFEST.tsv");
  ASSERT_EQ(manifest.rows.size(), 9u);
  for (const std::vector<Cell>& row : manifest.rows) {
    const std::string& name = std::get<std::string>(row[0]);
    EXPECT_EQ(row[2], Cell{sha256_of(read_file(out / name))}) << name;
  }
  EXPECT_EQ(cell_of(manifest, 0, "left_out"), Cell{"created_utc answer_comment"});
}

TEST(Export, RefusesAFolderThatHoldsSomething) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  export_study(made.study(), out, ExportAudience::own, Overwrite::refuse);
  EXPECT_THROW(export_study(made.study(), out, ExportAudience::own, Overwrite::refuse),
               ResultsError);
  export_study(made.study(), out, ExportAudience::published, Overwrite::allow);
  EXPECT_THAT(read_file(out / "sessions.tsv"), Not(HasSubstr("started_utc")));
}

TEST(Export, NeverThrowsAwayAFileThatNoExportWrote) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  std::filesystem::create_directory(out);
  write_file(out / "thesis.txt", "years of work", Overwrite::refuse);
  try {
    export_study(made.study(), out, ExportAudience::own, Overwrite::allow);
    FAIL() << "nothing was refused";
  } catch (const ResultsError& error) {
    EXPECT_THAT(error.what(), HasSubstr("thesis.txt"));
  }
  EXPECT_THAT(names_in(out), ElementsAre("thesis.txt"));
  EXPECT_THAT(names_in(made.beside("")), ElementsAre("out", "study"));
}

TEST(Export, TakesAnEmptyFolderAndOneWithASlashAtItsEnd) {
  MadeUpStudy made;
  fill(made);
  std::filesystem::create_directory(made.beside("empty"));
  export_study(made.study(), made.beside("empty"), ExportAudience::own, Overwrite::refuse);
  export_study(made.study(), made.beside("deep") / "er" / "", ExportAudience::own,
               Overwrite::refuse);
  EXPECT_THAT(names_in(made.beside("empty")), Contains("trials.tsv"));
  EXPECT_THAT(names_in(made.beside("deep") / "er"), Contains("trials.tsv"));
}

TEST(Export, ReadsAStudyThatMayNotBeWritten) {
  MadeUpStudy made;
  fill(made);
  const Study reader = Study::open(made.folder(), Access::read_only);
  const ExportTables tables = export_tables(reader, ExportAudience::own);
  EXPECT_EQ(table_of(tables, "participants").table.rows.size(), 2u);
}

}  // namespace
}  // namespace asperity
