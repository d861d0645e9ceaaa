// Runs another program to its end and returns what it printed.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A program of this computer with its arguments, which no shell reads.
struct Command {
  std::filesystem::path program{};
  std::vector<std::string> arguments{};
};

/// As it would be written for a shell, for messages: "sbatch --parsable shards.sbatch", with the name of the program alone.
std::string text_of(const Command& command);

/// The executable of this name in the folders of `search_path`, which are separated by ":" as in PATH; nothing where there
/// is none. A folder without a name is skipped: it would be the current one.
std::optional<std::filesystem::path> program_in(const std::string& search_path,
                                                const std::string& name);

/// What the command wrote to its standard output. Waits for its end without a limit.
///
/// Errors: std::runtime_error where it cannot be started or ends otherwise than with status 0: the command, how it
/// ended, the first line of its standard error, and `remedy`, which completes the sentence after a semicolon.
std::string output_of(const Command& command, const std::string& remedy);

}  // namespace asperity
