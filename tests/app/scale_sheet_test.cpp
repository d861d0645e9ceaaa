// Marks on scales: where they begin, what moves them, and when they are an answer.

#include "app/session/respondents/sheets/scale_sheet.h"

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/respondents/dialogues/answer_dialogue.h"

namespace asperity {
namespace {

using ::testing::HasSubstr;
using Kind = ParticipantInput::Kind;

Question scale(const std::string& name, const ScaleForm& form) {
  Question question{};
  question.name = name;
  question.prompt = "How " + name + "?";
  question.form = form;
  return question;
}

const ScaleForm kSevenPoints{
    .minimum = -3.0, .maximum = 3.0, .points = 7, .labels = {"low", "high"}};
const ScaleForm kLine{};

/// A page of scales about one surface that may be felt again.
class ScalePage : public testing::Test {
 protected:
  explicit ScalePage(std::vector<Question> questions = {scale("rough", kSevenPoints),
                                                        scale("hard", kSevenPoints),
                                                        scale("pleasant", kLine)}) {
    trial_.questions = std::move(questions);
    trial_.on_one_page = true;
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
    input.time_ns = ++now_ns_;
    return sheet_->take(input);
  }
  /// What the participant sees.
  ParticipantScene scene() {
    ParticipantScene scene = scene_of_question(trial_, trial_.questions, {1});
    sheet_->mark(scene);
    return scene;
  }
  static std::vector<int> steps_in(const SheetResult& result) {
    std::vector<int> steps{};
    for (const GivenAnswer& given : std::get<GivenAnswers>(result)) {
      steps.push_back(std::get<ScalePoint>(given.answer).step);
    }
    return steps;
  }

  Trial trial_{};
  std::unique_ptr<AnswerSheet> sheet_{};
  std::int64_t now_ns_ = 0;
};

TEST_F(ScalePage, ShowsNoMarkBeforeTheFirstTouch) {
  const ParticipantScene shown = scene();
  ASSERT_EQ(shown.scales.size(), 3U);
  for (const ParticipantScene::Scale& scale : shown.scales) EXPECT_FALSE(scale.step);
  EXPECT_TRUE(shown.scales.front().current);
  EXPECT_FALSE(shown.can_confirm);
  const SheetResult refused = take(Kind::confirm);
  ASSERT_TRUE(std::holds_alternative<SheetRefused>(refused));
  EXPECT_EQ(text_of(std::get<SheetRefused>(refused).message),
            "Please mark a point on every scale first.");
}

TEST_F(ScalePage, TakesAMarkWhereThePointerPresses) {
  take(Kind::mark, 1, 0.0);
  take(Kind::mark, 2, 0.49);  // nearest to the middle point
  take(Kind::mark, 3, 0.4126);
  EXPECT_TRUE(scene().can_confirm);
  const SheetResult answered = take(Kind::confirm);
  EXPECT_EQ(steps_in(answered), (std::vector<int>{0, 3, 413}));
  const auto& answers = std::get<GivenAnswers>(answered);
  EXPECT_EQ(answers[0].given_ns, 1);
  EXPECT_EQ(answers[2].given_ns, 3);
  EXPECT_EQ(items_of(trial_.questions[1], answers[1].answer).front().answer, "0");
  EXPECT_EQ(items_of(trial_.questions[2], answers[2].answer).front().answer, "41.3");
}

TEST_F(ScalePage, DoesNotCountWhereAKeyBegins) {
  take(Kind::step, 1);
  EXPECT_EQ(scene().scales[0].step, 3);
  EXPECT_FALSE(scene().scales[0].counts);
  take(Kind::mark, 2, 1.0);
  take(Kind::mark, 3, 1.0);
  EXPECT_FALSE(scene().can_confirm);
  EXPECT_TRUE(std::holds_alternative<SheetRefused>(take(Kind::confirm)));
  EXPECT_TRUE(scene().scales[0].current) << "the refusal leads to the scale that is open";
  take(Kind::step, 1);
  take(Kind::step, -1);
  EXPECT_TRUE(scene().scales[0].counts) << "it was left and chosen again";
  EXPECT_EQ(steps_in(take(Kind::confirm)), (std::vector<int>{3, 6, 1000}));
}

TEST_F(ScalePage, StaysWithinItsEnds) {
  take(Kind::mark, 1, 1.0);
  take(Kind::step, 1);
  EXPECT_EQ(scene().scales[0].step, 6);
  take(Kind::mark, 1, 0.0);
  take(Kind::step, -1);
  EXPECT_EQ(scene().scales[0].step, 0);
}

TEST_F(ScalePage, MovesAMarkOnALineByHundredths) {
  take(Kind::mark, 3, 0.5);
  take(Kind::step, 1);
  EXPECT_EQ(scene().scales[2].step, 510);
  take(Kind::step, -2);
  EXPECT_EQ(scene().scales[2].step, 490);
}

TEST_F(ScalePage, GoesFromScaleToScaleByDigits) {
  take(Kind::option, 7);
  EXPECT_EQ(scene().scales[0].step, 6);
  EXPECT_TRUE(scene().scales[1].current);
  EXPECT_TRUE(std::holds_alternative<SheetUnchanged>(take(Kind::option, 8)));
  take(Kind::option, 1);
  EXPECT_TRUE(scene().scales[2].current);
  EXPECT_TRUE(std::holds_alternative<SheetUnchanged>(take(Kind::option, 5)))
      << "a line has no points";
}

TEST_F(ScalePage, IsAnsweredWithOneButtonOfTheDevice) {
  const auto press = [this](double held_s) {
    ParticipantInput input{};
    input.kind = Kind::device_button;
    input.number = 1;
    input.held_s = held_s;
    input.time_ns = ++now_ns_;
    return sheet_->take(input);
  };
  press(0.1);
  press(0.1);  // the second point
  EXPECT_TRUE(std::get<SheetChanged>(press(1.0)).needs_new_reading);
  press(0.1);
  press(1.0);
  press(0.1);
  press(0.1);  // a tenth of the line
  EXPECT_EQ(steps_in(press(1.0)), (std::vector<int>{1, 0, 100}));
}

TEST_F(ScalePage, LetsTheSurfaceBeFeltAgain) {
  EXPECT_TRUE(std::holds_alternative<WishToFeelAgain>(take(Kind::next)));
  EXPECT_TRUE(std::holds_alternative<WishToFeelAgain>(take(Kind::surface, 1)));
}

TEST(Scale, StoresItsPointsAndNothingBetween) {
  const Question question = scale("rough", kSevenPoints);
  EXPECT_TRUE(
      problems_with(question, std::vector<AnsweredItem>{{.answer = "-3", .number = -3.0}}).empty());
  EXPECT_TRUE(
      problems_with(question, std::vector<AnsweredItem>{{.answer = "0", .number = 0.0}}).empty());
  EXPECT_FALSE(
      problems_with(question, std::vector<AnsweredItem>{{.answer = "0.5", .number = 0.5}}).empty());
  EXPECT_FALSE(
      problems_with(question, std::vector<AnsweredItem>{{.answer = "4", .number = 4.0}}).empty());
  EXPECT_FALSE(
      problems_with(question, std::vector<AnsweredItem>{{.answer = "1", .number = 2.0}}).empty());
  EXPECT_THROW(items_of(question, Answer(ScalePoint{7})), std::out_of_range);
  const ScaleForm likert{
      .minimum = 1, .maximum = 3, .points = 3, .labels = {"no", "partly", "yes"}};
  EXPECT_EQ(label_of(scale("agree", likert), "2"), "2 (partly)");
}

TEST(Scale, EndsAtItsMaximumWhateverRoundingDoes) {
  for (const double maximum : {0.4, 0.8, 1.0}) {
    const ScaleForm form{.minimum = maximum == 1.0 ? 0.2 : 0.0, .maximum = maximum, .points = 7};
    const Question question = scale("rough", form);
    const AnsweredItem item = items_of(question, Answer(ScalePoint{6})).front();
    EXPECT_EQ(item.number, maximum);
    EXPECT_TRUE(problems_with(question, std::vector{item}).empty());
  }
}

TEST(Scale, IsTypedAtATerminalAsItsNumber) {
  const auto step_in = [](AnswerDialogue& dialogue, const std::string& typed) {
    return std::get<ScalePoint>(std::get<std::optional<Answer>>(dialogue.take(typed)).value()).step;
  };
  const Question of_points = scale("rough", kSevenPoints);
  AnswerDialogue points(of_points);
  EXPECT_EQ(points.introduction(), "  -3  low\n  …\n  3  high\n");
  EXPECT_EQ(step_in(points, "2"), 5);
  EXPECT_EQ(std::get<NextLine>(points.take("2.5")).complaint,
            "Please enter a number from -3 to 3, in steps of 1.");
  const Question of_line = scale("rough", kLine);
  AnswerDialogue line(of_line);
  EXPECT_EQ(step_in(line, "41,26"), 413);
  EXPECT_EQ(std::get<NextLine>(line.take("101")).complaint, "Please enter a number from 0 to 100.");
}

}  // namespace
}  // namespace asperity
