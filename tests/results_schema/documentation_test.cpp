// What docs/formats states about studies and recordings.

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "results_schema/files/atomic_file.h"
#include "results_schema/migrations.h"
#include "results_schema/recording.h"
#include "results_schema/tables/table.h"
#include "tests/results_schema/rows_for_tests.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

std::string page(const std::string& name) {
  return read_file(std::filesystem::path(ASPERITY_SOURCE_DIR) / "docs/formats" / name);
}

/// The program between ```python and ``` in a page.
std::string python_of(const std::string& name) {
  const std::string text = page(name);
  const std::string opening = "```python\n";
  const std::size_t start = text.find(opening) + opening.size();
  return text.substr(start, text.find("```", start) - start);
}

std::string output_of(const std::string& command) {
  FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return "";
  std::string output;
  for (int character = std::fgetc(pipe); character != EOF; character = std::fgetc(pipe)) {
    output += static_cast<char>(character);
  }
  EXPECT_EQ(::pclose(pipe), 0) << command;
  return output;
}

/// What the documented reader prints about a file or folder.
std::string read_by_documentation(const std::string& name, const std::filesystem::path& what) {
  const TemporaryFolder folder;
  write_file(folder / "reader.py", python_of(name), Overwrite::refuse);
  return output_of("python3 '" + (folder / "reader.py").string() + "' '" + what.string() + "'");
}

TEST(RecordingDocumentation, HasAReaderThatReadsWhatWeRead) {
  const TemporaryFolder study;
  RecordingWriter writer(
      study.path(), "recordings/a.rec",
      {.rate_Hz = 10.0,
       .columns = {{.name = "x_m", .unit = "m", .meaning = "position"},
                   {.name = "force_N", .unit = "N", .meaning = "force on the hand"}}});
  for (int i = 0; i < 25; ++i) {
    const float values[] = {0.01F * static_cast<float>(i), 2.0F};
    writer.append(std::int64_t{100'000'000} * i, values);
  }
  const std::filesystem::path file = study / writer.finish().path;
  const Table table = read_tsv(read_by_documentation("recording.md", file), "python's output");
  const Recording recording = read_recording(file);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"time_ns", "x_m", "force_N"}));
  ASSERT_EQ(table.rows.size(), 25U);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto number = [&table, i](std::size_t column) {
      return number_in(std::get<std::string>(table.rows[i][column]));
    };
    EXPECT_EQ(number(0), static_cast<double>(recording.time_ns[i]));
    EXPECT_EQ(number(1), static_cast<double>(recording.columns[0][i]));
    EXPECT_EQ(number(2), static_cast<double>(recording.columns[1][i]));
  }
}

TEST(StudyDocumentation, HasAReaderThatReadsWhatAnalysesInclude) {
  const TemporaryFolder folder;
  {
    auto [study, session_id] = study_with_session(folder / "s", 2);
    AttemptRow aborted = some_attempt(1);
    aborted.outcome = AttemptOutcome::aborted;
    aborted.valid = false;
    aborted.invalid_reason = "aborted";
    study.add_attempt(session_id, aborted);
    study.add_attempt(session_id, some_attempt(1, 2));
    study.add_attempt(session_id, some_attempt(2));
    study.add_decision(
        session_id, {.trial = 2, .attempt = 1, .verdict = Verdict::exclude, .reason = "sneezed"});
  }
  EXPECT_EQ(read_by_documentation("study.md", folder / "s"),
            "P01 1 1 2 confidence sure None\nP01 1 1 2 which B 1\n");
}

TEST(StudyDocumentation, NamesTheSchemaVersion) {
  EXPECT_TRUE(page("study.md")
                  .starts_with("# Studies: schema version " +
                               std::to_string(migrations().back().version) + "\n"));
}

TEST(StudyDocumentation, NamesEveryTableAndColumn) {
  const TemporaryFolder folder;
  Study::create(folder / "s", "x");
  const std::string text = page("study.md");
  const std::string output = output_of(
      "python3 -c \"import sqlite3, sys\n"
      "c = sqlite3.connect('file:" +
      (folder / "s/study.sqlite").string() +
      "?immutable=1', uri=True)\n"
      "for (t,) in c.execute('SELECT name FROM sqlite_schema WHERE type IN (\\\"table\\\", "
      "\\\"view\\\")').fetchall():\n"
      "  print(t)\n"
      "  if not t.startswith('tidy'):\n"
      "    for r in c.execute('PRAGMA table_info(' + t + ')'): print(r[1])\n\"");
  std::size_t start = 0;
  int names = 0;
  for (std::size_t end = 0; (end = output.find('\n', start)) != std::string::npos;
       start = end + 1, ++names) {
    const std::string name = "`" + output.substr(start, end - start) + "`";
    EXPECT_NE(text.find(name), std::string::npos) << name;
  }
  EXPECT_GT(names, 100);
}

}  // namespace
}  // namespace asperity
