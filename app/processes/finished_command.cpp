// Pumps a child process until it ends; a failure quotes the first line of its errors.

#include "app/processes/finished_command.h"

#include <stdexcept>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "app/processes/child_process.h"
#include "app/words/shell_word.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

[[noreturn]] void fail(const Command& command, const std::string& how, const std::string& remedy) {
  throw std::runtime_error("the command \"" + text_of(command) + "\" " + how + "; " + remedy);
}

/// The first line that is not empty, in quotation marks after a colon; empty where there is none.
std::string first_line_of(const std::string& errors) {
  for (const std::string& line : parts_of(errors, '\n')) {
    if (!line.empty()) return ": \"" + line + '"';
  }
  return {};
}

std::string text_of_end(const ChildProcess::Ending& ending) {
  switch (ending.how) {
    case ChildProcess::End::closed:
      break;
    case ChildProcess::End::exited:
      return "failed with exit status " + std::to_string(ending.number);
    case ChildProcess::End::signalled:
      return "was ended by signal " + std::to_string(ending.number);
  }
  return "closed its standard output without ending";
}

}  // namespace

std::string text_of(const Command& command) {
  std::string text = shell_word(command.program.filename().string());
  for (const std::string& argument : command.arguments) text += ' ' + shell_word(argument);
  return text;
}

std::optional<std::filesystem::path> program_in(const std::string& search_path,
                                                const std::string& name) {
  for (const std::string& folder : parts_of(search_path, ':')) {
    if (folder.empty()) continue;
    std::filesystem::path file = std::filesystem::path(folder) / name;
    std::error_code error{};
    if (std::filesystem::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) {
      return file;
    }
  }
  return std::nullopt;
}

std::string output_of(const Command& command, const std::string& remedy) {
  std::string output{};
  std::string errors{};
  ChildProcess::Ending ending{};
  try {
    ChildProcess process(command.program, command.arguments);
    process.close_input();
    constexpr double kLongestWait_s = 1.0;
    while (!process.has_ended()) {
      process.pump(kLongestWait_s);
      output += std::exchange(process.output(), {});
      errors += process.take_errors();
    }
    ending = process.ending();
  } catch (const std::system_error& error) {
    fail(command, "cannot be started (" + error.code().message() + ")", remedy);
  }
  if (ending.how != ChildProcess::End::exited || ending.number != 0) {
    fail(command, text_of_end(ending) + first_line_of(errors), remedy);
  }
  return output;
}

}  // namespace asperity
