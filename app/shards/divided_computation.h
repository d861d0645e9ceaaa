// A computation that is divided into shards, as a whole.

#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/shards/shard.h"

namespace asperity {

/// Shards belong together if their computations are equal and have the same number of shards.
struct DividedComputation {
  std::string command{};  ///< the subcommand, such as "sweep"
  std::string
      declaration{};  ///< JSON text of everything that determines the bytes of the result, except the program
  /// Of the whole: rows of a sweep, runs of a power analysis, participants of a simulation.
  std::size_t results = 0;
  std::string program{};  ///< numerical_identity() of the program that computes it

  /// Identifies the computation: of all members.
  std::string sha256() const;
  bool operator==(const DividedComputation&) const = default;
};

/// A shard of a computation.
struct ShardIdentity {
  DividedComputation whole{};
  Shard shard{};

  bool operator==(const ShardIdentity&) const = default;
};

/// The format that files of shards state.
inline constexpr const char* kShardFormat = "asperity.shard/1";

/// An object with `format`, `command`, `program`, `whole_sha256`, `results_of_whole`, `shard`, `of` and `declaration`.
nlohmann::ordered_json json_of(const ShardIdentity& identity);
/// Errors: std::runtime_error without a place for another format, for a member that is missing or has another type, and where
/// `whole_sha256` is not that of the other members.
ShardIdentity shard_identity_from(const nlohmann::json& json);

/// Whether two shards belong to one division of one computation.
bool belong_together(const ShardIdentity& one, const ShardIdentity& other);
/// Why they do not: "the options, or the files that they name, differ".
std::string difference(const ShardIdentity& one, const ShardIdentity& other);

}  // namespace asperity
