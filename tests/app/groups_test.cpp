// Groups of participants, from the beginning of a session to the exported table.

#include "protocols/plan/groups.h"

#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/gathering/group_blocks.h"
#include "app/tasks/group_choice.h"
#include "app/tasks/run_session.h"
#include "app/tasks/simulation/simulation.h"
#include "app/tasks/verify/verify_study.h"
#include "protocols/file/protocol_reader.h"
#include "protocols/file/stored_protocol.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/merge/study_merge.h"
#include "tests/app/exported_study.h"
#include "tests/app/small_study.h"
#include "tests/support/refusal.h"
#include "tests/support/scripted_person.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The small protocol, one trial a session, with two groups.
std::string grouped_protocol(const std::string& assigned, int sessions = 1) {
  std::string text = small_protocol();
  text.replace(text.find("[1, 2, 3]"), 9, "[1]");
  text.insert(text.find("\"factors\": {") + 12,
              R"("training": {"levels": ["haptic", "visual"], "meaning": "practised sense"}, )");
  text.insert(text.find("\"factors\""), R"("groups": {"factor": "training", "assigned": ")" +
                                            assigned + R"("}, "participants": {"sessions": )" +
                                            std::to_string(sessions) + "},\n  ");
  return text;
}

class GroupsOfASession : public testing::Test {
 protected:
  void write(const std::string& protocol) {
    make_small_study(inputs_.study);
    write_file(inputs_.protocol, protocol, Overwrite::allow);
  }
  SessionEnd run(const std::string& participant, const std::optional<std::string>& group = {}) {
    inputs_.participant = participant;
    inputs_.group = group;
    return run_session(inputs_, models_, &person_, {}, {}, {.requests = &requests_});
  }
  std::string refused(const std::string& participant,
                      const std::optional<std::string>& group = {}) {
    return refusal_of<PhrasedError>([&] { run(participant, group); });
  }
  std::map<std::string, std::string> groups() const {
    std::map<std::string, std::string> groups{};
    for (const SessionRow& row : study().sessions()) {
      groups[row.participant + "/" + std::to_string(row.session)] = row.group_level.value_or("-");
    }
    return groups;
  }
  Study study() const { return Study::open(inputs_.study, Access::read_only); }
  std::vector<std::string> problems() const {
    Study opened = study();
    return verify_study(opened, models_, false, {}, [](double) {}).problems;
  }

  TemporaryFolder folder_{};
  ModelRegistry models_ = built_in_models();
  RunInputs inputs_{.protocol = folder_.path() / "study" / "protocols" / "small.json",
                    .study = folder_.path() / "study",
                    .seed = 5,
                    .mode = SessionMode::pilot,
                    .pacing = RunPacing::stepped};
  ScriptedPerson person_{};
  SessionRequests requests_{};
};

TEST_F(GroupsOfASession, AreBalancedByTheProgramAndInEveryTrial) {
  write(grouped_protocol("balanced", 2));
  EXPECT_EQ(run("p1").state, SessionState::completed);
  EXPECT_EQ(run("p2").state, SessionState::completed);
  EXPECT_EQ(run("p1").state, SessionState::completed);
  EXPECT_EQ(groups(), (std::map<std::string, std::string>{
                          {"p1/1", "haptic"}, {"p1/2", "haptic"}, {"p2/1", "visual"}}));
  for (const SessionRow& row : study().sessions()) {
    for (const PlannedTrialRow& trial : study().plan(row.id)) {
      EXPECT_THAT(trial.factors_json, HasSubstr("\"training\":\"" + *row.group_level + "\""));
    }
  }
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_THAT(refused("p3", "haptic"), HasSubstr("the program assigns the groups"));
}

TEST_F(GroupsOfASession, AreStatedByTheExperimenterWhereTheProtocolSaysSo) {
  write(grouped_protocol("by_experimenter"));
  EXPECT_THAT(refused("p1"), HasSubstr("with --group: \"haptic\" or \"visual\""));
  EXPECT_THAT(refused("p1", "olfactory"), HasSubstr("use \"haptic\" or \"visual\""));
  EXPECT_TRUE(study().participants().empty()) << "nothing is stored of what is refused";
  EXPECT_EQ(run("p1", "visual").state, SessionState::completed);
  EXPECT_THAT(refused("p1", "haptic"), HasSubstr("stays in it in all sessions"));
  EXPECT_EQ(run("p1").state, SessionState::completed) << "the group is known";
  EXPECT_EQ(groups(), (std::map<std::string, std::string>{{"p1/1", "visual"}, {"p1/2", "visual"}}));
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(GroupsOfASession, AreRefusedWhereTheProtocolHasNone) {
  write(small_protocol());
  EXPECT_THAT(refused("p1", "haptic"), HasSubstr("has no groups; leave out --group"));
}

TEST_F(GroupsOfASession, StayWithAResumedSession) {
  std::string text = grouped_protocol("by_experimenter");
  text.replace(text.find("\"go\": {\"levels\": [1]"), 20, "\"go\": {\"levels\": [1, 2]");
  write(text);
  person_.at_question = [this](int, const Trial&) -> Reply {
    requests_.stop_after(StopAfter::trial);
    return chooses(0);
  };
  EXPECT_EQ(run("p1", "visual").state, SessionState::stopped);
  person_.at_question = {};
  inputs_.resume = true;
  EXPECT_EQ(run("p1").state, SessionState::completed);
  EXPECT_EQ(groups(), (std::map<std::string, std::string>{{"p1/1", "visual"}}));
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(GroupsOfASession, AlternateInASimulationAndAreExported) {
  write(grouped_protocol("by_experimenter", 2));
  simulate({.protocols = {inputs_.protocol},
            .study = inputs_.study,
            .participants = 4,
            .seed = 3,
            .recordings = Recordings::none},
           models_, {}, {}, {});
  EXPECT_THAT(problems(), IsEmpty());
  const std::filesystem::path out = folder_.path() / "out";
  export_study(study(), models_, out, {});
  const Table people = table_in(out, "participants.tsv");
  const Table sessions = table_in(out, "sessions.tsv");
  const Table trials = table_in(out, "trials.tsv");
  std::vector<std::string> of_people{};
  for (std::size_t i = 0; i < people.rows.size(); ++i) {
    of_people.push_back(std::get<std::string>(cell_of(people, i, "sex")) + " " +
                        std::get<std::string>(cell_of(people, i, "group")));
  }
  EXPECT_THAT(of_people, ElementsAre("F haptic", "M visual", "F visual", "M haptic"));
  ASSERT_EQ(sessions.rows.size(), 8U);
  ASSERT_EQ(trials.rows.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(cell_of(sessions, i, "group"), cell_of(people, i / 2, "group"));
    EXPECT_EQ(cell_of(trials, i, "factor_training"), cell_of(people, i / 2, "group"));
  }
  const Table bids = table_in(out, "virtual/bids/participants.tsv");
  EXPECT_EQ(cell_of(bids, 1, "group"), Cell{"visual"});
  const auto described = columns_in_codebook(table_in(out, "codebook.tsv"));
  EXPECT_TRUE(described.contains({"participants.tsv", "group"}));
  EXPECT_TRUE(described.contains({"sessions.tsv", "group"}));
  // One column for a condition that all participants have, not one per group.
  const std::string wide = read_file(out / "virtual/wide.csv");
  EXPECT_THAT(wide.substr(0, wide.find('\n')), HasSubstr("small_best_height_map"));
  EXPECT_THAT(wide.substr(0, wide.find('\n')), testing::Not(HasSubstr("_haptic_")));
}

TEST_F(GroupsOfASession, ThatDoNotFitThePlanAreFound) {
  write(grouped_protocol("balanced"));
  EXPECT_EQ(run("p1").state, SessionState::completed);
  {
    Study opened = Study::open(inputs_.study, Access::read_write);
    SessionRow row = opened.sessions().at(0);
    row.session = 0;
    row.participant = "p2";
    row.state = SessionState::open;
    opened.add_participant({.label = "p2", .created_utc = "2026-01-01T00:00:00.000Z"});
    const std::vector<PlannedTrialRow> plan = opened.plan(row.id);
    row.group_level = "visual";  // with the plan of the other group
    opened.add_session(row, plan);
  }
  EXPECT_THAT(problems(),
              ElementsAre(HasSubstr("differs from the one that its protocol, seed, row, group "
                                    "and earlier responses")));
}

TEST(GroupsOfEarlierStudies, AreNoColumns) {
  MadeUpStudy made;
  fill(made);
  const Exported tables(made);
  const auto described = columns_in_codebook(tables.codebook());
  EXPECT_FALSE(described.contains({"participants.tsv", "group"}));
  EXPECT_FALSE(described.contains({"sessions.tsv", "group"}));
}

TEST_F(GroupsOfASession, FollowThePermutedBlocksOfTheProtocol) {
  std::string text = grouped_protocol("permuted_blocks");
  text.replace(text.find("permuted_blocks\"") + 16, 0, R"(, "seed": 8, "block_sizes": [2])");
  write(text);
  for (const char* const label : {"p1", "p2", "p3", "p4"}) {
    EXPECT_EQ(run(label).state, SessionState::completed);
  }
  std::map<std::string, std::string> expected{};
  const Protocol protocol = read_protocol(text, "small.json", declarations_of(models_));
  for (std::size_t i = 0; i < 4; ++i) {
    expected["p" + std::to_string(i + 1) + "/1"] = permuted_group(protocol, "pilot", i);
  }
  EXPECT_EQ(groups(), expected);
  EXPECT_NE(expected["p1/1"], expected["p2/1"]) << "a block of two has both groups";
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_THAT(refused("p5", "haptic"), HasSubstr("the program assigns the groups"));
}

/// A participant with the plan of the other group, so that session and plan agree.
TEST_F(GroupsOfASession, ThatAreNotThoseOfTheSequenceAreFound) {
  std::string text = grouped_protocol("permuted_blocks");
  text.replace(text.find("permuted_blocks\"") + 16, 0, R"(, "seed": 8, "block_sizes": [2])");
  write(text);
  for (const char* const label : {"p1", "p2"}) EXPECT_EQ(run(label).state, SessionState::completed);
  EXPECT_THAT(problems(), IsEmpty());
  const Protocol protocol = read_protocol(text, "small.json", declarations_of(models_));
  const std::string third = permuted_group(protocol, "pilot", 2);
  const std::string other = third == "haptic" ? "visual" : "haptic";
  {
    Study opened = Study::open(inputs_.study, Access::read_write);
    std::vector<SessionRow> rows = opened.sessions();
    SessionRow row = rows[0].group_level == other ? rows[0] : rows[1];
    const std::vector<PlannedTrialRow> plan = opened.plan(row.id);
    row.session = 0;
    row.participant = "p3";
    row.state = SessionState::open;
    opened.add_participant({.label = "p3", .created_utc = "2026-01-01T00:00:00.000Z"});
    opened.add_session(row, plan);
  }
  EXPECT_THAT(problems(), ElementsAre("session 1 of participant p3: its group is " + other +
                                      ", and that of place 3 in the permuted blocks is " + third));
}

// Each station begins the sequence anew; what is run in the merged study continues after all of them.
TEST_F(GroupsOfASession, OfAMergedStudyFollowTheSequenceOfEachStation) {
  std::string text = grouped_protocol("permuted_blocks");
  text.replace(text.find("permuted_blocks\"") + 16, 0, R"(, "seed": 8, "block_sizes": [2])");
  const auto move_to = [this](const std::string& name) {
    inputs_.study = folder_ / name;
    inputs_.protocol = inputs_.study / "protocols" / "small.json";
    ++inputs_.seed;
    return inputs_.study;
  };
  write(text);
  for (const char* const label : {"p1", "p3", "p5"}) run(label);
  const std::filesystem::path first = inputs_.study;
  const std::filesystem::path second = move_to("second");
  write(text);
  for (const char* const label : {"p4", "p2"}) run(label);
  EXPECT_THAT(problems(), IsEmpty());
  const std::filesystem::path merged = move_to("merged");
  Study::merge(std::vector<MergeSource>{{second}, {first}}, merged, {});
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_EQ(run("p0").state, SessionState::completed);
  EXPECT_THAT(problems(), IsEmpty());
  const Protocol protocol = read_protocol(text, "small.json", declarations_of(models_));
  EXPECT_EQ(groups().at("p4/1"), permuted_group(protocol, "pilot", 0));
  EXPECT_EQ(groups().at("p0/1"), permuted_group(protocol, "pilot", 5));
  EXPECT_EQ(groups().at("p1/1"), groups().at("p4/1")) << "both are the first of their station";
  // Blocks of two, of each station: p1 and p3, p5; p4 and p2; and that of the sixth place.
  const Study study = Study::open(merged, Access::read_only);
  const std::vector<SessionRow> sessions = study.sessions();
  GroupBlocks blocks(study, sessions);
  std::map<std::string, std::set<std::string>> members{};
  for (const SessionRow& session : sessions) {
    members[blocks.of(session, stored_protocol(text).protocol).value_or("none")].insert(
        session.participant);
  }
  std::set<std::set<std::string>> of_blocks{};
  for (const auto& [name, labels] : members) of_blocks.insert(labels);
  EXPECT_EQ(of_blocks,
            (std::set<std::set<std::string>>{{"p0"}, {"p1", "p3"}, {"p2", "p4"}, {"p5"}}));
}

}  // namespace
}  // namespace asperity
