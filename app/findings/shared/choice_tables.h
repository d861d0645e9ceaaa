// Makes the tables that a selection and a paired comparison have in common.

#pragma once

#include <span>
#include <string>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/tidy/found_numbers.h"
#include "app/words/phrase.h"

namespace asperity {

/// Appends the table `positions`: the proportion of choices of each position of a trial, first to last.
void add_positions_table(std::span<const Tally> positions, const Phrase& note,
                         AnalysisOutcome& outcome);

/// A scale of items by the findings of a family, with intervals over participants.
struct WorthScale {
  std::string log_worth{};    ///< quantity
  std::string worth{};        ///< quantity
  std::string no_interval{};  ///< the quantity that states why there are no intervals
  Phrase title{};
  Phrase note{};  ///< %1: how the intervals are computed, or why there are none
};
/// Appends the table `scale` with a row per item.
void add_worth_scale(const WorthScale& scale, std::span<const std::string> items,
                     const FoundNumbers& found, AnalysisOutcome& outcome);

}  // namespace asperity
