// What leaves a study as tables.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <map>
#include <stop_token>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "analysis/numbers/number_text.h"
#include "app/exports/export_folder.h"
#include "app/exports/publication.h"
#include "app/findings/study/analyze_study.h"
#include "app/words/coded_phrases.h"
#include "app/words/offered_reasons.h"
#include "app/words/reason.h"
#include "renderers/built_in_models.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/tables/table.h"
#include "tests/app/exported_study.h"
#include "tests/app/sav_reading.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Export, WritesTheFilesThatAreDocumented) {
  MadeUpStudy made;
  fill(made);
  export_to(made, made.beside("out"));
  EXPECT_THAT(names_in(made.beside("out")),
              ElementsAre("MANIFEST.tsv", "README.txt", "attempts.tsv", "bids", "codebook.tsv",
                          "compliance.tsv", "events.json", "events.tsv", "import.R", "import.py",
                          "participants.tsv", "presentations.tsv", "psychds", "responses.tsv",
                          "servo_quality.tsv", "sessions.tsv", "stimuli.tsv", "trials.sav",
                          "trials.tsv", "virtual", "visits.tsv", "wide.csv", "wide.sav"));
  EXPECT_THAT(names_in(made.beside("out") / "virtual"),
              ElementsAre("bids", "psychds", "trials.sav", "wide.csv", "wide.sav"));
  EXPECT_THAT(names_in(made.beside("")), ElementsAre("out", "study"));
}

TEST(Export, WarnsOfLabelsThatDifferInLetterCaseOrLeadingZeros) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("selection", "selection");
  for (const char* const label : {"1", "01", "p2", "q2"}) {
    made.add_person(label, "F");
    made.add_session(label, protocol, {});
  }
  const ExportOutcome outcome = export_to(made, made.beside("out"), tables_only());
  ASSERT_EQ(outcome.warnings.size(), 1U);
  EXPECT_THAT(outcome.warnings[0].english(),
              HasSubstr("The labels 01 and 1 differ only in letter case or leading zeros"));
  EXPECT_THAT(read_file(made.beside("out") / "README.txt"), Not(HasSubstr("INCOMPLETE")));
}

TEST(Export, WritesWhatIsAskedForBesideTheTables) {
  MadeUpStudy made;
  fill(made);
  const Exported tables(made);
  EXPECT_EQ(names_in(tables.folder()).size(), 17U);
  EXPECT_THAT(names_in(tables.folder()), Not(Contains("wide.csv")));
  ExportOptions wide{};
  wide.formats = {ExportFormat::wide};
  export_to(made, made.beside("wide"), wide);
  EXPECT_THAT(names_in(made.beside("wide")), Contains("wide.csv"));
  EXPECT_THAT(names_in(made.beside("wide")), Not(Contains("wide.sav")));
}

TEST(Export, NamesEveryFileThatItWroteWithItsRows) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  std::vector<std::string> named{};
  const ExportOutcome outcome = export_to(made, out);
  for (const ExportedFile& file : outcome.files) {
    named.push_back(file.name);
    if (!file.name.ends_with(".tsv")) continue;
    EXPECT_EQ(file.rows, table_in(out, file.name).rows.size()) << file.name;
  }
  std::sort(named.begin(), named.end());
  const auto there = files_in(out);
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
  EXPECT_TRUE(export_study(made.study(), built_in_models(), made.beside("out"), {},
                           stop.get_token(), progress)
                  .files.empty());
  EXPECT_TRUE(stop.stop_requested()) << "it tells how far it is";
  EXPECT_THAT(names_in(made.beside("")), ElementsAre("study"));
}

TEST(Export, LeavesNoCellEmptyAndMissesNoneThatTheCodebookPromises) {
  const Exported& tables = exported_tables();
  std::size_t described = 0;
  for (const std::vector<Cell>& row : tables.codebook().rows) {
    const std::string& file = std::get<std::string>(row[0]);
    const std::string& column = std::get<std::string>(row[1]);
    if (file == "codebook.tsv") continue;
    ++described;
    const Table table = table_in(tables.folder(), file);
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const Cell cell = cell_of(table, i, column);
      EXPECT_NE(cell, Cell{""}) << column;
      if (row[8] == Cell{"never"}) {
        EXPECT_NE(cell, Cell{}) << column;
      }
    }
  }
  EXPECT_GT(described, 100U);
}

TEST(Export, BeginsEveryTableWithItsKeysAndSaysWhoIsVirtual) {
  const Exported& tables = exported_tables();
  const std::vector<std::string> keys{"participant", "session", "trial", "attempt"};
  const std::map<std::string, std::size_t> depth{
      {"participants", 1},  {"sessions", 2},  {"trials", 3},        {"attempts", 4},
      {"presentations", 4}, {"responses", 4}, {"servo_quality", 4}, {"compliance", 4},
      {"events", 4},        {"visits", 4}};
  for (const auto& [name, keys_of_table] : depth) {
    std::vector<std::string> expected(keys.begin(),
                                      keys.begin() + static_cast<std::ptrdiff_t>(keys_of_table));
    expected.insert(expected.end(), {"virtual", "mode"});
    const std::vector<std::string> columns = tables.table(name).columns;
    ASSERT_GE(columns.size(), expected.size());
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), columns.begin())) << name;
  }
  const Table sessions = tables.table("sessions");
  EXPECT_EQ(cell_of(sessions, 0, "virtual"), Cell{"0"});
  EXPECT_EQ(cell_of(sessions, 0, "mode"), Cell{"run"});
  EXPECT_EQ(cell_of(sessions, 1, "virtual"), Cell{"1"});
  EXPECT_EQ(cell_of(sessions, 1, "mode"), Cell{"simulate"});
}

TEST(Export, HasOneRowPerThing) {
  const Exported& tables = exported_tables();
  const std::map<std::string, std::size_t> expected{
      {"participants", 2},  {"sessions", 2},  {"trials", 3},        {"attempts", 3},
      {"presentations", 6}, {"responses", 5}, {"servo_quality", 0}, {"compliance", 0},
      {"events", 0},        {"visits", 0}};
  for (const auto& [name, rows] : expected) EXPECT_EQ(tables.table(name).rows.size(), rows) << name;
}

TEST(Export, GivesEachFactorAColumnWithTheProtocolsWords) {
  const Exported& tables = exported_tables();
  const Table trials = tables.table("trials");
  EXPECT_EQ(cell_of(trials, 0, "factor_spacing_m"), Cell{"0.01"});
  EXPECT_EQ(cell_of(trials, 0, "factor_order"), Cell{"first"});
  const Table codebook = tables.codebook();
  const auto row = std::find_if(
      codebook.rows.begin(), codebook.rows.end(),
      [](const std::vector<Cell>& cells) { return cells[1] == Cell{"factor_spacing_m"}; });
  ASSERT_NE(row, codebook.rows.end());
  EXPECT_EQ((*row)[2], Cell{"distance of the ridges"});
  EXPECT_EQ((*row)[3], Cell{"number"});
  EXPECT_EQ((*row)[4], Cell{"m"});
  EXPECT_EQ((*row)[5], Cell{"0.01"});
  EXPECT_EQ((*row)[6], Cell{"0.01"});
  EXPECT_EQ((*row)[10], Cell{"protocol recognition 1: /factors/spacing_m"});
}

// Practice ends when its criterion is reached; the rest of it stays in the plan.
TEST(Export, CountsTheAttemptsAtEveryPlannedTrial) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  MadeUpTrial practice = some_trial();
  practice.phase = "practice";
  practice.is_presented = false;
  made.add_session("anna", made.add_protocol("recognition", "recognition", kExportedProtocol),
                   {some_trial(), practice});
  const Exported tables(made);
  const Table trials = tables.table("trials");
  EXPECT_EQ(trials.columns.back(), "attempts");
  EXPECT_EQ(cell_of(trials, 0, "attempts"), Cell{"1"});
  EXPECT_EQ(cell_of(trials, 1, "attempts"), Cell{"0"});
}

TEST(Export, HasThePlaceOnTheTextureAndTheIntervalBeforeEverySurface) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  MadeUpTrial drawn = some_trial();
  drawn.plan_json = R"({"presentations": [
    {"position": 1, "patch": {"centre_m": [0, 0], "texture_origin_m": [0.25, 0.5]}},
    {"position": 2}]})";
  drawn.surfaces[0].onset_ns = 6'100'000'000;
  drawn.surfaces[0].visits = {{.contact_ns = 6'200'000'000, .offset_ns = 6'300'000'000},
                              {.contact_ns = 7'800'000'000, .offset_ns = 7'900'000'000}};
  drawn.surfaces[1].onset_ns = 7'200'000'000;
  drawn.surfaces[1].visits = {{.contact_ns = 7'300'000'000, .offset_ns = 7'400'000'000}};
  for (PresentationRow& surface : drawn.surfaces) {
    for (VisitRow& visit : surface.visits) visit.contact_s = 0.1;
  }
  made.add_session("anna", made.add_protocol("recognition", "recognition", kExportedProtocol),
                   {drawn});
  const Exported tables(made);
  const Table surfaces = tables.table("presentations");
  EXPECT_EQ(surfaces.columns.back(), "interval_s");
  EXPECT_EQ(cell_of(surfaces, 0, "texture_origin_x_m"), Cell{"0.25"});
  EXPECT_EQ(cell_of(surfaces, 0, "texture_origin_y_m"), Cell{"0.5"});
  EXPECT_EQ(cell_of(surfaces, 1, "texture_origin_x_m"), Cell{});
  EXPECT_EQ(cell_of(surfaces, 0, "interval_s"), Cell{});
  EXPECT_EQ(cell_of(surfaces, 1, "interval_s"), Cell{"0.9"}) << "before the second visit to A";
}

TEST(Export, GivesEachParameterOfAModelAColumn) {
  const Exported& tables = exported_tables();
  const Table surfaces = tables.table("presentations");
  EXPECT_EQ(cell_of(surfaces, 0, "parameter_amplitude_m"), Cell{});
  EXPECT_EQ(cell_of(surfaces, 1, "parameter_amplitude_m"), Cell{"1e-04"});
  EXPECT_EQ(cell_of(surfaces, 0, "parameter_stiffness_N_per_m"), Cell{"500"});
  const Table codebook = tables.codebook();
  const auto row =
      std::find_if(codebook.rows.begin(), codebook.rows.end(), [](const std::vector<Cell>& cells) {
        return cells[1] == Cell{"parameter_stiffness_N_per_m"};
      });
  ASSERT_NE(row, codebook.rows.end());
  EXPECT_EQ((*row)[2],
            Cell{"parameter of the force model as rendered; models: height_map, sinusoid"});
  EXPECT_EQ((*row)[4], Cell{"N/m"});
}

// The made-up session's clock begins at 5 s, its first attempt at 6 s.
TEST(Export, CountsTimeFromTheBeginningOfTheSession) {
  const Exported& tables = exported_tables();
  EXPECT_EQ(cell_of(tables.table("attempts"), 0, "onset_s"), Cell{"1"});
  EXPECT_EQ(cell_of(tables.table("responses"), 0, "time_s"), Cell{"0.5"});
}

TEST(Export, PutsAnswersToTheSessionsQuestionsAmongTheResponses) {
  const Exported& tables = exported_tables();
  const Table responses = tables.table("responses");
  EXPECT_EQ(cell_of(responses, 0, "question"), Cell{"comment"});
  EXPECT_EQ(cell_of(responses, 0, "trial"), Cell{});
  EXPECT_EQ(cell_of(responses, 0, "attempt"), Cell{});
  // One apostrophe more than was typed keeps a spreadsheet from taking it for a formula.
  EXPECT_EQ(cell_of(responses, 0, "answer"), Cell{"'=SUM(A1)"});
  EXPECT_EQ(cell_of(responses, 2, "trial"), Cell{"1"});
}

TEST(Export, IsOrderedByNaturalKeysWhateverTheOrderOfWriting) {
  MadeUpStudy first;
  MadeUpStudy second;
  for (MadeUpStudy* made : {&first, &second}) {
    const bool forwards = made == &first;
    const std::vector<std::string> labels =
        forwards ? std::vector<std::string>{"a", "b"} : std::vector<std::string>{"b", "a"};
    for (const std::string& label : labels) made->add_person(label, "F");
    const std::int64_t protocol =
        made->add_protocol("recognition", "recognition", kExportedProtocol);
    for (const std::string& label : labels) made->add_session(label, protocol, {some_trial()});
    export_to(*made, made->beside("out"));
  }
  for (const std::string& name : files_in(first.beside("out"))) {
    EXPECT_EQ(read_file(first.beside("out") / name), read_file(second.beside("out") / name))
        << name;
  }
}

TEST(Export, TellsThePublicNeitherDatesNorFreeTextInAnyFile) {
  MadeUpStudy made;
  fill(made);
  const std::vector<std::string> private_words{"2001-02-03", "my name is", "SUM(A1)",
                                               "made up to be flagged"};
  std::map<std::string, int> told{};
  for (const ExportAudience audience : {ExportAudience::own, ExportAudience::published}) {
    ExportOptions options = options_of(audience);
    options.formats.insert(ExportFormat::physio);
    const std::filesystem::path out = made.beside(audience == ExportAudience::own ? "own" : "out");
    export_to(made, out, options);
    for (const std::string& name : files_in(out)) {
      const std::string text = read_file(out / name);
      for (const std::string& word : private_words) {
        if (text.find(word) == std::string::npos) continue;
        ++told[word];
        EXPECT_EQ(audience, ExportAudience::own) << name << " tells " << word;
      }
    }
  }
  EXPECT_EQ(told.size(), private_words.size()) << "each of them is somewhere to be found";
  const std::filesystem::path out = made.beside("out");
  const Table responses = read_tsv(read_file(out / "responses.tsv"), "responses.tsv");
  EXPECT_EQ(cell_of(responses, 0, "answer"), Cell{});
  EXPECT_EQ(cell_of(responses, 2, "answer"), Cell{"stone"});
}

// A number that was asked for once more is the answer; the first one stands beside it, in every table
// of answers, and is counted per person.
TEST(Export, TellsTheNumberThatAnEstimateTookThePlaceOf) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  const std::int64_t protocol = made.add_protocol("rough", "magnitude", R"({
      "estimation": {"spacing": "spacing"}, "factors": {"spacing": {"levels": [0.001]}}})");
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("s", "sinusoid", "s")};
  trial.factors_json = R"({"spacing": 0.001})";
  trial.answers = {"7"};
  trial.number = 7.0;
  MadeUpTrial doubted = trial;
  doubted.events = {{.kind = "estimate_doubted",
                     .text = "70",
                     .data_json = R"({"estimate": 70, "earlier_estimate": 7})"}};
  made.add_session("anna", protocol, {trial, doubted});
  ExportOptions options{};
  options.formats = {ExportFormat::wide};
  const std::filesystem::path out = made.beside("out");
  export_to(made, out, options);
  const Table responses = table_in(out, "responses.tsv");
  EXPECT_EQ(cell_of(responses, 0, "doubted_estimate"), Cell{});
  EXPECT_EQ(cell_of(responses, 1, "doubted_estimate"), Cell{"70"});
  EXPECT_EQ(cell_of(responses, 1, "answer"), Cell{"7"});
  EXPECT_THAT(read_file(out / "wide.csv"),
              HasSubstr("answers,answers_flagged,answers_left_out,answers_doubted,"));
  EXPECT_THAT(read_file(out / "wide.csv"), HasSubstr(",2,0,0,1,0,7,2"));
  EXPECT_THAT(read_file(out / "codebook.tsv"), HasSubstr("\tdoubted_estimate\t"));
}

// Ben's numbers are ten times Anna's: on one scale, √10 times hers and his over √10. Carl has no numbers for two of
// the waves.
TEST(Export, TakesTheOwnScaleOfAPersonOutOfTheirEstimates) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("rough", "magnitude", R"({
      "estimation": {"spacing": "spacing"}, "factors": {"spacing": {"levels": [0.001, 0.002, 0.004]}}})");
  const auto trial_of = [](double spacing_m, double number) {
    MadeUpTrial trial{};
    trial.surfaces = {surface_of("s", "sinusoid", "s")};
    trial.factors_json = R"({"spacing": )" + number_text(spacing_m) + "}";
    trial.answers = {number_text(number)};
    trial.number = number;
    return trial;
  };
  MadeUpTrial anchor = trial_of(0.001, 100.0);
  anchor.repetition = 0;
  for (const auto& [label, unit] : {std::pair("anna", 1.0), std::pair("ben", 10.0)}) {
    made.add_person(label, "F");
    made.add_session(label, protocol,
                     {anchor, trial_of(0.001, 0.5 * unit), trial_of(0.001, 2.0 * unit),
                      trial_of(0.002, 10.0 * unit), trial_of(0.004, 7.0 * unit)});
  }
  made.add_person("carl", "M");
  made.add_session("carl", protocol, {trial_of(0.001, 3.0)});
  const std::filesystem::path out = made.beside("out");
  export_to(made, out, tables_only());
  const Table responses = table_in(out, "responses.tsv");
  ASSERT_EQ(responses.rows.size(), 11U);
  const auto normalised = [&responses](std::size_t row) {
    return number_in(std::get<std::string>(cell_of(responses, row, "normalised_estimate"))).value();
  };
  const double root = std::sqrt(10.0);
  const std::vector<double> of_both{0.5 * root, 2.0 * root, 10.0 * root, 7.0 * root};
  for (std::size_t i = 0; i < of_both.size(); ++i) {
    EXPECT_NEAR(normalised(1 + i), of_both[i], 1e-9) << i;
    EXPECT_NEAR(normalised(6 + i), of_both[i], 1e-9) << i;
  }
  EXPECT_NEAR(normalised(0), 100.0 * root, 1e-9) << "an anchor makes no scale, and has one";
  EXPECT_NEAR(normalised(5), 100.0 / root, 1e-9);
  EXPECT_EQ(cell_of(responses, 10, "normalised_estimate"), Cell{});
  EXPECT_EQ(cell_of(responses, 10, "answer_number"), Cell{"3"});
}

// An anchor keeps the scale in mind and is no result, whichever file is read.
TEST(Export, MarksTheAttemptsThatAnalysesCount) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  MadeUpTrial counted{};
  counted.surfaces = {surface_of("s", "sinusoid", "s")};
  counted.answers = {"7"};
  counted.number = 7.0;
  MadeUpTrial anchor = counted;
  anchor.repetition = 0;
  MadeUpTrial practice = counted;
  practice.phase = "practice";
  MadeUpTrial invalid = counted;
  invalid.valid = false;
  MadeUpTrial unanswered = counted;
  unanswered.answers = {};
  unanswered.outcome = AttemptOutcome::timed_out;
  MadeUpTrial flagged = counted;
  flagged.flagged = true;
  const std::int64_t session =
      made.add_session("anna", made.add_protocol("rough", "magnitude"),
                       {anchor, counted, practice, invalid, unanswered, flagged, counted});
  made.study().add_decision(
      session, {.trial = 7, .attempt = 1, .verdict = Verdict::exclude, .reason = "the alarm rang"});
  ExportOptions options{};
  options.formats = {ExportFormat::bids};
  const std::filesystem::path out = made.beside("out");
  export_to(made, out, options);
  const std::vector<Cell> expected{"0", "1", "0", "0", "0", "1", "0"};
  for (const std::string name :
       {"attempts.tsv", "bids/sub-anna/ses-01/beh/sub-anna_ses-01_task-rough_beh.tsv"}) {
    const Table table = table_in(out, name);
    std::vector<Cell> counts{};
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      counts.push_back(cell_of(table, row, "counts_in_analyses"));
    }
    EXPECT_EQ(counts, expected) << name;
  }
  EXPECT_EQ(analyze_study(made.study()).at(0).answers, 2U);
  // Both scripts read that column; neither repeats the rule.
  for (const char* const script : {"import.py", "import.R"}) {
    const std::string text = read_file(out / script);
    EXPECT_THAT(text, HasSubstr("counts_in_analyses")) << script;
    EXPECT_THAT(text, Not(HasSubstr("excluded"))) << script;
    EXPECT_THAT(text, Not(HasSubstr("repetition"))) << script;
  }
}

// Sentences are reworded; whoever filters needs what stays.
TEST(Export, StatesReasonsByTheirCodesNextToTheirWords) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("s", "sinusoid", "s")};
  trial.answers = {"7"};
  const std::int64_t session =
      made.add_session("anna", made.add_protocol("rough", "magnitude"), {trial, trial, trial});
  const auto decide = [&](int number, Verdict verdict, const StoredWords& reason) {
    made.study().add_decision(
        session, {.trial = number, .attempt = 1, .verdict = verdict, .reason = reason});
  };
  decide(1, Verdict::exclude, stored(offered_reasons(ReasonFor::excluding_attempt).front()));
  decide(2, Verdict::exclude, "the alarm rang");
  decide(3, Verdict::flag, stored(phrase_of(Reason::force_limited).with("7")));
  decide(3, Verdict::flag, stored(phrase_of(Reason::not_touched).with("1")));
  made.study().add_event(session, event_row(5, "session_stopped", phrase_of(Reason::as_asked)));
  made.study().add_event(session, event_row(6, "phase", "iti"));
  made.study().add_event(session, event_row(7, "session_completed", Phrase()));  // without words
  const std::filesystem::path out = made.beside("out");
  export_to(made, out, tables_only());
  const Table attempts = table_in(out, "attempts.tsv");
  EXPECT_EQ(cell_of(attempts, 0, "exclusion_code"), Cell{"instruction_not_followed"});
  EXPECT_EQ(cell_of(attempts, 1, "exclusion_code"), Cell{"typed"});
  EXPECT_EQ(cell_of(attempts, 1, "exclusion_reason"), Cell{"the alarm rang"});
  EXPECT_EQ(cell_of(attempts, 2, "exclusion_code"), Cell{});
  EXPECT_EQ(cell_of(attempts, 2, "flag_code"), Cell{"force_limited; surface_not_touched"});
  EXPECT_EQ(cell_of(attempts, 2, "flag_reason"),
            Cell{"ticks with limited force: 7; surface 1 was not touched"});
  EXPECT_EQ(cell_of(attempts, 2, "invalid_code"), Cell{});
  const Table events = table_in(out, "events.tsv");
  EXPECT_EQ(cell_of(events, 0, "text_code"), Cell{"stop_requested"});
  EXPECT_EQ(cell_of(events, 1, "text_code"), Cell{});
  EXPECT_EQ(cell_of(events, 2, "text_code"), Cell{});

  ExportOptions options = tables_only();
  options.audience = ExportAudience::published;
  const std::filesystem::path published = made.beside("published");
  export_to(made, published, options);
  const Table of_public = table_in(published, "attempts.tsv");
  EXPECT_EQ(cell_of(of_public, 0, "exclusion_code"), Cell{"typed"});
  EXPECT_EQ(cell_of(of_public, 2, "flag_code"), Cell{"force_limited; surface_not_touched"});
}

// Textures have names; what roughness is drawn over is how far apart their elements are.
TEST(Export, SaysTheSpacingOfTheTextureOfATrialInMetres) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  const std::int64_t protocol = made.add_protocol("rough", "magnitude", R"({
      "estimation": {"spacing": "texture"},
      "factors": {"texture": {"levels": ["fine", "plain"]}},
      "textures": {"fine": {"spacing_m": 0.0012}}})");
  MadeUpTrial fine{};
  fine.surfaces = {surface_of("s", "sinusoid", "s")};
  fine.factors_json = R"({"texture": "fine"})";
  MadeUpTrial plain = fine;
  plain.factors_json = R"({"texture": "plain"})";
  made.add_session("anna", protocol, {fine, plain});
  const std::filesystem::path out = made.beside("out");
  export_to(made, out, tables_only());
  const Table trials = table_in(out, "trials.tsv");
  EXPECT_EQ(cell_of(trials, 0, "texture_spacing_m"), Cell{"0.0012"});
  EXPECT_EQ(cell_of(trials, 1, "texture_spacing_m"), Cell{});
  EXPECT_THAT(read_file(out / "codebook.tsv"), HasSubstr("\ttexture_spacing_m\t"));

  MadeUpStudy other;
  fill(other);
  export_to(other, other.beside("out"), tables_only());
  EXPECT_THAT(read_file(other.beside("out") / "trials.tsv"), Not(HasSubstr("texture_spacing_m")))
      << "no protocol asks for magnitudes";
}

/// `fill`, with questions of the library's kind: about somebody's health, as a choice and a number.
void fill_with_health(MadeUpStudy& made) {
  fill(made);
  ParticipantRow person{};
  person.label = "carl";
  person.answers_json = R"({"pain": "it hurts a lot", "scars": 777})";
  made.study().add_participant(person);
  const std::int64_t protocol = made.add_protocol("health", "recognition", R"({"questions": {
      "pain": {"prompt": "Any pain?", "form": "choice", "options": ["no", "it hurts a lot"]},
      "scars": {"prompt": "How many scars?", "form": "number", "minimum": 0}}})");
  const std::int64_t session = made.add_session("carl", protocol, {some_trial()});
  ResponseRow number = session_answer("scars", "777");
  number.answer_number = 777;
  made.study().add_session_answer(session, number);
  made.study().add_session_answer(session, session_answer("pain", "it hurts a lot"));
}

int cells_of_text(const std::string& word, std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == ','; }, '\t');
  const std::string cell = '\t' + word + '\t';
  int cells = 0;
  for (std::size_t at = text.find(cell); at != std::string::npos; at = text.find(cell, at + 1)) {
    ++cells;
  }
  return cells;
}

/// Numbers of which a label is the word count too.
int cells_of_sav(const std::string& word, const Sav& file) {
  int cells = 0;
  for (const auto& row : file.rows) {
    for (const auto& [name, text] : row) {
      const auto variable = std::find_if(file.variables.begin(), file.variables.end(),
                                         [&](const auto& one) { return one.name == name; });
      const auto labels = file.value_labels.find(variable->labels);
      const auto number = number_in(text);
      if (labels != file.value_labels.end() && number && labels->second.contains(*number)) {
        cells += labels->second.at(*number) == word ? 1 : 0;
      } else {
        cells += text == word ? 1 : 0;
      }
    }
  }
  return cells;
}

/// Names in an object are no answers: levels of a column stand there.
int values_of_json(const std::string& word, const nlohmann::json& json) {
  if (json.is_string()) return json.get<std::string>() == word ? 1 : 0;
  if (!json.is_structured()) return json.dump() == word ? 1 : 0;
  int values = 0;
  for (const nlohmann::json& each : json) values += values_of_json(word, each);
  return values;
}

/// How many cells of all tables of an export, and values of what describes them, are exactly this.
int cells_that_are(const std::string& word, const std::filesystem::path& out) {
  int cells = 0;
  for (const std::string& name : files_in(out)) {
    if (name == "codebook.tsv") continue;  // says what could be answered
    const std::filesystem::path file = out / name;
    if (name.ends_with(".tsv") || name.ends_with(".csv")) {
      cells += cells_of_text(word, read_file(file));
    } else if (name.ends_with(".sav")) {
      cells += cells_of_sav(word, sav(file));
    } else if (name.ends_with(".json")) {
      cells += values_of_json(word, nlohmann::json::parse(read_file(file)));
    }
  }
  return cells;
}

TEST(Export, TellsThePublicNoAnswerToAQuestionnaireThatIsNotNamed) {
  MadeUpStudy made;
  fill_with_health(made);
  ExportOptions options{};
  export_to(made, made.beside("own"), options);
  EXPECT_EQ(cells_that_are("it hurts a lot", made.beside("own")), 9);
  EXPECT_EQ(cells_that_are("777", made.beside("own")), 8);  // as text and as number in responses
  options.audience = ExportAudience::published;
  export_to(made, made.beside("out"), options);
  EXPECT_EQ(cells_that_are("it hurts a lot", made.beside("out")), 0);
  EXPECT_EQ(cells_that_are("777", made.beside("out")), 0);
  EXPECT_THAT(read_file(made.beside("out") / "codebook.tsv"), Not(HasSubstr("answer_pain")));
  const std::map<std::string, std::string> named{{"participants.tsv", "answer_pain"},
                                                 {"responses.tsv", "answer(pain)"},
                                                 {"wide.csv", "session_pain"}};
  std::size_t told = 0;
  for (const std::vector<Cell>& row : table_in(made.beside("out"), "MANIFEST.tsv").rows) {
    const auto found = named.find(std::get<std::string>(row[0]));
    if (found == named.end()) continue;
    ++told;
    EXPECT_THAT(std::get<std::string>(row[3]), HasSubstr(found->second));
  }
  EXPECT_EQ(told, named.size());

  options.questions_for_public = {"pain", "hand"};
  export_to(made, made.beside("named"), options);
  EXPECT_EQ(cells_that_are("it hurts a lot", made.beside("named")), 9);
  EXPECT_EQ(cells_that_are("777", made.beside("named")), 0);
  EXPECT_THAT(read_file(made.beside("named") / "README.txt"),
              HasSubstr("answers to questionnaires, except for hand, pain. "));
}

// What becomes of a column stands with the column alone: README.txt and --help are made of it.
TEST(Export, StatesInItsReadmeWhatThePublicGetsOfAParticipantAndWhatNot) {
  MadeUpStudy made;
  fill(made);
  export_to(made, made.beside("own"));
  EXPECT_THAT(read_file(made.beside("own") / "README.txt"), Not(HasSubstr("Kept of each")));
  ExportOptions options = options_of(ExportAudience::published);
  options.questions_for_public = {"hand"};
  export_to(made, made.beside("out"), options);
  std::string readme = read_file(made.beside("out") / "README.txt");
  std::replace(readme.begin(), readme.end(), '\n', ' ');
  EXPECT_THAT(readme, HasSubstr("Kept for each participant: participant, virtual, mode, age_years, "
                                "sex, handedness, withdrawn, answer_hand (participants.tsv)."));
  EXPECT_THAT(table_in(made.beside("out"), "participants.tsv").columns,
              ElementsAre("participant", "virtual", "mode", "age_years", "sex", "handedness",
                          "withdrawn", "answer_hand"));
  EXPECT_THAT(readme, HasSubstr("Left out: created_utc, answer_comment, answer_years "
                                "(participants.tsv), os, consent_utc, started_utc, ended_utc "
                                "(sessions.tsv), invalid_reason, exclusion_reason, flag_reason "
                                "(attempts.tsv)."));
  EXPECT_THAT(readme,
              HasSubstr("n/a for answers to questionnaires, unless named by "
                        "--with-questions, and for free text: item, answer, answer_number, time_s, "
                        "from_cue_s, source (responses.tsv)."));
  EXPECT_THAT(
      readme,
      HasSubstr("Left out with --relabel: protocol_sha256, seed, generator, counterbalance_row, "
                "program_version, program_commit, program_build, program_sha256, "
                "instruction_set, stimulus_files_json, consent_version (sessions.tsv), "
                "masking_noise_measured_dBA, recording_path, recording_sha256 (attempts.tsv), seed "
                "(presentations.tsv)."));
  EXPECT_THAT(publication_text_of_any_study(), HasSubstr("age_years, sex, handedness"));
  EXPECT_THAT(publication_text_of_any_study(),
              HasSubstr("Left out unless named by --with-questions: answer_NAME"));
}

// The README states what an export contains: the text depends on the options.
TEST(Export, StatesInItsReadmeWhatCanStillIdentifyAParticipant) {
  MadeUpStudy made;
  fill(made);
  const auto readme_with = [&made](const ExportOptions& options) {
    const std::filesystem::path out = made.beside("out");
    export_to(made, out, options);
    std::string readme = read_file(out / "README.txt");
    std::filesystem::remove_all(out);
    std::replace(readme.begin(), readme.end(), '\n', ' ');
    readme.erase(std::unique(readme.begin(), readme.end(),
                             [](char a, char b) { return a == ' ' && b == ' '; }),
                 readme.end());
    return readme;
  };
  EXPECT_THAT(readme_with({}), Not(HasSubstr("can still identify")));
  ExportOptions options = options_of(ExportAudience::published);
  const std::string usual = readme_with(options);
  EXPECT_THAT(usual, HasSubstr("- Recordings, which contain the movement of the hand in every "
                               "tick, are left out"));
  EXPECT_THAT(usual, HasSubstr("- The exact age is often unique together with sex, handedness"));
  EXPECT_THAT(usual, HasSubstr("- The label identifies a participant to every reader of the list"));
  EXPECT_THAT(usual, HasSubstr("- Names of files and programs are kept: stimuli, height fields"));
  for (const std::string sentence : {"The exact age", "The label", "Names of files"}) {
    EXPECT_THAT(publication_text_of_any_study(), HasSubstr(sentence));
  }
  options.formats.insert(ExportFormat::physio);
  options.has_age_bands = true;
  options.audience = ExportAudience::relabelled;
  options.random_bits = random_bits_of_this_machine();
  const std::string guarded = readme_with(options);
  EXPECT_THAT(guarded, HasSubstr("- Recordings contain the movement of the hand in every tick."));
  EXPECT_THAT(guarded, HasSubstr("- A band of ages contains at least five participants, but"));
  EXPECT_THAT(guarded, HasSubstr("- Labels were drawn at random for this export, and the rows are "
                                 "in their order."));
  EXPECT_THAT(guarded, Not(HasSubstr("The label identifies")));
}

// In one protocol a trial asks how rough something was, in another the questionnaire does.
TEST(Export, TellsThePublicOfAQuestionnairesQuestionThatATrialOfAnotherProtocolAsksAsWell) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  made.add_protocol(
      "first", "recognition",
      R"({"blocks": {"b": {"question": {"name": "rough", "prompt": "How rough?"}}}})");
  const std::int64_t second = made.add_protocol("second", "recognition", R"({"questions": {
      "rough": {"prompt": "Rough hands?", "form": "choice", "options": ["no", "cracked"]}}})");
  const std::int64_t session = made.add_session("anna", second, {some_trial()});
  made.study().add_session_answer(session, session_answer("rough", "cracked"));
  ExportOptions options = options_of(ExportAudience::published);
  export_to(made, made.beside("out"), options);
  EXPECT_EQ(cells_that_are("cracked", made.beside("out")), 0);
  EXPECT_THAT(read_file(made.beside("out") / "MANIFEST.tsv"), HasSubstr("answer(rough)"));
  options.questions_for_public = {"rough"};
  export_to(made, made.beside("named"), options);
  EXPECT_GT(cells_that_are("cracked", made.beside("named")), 0);
}

// Whether the second question was asked is the answer to the first one.
TEST(Export, PublishesAConditionalQuestionWithTheOneOfItsConditionOnly) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  const std::int64_t protocol = made.add_protocol("feeling", "recognition", R"({"questions": {
      "pain": {"prompt": "Pain?", "form": "choice", "options": ["no", "yes"]},
      "where": {"prompt": "Where?", "form": "choice", "options": ["hand", "arm"],
                "if": {"question": "pain", "is": "yes"}}}})");
  const std::int64_t session = made.add_session("anna", protocol, {some_trial()});
  made.study().add_session_answer(session, session_answer("pain", "yes"));
  made.study().add_session_answer(session, session_answer("where", "arm"));
  ExportOptions options = options_of(ExportAudience::published);
  options.questions_for_public = {"where"};
  EXPECT_THAT(
      refusal_of<std::invalid_argument>([&] { export_to(made, made.beside("out"), options); }),
      HasSubstr("cannot be published without those to \"pain\""));
  options.questions_for_public = {"pain", "where"};
  export_to(made, made.beside("both"), options);
  EXPECT_GT(cells_that_are("arm", made.beside("both")), 0);
}

TEST(Export, RefusesToTellThePublicWhatIsTypedFreelyOrNotAsked) {
  MadeUpStudy made;
  fill_with_health(made);
  const auto refused = [&made](const std::string& question, const std::string& because) {
    ExportOptions options = options_of(ExportAudience::published);
    options.questions_for_public = {question};
    EXPECT_EQ(
        refusal_of<std::invalid_argument>([&] { export_to(made, made.beside("out"), options); }),
        "answers to \"" + question + "\" cannot be published: " + because +
            "; choose from those that can be published: hand, pain, scars");
  };
  refused("comment", "they are free text");
  refused("pian", "no questionnaire of the study contains this question");
  refused("which", "no questionnaire of the study contains this question");
  EXPECT_FALSE(std::filesystem::exists(made.beside("out")));
}

TEST(Export, SaysInTheManifestWhatIsThereAndWhatThePublicDoesNotGet) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  export_to(made, out, options_of(ExportAudience::published));
  const Table manifest = read_tsv(read_file(out / "MANIFEST.tsv"), "MANIFEST.tsv");
  EXPECT_EQ(manifest.rows.size() + 1, files_in(out).size());
  for (const std::vector<Cell>& row : manifest.rows) {
    const std::string& name = std::get<std::string>(row[0]);
    EXPECT_EQ(row[2], Cell{sha256_of(read_file(out / name))}) << name;
    if (name == "participants.tsv") {
      EXPECT_EQ(row[3], Cell{"created_utc answer_comment answer_hand answer_years"});
    }
  }
}

TEST(Export, NeverThrowsAwayAFileThatNoExportWrote) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  std::filesystem::create_directory(out);
  write_file(out / "thesis.txt", "years of work", Overwrite::refuse);
  EXPECT_THAT(refusal_of<ResultsError>(
                  [&] { export_to(made, out, options_of(ExportAudience::own, Overwrite::allow)); }),
              HasSubstr("thesis.txt"));
  EXPECT_THAT(names_in(out), ElementsAre("thesis.txt"));
  EXPECT_THAT(names_in(made.beside("")), ElementsAre("out", "study"));
}

TEST(Export, ReplacesAnEarlierExportOnlyWhenToldTo) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  export_to(made, out);
  EXPECT_THROW(export_to(made, out), ResultsError);
  export_to(made, out, options_of(ExportAudience::published, Overwrite::allow));
  EXPECT_THAT(read_file(out / "sessions.tsv"), Not(HasSubstr("started_utc")));
  export_to(made, out, options_of(ExportAudience::own, Overwrite::allow));
  write_file(out / "virtual" / "notes.txt", "years of work", Overwrite::refuse);
  EXPECT_THROW(export_to(made, out, options_of(ExportAudience::own, Overwrite::allow)),
               ResultsError);
  EXPECT_EQ(read_file(out / "virtual" / "notes.txt"), "years of work");
}

TEST(Export, RemovesWhatAKilledOneLeft) {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ExportFolder killed(folder / "out", Overwrite::refuse);
    killed.write("a.tsv", "a");
    ::kill(::getpid(), SIGKILL);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  ExportFolder(folder / "out", Overwrite::refuse).take_place();
  std::vector<std::string> names{};
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename().string());
  }
  EXPECT_EQ(names, std::vector<std::string>{"out"});
}

TEST(Export, NeverThrowsAwayWhatSomebodyWroteIntoAnExportedFile) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path out = made.beside("out");
  export_to(made, out);
  write_file(out / "virtual" / "wide.csv", "with notes of mine", Overwrite::allow);
  const ExportOptions again = options_of(ExportAudience::own, Overwrite::allow);
  EXPECT_THAT(refusal_of<ResultsError>([&] { export_to(made, out, again); }),
              HasSubstr("\"virtual/wide.csv\", which was changed"));
  EXPECT_EQ(read_file(out / "virtual" / "wide.csv"), "with notes of mine");
  std::filesystem::remove(out / "virtual" / "wide.csv");
  export_to(made, out, again);
  EXPECT_THAT(names_in(out / "virtual"), Contains("wide.csv"));
}

TEST(Export, TakesAnEmptyFolderAndOneWithASlashAtItsEnd) {
  MadeUpStudy made;
  fill(made);
  std::filesystem::create_directory(made.beside("empty"));
  export_to(made, made.beside("empty"));
  export_to(made, made.beside("deep") / "er" / "");
  EXPECT_THAT(names_in(made.beside("empty")), Contains("trials.tsv"));
  EXPECT_THAT(names_in(made.beside("deep") / "er"), Contains("trials.tsv"));
}

// The deletion does not wait for a reader that holds no lock, and changes the file under it.
TEST(Export, BeginsAgainWithoutAParticipantWhoseDataAreDeletedMeanwhile) {
  MadeUpStudy made;
  fill(made);
  const std::filesystem::path closed = made.beside("closed");
  made.study().copy_to(closed);
  const Study reader = Study::open(closed, Access::read_only);
  bool is_deleted = false;
  const auto delete_anna = [&](double) {
    if (std::exchange(is_deleted, true)) return;
    Study::open(closed, Access::read_write)
        .withdraw("anna", {.data = WithdrawnData::deleted, .decided_by = "R. Keeper"});
  };
  export_study(reader, built_in_models(), made.beside("out"), {}, {}, delete_anna);
  ASSERT_TRUE(is_deleted);
  for (const char* const name : {"participants", "sessions", "attempts", "responses", "events"}) {
    const Table table = table_in(made.beside("out"), std::string(name) + ".tsv");
    for (const std::vector<Cell>& row : table.rows) EXPECT_EQ(row[0], Cell{"virtual0001"}) << name;
  }
  EXPECT_EQ(table_in(made.beside("out"), "participants.tsv").rows.size(), 1U);
  EXPECT_THAT(names_in(made.beside("out")), Not(Contains("wide.csv"))) << "there is nobody else";
}

}  // namespace
}  // namespace asperity
