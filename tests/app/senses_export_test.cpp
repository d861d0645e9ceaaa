// What participants were to see and hear, and what was recorded of it, in an export.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/exports/new_labels.h"
#include "app/records/eye_mask.h"
#include "results_schema/tables/table.h"
#include "tests/app/exported_study.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kBlindfolded = R"({"environment": {
  "vision": "blindfold", "masking_noise": {"kind": "pink", "level_dBA": 65}}})";
constexpr const char* kMeasured = R"({"kind": "pink", "declared_dBA": 65, "measured_dBA": 64.5,
  "verified_by": "A. Keller", "heard": true})";
constexpr std::int64_t kOneSecond_ns = 1'000'000'000;

EventRow event_at_s(double time_s, const std::string& kind, const std::string& data = "null") {
  return {static_cast<std::int64_t>(time_s * 1e9), kind, "", data};
}

/// A trial whose only surface was touched twice. The first trial of a made-up session begins after 6 s, the second after
/// 16 s.
MadeUpTrial touched_at(double first_s, double second_s) {
  MadeUpTrial trial = some_trial();
  trial.surfaces.resize(1);
  for (const double time_s : {first_s, second_s}) {
    const auto time_ns = static_cast<std::int64_t>(time_s * 1e9);
    trial.surfaces.front().visits.push_back(
        {.contact_ns = time_ns, .offset_ns = time_ns + kOneSecond_ns / 2, .contact_s = 0.5});
  }
  return trial;
}

/// The mask is worn in the first trial, and taken off before the second visit of the second one.
void fill_with_senses(MadeUpStudy& made) {
  made.add_person("anna", "F");
  MadeUpTrial first = touched_at(7.0, 8.0);
  first.events = {event_at_s(6.5, "mask_on")};
  MadeUpTrial second = touched_at(17.0, 18.0);
  second.events = {event_at_s(17.5, "mask_off")};
  const std::int64_t session = made.add_session(
      "anna", made.add_protocol("dark", "recognition", kBlindfolded), {first, second});
  made.study().add_event(session, event_at_s(5.0, "session_began", R"({"segment": 1})"));
  made.study().add_event(session, event_at_s(5.1, "masking_noise", kMeasured));
}

TEST(EyeMask, IsOffUntilItIsConfirmedAndAfterASessionIsResumed) {
  const std::vector<TimedEvent> timeline = session_timeline(
      {event_at_s(1.0, "session_began"), event_at_s(2.0, "mask_on"), event_at_s(4.0, "mask_off"),
       event_at_s(5.0, "mask_on"), event_at_s(7.0, "session_resumed")},
      {});
  const EyeMask mask(timeline);
  std::vector<bool> is_on{};
  for (const int time_s : {0, 1, 2, 3, 4, 5, 6, 7, 8}) {
    is_on.push_back(mask.is_on(time_s * kOneSecond_ns));
  }
  EXPECT_THAT(is_on, ElementsAre(false, false, true, true, false, true, true, false, false));
}

TEST(EyeMask, IsJudgedWhenSurfacesWereTouched) {
  const EyeMask mask(
      session_timeline({event_at_s(2.0, "mask_on"), event_at_s(4.0, "mask_off")}, {}));
  AttemptRow attempt{};
  EXPECT_EQ(mask.was_on_in(attempt), std::nullopt) << "no surface appeared";
  attempt.presentations = {surface_of("a", "sinusoid", "a")};
  attempt.presentations[0].onset_ns = kOneSecond_ns;
  EXPECT_EQ(mask.was_on_in(attempt), false);
  attempt.presentations[0].visits = {{.contact_ns = 3 * kOneSecond_ns}};
  EXPECT_EQ(mask.was_on_in(attempt), true) << "it appeared before the mask was on";
  attempt.presentations[0].visits.push_back({.contact_ns = 5 * kOneSecond_ns});
  EXPECT_EQ(mask.was_on_in(attempt), false);
}

TEST(SensesExport, StatesWhatIsRequestedForTheSessionAndWhatWasRecordedForEachAttempt) {
  MadeUpStudy made;
  fill_with_senses(made);
  const Exported tables(made);
  const Table sessions = tables.table("sessions");
  EXPECT_EQ(cell_of(sessions, 0, "vision"), Cell{"blindfold"});
  EXPECT_EQ(cell_of(sessions, 0, "masking_noise"), Cell{"pink"});
  EXPECT_EQ(cell_of(sessions, 0, "masking_noise_level_dBA"), Cell{"65"});
  const Table attempts = tables.table("attempts");
  EXPECT_EQ(cell_of(attempts, 0, "eye_mask_confirmed"), Cell{"1"});
  EXPECT_EQ(cell_of(attempts, 1, "eye_mask_confirmed"), Cell{"0"});
  EXPECT_EQ(cell_of(attempts, 0, "masking_noise_source"), Cell{"program"});
  EXPECT_EQ(cell_of(attempts, 0, "masking_noise_measured_dBA"), Cell{"64.5"});
}

// A protocol may request noise of a session without a sound output: the export states what there was.
TEST(SensesExport, TakesTheRecordedNoiseAndNotTheRequestedOne) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  const std::int64_t protocol = made.add_protocol("dark", "recognition", kBlindfolded);
  const std::int64_t silent = made.add_session("anna", protocol, {some_trial()});
  made.study().add_event(silent, event_at_s(5.0, "session_began", R"({"segment": 1})"));
  made.study().add_event(silent,
                         event_at_s(5.1, "masking_noise", R"({"kind": "none", "heard": false})"));
  made.add_person("bert", "M");
  made.add_session("bert", protocol, {some_trial()});  // of which nothing is recorded
  const Exported tables(made);
  EXPECT_EQ(cell_of(tables.table("sessions"), 0, "masking_noise"), Cell{"pink"});
  const Table attempts = tables.table("attempts");
  EXPECT_EQ(cell_of(attempts, 0, "masking_noise_source"), Cell{"not_played"});
  EXPECT_EQ(cell_of(attempts, 0, "masking_noise_measured_dBA"), Cell{});
  EXPECT_EQ(cell_of(attempts, 0, "eye_mask_confirmed"), Cell{"0"});
  EXPECT_EQ(cell_of(attempts, 1, "masking_noise_source"), Cell{});
}

TEST(SensesExport, HasTheDefaultsOfAProtocolThatStatesNothing) {
  const Exported& tables = exported_tables();
  const Table sessions = tables.table("sessions");
  EXPECT_EQ(cell_of(sessions, 0, "vision"), Cell{"free"});
  EXPECT_EQ(cell_of(sessions, 0, "masking_noise"), Cell{"none"});
  EXPECT_EQ(cell_of(sessions, 0, "masking_noise_level_dBA"), Cell{});
  EXPECT_EQ(cell_of(tables.table("attempts"), 0, "eye_mask_confirmed"), Cell{});
}

// The hand is hidden, and no eye mask is worn: none can be confirmed.
TEST(SensesExport, StatesThatTheHandWasHidden) {
  MadeUpStudy made;
  made.add_person("anna", "F");
  made.add_session(
      "anna",
      made.add_protocol("dark", "recognition", R"({"environment": {"vision": "hand_occluded"}})"),
      {some_trial()});
  const fs::path out = made.beside("out");
  export_to(made, out);
  const Table sessions = table_in(out, "sessions.tsv");
  EXPECT_EQ(cell_of(sessions, 0, "vision"), Cell{"hand_occluded"});
  EXPECT_EQ(cell_of(sessions, 0, "masking_noise"), Cell{"none"});
  EXPECT_EQ(cell_of(table_in(out, "attempts.tsv"), 0, "eye_mask_confirmed"), Cell{});
  const std::string start = "bids/sub-anna/ses-01/beh/sub-anna_ses-01_task-dark_";
  for (const char* const suffix : {"beh.json", "events.json"}) {
    const auto sidecar = nlohmann::json::parse(read_file(out / (start + suffix)));
    EXPECT_EQ(sidecar.at("Environment").at("Vision"), "hand_occluded") << suffix;
  }
}

// The members of the sidecar of events that are not objects are errors of bids-validator.
TEST(SensesExport, IsInTheSidecarsOfBids) {
  MadeUpStudy made;
  fill_with_senses(made);
  const fs::path out = made.beside("out");
  export_to(made, out);
  const std::string start = "bids/sub-anna/ses-01/beh/sub-anna_ses-01_task-dark_";
  for (const char* const suffix : {"beh.json", "events.json"}) {
    const auto sidecar = nlohmann::json::parse(read_file(out / (start + suffix)));
    const nlohmann::json& environment = sidecar.at("Environment");
    EXPECT_EQ(environment.at("Vision"), "blindfold") << suffix;
    EXPECT_EQ(environment.at("MaskingNoise"), "pink") << suffix;
    EXPECT_EQ(environment.at("MaskingNoiseLevel_dBA"), 65.0) << suffix;
  }
  const auto of_events = nlohmann::json::parse(read_file(out / (start + "events.json")));
  for (const auto& [name, member] : of_events.items()) EXPECT_TRUE(member.is_object()) << name;
  const Table answers = table_in(out, start + "beh.tsv");
  EXPECT_EQ(cell_of(answers, 0, "eye_mask_confirmed"), Cell{"1"});
  EXPECT_EQ(cell_of(answers, 0, "masking_noise_measured_dBA"), Cell{"64.5"});
}

// A level is measured on a day: it would narrow down when a session was run.
TEST(SensesExport, LeavesTheMeasuredLevelOutWithNewLabels) {
  MadeUpStudy made;
  fill_with_senses(made);
  const fs::path out = made.beside("out");
  ExportOptions options = options_of(ExportAudience::relabelled);
  options.random_bits = random_bits_of_this_machine();
  export_to(made, out, options);
  const Table attempts = table_in(out, "attempts.tsv");
  EXPECT_THAT(attempts.columns, Not(Contains("masking_noise_measured_dBA")));
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(out)) {
    if (each.path().extension() != ".json") continue;
    EXPECT_THAT(read_file(each.path()), Not(HasSubstr("masking_noise_measured_dBA")))
        << each.path() << " refers to a column that is left out";
  }
  EXPECT_EQ(cell_of(attempts, 0, "masking_noise_source"), Cell{"program"});
  EXPECT_EQ(cell_of(table_in(out, "sessions.tsv"), 0, "masking_noise_level_dBA"), Cell{"65"});
}

}  // namespace
}  // namespace asperity
