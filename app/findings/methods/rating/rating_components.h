// Reports which dimensions the scales of a rating share.

#pragma once

#include <cstddef>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/shared/rated_scales.h"

namespace asperity {

/// The number of components whose loadings are reported: one for every five items. With fewer items per component,
/// loadings depend on the chosen items more than on the scales.
std::size_t components_with_loadings(std::size_t items) noexcept;

/// Adds the principal components of the items' mean ratings, over the items that were rated on every scale, with intervals
/// from participants drawn with replacement. Adds nothing with fewer than two scales.
void add_rating_components(const GatheredAnswers& gathered, const std::vector<RatedScale>& scales,
                           AnalysisOutcome& outcome);

}  // namespace asperity
