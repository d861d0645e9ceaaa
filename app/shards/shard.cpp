// Numbers shards from 1, and composes and parses their text "INDEX/COUNT" and their file names.

#include "app/shards/shard.h"

#include <charconv>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "app/words/text_parts.h"

namespace asperity {

namespace {

/// Digits alone: no sign, no blank.
std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || read != end || number < 1) return std::nullopt;
  return number;
}

std::filesystem::path without_slash(const std::filesystem::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

std::size_t Shard::number_of(std::size_t items) const noexcept {
  const auto of = static_cast<std::size_t>(count);
  return items / of + (items % of >= static_cast<std::size_t>(index) ? 1 : 0);
}

std::string text_of(const Shard& shard) {
  return std::to_string(shard.index) + '/' + std::to_string(shard.count);
}

std::optional<Shard> shard_in(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const std::optional<int> index = whole_number(text.substr(0, slash));
  const std::optional<int> count = whole_number(text.substr(slash + 1));
  if (!index || !count || *index > *count || *count > kMostShards) return std::nullopt;
  return Shard{*index, *count};
}

std::filesystem::path shard_path(const std::filesystem::path& whole, const Shard& shard) {
  std::filesystem::path path = without_slash(whole);
  if (path.filename() == "." || path.filename() == "..") {
    path = without_slash(std::filesystem::weakly_canonical(path));
  }
  path += ".shard-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
  return path;
}

std::string missing_shards(const std::set<int>& present, const Shard& of_given,
                           const std::filesystem::path& given) {
  const std::string ending = shard_path({}, of_given).string();
  const std::string name = without_slash(given).string();
  const bool has_ending = name.ends_with(ending);
  std::vector<std::string> missing{};
  for (int index = 1; index <= of_given.count; ++index) {
    const Shard shard{index, of_given.count};
    if (present.contains(index)) continue;
    missing.push_back(has_ending
                          ? shard_path(name.substr(0, name.size() - ending.size()), shard).string()
                          : "shard " + text_of(shard));
  }
  return listed(missing);
}

void require_items(const Shard& shard, std::size_t number, const std::string& items) {
  if (static_cast<std::size_t>(shard.count) <= number) return;
  throw std::invalid_argument("--shard " + text_of(shard) + " divides " + std::to_string(number) +
                              ' ' + items + " among " + std::to_string(shard.count) +
                              " shards; divide them among at most " + std::to_string(number));
}

}  // namespace asperity
