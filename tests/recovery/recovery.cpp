// Runs tracks of simulated observers, and compares their errors with the bound of the Fisher information.

#include "tests/recovery/recovery.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <map>
#include <span>
#include <thread>

#include <Eigen/Core>
#include <Eigen/LU>

#include "analysis/numbers/number_text.h"
#include "analysis/psychometric/function_table.h"
#include "analysis/psychometric/psychometric_maximum.h"
#include "analysis/psychometric/staircase.h"

namespace asperity {
namespace {

const LevelGrid kGrid{.scale = LevelScale::log10, .lowest = 0.1, .highest = 10.0, .step = 0.025};
constexpr double kLowest_log10 = -1.0;
constexpr double kHighest_log10 = 1.0;
constexpr std::size_t kStart = 64;  // 10^0.6
constexpr std::size_t kDiscarded = 4;

PsychometricFunction function_of(const RecoveryObserver& observer, double alpha) {
  return {.shape = PsychometricShape::gumbel,
          .alpha = alpha,
          .beta = observer.beta,
          .gamma = kGuess,
          .lambda = observer.lapse};
}

/// Guesses are 2·(1 − ψ) of the responses, and s of them are replaced by "cannot tell".
LevelOutcome response_at(double p, double s, Random& random) {
  const double half_unsure = s * (1.0 - p);
  const double drawn = random.uniform();
  if (drawn < p - half_unsure) return LevelOutcome::correct;
  return drawn < p + half_unsure ? LevelOutcome::unsure : LevelOutcome::incorrect;
}

/// The Fisher information of one trial at x about α and β. With a proportion s of guesses that are replaced by "cannot tell",
/// hits have the probability h = ψ − s·(1 − ψ), so that dh/dψ = 1 + s; of the other responses, the
/// proportion of "cannot tell" does not depend on ψ and has no information. The information about ψ is (1 + s)²/(h·(1 − h)) with 1 − h = (1 + s)·(1 − ψ).
Eigen::Matrix2d information(const PsychometricFunction& f, double x, double s) {
  const StandardCurve curve = standard_curve(f.shape, f.beta * (x - f.alpha));
  const double rise = (1.0 - f.gamma - f.lambda) * curve.d1;
  const Eigen::Vector2d gradient(-rise * f.beta, rise * (x - f.alpha));
  // ψ and 1 − ψ without cancellation; where nothing is left of 1 − ψ, a trial has no information.
  const double p = f.gamma + (1.0 - f.gamma - f.lambda) * curve.F;
  const double q = f.lambda + (1.0 - f.gamma - f.lambda) * curve.Q;
  if (!(q > 0.0)) return Eigen::Matrix2d::Zero();
  return gradient * gradient.transpose() * (1.0 + s) / ((p - s * q) * q);
}

double bound_of(const Eigen::Matrix2d& information, const PsychometricFunction& f,
                double performance) {
  // x = α + t/β at the performance, t depending on γ and λ alone.
  const double t = f.beta * (f.inverse(performance) - f.alpha);
  const Eigen::Vector2d gradient(1.0, -t / (f.beta * f.beta));
  return std::sqrt(gradient.dot(information.inverse() * gradient));
}

std::vector<PsychometricBlock> counts_of(std::span<const LevelAnswer> answers) {
  std::map<double, PsychometricBlock> by_level{};
  for (const LevelAnswer& answer : answers) {
    PsychometricBlock& block = by_level[answer.level];
    block.x = std::log10(answer.level);
    ++block.trials;
    if (answer.outcome == LevelOutcome::correct) ++block.hits;
    if (answer.outcome == LevelOutcome::unsure) block.guessed_hits += kGuess;
  }
  std::vector<PsychometricBlock> blocks{};
  for (const auto& [level, block] : by_level) blocks.push_back(block);
  return blocks;
}

/// Empty for a single level, and where no increasing function is more likely than a constant.
std::optional<PsychometricFunction> fit_of(const std::vector<PsychometricBlock>& counts,
                                           const std::optional<SlopeRange>& slope) {
  if (counts.size() < 2) return std::nullopt;
  const PsychometricMaximum maximum =
      maximise_psychometric(counts, {.shape = PsychometricShape::gumbel,
                                     .gamma = kGuess,
                                     .lambda = kAssumedLapse,
                                     .slope = slope});
  return maximum.increases ? std::optional(maximum.function) : std::nullopt;
}

/// log10 of the mean of the reversals; a reversal is found by the directions of the moves.
std::optional<double> reversal_estimate(const UpDownRule& rule,
                                        std::span<const LevelAnswer> answers) {
  UpDownRun run(rule);
  StaircaseTrack track{};
  for (const LevelAnswer& answer : answers) {
    track.trials.push_back(
        {.level = answer.level,
         .is_reversal = run.respond(answer.outcome == LevelOutcome::correct).is_reversal});
  }
  const auto mean = mean_of_reversals(track, {.scale = LevelScale::log10, .discard = kDiscarded});
  return mean ? std::optional(std::log10(mean->mean)) : std::nullopt;
}

/// Empty for constant stimuli.
std::optional<UpDownRule> rule_of(const ProcedureSettings& settings) {
  if (const auto* method = std::get_if<TransformedUpDown>(&settings)) return method->track.rule;
  if (std::holds_alternative<WeightedUpDown>(settings)) return UpDownRule{};
  return std::nullopt;
}

struct Question {
  RecoveryEstimate estimate = RecoveryEstimate::fit_common;
  double performance = kCommonPerformance;
};

std::vector<Question> questions_of(const ProcedureSettings& settings,
                                   const RecoveryObserver& observer) {
  std::vector<Question> questions{{}};
  if (observer.lapse == kAssumedLapse) {
    questions.push_back({.estimate = RecoveryEstimate::free_common});
  }
  if (const auto target = procedure_of(settings).target(settings)) {
    questions.push_back({.estimate = RecoveryEstimate::fit_target, .performance = *target});
    if (posterior_track_of(settings) != nullptr) {
      questions.push_back({.estimate = RecoveryEstimate::posterior_common});
      questions.push_back({.estimate = RecoveryEstimate::posterior_target, .performance = *target});
    } else {
      questions.push_back({.estimate = RecoveryEstimate::reversals, .performance = *target});
    }
  }
  return questions;
}

/// A procedure with what all tracks share.
struct PreparedRecovery {
  const RecoveryProcedure* procedure = nullptr;
  LevelRule rule{};
  std::vector<Question> questions{};
  /// Of psi and QUEST+: the functions of the prior. Levels have no part in it.
  std::optional<FunctionTable> functions{};
};

PreparedRecovery prepared_recovery(const RecoveryProcedure& procedure,
                                   const RecoveryObserver& observer) {
  PreparedRecovery prepared{.procedure = &procedure,
                            .rule = level_rule(procedure.settings),
                            .questions = questions_of(procedure.settings, observer)};
  if (const PosteriorTrack* const track = posterior_track_of(procedure.settings)) {
    prepared.functions.emplace(functions_of(track->prior, {}), 1, levels_of(track->grid));
  }
  return prepared;
}

/// log10 of the posterior mean after each answer, at a performance.
double posterior_estimate(const PreparedRecovery& prepared, std::span<const LevelAnswer> answers,
                          double performance) {
  const PosteriorTrack& track = *posterior_track_of(prepared.procedure->settings);
  Eigen::ArrayXd weights = prepared.functions->uniform();
  for (const LevelAnswer& answer : answers) {
    prepared.functions->respond(weights, nearest_index(track.grid, answer.level),
                                answer.outcome == LevelOutcome::correct);
  }
  const CredibleThreshold threshold = credible_threshold(
      track.prior, prepared.functions->functions(),
      {weights.data(), static_cast<std::size_t>(weights.size())}, {.performance = performance});
  return std::log10(threshold.value);
}

/// One track after one number of trials.
struct Evaluation {
  std::vector<std::optional<double>> errors{};  ///< by question
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
};

std::vector<Evaluation> evaluated_track(const PreparedRecovery& prepared,
                                        const RecoveryObserver& observer,
                                        const Random& of_observer) {
  const double alpha = kAlphaSpread * (2.0 * of_observer.split("alpha").uniform() - 1.0);
  const PsychometricFunction f = function_of(observer, alpha);
  const double unsure = prepared.procedure->unsure;
  const std::vector<LevelAnswer> answers = simulated_track(
      prepared.rule,
      [&f, unsure](double level, Random& random) {
        return response_at(f.value(std::log10(level)), unsure, random);
      },
      of_observer.split("track"));
  const std::optional<UpDownRule> rule = rule_of(prepared.procedure->settings);
  std::vector<Evaluation> evaluations{};
  for (const std::size_t trials : recovery_trials()) {
    const auto prefix = std::span(answers).first(trials);
    Evaluation evaluation{};
    for (const LevelAnswer& answer : prefix) {
      evaluation.information += information(f, std::log10(answer.level), unsure);
    }
    const std::vector<PsychometricBlock> counts = counts_of(prefix);
    const auto within_limits = fit_of(counts, kSlopeLimits);
    for (const Question& question : prepared.questions) {
      std::optional<double> estimate{};
      if (question.estimate == RecoveryEstimate::reversals) {
        estimate = reversal_estimate(*rule, prefix);
      } else if (question.estimate == RecoveryEstimate::posterior_common ||
                 question.estimate == RecoveryEstimate::posterior_target) {
        estimate = posterior_estimate(prepared, prefix, question.performance);
      } else {
        const bool is_free = question.estimate == RecoveryEstimate::free_common;
        const auto function = is_free ? fit_of(counts, std::nullopt) : within_limits;
        if (function) {
          estimate =
              std::clamp(function->inverse(question.performance), kLowest_log10, kHighest_log10);
        }
      }
      evaluation.errors.push_back(
          estimate ? std::optional(*estimate - f.inverse(question.performance)) : std::nullopt);
    }
    evaluations.push_back(std::move(evaluation));
  }
  return evaluations;
}

}  // namespace

std::vector<std::size_t> recovery_trials() { return {40, 60, 80, 120, 240}; }

std::vector<RecoveryObserver> recovery_observers() {
  std::vector<RecoveryObserver> all{};
  for (const double beta : {1.3, 2.0, 3.5}) {
    for (const double lapse : {0.0, 0.02, 0.05}) all.push_back({.beta = beta, .lapse = lapse});
  }
  return all;
}

std::vector<RecoveryObserver> bayesian_recovery_observers() {
  std::vector<RecoveryObserver> all{};
  for (const double beta : {1.3, 2.0, 3.5}) all.push_back({.beta = beta, .lapse = kAssumedLapse});
  return all;
}

std::vector<RecoveryProcedure> recovery_procedures() {
  const std::size_t trials = recovery_trials().back();
  const std::vector<double> constant{level_of(kGrid, 24), level_of(kGrid, 32), level_of(kGrid, 40),
                                     level_of(kGrid, 48), level_of(kGrid, 56)};
  const auto transformed = [trials](std::size_t down, StepList up_steps, StepList down_steps) {
    return TransformedUpDown{.track = {.grid = kGrid,
                                       .start = level_of(kGrid, kStart),
                                       .rule = {.up = 1, .down = down},
                                       .steps_up = std::move(up_steps),
                                       .steps_down = std::move(down_steps),
                                       .stop = {.trials = trials}}};
  };
  // Large steps up to the fourth reversal: an early lapse or guess would otherwise leave a track with small steps far
  // from the threshold.
  const StepList equal{0.2, 0.1, 0.1, 0.1, 0.05};
  const WeightedUpDown weighted{.grid = kGrid,
                                .start = level_of(kGrid, kStart),
                                .target = 0.75,
                                .steps_down = {0.1, 0.1, 0.1, 0.1, 0.05},
                                .stop = {.trials = trials}};
  WeightedUpDown unforced = weighted;
  unforced.unforced_alternatives = 2;
  return {
      {.name = "constant",
       .meaning = "constant stimuli at −0.4, −0.2, 0, 0.2 and 0.4",
       .settings = ConstantStimuli{.levels = constant, .repetitions = trials / constant.size()}},
      {.name = "1u2d",
       .meaning = "2-down/1-up, steps 0.2, from the first reversal 0.1, from the fourth 0.05",
       .settings = transformed(2, equal, equal)},
      {.name = "1u3d",
       .meaning = "3-down/1-up, the same steps",
       .settings = transformed(3, equal, equal)},
      {.name = "1u3d_unequal",
       .meaning = "3-down/1-up, steps up 0.2, from the first reversal 0.1, down 0.75 times these",
       .settings = transformed(3, {0.2, 0.1}, {0.15, 0.075})},
      {.name = "weighted_75",
       .meaning = "weighted up-down for 75 %, steps down 0.1, from the fourth reversal 0.05, up 3 "
                  "times these",
       .settings = weighted},
      {.name = "unforced_75",
       .meaning = "the same steps, after \"cannot tell\" up by one step down; an observer who "
                  "would guess responds \"cannot tell\" with the probability ½",
       .settings = unforced,
       .unsure = 0.5}};
}

std::vector<RecoveryProcedure> bayesian_recovery_procedures() {
  const PosteriorTrack posterior{
      .grid = kGrid,
      .prior = {.performance = 0.8,
                .thresholds = {.lowest = kGrid.lowest, .highest = kGrid.highest, .count = 41}},
      .stop = {.trials = recovery_trials().back()}};
  return {{.name = "psi",
           .meaning =
               "psi with slope and lapse rate marginalised, threshold at 80 %: 41 thresholds from "
               "−1 to 1, 8 slopes from 1 to 8, lapse rates 0, 2, 4 and 6 %",
           .settings = Psi{.track = posterior}},
          {.name = "quest_plus",
           .meaning = "QUEST+, the same thresholds, slopes and lapse rates",
           .settings = QuestPlus{.track = posterior}}};
}

std::string_view name_of(RecoveryEstimate estimate) noexcept {
  switch (estimate) {
    case RecoveryEstimate::fit_common:
      return "fit_75";
    case RecoveryEstimate::free_common:
      return "free_fit_75";
    case RecoveryEstimate::fit_target:
      return "fit_target";
    case RecoveryEstimate::posterior_common:
      return "posterior_75";
    case RecoveryEstimate::posterior_target:
      return "posterior_target";
    case RecoveryEstimate::reversals:
      return "reversals";
  }
  return "";
}

std::vector<RecoveryRow> recovery_rows(const RecoveryProcedure& procedure,
                                       const RecoveryObserver& observer, const RecoveryRun& run) {
  const PreparedRecovery prepared = prepared_recovery(procedure, observer);
  std::vector<std::vector<Evaluation>> tracks(run.observers);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < run.observers; i = next++) {
      const Random of_observer = Random(run.seed).split(static_cast<std::uint64_t>(i));
      tracks[i] = evaluated_track(prepared, observer, of_observer);
    }
  };
  {
    std::vector<std::jthread> others{};
    for (std::size_t i = 1; i < run.jobs; ++i) others.emplace_back(work);
    work();
  }

  // Sums in the order of the observers: the same for any number of jobs.
  const std::vector<Question>& questions = prepared.questions;
  const std::vector<std::size_t> trials = recovery_trials();
  std::vector<RecoveryRow> rows{};
  for (std::size_t question = 0; question < questions.size(); ++question) {
    for (std::size_t length = 0; length < trials.size(); ++length) {
      RecoveryRow row{.procedure = std::string(procedure.name),
                      .estimate = questions[question].estimate,
                      .observer = observer,
                      .trials = trials[length],
                      .observers = run.observers};
      double sum = 0.0;
      double squares = 0.0;
      Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
      for (const std::vector<Evaluation>& track : tracks) {
        information += track[length].information;
        const std::optional<double>& error = track[length].errors[question];
        if (!error) {
          ++row.without;
          continue;
        }
        sum += *error;
        squares += *error * *error;
      }
      const double estimated = static_cast<double>(run.observers - row.without);
      row.bias = sum / estimated;
      row.rmse = std::sqrt(squares / estimated);
      row.bound = bound_of(information / static_cast<double>(run.observers),
                           function_of(observer, 0.0), questions[question].performance);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

std::string recovery_header() {
  return "procedure\testimate\tbeta\tlapse\ttrials\tobservers\twithout\tbias_log10\trmse_log10\t"
         "bound_log10";
}

std::string row_text(const RecoveryRow& row) {
  std::array<char, 64> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "%.6f\t%.6f\t%.6f", row.bias, row.rmse, row.bound);
  return row.procedure + '\t' + std::string(name_of(row.estimate)) + '\t' +
         number_text(row.observer.beta) + '\t' + number_text(row.observer.lapse) + '\t' +
         std::to_string(row.trials) + '\t' + std::to_string(row.observers) + '\t' +
         std::to_string(row.without) + '\t' + numbers.data();
}

}  // namespace asperity
