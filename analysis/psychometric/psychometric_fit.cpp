// Checks whether a maximum exists, fits, then adds goodness of fit, precision and the model with free lapses.

#include "analysis/psychometric/psychometric_fit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "analysis/numbers/tail_probabilities.h"
#include "analysis/psychometric/psychometric_maximum.h"

namespace asperity {
namespace {

// X² = Σ (k − n·p)²/(n·p·(1 − p)), p = ψ(x).
std::optional<double> pearson(const std::vector<PsychometricBlock>& blocks,
                              const PsychometricFunction& f) {
  double sum = 0.0;
  for (const PsychometricBlock& block : blocks) {
    const auto n = static_cast<double>(block.trials);
    const double p = f.value(block.x);
    const double residual = hits_of(block) - n * p;
    sum += residual * residual / (n * p * (1.0 - p));
  }
  return std::isfinite(sum) ? std::optional<double>(sum) : std::nullopt;
}

std::optional<PsychometricFit::FreeLapses> free_lapses(std::span<const PsychometricBlock> blocks,
                                                       const PsychometricQuestion& question,
                                                       double log_likelihood) {
  if (!question.model.lambda) {
    return std::nullopt;
  }
  PsychometricModel model = question.model;
  model.lambda.reset();
  model.greatest_lambda = std::max(model.greatest_lambda, *question.model.lambda);
  const PsychometricMaximum maximum = maximise_psychometric(blocks, model);
  return PsychometricFit::FreeLapses{
      .lambda = maximum.function.lambda,
      .alpha = maximum.function.alpha,
      .threshold = maximum.function.inverse(question.performance),
      .likelihood_ratio = std::max(0.0, 2.0 * (maximum.log_likelihood - log_likelihood))};
}

}  // namespace

PsychometricJudgement judge(std::span<const PsychometricBlock> all,
                            const PsychometricModel& model) {
  const std::vector<PsychometricBlock> blocks = answered_blocks(all, model);
  if (blocks.empty()) {
    return {.status = PsychometricStatus::no_data};
  }
  const auto every = [&](const auto& holds) {
    return std::all_of(blocks.begin(), blocks.end(), holds);
  };
  if (every([](const PsychometricBlock& b) { return misses_of(b) == 0.0; })) {
    return {.status = PsychometricStatus::all_correct};
  }
  if (every([](const PsychometricBlock& b) { return hits_of(b) == 0.0; })) {
    return {.status = PsychometricStatus::all_wrong};
  }
  struct CountOfLevel {
    double hits = 0.0;
    double trials = 0.0;
  };
  std::map<double, CountOfLevel> levels;
  for (const PsychometricBlock& block : blocks) {
    levels[block.x].hits += hits_of(block);
    levels[block.x].trials += static_cast<double>(block.trials);
  }
  const std::size_t different_levels = distinct_levels(blocks, model.shape).size();
  if (different_levels < 2) {
    return {.status = PsychometricStatus::one_level};
  }
  const std::size_t parameters = 2U + (model.gamma ? 0U : 1U) + (model.lambda ? 0U : 1U);
  // A level of 0 of a Weibull function, which the other levels do not count, determines γ where it is free.
  const std::size_t informative = model.gamma ? different_levels : levels.size();
  if (informative < parameters) {
    return {.status = PsychometricStatus::too_few_levels};
  }
  if (!model.gamma || *model.gamma != 0.0 || !model.lambda || *model.lambda != 0.0) {
    return {};
  }
  // Only incorrect responses below, only correct ones above, at most one level with both between them: the
  // likelihood grows with the slope without limit.
  std::optional<double> mixed;
  std::optional<double> last_incorrect;
  std::optional<double> first_correct;
  double before = 0.0;
  for (const auto& [x, count] : levels) {
    const double correct = count.hits / count.trials;
    if (correct < before) {
      return {};
    }
    before = correct;
    if (correct > 0.0 && correct < 1.0) {
      if (mixed) {
        return {};
      }
      mixed = x;
    } else if (correct == 0.0) {
      last_incorrect = x;
    } else if (!first_correct) {
      first_correct = x;
    }
  }
  if (mixed) {
    return {.status = PsychometricStatus::quasi_separated,
            .bracket = ConfidenceInterval{.low = *mixed, .high = *mixed}};
  }
  return {.status = PsychometricStatus::separated,
          .bracket = ConfidenceInterval{.low = *last_incorrect, .high = *first_correct}};
}

std::optional<PsychometricFit> fit_psychometric(std::span<const PsychometricBlock> blocks,
                                                const PsychometricQuestion& question) {
  if (judge(blocks, question.model).status != PsychometricStatus::ok) {
    throw std::invalid_argument(
        "blocks: these data have no maximum-likelihood estimate; call judge first, and fit only if "
        "its "
        "status is ok");
  }
  if (question.model.slope) {
    throw std::invalid_argument(
        "slope has limits, which leave no standard error; use maximise_psychometric");
  }
  normal_limit(question.confidence);  // throws for a confidence outside (0, 1)
  const PsychometricLikelihood data(blocks, question.model);
  PsychometricStarts starts{};
  const CurveSolution solution = greatest_likelihood(data, starts);
  if (!is_increasing(data, solution.maximum)) {
    return std::nullopt;
  }
  PsychometricFit fit;
  fit.function = data.function(solution.maximum.at);
  fit.log_likelihood = solution.maximum.value;
  fit.beta_at_bound = solution.at_bound.beta;
  fit.gamma_at_bound = solution.at_bound.gamma;
  fit.lambda_at_bound = solution.at_bound.lambda;
  const auto parameters = static_cast<double>(places_of(solution.free).size());
  fit.deviance = 2.0 * (data.saturated() - fit.log_likelihood);
  fit.deviance_df = static_cast<double>(data.blocks().size()) - parameters;
  fit.pearson = pearson(data.blocks(), fit.function);
  fit.deviance_p = upper_tail(ChiSquaredStatistic{.value = fit.deviance, .df = fit.deviance_df});
  fit.threshold = fit.function.inverse(question.performance);
  fit.free_lapses = free_lapses(blocks, question, fit.log_likelihood);
  if (fit.pearson && fit.deviance_df > 0.0) {
    fit.dispersion = *fit.pearson / fit.deviance_df;
  }
  if (fit.beta_at_bound) {
    return fit;
  }
  fit.precision = delta_method_precision(data, solution, question);
  if (!fit.precision) {
    return fit;
  }
  if (fit.dispersion) {
    fit.overdispersed = overdispersed_precision(*fit.precision, fit.function, question,
                                                {.value = *fit.dispersion, .df = fit.deviance_df});
  }
  const ProfileInterval profile =
      profile_interval(data, solution, *fit.precision, question.confidence);
  fit.profile_low = profile.low;
  fit.profile_high = profile.high;
  return fit;
}

}  // namespace asperity
