// What the attempts of a session make of its trials.

#include "app/session/trial_tally.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

/// Two trials in a practice to two right answers in a row of three trials at most, one in the block
/// after it.
struct Practised {
  Practised() {
    protocol.blocks["practice"].until =
        Protocol::Criterion{.correct = 2, .of_last = 2, .maximum_trials = 3};
    protocol.blocks["main"];
    for (int ordinal = 1; ordinal <= 4; ++ordinal) {
      Trial trial{};
      trial.ordinal = ordinal;
      trial.block = ordinal < 4 ? "practice" : "main";
      trial.block_ordinal = ordinal < 4 ? 1 : 2;
      plan.trials.push_back(trial);
    }
  }
  static AttemptRow attempt(int trial, int number, AttemptOutcome outcome, bool right = true) {
    AttemptRow row{};
    row.trial = trial;
    row.attempt = number;
    row.outcome = outcome;
    row.valid = outcome == AttemptOutcome::answered;
    ResponseRow response{};
    response.correct = right;
    if (row.valid) row.responses.push_back(response);
    return row;
  }
  Protocol protocol{};
  Plan plan{};
  TrialTally tally{protocol, plan};
};

TEST(TrialTally, ATrialIsDoneWhenItWasAnsweredOrSkipped) {
  Practised session{};
  const auto& trials = session.plan.trials;
  session.tally.add(Practised::attempt(1, 1, AttemptOutcome::aborted));
  EXPECT_FALSE(session.tally.is_done(trials[0]));
  EXPECT_EQ(session.tally.last_done(), nullptr);
  session.tally.add(Practised::attempt(1, 2, AttemptOutcome::answered));
  session.tally.add(Practised::attempt(2, 1, AttemptOutcome::skipped));
  EXPECT_TRUE(session.tally.is_done(trials[0]));
  EXPECT_TRUE(session.tally.is_done(trials[1]));
  EXPECT_FALSE(session.tally.is_done(trials[2]));
  EXPECT_EQ(session.tally.attempts_at(1), 2);
  ASSERT_NE(session.tally.last_done(), nullptr);
  EXPECT_EQ(session.tally.last_done()->trial, 2);
}

TEST(TrialTally, ATrialIsOpenAgainOnceItWasSetAside) {
  Practised session{};
  session.tally.add(Practised::attempt(1, 1, AttemptOutcome::answered));
  session.tally.add(Practised::attempt(2, 1, AttemptOutcome::skipped));
  session.tally.set_aside(2, 1, "the sample lay there after all");
  EXPECT_FALSE(session.tally.is_done(session.plan.trials[1]));
  EXPECT_EQ(session.tally.attempts().back().invalid_reason.value().text,
            "repeated by the experimenter: the sample lay there after all");
  EXPECT_EQ(session.tally.last_done()->trial, 1);
  session.tally.set_aside(1, 1, "a cough");
  EXPECT_FALSE(session.tally.is_done(session.plan.trials[0]));
  EXPECT_EQ(session.tally.last_done(), nullptr);
}

TEST(TrialTally, APracticeIsOverWhenItsCriterionIsMetByAnswersThatCount) {
  Practised session{};
  const auto& trials = session.plan.trials;
  session.tally.add(Practised::attempt(1, 1, AttemptOutcome::answered));
  session.tally.add(Practised::attempt(4, 1, AttemptOutcome::answered));  // of another block
  EXPECT_FALSE(session.tally.is_over(trials[2]));
  session.tally.add(Practised::attempt(2, 1, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.criterion_of(trials[2]), BlockState::criterion_met);
  EXPECT_FALSE(session.tally.is_over(trials[3])) << "its block has no criterion";
  session.tally.set_aside(2, 1, "a cough");
  EXPECT_FALSE(session.tally.is_over(trials[2]));
}

using Again = TrialTally::Again;

/// As the walk over a plan sees it: a break after the first trial, another between the blocks.
struct Walked : Practised {
  Walked() {
    protocol.blocks["practice"].until.reset();
    plan.steps = {TrialStep{0}, Protocol::Break{}, TrialStep{1},
                  TrialStep{2}, Protocol::Break{}, TrialStep{3}};
  }
};

TEST(TrialTally, AfterATrialComesTheNextOneThatIsOpen) {
  Walked session{};
  EXPECT_EQ(session.tally.coming(0, 0, 0, Again::at_once), 1) << "before the first";
  session.tally.add(Practised::attempt(1, 1, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.coming(0, 1, 1, Again::at_once), 2);
  EXPECT_EQ(session.tally.coming(1, 1, 0, Again::at_once), 2) << "in the break";
  session.tally.add(Practised::attempt(2, 1, AttemptOutcome::skipped));
  session.tally.add(Practised::attempt(3, 1, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.coming(3, 1, 3, Again::at_once), 4) << "of the next block";
  session.tally.add(Practised::attempt(4, 1, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.coming(5, 2, 4, Again::at_once), 0);
}

TEST(TrialTally, ATrialThatFailedComesAgainAtOnceOrAfterTheOthersOfItsBlock) {
  Walked session{};
  session.tally.add(Practised::attempt(1, 1, AttemptOutcome::device_fault));
  EXPECT_EQ(session.tally.coming(0, 1, 1, Again::at_once), 1);
  EXPECT_EQ(session.tally.coming(0, 1, 1, Again::after_others), 2);
  session.tally.add(Practised::attempt(2, 1, AttemptOutcome::not_compliant));
  session.tally.add(Practised::attempt(3, 1, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.coming(3, 1, 3, Again::at_once), 1) << "the rounds at the block's end";
  session.tally.add(Practised::attempt(1, 2, AttemptOutcome::not_compliant));
  EXPECT_EQ(session.tally.coming(4, 1, 1, Again::after_others), 2);
  session.tally.add(Practised::attempt(2, 2, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.coming(4, 1, 2, Again::at_once), 1) << "the next round";
  session.tally.add(Practised::attempt(1, 3, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.coming(4, 1, 1, Again::at_once), 4);
}

TEST(TrialTally, AfterAPracticeThatIsOverComesTheNextBlock) {
  Practised session{};
  session.plan.steps = {TrialStep{0}, TrialStep{1}, TrialStep{2}, TrialStep{3}};
  session.tally.add(Practised::attempt(1, 1, AttemptOutcome::answered));
  session.tally.add(Practised::attempt(2, 1, AttemptOutcome::answered));
  EXPECT_EQ(session.tally.coming(1, 1, 2, Again::at_once), 4);
}

TEST(TrialTally, KnowsWhoExploredWronglyFromWhatFailedByItself) {
  Practised session{};
  AttemptRow wrongly = Practised::attempt(1, 1, AttemptOutcome::not_compliant);
  wrongly.presentations.push_back({.contact_s = 1.0});
  AttemptRow untouched = wrongly;
  untouched.attempt = 2;
  untouched.presentations.front().contact_s = 0.0;
  session.tally.add(wrongly);
  session.tally.add(untouched);
  EXPECT_FALSE(failed_technically(wrongly));
  EXPECT_TRUE(failed_technically(untouched));
  EXPECT_EQ(session.tally.explored_wrongly(1), 1);
}

}  // namespace
}  // namespace asperity
