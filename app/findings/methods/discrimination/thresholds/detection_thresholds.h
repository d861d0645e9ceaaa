// Estimates thresholds of the designs whose responses are words: yes/no and same–different.

#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "analysis/psychometric/detection_function.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// The model of the responses of a design; nothing where a surface is chosen.
std::optional<DetectionTask> detection_task(const DiscriminationDesign& design);

/// The fits of `fit_detection` with lapse rates of `kSymmetricLapseRate`:
///   functions    analysis `psychometric`, by key: fit.design (the id of the design), fit.detection.alpha, .beta, .criterion; bound.beta, loglik, deviance,
///                deviance.df, deviance.p.chisq
///   thresholds   standard, jnd.dprime1 (α), weber (jnd.dprime1 divided by the standard); a word and a status in place of
///                a number that cannot be estimated, or that is outside the presented levels
DiscriminationFit fit_detections(const DiscriminationTask& task,
                                 std::span<const DiscriminationData> data);

/// The function of a key from these findings; nothing where none was fitted.
std::optional<DetectionFunction> detection_function(const DiscriminationDesign& design,
                                                    const FoundNumbers& functions,
                                                    const FindingKey& key);

}  // namespace asperity
