// Makes the tables that a selection and a paired comparison have in common.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/cell_words.h"
#include "app/findings/outcome/figure.h"
#include "app/findings/outcome/found_numbers.h"
#include "app/findings/outcome/result_table.h"
#include "app/findings/outcome/tally.h"

namespace asperity {

/// Tables of proportions that several kinds of protocol have: of all responses, by texture and by position.
inline constexpr const char* kAllShares = "shares";
inline constexpr const char* kSharesByTexture = "shares_by_texture";
inline constexpr const char* kPositions = "positions";
/// Of the means of the participants' proportions (add_persons) by position.
inline constexpr const char* kPersonsByPosition = "persons_by_position";
/// The table of items along a scale, and the analysis of its findings.
inline constexpr const char* kWorthScale = "scale";

/// The figures of a table of choices within pairs: the proportions, and the scale where there is no table of it, because an item was
/// always or never chosen.
std::vector<Figure> figures_of_pairs(const ResultTable& table, const AnalysisOutcome& outcome);

/// Appends the table `positions`: the proportion of choices of each position of a trial, first to last.
void add_positions_table(std::span<const Tally> positions, const Phrase& note,
                         AnalysisOutcome& outcome);

/// A scale of items by the findings of a family, with intervals over participants.
struct WorthScale {
  QuantityName log_worth{};
  QuantityName worth{};
  QuantityName no_interval{};  ///< states why there are no intervals
  Phrase title{};
  Phrase note{};  ///< %1: how the intervals are computed, or why there are none
};
/// Appends the table `scale` with a row per item.
void add_worth_scale(const WorthScale& scale, std::span<const std::string> items,
                     const FoundNumbers& found, AnalysisOutcome& outcome);

}  // namespace asperity
