// Implements the checks of counts and models before a fit.

#include "analysis/psychometric/psychometric_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/numbers/number_text.h"

namespace asperity {

bool is_impossible(const PsychometricBlock& block, const PsychometricModel& model) {
  return is_weibull(model.shape) && block.x == 0.0 && hits_of(block) > 0.0 && model.gamma == 0.0;
}

std::vector<PsychometricBlock> answered_blocks(std::span<const PsychometricBlock> blocks,
                                               const PsychometricModel& model) {
  const auto refuse_rate = [](const std::optional<double>& rate, const char* name) {
    if (rate && !(*rate >= 0.0 && *rate < 1.0)) {
      throw std::invalid_argument(std::string(name) + " is " + number_text(*rate) +
                                  "; it must be at least 0 and below 1");
    }
  };
  refuse_rate(model.gamma, "gamma");
  refuse_rate(model.lambda, "lambda");
  refuse_rate(model.greatest_lambda, "greatest_lambda");
  if (model.gamma.value_or(0.0) + model.lambda.value_or(0.0) >= 1.0) {
    throw std::invalid_argument(
        "gamma and lambda have a sum of at least 1; their sum must be below 1");
  }
  std::vector<PsychometricBlock> kept;
  for (const PsychometricBlock& block : blocks) {
    if (!(block.guessed_hits >= 0.0) ||
        (block.hits <= block.trials && !(misses_of(block) >= 0.0))) {
      throw std::invalid_argument("guessed_hits is " + number_text(block.guessed_hits) +
                                  "; it must be at least 0 and not exceed the trials without hits");
    }
    if (block.hits > block.trials) {
      throw std::invalid_argument("hits is " + std::to_string(block.hits) + " and trials is " +
                                  std::to_string(block.trials) + "; hits must not exceed trials");
    }
    if (!std::isfinite(block.x) || (is_weibull(model.shape) && block.x < 0.0)) {
      throw std::invalid_argument("x is " + number_text(block.x) +
                                  "; it must be finite, and at least 0 for a weibull");
    }
    if (is_impossible(block, model)) {
      throw std::invalid_argument("hits is " + std::to_string(block.hits) +
                                  " at x = 0; it must be 0 there for a weibull with gamma 0");
    }
    if (block.trials > 0) {
      kept.push_back(block);
    }
  }
  return kept;
}

std::vector<double> distinct_levels(std::span<const PsychometricBlock> blocks,
                                    PsychometricShape shape) {
  std::vector<double> levels;
  for (const PsychometricBlock& block : blocks) {
    if (!is_weibull(shape)) {
      levels.push_back(block.x);
    } else if (block.x > 0.0) {
      levels.push_back(std::log(block.x));
    }
  }
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

}  // namespace asperity
