// The findings of a psychometric function of responses that include "cannot tell".

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/psychometric/psychometric_maximum.h"
#include "analysis/psychometric/unforced_bootstrap.h"
#include "app/findings/tidy/finding_list.h"

namespace asperity {

/// Responses of one condition to a choice between `alternatives`.
struct UnforcedData {
  FindingKey key{};
  std::vector<UnforcedBlock> blocks{};
  std::size_t alternatives = 2;
};

/// Adds the numbers of the family `psyfit` of a function that was fitted to split counts (`split_block`): `fit.…`,
/// `bound.beta`, `loglik`, `threshold` and `slope.at.threshold`. `threshold` and `fit.beta` have the intervals of
/// `bootstrap_unforced` with `draws` draws (0: none). There are no numbers of the goodness of fit: split counts are not
/// binomial.
///
/// `maximum`: of the split blocks, increasing. `lists`: one for each performance of the question, to which the findings with
/// the threshold at this performance are added.
void add_unforced_estimates(const UnforcedData& data, const PsychometricMaximum& maximum,
                            const UnforcedQuestion& question, std::size_t draws,
                            std::span<FindingList> lists);

}  // namespace asperity
