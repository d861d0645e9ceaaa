#include "app/shards/study_shard.h"

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "results_schema/files/atomic_file.h"
#include "results_schema/part_files.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

[[noreturn]] void refuse_study(const std::filesystem::path& path, const std::string& problem) {
  throw std::runtime_error(path.string() + ' ' + problem);
}

}  // namespace

void write_study_shard(const std::filesystem::path& study, const ShardIdentity& identity) {
  write_file(study / kShardFile, json_of(identity).dump(2) + '\n', Overwrite::refuse);
}

std::optional<ShardIdentity> study_shard(const std::filesystem::path& study) {
  const std::filesystem::path file = study / kShardFile;
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    return shard_identity_from(
        nlohmann::json::parse(read_file(file, kOptionsFile), nullptr, false));
  } catch (const ResultsError&) {
    throw;
  } catch (const std::runtime_error& error) {
    refuse_study(file, error.what());
  }
}

bool is_stored_study(const std::filesystem::path& study, const ShardIdentity& identity) {
  if (!std::filesystem::exists(std::filesystem::symlink_status(study))) return false;
  const std::optional<ShardIdentity> stored = study_shard(study);
  if (!stored) {
    refuse_study(study,
                 "exists and is not a shard of a simulation; move it away, or use another --study");
  }
  if (*stored != identity) {
    refuse_study(study, "exists and is of another simulation: " + difference(*stored, identity) +
                            "; move it away, or use another --study");
  }
  if (Study::open(study, Access::read_only).condition() != StudyCondition::whole) {
    refuse_study(study,
                 "has changed since it was simulated: the checksum of its study.sqlite does not "
                 "hold; remove it, and simulate this shard again");
  }
  return true;
}

void require_complete_divisions(const std::vector<std::filesystem::path>& studies) {
  struct Division {
    std::filesystem::path first{};
    Shard of_first{};
    std::map<int, std::filesystem::path> shards{};
  };
  std::map<std::pair<std::string, int>, Division> divisions{};
  for (const std::filesystem::path& study : studies) {
    const std::optional<ShardIdentity> identity = study_shard(study);
    if (!identity) continue;
    const auto& [whole, shard] = *identity;
    Division& division = divisions[{whole.sha256(), shard.count}];
    if (division.shards.empty()) {
      division.first = study;
      division.of_first = shard;
    }
    const auto [place, is_new] = division.shards.try_emplace(shard.index, study);
    if (is_new) continue;
    throw std::runtime_error(place->second.string() + " and " + study.string() +
                             " are both shard " + text_of(shard) +
                             " of one simulation; name one of them");
  }
  for (const auto& [key, division] : divisions) {
    std::set<int> present{};
    for (const auto& [index, study] : division.shards) present.insert(index);
    const std::string missing = missing_shards(present, division.of_first, division.first);
    if (missing.empty()) continue;
    throw std::runtime_error("missing of the simulation of " + division.first.string() + ": " +
                             missing + "; simulate what is missing, then name all shards");
  }
}

}  // namespace asperity
