// Draws each block from a stream of its own, in order, up to that of the participant.

#include "protocols/plan/permuted_blocks.h"

#include <span>

#include "analysis/numbers/random.h"

namespace asperity {

std::vector<int> default_block_sizes(std::size_t groups) {
  return {2 * static_cast<int>(groups), 3 * static_cast<int>(groups)};
}

PermutedPlace permuted_place(const PermutedBlocks& blocks, const std::string& mode,
                             std::size_t assigned) {
  const Random sequence = Random(blocks.seed).split("groups").split(mode);
  for (std::uint64_t block = 0;; ++block) {
    Random random = sequence.split(block);
    const auto size = static_cast<std::size_t>(blocks.sizes[random.below(blocks.sizes.size())]);
    if (assigned >= size) {
      assigned -= size;
      continue;
    }
    std::vector<std::size_t> order(size);
    for (std::size_t i = 0; i < size; ++i) order[i] = i % blocks.groups;
    random.shuffle(std::span<std::size_t>(order));
    return {.block = block, .group = order[assigned]};
  }
}

}  // namespace asperity
