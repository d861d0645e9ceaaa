// A divided computation on a cluster: its command, its batch scripts and its folder.

#include "app/cluster/submission.h"

#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cluster/batch_scripts.h"
#include "app/cluster/divided_commands.h"
#include "app/power/curve/power_files.h"
#include "tests/support/refusal.h"
#include "tests/support/temporary_folder.h"

namespace asperity {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::vector<std::string> kSweep{"sweep", "--model", "bump_map", "--out", "diameter.tsv"};

Submission submission_of_four() { return new_submission("/home/a/sub", "/home/a/results", kSweep, 4); }

TEST(Submission, NamesItsShardsByAnOptionOfEitherForm) {
  const std::filesystem::path expected = "a b.tsv";
  EXPECT_EQ(whole_of({"sweep", "--out", "a b.tsv", "--model", "x"}), expected);
  EXPECT_EQ(whole_of({"sweep", "--model", "x", "--out=a b.tsv"}), expected);
  EXPECT_EQ(whole_of({"simulate", "p.json", "--study", "S/"}), "S");
}

TEST(Submission, NamesShardsOfAFileInAFolder) {
  const std::vector<std::string> power{"power", "p.json", "--seed", "1", "--out", "my power/"};
  EXPECT_EQ(whole_of(power), PowerFiles{.folder = "my power"}.studies());
  EXPECT_EQ(whole_of({"power", "p.json", "--out", "."}), "./studies.tsv");
  const Submission submission = new_submission("/f", "/w", power, 2);
  EXPECT_EQ(submission.shard(2), "/w/my power/studies.tsv.shard-2-of-2");
  EXPECT_EQ(submission.result(), "/w/my power/studies.tsv");
  EXPECT_THAT(gather_script_of(submission, {}, "/usr/bin/asperity"),
              HasSubstr("gather \"my power/studies.tsv\".shard-{1..2}-of-2 --out \"my "
                        "power/studies.tsv\"\n"));
}

TEST(Submission, RefusesCommandsThatCannotBeDividedOrNameNoShards) {
  const auto refused = [](const std::vector<std::string>& words) {
    return refusal_of<std::invalid_argument>([&] { whole_of(words); });
  };
  EXPECT_THAT(refused({"verify", "S"}), AllOf(HasSubstr("\"verify\" cannot be divided"),
                                              HasSubstr("sweep, simulate and power")));
  EXPECT_THAT(refused({}), HasSubstr("cannot be divided"));
  EXPECT_THAT(refused({"sweep", "--model", "x"}),
              HasSubstr("--out, which names the shards, is missing"));
  EXPECT_THAT(refused({"sweep", "--out"}), HasSubstr("is missing"));
  EXPECT_THAT(refused({"simulate", "--study", "."}), HasSubstr("--study \".\" has no name"));
  EXPECT_THAT(refused({"simulate", "--study", "S/../"}), HasSubstr("has no name"));
  EXPECT_THAT(refused({"sweep", "--out", "a", "--out=b"}), HasSubstr("--out is given twice"));
  EXPECT_THAT(refused({"sweep", "--out", "a", "--shard", "1/2"}),
              HasSubstr("write --shards N before --"));
  EXPECT_THAT(refused({"sweep", "--out", "a", "--jobs=3"}), HasSubstr("write --cpus N before --"));
}

TEST(Submission, ComparesTheWholeNameOfAnOption) {
  EXPECT_EQ(whole_of({"sweep", "--outer", "x", "--out", "a.tsv", "--sharded", "--jobsite=1"}),
            "a.tsv");
}

TEST(Submission, NamesItsJobsAfterTheResultAndAllThatItIs) {
  const Submission submission = submission_of_four();
  EXPECT_THAT(submission.job_name, ::testing::MatchesRegex("diameter\\.tsv-[0-9a-f]{12}"));
  const auto name_with = [](const std::string& folder, std::vector<std::string> words, int shards) {
    return new_submission(folder, "/home/a/results", std::move(words), shards).job_name;
  };
  EXPECT_EQ(name_with("/home/a/sub/", kSweep, 4), submission.job_name);
  EXPECT_NE(name_with("/home/a/sub2", kSweep, 4), submission.job_name);
  EXPECT_NE(name_with("/home/a/sub", kSweep, 5), submission.job_name);
  // squeue takes names in a list with commas.
  EXPECT_THAT(name_with("/f", {"sweep", "--out", "a,b c.tsv"}, 4),
              ::testing::StartsWith("a_b_c.tsv-"));
}

TEST(Submission, JoinsIntoTheNamedResult) {
  const Submission submission = new_submission("/f", "/w", kSweep, 2, "all tables/joined.tsv");
  EXPECT_THAT(gather_script_of(submission, {}, "/usr/bin/asperity"),
              HasSubstr("gather diameter.tsv.shard-{1..2}-of-2 --out \"all tables/joined.tsv\"\n"));
  EXPECT_EQ(submission.result(), "/w/all tables/joined.tsv");
  EXPECT_EQ(submission.shard(1), "/w/diameter.tsv.shard-1-of-2");
  EXPECT_NE(submission.job_name, new_submission("/f", "/w", kSweep, 2).job_name);
  EXPECT_THAT(new_submission("/f", "/w", kSweep, 2, "joined/").job_name,
              ::testing::StartsWith("joined-"));
}

TEST(Submission, RefusesWhatABatchScriptCannotContain) {
  const auto refused = [](const std::string& folder, const std::string& word) {
    return refusal_of<std::invalid_argument>([&] {
      new_submission(folder, "/w", {"sweep", "--out", "a", word}, 2);
    });
  };
  EXPECT_THAT(refused("/a%b", ""), HasSubstr("choose another folder"));
  EXPECT_THAT(refused("/a\"b", ""), HasSubstr("choose another folder"));
  EXPECT_THAT(refused("/a", "two\nlines"), HasSubstr("control character"));
  EXPECT_THAT(refused("/a", "\xff"), HasSubstr("is not UTF-8 text"));
  EXPECT_EQ(refused("/a b", "$HOME"), "");
}

TEST(Submission, WritesABatchScriptOfTheArray) {
  const Submission submission = submission_of_four();
  EXPECT_EQ(array_script_of(submission,
                            {.partition = "short",
                             .time = "02:00:00",
                             .memory = "2G",
                             .cpus = 3,
                             .further = {"--account=lab"}},
                            "/opt/my tools/asperity"),
            "#!/bin/bash\n"
            "# A job array. Task K computes shard K of 4, a file or a study with the ending "
            ".shard-K-of-4.\n"
            "# Running a task again gives the same bytes.\n"
            "#SBATCH --job-name=" +
                submission.job_name +
                "\n"
                "#SBATCH --array=1-4\n"
                "#SBATCH --cpus-per-task=3\n"
                "#SBATCH --partition=short\n"
                "#SBATCH --time=02:00:00\n"
                "#SBATCH --mem=2G\n"
                "#SBATCH --requeue\n"
                "#SBATCH --open-mode=append\n"
                "#SBATCH --output=\"/home/a/sub/logs/shard-%a-%A.log\"\n"
                "#SBATCH --account=lab\n"
                "\n"
                "set -eu\n"
                "cd /home/a/results\n"
                "exec \"/opt/my tools/asperity\" sweep --shard \"$SLURM_ARRAY_TASK_ID/4\" --jobs "
                "\"$SLURM_CPUS_PER_TASK\" --model bump_map --out diameter.tsv\n");
}

TEST(Submission, WritesABatchScriptThatNamesEveryShardToJoin) {
  const Submission submission = submission_of_four();
  EXPECT_EQ(
      gather_script_of(submission, {}, "/usr/bin/asperity"),
      "#!/bin/bash\n"
      "# Joins the 4 shards. Submitted with --dependency=afterok:ARRAY --kill-on-invalid-dep=yes.\n"
      "#SBATCH --job-name=" +
          submission.job_name +
          "-gather\n"
          "#SBATCH --requeue\n"
          "#SBATCH --open-mode=append\n"
          "#SBATCH --output=\"/home/a/sub/logs/gather-%j.log\"\n"
          "\n"
          "set -eu\n"
          "cd /home/a/results\n"
          "exec /usr/bin/asperity gather diameter.tsv.shard-{1..4}-of-4 --out diameter.tsv\n");
  const Submission studies =
      new_submission("/f", "/w", {"simulate", "p.json", "--study", "my study/"}, 12);
  EXPECT_THAT(gather_script_of(studies, {}, "/usr/bin/asperity"),
              HasSubstr("exec /usr/bin/asperity merge \"my study\".shard-{1..12}-of-12 --out \"my "
                        "study.merged\"\n"));
  EXPECT_EQ(studies.result(), "/w/my study.merged");
  EXPECT_EQ(studies.shard(12), "/w/my study.shard-12-of-12");
}

TEST(Submission, RefusesOptionsOfSbatchThatWouldBeOtherLines) {
  const auto refused = [](const SlurmRequest& request) {
    return refusal_of<std::invalid_argument>(
        [&] { array_script_of(submission_of_four(), request, "/usr/bin/asperity"); });
  };
  EXPECT_THAT(refused({.time = "2 hours"}), HasSubstr("--time \"2 hours\" is not one word"));
  EXPECT_THAT(refused({.partition = "a\n#SBATCH --uid=0"}), HasSubstr("--partition"));
  EXPECT_THAT(refused({.further = {"account=lab"}}), HasSubstr("--sbatch=--account=NAME"));
  EXPECT_THAT(refused({.further = {"--comment=a b"}}), HasSubstr("not one word"));
}

TEST(Submission, IsComputedByGnuParallelToo) {
  EXPECT_EQ(
      parallel_line_of(submission_of_four(), "/usr/bin/asperity"),
      "seq 4 | parallel --halt soon,fail=1 --quote /usr/bin/asperity sweep --shard {}/4 --jobs 1 "
      "--model bump_map --out diameter.tsv && /usr/bin/asperity gather "
      "diameter.tsv.shard-{1..4}-of-4 --out diameter.tsv");
}

TEST(Submission, IsReadBackFromItsFolder) {
  const TemporaryFolder folder;
  const Submission submission =
      new_submission(folder / "sub", folder.path(), {"sweep", "--out", "a\" b.tsv"}, 7);
  EXPECT_FALSE(submission_in(folder / "sub").has_value());
  write_submission(submission, {}, "/usr/bin/asperity");
  const auto read = submission_in(folder.path() / "sub" / "");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->folder, submission.folder);
  EXPECT_EQ(read->directory, submission.directory);
  EXPECT_EQ(read->command, submission.command);
  EXPECT_EQ(read->shards, 7);
  EXPECT_EQ(read->out, "a\" b.tsv");
  EXPECT_EQ(read->job_name, submission.job_name);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "sub/logs"));
}

TEST(Submission, IsWrittenOnceAndRepeatedOnlyUnchanged) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& out, const SlurmRequest& request) {
    write_submission(new_submission(folder / "sub", folder.path(), {"sweep", "--out", out}, 2),
                     request, "/usr/bin/asperity");
  };
  write("a.tsv", {});
  EXPECT_EQ(refusal_of([&] { write("a.tsv", {}); }), "");
  EXPECT_THAT(refusal_of([&] { write("b.tsv", {}); }), HasSubstr("holds another submission"));
  EXPECT_THAT(refusal_of([&] { write("a.tsv", {.time = "1"}); }),
              HasSubstr("shards.sbatch was edited"));
}

TEST(Submission, RefusesAResultThatExists) {
  const TemporaryFolder folder;
  std::ofstream(folder / "a.tsv") << "a table\n";
  const Submission submission =
      new_submission(folder / "sub", folder.path(), {"sweep", "--out", "a.tsv"}, 2);
  EXPECT_THAT(refusal_of([&] { write_submission(submission, {}, "/usr/bin/asperity"); }),
              HasSubstr("a.tsv exists already; choose another name"));
  EXPECT_FALSE(std::filesystem::exists(folder / "sub"));
}

TEST(Submission, RefusesAFileThatIsNotOne) {
  const TemporaryFolder folder;
  std::ofstream(folder / "submission.json") << R"({"format": "asperity.submission/2"})";
  EXPECT_THAT(refusal_of([&] { submission_in(folder.path()); }),
              AllOf(HasSubstr("submission.json"), HasSubstr("asperity.submission/2")));
}

}  // namespace
}  // namespace asperity
