// Stores the submission as JSON in its folder, and derives the name of its jobs from a checksum.

#include "app/cluster/submission.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cluster/batch_scripts.h"
#include "app/cluster/divided_commands.h"
#include "app/shards/shard.h"
#include "results_schema/files/atomic_file.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr const char* kFormat = "asperity.submission/1";

std::filesystem::path file_in(const std::filesystem::path& folder) {
  return folder / "submission.json";
}

std::string json_of(const Submission& submission) {
  return nlohmann::ordered_json{{"format", kFormat},
                                {"directory", submission.directory.string()},
                                {"command", submission.command},
                                {"shards", submission.shards},
                                {"out", submission.out.string()},
                                {"job_name", submission.job_name}}
             .dump(2) +
         '\n';
}

/// The name of the result's file, with other characters than letters, digits, ".", "_" and "-" replaced (squeue takes names in a
/// list with commas), and a digest that no other submission has.
std::string name_of(const Submission& submission) {
  std::string name = submission.result().filename().string();
  std::replace_if(
      name.begin(), name.end(),
      [](char c) {
        return !((c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                 c == '.' || c == '_' || c == '-');
      },
      '_');
  constexpr std::size_t kDigits = 12;
  return name + '-' +
         sha256_of(submission.folder.string() + '\n' + json_of(submission)).substr(0, kDigits);
}

void require_printable(const std::string& text, const std::string& what) {
  try {
    static_cast<void>(nlohmann::json(text).dump());
  } catch (const nlohmann::json::type_error&) {
    throw std::invalid_argument(
        what + " \"" + text + "\" is not UTF-8 text, which submission.json consists of; rename it");
  }
  const bool is_printable = std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' || c == 0x7f;
  });
  if (is_printable) return;
  throw std::invalid_argument(what + " \"" + text +
                              "\" contains a control character, which a batch script cannot "
                              "contain; rename it");
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
  std::filesystem::path absolute = std::filesystem::absolute(path).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();
}

}  // namespace

std::filesystem::path Submission::shard(int index) const {
  return shard_path(directory / whole_of(command), {.index = index, .count = shards});
}

std::filesystem::path Submission::shard_log(const std::string& index,
                                            const std::string& job) const {
  return folder / "logs" / ("shard-" + index + '-' + job + ".log");
}

std::filesystem::path Submission::gather_log(const std::string& job) const {
  return folder / "logs" / ("gather-" + job + ".log");
}

Submission new_submission(const std::filesystem::path& folder,
                          const std::filesystem::path& directory, std::vector<std::string> command,
                          int shards, std::filesystem::path out) {
  Submission submission{.folder = absolute_path(folder),
                        .directory = absolute_path(directory),
                        .command = std::move(command),
                        .shards = shards,
                        .out = std::move(out)};
  const std::filesystem::path whole = whole_of(submission.command);
  if (submission.out.empty()) {
    submission.out = whole;
    submission.out += declaration_of(submission.command).result_ending;
  }
  if (!submission.out.has_filename()) submission.out = submission.out.parent_path();
  require_printable(submission.folder.string(), "the folder");
  require_printable(submission.directory.string(), "the current folder");
  for (const std::string& word : submission.command) require_printable(word, "the argument");
  if (submission.folder.string().find_first_of("\"%\\") != std::string::npos) {
    throw std::invalid_argument(
        "the folder " + submission.folder.string() +
        " has one of the characters \" % \\ in its path, which have another "
        "meaning in the names of Slurm's log files; choose another folder");
  }
  require_printable(submission.out.string(), "the result");
  submission.job_name = name_of(submission);
  return submission;
}

void write_submission(const Submission& submission, const SlurmRequest& request,
                      const std::filesystem::path& program) {
  const std::vector<NewFile> files{
      {submission.array_script(), array_script_of(submission, request, program)},
      {submission.gather_script(), gather_script_of(submission, request, program)},
      {file_in(submission.folder), json_of(submission)}};
  if (std::filesystem::exists(files.back().path)) {
    for (const NewFile& file : files) {
      if (holds(file)) continue;
      throw std::runtime_error(
          submission.folder.string() + " holds another submission, or " +
          file.path.filename().string() +
          " was edited since; give the folder alone to continue the one that it holds, or choose "
          "another folder");
    }
    return;
  }
  if (std::filesystem::exists(submission.result())) {
    throw std::runtime_error("the result " + submission.result().string() +
                             " exists already; choose another name, or remove it first");
  }
  std::error_code error{};
  std::filesystem::create_directories(submission.folder / "logs", error);
  if (error) {
    throw std::runtime_error("the folder " + (submission.folder / "logs").string() +
                             " cannot be created (" + error.message() +
                             "); choose another folder, or change its permissions");
  }
  write_files_together(files, Overwrite::refuse);
}

std::optional<Submission> submission_in(const std::filesystem::path& folder) {
  Submission submission{.folder = absolute_path(folder)};
  const std::filesystem::path file = file_in(submission.folder);
  if (!std::filesystem::exists(file)) return std::nullopt;
  constexpr FileKind kKind{"a submission", std::uint64_t{4} << 20};
  try {
    const nlohmann::json json = nlohmann::json::parse(read_file(file, kKind));
    if (json.at("format") != kFormat) {
      throw std::runtime_error("its format is " + json.at("format").dump() + " instead of \"" +
                               kFormat + '"');
    }
    submission.directory = json.at("directory").get<std::string>();
    submission.command = json.at("command").get<std::vector<std::string>>();
    submission.shards = json.at("shards").get<int>();
    submission.out = json.at("out").get<std::string>();
    submission.job_name = json.at("job_name").get<std::string>();
    if (submission.shards < 1 || submission.shards > kMostShards) {
      throw std::runtime_error("its number of shards is not one from 1 to " +
                               std::to_string(kMostShards));
    }
    whole_of(submission.command);
  } catch (const ResultsError&) {
    throw;
  } catch (const std::exception& error) {
    throw ResultsError(file.string() + " is not a submission that can be read (" + error.what() +
                           "); submit the command again with another folder",
                       file);
  }
  return submission;
}

}  // namespace asperity
