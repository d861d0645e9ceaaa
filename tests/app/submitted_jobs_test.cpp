// What files and queue amount to, what is submitted next, and the commands of Slurm that do it.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cli/output/submission_output.h"
#include "app/cluster/slurm.h"
#include "app/cluster/submission.h"
#include "app/cluster/submission_state.h"
#include "app/cluster/submission_turn.h"
#include "app/cluster/submission_watch.h"
#include "app/cluster/submit_jobs.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Submission four_shards() {
  return new_submission("/home/a/sub", "/home/a/results",
                        {"sweep", "--model", "bump_map", "--out", "diameter.tsv"}, 4);
}

/// As squeue lists them; of a gather job no task.
QueuedJob task(int index, const std::string& state, const std::string& reason = "None",
               const std::string& job = "11") {
  return {
      .name = four_shards().job_name, .job = job, .task = index, .state = state, .reason = reason};
}
QueuedJob gather_job(const std::string& state, const std::string& reason = "None",
                     const std::string& job = "12") {
  return {.name = four_shards().gather_name(), .job = job, .state = state, .reason = reason};
}

SubmissionFiles files_with(const std::vector<bool>& shards) { return {.shards = shards}; }

TEST(QueuedJobs, ReadsTheQueueOfSlurm) {
  const std::vector<QueuedJob> jobs = queued_jobs_in(
      "d-1|4711|3|PENDING|ReqNodeNotAvail, "
      "UnavailableNodes:node2\nd-1-gather|4712|N/A|RUNNING|None\n");
  EXPECT_THAT(jobs, ElementsAre(QueuedJob{"d-1", "4711", 3, "PENDING",
                                          "ReqNodeNotAvail, UnavailableNodes:node2"},
                                QueuedJob{"d-1-gather", "4712", std::nullopt, "RUNNING", "None"}));
  EXPECT_THAT(refusal_of([] { queued_jobs_in("JOBID PARTITION\n"); }),
              HasSubstr("JOBID PARTITION"));
}

// A state that this program does not know is active: a task may be in it, and would be submitted twice.
TEST(QueuedJobs, SubmitsNoTaskTwiceThatMayBeActive) {
  for (const char* const state :
       {"PENDING", "RUNNING", "COMPLETING", "REQUEUE_HOLD", "SUSPENDED", "A_LATER_ONE"}) {
    EXPECT_TRUE(task(1, state).is_active()) << state;
  }
  for (const char* const state :
       {"BOOT_FAIL", "CANCELLED", "COMPLETED", "DEADLINE", "FAILED", "NODE_FAIL", "OUT_OF_MEMORY",
        "PREEMPTED", "REVOKED", "TIMEOUT"}) {
    EXPECT_FALSE(task(1, state).is_active()) << state;
  }
}

TEST(SubmissionState, IsThatOfFilesAndQueue) {
  const SubmissionState state =
      state_of(four_shards(),
               {task(1, "COMPLETED"), task(2, "RUNNING"), task(3, "PENDING", "Resources"),
                gather_job("PENDING", "Dependency")},
               files_with({true, false, false, false}));
  EXPECT_THAT(state.indices_of(ShardState::complete), ElementsAre(1));
  EXPECT_THAT(state.indices_of(ShardState::queued), ElementsAre(2, 3));
  EXPECT_THAT(state.indices_of(ShardState::missing), ElementsAre(4));
  EXPECT_EQ(state.gathers.size(), 1U);
  EXPECT_FALSE(state.is_complete);
  EXPECT_FALSE(state.is_untouched());
}

TEST(SubmissionState, CountsAShardAsCompleteWhateverItsTask) {
  const SubmissionState state =
      state_of(four_shards(), {task(1, "NODE_FAIL"), task(2, "PENDING", "BeginTime")},
               files_with({true, true, true, true}));
  EXPECT_THAT(state.indices_of(ShardState::complete), ElementsAre(1, 2, 3, 4));
}

TEST(SubmissionState, TakesTheActiveTaskOfAShardThatWasSubmittedAgain) {
  const SubmissionState state =
      state_of(four_shards(),
               {task(1, "RUNNING", "None", "9"), task(1, "FAILED", "NonZeroExitCode", "13"),
                task(2, "FAILED", "NonZeroExitCode", "9"), task(2, "TIMEOUT", "TimeLimit", "13")},
               files_with({false, false, true, true}));
  EXPECT_EQ(state.shards[0].job->job, "9");
  EXPECT_EQ(state.shards[0].state, ShardState::queued);
  EXPECT_EQ(state.shards[1].job->job, "13");
  EXPECT_EQ(state.shards[1].state, ShardState::missing);
}

TEST(SubmissionState, NeedsNothingWhileTheQueueHasAllThatIsMissing) {
  const Submission submission = four_shards();
  const auto next = [&](const std::vector<QueuedJob>& jobs, const SubmissionFiles& files) {
    return next_jobs(state_of(submission, jobs, files));
  };
  EXPECT_TRUE(next({task(4, "RUNNING"), gather_job("PENDING", "Dependency")},
                   files_with({true, true, true, false}))
                  .is_empty());
  EXPECT_TRUE(next({gather_job("RUNNING")}, files_with({true, true, true, true})).is_empty());
  EXPECT_TRUE(next({}, {.shards = {false, false, false, false}, .result = true}).is_empty());
}

TEST(SubmissionState, SubmitsAllAtFirst) {
  const SubmissionState state =
      state_of(four_shards(), {}, files_with({false, false, false, false}));
  EXPECT_TRUE(state.is_untouched());
  const NextJobs next = next_jobs(state);
  EXPECT_EQ(ranges_of(next.tasks), "1-4");
  EXPECT_THAT(waiting_options(next, "11"),
              ElementsAre("--dependency=afterok:11", "--kill-on-invalid-dep=yes"));
}

// A gather job that depends on the array of a failed task will never run; the new one waits for the older tasks too.
TEST(SubmissionState, SubmitsMissingShardsWithANewGatherJob) {
  const NextJobs next = next_jobs(
      state_of(four_shards(),
               {task(2, "RUNNING"), task(3, "OUT_OF_MEMORY"), gather_job("PENDING", "Dependency")},
               files_with({true, false, false, false})));
  EXPECT_THAT(next.tasks, ElementsAre(3, 4));
  EXPECT_THAT(next.to_cancel, ElementsAre("12"));
  EXPECT_TRUE(next.gather);
  EXPECT_THAT(waiting_options(next, "13"),
              ElementsAre("--dependency=afterok:13,afterany:11", "--kill-on-invalid-dep=yes"));
}

TEST(SubmissionState, ReplacesAGatherJobThatWasCancelledOrWaitsForEver) {
  const auto next = [](const QueuedJob& gather, std::vector<QueuedJob> jobs,
                       const SubmissionFiles& files) {
    jobs.push_back(gather);
    return next_jobs(state_of(four_shards(), jobs, files));
  };
  const QueuedJob waits = gather_job("PENDING", std::string(kDependencyNeverSatisfied));
  const QueuedJob cancelled = gather_job("CANCELLED", std::string(kDependencyNeverSatisfied));
  const NextJobs instead = next(waits, {}, files_with({true, true, true, true}));
  EXPECT_THAT(instead.tasks, IsEmpty());
  EXPECT_TRUE(instead.gather);
  EXPECT_THAT(instead.to_cancel, ElementsAre("12"));
  EXPECT_THAT(waiting_options(instead, ""), IsEmpty());
  const NextJobs again =
      next(cancelled, {task(4, "RUNNING")}, files_with({true, true, true, false}));
  EXPECT_TRUE(again.gather);
  EXPECT_THAT(again.to_cancel, IsEmpty());
  EXPECT_THAT(waiting_options(again, ""),
              ElementsAre("--dependency=afterany:11", "--kill-on-invalid-dep=yes"));
}

TEST(SubmissionState, IsStatedInLines) {
  const TemporaryFolder folder;
  Submission submission = four_shards();
  submission.folder = folder.path();
  std::filesystem::create_directory(folder / "logs");
  std::ofstream(folder / "logs/shard-3-9.log") << "an earlier one\n";
  std::ofstream(folder / "logs/shard-3-11.log") << "begun\nasperity: out of memory\n\n";
  const auto text = [&](const std::vector<QueuedJob>& jobs, const std::vector<bool>& shards) {
    return state_text(submission, state_of(submission, jobs, files_with(shards)));
  };
  EXPECT_EQ(
      text({task(2, "RUNNING"), task(3, "OUT_OF_MEMORY"), gather_job("PENDING", "Dependency")},
           {true, false, false, false}),
      "/home/a/results/diameter.tsv: 1 of 4 shards complete\n"
      "running: shard 2\n"
      "missing: shard 3, task out of memory; its log ends with \"asperity: out of memory\" (" +
          (folder / "logs/shard-3-11.log").string() +
          ")\n"
          "not submitted: shard 4\n"
          "gather job 12: pending (Dependency)\n");
  const std::string never{kDependencyNeverSatisfied};
  EXPECT_THAT(text({gather_job("PENDING", never)}, {true, true, true, true}),
              HasSubstr("gather job 12 would wait for ever: a task on which it depends did not end "
                        "successfully"));
  EXPECT_THAT(text({gather_job("CANCELLED", never)}, {true, true, true, true}),
              HasSubstr("gather job 12 was cancelled by Slurm: a task on which it depends did not "
                        "end successfully"));
  EXPECT_THAT(text({gather_job("FAILED", "NonZeroExitCode")}, {true, true, true, true}),
              HasSubstr("gather job 12: failed (NonZeroExitCode); there is no log"));
}

/// A folder with commands in place of those of Slurm: sbatch and scancel append their arguments to `calls`, sbatch prints the
/// numbers 21, 22, …, and squeue appends its own to `queries` and prints `queue`.
class FakeSlurm final {
 public:
  FakeSlurm() {
    make("squeue", "echo \"squeue $*\" >> queries\ncat queue");
    make("scancel", "echo \"scancel $*\" >> calls");
    make("sbatch", "echo \"sbatch $*\" >> calls\necho $((20 + $(grep -c sbatch calls)))");
    std::ofstream(folder_ / "queue").flush();
  }
  void make(const std::string& name, const std::string& body) const {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file) << "#!/bin/sh\nset -e\ncd \"$(dirname \"$0\")\"\n" << body << '\n';
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  }
  void queue(const std::string& lines) const { std::ofstream(folder_ / "queue") << lines; }
  std::string calls() const { return text_in("calls"); }
  std::string queries() const { return text_in("queries"); }
  Slurm commands() const { return Slurm(search_path(), "none"); }
  std::string search_path() const { return folder_.path().string() + ":/usr/bin:/bin"; }

 private:
  std::string text_in(const std::string& name) const {
    std::ifstream file(folder_ / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_{};
};

TEST(SubmittedJobs, AreRequestedOfTheCommandsOfSlurm) {
  const FakeSlurm fake;
  const Submission submission = four_shards();
  const Slurm slurm = fake.commands();
  fake.queue(submission.job_name + "|11|1|RUNNING|None\n" + submission.gather_name() +
             "|12|N/A|PENDING|Dependency\n");
  const SubmissionState state = current_state(submission, slurm);
  const NextJobs next = next_jobs(state);
  const SubmittedJobs submitted = submit_jobs(submission, next, slurm);
  EXPECT_EQ(fake.queries(),
            "squeue --me --noheader --array --states=all --name=" + submission.job_name + ',' +
                submission.gather_name() + " --format=%j|%F|%K|%T|%r\n");
  EXPECT_EQ(fake.calls(),
            "scancel 12\n"
            "sbatch --parsable --array=2-4 /home/a/sub/shards.sbatch\n"
            "sbatch --parsable --dependency=afterok:21,afterany:11 --kill-on-invalid-dep=yes "
            "/home/a/sub/gather.sbatch\n");
  EXPECT_EQ(submitted_text(next, submitted),
            "cancelled: gather job 12\nsubmitted: job array 21 (shards 2-4) and gather job 22\n");
}

TEST(SubmittedJobs, AreNotRequestedWhereTheQueueIsUnknown) {
  const FakeSlurm fake;
  fake.make("squeue",
            "echo 'slurm_load_jobs error: Unable to contact slurm controller' >&2; exit 1");
  EXPECT_THAT(
      refusal_of([&] { current_state(four_shards(), fake.commands()); }),
      AllOf(HasSubstr("squeue --me --noheader --array"), HasSubstr("exit status 1"),
            HasSubstr("Unable to contact slurm controller"), HasSubstr("nothing was submitted")));
}

TEST(SubmittedJobs, NameTheScriptThatSbatchRefuses) {
  const FakeSlurm fake;
  fake.make("sbatch", "echo 'sbatch: error: invalid partition specified: nope' >&2; exit 1");
  const Submission submission = four_shards();
  EXPECT_THAT(refusal_of([&] {
                submit_jobs(submission, {.tasks = {1, 2}, .gather = true}, fake.commands());
              }),
              AllOf(HasSubstr("invalid partition specified: nope"),
                    HasSubstr("correct the options of sbatch in /home/a/sub/shards.sbatch")));
  fake.make("sbatch", "echo Submitted batch job 5");
  EXPECT_THAT(refusal_of([&] { submit_jobs(submission, {.tasks = {1}}, fake.commands()); }),
              HasSubstr("in place of the number of a job"));
}

TEST(SubmittedJobs, ReadTheNumberOfAJobOfOneClusterAmongSeveral) {
  const FakeSlurm fake;
  fake.make("sbatch", "echo '17;east'");
  EXPECT_EQ(submit_jobs(four_shards(), {.tasks = {1}}, fake.commands()).array, "17");
}

TEST(SubmittedJobs, NamesTheCommandThatIsMissing) {
  const TemporaryFolder empty;
  EXPECT_THAT(
      refusal_of([&] { Slurm(empty.path().string(), "Instead: x"); }),
      AllOf(HasSubstr("sbatch of Slurm is not in a folder of PATH"), HasSubstr("Instead: x")));
}

TEST(SubmissionTurn, IsOfOneProcessAtATime) {
  const TemporaryFolder folder;
  const Submission submission{.folder = folder.path()};
  std::optional<SubmissionTurn> turn(std::in_place, submission);
  EXPECT_THAT(refusal_of([&] { SubmissionTurn(submission, std::chrono::milliseconds(1)); }),
              AllOf(HasSubstr("another asperity submit is submitting the jobs of"),
                    HasSubstr((folder / "lock").string()), HasSubstr("stop it")));
  turn.reset();
  turn.emplace(submission, std::chrono::milliseconds(1));
}

/// The end of a watch in which the queue stays empty: every task ends at once, without its shard.
WatchEnd end_of_watch(const Submission& submission, const FakeSlurm& fake,
                      const std::function<bool()>& wait) {
  return watch_submission(submission, fake.commands(),
                          {.on_state = [](const SubmissionState&) {},
                           .on_submitted = [](const NextJobs&, const SubmittedJobs&) {},
                           .wait = wait});
}

TEST(SubmissionWatch, EndsWhereATaskFailsInEveryAttempt) {
  const FakeSlurm fake;
  const TemporaryFolder folder;
  const Submission submission =
      new_submission(folder.path(), folder.path(), {"sweep", "--out", "a.tsv"}, 3);
  std::ofstream(submission.shard(1)) << "complete\n";
  const WatchEnd end = end_of_watch(submission, fake, [] { return true; });
  EXPECT_EQ(end.why, WatchEnd::Why::failed);
  EXPECT_EQ(end.shard, 2);
  EXPECT_EQ(std::ranges::count(fake.calls(), '\n'), 2 * kMostAttempts);
}

TEST(SubmissionWatch, EndsWithTheResult) {
  const FakeSlurm fake;
  const TemporaryFolder folder;
  const Submission submission =
      new_submission(folder.path(), folder.path(), {"sweep", "--out", "a.tsv"}, 2);
  const WatchEnd end = end_of_watch(submission, fake, [&] {
    std::ofstream(submission.result()) << "the table\n";
    return true;
  });
  EXPECT_EQ(end.why, WatchEnd::Why::complete);
}

// Another process looks and submits only while this one waits.
TEST(SubmissionWatch, LooksInItsTurn) {
  const FakeSlurm fake;
  const TemporaryFolder folder;
  Submission submission = four_shards();
  submission.folder = folder.path();
  const auto take_turn = [&] { SubmissionTurn(submission, std::chrono::milliseconds(1)); };
  bool has_looked = false;
  watch_submission(submission, fake.commands(),
                   {.on_state =
                        [&](const SubmissionState&) {
                          has_looked = true;
                          EXPECT_THAT(refusal_of(take_turn), HasSubstr("another asperity submit"));
                        },
                    .on_submitted = [](const NextJobs&, const SubmittedJobs&) {},
                    .wait =
                        [&] {
                          take_turn();
                          return false;
                        }});
  EXPECT_TRUE(has_looked);
}

TEST(SubmissionWatch, StopsWhenItIsToldTo) {
  const FakeSlurm fake;
  const TemporaryFolder folder;
  Submission submission = four_shards();
  submission.folder = folder.path();
  EXPECT_EQ(end_of_watch(submission, fake, [] { return false; }).why, WatchEnd::Why::stopped);
}

}  // namespace
}  // namespace asperity
