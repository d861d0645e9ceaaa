// The temporary study of a trial with the mouse, for every protocol of the library.

#include "app/tasks/mouse_trial.h"

#include <map>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/group_choice.h"
#include "app/tasks/protocol_files.h"
#include "app/words/phrase_of_error.h"
#include "protocols/file/library_protocols.h"
#include "protocols/plan/course.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"
#include "tests/app/small_study.h"
#include "tests/support/replaced.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

constexpr const char* kIntroduction = "You try this experiment with the mouse.";

std::map<std::string, std::string> hashes_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> hashes{};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) hashes[entry.path().string()] = sha256_of_file(entry.path());
  }
  return hashes;
}

/// A study with the protocols of the library, whose files are not read.
class MouseTrialOfLibrary : public testing::TestWithParam<LibraryProtocol> {
 protected:
  MouseTrialOfLibrary() {
    Study::create(study, "library");
    write_file(study / "protocols" / "tried.json", GetParam().text, Overwrite::refuse);
    protocol = load_protocol(study / "protocols" / "tried.json", models, study);
    for (const NamedFile& file : files_of(protocol)) {
      for (const std::string& path : paths_of(file)) {
        if (!std::filesystem::exists(study / path)) {
          write_file(study / path, "content of " + path, Overwrite::refuse);
        }
      }
    }
  }

  TemporaryFolder folder{};
  std::filesystem::path study = folder / "study";
  ModelRegistry models = built_in_models();
  Protocol protocol{};
};

TEST_P(MouseTrialOfLibrary, BeginsWithTwoTrialsOfItsFirstMainBlock) {
  const auto before = hashes_in(study);
  std::filesystem::path temporary{};
  {
    const MouseTrial trial(protocol, study, kIntroduction, 7);
    const RunInputs& inputs = trial.inputs();
    temporary = inputs.study;
    EXPECT_EQ(inputs.mode, SessionMode::pilot);
    EXPECT_EQ(inputs.device, "mouse");
    // Errors: a protocol with problems.
    const Protocol tried = load_protocol(inputs.protocol, models, inputs.study);
    EXPECT_TRUE(tried.input_only);
    EXPECT_EQ(tried.masking_noise.kind, Protocol::Noise::Kind::none);
    EXPECT_EQ(tried.blocks.size(), protocol.blocks.size());
    EXPECT_FALSE(tried.instability);
    for (const auto& [name, exploration] : tried.explorations) {
      EXPECT_EQ(exploration.on_failure, Exploration::OnFailure::flag) << "no trial is repeated";
    }
    for (const NamedFile& file : files_of(protocol)) {
      for (const std::string& path : paths_of(file)) {
        EXPECT_EQ(read_file(inputs.study / path), read_file(study / path));
      }
    }

    const Plan plan = example_plan(tried, {inputs.seed, 0});
    const auto* first = std::get_if<Protocol::Screen>(&plan.steps.front());
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->text, kIntroduction);
    ASSERT_GE(plan.trials.size(), 2U);
    EXPECT_EQ(plan.trials[0].block, plan.trials[1].block);
    EXPECT_EQ(tried.blocks.at(plan.trials[0].block).phase, Phase::main);
    int trials = 0;
    for (const PlanStep& step : plan.steps) {
      if (std::holds_alternative<TrialStep>(step) && ++trials == MouseTrial::kLastTrial) break;
      EXPECT_FALSE(std::holds_alternative<Protocol::Check>(step));
      EXPECT_FALSE(std::holds_alternative<Protocol::Break>(step));
    }
    EXPECT_EQ(trials, MouseTrial::kLastTrial);
  }
  EXPECT_FALSE(std::filesystem::exists(temporary));
  EXPECT_EQ(hashes_in(study), before);
}

INSTANTIATE_TEST_SUITE_P(Protocols, MouseTrialOfLibrary, testing::ValuesIn(library_protocols()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST(MouseTrial, KeepsComments) {
  const std::string text = replaced(small_protocol(), R"("explorations": {)",
                                    R"("explorations": {"$comment": "one of two", )");
  const Protocol protocol = read_small_protocol(built_in_models(), text);
  EXPECT_THAT(mouse_trial_text(protocol, kIntroduction), testing::HasSubstr("one of two"));
}

TEST(MouseTrial, IsOfAnyGroup) {
  const TemporaryFolder folder{};
  const std::filesystem::path study = folder / "study";
  make_small_study(study);
  const ModelRegistry models = built_in_models();
  for (const char* assigned : {"", R"(, "assigned": "by_experimenter")",
                               R"(, "assigned": "permuted_blocks", "seed": 4)"}) {
    const Protocol protocol = read_small_protocol(
        models, replaced(small_protocol(), R"("factors": {)",
                         std::string(R"("groups": {"factor": "ground")") + assigned +
                             R"(}, "factors": {"ground": {"levels": ["dawn", "dusk"]}, )"));
    EXPECT_EQ(MouseTrial(protocol, study, kIntroduction, 7).inputs().group, "dawn");
    const MouseTrial trial(protocol, study, kIntroduction, 7, "dusk");
    EXPECT_EQ(trial.inputs().group, "dusk");
    const Protocol tried = load_protocol(trial.inputs().protocol, models, trial.inputs().study);
    EXPECT_EQ(complaint_about_group(tried, {}, "dusk"), std::nullopt);
  }
}

TEST(MouseTrial, RefusesWhatItCannotShow) {
  const TemporaryFolder folder{};
  const std::filesystem::path study = folder / "study";
  make_small_study(study);
  const ModelRegistry models = built_in_models();
  const Protocol protocol = read_small_protocol(models, small_protocol());
  EXPECT_NO_THROW(MouseTrial(protocol, study, kIntroduction, 7));
  std::filesystem::remove(study / "stimuli" / "grain.png");
  EXPECT_THROW(MouseTrial(protocol, study, kIntroduction, 7), PhrasedError);
}

}  // namespace
}  // namespace asperity
