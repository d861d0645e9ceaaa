// What leaves a study for other programs: each format held to the rules of its specification.

#include <cmath>
#include <csignal>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <regex>
#include <sys/resource.h>

#include <fnmatch.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <readstat.h>
#include <zlib.h>

#include "app/exports/sav_table.h"
#include "results_schema/recording.h"
#include "results_schema/study.h"
#include "tests/app/exported_study.h"
#include "tests/app/sav_reading.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using Rows = std::vector<std::vector<std::string>>;

/// RFC 4180, taken at its word: CR LF, quotes doubled.
Rows csv(const std::string& text) {
  Rows rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      rows.back().back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\r') {
      EXPECT_EQ(text.substr(i, 2), "\r\n");
      ++i;
      if (i + 1 < text.size()) rows.push_back({""});
    } else {
      EXPECT_TRUE(quoted || c != '\n');
      rows.back().back() += c;
    }
  }
  EXPECT_FALSE(quoted);
  return rows;
}

std::string unpacked(const std::filesystem::path& path) {
  const gzFile file = gzopen(path.c_str(), "rb");
  std::string text(1 << 20, '\0');
  const int bytes = gzread(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  text.resize(static_cast<std::size_t>(std::max(bytes, 0)));
  return text;
}

const Sav::Variable& variable_of(const Sav& file, const std::string& name) {
  for (const Sav::Variable& variable : file.variables) {
    if (variable.name == name) return variable;
  }
  throw std::runtime_error("no variable " + name);
}

nlohmann::json json_in(const std::filesystem::path& path) {
  return nlohmann::json::parse(read_file(path));
}

/// Ticks at these times since 6 s, which is 1 s after the session's clock began.
RecordingRow record(MadeUpStudy& made, const std::vector<std::int64_t>& times_us) {
  RecordingWriter writer(made.folder(), "recordings/anna/a.rec",
                         {.rate_Hz = 1000.0,
                          .columns = {{.name = "x_m", .unit = "m", .meaning = "position"},
                                      {.name = "fz_N", .unit = "N", .meaning = "force"}}});
  for (const std::int64_t time_us : times_us) {
    const float values[] = {0.1F, -0.5F};
    writer.append(6'000'000'000 + time_us * 1'000, values);
  }
  return writer.finish();
}

/// `fill`, with a recorded trial, an unanswered one, a pilot, and what is awkward in a text.
void fill_all(MadeUpStudy& made) {
  fill(made);
  made.add_person("ben", "M");
  const std::int64_t protocol = made.add_protocol("a_selection", "selection", R"({
      "title": "Which one?",
      "factors": {"texture": {"levels": ["metal", "wood"], "meaning": "what is shown"}},
      "blocks": {"main": {"question": {"name": "which", "prompt": "Which was it, \"a\" or b?"}}}})");
  const auto trial = [](const std::string& texture, const std::string& answer) {
    MadeUpTrial made_trial = some_trial();
    made_trial.factors_json = R"({"texture": ")" + texture + "\"}";
    made_trial.answers = {answer};
    made_trial.right = {};
    return made_trial;
  };
  MadeUpTrial recorded = trial("metal", "=1+1, \"or\"\nmore");
  recorded.recording = record(made, {0, 1000, 2000, 5000});  // two of them lost
  MadeUpTrial silent = trial("wood", "");
  silent.answers = {};
  silent.outcome = AttemptOutcome::skipped;
  silent.valid = false;
  made.add_session("anna", protocol, {recorded, trial("wood", "stone"), silent});
  made.add_session("ben", protocol, {trial("metal", "stone")}, SessionMode::pilot);
}

ExportOptions everything() {
  ExportOptions options{};
  options.formats.insert(ExportFormat::physio);
  return options;
}

class ExportFormats : public testing::Test {
 protected:
  ExportFormats() {
    fill_all(made_);
    export_to(made_, out_, everything());
  }
  MadeUpStudy made_{};
  std::filesystem::path out_ = made_.beside("out");
};

// Columns of every file: the names in its first line, or in its sidecar, or in its head.
std::vector<std::string> columns_of(const std::filesystem::path& file) {
  const std::string name = file.filename();
  if (name.ends_with(".csv")) return csv(read_file(file)).front();
  if (name.ends_with(".tsv")) return read_tsv(read_file(file), name).columns;
  std::vector<std::string> columns{};
  if (name.ends_with(".sav")) {
    for (const Sav::Variable& variable : sav(file).variables) columns.push_back(variable.name);
  }
  return columns;
}

TEST_F(ExportFormats, DescribeEveryColumnOfEveryFileInTheCodebookAndNoOther) {
  for (const ExportAudience audience : {ExportAudience::own, ExportAudience::published}) {
    const std::filesystem::path out =
        made_.beside(audience == ExportAudience::own ? "own" : "published");
    ExportOptions options = everything();
    options.audience = audience;
    export_to(made_, out, options);
    std::set<std::pair<std::string, std::string>> unused{};
    for (const auto& entry : columns_in_codebook(table_in(out, "codebook.tsv"))) {
      EXPECT_TRUE(unused.insert(entry).second) << entry.first << " " << entry.second;
    }
    const auto described = unused;
    std::size_t columns = 0;
    for (const std::string& name : files_in(out)) {
      for (const std::string& column : columns_of(out / name)) {
        ++columns;
        bool found = false;
        for (const auto& [file, of_file] : described) {
          if (of_file != column || fnmatch(file.c_str(), name.c_str(), 0) != 0) continue;
          found = true;
          unused.erase({file, of_file});
        }
        EXPECT_TRUE(found) << name << ": " << column;
      }
    }
    EXPECT_GT(columns, 650U);
    EXPECT_TRUE(unused.empty()) << unused.begin()->first << ": " << unused.begin()->second;
  }
}

TEST_F(ExportFormats, GiveTheSameBytesForTheSameStudy) {
  export_to(made_, made_.beside("again"), everything());
  const auto files = files_in(out_);
  EXPECT_EQ(files_in(made_.beside("again")), files);
  for (const std::string& name : files) {
    EXPECT_TRUE(read_file(out_ / name) == read_file(made_.beside("again") / name)) << name;
  }
}

TEST_F(ExportFormats, KeepPilotsAndVirtualParticipantsApart) {
  const auto people = [this](const std::string& name) {
    std::vector<std::string> labels{};
    for (const std::vector<std::string>& row : csv(read_file(out_ / name))) {
      labels.push_back(row[0]);
    }
    return labels;
  };
  EXPECT_THAT(people("wide.csv"), ElementsAre("participant", "anna"));
  EXPECT_THAT(people("pilot/wide.csv"), ElementsAre("participant", "ben"));
  EXPECT_THAT(people("virtual/wide.csv"), ElementsAre("participant", "virtual0001"));
  for (const std::string& name : files_in(out_)) {
    const bool is_apart = name.starts_with("pilot/") || name.starts_with("virtual/");
    const bool is_of_all = name.ends_with(".tsv") && !name.starts_with("bids/");
    if (is_apart || is_of_all) continue;
    EXPECT_THAT(read_file(out_ / name), Not(HasSubstr("virtual0001"))) << name;
    EXPECT_THAT(name, Not(HasSubstr("ben"))) << name;
  }
}

// A spreadsheet takes a cell for a formula by its first character, quoted or not.
TEST_F(ExportFormats, LeaveNoTextThatASpreadsheetTakesForAFormula) {
  std::size_t marked = 0;
  for (const std::string& name : files_in(out_)) {
    Rows rows{};
    if (name.ends_with(".csv")) rows = csv(read_file(out_ / name));
    if (name.ends_with(".tsv")) {
      std::istringstream text(read_file(out_ / name));
      for (std::string line; std::getline(text, line);) {
        rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
      }
    }
    for (const std::vector<std::string>& row : rows) {
      for (const std::string& cell : row) {
        if (!cell.empty() && cell.front() == '\'') ++marked;
        const bool looks_like_one = !cell.empty() && std::string("=+-@").find(cell[0]) < 4;
        EXPECT_TRUE(!looks_like_one || number_in(cell)) << name << ": " << cell;
      }
    }
  }
  EXPECT_GE(marked, 4U);  // the answer and the comment, in each form
}

TEST_F(ExportFormats, KeepATextAsItWasTypedWhereTheFormatCan) {
  const Rows rows =
      csv(read_file(out_ / "psychds/data/subject-anna_session-02_task-aselection_data.csv"));
  const auto column = static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), "answer") -
                                               rows[0].begin());
  EXPECT_EQ(rows[1][column], "'=1+1, \"or\"\nmore");
  const Sav trials = sav(out_ / "trials.sav");
  EXPECT_TRUE(std::any_of(trials.rows.begin(), trials.rows.end(), [](const auto& row) {
    return row.at("answer") == "=1+1, \"or\"\nmore";
  }));
}

TEST_F(ExportFormats, CountInTheWideTableWhatEachConditionGave) {
  const Rows rows = csv(read_file(out_ / "wide.csv"));
  std::map<std::string, std::string> anna{};
  ASSERT_EQ(rows.size(), 2U);
  for (std::size_t i = 0; i < rows[0].size(); ++i) anna[rows[0][i]] = rows[1][i];
  EXPECT_EQ(anna.at("recognition_which_correct"), "1");
  EXPECT_EQ(anna.at("recognition_which_n"), "2");
  EXPECT_EQ(anna.at("a_selection_which_wood_stone"), "1");
  EXPECT_EQ(anna.at("a_selection_which_metal_stone"), "0");
  EXPECT_EQ(anna.at("a_selection_which_metal_n"), "1");
  EXPECT_EQ(anna.at("answers"), "4");
  EXPECT_EQ(anna.at("answers_flagged"), "1");
  EXPECT_EQ(anna.at("session_hand"), "left");
  const Sav same = sav(out_ / "wide.sav");
  ASSERT_EQ(same.rows.size(), 1U);
  EXPECT_EQ(same.rows[0].at("recognition_which_correct"), "1");
}

// One of two correct with one texture, both with the other: three of four in all.
TEST(WideExport, HasTheProportionCorrectOfAllConditionsTogether) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  std::vector<MadeUpTrial> trials(4, some_trial());
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].factors_json = i < 2 ? R"({"texture": "metal"})" : R"({"texture": "wood"})";
  }
  trials[0].answers = {"wood"};
  made.set_state(SessionState::stopped);
  made.add_session("anna", made.add_protocol("recognition", "recognition"), trials);
  export_to(made, made.beside("out"));
  const Rows rows = csv(read_file(made.beside("out") / "wide.csv"));
  std::map<std::string, std::string> anna{};
  for (std::size_t i = 0; i < rows.at(0).size(); ++i) anna[rows[0][i]] = rows.at(1).at(i);
  EXPECT_EQ(anna.at("recognition_which_correct"), "0.75");
  EXPECT_EQ(anna.at("recognition_which_n"), "4");
  EXPECT_EQ(anna.at("recognition_which_metal_correct"), "0.5");
  EXPECT_EQ(anna.at("recognition_which_wood_correct"), "1");
  EXPECT_EQ(anna.at("sessions_unfinished"), "1");
}

/// A session of anna's by a protocol of this version, whose source differs by `texture`.
void add_version(MadeUpStudy& made, const std::string& version, const std::string& texture,
                 const std::vector<MadeUpTrial>& trials) {
  ProtocolRow protocol{};
  protocol.name = "sorting";
  protocol.version = version;
  protocol.kind = "recognition";
  protocol.design = "chapter";
  protocol.source = R"({"textures": {")" + texture + "\": {}}}";
  made.add_session("anna", made.study().add_protocol(protocol), trials);
}

std::map<std::string, std::string> only_row_of(const std::filesystem::path& file) {
  const Rows rows = csv(read_file(file));
  std::map<std::string, std::string> cells{};
  for (std::size_t i = 0; i < rows.at(0).size(); ++i) cells[rows[0][i]] = rows.at(1).at(i);
  EXPECT_EQ(rows.size(), 2U);
  return cells;
}

// 96, 91 and 110 after an anchor of 900: their mean is 99.
TEST(WideExport, LeavesAnchorsOutOfConditions) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  std::vector<MadeUpTrial> trials(4);
  const std::vector<double> numbers{900.0, 96.0, 91.0, 110.0};
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].surfaces = {surface_of("s", "sinusoid", "s")};
    trials[i].answers = {text_of_number(numbers[i])};
    trials[i].number = numbers[i];
  }
  trials[0].repetition = 0;
  made.add_session("anna", made.add_protocol("rough", "magnitude"), trials);
  export_to(made, made.beside("out"));
  const auto anna = only_row_of(made.beside("out") / "wide.csv");
  EXPECT_EQ(anna.at("rough_which_mean"), "99");
  EXPECT_EQ(anna.at("rough_which_n"), "3");
  EXPECT_EQ(anna.at("answers"), "3");
  EXPECT_EQ(anna.at("answers_left_out"), "0");
  const auto same = sav(made.beside("out") / "wide.sav").rows.at(0);
  EXPECT_EQ(same.at("rough_which_mean"), "99");
  EXPECT_EQ(same.at("rough_which_n"), "3");
}

TEST(WideExport, KeepsTheVersionsOfAProtocolApart) {
  MadeUpStudy made;
  fill(made);
  MadeUpTrial wrong = some_trial();
  wrong.answers = {"wood"};
  add_version(made, "1.0.0", "a", {some_trial()});
  add_version(made, "9.9.9", "b", {wrong, wrong});
  export_to(made, made.beside("out"));
  const auto anna = only_row_of(made.beside("out") / "wide.csv");
  EXPECT_FALSE(anna.contains("sorting_which_n"));
  EXPECT_EQ(anna.at("sorting_1_0_0_which_n"), "1");
  EXPECT_EQ(anna.at("sorting_1_0_0_which_correct"), "1");
  EXPECT_EQ(anna.at("sorting_9_9_9_which_n"), "2");
  EXPECT_EQ(anna.at("sorting_9_9_9_which_correct"), "0");
  EXPECT_TRUE(anna.contains("recognition_which_n")) << "a single version is not named";
  EXPECT_EQ(sav(made.beside("out") / "wide.sav").rows.at(0).at("sorting_9_9_9_which_n"), "2");
  const std::string codebook = read_file(made.beside("out") / "codebook.tsv");
  EXPECT_THAT(codebook, HasSubstr("number of responses of sorting 9.9.9, "));
  EXPECT_THAT(codebook, HasSubstr("number of responses of recognition 1, "));
}

TEST(WideExport, KeepsTwoSourcesOfOneVersionApart) {
  MadeUpStudy made;
  fill(made);
  add_version(made, "1.0.0", "a", {some_trial()});
  add_version(made, "1.0.0", "b", {some_trial(), some_trial()});
  export_to(made, made.beside("out"));
  std::multiset<std::string> counts{};
  const std::regex of_source("sorting_1_0_0_[0-9a-f]{8}_which_n");
  for (const auto& [column, cell] : only_row_of(made.beside("out") / "wide.csv")) {
    if (std::regex_match(column, of_source)) counts.insert(cell);
  }
  EXPECT_THAT(counts, ElementsAre("1", "2"));
  EXPECT_THAT(read_file(made.beside("out") / "codebook.tsv"),
              testing::ContainsRegex("responses of sorting 1.0.0 \\(source [0-9a-f]{8}\\), "));
}

TEST(WideExport, CountsLanguagesOfOneVersionTogether) {
  MadeUpStudy made;
  fill(made);
  const auto hold = [&made](const std::string& source, const std::string& feels) {
    ProtocolRow protocol{};
    protocol.name = "sorting";
    protocol.version = "1.0.0";
    protocol.kind = "recognition";
    protocol.design = "chapter";
    protocol.source = source;
    const std::int64_t session =
        made.add_session("anna", made.study().add_protocol(protocol), {some_trial()});
    made.study().add_session_answer(session, session_answer("feel", feels));
  };
  hold(R"({"title": "Sorting", "questions": {"feel": {"form": "choice", "prompt": "Your hand?",
           "options": ["good", "bad"]}}, "flow": [{"screen": "Hello."}]})",
       "good");
  hold(R"({"language": "de", "title": "Sortieren", "questions": {"feel": {"form": "choice",
           "prompt": "Ihre Hand?", "options": [{"value": "good", "text": "gut"},
           {"value": "bad", "text": "schlecht"}]}}, "flow": [{"screen": "Guten Tag."}]})",
       "bad");
  export_to(made, made.beside("out"));
  const auto anna = only_row_of(made.beside("out") / "wide.csv");
  EXPECT_EQ(anna.at("sorting_which_n"), "2");
  EXPECT_EQ(anna.at("session_feel"), "bad");
}

TEST(WideExport, KeepsTwoFilesOfOneLanguageApart) {
  MadeUpStudy made;
  fill(made);
  for (const char* prompt : {"Which is rougher?", "Which is smoother?"}) {
    ProtocolRow protocol{};
    protocol.name = "sorting";
    protocol.version = "1.0.0";
    protocol.kind = "recognition";
    protocol.design = "chapter";
    protocol.source =
        R"({"questions": {"feel": {"form": "text", "prompt": ")" + std::string(prompt) + R"("}}})";
    made.add_session("anna", made.study().add_protocol(protocol), {some_trial()});
  }
  export_to(made, made.beside("out"));
  EXPECT_FALSE(only_row_of(made.beside("out") / "wide.csv").contains("sorting_which_n"));
}

// "It hurts" to another question than before, and to the same question of another protocol.
TEST(WideExport, KeepsAnswersToQuestionsOfAVersionApart) {
  MadeUpStudy made;
  fill(made);
  const auto ask = [&made](const std::string& name, const std::string& version,
                           const std::string& prompt, const std::string& answer) {
    ProtocolRow protocol{};
    protocol.name = name;
    protocol.version = version;
    protocol.kind = "recognition";
    protocol.design = "chapter";
    protocol.source = R"({"title": ")" + name +
                      R"(", "questions": {"feel": {"form": "choice", "options": ["a", "b", "c"],
                          "prompt": ")" +
                      prompt + "\"}}}";
    const std::int64_t session =
        made.add_session("anna", made.study().add_protocol(protocol), {some_trial()});
    made.study().add_session_answer(session, session_answer("feel", answer));
  };
  ask("sorting", "1.0.0", "Your hand?", "a");
  ask("sorting", "2.0.0", "Your arm?", "b");
  ask("choosing", "1.0.0", "Your hand?", "c");
  export_to(made, made.beside("out"));
  const auto anna = only_row_of(made.beside("out") / "wide.csv");
  EXPECT_EQ(anna.at("session_sorting_1_0_0_feel"), "a");
  EXPECT_EQ(anna.at("session_sorting_2_0_0_feel"), "b");
  EXPECT_EQ(anna.at("session_choosing_feel"), "c");
  EXPECT_EQ(anna.at("session_hand"), "left") << "asked by one protocol";
  EXPECT_FALSE(anna.contains("session_feel"));
  EXPECT_THAT(read_file(made.beside("out") / "codebook.tsv"),
              HasSubstr("of the last session with sorting 2.0.0: Your arm?\t"));
}

// "feel" of sorting and of choosing, and "sorting_feel" of choosing: one name, three questions.
TEST(WideExport, NumbersColumnsWhoseNamesWouldBeTheSame) {
  MadeUpStudy made;
  fill(made);
  const auto ask = [&made](const std::string& name,
                           const std::vector<std::pair<std::string, std::string>>& answers) {
    const std::int64_t session = made.add_session(
        "anna", made.add_protocol(name, "recognition", R"({"questions": {}})"), {some_trial()});
    for (const auto& [question, answer] : answers) {
      made.study().add_session_answer(session, session_answer(question, answer));
    }
  };
  ask("choosing", {{"feel", "a"}, {"sorting_feel", "b"}});
  ask("sorting", {{"feel", "c"}});
  export_to(made, made.beside("out"));
  const auto anna = only_row_of(made.beside("out") / "wide.csv");
  EXPECT_EQ(anna.at("session_choosing_feel"), "a");
  const std::string codebook = read_file(made.beside("out") / "codebook.tsv");
  for (const auto& [question, answer] :
       {std::pair{"sorting_feel of the last session with choosing", "b"},
        std::pair{"feel of the last session with sorting", "c"}}) {
    const std::regex row("(session_sorting_feel(_2)?)\t[^\n]*question " + std::string(question));
    std::smatch found{};
    ASSERT_TRUE(std::regex_search(codebook, found, row)) << question;
    EXPECT_EQ(anna.at(found[1]), answer) << question;
  }
}

// The release of a kernel can bear an institution's name.
TEST(PublicExport, TellsTheSystemsNameAndNothingElseOfTheMachine) {
  MadeUpStudy made;
  made.add_person("kim", "F");
  made.add_session("kim", made.add_protocol("sorting", "recognition"), {some_trial()});
  for (const ExportAudience audience : {ExportAudience::own, ExportAudience::published}) {
    const bool is_public = audience == ExportAudience::published;
    const std::filesystem::path out = made.beside(is_public ? "public" : "own");
    export_to(made, out, options_of(audience));
    for (const std::string& name : files_in(out)) {
      const bool tells = read_file(out / name).find("6.1.0-made-up") != std::string::npos;
      EXPECT_FALSE(is_public && tells) << name;
    }
    const Table sessions = table_in(out, "sessions.tsv");
    EXPECT_EQ(std::count(sessions.columns.begin(), sessions.columns.end(), "os"),
              is_public ? 0 : 1);
    const nlohmann::json sidecar =
        json_in(out / "bids/sub-kim/ses-01/beh/sub-kim_ses-01_task-sorting_beh.json");
    EXPECT_EQ(sidecar.at("StimulusPresentation").at("OperatingSystem"),
              is_public ? "Linux" : "Linux 6.1.0-made-up x86_64");
  }
}

// A comma is not what every spreadsheet splits at, and some skip blanks before they look for "=".
TEST(TextsOfAnExport, AreNoFormulaAfterATabALineBreakOrASemicolon) {
  MadeUpStudy made;  // for its folder
  const std::vector<Cell> row{"\t=1", "\r=1", "x;=HYPERLINK(1)", "a\tb"};
  TableFile comma(made.beside("a.csv"), TableFile::Format::csv, {"a", "b", "c", "d"});
  comma.add(row);
  EXPECT_EQ(comma.finish().marked_cells, 2U);
  EXPECT_EQ(read_file(made.beside("a.csv")),
            "a,b,c,d\r\n'\t=1,\"'\r=1\",\"x;=HYPERLINK(1)\",a\tb\r\n");
  TableFile tab(made.beside("a.tsv"), TableFile::Format::tsv, {"a", "b", "c", "d"});
  tab.add(row);
  EXPECT_EQ(tab.finish().marked_cells, 2U);
  EXPECT_EQ(read_file(made.beside("a.tsv")), "a\tb\tc\td\n' =1\t' =1\tx;=HYPERLINK(1)\ta b\n");
}

TEST(SavExport, CountsOptionsThatItCutsAndKeepsThemApart) {
  MadeUpStudy made;  // for its folder
  const std::string alike(119, 'a');
  ExportColumn column{};
  column.name = "answer";
  column.type = "text";
  column.levels = {alike + " one", alike + " two", "short"};
  SavTable table({column}, made.beside(""));
  for (const std::string& level : column.levels) table.add({level});
  EXPECT_EQ(table.write(made.beside("a.sav"), "title").cut_cells, 2U);
  const Sav read = sav(made.beside("a.sav"));
  const auto& labels = read.value_labels.at(read.variables.at(0).labels);
  EXPECT_EQ(labels.at(1.0), std::string(117, 'a') + "…");
  EXPECT_EQ(labels.at(2.0), std::string(113, 'a') + "… (2)");
  EXPECT_EQ(labels.at(3.0), "short");
}

// A limit on the size of files fails a write as a full disk does.
TEST(SavExport, NamesTheFolderWhereItsRowsDoNotFit) {
  MadeUpStudy made;  // for its folder
  ExportColumn column{};
  column.name = "answer";
  column.type = "text";
  SavTable table({column}, made.beside(""));
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = refusal_of<ResultsError>([&] {
    for (int row = 0; row < 100; ++row) table.add({std::string(1000, 'x')});
  });
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(message, testing::AllOf(testing::HasSubstr("SPSS table"),
                                      testing::HasSubstr(made.beside("").string()),
                                      testing::HasSubstr("then export again")));
}

TEST_F(ExportFormats, TellSpssWhatItsNumbersMean) {
  const Sav trials = sav(out_ / "trials.sav");
  ASSERT_EQ(trials.rows.size(), 5U);
  for (const Sav::Variable& variable : trials.variables) {
    EXPECT_FALSE(variable.label.empty()) << variable.name;
    EXPECT_LE(variable.label.size(), 256U) << variable.name;
    EXPECT_NE(variable.measure, READSTAT_MEASURE_UNKNOWN) << variable.name;
  }
  const Sav::Variable& texture = variable_of(trials, "factor_texture");
  EXPECT_EQ(texture.measure, READSTAT_MEASURE_NOMINAL);
  EXPECT_EQ(texture.label, "what is shown");
  EXPECT_EQ(trials.value_labels.at(texture.labels).at(1.0), "metal");
  EXPECT_EQ(trials.value_labels.at(texture.labels).at(-1.0), "the trial does not have this factor");
  EXPECT_EQ(texture.missing_ranges, 1);
  EXPECT_EQ(variable_of(trials, "from_cue_s").measure, READSTAT_MEASURE_SCALE);
  EXPECT_THAT(variable_of(trials, "from_cue_s").label, HasSubstr("[s]"));
  const Sav::Variable& valid = variable_of(trials, "valid");
  EXPECT_EQ(trials.value_labels.at(valid.labels).at(1.0), "yes");
  std::multiset<std::string> textures{};
  for (const auto& row : trials.rows) textures.insert(row.at("factor_texture"));
  EXPECT_EQ(textures, (std::multiset<std::string>{"-1", "-1", "1", "2", "2"}));
  EXPECT_EQ(trials.rows.back().at("answer"), "");
  EXPECT_EQ(trials.rows.back().at("from_cue_s"), ".");
}

/// Every column of a table, or of a recording, has a description in the sidecar next to it.
void expect_described_columns(const std::filesystem::path& dataset, const std::string& name) {
  SCOPED_TRACE(name);
  const std::string start = name.substr(0, name.find('.'));
  std::vector<std::string> columns{};
  if (name.ends_with(".tsv")) columns = table_in(dataset, name).columns;
  if (name.ends_with(".tsv.gz")) json_in(dataset / (start + ".json")).at("Columns").get_to(columns);
  for (const std::string& column : columns) {
    const nlohmann::json sidecar = json_in(dataset / (start + ".json"));
    ASSERT_TRUE(sidecar.contains(column)) << column;
    EXPECT_NE(sidecar.at(column).value("Description", ""), "") << column;
  }
}

// [BIDS 1.10.0]: names of entities in their order, columns that have to come first, sidecars.
TEST_F(ExportFormats, FollowTheRulesOfBids) {
  const std::regex beh(
      "sub-([0-9A-Za-z]+)/ses-([0-9A-Za-z]+)/beh/sub-\\1_ses-\\2_task-[0-9A-Za-z]+"
      "(_(beh|events)\\.(tsv|json)|(_run-[0-9]+)_recording-[0-9A-Za-z]+_physio\\.(tsv\\.gz|json))");
  const std::set<std::string> at_top{
      ".bids-validator-config.json", "CHANGES",           "README",
      "dataset_description.json",    "participants.json", "participants.tsv"};
  for (const char* const root : {"bids", "pilot/bids", "virtual/bids"}) {
    const std::filesystem::path bids = out_ / root;
    const nlohmann::json description = json_in(bids / "dataset_description.json");
    EXPECT_TRUE(description.at("Name").is_string());
    const std::string name_and_readme =
        description.at("Name").get<std::string>() + '\n' + read_file(bids / "README");
    for (const char* const whom : {"virtual", "pilot"}) {
      EXPECT_EQ(std::regex_search(name_and_readme,
                                  std::regex(std::string("\\(") + whom + " [a-z]+\\)\n.*" + whom)),
                std::string(root).starts_with(whom))
          << root << ": whoever has this folder alone is told whose answers these are";
    }
    EXPECT_EQ(description.at("BIDSVersion"), "1.10.0");
    EXPECT_EQ(description.at("DatasetType"), "raw");
    const Table participants = table_in(bids, "participants.tsv");
    ASSERT_EQ(participants.columns.front(), "participant_id");
    std::set<std::string> listed{};
    for (const auto& row : participants.rows) listed.insert(std::get<std::string>(row[0]));
    std::set<std::string> there{};
    for (const std::string& name : files_in(bids)) {
      EXPECT_TRUE(at_top.contains(name) || std::regex_match(name, beh)) << name;
      if (!at_top.contains(name)) there.insert(name.substr(0, name.find('/')));
      expect_described_columns(bids, name);
      if (!name.ends_with("_beh.tsv")) continue;
      const nlohmann::json sidecar = json_in(bids / (name.substr(0, name.size() - 4) + ".json"));
      EXPECT_TRUE(sidecar.at("TaskName").is_string());
      std::string task = sidecar.at("TaskName");
      std::erase_if(task, [](char letter) { return std::isalnum(letter) == 0; });
      EXPECT_THAT(name, HasSubstr("_task-" + task + "_"));
      const Table rows = table_in(bids, name);
      for (const std::string& column : rows.columns) {
        EXPECT_TRUE(std::regex_match(column, std::regex("[a-zA-Z0-9_]+"))) << column;
      }
      EXPECT_GT(rows.rows.size(), 0U);
      for (const auto& row : rows.rows) EXPECT_EQ(row.size(), rows.columns.size());
    }
    EXPECT_EQ(listed, there);
    const std::map<std::string, std::set<std::string>> words{
        {"sex", {"F", "M", "O"}}, {"handedness", {"left", "right", "ambidextrous"}}};
    for (std::size_t row = 0; row < participants.rows.size(); ++row) {
      for (const auto& [column, allowed] : words) {
        const Cell cell = cell_of(participants, row, column);
        EXPECT_TRUE(cell == Cell{} || allowed.contains(std::get<std::string>(cell))) << column;
      }
    }
    EXPECT_EQ(json_in(bids / "participants.json").at("age").at("Units"), "year");
  }
}

// The validator warns of participants with other files than the first one, unless the dataset itself states that it is meant.
TEST(BidsExport, StatesThatParticipantsHaveDifferentFiles) {
  MadeUpStudy made;
  const std::int64_t sorting = made.add_protocol("sorting", "recognition");
  const std::int64_t choosing = made.add_protocol("choosing", "selection");
  const auto ignored = [&made](const std::string& out) {
    export_to(made, made.beside(out));
    const std::filesystem::path file = made.beside(out) / "bids/.bids-validator-config.json";
    return std::filesystem::exists(file) ? json_in(file).at("ignore") : nlohmann::json::array();
  };
  made.add_person("anna", "F");
  made.add_person("kim", "M");
  made.add_session("anna", sorting, {some_trial()});
  made.add_session("kim", sorting, {some_trial()});
  made.study().set_metadata({.authors = {"Doe, Jane", "Roe, Richard"}});
  EXPECT_EQ(ignored("balanced"), nlohmann::json::array());
  made.study().set_metadata({.authors = {"Doe, Jane"}});
  EXPECT_EQ(ignored("one_author"), (nlohmann::json{"TOO_FEW_AUTHORS"}));
  made.study().set_metadata({.authors = {"Doe, Jane", "Roe, Richard"}});
  made.add_person("lee", "F");
  made.add_session("lee", choosing, {some_trial()});
  EXPECT_EQ(ignored("mixed"), (nlohmann::json{"INCONSISTENT_SUBJECTS"}));
  made.add_session("lee", sorting, {some_trial()});
  EXPECT_EQ(ignored("second_session"),
            (nlohmann::json{"INCONSISTENT_SUBJECTS", "MISSING_SESSION"}));
  const std::filesystem::path dataset = made.beside("second_session") / "bids";
  for (const std::string& name : files_in(dataset)) expect_described_columns(dataset, name);
}

TEST(BidsExport, HasItsOwnWordsForSexAndUnits) {
  MadeUpStudy made;
  made.add_person("kim", "X");
  const std::int64_t protocol = made.add_protocol("sorting", "recognition", R"({"factors": {
          "acceleration_m_per_s2": {"unit": "m/s2"}, "damping_N_s_per_m": {"unit": "N s/m"}}})");
  MadeUpTrial trial = some_trial();
  trial.factors_json = R"({"acceleration_m_per_s2": 1.5, "damping_N_s_per_m": 2.5})";
  made.add_session("kim", protocol, {trial});
  export_to(made, made.beside("out"));
  const std::filesystem::path bids = made.beside("out") / "bids";
  EXPECT_EQ(cell_of(table_in(bids, "participants.tsv"), 0, "sex"), Cell{"O"});
  EXPECT_EQ(cell_of(table_in(made.beside("out"), "participants.tsv"), 0, "sex"), Cell{"X"});
  const nlohmann::json sidecar =
      json_in(bids / "sub-kim/ses-01/beh/sub-kim_ses-01_task-sorting_beh.json");
  EXPECT_EQ(sidecar.at("factor_acceleration_m_per_s2").at("Units"), "m/s^2");
  EXPECT_EQ(sidecar.at("factor_damping_N_s_per_m").at("Units"), "N.s/m");
}

TEST_F(ExportFormats, WriteARecordingAsOneRegularStream) {
  const std::filesystem::path folder = out_ / "bids/sub-anna/ses-02/beh";
  const std::string start = "sub-anna_ses-02_task-aselection_run-01_recording-haptic_physio";
  const nlohmann::json sidecar = json_in(folder / (start + ".json"));
  EXPECT_EQ(sidecar.at("SamplingFrequency"), 1000.0);
  EXPECT_EQ(sidecar.at("StartTime"), 1.0);  // the session's clock begins at 5 s
  EXPECT_THAT(sidecar.at("Columns").get<std::vector<std::string>>(),
              ElementsAre("time_s", "x_m", "fz_N"));
  EXPECT_EQ(sidecar.at("fz_N").at("Units"), "N");
  EXPECT_EQ(unpacked(folder / (start + ".tsv.gz")),
            "1\t0.1\t-0.5\n1.001\t0.1\t-0.5\n1.002\t0.1\t-0.5\nn/a\tn/a\tn/a\nn/a\tn/a\tn/a\n"
            "1.005\t0.1\t-0.5\n");
  const std::string head = read_file(folder / (start + ".tsv.gz")).substr(0, 8);
  EXPECT_EQ(head.substr(3, 5), std::string(5, '\0')) << "no name and no time";
  const Table rows = table_in(folder, "sub-anna_ses-02_task-aselection_beh.tsv");
  EXPECT_EQ(cell_of(rows, 0, "run"), Cell{"1"});
  EXPECT_EQ(cell_of(rows, 1, "run"), Cell{});
}

/// The physio file of a single attempt whose ticks were at these times, row by row; "" for a gap.
std::vector<std::string> rows_of_ticks(const std::vector<std::int64_t>& times_us) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  MadeUpTrial trial = some_trial();
  trial.recording = record(made, times_us);
  made.add_session("anna", made.add_protocol("sorting", "recognition"), {trial});
  export_to(made, made.beside("out"), everything());
  std::istringstream lines(
      unpacked(made.beside("out") /
               "bids/sub-anna/ses-01/beh/"
               "sub-anna_ses-01_task-sorting_run-01_recording-haptic_physio.tsv.gz"));
  std::vector<std::string> times{};
  for (std::string line; std::getline(lines, line);) {
    const std::string time = line.substr(0, line.find('\t'));
    times.push_back(time == "n/a" ? "" : time);
  }
  return times;
}

TEST(PhysioExport, MakesNoRowsOfJitter) {
  // One tick comes late and the next ones on time.
  EXPECT_THAT(rows_of_ticks({0, 1000, 2900, 3000, 4010, 4990}),
              ElementsAre("1", "1.001", "1.0029", "1.003", "1.00401", "1.00499"));
  // Late by more than half a period, from the second tick on and from the first one on.
  EXPECT_THAT(rows_of_ticks({0, 400, 1400, 2600}), ElementsAre("1", "1.0004", "1.0014", "1.0026"));
  EXPECT_THAT(rows_of_ticks({0, 1700, 2600, 3500, 4000}),
              ElementsAre("1", "1.0017", "1.0026", "1.0035", "1.004"));
}

TEST(PhysioExport, StaysWithItsSamplingFrequencyWhateverTheJitterAddsUpTo) {
  std::vector<std::int64_t> times_us{};
  for (std::int64_t tick = 0; tick < 2000; ++tick) {
    const bool is_lost = tick % 400 == 399;
    if (!is_lost) times_us.push_back(tick * 1000 + (tick % 7 == 4 ? 800 : tick % 5 * 90));
  }
  const std::vector<std::string> rows = rows_of_ticks(times_us);
  EXPECT_EQ(rows.size(), 1999U) << "the last one is lost";
  EXPECT_EQ(std::count(rows.begin(), rows.end(), ""), 4);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (rows[row].empty()) continue;
    const double row_s = 1.0 + static_cast<double>(row) * 1e-3;
    EXPECT_LT(std::abs(number_in(rows[row]).value() - row_s), 1e-3) << row;
  }
}

TEST(PhysioExport, LosesNoTickOfALoopThatIsFasterThanItsRate) {
  std::vector<std::int64_t> times_us{};
  for (std::int64_t tick = 0; tick < 100; ++tick) times_us.push_back(tick * 900);
  const std::vector<std::string> rows = rows_of_ticks(times_us);
  EXPECT_EQ(rows.size(), 100U);
  EXPECT_THAT(rows, Not(Contains("")));
}

// The specification's rules for names, for the description and for what it has to describe.
TEST_F(ExportFormats, FollowTheRulesOfPsychDs) {
  const std::regex data_file("data/([a-z]+-[0-9A-Za-z]+)(_[a-z]+-[0-9A-Za-z]+)*_data\\.csv");
  for (const char* const root : {"psychds", "pilot/psychds", "virtual/psychds"}) {
    const nlohmann::json description = json_in(out_ / root / "dataset_description.json");
    EXPECT_THAT(description.at("@context").get<std::string>(), HasSubstr("schema.org"));
    EXPECT_EQ(description.at("@type"), "Dataset");
    EXPECT_TRUE(description.at("name").is_string());
    EXPECT_TRUE(description.at("description").is_string());
    for (const char* const whom : {"virtual", "pilot"}) {
      for (const char* const field : {"name", "description"}) {
        EXPECT_EQ(description.at(field).get<std::string>().find(whom) != std::string::npos,
                  std::string(root).starts_with(whom))
            << root << ' ' << field;
      }
    }
    std::set<std::string> measured{};
    for (const nlohmann::json& variable : description.at("variableMeasured")) {
      EXPECT_EQ(variable.at("@type"), "PropertyValue");
      EXPECT_TRUE(measured.insert(variable.at("name")).second);
    }
    std::size_t files = 0;
    for (const std::string& name : files_in(out_ / root)) {
      if (name == "dataset_description.json") continue;
      ++files;
      EXPECT_TRUE(std::regex_match(name, data_file)) << name;
      const Rows rows = csv(read_file(out_ / root / name));
      EXPECT_EQ(std::set<std::string>(rows[0].begin(), rows[0].end()), measured);
      for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size()) << name;
    }
    EXPECT_GT(files, 0U);
  }
}

}  // namespace
}  // namespace asperity
