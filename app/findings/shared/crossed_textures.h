// Tests whether a proportion generalises to other participants and textures.

#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// One response to a texture: correct, or a choice of the target.
struct TextureResponse {
  std::uint32_t person = 0;   ///< index of the participant
  std::uint32_t texture = 0;  ///< index of its word
  bool is_hit = false;
};

struct CrossedResponses {
  std::span<const TextureResponse> responses{};
  double chance = 0.5;
  Phrase proportion{};  ///< what is modelled: "the proportion correct"
  Phrase assumption{};  ///< about the responses; may be empty
};

/// Mixed logistic regression (family `glmm`) with participants and textures as crossed random intercepts.
/// Where one of their standard deviations is estimated as 0, a boundary estimate without standard errors, the model
/// without these intercepts has the same maximum; it is integrated numerically, and its test keeps the degrees of freedom of
/// the smaller sample. With fewer than five participants or three textures, fewer than ten responses of a kind, and for data
/// without a maximum, a status is reported instead of a number.
void ask_other_textures(const CrossedResponses& crossed, AnalysisOutcome& outcome);

/// Adds the finding that there is no such model, and why.
void add_no_crossed_model(const char* code, const std::string& reason, AnalysisOutcome& outcome);

}  // namespace asperity
