// Reports tracks that ended before their procedure stopped, next to the means that include their estimates.

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/numbers/finding.h"
#include "analysis/words/phrase.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_results.h"
#include "app/findings/tidy/quantity_name.h"

namespace asperity {

/// The answer, and after it how many participants have an unfinished track, and how many estimates of this quantity from such
/// tracks are included in its mean. `means`: empty without a mean. The answer alone where every track was finished.
Phrase with_unfinished_tracks(const Phrase& answer, const DiscriminationResults& results,
                              QuantityName quantity, const Phrase& means);

/// " Tracks of one of 3 participants were unfinished; the threshold was estimated from the presented trials and is included in
/// the means." Of a task with PSE and JND, both are stated. Empty where every track was finished.
std::string unfinished_sentence(const std::vector<Finding>& findings);

}  // namespace asperity
