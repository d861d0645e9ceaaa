// Implements the checks that the factor of the groups is set by the groups alone.

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/groups.h"

namespace asperity {

namespace {

void check_groups_of_screens(CheckedDocument& checked) {
  const auto& factors = checked.protocol.factors;
  const auto& groups = checked.protocol.groups;
  if (groups && !factors.contains(groups->factor)) return;  // reported there
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    const auto* const screen = std::get_if<Protocol::Screen>(&checked.protocol.flow[i]);
    if (screen == nullptr || screen->groups.empty()) continue;
    const std::string pointer = pointer_to("/flow", i) + "/groups";
    if (!groups) {
      checked.report(
          pointer, phrase("Protocols",
                          "participants have no groups; add the key %1 to the protocol, or remove "
                          "this key")
                       .with(key_name("groups")));
      continue;
    }
    const std::vector<std::string> known = groups_of(checked.protocol);
    for (std::size_t j = 0; j < screen->groups.size(); ++j) {
      const std::string& name = screen->groups[j];
      if (std::ranges::find(known, name) != known.end()) continue;
      checked.report(pointer_to(pointer, j), unknown_name("group", name, known));
    }
  }
}

}  // namespace

std::set<std::string> factors_of(const CheckedDocument& checked, const Protocol::Block& block,
                                 const Protocol::Run* run) {
  std::set<std::string> names = factors_set_by(block, run);
  if (checked.protocol.groups) names.insert(checked.protocol.groups->factor);
  return names;
}

void check_groups(CheckedDocument& checked) {
  check_groups_of_screens(checked);
  if (!checked.protocol.groups) return;
  const std::string& name = checked.protocol.groups->factor;
  const auto factor = checked.protocol.factors.find(name);
  if (factor == checked.protocol.factors.end()) {
    checked.report("/groups/factor", unknown_name("factor", name, checked.protocol.factors));
    return;
  }
  constexpr std::size_t kMost = Protocol::Groups::kMost;
  const std::size_t levels = factor->second.levels.size();
  if (levels < 2 || levels > kMost) {
    checked.report(pointer_to("/factors", name) + "/levels",
                   phrase("Protocols",
                          "the factor of the groups must have 2 to %1 levels, one per group; add "
                          "or remove levels")
                       .with(std::to_string(kMost)));
  }
  const bool is_permuted =
      checked.protocol.groups->assigned == Protocol::Groups::Assignment::permuted_blocks;
  if (is_permuted && !checked.protocol.groups->seed) {
    checked.report(
        "/groups",
        phrase("Protocols", "permuted blocks are a random sequence: state its %1, a whole number")
            .with(key_name("seed")));
  }
  for (std::size_t i = 0; i < checked.protocol.groups->block_sizes.size(); ++i) {
    const int size = checked.protocol.groups->block_sizes[i];
    if (!is_permuted || levels == 0 || size % static_cast<int>(levels) == 0) continue;
    checked.report(
        pointer_to("/groups/block_sizes", i),
        phrase("Protocols",
               "a block of %1 participants does not contain the %2 groups equally often; "
               "use a multiple of %2")
            .with(std::to_string(size), std::to_string(levels)));
  }
  const Phrase why =
      phrase("Protocols",
             "%1 is the factor of the groups, and the group of the participant sets its level; use "
             "another factor here, or remove the key %2")
          .with(in_quotes(name), key_name("groups"));
  for (const auto& [block_name, block] : checked.protocol.blocks) {
    const bool varies_in_pairs = block.all_pairs && block.all_pairs->factor == name;
    if (varies_in_pairs || factors_set_by(block, nullptr).contains(name)) {
      checked.report_key(pointer_to("/blocks", block_name), why);
    }
  }
  for (std::size_t i = 0; i < checked.protocol.flow.size(); ++i) {
    const auto* const run = std::get_if<Protocol::Run>(&checked.protocol.flow[i]);
    if (run != nullptr && run->for_each == name) {
      checked.report(pointer_to("/flow", i) + "/for_each", why);
    }
  }
}

}  // namespace asperity
