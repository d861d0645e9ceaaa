// Tables of the similarity of textures, from the confusions of a recognition.

#pragma once

#include <string>
#include <vector>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/found_numbers.h"

namespace asperity {

/// The analysis of their findings, and the table of the pairs.
inline constexpr const char* kTextureSimilarity = "similarity";

/// Whether a finding of the family `recognition` is about similarities, their MDS configuration or their dendrogram.
bool is_about_similarity(const Finding& finding);

/// Withdraws the fit of the choice model if it mainly fits the ½ that was added to every count.
void withhold_fit(std::vector<Finding>& similarity);

/// Adds similarities, MDS configuration and dendrogram of the textures that were felt.
void add_similarity_tables(const std::vector<std::string>& felt, const FoundNumbers& found,
                           AnalysisOutcome& outcome);

}  // namespace asperity
