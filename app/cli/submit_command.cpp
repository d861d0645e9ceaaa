// asperity submit: a divided computation as the jobs of a cluster.

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/options/number_option.h"
#include "app/cli/output/submission_output.h"
#include "app/cli/output/terminal.h"
#include "app/cli/signals.h"
#include "app/cluster/batch_scripts.h"
#include "app/cluster/divided_commands.h"
#include "app/cluster/slurm.h"
#include "app/cluster/submission.h"
#include "app/cluster/submission_turn.h"
#include "app/cluster/submission_watch.h"
#include "app/cluster/submit_jobs.h"
#include "app/shards/shard.h"
#include "app/study_files/program.h"
#include "app/words/shell_word.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

struct SubmitOptions {
  std::filesystem::path folder{};
  std::vector<std::string> command{};
  bool slurm = false;
  int shards = 0;
  std::filesystem::path out{};
  SlurmRequest request{};
  bool write_only = false;
  bool status = false;
  bool watch = false;
  bool json = false;
};

std::filesystem::path running_program() {
  std::filesystem::path program = program_file();
  if (!program.empty()) return program;
  throw std::runtime_error(
      "the file of this program was replaced or removed since it was started, and the batch "
      "scripts need its path; repeat the command");
}

/// The submission of the command line: a new one, which is written, or that of the folder.
Submission chosen_submission(const SubmitOptions& options, const std::filesystem::path& program) {
  if (options.command.empty()) {
    if (auto submission = submission_in(options.folder)) return *std::move(submission);
    throw WrongUsage("submit: " + options.folder.string() +
                     " holds no submission; give the command to submit: asperity submit FOLDER "
                     "--slurm --shards N -- COMMAND");
  }
  if (options.shards == 0) throw WrongUsage("submit: --shards is missing; add --shards N");
  try {
    Submission submission = new_submission(options.folder, std::filesystem::current_path(),
                                           options.command, options.shards, options.out);
    if (!options.slurm) {
      throw WrongUsage(
          "submit: the batch system is missing; add --slurm. Without a batch system: " +
          parallel_line_of(submission, program));
    }
    write_submission(submission, options.request, program);
    return submission;
  } catch (const std::invalid_argument& error) {
    throw WrongUsage(std::string("submit: ") + error.what());
  }
}

void print_scripts(const Submission& submission, const std::filesystem::path& program) {
  std::cout << "written: " << submission.array_script().string() << ", "
            << submission.gather_script().string() << '\n'
            << "to submit them: asperity submit " << shell_word(submission.folder.string()) << '\n'
            << "without a batch system, in " << submission.directory.string() << ": "
            << parallel_line_of(submission, program) << '\n';
}

/// Until the result exists.
int watch(const Submission& submission, const Slurm& slurm) {
  constexpr std::chrono::seconds kBetweenLooks{30};
  const InterruptWatch interrupt("stopping the watch; the jobs remain in the queue");
  std::string shown{};
  std::mutex mutex{};
  std::condition_variable_any never{};
  const WatchEnd end = watch_submission(
      submission, slurm,
      {.on_state =
           [&](const SubmissionState& state) {
             std::string text = state_text(submission, state);
             if (text != shown) std::cout << text << std::flush;
             shown = std::move(text);
           },
       .on_submitted =
           [](const NextJobs& next, const SubmittedJobs& submitted) {
             std::cout << submitted_text(next, submitted) << std::flush;
           },
       .wait =
           [&] {
             std::unique_lock lock(mutex);
             never.wait_for(lock, interrupt.token(), kBetweenLooks, [] { return false; });
             return !interrupt.token().stop_requested();
           }});
  if (end.why == WatchEnd::Why::complete) return 0;
  if (end.why == WatchEnd::Why::failed) {
    say("asperity: " + (end.shard == 0 ? "the gather job" : "shard " + std::to_string(end.shard)) +
        " was submitted " + std::to_string(kMostAttempts) +
        " times in this watch and did not succeed; correct what its log states, then repeat the "
        "command");
  }
  return 1;
}

int run_submit(const SubmitOptions& options) {
  const std::filesystem::path program = running_program();
  const Submission submission = chosen_submission(options, program);
  if (options.write_only) {
    print_scripts(submission, program);
    return 0;
  }
  if (const SubmissionFiles files = files_of(submission); files.result) {  // also without Slurm
    const SubmissionState state = state_of(submission, {}, files);
    if (options.json) {
      std::cout << state_json(submission, state, {}, {}).dump(2) << '\n';
    } else {
      std::cout << state_text(submission, state);
    }
    return 0;
  }
  const char* const search_path = std::getenv("PATH");
  const Slurm slurm(search_path == nullptr ? "" : search_path,
                    "Without a batch system: " + parallel_line_of(submission, program));
  if (options.watch) return watch(submission, slurm);
  std::optional<SubmissionTurn> turn{};
  if (!options.status) turn.emplace(submission);
  const SubmissionState state = current_state(submission, slurm);
  const NextJobs next = options.status ? NextJobs{} : next_jobs(state);
  const bool submits = !next.is_empty();
  const bool is_stated = options.status || !state.is_untouched();
  if (!options.json && is_stated) std::cout << state_text(submission, state);
  const SubmittedJobs submitted = submits ? submit_jobs(submission, next, slurm) : SubmittedJobs{};
  if (options.json) {
    std::cout << state_json(submission, state, next, submitted).dump(2) << '\n';
  } else if (submits) {
    std::cout << submitted_text(next, submitted);
  }
  return 0;
}

std::string names_of_divided_commands() {
  std::vector<std::string> names{};
  for (const DividedCommand& command : divided_commands()) names.emplace_back(command.name);
  return listed(names);
}

/// "of sweep its --out; of simulate its --study with .merged appended; of power studies.tsv in its --out"
std::string default_results() {
  std::string text{};
  for (const DividedCommand& command : divided_commands()) {
    text += std::string(text.empty() ? "" : "; ") + "of " + std::string(command.name) + ' ';
    if (!command.whole_file.empty()) text += std::string(command.whole_file) + " in ";
    text += "its " + std::string(command.whole_option);
    if (!command.result_ending.empty()) {
      text += " with " + std::string(command.result_ending) + " appended";
    }
  }
  return text;
}

}  // namespace

void add_submit(CLI::App& program, Job& job) {
  auto options = std::make_shared<SubmitOptions>();
  CLI::App* command = program.add_subcommand(
      "submit",
      "Compute a divided command on a cluster: a job array of shards, then their joining.");
  command
      ->add_option("FOLDER", options->folder,
                   "Folder of the submission: its batch scripts and logs (created with a COMMAND)")
      ->required();
  auto* words = command->add_option(
      "COMMAND", options->command,
      "After --: the command to divide, with its arguments and without the name of the program: " +
          names_of_divided_commands());
  command->add_flag("--slurm", options->slurm, "Batch system: Slurm (sbatch, squeue, scancel)")
      ->needs(words);
  command->add_option("--shards", options->shards, "Number of shards, a task each")
      ->check(number_within(2, kMostShards))
      ->needs(words);
  command
      ->add_option("--out", options->out,
                   "Result, a file or a study (default: " + default_results() + ')')
      ->needs(words);
  command
      ->add_option("--partition", options->request.partition,
                   "Partition of the jobs, as sbatch takes it (default: that of the cluster)")
      ->needs(words);
  command
      ->add_option(
          "--time", options->request.time,
          "Time limit of each task, as sbatch takes it, such as 02:00:00 (default: that of "
          "the partition)")
      ->needs(words);
  command
      ->add_option("--mem", options->request.memory,
                   "Memory of each task, as sbatch takes it, such as 2G (default: that of the "
                   "partition)")
      ->needs(words);
  command->add_option("--cpus", options->request.cpus, "Processors of each task, and its --jobs")
      ->check(number_within(1, 256))
      ->capture_default_str()
      ->needs(words);
  command
      ->add_option("--sbatch", options->request.further,
                   "Further option of sbatch, in one word, such as --sbatch=--account=NAME; may be "
                   "given more than once")
      ->allow_extra_args(false)
      ->needs(words);
  auto* write_only = command->add_flag(
      "--write-only", options->write_only,
      "Write the batch scripts and submit nothing; print the same computation for "
      "GNU parallel");
  auto* status = command->add_flag("--status", options->status,
                                   "Show the state of the submission and submit nothing");
  auto* watch_flag = command->add_flag(
      "--watch", options->watch,
      "Show the state and submit what is missing, every 30 s, until the result exists");
  auto* json = command->add_flag("--json", options->json, "Print the state as JSON");
  status->excludes(write_only)->excludes(watch_flag);
  watch_flag->excludes(write_only)->excludes(json);
  json->excludes(write_only);
  command->callback([options, &job] { job = [options] { return run_submit(*options); }; });
}

}  // namespace asperity
