// Conditions of the questions of a trial in a session: what is asked, stored, resumed and verified.

#include <map>
#include <stop_token>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/findings/gathering/gathered_answers.h"
#include "app/session/respondents/virtual_participant.h"
#include "app/tasks/verify/verify_questionnaire.h"
#include "app/tasks/verify/verify_study.h"
#include "tests/app/scripted_session.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A selection, how sure the participant is, and where that is little what was hard.
std::string conditional_protocol() {
  nlohmann::json protocol = nlohmann::json::parse(small_protocol());
  protocol["factors"]["go"]["levels"] = {1, 2};
  nlohmann::json& block = protocol["blocks"]["main"];
  block["questions"] = nlohmann::json::parse(R"([
    {"name": "best", "prompt": "Which felt more like the picture?"},
    {"name": "sure", "prompt": "How sure are you?", "scale": {"minimum": 1, "maximum": 5, "points": 5}},
    {"name": "hard", "prompt": "How hard was it?", "scale": {"minimum": 1, "maximum": 3, "points": 3},
     "if": {"question": "sure", "at_most": 2}}])");
  block.erase("question");
  protocol["flow"] = nlohmann::json::parse(R"([{"run": "main"}])");
  return protocol.dump();
}

class ConditionsOfTrials : public SessionTest {
 protected:
  Reply reply_to(const Trial& trial) {
    const Question& question = trial.questions.front();
    asked_.push_back(std::to_string(trial.ordinal) + ' ' + question.name);
    if (question.name == "best") return chooses(0);
    if (question.name == "hard") return {only_answer(ScalePoint{1})};
    return {only_answer(ScalePoint{trial.ordinal == sure_trial_ ? 4 : 0})};
  }
  void begin_conditional() {
    begin(conditional_protocol());
    person_.at_question = [this](int, const Trial& trial) { return reply_to(trial); };
  }
  /// "2 hard 1 2 keyboard", of valid attempts.
  std::vector<std::string> stored() const {
    std::vector<std::string> rows{};
    for (const AttemptRow& attempt : attempts()) {
      for (const ResponseRow& row : attempt.responses) {
        rows.push_back(std::to_string(attempt.trial) + ' ' + row.question + ' ' +
                       std::to_string(row.item) + ' ' + row.answer + ' ' + row.source);
      }
    }
    return rows;
  }
  std::vector<std::string> problems() {
    return verify_study(*study_, models_, false, {}, [](double) {}).problems;
  }

  int sure_trial_ = 1;  ///< the other trial is a guess
  std::vector<std::string> asked_{};
};

TEST_F(ConditionsOfTrials, DecideWhatIsAskedAndHowItIsStored) {
  begin_conditional();
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(asked_, ElementsAre("1 best", "1 sure", "2 best", "2 sure", "2 hard"));
  EXPECT_THAT(stored(), ElementsAre("1 best 1 height_map keyboard", "1 sure 1 5 keyboard",
                                    "1 hard 1  not_asked", "2 best 1 height_map keyboard",
                                    "2 sure 1 1 keyboard", "2 hard 1 2 keyboard"));
  for (const AttemptRow& attempt : attempts()) {
    EXPECT_EQ(attempt.outcome, AttemptOutcome::answered);
    EXPECT_TRUE(attempt.valid);
    EXPECT_EQ(attempt.responses[2].from_cue_s.has_value(), attempt.trial == 2);
  }
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(ConditionsOfTrials, HoldAfterAnInterruption) {
  begin_conditional();
  EXPECT_EQ(conduct({.record = false}, 1).state, SessionState::stopped);
  reopen_session();
  EXPECT_EQ(run().state, SessionState::completed);
  EXPECT_THAT(asked_, ElementsAre("1 best", "1 sure", "2 best", "2 sure", "2 hard"));
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(ConditionsOfTrials, AreMetByTheAnswersOfAVirtualParticipant) {
  begin(conditional_protocol());
  VirtualParticipant participant(protocol_, {}, {}, Random(5));
  Conductor conductor(*study_, protocol_, *builder_, *rig_, participant, {});
  EXPECT_EQ(conductor.run(session_).state, SessionState::completed);
  EXPECT_EQ(stored().size(), 6U);
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(ConditionsOfTrials, LeaveWhatWasNotAskedOutOfTheAnalysis) {
  begin_conditional();
  run();
  std::map<std::string, int> answers{};
  for (const GatheredAnswers& gathered : gather_answers(*study_, {}, std::stop_token{})) {
    for (const GatheredAnswer& answer : gathered.answers) {
      ++answers[gathered.word(answer.question)];
      EXPECT_EQ(gathered.replies_of(answer).size(), 1U);
    }
  }
  EXPECT_EQ(answers, (std::map<std::string, int>{{"best", 2}, {"hard", 1}, {"sure", 2}}));
}

TEST(AnswerProblems, AreFoundInWhatWasAskedAndInWhatWasNot) {
  const Question question{
      .name = "hard",
      .form = ScaleForm{.minimum = 1, .maximum = 3, .points = 3},
      .condition = AnswerCondition{.question = "sure", .test = AnswerWithin{.maximum = 2.0}}};
  const std::vector<AnsweredItem> answered{{.answer = "2", .number = 2.0}};
  const std::vector<AnsweredItem> empty{{.answer = ""}};
  EXPECT_THAT(answer_problems(question, answered, true, true), IsEmpty());
  EXPECT_THAT(answer_problems(question, empty, false, false), IsEmpty());
  EXPECT_THAT(
      answer_problems(question, answered, true, false),
      ElementsAre("it was asked, but the condition that the answer to \"sure\" was 2 or less "
                  "is not met"));
  EXPECT_THAT(answer_problems(question, empty, false, true),
              ElementsAre("it was not asked, but the answer to \"sure\" was 2 or less"));
  EXPECT_THAT(answer_problems(question, answered, false, false),
              ElementsAre("it was not asked, and an answer is stored"));
  EXPECT_THAT(answer_problems(question, empty, true, true), ElementsAre(HasSubstr("left empty")));
}

}  // namespace
}  // namespace asperity
