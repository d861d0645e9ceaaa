// Assigns participants to groups by permuted blocks.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

/// The size of each block is drawn from `sizes`, multiples of the number of groups, and its order is drawn, so that every block has
/// each group equally often.
///
/// [Schulz 2002] K. F. Schulz, D. A. Grimes: Unequal group sizes in randomised trials: guarding against guessing. Lancet
/// 359(9310), 966–970.
struct PermutedBlocks {
  std::size_t groups = 0;
  std::vector<int> sizes{};  ///< none below 1
  std::uint64_t seed = 0;
};

/// Two and three times the number of groups.
std::vector<int> default_block_sizes(std::size_t groups);

struct PermutedPlace {
  std::uint64_t block = 0;
  std::size_t group = 0;  ///< index
};

/// Of the participant who is assigned after `assigned` others. Sequences of different modes are independent: pilot sessions do not
/// reveal that of the study.
PermutedPlace permuted_place(const PermutedBlocks& blocks, const std::string& mode,
                             std::size_t assigned);

}  // namespace asperity
