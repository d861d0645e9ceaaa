// Declares the option of a command that computes one part of the whole.

#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/shards/shard.h"

namespace asperity {

/// Refuses a text that does not name a shard.
inline CLI::Validator names_shard() {
  const auto read = [](std::string& text) -> std::string {
    if (shard_in(text)) return {};
    return '"' + text +
           "\" is not permitted; write K/N, part K of N, such as 3/7, with K from 1 to " +
           "N and N at most " + std::to_string(kMostShards);
  };
  return {read, "K/N"};
}

/// --shard K/N. `items`: what is divided, in words; `joined_by`: the command that joins the results. `shard` must outlive the
/// command.
inline CLI::Option* add_shard_option(CLI::App& command, std::optional<Shard>& shard,
                                     const std::string& items, const std::string& joined_by) {
  return command
      .add_option_function<std::string>(
          "--shard", [&shard](const std::string& text) { shard = shard_in(text); },
          "Compute part K of N of the " + items +
              "; the result has the name of the whole with .shard-K-of-N appended; " + joined_by +
              " joins the results of all parts")
      ->check(names_shard())
      ->option_text("K/N");
}

}  // namespace asperity
