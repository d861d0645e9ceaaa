// The placeholders of a session: what the participant reads is stored, and is that of the participant's plan.

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/report/text/report_facts.h"
#include "app/report/text/report_sections.h"
#include "app/tasks/run_session.h"
#include "renderers/built_in_models.h"
#include "results_schema/files/atomic_file.h"
#include "tests/app/report_words.h"
#include "tests/app/scripted_session.h"
#include "tests/support/replaced.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

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

class TextAsRead : public testing::Test {
 protected:
  /// A session of three trials, with two surfaces each.
  void run(const std::string& protocol) {
    make_small_study(study_);
    const std::filesystem::path file = study_ / "protocols" / "small.json";
    write_file(file, protocol, Overwrite::refuse);
    SessionRequests requests{};
    const RunInputs inputs{.protocol = file,
                           .study = study_,
                           .participant = "p1",
                           .seed = 5,
                           .mode = SessionMode::pilot,
                           .pacing = RunPacing::stepped};
    const ModelRegistry models = built_in_models();
    ASSERT_EQ(run_session(inputs, models, &person, {}, {}, {.requests = &requests}).state,
              SessionState::completed);
    const Study study = Study::open(study_, Access::read_only);
    ASSERT_EQ(study.plan(study.sessions().front().id).size(), 3U);
    for (const EventRow& event : study.events(study.sessions().front().id)) {
      if (event.kind == "text_as_read") stored.push_back(event.text + event.data_json);
    }
  }

  ReadingPerson person{};
  std::vector<std::string> stored{};

  TemporaryFolder folder_{};
  std::filesystem::path study_ = folder_.path() / "study";
};

TEST_F(TextAsRead, HasTheNumbersOfThePlanAndIsStored) {
  run(replaced(replaced(small_protocol(), "Welcome.",
                        "{trials} {trials|trial|trials}, with {surfaces} surfaces each, {{such}."),
               "I take part of my own free will.", "I take part in {trials} trials."));
  const std::string expected = "Three trials, with two surfaces each, {such}.";
  EXPECT_THAT(person.texts, Contains(expected));
  EXPECT_THAT(person.texts, Contains("I take part in three trials.\n\nDo you agree?"));
  EXPECT_THAT(stored, ElementsAre(R"(I take part in three trials.{"place":"/consent/statement"})",
                                  expected + R"({"place":"/flow/0/screen"})"));
}

TEST_F(TextAsRead, IsThatOfTheGroup) {
  run(replaced(replaced(small_protocol(), R"("factors": {)",
                        R"("groups": {"factor": "training"},
                           "factors": {"training": {"levels": ["haptic", "visual"]}, )"),
               R"({"screen": "Welcome."})",
               R"({"screen": "Look {trials} times.", "groups": ["visual"]},
                  {"screen": "Feel {trials} times.", "groups": ["haptic"]})"));
  EXPECT_THAT(person.texts, Contains("Feel three times."));
  EXPECT_THAT(person.texts, Not(Contains("Look three times.")));
  EXPECT_THAT(stored, ElementsAre(R"(Feel three times.{"place":"/flow/1/screen"})"));

  const std::vector<ReportFacts> facts =
      report_facts(Study::open(study_, Access::read_only), {}, {}, {});
  ASSERT_EQ(facts.size(), 1U);
  EXPECT_THAT(words_of(design_section(facts.front())),
              AllOf(HasSubstr("Text for the group “visual” only: “Look three times.”."),
                    HasSubstr("Text for the group “haptic” only: “Feel three times.”.")));
}

}  // namespace
}  // namespace asperity
