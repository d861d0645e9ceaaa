// Additional questions of a trial in a session: what is stored, analysed and published.

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/exports/export_study.h"
#include "app/findings/gathering/gathered_answers.h"
#include "app/session/respondents/virtual_participant.h"
#include "app/tasks/verify/verify_study.h"
#include "results_schema/files/file_system.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string protocol_with_additional_questions() {
  nlohmann::json protocol = nlohmann::json::parse(small_protocol());
  protocol["factors"]["go"]["levels"] = {1, 2};
  nlohmann::json& block = protocol["blocks"]["main"];
  block["questions"] = nlohmann::json::parse(R"([
    {"name": "words", "prompt": "Describe it.", "form": "text"},
    {"name": "best", "prompt": "Which felt more like the picture?"},
    {"name": "felt", "prompt": "What did you feel?", "form": "multiple_choice",
     "options": [{"value": "ridges", "text": "ridges"}, {"value": "grains", "text": "grains"},
                 {"value": "nothing", "text": "nothing"}]},
    {"name": "count", "prompt": "How many ridges?", "form": "number", "minimum": 0, "maximum": 9}])");
  block.erase("question");
  protocol["flow"] = nlohmann::json::parse(R"([{"run": "main"}])");
  return protocol.dump();
}

class AdditionalQuestions : public SessionTest {
 protected:
  void SetUp() override {
    begin(protocol_with_additional_questions());
    person_.at_question = [](int, const Trial& trial) -> Reply {
      const std::string& name = trial.questions.front().name;
      if (name == "words") return {only_answer(WrittenText{"like sand paper"})};
      if (name == "felt") return {only_answer(ChosenOptions{{0, 1}})};
      if (name == "count") return {only_answer(GivenNumber{4.0})};
      return chooses(0);
    };
  }
  std::vector<std::string> stored_in_first_trial() const {
    std::vector<std::string> rows{};
    const AttemptRow first = attempts().front();
    for (const ResponseRow& row : first.responses) {
      rows.push_back(row.question + ' ' + std::to_string(row.item) + ' ' + row.answer);
    }
    return rows;
  }
  std::string exported(ExportAudience audience, const char* file) {
    const auto folder = folder_.path() / ("export_" + std::to_string(++exports_));
    export_study(*study_, models_, folder, {.audience = audience});
    return read_file(folder / file);
  }

  int exports_ = 0;
};

TEST_F(AdditionalQuestions, AreStoredAndVerified) {
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(stored_in_first_trial(), ElementsAre("words 1 like sand paper", "best 1 height_map",
                                                   "felt 1 ridges", "felt 2 grains", "count 1 4"));
  EXPECT_THAT(verify_study(*study_, models_, false, {}, [](double) {}).problems, IsEmpty());
}

TEST_F(AdditionalQuestions, AreAnsweredByVirtualParticipants) {
  VirtualParticipant participant(protocol_, {}, {}, Random(5));
  Conductor conductor(*study_, protocol_, *builder_, *rig_, participant, {});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  EXPECT_THAT(verify_study(*study_, models_, false, {}, [](double) {}).problems, IsEmpty());
}

TEST_F(AdditionalQuestions, KeepTheirTextsOutOfPublicExportsAndTables) {
  run();
  EXPECT_THAT(exported(ExportAudience::own, "responses.tsv"), HasSubstr("like sand paper"));
  const std::string wide = exported(ExportAudience::own, "wide.csv");
  EXPECT_THAT(wide, Not(HasSubstr("sand paper")));
  EXPECT_THAT(wide, HasSubstr("felt"));
  const std::string published = exported(ExportAudience::published, "responses.tsv");
  EXPECT_THAT(published, Not(HasSubstr("sand paper")));
  EXPECT_THAT(published, HasSubstr("ridges"));
}

TEST_F(AdditionalQuestions, AreLeftOutOfTheAnalysis) {
  run();
  std::map<std::string, int> answers{};
  for (const GatheredAnswers& gathered : gather_answers(*study_, {}, std::stop_token{})) {
    for (const GatheredAnswer& answer : gathered.answers) {
      ++answers[gathered.word(answer.question)];
    }
  }
  EXPECT_EQ(answers, (std::map<std::string, int>{{"best", 2}}));
}

}  // namespace
}  // namespace asperity
