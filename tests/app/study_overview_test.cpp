// What the pages of a study list, counted from rows that are known.

#include "app/tasks/study_overview.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/made_up_study.h"
#include "tests/app/small_study.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::HasSubstr;

MadeUpTrial answered(const std::string& answer, const std::string& right) {
  return {.surfaces = {surface_of(right, "height_map", right)},
          .answers = {answer},
          .right = {right},
          .options = {"brick", "wood"}};
}

TEST(SessionOverviews, CountTrialsThatAreDoneAndAttempts) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("one", "recognition");
  made.add_person("P1", "F");
  MadeUpTrial invalid = answered("wood", "brick");
  invalid.valid = false;
  made.add_session("P1", protocol, {answered("wood", "wood"), invalid});
  const auto sessions = session_overviews(made.study(), {});
  ASSERT_EQ(sessions.size(), 1U);
  EXPECT_EQ(sessions[0].protocol_name, "one");
  EXPECT_EQ(sessions[0].planned_trials, 2);
  EXPECT_EQ(sessions[0].attempts, 2);
  EXPECT_EQ(sessions[0].done_trials, 1);
  EXPECT_DOUBLE_EQ(sessions[0].duration_s, 15.0);  // the second began 10 s after the first, for 5 s
  EXPECT_FALSE(sessions[0].is_running);
  EXPECT_FALSE(sessions[0].is_unfinished());
}

TEST(SessionOverviews, KnowWhetherAnOpenSessionIsHeld) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("one", "recognition");
  made.add_person("P1", "F");
  made.add_session("P1", protocol, {answered("wood", "wood")});
  SessionRow open = made.study().sessions()[0];  // another one that nobody has ended
  open.session = 0;
  open.state = SessionState::open;
  open.ended_utc.reset();
  made.study().add_session(open, {PlannedTrialRow{.trial = 1, .block = "only", .phase = "main"}});
  EXPECT_TRUE(session_overviews(made.study(), {})[1].is_unfinished());
  const StudyLock lock(made.folder(), Study::session_lock_name("P1"));
  EXPECT_TRUE(session_overviews(made.study(), {})[1].is_running);
  EXPECT_FALSE(session_overviews(made.study(), {})[1].is_unfinished());
}

TEST(SessionOverviews, KnowTheFileWithTheTextThatASessionBeganWith) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("one", "recognition");
  made.add_person("P1", "F");
  made.add_session("P1", protocol, {answered("wood", "wood")});
  EXPECT_FALSE(session_overviews(made.study(), {})[0].protocol_file);
  const std::filesystem::path file = made.folder() / "protocols" / "another_name.json";
  std::filesystem::create_directories(file.parent_path());
  write_file(file, made.study().protocol(protocol).source, Overwrite::refuse);
  EXPECT_EQ(session_overviews(made.study(), {})[0].protocol_file, file);
  write_file(file, made.study().protocol(protocol).source + "\n", Overwrite::allow);
  EXPECT_FALSE(session_overviews(made.study(), {})[0].protocol_file);
}

TEST(SessionDetail, StatesWhetherTheResponsesWereCorrect) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("one", "matching");
  made.add_person("P1", "F");
  const std::int64_t id =
      made.add_session("P1", protocol,
                       {answered("wood", "wood"),
                        {.surfaces = {surface_of("brick", "height_map", "brick"),
                                      surface_of("wood", "height_map", "wood")},
                         .answers = {"wood", "brick"},
                         .right = {"brick", "wood"},
                         .options = {"brick", "wood"}}});
  const SessionDetail detail = session_detail(made.study(), id);
  ASSERT_EQ(detail.trials.size(), 2U);
  EXPECT_EQ(detail.trials[0].correct(), true);
  EXPECT_EQ(detail.trials[1].correct(), false);
}

TEST(ParticipantOverviews, CountNoPilotsAsData) {
  MadeUpStudy made{};
  const std::int64_t protocol = made.add_protocol("one", "recognition");
  made.add_person("P1", "F");
  made.add_session("P1", protocol, {answered("wood", "wood")}, SessionMode::pilot);
  made.add_session("P1", protocol, {answered("wood", "wood")});
  const auto people = participant_overviews(made.study());
  ASSERT_EQ(people.size(), 1U);
  EXPECT_EQ(people[0].completed, 1);
  EXPECT_EQ(people[0].unfinished, 0);
  ASSERT_TRUE(people[0].last_session);
  EXPECT_EQ(people[0].last_session->started_utc, "2001-02-03T04:05:06Z");
}

TEST(ProtocolOverviews, KeepVirtualParticipantsAndPilotsApart) {
  const TemporaryFolder folder{};
  make_small_study(folder.path() / "study");
  const std::filesystem::path file = folder.path() / "study" / "protocols" / "small.json";
  write_file(file, small_protocol(), Overwrite::refuse);
  const ModelRegistry models = built_in_models();
  const Protocol protocol = read_small_protocol(models, small_protocol());
  Study study = Study::open(folder.path() / "study", Access::read_write);
  const auto overviews = protocol_overviews(study, models, {});
  ASSERT_EQ(overviews.size(), 1U);
  EXPECT_TRUE(overviews[0].is_valid());
  EXPECT_EQ(overviews[0].name(), protocol.name);
  EXPECT_EQ(overviews[0].blocks, 1);
  EXPECT_EQ(overviews[0].people_done, 0);
  EXPECT_FALSE(overviews[0].last_session);
}

TEST(ProtocolOverviews, ShowWhatCanBeReadOfAProtocolWithProblems) {
  const TemporaryFolder folder{};
  make_small_study(folder.path() / "study");
  nlohmann::json protocol = nlohmann::json::parse(small_protocol());
  protocol["title"] = "Small";
  protocol["flow"] = "no list";
  write_file(folder.path() / "study" / "protocols" / "odd.json", protocol.dump(),
             Overwrite::refuse);
  const Study study = Study::open(folder.path() / "study", Access::read_only);
  const auto overviews = protocol_overviews(study, built_in_models(), {});
  ASSERT_EQ(overviews.size(), 1U);
  EXPECT_FALSE(overviews[0].is_valid());
  EXPECT_EQ(overviews[0].name(), protocol.at("name").get<std::string>());
  EXPECT_EQ(overviews[0].read().title, "Small");
  EXPECT_EQ(overviews[0].read().kind, protocol.at("kind").get<std::string>());
  EXPECT_EQ(overviews[0].read().version, protocol.at("version").get<std::string>());
}

TEST(ProtocolOverviews, NameAFileThatCannotBeReadByItself) {
  const TemporaryFolder folder{};
  make_small_study(folder.path() / "study");
  write_file(folder.path() / "study" / "protocols" / "odd.json", std::string("{"),
             Overwrite::refuse);
  const Study study = Study::open(folder.path() / "study", Access::read_only);
  const auto overviews = protocol_overviews(study, built_in_models(), {});
  ASSERT_EQ(overviews.size(), 1U);
  EXPECT_EQ(overviews[0].name(), "odd");
  EXPECT_TRUE(overviews[0].read().kind.empty());
  EXPECT_FALSE(overviews[0].is_valid());
}

TEST(StimulusOverviews, SayWhatAReliefIsAndWhatIsWrongWithAFile) {
  const TemporaryFolder folder{};
  const std::filesystem::path study = folder.path() / "study";
  make_small_study(study);
  write_file(study / "stimuli" / "torn.png", std::string("no picture"), Overwrite::refuse);
  write_file(study / "stimuli" / "notes.txt", std::string("not listed"), Overwrite::refuse);
  const auto stimuli = stimulus_overviews(study, built_in_models(), 32, {});
  ASSERT_EQ(stimuli.size(), 3U);
  EXPECT_EQ(count_stimuli(study, built_in_models()), 1) << "a photograph is none";
  EXPECT_EQ(stimuli[0].path, "stimuli/grain.png");
  EXPECT_EQ(stimuli[0].kind, StimulusOverview::Kind::height_field);
  EXPECT_TRUE(stimuli[0].problem.empty());
  EXPECT_GT(stimuli[0].rms_m, 0.0);
  EXPECT_EQ(stimuli[0].relief.rows, 32U);
  EXPECT_EQ(stimuli[1].kind, StimulusOverview::Kind::picture);
  EXPECT_EQ(stimuli[1].columns, 2U);
  EXPECT_THAT(stimuli[2].problem.english(), HasSubstr("torn.png"));
}

}  // namespace
}  // namespace asperity
