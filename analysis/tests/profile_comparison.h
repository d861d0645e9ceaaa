// Compares two groups of participants in several numbers at once, without assuming a distribution.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/numbers/random.h"
#include "analysis/numbers/seed_of_tests.h"

namespace asperity {

/// How different the mean profiles of two groups are. A profile: the numbers of one participant, in an order that is the same for
/// all, of which the participant's mean is subtracted first, so that what is compared is its form and not its level.
///
/// With the group means m₁ⱼ and m₂ⱼ of n₁ and n₂ participants, R² is the proportion of the sum of squares around the mean profile
/// that is between the groups: n₁n₂/(n₁ + n₂)·Σⱼ(m₁ⱼ − m₂ⱼ)² divided by Σᵢⱼ(xᵢⱼ − mⱼ)² [Anderson 2001]. In the population it
/// is 0 for equal groups; in samples it then is 1/(n₁ + n₂ − 1) on average.
///
/// p, by `permute_labels`: the proportion of the ways to divide the participants into groups of these sizes that have at least this
/// R², rounding apart. The unit is the participant: the numbers of one always stay together.
///
/// [Anderson 2001] Anderson: A new method for non-parametric multivariate analysis of variance.
struct ProfileComparison {
  double r2 = 0.0;  ///< NaN where all profiles are equal
  double p = 1.0;
  bool exact = true;
};
using Profiles = std::span<const std::vector<double>>;
/// `blocks`: TwoGroups::blocks. Errors: std::invalid_argument for an empty group, for profiles of unequal length, and for those of
/// fewer than two numbers.
ProfileComparison compare_profiles(Profiles first, Profiles second,
                                   std::span<const std::size_t> blocks = {},
                                   Random random = Random(kSeedOfTests));

/// A profile without its mean.
std::vector<double> centred(std::vector<double> profile);

}  // namespace asperity
