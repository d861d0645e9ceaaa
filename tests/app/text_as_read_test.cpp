// The placeholders of a session: what the participant reads is stored, and is that of the participant's plan.

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/tasks/run_session.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/scripted_session.h"
#include "tests/support/replaced.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::Contains;
using testing::ElementsAre;

/// Keeps what is read.
class ReadingPerson final : public ScriptedPerson {
 public:
  void read(const std::string& text, double minimum_s, const Wait& wait) override {
    texts.push_back(text);
    ScriptedPerson::read(text, minimum_s, wait);
  }
  std::optional<Answer> answer(const Question& question, const Wait& wait) override {
    texts.push_back(question.prompt);
    return ScriptedPerson::answer(question, wait);
  }
  std::vector<std::string> texts{};
};

TEST(TextAsRead, HasTheNumbersOfThePlanAndIsStored) {
  const TemporaryFolder folder{};
  const std::filesystem::path study_folder = folder.path() / "study";
  make_small_study(study_folder);
  const std::filesystem::path file = study_folder / "protocols" / "small.json";
  write_file(file,
             replaced(replaced(small_protocol(), "Welcome.",
                               "{trials} {trials|trial|trials}, with {surfaces} surfaces each, "
                               "{{such}."),
                      "I take part of my own free will.", "I take part in {trials} trials."),
             Overwrite::refuse);
  SessionRequests requests{};
  ReadingPerson person{};
  const RunInputs inputs{.protocol = file,
                         .study = study_folder,
                         .participant = "p1",
                         .seed = 5,
                         .mode = SessionMode::pilot,
                         .pacing = RunPacing::stepped};
  const ModelRegistry models = built_in_models();
  ASSERT_EQ(run_session(inputs, models, &person, {}, {}, {.requests = &requests}).state,
            SessionState::completed);
  const Study study = Study::open(study_folder, Access::read_only);
  const std::size_t trials = study.plan(study.sessions().front().id).size();
  ASSERT_EQ(trials, 3U);
  const std::string expected = "Three trials, with two surfaces each, {such}.";
  EXPECT_THAT(person.texts, Contains(expected));
  EXPECT_THAT(person.texts, Contains("I take part in three trials.\n\nDo you agree?"));
  std::vector<std::string> stored{};
  for (const EventRow& event : study.events(study.sessions().front().id)) {
    if (event.kind != "text_as_read") continue;
    stored.push_back(event.text + event.data_json);
  }
  EXPECT_THAT(stored, ElementsAre(R"(I take part in three trials.{"place":"/consent/statement"})",
                                  expected + R"({"place":"/flow/0/screen"})"));
}

}  // namespace
}  // namespace asperity
