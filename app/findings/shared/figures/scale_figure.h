// Makes figures of items along a scale.

#pragma once

#include <string>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// Items along a scale with intervals over participants, in descending order from the top.
struct ScaleChoice {
  QuantityName quantity{};
  /// Used where there is no finding of `quantity`, without its intervals, which treat all
  /// judgements as independent; may be empty.
  QuantityName otherwise{};
  QuantityName status{};  ///< of the fit
  Phrase title{};
};
ScaleChoice bradley_terry();
ScaleChoice plackett_luce();
Figure scale_figure(const std::string& name, const ScaleChoice& choice, const FoundNumbers& found);

}  // namespace asperity
