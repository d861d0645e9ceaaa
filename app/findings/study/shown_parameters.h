// What the responses of a study show of the parameters of response tables: how far participants differ, noise and lapses.

#pragma once

#include <functional>
#include <map>
#include <string>

#include "app/findings/study/gathered_answers.h"
#include "protocols/kinds/response_table.h"

namespace asperity {

/// Parameters of the response table of a question (ResponseParameter) by name.
using ShownParameters = std::map<std::string, double, std::less<>>;

/// Of a rating: level, level_sd and noise_sd, and with several items difference_sd (√2·VarianceComponents::interaction_sd). The
/// limits of the scale are ignored.
ShownParameters shown_rating_parameters(const GatheredAnswers& gathered,
                                        const TabulatedQuestion& asked);

/// Of a magnitude estimation, from logarithms (base 10) in the cells of stimuli and conditions: level and level_sd (without a
/// standard), and noise_sd.
ShownParameters shown_magnitude_parameters(const GatheredAnswers& gathered,
                                           const TabulatedQuestion& asked);

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
