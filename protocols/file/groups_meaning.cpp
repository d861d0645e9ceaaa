// Implements the checks that the factor of the groups is set by the groups alone.

#include "protocols/file/meaning_checks.h"

namespace asperity {

std::set<std::string> Meaning::factors_of(const Protocol::Block& block,
                                          const Protocol::Run* run) const {
  std::set<std::string> names = factors_set_by(block, run);
  if (protocol_.groups) names.insert(protocol_.groups->factor);
  return names;
}

void Meaning::check_groups() {
  if (!protocol_.groups) return;
  const std::string& name = protocol_.groups->factor;
  const auto factor = protocol_.factors.find(name);
  if (factor == protocol_.factors.end()) {
    report("/groups/factor", unknown_name("factor", name, protocol_.factors));
    return;
  }
  constexpr std::size_t kMaximumGroups = 32;
  const std::size_t levels = factor->second.levels.size();
  if (levels < 2 || levels > kMaximumGroups) {
    report(pointer_to("/factors", name) + "/levels",
           "the factor of the groups must have 2 to " + std::to_string(kMaximumGroups) +
               " levels, one per group; add or remove levels");
  }
  const bool is_permuted =
      protocol_.groups->assigned == Protocol::Groups::Assignment::permuted_blocks;
  if (is_permuted && !protocol_.groups->seed) {
    report("/groups",
           "permuted blocks are a random sequence: state its \"seed\", a whole number");
  }
  for (const char* const key : {"block_sizes", "seed"}) {
    if (is_permuted || !document_.root().at("groups").contains(key)) continue;
    report_key(std::string("/groups/") + key,
               "only the assignment \"permuted_blocks\" has this key; remove it, or set assigned "
               "to \"permuted_blocks\"");
  }
  for (std::size_t i = 0; i < protocol_.groups->block_sizes.size(); ++i) {
    const int size = protocol_.groups->block_sizes[i];
    if (!is_permuted || levels == 0 || size % static_cast<int>(levels) == 0) continue;
    report(pointer_to("/groups/block_sizes", i),
           "a block of " + std::to_string(size) + " participants does not contain the " +
               std::to_string(levels) + " groups equally often; use a multiple of " +
               std::to_string(levels));
  }
  constexpr const char* kWhy =
      " is the factor of the groups, and the group of the participant sets its level; use another "
      "factor here, or remove the key groups";
  for (const auto& [block_name, block] : protocol_.blocks) {
    const bool varies_in_pairs = block.all_pairs && block.all_pairs->factor == name;
    if (varies_in_pairs || factors_set_by(block, nullptr).contains(name)) {
      report_key(pointer_to("/blocks", block_name), in_quotes(name) + kWhy);
    }
  }
  for (std::size_t i = 0; i < protocol_.flow.size(); ++i) {
    const auto* const run = std::get_if<Protocol::Run>(&protocol_.flow[i]);
    if (run != nullptr && run->for_each == name) {
      report(pointer_to("/flow", i) + "/for_each", in_quotes(name) + kWhy);
    }
  }
}

}  // namespace asperity
