// Studies of stations: the places that are dealt to each, and the balance of all of them together.

#include "app/study_files/dealt_places.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/records/recorded_attempt.h"
#include "app/session/session_setup.h"
#include "app/tasks/verify/verify_groups.h"
#include "app/tasks/verify/verify_places.h"
#include "app/tasks/verify/verify_study.h"
#include "protocols/plan/groups.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/merge/study_merge.h"
#include "results_schema/part_files.h"
#include "tests/app/small_study.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(PlaceRange, IsReadAsItIsWritten) {
  EXPECT_EQ(place_range_in("13-24"), (PlaceRange{13, 24}));
  EXPECT_EQ(place_range_in("7"), (PlaceRange{7, 7}));
  EXPECT_EQ(text_of(PlaceRange{13, 24}), "13-24");
  EXPECT_EQ(text_of(PlaceRange{7, 7}), "7");
  for (const char* const wrong :
       {"", "-", "0-4", "4-", "-4", "5-4", "1-10000", "a-b", "1 - 4", "1-2-3", "1.0-2"}) {
    EXPECT_FALSE(place_range_in(wrong)) << wrong;
  }
}

using GroupAndRow = std::pair<std::string, int>;  // group and row

/// Stations with a protocol of two groups and two rows.
class Stations : public testing::Test {
 protected:
  Stations() { set_assignment(R"("balanced")"); }

  /// `assigned`: the members of "groups" after the factor.
  void set_assignment(const std::string& assigned) {
    std::string text = small_protocol();
    const auto insert = [&text](const std::string& before, const std::string& inserted) {
      text.insert(text.find(before), inserted);
    };
    text.insert(text.find("\"factors\": {") + 12,
                R"("training": {"levels": ["haptic", "visual"]}, )"
                R"("posture": {"levels": ["sitting", "standing"]}, )");
    insert("\"factors\"", R"("groups": {"factor": "training", "assigned": )" + assigned + "},\n  ");
    insert("\"flow\"", "\"counterbalance\": \"latin\",\n  ");
    text.insert(text.find("{\"run\": \"main\"") + 14, R"(, "for_each": "posture")");
    protocol_ = read_small_protocol(models_, text);
  }
  std::filesystem::path folder(const std::string& station) const { return folder_ / station; }
  /// A new study, with places.
  Study station(const std::string& name, const std::vector<PlaceRange>& places) const {
    make_small_study(folder(name));
    Study study = Study::open(folder(name), Access::read_write);
    for (const PlaceRange& range : places) deal_places(study, range);
    return study;
  }
  SessionRow begin(Study& study, const std::string& label, SessionMode mode = SessionMode::run,
                   const std::optional<std::string>& group = {}) {
    if (!study.participant(label)) {
      study.add_participant({.label = label, .created_utc = "2026-01-01T00:00:00.000Z"});
    }
    const SessionConditions conditions{.mode = mode,
                                       .seed = ++seed_,
                                       .group = group,
                                       .pacing = "stepped",
                                       .scheduling = "none",
                                       .device = {.name = "simulated"},
                                       .started_utc = "2026-01-01T00:00:00.000Z"};
    return begin_session(study, protocol_, label, conditions, {}).row;
  }
  static GroupAndRow assigned(const SessionRow& row) {
    return {row.group_level.value_or("-"), row.counterbalance_row};
  }
  std::vector<std::string> problems(const Study& study) const {
    PlansOfSessions plans(study, models_);
    std::vector<std::string> all = group_problems(study, plans);
    for (const std::string& problem : place_problems(study, plans)) all.push_back(problem);
    return all;
  }

  Study merged(const std::vector<std::string>& stations, const std::string& name) const {
    std::vector<MergeSource> sources{};
    for (const std::string& station : stations) sources.push_back({folder(station)});
    Study::merge(sources, folder(name), {});
    return Study::open(folder(name), Access::read_only);
  }
  VerifyResult verified(Study& study) const {
    return verify_study(study, models_, false, {}, [](double) {});
  }

  TemporaryFolder folder_{};
  std::uint64_t seed_ = 0;  // of the last session
  ModelRegistry models_ = built_in_models();
  Protocol protocol_{};
};

TEST_F(Stations, AreBalancedTogether) {
  ASSERT_EQ(counterbalance_rows(protocol_), 2);
  std::map<GroupAndRow, int> participants{};
  for (const auto& [name, places] :
       {std::pair{"A", PlaceRange{1, 6}}, std::pair{"B", PlaceRange{7, 12}}}) {
    Study study = station(name, {places});
    for (int i = 0; i < 6; ++i) ++participants[assigned(begin(study, name + std::to_string(i)))];
    EXPECT_THAT(problems(study), IsEmpty());
  }
  // Each station alone cannot be: 6 participants in 4 cells.
  EXPECT_EQ(participants,
            (std::map<GroupAndRow, int>{
                {{"haptic", 0}, 3}, {{"haptic", 1}, 3}, {{"visual", 0}, 3}, {{"visual", 1}, 3}}));
}

TEST_F(Stations, StayBalancedWhenTheyAreMerged) {
  for (const auto& [name, assignment] :
       {std::pair{"balanced", R"("balanced")"},
        std::pair{"permuted", R"("permuted_blocks", "seed": 8, "block_sizes": [4])"}}) {
    set_assignment(assignment);
    const std::vector<std::string> stations{std::string(name) + "A", std::string(name) + "B"};
    for (int s = 0; s < 2; ++s) {
      Study study = station(stations[s], {{6 * s + 1, 6 * s + 6}});
      for (int i = 0; i < 6; ++i) begin(study, "AB"[s] + std::to_string(i));
    }
    Study whole = merged({stations[1], stations[0]}, name);
    const VerifyResult result = verified(whole);
    EXPECT_THAT(result.problems, IsEmpty()) << name;
    EXPECT_THAT(result.remarks, IsEmpty()) << name;
    EXPECT_THAT(dealt_places(folder(name)), IsEmpty()) << "a merged study is no station";
    std::map<GroupAndRow, int> participants{};
    for (const SessionRow& row : whole.sessions()) ++participants[assigned(row)];
    EXPECT_EQ(participants,
              (std::map<GroupAndRow, int>{
                  {{"haptic", 0}, 3}, {{"haptic", 1}, 3}, {{"visual", 0}, 3}, {{"visual", 1}, 3}}))
        << name;
  }
}

// In two merges, studies that were copied from one can have the same number.
TEST_F(Stations, KeepTheirSequencesInAMergeOfMergedStudies) {
  set_assignment(R"("permuted_blocks", "seed": 8, "block_sizes": [2])");
  { station("base", {}); }
  for (const auto& [name, labels] :
       {std::pair{"A", std::vector{"A1", "A2"}}, std::pair{"B", std::vector{"B1"}},
        std::pair{"C", std::vector{"C1", "C2"}}, std::pair{"D", std::vector{"D1"}}}) {
    Study::open(folder("base"), Access::read_only).copy_to(folder(name));
    Study study = Study::open(folder(name), Access::read_write);
    for (const char* const label : labels) begin(study, label);
  }
  merged({"A", "B"}, "AB");
  merged({"C", "D"}, "CD");
  Study whole = merged({"AB", "CD"}, "whole");
  EXPECT_THAT(problems(whole), IsEmpty());
}

// Finished sessions of people are merged in any case, and the merge and verify name the same places.
TEST_F(Stations, WithTheSamePlacesAreNamedWhenTheyAreMerged) {
  {
    Study a = station("A", {{1, 4}});
    Study b = station("B", {{2, 5}});
    for (const char* const label : {"A1", "A2", "A3", "A4"}) begin(a, label);
    for (const char* const label : {"B2", "B3", "B4"}) begin(b, label);
    b.withdraw("B3", {.data = WithdrawnData::kept, .decided_by = "R. Keeper"});
    EXPECT_THAT(shared_places(a), IsEmpty());
  }
  Study whole = merged({"A", "B"}, "merged");
  const std::vector<std::string> warnings = shared_places(whole);
  EXPECT_THAT(warnings,
              ElementsAre(AllOf(HasSubstr("places of the protocol small: 2 (A2 and B2) and 4 (A4 "
                                          "and B4). "),
                                HasSubstr("--deal"))));
  const VerifyResult result = verified(whole);
  EXPECT_THAT(result.problems, IsEmpty());
  EXPECT_EQ(result.remarks, warnings);
}

// A participant who dropped out comes back, after the place was given to the next one.
TEST_F(Stations, MayThemselvesHaveAPlaceTwice) {
  {
    Study study = station("A", {{1, 2}});
    const SessionRow first = begin(study, "A1");
    study.end_session(first.id, SessionState::stopped, "2026-01-01T01:00:00.000Z");
    ASSERT_EQ(dealt_place(study.events(begin(study, "A2").id)), 1);
    ASSERT_EQ(dealt_place(study.events(begin(study, "A1").id)), 1);
    EXPECT_THAT(shared_places(study), IsEmpty());
    Study other = station("B", {{3, 4}});
    begin(other, "B3");
  }
  EXPECT_THAT(shared_places(merged({"A", "B"}, "merged")), IsEmpty());
}

TEST_F(Stations, ContinueTheSequenceOfPermutedBlocks) {
  set_assignment(R"("permuted_blocks", "seed": 8, "block_sizes": [4])");
  std::vector<std::string> groups{};
  for (const auto& [name, places] :
       {std::pair{"A", PlaceRange{1, 3}}, std::pair{"B", PlaceRange{4, 8}}}) {
    Study study = station(name, {places});
    for (int place = places.first; place <= places.last; ++place) {
      groups.push_back(assigned(begin(study, "p" + std::to_string(place))).first);
      EXPECT_EQ(groups.back(),
                permuted_group(protocol_, "run", static_cast<std::size_t>(place - 1)));
    }
    EXPECT_THAT(problems(study), IsEmpty());
  }
  EXPECT_EQ(std::count(groups.begin(), groups.end(), "haptic"), 4) << "two complete blocks";
}

// Whoever knows that the next participant gets the place of one who dropped out foresees the group.
TEST_F(Stations, GiveNoPlaceOfPermutedBlocksTwice) {
  set_assignment(R"("permuted_blocks", "seed": 8, "block_sizes": [4])");
  Study study = station("A", {{1, 2}});
  const SessionRow first = begin(study, "p1");
  study.end_session(first.id, SessionState::stopped, "2026-01-01T01:00:00.000Z");
  EXPECT_EQ(dealt_place(study.events(begin(study, "p2").id)), 2);
}

TEST_F(Stations, TakeTheirPlacesInOrderAndStateThem) {
  Study study = station("A", {{5, 6}, {9, 9}});
  std::vector<int> places{};
  for (const char* const label : {"p1", "p2", "p3"}) {
    const SessionRow row = begin(study, label);
    const std::optional<int> place = dealt_place(study.events(row.id));
    ASSERT_TRUE(place);
    places.push_back(*place);
    const Allocation expected = allocations_in_turn(protocol_, "run", *place).back();
    EXPECT_EQ(assigned(row), GroupAndRow(expected.group, expected.counterbalance_row));
  }
  EXPECT_THAT(places, ElementsAre(5, 6, 9));
}

TEST_F(Stations, RefuseAParticipantMoreThanTheyHavePlacesUntilMoreAreDealt) {
  Study study = station("A", {{1, 2}});
  begin(study, "p1");
  begin(study, "p2");
  EXPECT_THAT(refusal_of<ResultsError>([&] { begin(study, "p3"); }),
              AllOf(HasSubstr(folder("A").string()), HasSubstr("no place left"), HasSubstr("small"),
                    HasSubstr("--deal FROM-TO")));
  EXPECT_EQ(study.sessions().size(), 2U);
  deal_places(study, {7, 8});
  EXPECT_EQ(dealt_place(study.events(begin(study, "p3").id)), 7);
}

TEST_F(Stations, KeepAParticipantAtTheirPlace) {
  Study study = station("A", {{3, 4}});
  const SessionRow first = begin(study, "p1");
  begin(study, "p2");
  study.end_session(first.id, SessionState::completed, "2026-01-01T01:00:00.000Z");
  const SessionRow second = begin(study, "p1");
  EXPECT_EQ(assigned(second), assigned(first));
  EXPECT_EQ(dealt_place(study.events(second.id)), 3);
}

TEST_F(Stations, GiveThePlaceOfAParticipantWhoDroppedOutToTheNextOne) {
  Study study = station("A", {{1, 2}});
  const SessionRow first = begin(study, "p1");
  begin(study, "p2");
  study.end_session(first.id, SessionState::stopped, "2026-01-01T01:00:00.000Z");
  EXPECT_EQ(dealt_place(study.events(begin(study, "p3").id)), 1);
  study.withdraw("p2", {.data = WithdrawnData::kept, .decided_by = "R. Keeper"});
  EXPECT_EQ(dealt_place(study.events(begin(study, "p4").id)), 2);
}

TEST_F(Stations, HaveAsManyPlacesOfAGroupThatTheExperimenterStates) {
  set_assignment(R"("by_experimenter")");
  Study study = station("A", {{1, 4}});
  EXPECT_EQ(assigned(begin(study, "p1", SessionMode::run, "visual")).second, 0);
  EXPECT_EQ(assigned(begin(study, "p2", SessionMode::run, "visual")).second, 1);
  EXPECT_THAT(refusal_of<ResultsError>([&] { begin(study, "p3", SessionMode::run, "visual"); }),
              HasSubstr("in the group visual"));
  EXPECT_EQ(assigned(begin(study, "p3", SessionMode::run, "haptic")), GroupAndRow("haptic", 0));
}

TEST_F(Stations, DealNoPlacesToPilots) {
  Study study = station("A", {{1, 1}});
  for (const char* const label : {"p1", "p2", "p3"}) {
    const SessionRow row = begin(study, label, SessionMode::pilot);
    EXPECT_FALSE(dealt_place(study.events(row.id)));
  }
  EXPECT_EQ(dealt_place(study.events(begin(study, "p4").id)), 1);
}

TEST_F(Stations, AreDealtEveryPlaceOnceAndBeforeTheFirstSession) {
  Study study = station("A", {{1, 6}, {13, 18}});
  EXPECT_THAT(dealt_places(folder("A")), ElementsAre(PlaceRange{1, 6}, PlaceRange{13, 18}));
  for (const PlaceRange& taken : {PlaceRange{6, 7}, PlaceRange{1, 20}, PlaceRange{14, 14}}) {
    EXPECT_THAT(refusal_of([&] { deal_places(study, taken); }), HasSubstr("are dealt to the study"))
        << text_of(taken);
  }
  Study begun = station("B", {});
  EXPECT_THAT(dealt_places(folder("B")), IsEmpty());
  begin(begun, "p1");
  EXPECT_THAT(refusal_of([&] {
                deal_places(begun, {7, 12});
              }),
              AllOf(HasSubstr(folder("B").string()), HasSubstr("before the first session")));
}

TEST_F(Stations, BeginNoSessionWithADamagedDeal) {
  Study study = station("A", {{1, 6}});
  write_file(folder("A") / kDealFile, R"({"format": "asperity.deal/1", "places": ["6-1"]})",
             Overwrite::allow);
  EXPECT_THAT(refusal_of([&] { begin(study, "p1"); }),
              HasSubstr((folder("A") / kDealFile).string()));
  EXPECT_THAT(study.sessions(), IsEmpty());
}

/// A session with the place of another group and row.
TEST_F(Stations, WhosePlacesWereChangedAreFound) {
  Study study = station("A", {{1, 2}});
  begin(study, "p1");
  SessionRow row = begin(study, "p2");
  EXPECT_THAT(problems(study), IsEmpty());
  const std::vector<PlannedTrialRow> plan = study.plan(row.id);
  row.session = 0;
  row.participant = "p3";
  study.add_participant({.label = "p3", .created_utc = "2026-01-01T00:00:00.000Z"});
  study.add_event(study.add_session(row, plan), {row.clock_zero_ns, kDealtEvent, "1"});
  EXPECT_THAT(problems(study),
              ElementsAre("session 1 of participant p3: it has row 0 and group visual, and its "
                          "place 1 has row 0 and group haptic"));
}

}  // namespace
}  // namespace asperity
