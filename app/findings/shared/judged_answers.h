// Represents the responses of a recognition as correct and incorrect ones, and as the tables that families of analyses
// read.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/tally.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// A response to a question that has a correct one.
struct JudgedAnswer {
  const GatheredAnswer* answer = nullptr;
  std::uint32_t felt = 0;  ///< as `chosen`, a word of GatheredAnswers
  std::uint32_t chosen = 0;
  bool right = false;
};

/// The responses that can be classified as correct or incorrect; a remark on the number of others.
std::vector<JudgedAnswer> judged_answers(const GatheredAnswers& gathered, AnalysisOutcome& outcome);

/// The pictures from which was chosen. The chance level of a trial is 1 divided by their number: a participant who does
/// not choose has not guessed, and is not correct either.
struct RecognitionPictures {
  std::vector<std::set<std::string>> of_list{};  ///< by option list of GatheredAnswers
  std::set<std::string> all{};
  bool always_the_same = true;
  std::vector<std::string> felt{};  ///< the textures, by name
};

RecognitionPictures pictures_in(const GatheredAnswers& gathered,
                                const std::vector<JudgedAnswer>& judged);

/// Correct responses and all classified responses of each of the gathered people, in their order.
std::vector<HitCount> responses_of_people(const GatheredAnswers& gathered,
                                          const std::vector<JudgedAnswer>& judged);

/// For the family `recognition`; a response that is not among the labels counts as missing.
TidyInput judged_trials_table(const GatheredAnswers& gathered,
                              const std::vector<JudgedAnswer>& judged,
                              const std::vector<std::string>& labels);
/// For the family `proportion`: a row per felt texture.
TidyInput judged_textures_table(const GatheredAnswers& gathered,
                                const std::vector<JudgedAnswer>& judged, std::size_t pictures);

}  // namespace asperity
