// The response table of a magnitude estimation.

#pragma once

#include "protocols/kinds/response_table.h"

namespace asperity {

/// The logarithm to base 10 of an estimate is
///
///   L = m + b + n·x − k·(x − x₀)² + c·q + ε
///
/// with the level m and the participant's own b ~ N(0, `level_sd`²); the logarithm x of the predictor (the spacing, the level or the
/// declared value) relative to the mean of its logarithms; the participant's own exponent n; the participant's own curvature k and
/// spacing of maximum roughness x₀, of spacings only; and the participant's own logarithm c of the ratio of the estimates in the
/// last and the first condition, where conditions are equally spaced (q from −½ to ½). n also changes by the participant's own
/// difference of exponents times q, and x₀ by the logarithm of the ratio of the spacings of the maximum times q. Stimuli without
/// a predictor have the place p from −½ to ½ in the order of the protocol in place of x, the logarithm of `ratio` in place of n,
/// and the participant's own u ~ N(0, s²/2) of each stimulus, so that differences between any two have the standard deviation
/// s. All standard deviations of ratios are those of natural logarithms.
/// The curve has its maximum at x₀ + n/(2k): an exponent moves it.
///
/// With a standard, m + b is the logarithm of its number, and the part of L that depends on the stimulus is relative to that of the
/// standard. Numbers have two significant digits; a line is in proportion to the longest one, which limits it. A lapse is an
/// estimate with the level alone and a standard deviation of 0.3.
const ResponseTable& magnitude_responses();

}  // namespace asperity
