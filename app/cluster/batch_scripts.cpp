// Composes the scripts of an array job and a gather job for sbatch, and one line for GNU parallel.

#include "app/cluster/batch_scripts.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "app/cluster/divided_commands.h"
#include "app/shards/shard.h"
#include "app/words/shell_word.h"

namespace asperity {

namespace {

std::string number_of_shards(const Submission& submission) {
  return std::to_string(submission.shards);
}

/// `value` if a line "#SBATCH …" can contain it: anything else would be another option, or end the line.
const std::string& one_word(const std::string& option, const std::string& value) {
  const bool is_word = !value.empty() && std::all_of(value.begin(), value.end(), [](char c) {
    return c > ' ' && c < 0x7f && c != '"' && c != '\'' && c != '\\' && c != '#';
  });
  if (is_word) return value;
  throw std::invalid_argument(
      option + " \"" + value +
      "\" is not one word without quotation marks; write it as sbatch takes "
      "it, such as --time 02:00:00");
}

/// The settings of both jobs. `log` is a pattern of sbatch. Further options are last, so that they have precedence.
std::string setting_lines(const SlurmRequest& request, const std::filesystem::path& log) {
  std::string lines{};
  const auto add = [&lines](const char* option, const std::string& value) {
    if (value.empty()) return;
    lines += std::string("#SBATCH ") + option + '=' + one_word(option, value) + '\n';
  };
  add("--partition", request.partition);
  add("--time", request.time);
  add("--mem", request.memory);
  lines +=
      "#SBATCH --requeue\n#SBATCH --open-mode=append\n#SBATCH --output=\"" + log.string() + "\"\n";
  for (const std::string& option : request.further) {
    if (!option.starts_with("--")) {
      throw std::invalid_argument("--sbatch \"" + option +
                                  "\" is not an option of sbatch in one word; write it as "
                                  "--sbatch=--account=NAME");
    }
    lines += "#SBATCH " + one_word("--sbatch", option) + '\n';
  }
  return lines;
}

/// The command of one shard, with a text of the shell in place of its number and number of threads.
std::string shard_command(const Submission& submission, const std::filesystem::path& program,
                          const std::string& index, const std::string& threads) {
  std::string line = shell_word(program.string()) + ' ' + submission.command.front();
  line += ' ' + std::string(kShardOption) + ' ' + index + ' ' + std::string(kJobsOption) + ' ' +
          threads;
  for (auto word = submission.command.begin() + 1; word != submission.command.end(); ++word) {
    line += ' ' + shell_word(*word);
  }
  return line;
}

/// The names of all shards as one word of bash: "diameter.tsv.shard-{1..20}-of-20".
std::string all_shards(const std::filesystem::path& whole, int shards) {
  std::string ending = shard_path("", {.index = 1, .count = shards}).string();
  ending.replace(ending.find('1'), 1, "{1.." + std::to_string(shards) + '}');
  return shell_word(whole.string()) + ending;
}

std::string gather_command(const Submission& submission, const std::filesystem::path& program) {
  return shell_word(program.string()) + ' ' +
         std::string(declaration_of(submission.command).joined_by) + ' ' +
         all_shards(whole_of(submission.command), submission.shards) + " --out " +
         shell_word(submission.out.string());
}

std::string body_of(const Submission& submission, const std::string& command) {
  return "\nset -eu\ncd " + shell_word(submission.directory.string()) + "\nexec " + command + '\n';
}

}  // namespace

std::string array_script_of(const Submission& submission, const SlurmRequest& request,
                            const std::filesystem::path& program) {
  const std::string count = number_of_shards(submission);
  return "#!/bin/bash\n"
         "# A job array. Task K computes shard K of " +
         count + ", a file or a study with the ending .shard-K-of-" + count +
         ".\n# Running a task again gives the same bytes.\n" +
         "#SBATCH --job-name=" + submission.job_name + '\n' + "#SBATCH --array=1-" + count + '\n' +
         "#SBATCH --cpus-per-task=" + std::to_string(request.cpus) + '\n' +
         setting_lines(request, submission.shard_log("%a", "%A")) +
         body_of(submission,
                 shard_command(submission, program, "\"$SLURM_ARRAY_TASK_ID/" + count + '"',
                               "\"$SLURM_CPUS_PER_TASK\""));
}

std::string gather_script_of(const Submission& submission, const SlurmRequest& request,
                             const std::filesystem::path& program) {
  return "#!/bin/bash\n"
         "# Joins the " +
         number_of_shards(submission) +
         " shards. Submitted with --dependency=afterok:ARRAY --kill-on-invalid-dep=yes.\n" +
         "#SBATCH --job-name=" + submission.gather_name() + '\n' +
         setting_lines(request, submission.gather_log("%j")) +
         body_of(submission, gather_command(submission, program));
}

std::string parallel_line_of(const Submission& submission, const std::filesystem::path& program) {
  const std::string count = number_of_shards(submission);
  return "seq " + count + " | parallel --halt soon,fail=1 --quote " +
         shard_command(submission, program, "{}/" + count, "1") + " && " +
         gather_command(submission, program);
}

}  // namespace asperity
