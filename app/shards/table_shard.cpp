// Writes rows with the numbers of their results, ended by a checksum, and merges them in that order.

#include "app/shards/table_shard.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "results_schema/hashes/sha256.h"
#include "results_schema/study.h"

namespace asperity {

namespace {

constexpr const char* kNumberColumn = "result";
constexpr std::string_view kDigestLine = "sha256\t";

[[noreturn]] void refuse_file(const std::filesystem::path& file, const std::string& problem) {
  throw std::runtime_error(file.string() + ' ' + problem);
}

/// Takes the first line off the text, without its end.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

/// What precedes the SHA-256 at the end; nothing where that does not hold.
std::optional<std::string_view> content_of(std::string_view text) {
  constexpr std::size_t kDigits = 64;
  const std::size_t length = kDigestLine.size() + kDigits + 1;
  if (text.size() < length) return std::nullopt;
  const std::string_view content = text.substr(0, text.size() - length);
  const std::string expected = std::string(kDigestLine) + sha256_of(content) + '\n';
  return text.substr(content.size()) == expected ? std::optional(content) : std::nullopt;
}

/// Without the number of its result.
std::string_view after_number(std::string_view line) { return line.substr(line.find('\t') + 1); }

/// Of a content whose SHA-256 holds.
TableShard shard_from(std::string_view content) {
  TableShard read{.identity = shard_identity_from(nlohmann::json::parse(next_line(content)))};
  read.heading = after_number(next_line(content));
  while (!content.empty()) {
    const std::string_view line = next_line(content);
    read.lines[std::stoull(std::string(line))].append(after_number(line)) += '\n';
  }
  return read;
}

/// A shard, and the file from which it was read.
struct ShardFile {
  std::filesystem::path file{};
  TableShard shard{};
};

void require_same_computation(const ShardFile& one, const ShardFile& first) {
  if (belong_together(one.shard.identity, first.shard.identity)) return;
  refuse_file(one.file, "does not belong to the computation of " + first.file.string() + ": " +
                            difference(one.shard.identity, first.shard.identity) +
                            "; name only the shards of one computation");
}

}  // namespace

TableShard table_shard(ShardIdentity identity, const Table& table,
                       const std::vector<std::size_t>& numbers) {
  TableShard made{.identity = std::move(identity)};
  const std::string text = tsv_of(table);
  std::string_view rest = text;
  made.heading = next_line(rest);
  for (const std::size_t number : numbers) made.lines[number].append(next_line(rest)) += '\n';
  return made;
}

std::string text_of(const TableShard& shard) {
  std::string text =
      json_of(shard.identity).dump() + '\n' + kNumberColumn + '\t' + shard.heading + '\n';
  for (const auto& [number, lines] : shard.lines) {
    for (std::string_view rest = lines; !rest.empty();) {
      text += std::to_string(number) + '\t';
      text.append(next_line(rest)) += '\n';
    }
  }
  return text + std::string(kDigestLine) + sha256_of(text) + '\n';
}

TableShard read_table_shard(const std::filesystem::path& file) {
  const std::string text = read_file(file, kTableFile);
  const std::optional<std::string_view> content = content_of(text);
  if (!content) {
    refuse_file(file,
                "is not the file of a shard, or is damaged: its last line is not the SHA-256 of "
                "its content. Remove it, and compute this shard again");
  }
  try {
    return shard_from(*content);
  } catch (const std::exception& error) {
    refuse_file(file, error.what());
  }
}

bool is_stored(const std::filesystem::path& file, const ShardIdentity& identity) {
  if (!std::filesystem::exists(std::filesystem::symlink_status(file))) return false;
  const TableShard stored = read_table_shard(file);
  if (stored.identity == identity) return true;
  refuse_file(file, "exists and is of another computation: " +
                        difference(stored.identity, identity) + "; use --force to replace it");
}

void store(const std::filesystem::path& file, const TableShard& shard, Overwrite overwrite) {
  const std::string text = text_of(shard);
  try {
    write_file(file, text, overwrite);
  } catch (const ResultsError& error) {
    if (error.code() != EEXIST) throw;
    if (holds({file, text})) return;
    refuse_file(file,
                "exists with other bytes than this process computed for the same shard; find out "
                "which of the two is right, and use --force to replace the file");
  }
}

GatheredTable gathered(const std::vector<std::filesystem::path>& files) {
  std::map<int, ShardFile> shards{};
  std::optional<ShardFile> first{};
  for (const std::filesystem::path& file : files) {
    const ShardFile read{.file = file, .shard = read_table_shard(file)};
    if (!first) first = read;
    require_same_computation(read, *first);
    const auto [place, is_new] = shards.try_emplace(read.shard.identity.shard.index, read);
    if (is_new || place->second.shard == read.shard) continue;
    refuse_file(file,
                "and " + place->second.file.string() + " are both shard " +
                    text_of(read.shard.identity.shard) +
                    " and differ; find out which of the two is right, and name only that one");
  }
  if (!first) throw std::invalid_argument("no shard is named; name the files of all shards");
  const Shard of_first = first->shard.identity.shard;
  std::set<int> present{};
  for (const auto& [index, one] : shards) present.insert(index);
  const std::string missing = missing_shards(present, of_first, first->file);
  if (!missing.empty()) {
    throw std::runtime_error("missing: " + missing +
                             "; compute what is missing, then join all shards");
  }
  GatheredTable whole{.whole = first->shard.identity.whole,
                      .shards = of_first.count,
                      .table = first->shard.heading + '\n'};
  std::map<std::size_t, std::string> lines{};
  for (auto& [index, one] : shards) lines.merge(one.shard.lines);
  for (const auto& [number, rows] : lines) whole.table += rows;
  whole.rows =
      static_cast<std::size_t>(std::count(whole.table.begin(), whole.table.end(), '\n')) - 1;
  if (lines.size() != whole.whole.results) {
    throw std::runtime_error("the shards have " + std::to_string(lines.size()) + " of " +
                             std::to_string(whole.whole.results) +
                             " results, although none of them is missing; compute them again");
  }
  return whole;
}

}  // namespace asperity
