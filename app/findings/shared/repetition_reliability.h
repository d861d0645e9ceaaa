// Computes the reliability of participants' results over the repetitions of an experiment.

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// The result of one trial, or of one response: a proportion.
struct RepeatedScore {
  std::uint32_t person = 0;  ///< index of the participant
  std::uint32_t column = 0;  ///< as GatheredAnswer::column
  int repetition = 1;        ///< as planned
  double score = 0.0;
};
struct RepeatedScores {
  std::span<const RepeatedScore> scores{};
  Phrase name{};  ///< "the participants' proportions correct"
};

/// Intraclass correlations of the participants' mean scores in each repetition: a level of the
/// factor `column`, or, without that factor, a repetition of the block. Adds no question where
/// there are not two repetitions and two participants with both; only a status where `repetitions_are_textures`.
void ask_reliability(const GatheredAnswers& gathered, const RepeatedScores& repeated,
                     AnalysisOutcome& outcome);

/// Whether each repetition presents other textures than the others: then repetitions and textures cannot be distinguished.
bool repetitions_are_textures(const GatheredAnswers& gathered);

bool has_repetitions(const GatheredAnswers& gathered);
/// Adds the finding that there is no reliability, and why.
void add_no_reliability(const char* code, const char* reason, AnalysisOutcome& outcome);

/// A response to one surface, which is one of each participant's targets.
struct RepeatedEstimate {
  std::uint32_t person = 0;
  std::string surface{};
  int repetition = 1;
  double value = 0.0;  ///< the logarithm of an estimate, or a rating
};

/// The mean over the participants of individual intraclass correlations ICC3: targets are the
/// surfaces, raters the repetitions. A participant's scale adds a constant to all their logarithms,
/// so that a correlation over all participants together would reflect their scales. Adds no
/// question where no participant has two surfaces with two repetitions.
void ask_reliability_of_estimates(const GatheredAnswers& gathered,
                                  std::span<const RepeatedEstimate> estimates,
                                  AnalysisOutcome& outcome);
/// The same of the ratings on a scale, without logarithms.
void ask_reliability_of_ratings(const GatheredAnswers& gathered, const std::string& scale,
                                std::span<const RepeatedEstimate> ratings,
                                AnalysisOutcome& outcome);

}  // namespace asperity
