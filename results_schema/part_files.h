// The files in the folder of a study that state which part of a whole it is.

#pragma once

#include <filesystem>

namespace asperity {

/// The shard of a simulation whose participants the study contains (docs/shards.md).
inline constexpr const char* kShardFile = "shard.json";
/// The places of the whole study that are dealt to a station.
inline constexpr const char* kDealFile = "deal.json";

/// Whether a study-relative path is one of them. A copy of a study is the same part and has the file; a study that is merged from
/// several parts is none of them, and has not.
inline bool states_part(const std::filesystem::path& relative) {
  return relative == kShardFile || relative == kDealFile;
}

}  // namespace asperity
