// Enumerates the participants of the first group block by block, with the sums over those chosen so far.

#include "analysis/tests/label_permutations.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace asperity {
namespace {

struct Block {
  std::vector<std::size_t> participants{};
  std::size_t first = 0;  ///< of them, participants of the first group
};

std::vector<Block> blocks_of(const TwoGroups& groups) {
  std::map<std::size_t, Block> blocks;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    Block& block = blocks[groups.blocks.empty() ? 0 : groups.blocks[i]];
    block.participants.push_back(i);
    block.first += i < groups.first ? 1 : 0;
  }
  std::vector<Block> all;
  for (auto& [name, block] : blocks) all.push_back(std::move(block));
  return all;
}

/// Exact for up to kMostPermuted.
double binomial_coefficient(std::size_t chosen, std::size_t others) {
  double ways = 1.0;
  for (std::size_t i = 1; i <= chosen; ++i) {
    ways = ways * static_cast<double>(others + i) / static_cast<double>(i);
  }
  return ways;
}

bool are_enumerated(const TwoGroups& groups) {
  return groups.size() <= kMostPermuted ||
         (!groups.blocks.empty() &&
          label_permutations(groups) <=
              binomial_coefficient(kMostPermuted / 2, kMostPermuted - kMostPermuted / 2));
}

class Permutations final {
 public:
  Permutations(const TwoGroups& groups, std::span<const std::vector<double>> numbers,
               const IsAsFar& is_as_far)
      : blocks_(blocks_of(groups)),
        numbers_(numbers),
        is_as_far_(is_as_far),
        sums_(groups.first + 1, std::vector<double>(numbers.front().size(), 0.0)) {}

  double exact_p() {
    choose({.chosen = 0, .block = 0, .next = 0, .left = blocks_.front().first});
    return as_far_count_ / ways_;
  }
  double random_p(Random& random) {
    std::size_t as_far = 1;
    for (std::size_t i = 0; i < kRandomSplits; ++i) {
      std::size_t chosen = 0;
      for (Block& block : blocks_) {
        std::vector<std::size_t>& all = block.participants;
        // The first places of a shuffle, which is all that a split needs.
        for (std::size_t place = 0; place < block.first; ++place) {
          std::swap(all[place], all[place + random.below(all.size() - place)]);
        }
        for (std::size_t place = 0; place < block.first; ++place) add(all[place], chosen++);
      }
      as_far += is_as_far_(sums_[chosen]) ? 1 : 0;
    }
    return static_cast<double>(as_far) / static_cast<double>(kRandomSplits + 1);
  }

 private:
  struct Choice {
    std::size_t chosen = 0;  ///< in all
    std::size_t block = 0;
    std::size_t next = 0;  ///< the first of the block that can be chosen
    std::size_t left = 0;  ///< to be chosen in the block
  };

  /// sums_[chosen + 1] from sums_[chosen].
  void add(std::size_t participant, std::size_t chosen) {
    const std::vector<double>& own = numbers_[participant];
    for (std::size_t j = 0; j < own.size(); ++j) sums_[chosen + 1][j] = sums_[chosen][j] + own[j];
  }

  void choose(Choice choice) {
    if (choice.left == 0) {
      if (++choice.block == blocks_.size()) {
        ways_ += 1.0;
        as_far_count_ += is_as_far_(sums_[choice.chosen]) ? 1.0 : 0.0;
        return;
      }
      choice.next = 0;
      choice.left = blocks_[choice.block].first;
      choose(choice);
      return;
    }
    const std::vector<std::size_t>& all = blocks_[choice.block].participants;
    for (std::size_t i = choice.next; i + choice.left <= all.size(); ++i) {
      add(all[i], choice.chosen);
      choose({.chosen = choice.chosen + 1,
              .block = choice.block,
              .next = i + 1,
              .left = choice.left - 1});
    }
  }

  std::vector<Block> blocks_;
  std::span<const std::vector<double>> numbers_;
  const IsAsFar& is_as_far_;
  std::vector<std::vector<double>> sums_;  ///< by the number of participants chosen
  double as_far_count_ = 0.0;
  double ways_ = 0.0;
};

}  // namespace

double label_permutations(const TwoGroups& groups) {
  double ways = 1.0;
  for (const Block& block : blocks_of(groups)) {
    ways *= binomial_coefficient(block.first, block.participants.size() - block.first);
  }
  return ways;
}

double smallest_p_of_groups(const TwoGroups& groups) {
  if (groups.first == 0 || groups.second == 0) return 1.0;
  if (!are_enumerated(groups)) return 1.0 / static_cast<double>(kRandomSplits + 1);
  const std::vector<Block> blocks = blocks_of(groups);
  const bool has_mirror_image = std::all_of(blocks.begin(), blocks.end(), [](const Block& block) {
    return 2 * block.first == block.participants.size();
  });
  const double ways = label_permutations(groups);
  return std::min(1.0, (has_mirror_image ? 2.0 : 1.0) / ways);
}

SplitTest permute_labels(const TwoGroups& groups, std::span<const std::vector<double>> numbers,
                         const IsAsFar& is_as_far, Random random) {
  if (groups.first == 0 || groups.second == 0) {
    throw std::invalid_argument("a group is empty; each group needs at least one participant");
  }
  if (numbers.size() != groups.size() ||
      (!groups.blocks.empty() && groups.blocks.size() != groups.size())) {
    throw std::invalid_argument("every participant needs numbers and, with blocks, a block");
  }
  Permutations permutations(groups, numbers, is_as_far);
  if (are_enumerated(groups)) return {.p = permutations.exact_p()};
  return {.p = permutations.random_p(random), .exact = false};
}

}  // namespace asperity
