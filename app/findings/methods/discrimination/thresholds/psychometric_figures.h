// Makes figures of psychometric functions.

#pragma once

#include <optional>
#include <string>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// What the note of psychometric functions states.
struct FunctionsNote {
  enum class Intervals { none, delta, resamples, delta_and_resamples, repeated_procedure };
  enum class Thresholds { none, drawn };
  std::string percent_correct{};  ///< at the threshold; empty: points of subjective equality
  std::string confidence = "95";  ///< in percent
  Thresholds thresholds = Thresholds::drawn;
  Intervals intervals = Intervals::delta;  ///< of the drawn thresholds
};
/// Explains only the marks that are drawn.
Phrase note_on_functions(const FunctionsNote& note);

/// Proportions correct by level, the fitted function and its threshold. `unit`: of the levels. `levels`: the range of the
/// levels that the axis shows; those of the table without it.
Figure psychometric_figure(const TidyInput& input, const FoundNumbers& found,
                           const std::string& unit,
                           const std::optional<FigureSpan>& levels = std::nullopt);

}  // namespace asperity
