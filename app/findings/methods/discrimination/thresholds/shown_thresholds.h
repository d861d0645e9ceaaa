// What the responses of a discrimination show of the parameters of its response table.

#pragma once

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/shown_parameters.h"
#include "protocols/kinds/response_table.h"

namespace asperity {

/// Of a discrimination in which one of two surfaces is chosen: threshold, the geometric mean of the participants' differences with d′ =
/// 1, and threshold_sd, which contains the error of the estimates (with several conditions, of the geometric means of the
/// participants with a threshold in every one); order and order_sd, from the participants' effects
///
///   o = (z(p₁) − z(p₂))/√2
///
/// with the proportions p₁ and p₂ of choices of the comparison as the first and the second surface (½ added to both counts), the
/// variance of o without that of binomial proportions; and lapse, twice the proportion of errors in easy catch trials.
/// Where levels differ between trials, o is underestimated.
ShownParameters shown_discrimination_parameters(const GatheredAnswers& gathered,
                                                const TabulatedQuestion& asked);

}  // namespace asperity
