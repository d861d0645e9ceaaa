// Represents the responses of a matching as assignments of pictures to textures, and as the table that the family of
// analyses reads.

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/shared/crossed_textures.h"
#include "app/findings/shared/repetition_reliability.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// One trial in which as many pictures as surfaces were shown, every picture correct for one surface and used once, so
/// that a participant who feels nothing responds with a random permutation. Equal trials of a participant are one
/// MatchedTrial with a number of times.
struct MatchedTrial {
  std::uint32_t person = 0;
  std::uint32_t column = 0;
  std::uint32_t options = 0;
  std::vector<std::uint32_t> felt{};    ///< words of GatheredAnswers, in order
  std::vector<std::uint32_t> chosen{};  ///< for each of `felt`
  std::size_t right = 0;
  std::size_t times = 0;

  std::size_t items() const noexcept { return felt.size(); }
  bool whole() const noexcept { return right == items(); }
};

using MatchedTrials = std::span<const MatchedTrial* const>;

/// The trials for which the chance level of a permutation applies; a remark on the number of others.
std::vector<MatchedTrial> matched_trials(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The proportion of correct items of each of these trials, in the order of the responses.
std::vector<RepeatedScore> repeated_scores(const GatheredAnswers& gathered);
/// Every item of these trials.
std::vector<TextureResponse> responses_to_textures(const GatheredAnswers& gathered);

/// items!
std::uint64_t permutations(std::size_t items);

/// For the family `matching`, in which a response is correct if it has the name of the texture felt. `parts`: the parts
/// of the family's findings that are needed.
TidyInput matched_trials_table(const GatheredAnswers& gathered, MatchedTrials assignments,
                               const char* parts);

}  // namespace asperity
