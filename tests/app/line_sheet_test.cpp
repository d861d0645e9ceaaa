// A line as an answer: where it begins, what moves its end, and when it is an answer.

#include "app/session/respondents/sheets/line_sheet.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/respondents/dialogues/answer_dialogue.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using Kind = ParticipantInput::Kind;

class DrawnLineSheet : public testing::Test {
 protected:
  DrawnLineSheet() {
    Question question{};
    question.name = "size";
    question.prompt = "How strong?";
    question.form = LineForm{};
    trial_.questions = {question};
    trial_.presentations.resize(1);
    trial_.presentations.front().position = 1;
    trial_.presentations.front().code = "A";
    sheet_ = sheet_for(trial_, trial_.questions);
  }
  SheetResult take(Kind kind, int number = 0, double position = 0.0) {
    ParticipantInput input{};
    input.kind = kind;
    input.number = number;
    input.position = position;
    return sheet_->take(input);
  }
  std::optional<int> step() {
    ParticipantScene scene = scene_of_question(trial_, trial_.questions, {1});
    sheet_->mark(scene);
    return scene.line_step;
  }
  bool can_confirm() {
    ParticipantScene scene = scene_of_question(trial_, trial_.questions, {1});
    sheet_->mark(scene);
    return scene.can_confirm;
  }
  static int drawn(const SheetResult& result) {
    return std::get<DrawnLength>(std::get<GivenAnswers>(result).front().answer).step;
  }

  Trial trial_{};
  std::unique_ptr<AnswerSheet> sheet_{};
};

TEST_F(DrawnLineSheet, HasNoLineBeforeItIsDrawn) {
  EXPECT_EQ(step(), std::nullopt);
  EXPECT_FALSE(can_confirm());
  const SheetResult refused = take(Kind::confirm);
  EXPECT_EQ(std::get<SheetRefused>(refused).message.what, ParticipantMessage::What::line_needed);
}

TEST_F(DrawnLineSheet, EndsWhereItIsPressed) {
  take(Kind::mark, 1, 0.3);
  EXPECT_EQ(step(), 300);
  EXPECT_EQ(drawn(take(Kind::confirm)), 300);
}

TEST_F(DrawnLineSheet, IsExtendedAndShortenedByKeys) {
  take(Kind::step, 1);
  EXPECT_EQ(step(), 10);
  take(Kind::step, 5);
  EXPECT_EQ(step(), 60);
  take(Kind::step, -1);
  EXPECT_EQ(step(), 50);
  take(Kind::step, -100);
  EXPECT_EQ(step(), 1);  // never without length
  take(Kind::step, 1000);
  EXPECT_EQ(drawn(take(Kind::confirm)), LineForm::kSteps);
}

TEST_F(DrawnLineSheet, IsExtendedByTheButtonOfTheDevice) {
  take(Kind::device_button, 1);
  EXPECT_EQ(step(), 50);
  for (int i = 0; i < 19; ++i) take(Kind::device_button, 1);
  EXPECT_EQ(step(), 1000);
  EXPECT_TRUE(std::holds_alternative<PointedAtFeelingAgain>(take(Kind::device_button, 1)));
  take(Kind::device_button, 1);  // begins again
  EXPECT_EQ(step(), 50);
  EXPECT_EQ(drawn(take(Kind::device_button, 2)), 50);
}

TEST(AnswerDialogue, CountsTheSignsOfATypedLine) {
  const Question question{.form = LineForm{}};
  AnswerDialogue dialogue(question);
  EXPECT_EQ(
      std::get<DrawnLength>(std::get<std::optional<Answer>>(dialogue.take("-----")).value()).step,
      100);
  EXPECT_THAT(std::get<NextLine>(dialogue.take("5")).complaint, HasSubstr("signs \"-\""));
  EXPECT_THAT(std::get<NextLine>(dialogue.take(std::string(51, '-'))).complaint,
              HasSubstr("1 to 50"));
}

}  // namespace
}  // namespace asperity
