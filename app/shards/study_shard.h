// A study that contains the participants of one shard of a simulation.

#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/shards/divided_computation.h"

namespace asperity {

/// The file `shard.json` in the folder of such a study states which shard it is, as JSON (`json_of`). Its rows are those of the
/// whole study, and no row depends on the shard. Errors: ResultsError.
void write_study_shard(const std::filesystem::path& study, const ShardIdentity& identity);

/// Nothing for a study that is not a shard. Errors: std::runtime_error naming the file, for one that is damaged.
std::optional<ShardIdentity> study_shard(const std::filesystem::path& study);

/// Whether the study of this shard exists, so that a repeated command has nothing left to simulate.
///
/// Errors: std::runtime_error where the name is taken by anything else, by another shard or by a study whose checksum does not
/// hold.
bool is_stored_study(const std::filesystem::path& study, const ShardIdentity& identity);

/// Refuses studies that are to be merged and include shards of a simulation, unless they include all shards of it, each once.
/// Studies that are not shards are ignored.
///
/// Errors: std::runtime_error naming the missing shards, with those of another simulation in their place and the difference, or
/// the two studies of one shard.
void require_complete_divisions(const std::vector<std::filesystem::path>& studies);

}  // namespace asperity
