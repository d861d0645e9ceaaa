// Implements the groups of participants of a protocol.

#include "protocols/plan/groups.h"

#include <stdexcept>

#include "protocols/design/wording.h"

namespace asperity {

std::vector<std::string> groups_of(const Protocol& protocol) {
  std::vector<std::string> groups{};
  if (!protocol.groups) return groups;
  for (const Level& level : protocol.factors.at(protocol.groups->factor).levels) {
    groups.push_back(text_of(level));
  }
  return groups;
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

Allocation allocation_in_turn(const Protocol& protocol, int n) {
  const int rows = counterbalance_rows(protocol);
  const std::vector<std::string> groups = groups_of(protocol);
  if (groups.empty()) return {.counterbalance_row = n % rows};
  const int count = static_cast<int>(groups.size());
  const int round = n / count;
  const int shift = count % 2 == 0 ? round : 0;
  return {.counterbalance_row = round % rows,
          .group = groups[static_cast<std::size_t>((n + shift) % count)]};
}

}  // namespace asperity
