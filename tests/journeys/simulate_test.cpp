// simulate: the same seed gives the same tables, and as many rows as were planned.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "results_schema/study.h"
#include "tests/journeys/program.h"
#include "tests/journeys/small_study.h"

namespace asperity::test {
namespace {

// 2 textures × 3 repetitions.
constexpr int kRepetitions = 3;
constexpr std::size_t kTrialsPerSession = 6;

std::map<std::string, std::string> tables_of(const SmallStudy& small, const std::string& name,
                                             int seed, const std::vector<std::string>& more = {}) {
  const fs::path study = small.place() / name;
  copy_stimuli(small, study);
  std::vector<std::string> arguments = simulate_arguments(small, study, 3, seed);
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = asperity(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return exported(study, small.place() / (name + "_tables"));
}

/// Of the seed 7, made once.
const std::map<std::string, std::string>& tables() {
  static const auto made = tables_of(SmallStudy(kRepetitions), "once", 7);
  return made;
}

TEST(Simulate, ExportsTheSameBytesForTheSameSeedWhateverTheJobs) {
  for (const char* table : {"participants", "sessions", "trials", "attempts", "presentations",
                            "responses", "servo_quality", "compliance", "codebook"}) {
    EXPECT_TRUE(tables().contains(std::string(table) + ".tsv")) << table;
  }
  EXPECT_TRUE(tables_of(SmallStudy(kRepetitions), "again", 7, {"--jobs", "2"}) == tables());
}

TEST(Simulate, HasTheDeviceThatItIsGiven) {
  const SmallStudy small(1);
  const fs::path study = small.place() / "arm";
  copy_stimuli(small, study);
  std::vector<std::string> arguments = simulate_arguments(small, study, 1, 7);
  arguments.insert(arguments.end(), {"--device", "simulated:falcon,mass_kg=0.2"});
  ASSERT_EQ(asperity(arguments).status, 0);
  for (const SessionRow& row : Study::open(study, Access::read_only).sessions()) {
    EXPECT_EQ(row.device, "simulated in place of Novint Falcon with mass_kg=0.2");
  }
  arguments.back() = "falcon";
  const Outcome real = asperity(arguments);
  EXPECT_EQ(real.status, 1);
  EXPECT_THAT(real.err, testing::HasSubstr("a virtual participant cannot hold the device"));
}

TEST(Simulate, AnswersOtherwiseForAnotherSeed) {
  const Tsv one = tsv(tables().at("responses.tsv"));
  const Tsv other = tsv(tables_of(SmallStudy(kRepetitions), "other", 8).at("responses.tsv"));
  ASSERT_EQ(one.rows.size(), other.rows.size());
  EXPECT_NE(one.column("answer"), other.column("answer"));
}

TEST(Simulate, HasAsManyRowsAsPlanned) {
  // 3 participants × 2 protocols × 6 trials; a selection presents two surfaces, a recognition one.
  EXPECT_EQ(tsv(tables().at("participants.tsv")).rows.size(), 3U);
  EXPECT_EQ(tsv(tables().at("sessions.tsv")).rows.size(), 6U);
  EXPECT_EQ(tsv(tables().at("trials.tsv")).rows.size(), 6 * kTrialsPerSession);
  EXPECT_EQ(tsv(tables().at("attempts.tsv")).rows.size(), 6 * kTrialsPerSession);
  EXPECT_EQ(tsv(tables().at("responses.tsv")).rows.size(), 6 * kTrialsPerSession);
  EXPECT_EQ(tsv(tables().at("presentations.tsv")).rows.size(), 3 * (2 + 1) * kTrialsPerSession);
  EXPECT_EQ(tsv(tables().at("servo_quality.tsv")).rows.size(), 6 * kTrialsPerSession);
  EXPECT_EQ(tsv(tables().at("participants.tsv")).column("sex"),
            (std::vector<std::string>{"F", "M", "F"}));
  EXPECT_EQ(tsv(tables().at("participants.tsv")).column("participant"),
            (std::vector<std::string>{"virtual0001", "virtual0002", "virtual0003"}));
}

TEST(Simulate, SaysItsTotalsAsOneJsonDocumentAndEachCommitOnStandardError) {
  const SmallStudy small(kRepetitions);
  std::vector<std::string> arguments = simulate_arguments(small, small.study(), 1, 3);
  arguments.emplace_back("--json");
  const Outcome outcome = asperity(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.out.rfind("{\n  \"format\": \"asperity.simulate/1\"", 0), 0U) << outcome.out;
  const auto totals = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(totals.at("sessions"), 2);
  EXPECT_EQ(totals.at("attempts"), 2 * kTrialsPerSession);
  EXPECT_GT(totals.at("simulated_s"), totals.at("wall_s"));
  const std::vector<std::string> done = done_lines(outcome.err);
  ASSERT_EQ(done.size(), 2 * kTrialsPerSession);
  EXPECT_EQ(done.front(), "done virtual0001 1 1 1");
  EXPECT_EQ(done.back(), "done virtual0001 2 6 1");
  const std::string columns = "done PARTICIPANT SESSION TRIAL ATTEMPT";
  EXPECT_LT(outcome.err.find(columns), outcome.err.find(done.front()));
  EXPECT_EQ(outcome.err.find(columns), outcome.err.rfind(columns)) << "once";
}

TEST(Simulate, KeepsTheRecordingsThatWereAskedFor) {
  const SmallStudy small(1);
  const auto recorded_by = [&small](const std::string& which) {
    const fs::path study = small.place() / ("recordings_" + which);
    copy_stimuli(small, study);
    std::vector<std::string> arguments = simulate_arguments(small, study, 2, 3);
    arguments.insert(arguments.end(), {"--recordings", which});
    EXPECT_EQ(asperity(arguments).status, 0);
    std::size_t files = 0;
    for (const auto& [name, content] : contents_of(study / "recordings")) {
      if (name.ends_with(".rec")) ++files;
    }
    return files;
  };
  // 2 protocols × 2 trials each.
  EXPECT_EQ(recorded_by("all"), 8U);
  EXPECT_EQ(recorded_by("first"), 4U);
  EXPECT_EQ(recorded_by("none"), 0U);
}

std::vector<std::string> with_resume(std::vector<std::string> arguments) {
  arguments.emplace_back("--resume");
  return arguments;
}

// With 2 participants: of all, the second has records that "first" would not keep.
TEST(Simulate, IsNotResumedWithOtherRecordings) {
  const SmallStudy small(1);
  const auto with = [&small](const std::string& which) {
    std::vector<std::string> arguments = simulate_arguments(small, small.study(), 2, 3);
    arguments.insert(arguments.end(), {"--recordings", which});
    return arguments;
  };
  ASSERT_EQ(asperity(with("all")).status, 0);
  EXPECT_EQ(asperity(with_resume(with("all"))).status, 0);
  for (const char* const other : {"first", "none"}) {
    const Outcome refused = asperity(with_resume(with(other)));
    EXPECT_EQ(refused.status, 1) << other;
    EXPECT_THAT(refused.err, testing::HasSubstr("Resume with the value of --recordings with which "
                                                "it was begun"));
  }
}

// Both models of a trial are matched to the force of the height map on its texture, which is stored with each of them.
TEST(Simulate, StoresTheForceToWhichATextureWasMatched) {
  const SmallStudy small(1);
  nlohmann::ordered_json protocol = nlohmann::ordered_json::parse(text_of(small.selection()));
  protocol["stimuli"]["rendered"]["equal_force"] = {{"to_model", "height_map"}};
  write_text(small.selection(), protocol.dump(2));
  const Outcome simulated = asperity({"simulate", small.selection(), "--study", small.study(),
                                      "--participants", "1", "--seed", "3"});
  ASSERT_EQ(simulated.status, 0) << simulated.err;
  const Tsv presentations =
      tsv(exported(small.study(), small.place() / "tables").at("presentations.tsv"));
  const std::vector<std::string> textures = presentations.column("texture");
  const std::vector<std::string> forces_N = presentations.column("matched_texture_force_N");
  std::map<std::string, std::string> of_texture{};
  for (std::size_t i = 0; i < textures.size(); ++i) {
    EXPECT_GT(number_in(forces_N[i]).value_or(0.0), 0.0) << textures[i];
    EXPECT_EQ(of_texture.emplace(textures[i], forces_N[i]).first->second, forces_N[i])
        << textures[i];
  }
  EXPECT_EQ(of_texture.size(), 2U);
}

std::vector<std::string> participants_in(const fs::path& study, const fs::path& tables) {
  return tsv(exported(study, tables).at("participants.tsv")).column("participant");
}

void delete_participant(const fs::path& study, const std::string& label) {
  ASSERT_EQ(
      asperity({"withdraw", study, label, "--delete", "--confirm", label, "--by", "a test"}).status,
      0);
}

TEST(Simulate, IsCompleteWithoutParticipantsWhoWithdrew) {
  const SmallStudy small(1);
  const auto arguments = simulate_arguments(small, small.study(), 3, 7);
  ASSERT_EQ(asperity(arguments).status, 0);
  ASSERT_EQ(asperity({"withdraw", small.study(), "virtual0001", "--by", "a test"}).status, 0);
  delete_participant(small.study(), "virtual0003");
  const Outcome resumed = asperity(with_resume(arguments));
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_EQ(stored_attempts_in(resumed.err), std::vector<std::string>{});
  EXPECT_EQ(participants_in(small.study(), small.place() / "resumed"),
            (std::vector<std::string>{"virtual0001", "virtual0002"}));

  // The simulation is complete, so that its arguments add three others, and none under the label that was deleted.
  const Outcome added = asperity(arguments);
  EXPECT_EQ(added.status, 0) << added.err;
  EXPECT_EQ(participants_in(small.study(), small.place() / "added"),
            (std::vector<std::string>{"virtual0001", "virtual0002", "virtual0004", "virtual0005",
                                      "virtual0006"}));
}

TEST(Simulate, DoesNotBeginAgainWhereAllParticipantsWereDeleted) {
  const SmallStudy small(1);
  const auto arguments = simulate_arguments(small, small.study(), 1, 7);
  ASSERT_EQ(asperity(arguments).status, 0);
  delete_participant(small.study(), "virtual0001");
  const Outcome resumed = asperity(with_resume(arguments));
  EXPECT_EQ(resumed.status, 1);
  EXPECT_THAT(resumed.err,
              testing::HasSubstr("has no participant of a simulation with --participants 1 and "
                                 "--seed 7 (1 virtual participant was deleted from the study"));

  const Outcome added = asperity(arguments);
  EXPECT_EQ(added.status, 0) << added.err;
  EXPECT_EQ(participants_in(small.study(), small.place() / "added"),
            std::vector<std::string>{"virtual0002"})
      << "the participant who was deleted is made again";
}

TEST(Simulate, AddsParticipantsAndStatesHowManyWithTheSeedThereAre) {
  const SmallStudy small(1);
  const Outcome first = asperity(simulate_arguments(small, small.study(), 2, 3));
  EXPECT_EQ(first.err.find("already"), std::string::npos) << first.err;
  const Outcome second = asperity(simulate_arguments(small, small.study(), 2, 3));
  EXPECT_EQ(second.status, 0) << second.err;
  EXPECT_THAT(second.err,
              testing::HasSubstr("the study already has 2 participants with the seed 3; "
                                 "virtual0003 to virtual0004 are added. To resume a simulation "
                                 "instead, add --resume\n"));
  const Outcome resumed = asperity(with_resume(simulate_arguments(small, small.study(), 2, 3)));
  EXPECT_EQ(resumed.err.find("already"), std::string::npos) << resumed.err;
  const Outcome other = asperity(simulate_arguments(small, small.study(), 1, 4));
  EXPECT_EQ(other.err.find("already"), std::string::npos) << other.err;
  EXPECT_EQ(participants_in(small.study(), small.place() / "tables"),
            (std::vector<std::string>{"virtual0001", "virtual0002", "virtual0003", "virtual0004",
                                      "virtual0005"}));
}

// Their responses would be analysed together, under one name and version.
TEST(Simulate, WarnsAsCheckDoesOfSessionsWithAnotherTextOfTheVersion) {
  const SmallStudy small = simulated_study(2, 3);
  const std::vector<std::string> check{"check", small.selection(), "--study", small.study()};
  EXPECT_EQ(asperity(check).err.find("another text"), std::string::npos);
  auto protocol = nlohmann::ordered_json::parse(text_of(small.selection()));
  protocol["title"] = "Another title";
  write_text(small.selection(), protocol.dump(2));
  const auto warns = testing::HasSubstr(
      "warning: the study has 2 sessions of virtual participants with another text of "
      "small_selection 1.0.0; their responses would be analysed together with new ones; remove the "
      "virtual participants, or give the changed protocol a new version (/version)");
  const Outcome checked = asperity(check);
  EXPECT_EQ(checked.status, 0);
  EXPECT_THAT(checked.err, warns);
  const Outcome simulated = asperity(simulate_arguments(small, small.study(), 1, 4));
  EXPECT_EQ(simulated.status, 0);
  EXPECT_THAT(simulated.err, warns);
  // In another language it is the same protocol.
  protocol["title"] = "Ein anderer Titel";
  protocol["language"] = "de";
  write_text(small.selection(), protocol.dump(2));
  EXPECT_EQ(asperity(check).err.find("another text"), std::string::npos);
}

}  // namespace
}  // namespace asperity::test
