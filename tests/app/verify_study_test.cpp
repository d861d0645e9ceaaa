// verify by several threads: what it finds depends on none of them.

#include "app/tasks/verify/verify_study.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/findings/gathering/gathered_answers.h"
#include "renderers/built_in_models.h"
#include "tests/app/made_up_study.h"
#include "tests/app/no_more_threads.h"
#include "tests/app/small_study.h"
#include "tests/support/refusal.h"

namespace asperity {
namespace {

constexpr int kPeople = 24;

/// Sessions of which none has the plan that its protocol gives.
void fill_with_unplanned_sessions(MadeUpStudy& made) {
  const std::int64_t protocol = made.add_protocol("small", "selection", small_protocol());
  MadeUpTrial trial{};
  trial.surfaces = {surface_of("height_map", "height_map", "grain")};
  trial.answers = {"height_map"};
  trial.options = {"height_map"};
  for (int i = 0; i < kPeople; ++i) {
    const std::string label = "p" + std::to_string(100 + i);
    made.add_person(label, "F");
    made.add_session(label, protocol, {trial, trial});
  }
}

std::vector<std::string> problems_of(const std::filesystem::path& study, Access access) {
  Study opened = Study::open(study, access);
  return verify_study(opened, built_in_models(), false, {}, [](double) {}).problems;
}

TEST(VerifyStudy, FindsTheSameInTheSameOrderWhateverTheThreads) {
  MadeUpStudy made;
  fill_with_unplanned_sessions(made);
  std::vector<std::string> alone{};
  {
    const NoMoreThreads none;
    alone = problems_of(made.folder(), Access::read_only);
  }
  ASSERT_EQ(alone.size(), static_cast<std::size_t>(kPeople));
  for (int i = 0; i < kPeople; ++i) {
    EXPECT_THAT(alone[static_cast<std::size_t>(i)],
                testing::HasSubstr("participant p" + std::to_string(100 + i) +
                                   ", trial 1: its stored plan"));
  }
  for (int i = 0; i < 5; ++i) EXPECT_EQ(problems_of(made.folder(), Access::read_only), alone);
  EXPECT_EQ(problems_of(made.folder(), Access::read_write), alone);
}

TEST(VerifyStudy, TellsItsCallersThreadHowFarItIs) {
  MadeUpStudy made;
  fill_with_unplanned_sessions(made);
  Study study = Study::open(made.folder(), Access::read_only);
  std::vector<double> told{};
  const auto here = std::this_thread::get_id();
  (void)verify_study(study, built_in_models(), false, {}, [&](double fraction) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    told.push_back(fraction);
  });
  ASSERT_GT(told.size(), 2U);
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.back(), 0.9);
  EXPECT_LE(told.back(), 1.0);
}

TEST(VerifyStudy, ChecksAgainWhereAParticipantWithdrewMeanwhile) {
  MadeUpStudy made;
  fill_with_unplanned_sessions(made);
  const std::filesystem::path closed = made.beside("closed");
  made.study().copy_to(closed);
  const NoMoreThreads none;
  Study study = Study::open(closed, Access::read_only);
  bool is_deleted = false;
  const std::vector<std::string> problems =
      verify_study(study, built_in_models(), false, {}, [&](double) {
        if (std::exchange(is_deleted, true)) return;
        Study::open(closed, Access::read_write)
            .withdraw("p100", {.data = WithdrawnData::deleted, .decided_by = "R. Keeper"});
      }).problems;
  ASSERT_TRUE(is_deleted);
  EXPECT_EQ(problems.size(), static_cast<std::size_t>(kPeople - 1));
  EXPECT_THAT(problems, testing::Each(testing::Not(testing::HasSubstr("p100"))));
}

// A window that is closed meanwhile says so by throwing: that is no fault of the study.
TEST(VerifyStudy, EndsWithWhatItsCallerThrows) {
  MadeUpStudy made;
  fill_with_unplanned_sessions(made);
  const auto run = [&made](int throw_at) {
    Study study = Study::open(made.folder(), Access::read_only);
    int calls = 0;
    (void)verify_study(study, built_in_models(), false, {}, [&](double) {
      if (++calls == throw_at) throw ResultsError("of the caller", "");
    });
    return calls;
  };
  const auto expect_thrown = [&run](int throw_at) {
    EXPECT_EQ(refusal_of<ResultsError>([&] { run(throw_at); }), "of the caller") << throw_at;
  };
  for (int i = 1; i <= 3; ++i) expect_thrown(i);
  const NoMoreThreads none;  // and one thread tells of every session
  const int calls = run(0);
  ASSERT_GT(calls, kPeople);
  for (const int i : {1, 2, 3, calls - kPeople, calls - 1, calls}) expect_thrown(i);
}

// Every other session of an analysis is read by a second thread, where there can be one.
TEST(VerifyStudy, AStudyIsReadWithoutASecondThreadToo) {
  MadeUpStudy made;
  fill_with_unplanned_sessions(made);
  const Study study = Study::open(made.folder(), Access::read_only);
  const auto answers = [&study] {
    const std::vector<GatheredAnswers> gathered = gather_answers(study, {}, {});
    std::string all{};
    for (const GatheredAnswers& group : gathered) {
      for (const GatheredAnswer& answer : group.answers) {
        all += group.people[answer.person].label + ' ' + group.word(group.reply_of(answer).answer) +
               '\n';
      }
    }
    return all;
  };
  const std::string with_two = answers();
  EXPECT_EQ(std::count(with_two.begin(), with_two.end(), '\n'), 2 * kPeople);
  const NoMoreThreads none;
  EXPECT_EQ(answers(), with_two);
  EXPECT_EQ(Study::open(made.folder(), Access::read_only).condition(), StudyCondition::whole);
}

}  // namespace
}  // namespace asperity
