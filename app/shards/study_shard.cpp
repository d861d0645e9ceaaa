// Stores the identity of the shard in the study, and checks that all shards of a division are present.

#include "app/shards/study_shard.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "results_schema/files/atomic_file.h"
#include "results_schema/part_files.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

[[noreturn]] void refuse_study(const std::filesystem::path& path, const std::string& problem) {
  throw std::runtime_error(path.string() + ' ' + problem);
}

/// The shards of one computation with one number of shards.
struct Division {
  std::filesystem::path first{};
  ShardIdentity of_first{};
  std::map<int, std::filesystem::path> shards{};
};

/// "; STUDY is shard 2/3 of another simulation: …" for each shard of `other` in place of which `division` has none.
std::string foreign_shards(const Division& other, const Division& division) {
  if (other.of_first.shard.count != division.of_first.shard.count) return {};
  std::string text{};
  for (const auto& [index, study] : other.shards) {
    if (division.shards.contains(index)) continue;
    text += "; " + study.string() + " is shard " +
            text_of(Shard{index, other.of_first.shard.count}) +
            " of another simulation: " + difference(other.of_first, division.of_first);
  }
  return text;
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
  std::vector<Division> divisions{};
  for (const std::filesystem::path& study : studies) {
    const std::optional<ShardIdentity> identity = study_shard(study);
    if (!identity) continue;
    auto division = std::find_if(divisions.begin(), divisions.end(), [&](const Division& known) {
      return belong_together(known.of_first, *identity);
    });
    if (division == divisions.end()) {
      division = divisions.insert(divisions.end(), {.first = study, .of_first = *identity});
    }
    const auto [place, is_new] = division->shards.try_emplace(identity->shard.index, study);
    if (is_new) continue;
    throw std::runtime_error(place->second.string() + " and " + study.string() +
                             " are both shard " + text_of(identity->shard) +
                             " of one simulation; name one of them");
  }
  for (const Division& division : divisions) {
    std::set<int> present{};
    for (const auto& [index, study] : division.shards) present.insert(index);
    const std::string missing = missing_shards(present, division.of_first.shard, division.first);
    if (missing.empty()) continue;
    std::string foreign{};
    for (const Division& other : divisions) foreign += foreign_shards(other, division);
    throw std::runtime_error("missing of the simulation of " + division.first.string() + ": " +
                             missing + foreign +
                             "; simulate what is missing, then name all shards");
  }
}

}  // namespace asperity
