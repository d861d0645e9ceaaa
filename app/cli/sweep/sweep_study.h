// The estimates of a study with which a sweep is compared.

#pragma once

#include <string>
#include <vector>

#include "app/cli/sweep/sweep_options.h"
#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

namespace asperity {

/// The figure next to whose estimates a sweep is drawn.
struct StudyBeside {
  Figure estimates{};
  std::vector<std::string> conditions{};  ///< by the levels of the sweep
  AnswerGroup group = AnswerGroup::people;
};

/// The first estimates of roughness of the study of --beside in the order of `analyze`: those of human participants
/// before others. Prints which they are, and warnings.
///
/// Errors: std::runtime_error for a study without such estimates, or with several experiments among which --protocol
/// does not choose.
StudyBeside study_beside(const SweepOptions& options, const ModelRegistry& models);

}  // namespace asperity
