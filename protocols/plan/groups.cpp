// Implements the groups of participants of a protocol.

#include "protocols/plan/groups.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "protocols/design/wording.h"

namespace asperity {

using Assignment = Protocol::Groups::Assignment;

std::vector<std::string> groups_of(const Protocol& protocol) {
  std::vector<std::string> groups{};
  if (!protocol.groups) return groups;
  for (const Level& level : protocol.factors.at(protocol.groups->factor).levels) {
    groups.push_back(text_of(level));
  }
  return groups;
}

bool is_for_group(const std::vector<std::string>& groups, std::string_view group) {
  return groups.empty() || std::ranges::find(groups, group) != groups.end();
}

FactorLevels group_factor(const Protocol& protocol, const std::string& group) {
  if (!protocol.groups) {
    if (group.empty()) return {};
    throw std::runtime_error("the protocol " + in_quotes(protocol.name) +
                             " has no groups; leave out the group " + in_quotes(group));
  }
  const std::string& factor = protocol.groups->factor;
  const std::vector<Level>& levels = protocol.factors.at(factor).levels;
  if (group.empty()) return {{factor, levels.front()}};
  for (const Level& level : levels) {
    if (text_of(level) == group) return {{factor, level}};
  }
  throw std::runtime_error("the protocol " + in_quotes(protocol.name) + " has no group " +
                           in_quotes(group) + "; use " + one_of(groups_of(protocol)));
}

std::optional<PermutedBlocks> permuted_blocks_of(const Protocol& protocol) {
  if (!protocol.groups || protocol.groups->assigned != Assignment::permuted_blocks) return {};
  const std::size_t count = groups_of(protocol).size();
  if (count == 0) return {};
  const std::vector<int>& sizes = protocol.groups->block_sizes;
  return PermutedBlocks{.groups = count,
                        .sizes = sizes.empty() ? default_block_sizes(count) : sizes,
                        .seed = protocol.groups->seed.value_or(0)};
}

std::string permuted_group(const Protocol& protocol, const std::string& mode,
                           std::size_t assigned) {
  return groups_of(
      protocol)[permuted_place(permuted_blocks_of(protocol).value(), mode, assigned).group];
}

Allocation allocation_in_turn(const Protocol& protocol, int n) {
  const int rows = counterbalance_rows(protocol);
  const std::vector<std::string> groups = groups_of(protocol);
  if (groups.empty()) return {.counterbalance_row = n % rows};
  if (permuted_blocks_of(protocol)) {
    return allocations_in_turn(protocol, "simulate", n + 1).back();
  }
  const int count = static_cast<int>(groups.size());
  const int round = n / count;
  const int shift = count % 2 == 0 ? round : 0;
  return {.counterbalance_row = round % rows,
          .group = groups[static_cast<std::size_t>((n + shift) % count)]};
}

std::vector<Allocation> allocations_in_turn(const Protocol& protocol, const std::string& mode,
                                            int count) {
  const bool is_permuted = permuted_blocks_of(protocol).has_value();
  const int rows = counterbalance_rows(protocol);
  std::map<std::string, int> assigned{};
  std::vector<Allocation> allocations{};
  for (int n = 0; n < count; ++n) {
    if (!is_permuted) {
      allocations.push_back(allocation_in_turn(protocol, n));
      continue;
    }
    const std::string group = permuted_group(protocol, mode, static_cast<std::size_t>(n));
    allocations.push_back({.counterbalance_row = assigned[group]++ % rows, .group = group});
  }
  return allocations;
}

}  // namespace asperity
