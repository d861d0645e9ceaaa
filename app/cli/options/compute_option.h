// Declares the option for the place where contacts are evaluated.

#pragma once

#include <map>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/options/word_option.h"

namespace asperity {

/// `on_gpu` must outlive the command.
inline CLI::Option* add_compute_option(CLI::App& command, std::optional<bool>& on_gpu,
                                       const std::string& meaning) {
  const std::map<std::string, bool> words{{"cpu", false}, {"gpu", true}};
  return command.add_option("--compute", on_gpu, meaning)
      ->transform(word_of(words))
      ->option_text("cpu|gpu");
}

/// For commands that run sessions.
inline constexpr const char* kComputeOfSession =
    "Where the contacts of two textured bodies are evaluated: cpu, on the processor, or gpu, on "
    "the first OpenCL device (the default: as the protocol states)";

}  // namespace asperity
