// The option that loads plug-ins.

#pragma once

#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>

namespace asperity {

/// `plugins` must outlive the command.
inline void add_plugin_option(CLI::App& command, std::vector<std::filesystem::path>& plugins) {
  command
      .add_option(
          "--plugin", plugins,
          "Plug-in with a force model, a shared library (docs/write-a-force-model.md); may be "
          "given several times. No file can name it. Except in run and device-test it is called in "
          "a "
          "separate process: if it ends that process, or does not return from a call, the command "
          "states the plug-in, the function and the limit, and fails")
      ->option_text("FILE")
      ->allow_extra_args(false);  // one for each time the option is given
}

}  // namespace asperity
