// How often analyses, reports and exports read the rows of a session.

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <sqlite3.h>

#include "app/findings/study/analyze_study.h"
#include "app/report/text/study_report.h"
#include "tests/app/exported_study.h"

namespace asperity {
namespace {

/// The statements that this process runs on studies which are opened while it lives.
class RunStatements final {
 public:
  RunStatements() {
    statements().clear();
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(&watch));
  }
  ~RunStatements() { sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(&watch)); }
  RunStatements(const RunStatements&) = delete;
  RunStatements& operator=(const RunStatements&) = delete;

  std::size_t reading(std::string_view table) const {
    const std::string from = "FROM " + std::string(table) + " ";
    const std::lock_guard lock(mutex());
    std::size_t count = 0;
    for (const std::string& sql : statements())
      count += sql.find(from) != std::string::npos ? 1U : 0U;
    return count;
  }

 private:
  static std::vector<std::string>& statements() {
    static std::vector<std::string> all{};
    return all;
  }
  static std::mutex& mutex() {
    static std::mutex one{};
    return one;
  }
  static int note(unsigned, void*, void*, void* sql) {
    const std::lock_guard lock(mutex());
    statements().emplace_back(static_cast<const char*>(sql));
    return 0;
  }
  static int watch(sqlite3* database, char**, const void*) {
    return sqlite3_trace_v2(database, SQLITE_TRACE_STMT, &note, nullptr);
  }
};

constexpr std::size_t kSessions = 3;

/// Magnitudes, with a rule for errors in catch trials: rows of an export state results of both.
void fill_with_results(MadeUpStudy& made) {
  const std::int64_t protocol = made.add_protocol("rough", "magnitude", R"({
      "estimation": {"spacing": "spacing"}, "factors": {"spacing": {"levels": [0.001]}},
      "analysis": {"exclude": {"more_catch_errors_than": 1}}})");
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("s", "sinusoid", "s")};
  trial.factors_json = R"({"spacing": 0.001})";
  trial.answers = {"7"};
  trial.number = 7.0;
  MadeUpTrial caught = trial;
  caught.repetition = 0;
  caught.is_catch = true;
  for (std::size_t i = 0; i < kSessions; ++i) {
    const std::string label = "p" + std::to_string(i + 1);
    made.add_person(label, "F");
    made.add_session(label, protocol, {trial, caught});
  }
}

/// The statements of `use` that read a table of which each session has rows, by session.
template <class Use>
double reads_by_session(MadeUpStudy& made, const Use& use) {
  const RunStatements run{};
  use(Study::open(made.folder(), Access::read_only));
  return static_cast<double>(run.reading("compliance")) / static_cast<double>(kSessions);
}

TEST(ReadingPasses, AreOneOfAnAnalysis) {
  MadeUpStudy made;
  fill_with_results(made);
  EXPECT_EQ(reads_by_session(made, [](const Study& study) { analyze_study(study); }), 1.0);
}

TEST(ReadingPasses, AreTwoOfAReport) {
  MadeUpStudy made;
  fill_with_results(made);
  EXPECT_EQ(reads_by_session(made, [](const Study& study) { study_report(study); }), 2.0)
      << "of the facts and of the responses";
}

TEST(ReadingPasses, AreTwoOfAnExportWhoseRowsStateResults) {
  MadeUpStudy made;
  fill_with_results(made);
  const std::filesystem::path out = made.beside("out");
  EXPECT_EQ(
      reads_by_session(
          made, [&out](const Study& study) { export_study(study, built_in_models(), out, {}); }),
      2.0)
      << "the own scales and the exclusions are of one pass";
  EXPECT_EQ(cell_of(table_in(out, "responses.tsv"), 0, "normalised_estimate"), Cell{"7"});
}

TEST(ReadingPasses, AreOneOfAnExportWithoutSuchRows) {
  MadeUpStudy made;
  const std::int64_t protocol = made.add_protocol("recognition", "recognition", kExportedProtocol);
  for (std::size_t i = 0; i < kSessions; ++i) {
    made.add_person("p" + std::to_string(i + 1), "F");
    made.add_session("p" + std::to_string(i + 1), protocol, {some_trial()});
  }
  const std::filesystem::path out = made.beside("out");
  EXPECT_EQ(
      reads_by_session(
          made, [&out](const Study& study) { export_study(study, built_in_models(), out, {}); }),
      1.0);
}

TEST(ReadingPasses, AreNoneOfTheRefusalOfAnExport) {
  MadeUpStudy made;
  fill(made);
  ExportOptions options = options_of(ExportAudience::published);
  options.questions_for_public = {"hand"};
  const std::filesystem::path out = made.beside("out");
  const RunStatements run{};
  refuse_export(Study::open(made.folder(), Access::read_only), out, options);
  EXPECT_GT(run.reading("protocol"), 0U);
  EXPECT_EQ(run.reading("trial"), 0U);
  EXPECT_EQ(run.reading("presentation"), 0U);
}

}  // namespace
}  // namespace asperity
