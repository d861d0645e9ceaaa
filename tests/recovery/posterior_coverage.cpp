// Draws observers, runs the procedure, and compares counts of covering intervals by chi-squared.

#include "tests/recovery/posterior_coverage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <thread>

#include "analysis/numbers/number_text.h"
#include "analysis/psychometric/function_table.h"
#include "tests/recovery/recovery.h"

namespace asperity {
namespace {

constexpr std::size_t kTrialsOfPosterior = 60;
constexpr double kLapseOfPosterior = 0.02;

struct PosteriorOutcome {
  double truth = 0.0;
  double rank = 0.0;
  ConfidenceInterval interval{};
};

/// A procedure with what all of its tracks share.
struct PreparedCell {
  PosteriorTrack track{};
  std::optional<double> beta{};
  LevelRule rule{};
  FunctionTable table;
};

PsychometricFunction true_function(const PreparedCell& cell, const Random& of_observer) {
  if (!cell.beta) {
    const auto count = static_cast<std::uint64_t>(cell.table.functions().size());
    Random which = of_observer.split("function");
    return cell.table.functions()[which.below(count)];
  }
  const double place = kAlphaSpread * (2.0 * of_observer.split("alpha").uniform() - 1.0);
  return {.shape = PsychometricShape::weibull,
          .alpha = std::pow(10.0, place),
          .beta = *cell.beta,
          .gamma = kGuess,
          .lambda = kLapseOfPosterior};
}

PosteriorOutcome posterior_outcome(const PreparedCell& cell, const Random& of_observer) {
  const PsychometricFunction f = true_function(cell, of_observer);
  const ThresholdPrior& prior = cell.track.prior;
  const double step = std::log(prior.thresholds.highest / prior.thresholds.lowest) /
                      static_cast<double>(prior.thresholds.count - 1);
  // A threshold of the prior represents the step about it; one of another observer is exact.
  const double part = of_observer.split("step").uniform() - 0.5;
  const double truth = std::log(f.inverse(prior.performance)) + (cell.beta ? 0.0 : part * step);
  Eigen::ArrayXd weights = cell.table.uniform();
  for (const LevelAnswer& answer : simulated_track(
           cell.rule, [&f](double level) { return f.value(level); }, of_observer.split("track"))) {
    cell.table.respond(weights, nearest_index(cell.track.grid, answer.level),
                       answer.outcome == LevelOutcome::correct);
  }
  const CredibleThreshold threshold = credible_threshold(
      prior, cell.table.functions(), {weights.data(), static_cast<std::size_t>(weights.size())},
      {.performance = prior.performance});
  PosteriorOutcome outcome{.truth = std::exp(truth), .interval = threshold.interval};
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double own =
        std::log(cell.table.functions()[static_cast<std::size_t>(i)].inverse(prior.performance));
    outcome.rank += weights[i] * std::clamp((truth - own) / step + 0.5, 0.0, 1.0);
  }
  return outcome;
}

}  // namespace

std::vector<PosteriorCell> posterior_cells() {
  const LevelGrid grid{.scale = LevelScale::log10, .lowest = 0.1, .highest = 10.0, .step = 0.025};
  const PosteriorTrack track{
      .grid = grid,
      .prior = {.performance = 0.75,
                .thresholds = {.lowest = grid.lowest, .highest = grid.highest, .count = 41}},
      .stop = {.trials = kTrialsOfPosterior}};
  std::vector<PosteriorCell> cells{};
  for (const std::optional<double> beta :
       {std::optional<double>{}, std::optional(1.3), std::optional(2.0), std::optional(3.5)}) {
    cells.push_back({"psi", Psi{.track = track}, beta});
    cells.push_back({"quest_plus", QuestPlus{.track = track}, beta});
  }
  return cells;
}

double PosteriorCoverage::chi_squared() const {
  const double expected = static_cast<double>(observers) / static_cast<double>(ranks.size());
  double sum = 0.0;
  for (const std::size_t count : ranks) {
    sum += std::pow(static_cast<double>(count) - expected, 2) / expected;
  }
  return sum;
}

PosteriorCoverage posterior_coverage(const PosteriorCell& cell, const PosteriorCoverageRun& run) {
  const PosteriorTrack& track = *posterior_track_of(cell.settings);
  const PreparedCell prepared{
      .track = track,
      .beta = cell.beta,
      .rule = level_rule(cell.settings),
      .table = FunctionTable(functions_of(track.prior, {}), 1, levels_of(track.grid))};
  std::vector<PosteriorOutcome> outcomes(run.observers);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < run.observers; i = next++) {
      outcomes[i] = posterior_outcome(
          prepared, Random(run.seed).split("posterior").split(static_cast<std::uint64_t>(i)));
    }
  };
  {
    std::vector<std::jthread> others{};
    for (std::size_t i = 1; i < run.jobs; ++i) others.emplace_back(work);
    work();
  }
  PosteriorCoverage coverage{.observers = run.observers,
                             .ranks = std::vector<std::size_t>(PosteriorCoverage::kRanks)};
  std::vector<double> ratios{};
  for (const PosteriorOutcome& outcome : outcomes) {
    const auto rank = static_cast<std::size_t>(outcome.rank * PosteriorCoverage::kRanks);
    ++coverage.ranks[std::min(rank, PosteriorCoverage::kRanks - 1)];
    coverage.below += outcome.interval.high < outcome.truth ? 1 : 0;
    coverage.above += outcome.interval.low > outcome.truth ? 1 : 0;
    ratios.push_back(outcome.interval.high / outcome.interval.low);
  }
  std::sort(ratios.begin(), ratios.end());
  coverage.ratio = ratios[ratios.size() / 2];
  return coverage;
}

std::string posterior_coverage_header() {
  return "procedure\tobservers\tbeta\ttrials\tbelow\tabove\tcovered\tmedian_ratio\tchi_squared";
}

std::string row_text(const PosteriorCell& cell, const PosteriorCoverage& coverage) {
  std::array<char, 160> numbers{};
  std::snprintf(numbers.data(), numbers.size(), "%zu\t%zu\t%zu\t%.4f\t%.3f\t%.2f",
                kTrialsOfPosterior, coverage.below, coverage.above, coverage.covered(),
                coverage.ratio, coverage.chi_squared());
  return std::string(cell.procedure) + '\t' + std::to_string(coverage.observers) + '\t' +
         (cell.beta ? number_text(*cell.beta) : "prior") + '\t' + numbers.data();
}

}  // namespace asperity
