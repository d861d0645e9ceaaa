// Evaluates each formula for all combinations, and declares the values as a factor.

#include "protocols/file/derived_levels.h"

#include <algorithm>

#include "protocols/file/meaning/meaning_checks.h"
#include "protocols/plan/block_rows.h"

namespace asperity {

void declare_derived(const Protocol::Block& block, Protocol& protocol,
                     const std::set<std::string>& of_file) {
  if (block.derived.empty()) return;
  const bool can_be_made =
      std::all_of(block.crossed.begin(), block.crossed.end(),
                  [&of_file](const auto& name) { return of_file.contains(name); });
  if (!can_be_made || (block.all_pairs && !of_file.contains(block.all_pairs->factor)) ||
      row_count(protocol, block) > kMaximumTrials) {
    return;
  }
  for (const BlockRow& row : rows_of(protocol, block)) {
    for (const auto& [name, formula] : block.derived) {
      const auto level = row.factors.find(name);
      if (level == row.factors.end() || of_file.contains(name)) continue;
      Factor& factor = protocol.factors[name];
      factor.name = name;
      if (factor.meaning.empty()) factor.meaning = "Computed as " + formula;
      if (std::find(factor.levels.begin(), factor.levels.end(), level->second) ==
          factor.levels.end()) {
        factor.levels.push_back(level->second);
      }
    }
  }
  for (const auto& [name, formula] : block.derived) {
    const auto factor = protocol.factors.find(name);
    if (factor == protocol.factors.end() || of_file.contains(name)) continue;
    std::sort(factor->second.levels.begin(), factor->second.levels.end());
  }
}

}  // namespace asperity
