// Every event of a study leaves it: in events.tsv, in BIDS, and to the public without free text.

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/records/session_timeline.h"
#include "app/words/event_kinds.h"
#include "results_schema/tables/table.h"
#include "tests/app/exported_study.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr std::int64_t kOneSecond_ns = 1'000'000'000;

EventRow event_at(double time_s, const std::string& kind, const std::string& text = "",
                  const std::string& data_json = "null") {
  return {static_cast<std::int64_t>(time_s * 1e9), kind, text, data_json};
}

/// The line of a document's list for this kind.
std::string documented(const EventKind& kind) {
  std::string ends{};
  for (const std::string_view end : kind.ended_by) {
    ends += (ends.empty() ? "`" : ", `") + std::string(end) + "`";
  }
  return "| `" + std::string(kind.name) + "` | " + std::string(kind.meaning) + " | " + ends +
         (ends.empty() ? "|" : " |");
}

TEST(EventKinds, AreListedInTheDescriptionOfTheStore) {
  const std::string page = read_file(fs::path(ASPERITY_SOURCE_DIR) / "docs/formats/study.md");
  std::string expected = "| kind | meaning, text and data | until |\n| --- | --- | --- |\n";
  for (const EventKind& kind : event_kinds()) expected += documented(kind) + '\n';
  EXPECT_NE(page.find(expected), std::string::npos) << expected;
}

// A kind that is stored and not registered would be published as unknown, and missing in the list.
TEST(EventKinds, AreAllThatTheProgramStores) {
  const std::regex stored(
      R"re(\b(?:event|remark|remarked)\((?:[^";]*\? )?"([a-z_]+)"(?: : "([a-z_]+)")?|\.kind = "([a-z_]+)")re");
  std::set<std::string> found{};
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(ASPERITY_SOURCE_DIR) / "app")) {
    const std::string path = entry.path().string();
    const bool writes = path.find("/app/session/") != std::string::npos ||
                        path.find("/gui/session/") != std::string::npos ||
                        path.find("/gui/participant/") != std::string::npos ||
                        path.find("/gui/window/session_desk") != std::string::npos ||
                        path.find("/tasks/session_run") != std::string::npos;
    if (!writes || entry.path().extension() != ".cpp") continue;
    const std::string text = read_file(entry.path());
    for (std::sregex_iterator match(text.begin(), text.end(), stored), end; match != end; ++match) {
      for (std::size_t group = 1; group < match->size(); ++group) {
        if ((*match)[group].matched) found.insert((*match)[group].str());
      }
    }
  }
  EXPECT_GT(found.size(), 25U);
  for (const std::string& kind : found) EXPECT_NE(event_kind(kind), nullptr) << kind;
}

TEST(EventKinds, AreEndedByKinds) {
  for (const EventKind& kind : event_kinds()) {
    for (const std::string_view end : kind.ended_by) EXPECT_NE(event_kind(end), nullptr) << end;
  }
}

TEST(SessionTimeline, GivesAnAttemptNothingThatHappensAtItsEnds) {
  AttemptRow attempt{};
  attempt.onset_ns = 4 * kOneSecond_ns;
  attempt.offset_ns = 6 * kOneSecond_ns;
  const std::vector<AttemptRow> attempts{attempt};
  for (const TimedEvent& event :
       session_timeline({event_at(3.0, "break_began"), event_at(4.0, "break_ended"),
                         event_at(6.0, "break_began")},
                        attempts)) {
    EXPECT_EQ(event.attempt, nullptr) << event.row.time_ns;
  }
}

TEST(SessionTimeline, GivesWhatLastsTheTimeToItsEnd) {
  AttemptRow attempt{};
  attempt.onset_ns = 4 * kOneSecond_ns;
  attempt.offset_ns = 6 * kOneSecond_ns;
  attempt.events = {event_at(4.0, "phase", "fore"), event_at(5.0, "phase", "contact")};
  const std::vector<AttemptRow> attempts{attempt};
  const std::vector<TimedEvent> timeline = session_timeline(
      {event_at(1.0, "paused"), event_at(2.5, "resumed"), event_at(4.5, "note", "sneezed"),
       event_at(7.0, "break_began"), event_at(9.0, "session_stopped", "as asked")},
      attempts);
  std::vector<std::string> kinds{};
  std::vector<std::optional<double>> durations_s{};
  std::vector<bool> in_attempt{};
  for (const TimedEvent& event : timeline) {
    kinds.push_back(event.row.kind);
    durations_s.push_back(event.duration_s);
    in_attempt.push_back(event.attempt == attempts.data());
  }
  EXPECT_THAT(kinds, ElementsAre("paused", "resumed", "phase", "note", "phase", "break_began",
                                 "session_stopped"));
  EXPECT_THAT(durations_s, ElementsAre(1.5, 0.0, 1.0, 0.0, 4.0, 2.0, 0.0));
  EXPECT_THAT(in_attempt, ElementsAre(false, false, true, true, true, false, false));
  EXPECT_EQ(timeline.back().number, 7);
}

// What was under way when the program died has no recorded end, whatever came after it was resumed.
TEST(SessionTimeline, GivesNoDurationToWhatACrashCutOff) {
  const std::vector<TimedEvent> timeline =
      session_timeline({event_at(1.0, "paused"), event_at(5.0, "session_resumed"),
                        event_at(6.0, "paused"), event_at(8.0, "resumed")},
                       {});
  EXPECT_EQ(timeline[0].duration_s, std::nullopt);
  EXPECT_EQ(timeline[2].duration_s, 2.0);
}

/// A session with a note in its first attempt, a masking noise, an event of an attempt, and one of a
/// kind that this version does not store.
void fill_with_events(MadeUpStudy& made) {
  made.add_person("anna", "F");
  const std::int64_t protocol = made.add_protocol("recognition", "recognition", kExportedProtocol);
  MadeUpTrial trial = some_trial();
  trial.events = {event_at(6.2, "input", "option 1", R"({"source":"keyboard"})")};
  const std::int64_t session = made.add_session("anna", protocol, {trial});
  for (const EventRow& row :
       {event_at(5.0, "masking_noise", "",
                 R"({"kind":"pink","measured_dBA":65.0,"verified_by":"Ms Private"})"),
        event_at(5.5, "paused"), event_at(5.75, "resumed"), event_at(6.1, "note", "Anna sneezed"),
        event_at(9.0, "of_tomorrow", "Ms Private", R"({"who":"Ms Private"})")}) {
    made.study().add_event(session, row);
  }
}

TEST(ExportedEvents, HaveARowEach) {
  MadeUpStudy made;
  fill_with_events(made);
  const Exported tables(made);
  const Table events = tables.table("events");
  ASSERT_EQ(events.rows.size(), 6U);
  EXPECT_EQ(cell_of(events, 1, "kind"), Cell{"paused"});
  EXPECT_EQ(cell_of(events, 1, "onset_s"), Cell{"0.5"});
  EXPECT_EQ(cell_of(events, 1, "duration_s"), Cell{"0.25"});
  EXPECT_EQ(cell_of(events, 1, "trial"), Cell{});
  EXPECT_EQ(cell_of(events, 3, "text"), Cell{"Anna sneezed"});
  EXPECT_EQ(cell_of(events, 3, "trial"), Cell{"1"});
  EXPECT_EQ(cell_of(events, 3, "attempt"), Cell{"1"});
  EXPECT_EQ(cell_of(events, 4, "data_json"), Cell{R"({"source":"keyboard"})"});
  EXPECT_THAT(std::get<std::string>(cell_of(events, 0, "data_json")), HasSubstr("Ms Private"));
  const auto sidecar = nlohmann::json::parse(read_file(tables.folder() / "events.json"));
  EXPECT_EQ(sidecar.at("kind").at("Levels").size(), event_kinds().size());
  EXPECT_EQ(sidecar.at("kind").at("HED").at("paused"),
            "(Experiment-control, Pause, Label/paused, {event})");
}

TEST(ExportedEvents, GoToThePublicWithoutFreeText) {
  MadeUpStudy made;
  fill_with_events(made);
  ExportOptions options = options_of(ExportAudience::published);
  const fs::path out = made.beside("out");
  export_to(made, out, options);
  const Table events = table_in(out, "events.tsv");
  ASSERT_EQ(events.rows.size(), 6U);
  EXPECT_EQ(cell_of(events, 0, "data_json"), Cell{R"({"kind":"pink","measured_dBA":65.0})"});
  EXPECT_EQ(cell_of(events, 3, "kind"), Cell{"note"});
  EXPECT_EQ(cell_of(events, 3, "text"), Cell{});
  EXPECT_EQ(cell_of(events, 4, "text"), Cell{"option 1"});
  for (const std::string& name : files_in(out)) {
    if (name.ends_with(".sav") || name.ends_with(".gz")) continue;
    const std::string text = read_file(out / name);
    EXPECT_THAT(text, Not(HasSubstr("Ms Private"))) << name;
    EXPECT_THAT(text, Not(HasSubstr("sneezed"))) << name;
  }
}

// Events, the attempt and its two surfaces, in the order of their onsets.
TEST(ExportedEvents, StandInBidsAmongWhatWasPresented) {
  MadeUpStudy made;
  fill_with_events(made);
  const fs::path out = made.beside("out");
  export_to(made, out);
  const fs::path beh = out / "bids/sub-anna/ses-01/beh";
  const Table events = table_in(beh, "sub-anna_ses-01_task-recognition_events.tsv");
  EXPECT_THAT(std::vector(events.columns.begin(), events.columns.begin() + 4),
              ElementsAre("onset", "duration", "trial_type", "response_time"));
  std::map<std::string, int> kinds{};
  std::vector<double> onsets_s{};
  for (std::size_t i = 0; i < events.rows.size(); ++i) {
    ++kinds[std::get<std::string>(cell_of(events, i, "trial_type"))];
    onsets_s.push_back(std::stod(std::get<std::string>(cell_of(events, i, "onset"))));
    if (cell_of(events, i, "trial_type") == Cell{"attempt"}) {
      EXPECT_EQ(cell_of(events, i, "response_time"), Cell{"1.5"});
      EXPECT_EQ(cell_of(events, i, "factor_order"), Cell{"first"});
    }
  }
  EXPECT_TRUE(std::is_sorted(onsets_s.begin(), onsets_s.end()));
  const std::map<std::string, int> expected{{"attempt", 1}, {"input", 1},      {"masking_noise", 1},
                                            {"note", 1},    {"paused", 1},     {"presentation", 2},
                                            {"resumed", 1}, {"of_tomorrow", 1}};
  EXPECT_EQ(kinds, expected);
  const auto sidecar =
      nlohmann::json::parse(read_file(beh / "sub-anna_ses-01_task-recognition_events.json"));
  for (const std::string& column : events.columns) EXPECT_TRUE(sidecar.contains(column)) << column;
  const Table answers = table_in(beh, "sub-anna_ses-01_task-recognition_beh.tsv");
  EXPECT_EQ(cell_of(answers, 0, "response_time"), cell_of(answers, 0, "from_cue_s"));
}

TEST(ExportedBids, StatesWhoItIsBy) {
  MadeUpStudy made;
  fill_with_events(made);
  const auto description = [](const fs::path& out) {
    return nlohmann::json::parse(read_file(out / "bids/dataset_description.json"));
  };
  export_to(made, made.beside("bare"));
  EXPECT_FALSE(description(made.beside("bare")).contains("Authors"));
  EXPECT_FALSE(description(made.beside("bare")).contains("License"));
  EXPECT_EQ(description(made.beside("bare")).at("HEDVersion"), "8.3.0");
  made.study().set_metadata({.authors = {"Doe, Jane", "Roe, Richard"},
                             .license = "CC-BY-4.0",
                             .ethics_approval = "Board, 12/2026"});
  const fs::path out = made.beside("out");
  export_to(made, out);
  EXPECT_EQ(description(out).at("Authors"), (nlohmann::json{"Doe, Jane", "Roe, Richard"}));
  EXPECT_EQ(description(out).at("License"), "CC-BY-4.0");
  EXPECT_EQ(description(out).at("EthicsApprovals"), nlohmann::json::array({"Board, 12/2026"}));
  EXPECT_THAT(read_file(out / "bids/README"), HasSubstr("Authors: Doe, Jane; Roe, Richard\n"));
  EXPECT_THAT(read_file(out / "bids/CHANGES"), testing::StartsWith("1.0.0 2001-02-03\n"));
  export_to(made, made.beside("public"), options_of(ExportAudience::published));
  EXPECT_THAT(read_file(made.beside("public") / "bids/CHANGES"), testing::StartsWith("1.0.0\n"));
}

// Tags of levels are the protocol's; a number may be written in other digits than in the table.
TEST(ExportedLevels, HaveTheTagsOfTheProtocol) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  const std::int64_t protocol = made.add_protocol("recognition", "recognition", R"({
      "factors": {"spacing_m": {"levels": [0.001, 0.01], "hed": {"1e-2": "Item, Large"}},
                  "order": {"levels": ["first"], "hed": {"first": "Cue"}}}})");
  made.add_session("anna", protocol, {some_trial()});
  const fs::path out = made.beside("out");
  export_to(made, out);
  const auto sidecar = nlohmann::json::parse(
      read_file(out / "bids/sub-anna/ses-01/beh/sub-anna_ses-01_task-recognition_events.json"));
  EXPECT_EQ(sidecar.at("factor_spacing_m").at("HED"), (nlohmann::json{{"0.01", "Item, Large"}}));
  EXPECT_EQ(sidecar.at("trial_type").at("HED").at("attempt"),
            "(Experiment-structure, Label/attempt, {factor_order}, {factor_spacing_m})");
  EXPECT_EQ(sidecar.at("event").at("HED"), "ID/#");
  EXPECT_EQ(sidecar.at("factor_order").at("HED"), (nlohmann::json{{"first", "Cue"}}));
}

}  // namespace
}  // namespace asperity
