// What matching by chance gives with the participant as the unit: one relabelling of the pictures for all attempts.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "analysis/choices/matching_null.h"
#include "analysis/numbers/exact_null.h"

namespace asperity {

/// Trials of one participant with these answers.
struct RepeatedTrial {
  MatchingTrial items{};
  std::uint64_t times = 1;
};

/// The null distribution of one participant's answers when the names of the pictures carry no information.
///
/// A participant who feels nothing may still form one mapping and keep it: attempts are then as alike as they can be,
/// and counting them as independent permutations has a size far above the nominal one. Under the null hypothesis all
/// relabellings σ of the pictures are equally likely whatever the dependence between attempts, and the answers stay as
/// they are: the test conditions on them, its size is at most the nominal one.
///
/// Pictures are exchanged that belong to the same trials: all of them where every trial presents the same items. With
/// n_ab trials in which a was felt and b chosen, the right items are Σ_b n_σ(b)b. Its distribution is counted over the
/// subsets of items that are already assigned (2^m of them instead of m! permutations).
class RelabelledMatching final {
 public:
  /// Throws std::invalid_argument where more than 12 items would be exchanged.
  explicit RelabelledMatching(std::span<const RepeatedTrial> trials);

  /// Of the right items of all trials.
  const IntegerDistribution& right() const noexcept { return right_; }

  bool presents(std::size_t item) const { return group_of_.contains(item); }
  /// Of the right answers to one felt item, which must be presented.
  IntegerDistribution right_of(std::size_t felt) const;

  /// Of the trials with every item right; each must be a permutation. With n_g trials of the permutation g, n_g of them
  /// are right with probability 1/m!, when σ undoes g. Nothing where trials present different items in common: then no
  /// relabelling exchanges all items of a trial.
  const std::optional<IntegerDistribution>& whole() const noexcept { return whole_; }

 private:
  /// Items that are felt in the same trials, and the answers among them.
  struct Exchanged {
    std::vector<std::size_t> items{};
    CountMatrix chosen{};  ///< felt × chosen
  };
  std::vector<Exchanged> exchanged_{};
  std::map<std::size_t, std::size_t> group_of_{};  ///< by item
  IntegerDistribution right_{};
  std::optional<IntegerDistribution> whole_{};
};

}  // namespace asperity
