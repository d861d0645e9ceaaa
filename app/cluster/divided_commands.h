// The commands of the program that can be divided into shards, each declared once.

#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A command with the option --shard K/N, and the command that joins the results of its shards. A further one is a further row.
struct DividedCommand {
  std::string_view name{};  ///< "sweep"
  /// The option whose value, a file or a study, gives the shards their names (app/shards/shard.h): "--out".
  std::string_view whole_option{};
  /// Where that value is a folder: the file in it from which the shards have their names, and which joining them makes.
  std::string_view whole_file{};
  /// "gather": JOINED_BY SHARD… --out RESULT makes the result, and refuses shards that are missing or of another command.
  std::string_view joined_by{};
  /// Appended to the value of the option for the name of the result: empty where the undivided command would make it, and
  /// ".merged" where it exists before, as the study whose protocols are simulated.
  std::string_view result_ending{};
};

std::span<const DividedCommand> divided_commands();

/// The options that the batch script gives to every divided command; the user gives them to `submit`.
inline constexpr std::string_view kShardOption = "--shard";
inline constexpr std::string_view kJobsOption = "--jobs";

/// The declaration of a command, given as its words without the name of the program: {"sweep", "--model", …}.
///
/// Errors: std::invalid_argument for a command that cannot be divided, with those that can.
const DividedCommand& declaration_of(const std::vector<std::string>& words);

/// The whole from which the shards have their names: the value of the command's whole option ("--out FILE" or "--out=FILE"), without a
/// slash at the end, or its whole file in that folder.
///
/// Errors: std::invalid_argument where the option is missing, empty or given twice, where its value is "." or ".." and not the folder
/// of a whole file, and where the command has an option that the batch script gives; as declaration_of.
std::filesystem::path whole_of(const std::vector<std::string>& words);

}  // namespace asperity
