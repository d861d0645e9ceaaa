// What an export with new labels has in common with the study: everything but the labels and the order.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "app/exports/new_labels.h"
#include "app/study_files/study_outputs.h"
#include "results_schema/recording.h"
#include "tests/app/exported_study.h"
#include "tests/app/sav_reading.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

const std::vector<std::string> kLabelsOfStudy{"Quixote1", "Quixote2", "Quixote3", "Quixote9"};

/// Of no other number in the study, and each tells when or in which order a session was run.
const std::vector<std::string> kDatingWords{
    "918273645",   "gen-7.3.1",      "7.3.1-made-up", "c0ffee77", "made-in-may", "deadbeef7731",
    "avx-of-1999", "consent-of-may", "abba7731",      "1928.25",  "5647382910"};

/// Three people and a virtual participant; each has a session with a recording and magnitude estimates, and the events
/// of one that was resumed.
void fill_with_labels(MadeUpStudy& made) {
  const std::int64_t protocol = made.add_protocol("rough", "magnitude", R"({
      "estimation": {"spacing": "spacing"}, "factors": {"spacing": {"levels": [0.001, 0.002]}}})");
  double unit = 1.0;
  for (const std::string& label : kLabelsOfStudy) {
    const bool is_virtual = label == kLabelsOfStudy.back();
    if (is_virtual) {
      made.add_virtual(label, "F");
    } else {
      made.add_person(label, label == "Quixote2" ? "M" : "F");
    }
    std::vector<MadeUpTrial> trials{};
    for (const char* const spacing : {"0.001", "0.002"}) {
      MadeUpTrial& trial = trials.emplace_back();
      trial.surfaces = {surface_of("s", "sinusoid", "s")};
      trial.surfaces.front().seed = "5647382910";
      trial.factors_json = std::string(R"({"spacing": )") + spacing + "}";
      trial.number = unit * (trials.size() == 1 ? 2.0 : 3.0);
      trial.answers = {std::to_string(*trial.number)};
    }
    const std::string path = "recordings/" + label + "/a.rec";
    RecordingWriter writer(
        made.folder(), path,
        {.rate_Hz = 1000.0, .columns = {{.name = "x_m", .unit = "m", .meaning = "position"}}});
    const float value[] = {0.25F};
    writer.append(6'000'000'000, value);
    trials.front().recording = writer.finish();
    const SessionMode mode = is_virtual ? SessionMode::simulate : SessionMode::run;
    const std::int64_t id = made.add_session(label, protocol, trials, mode);
    made.study().add_event(
        id,
        {5'000'000'000, "session_began", "",
         R"({"program_version":"7.3.1-made-up","program_commit":"c0ffee77","program_sha256":"deadbeef7731",)"
         R"("instruction_set":"avx-of-1999","pacing":"stepped","segment":1})"});
    made.study().add_event(id, {5'100'000'000, "resumed_late", "It was late.",
                                R"({"age_hours":1928.25,"maximum_age_hours":24})"});
    made.study().add_event(id, {5'200'000'000, "external_program", "levels",
                                R"({"block_ordinal":1,"program":"levels","sha256":"abba7731"})"});
    SessionRow second = made.study().sessions().back();
    second.id = 0;
    second.participant = label;
    second.session = 0;
    second.mode = mode;
    second.seed = "918273645";
    second.generator = "gen-7.3.1";
    second.counterbalance_row = 3;
    second.program_version = "7.3.1-made-up";
    second.program_commit = "c0ffee77";
    second.program_build = "made-in-may";
    second.program_sha256 = std::string(52, '0') + "deadbeef7731";
    second.instruction_set = "avx-of-1999";
    second.consent_version = "consent-of-may";
    second.consent_utc = "2001-05-03T04:05:06Z";
    second.state = SessionState::stopped;
    made.study().add_session(second, {});
    unit *= 10.0;
  }
}

/// The letters that it chooses count down from the last one: "zzzzz", "xxxxx", "wwwww", …
RandomBits falling_bits() {
  return [drawn = std::make_shared<std::uint64_t>(0)] { return 18 - (*drawn)++ / 5 % 19; };
}

ExportOptions relabelled(RandomBits bits = falling_bits()) {
  ExportOptions options = options_of(ExportAudience::relabelled);
  options.random_bits = std::move(bits);
  options.formats.insert(ExportFormat::physio);
  return options;
}

/// The content of a file, unpacked.
std::string plain_content(const std::filesystem::path& path) {
  if (path.extension() != ".gz") return read_file(path);
  const gzFile file = gzopen(path.c_str(), "rb");
  std::string text(1 << 16, '\0');
  const int bytes = gzread(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  text.resize(static_cast<std::size_t>(std::max(bytes, 0)));
  return text;
}

/// The files below `folder` that have the word in their name or their content.
std::vector<std::string> files_with(const std::string& word, const std::filesystem::path& folder) {
  std::vector<std::string> names{};
  for (const std::string& name : files_in(folder)) {
    const bool is_named = name.find(word) != std::string::npos;
    if (is_named || plain_content(folder / name).find(word) != std::string::npos) {
      names.push_back(name);
    }
  }
  return names;
}

TEST(NewLabels, AreDifferentConsonantsThatNoParticipantOfTheStudyHas) {
  const RandomBits bits = [drawn = std::make_shared<std::uint64_t>(0)] { return (*drawn)++ / 10; };
  const std::vector<std::string> labels = drawn_labels(3, {"BBBBB", "p01"}, bits);
  // Twice five of every letter are drawn: the second five repeat a label, and b is taken.
  EXPECT_THAT(labels, ElementsAre("ccccc", "ddddd", "fffff"));
  const std::vector<std::string> many = drawn_labels(2000, {}, random_bits_of_this_machine());
  EXPECT_EQ(std::set(many.begin(), many.end()).size(), many.size());
  for (const std::string& label : many) {
    EXPECT_THAT(label, SizeIs(5));
    EXPECT_EQ(label.find_first_not_of("bcdfghjkmnpqrstvwxz"), std::string::npos) << label;
  }
}

// 2⁶⁴ is no multiple of 19: without a second draw the first letters would be more probable.
TEST(NewLabels, HaveEveryLetterWithTheSameProbability) {
  const RandomBits bits = [is_first = std::make_shared<bool>(true)]() -> std::uint64_t {
    return std::exchange(*is_first, false) ? std::numeric_limits<std::uint64_t>::max() : 1;
  };
  EXPECT_THAT(drawn_labels(1, {}, bits), ElementsAre("ccccc"));
}

TEST(RelabelledExport, HasNoLabelOfTheStudyInAnyFileOrName) {
  MadeUpStudy made;
  fill_with_labels(made);
  ExportOptions published = options_of(ExportAudience::published);
  published.formats.insert(ExportFormat::physio);
  export_to(made, made.beside("public"), published);
  export_to(made, made.beside("out"), relabelled());
  for (const std::string& label : kLabelsOfStudy) {
    EXPECT_THAT(files_with(label, made.beside("public")), Not(IsEmpty())) << label;
    EXPECT_THAT(files_with(label, made.beside("out")), IsEmpty()) << label;
  }
  EXPECT_EQ(files_in(made.beside("out")).size(), files_in(made.beside("public")).size());
  for (const char* const label : {"zzzzz", "xxxxx", "wwwww", "vvvvv"}) {
    EXPECT_THAT(files_with(label, made.folder()), IsEmpty()) << "the study has no assignment";
  }
}

TEST(RelabelledExport, LeavesOutWhatShowsWhenOrInWhichOrderSessionsWereRun) {
  MadeUpStudy made;
  fill_with_labels(made);
  export_to(made, made.beside("public"), options_of(ExportAudience::published));
  export_to(made, made.beside("out"), relabelled());
  for (const std::string& word : kDatingWords) {
    EXPECT_THAT(files_with(word, made.beside("public")), Not(IsEmpty())) << word;
    std::vector<std::string> with_word = files_with(word, made.beside("out"));
    std::erase(with_word, "README.txt");  // the versions of all sessions together
    EXPECT_THAT(with_word, IsEmpty()) << word;
  }
  EXPECT_THAT(read_file(made.beside("out") / "README.txt"),
              HasSubstr("The sessions were run with Asperity 1, 7.3.1-made-up."));
  EXPECT_THAT(table_in(made.beside("out"), "sessions.tsv").columns,
              Not(Contains("counterbalance_row")));
  for (const std::vector<Cell>& row : table_in(made.beside("out"), "MANIFEST.tsv").rows) {
    if (row.front() != Cell{"sessions.tsv"}) continue;
    EXPECT_THAT(std::get<std::string>(row.back()), HasSubstr("seed generator counterbalance_row"));
  }
  const Table events = table_in(made.beside("out"), "events.tsv");
  EXPECT_EQ(cell_of(events, 0, "data_json"), Cell{R"({"pacing":"stepped","segment":1})"});
  EXPECT_EQ(cell_of(events, 1, "data_json"), Cell{R"({"maximum_age_hours":24})"});
}

// The labels are drawn for Quixote1, Quixote2 and so on, from the last letter to the first: the rows are reversed.
TEST(RelabelledExport, SortsEveryTableByTheNewLabels) {
  MadeUpStudy made;
  fill_with_labels(made);
  export_to(made, made.beside("out"), relabelled());
  const Table participants = table_in(made.beside("out"), "participants.tsv");
  ASSERT_EQ(participants.rows.size(), 4U);
  EXPECT_EQ(participants.rows[0][0], Cell{"vvvvv"});
  EXPECT_EQ(cell_of(participants, 0, "virtual"), Cell{"1"});
  EXPECT_EQ(cell_of(participants, 2, "sex"), Cell{"M"});
  EXPECT_EQ(participants.rows[3][0], Cell{"zzzzz"});
  std::size_t tables = 0;
  for (const std::string& name : files_in(made.beside("out"))) {
    if (!name.ends_with(".tsv")) continue;
    const Table table = table_in(made.beside("out"), name);
    if (table.columns.empty() || table.columns.front().find("participant") != 0) continue;
    ++tables;
    std::vector<std::string> labels{};
    for (const std::vector<Cell>& row : table.rows) {
      labels.push_back(std::get<std::string>(row.front()));
    }
    EXPECT_TRUE(std::is_sorted(labels.begin(), labels.end())) << name;
  }
  EXPECT_GE(tables, 10U);
  std::vector<std::string> of_sav{};
  for (const auto& row : sav(made.beside("out") / "trials.sav").rows) {
    of_sav.push_back(row.at("participant"));
  }
  EXPECT_THAT(of_sav, ElementsAre("wwwww", "wwwww", "xxxxx", "xxxxx", "zzzzz", "zzzzz"));
  EXPECT_TRUE(std::filesystem::exists(made.beside("out") / "bids/sub-zzzzz/ses-01/beh"));
  EXPECT_TRUE(std::filesystem::exists(made.beside("out") /
                                      "psychds/data/subject-zzzzz_session-01_task-rough_data.csv"));
}

/// The rows of a table without the columns that only one of two exports has, and without labels, in some order.
std::vector<std::vector<Cell>> rows_without_labels(const Table& table, const Table& other) {
  std::vector<std::vector<Cell>> rows{};
  for (const std::vector<Cell>& row : table.rows) {
    std::vector<Cell>& kept = rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string& column = table.columns[i];
      const auto& in = other.columns;
      const bool is_common = std::find(in.begin(), in.end(), column) != in.end();
      if (is_common && column != "participant" && column != "data_json") kept.push_back(row[i]);
    }
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

TEST(RelabelledExport, HasTheRowsOfThePublicExport) {
  MadeUpStudy made;
  fill_with_labels(made);
  export_to(made, made.beside("public"), options_of(ExportAudience::published));
  export_to(made, made.beside("out"), relabelled());
  for (const char* const name :
       {"participants.tsv", "sessions.tsv", "trials.tsv", "attempts.tsv", "presentations.tsv",
        "responses.tsv", "events.tsv", "stimuli.tsv"}) {
    const Table of_public = table_in(made.beside("public"), name);
    const Table of_relabelled = table_in(made.beside("out"), name);
    EXPECT_FALSE(of_public.rows.empty()) << name;
    EXPECT_TRUE(rows_without_labels(of_relabelled, of_public) ==
                rows_without_labels(of_public, of_relabelled))
        << name;
  }
  EXPECT_NE(cell_of(table_in(made.beside("out"), "responses.tsv"), 0, "normalised_estimate"),
            Cell{});
}

TEST(RelabelledExport, HasTheSameBytesForTheSameRandomNumbersOnly) {
  MadeUpStudy made;
  fill_with_labels(made);
  export_to(made, made.beside("a"), relabelled());
  export_to(made, made.beside("b"), relabelled());
  const std::set<std::string> files = files_in(made.beside("a"));
  ASSERT_EQ(files_in(made.beside("b")), files);
  for (const std::string& name : files) {
    EXPECT_TRUE(read_file(made.beside("a") / name) == read_file(made.beside("b") / name)) << name;
  }
  export_to(made, made.beside("c"), relabelled(random_bits_of_this_machine()));
  EXPECT_NE(read_file(made.beside("c") / "participants.tsv"),
            read_file(made.beside("a") / "participants.tsv"));
}

// A withdrawal lists the outputs that may contain a participant. Of a virtual one it looks for the label.
TEST(RelabelledExport, IsAmongTheOutputsThatMayContainAParticipant) {
  MadeUpStudy made;
  fill_with_labels(made);
  ListedOutput listed(made.study(), OutputKind::public_export, made.beside("out"));
  export_to(made, made.beside("out"), relabelled());
  ASSERT_FALSE(listed.complete());
  EXPECT_THAT(outputs_of_participant(made.study(), "Quixote9"), SizeIs(1));
}

TEST(RelabelledExport, RequiresRandomNumbers) {
  MadeUpStudy made;
  fill_with_labels(made);
  EXPECT_THAT(refusal_of<std::invalid_argument>(
                  [&] { export_to(made, made.beside("out"), relabelled(RandomBits())); }),
              HasSubstr("random_bits"));
  EXPECT_FALSE(std::filesystem::exists(made.beside("out")));
}

}  // namespace
}  // namespace asperity
