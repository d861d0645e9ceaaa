// The options that choose the program that states the levels of a session.

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/session/levels/external_program.h"

namespace asperity {

struct ExternalOptions {
  std::string program{};
  std::vector<std::string> arguments{};

  std::optional<ExternalProgram> chosen() const {
    if (program.empty()) return std::nullopt;
    return ExternalProgram{.file = program, .arguments = arguments};
  }
};

/// `options` must outlive the command.
inline void add_external_options(CLI::App& command, ExternalOptions& options) {
  CLI::Option* const program = command.add_option(
      "--external", options.program,
      "Program that states the levels of the procedure \"external\" (docs/formats/external.md); "
      "no file can name it");
  program->option_text("PROGRAM");
  command
      .add_option("--external-argument", options.arguments,
                  "An argument of that program; may be given several times")
      ->option_text("TEXT")
      ->needs(program)
      ->allow_extra_args(false);  // one for each time the option is given
}

}  // namespace asperity
