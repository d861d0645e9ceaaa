// Identifies a computation by the checksum of its declaration and program, stored with every shard.

#include "app/shards/divided_computation.h"

#include <stdexcept>

#include <nlohmann/json.hpp>

#include "results_schema/hashes/sha256.h"

namespace asperity {

std::string DividedComputation::sha256() const {
  return sha256_of(nlohmann::ordered_json{command, declaration, results, program}.dump());
}

nlohmann::ordered_json json_of(const ShardIdentity& identity) {
  return {{"format", kShardFormat},
          {"command", identity.whole.command},
          {"program", identity.whole.program},
          {"whole_sha256", identity.whole.sha256()},
          {"results_of_whole", identity.whole.results},
          {"shard", identity.shard.index},
          {"of", identity.shard.count},
          {"declaration", identity.whole.declaration}};
}

ShardIdentity shard_identity_from(const nlohmann::json& json) {
  if (!json.is_object() || !json.contains("format") || json.at("format") != kShardFormat) {
    throw std::runtime_error(std::string("does not have the format ") + kShardFormat +
                             "; use the version of the program that wrote it");
  }
  try {
    ShardIdentity identity{.whole = {.command = json.at("command"),
                                     .declaration = json.at("declaration"),
                                     .results = json.at("results_of_whole"),
                                     .program = json.at("program")}};
    const auto shard = shard_in(std::to_string(json.at("shard").get<int>()) + '/' +
                                std::to_string(json.at("of").get<int>()));
    if (shard && json.at("whole_sha256") == identity.whole.sha256()) {
      identity.shard = *shard;
      return identity;
    }
  } catch (const nlohmann::json::exception&) {
    // A member that is missing or of another type is damage as well.
  }
  throw std::runtime_error(
      "is damaged: its members contradict each other. Compute this shard again");
}

bool belong_together(const ShardIdentity& one, const ShardIdentity& other) {
  return one.whole == other.whole && one.shard.count == other.shard.count;
}

std::string difference(const ShardIdentity& one, const ShardIdentity& other) {
  if (one.whole.command != other.whole.command) {
    return "it was computed by " + one.whole.command + ", not by " + other.whole.command;
  }
  if (one.whole.program != other.whole.program) {
    return "it was computed by " + one.whole.program + ", not by " + other.whole.program;
  }
  if (one.whole != other.whole) return "the options, or the files that they name, differ";
  if (one.shard.count != other.shard.count) {
    return "it is shard " + text_of(one.shard) + ", not one of " +
           std::to_string(other.shard.count);
  }
  return "it is shard " + text_of(one.shard) + ", not " + text_of(other.shard);
}

}  // namespace asperity
