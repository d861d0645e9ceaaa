// What is stated of the anchors of a session at its end.

#include "app/session/anchor_summary.h"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scripted_session.h"
#include "tests/support/replaced.h"

namespace asperity {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class AnchoredSession : public SessionTest {
 protected:
  /// Six estimates in each of two runs of the block, with anchors at these places.
  void begin_anchored(const std::string& places) {
    const std::string anchor = R"("anchor": {"spacing": 0.002},)";
    begin(replaced(estimated_protocol(), anchor, anchor + " \"anchor_at\": [" + places + "],"));
    person_.at_question = [](int, const Trial& trial) {
      if (!trial.anchor) return gives(5.0);
      const double first = trial.block_ordinal == 1 ? 12.0 : 8.0;
      return gives(*trial.anchor == AnchorPlace::start    ? first
                   : *trial.anchor == AnchorPlace::middle ? 10.0
                                                          : 6.0);
    };
  }
  std::vector<std::string> lines_at_end() {
    std::vector<std::string> lines{};
    for (const Phrase& line : run().anchors) lines.push_back(line.english());
    return lines;
  }
};

TEST_F(AnchoredSession, StatesTheAnchorsOfEveryRunInOrder) {
  begin_anchored(R"("start", "middle", "end")");
  EXPECT_THAT(
      lines_at_end(),
      ElementsAre("Anchors of block 1 (main), question roughness: 12 → 10 → 6; last/first: 0.50.",
                  "Anchors of block 2 (main), question roughness: 8 → 10 → 6; last/first: 0.75."));
  std::vector<int> anchors{};
  for (const AttemptRow& row : attempts()) {
    if (row.presentations.at(0).role == "anchor") anchors.push_back(row.trial);
  }
  EXPECT_THAT(anchors, ElementsAre(1, 5, 9, 10, 14, 18));
}

TEST_F(AnchoredSession, StatesNothingOfASingleAnchor) {
  begin_anchored(R"("start")");
  EXPECT_THAT(lines_at_end(), IsEmpty());
}

/// A plan of two anchors with one question of this form, and valid attempts with these responses.
struct MadeUpAnchors {
  Plan plan{};
  std::vector<AttemptRow> attempts{};

  MadeUpAnchors(const AnswerForm& form, const std::vector<ResponseRow>& responses) {
    for (const ResponseRow& response : responses) {
      Trial trial{};
      trial.ordinal = static_cast<int>(plan.trials.size()) + 1;
      trial.block = "main";
      trial.block_ordinal = 1;
      trial.anchor = trial.ordinal == 1 ? AnchorPlace::start : AnchorPlace::end;
      Question question{.name = "which", .form = form};
      if (has_options(form)) {
        question.options = {{"metal", "1", std::nullopt, ""}, {"stone", "2", std::nullopt, ""}};
      }
      trial.questions = {question};
      plan.trials.push_back(trial);
      AttemptRow& attempt = attempts.emplace_back();
      attempt.trial = trial.ordinal;
      attempt.attempt = 1;
      attempt.valid = true;
      attempt.responses = {response};
      attempt.responses.front().question = "which";
    }
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> lines{};
    for (const Phrase& line : anchor_summary(plan, attempts)) lines.push_back(line.english());
    return lines;
  }
};

ResponseRow chosen_response(const std::string& answer, std::optional<bool> correct = {}) {
  ResponseRow response{};
  response.answer = answer;
  response.correct = correct;
  return response;
}

TEST(AnchorSummary, StatesADifferenceOfRatings) {
  ResponseRow first = chosen_response("70.1");
  first.answer_number = 70.1;
  ResponseRow last = chosen_response("40");
  last.answer_number = 40.0;
  EXPECT_THAT(MadeUpAnchors(ScaleForm{}, {first, last}).lines(),
              ElementsAre("Anchors of block 1 (main), question which: 70.1 → 40; "
                          "last − first: -30.1."));
}

// The window may not name stimuli to an experimenter who must not know them.
TEST(AnchorSummary, NamesNoStimulus) {
  EXPECT_THAT(
      MadeUpAnchors(ChoiceForm{}, {chosen_response("metal"), chosen_response("stone")}).lines(),
      ElementsAre("Anchors of block 1 (main), question which: 1 → 2."));
  EXPECT_THAT(
      MadeUpAnchors(ChoiceForm{}, {chosen_response("metal", true), chosen_response("stone", false)})
          .lines(),
      ElementsAre("Anchors of block 1 (main), question which: correct → incorrect."));
}

TEST(AnchorSummary, LeavesOutInvalidAttempts) {
  MadeUpAnchors made(ChoiceForm{}, {chosen_response("metal"), chosen_response("stone")});
  made.attempts.back().valid = false;
  EXPECT_THAT(made.lines(), IsEmpty());
}

}  // namespace
}  // namespace asperity
