// Makes the tables of a matching.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/findings/outcome/found_numbers.h"
#include "app/findings/shared/matched_trials.h"

namespace asperity {

/// The table of pairs of textures, and its counts.
inline constexpr const char* kConfusedPairs = "confused_pairs";
inline const ResultColumn kFeltAsOther{
    .id = "felt_as_other", .heading = phrase("AnalysisWords", "confusions with the other")};
inline const ResultColumn kOtherAsFelt{.id = "other_as_felt",
                                       .heading = phrase("AnalysisWords", "reverse confusions")};
/// How often both textures of a row were confused.
std::int64_t confusions_of(const ResultTable& table, const ResultRow& pair);

/// Adds the correct trials and items by column and sex, and their tests.
void add_matching_tables(const GatheredAnswers& gathered, std::span<const MatchedTrial> assignments,
                         AnalysisOutcome& outcome);

/// Adds the correct items by texture, and the confusion matrix.
void add_confusions(const GatheredAnswers& gathered, std::span<const MatchedTrial> assignments,
                    AnalysisOutcome& outcome);

/// Adds the pairs of textures by the number of their confusions, the most frequent first.
void add_confused_pairs(const std::vector<std::string>& felt, const FoundNumbers& found,
                        AnalysisOutcome& outcome);

/// Adds the trials by their number of correct items, next to the numbers expected under guessing.
void add_right_items(std::size_t items, const FoundNumbers& found, AnalysisOutcome& outcome);

}  // namespace asperity
