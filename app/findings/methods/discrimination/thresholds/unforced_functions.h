// Psychometric functions of responses that include "cannot tell".

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/psychometric/psychometric_model.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"

namespace asperity {

/// Resamples of a bootstrap interval.
inline constexpr std::size_t kUnforcedResamples = 400;

/// Whether a response is "cannot tell".
bool has_unsure(const DiscriminationData& data);

/// Adds the status of the data under the names of the family `psyfit`, unless it is ok; returns whether a function can be
/// fitted.
bool add_fit_status(const std::vector<PsychometricBlock>& blocks, const PsychometricModel& model,
                    const FindingKey& key, const Basis& basis, FindingList& list);

/// The function of data whose levels did not depend on the responses, fitted to split counts (`split_hits`) by maximum
/// likelihood: the status and `add_unforced_estimates`, with intervals if the data need any.
///
/// `lists`: one for each of the proportions of hits, to which the findings with the threshold at this proportion are added.
void add_unforced_function(const DiscriminationTask& task, const DiscriminationData& data,
                           std::span<const double> performances, std::span<FindingList> lists);

}  // namespace asperity
