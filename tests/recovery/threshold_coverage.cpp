// Draws observers, places trials adaptively, fits them, and counts the intervals that contain the threshold.

#include "tests/recovery/threshold_coverage.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <optional>
#include <span>
#include <thread>

#include "analysis/numbers/number_text.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_thresholds.h"
#include "app/findings/outcome/found_numbers.h"
#include "tests/recovery/recovery.h"

namespace asperity {
namespace {

const LevelGrid kGridOfCoverage{
    .scale = LevelScale::log10, .lowest = 0.1, .highest = 10.0, .step = 0.025};
constexpr std::size_t kFirstStart = 64;   // 10^0.6
constexpr std::size_t kSecondStart = 52;  // 10^0.3
constexpr double kLapseOfCoverage = 0.02;

struct ObserverOutcome {
  bool has_threshold = false;
  std::optional<ConfidenceInterval> interval{};
  std::size_t without = 0;
  std::optional<ConfidenceInterval> delta{};
  double truth = 0.0;
};

/// Levels are values of the parameter, and the standard is 0.
DiscriminationTask task_of_coverage() {
  Dimension varied{};
  varied.standard = 0.0;
  return {.name = "coverage", .is_performance = true, .varied = varied};
}

std::optional<ConfidenceInterval> interval_of_jnd(const DiscriminationFit& fit) {
  const FoundNumbers found(fit.thresholds);
  const Finding* const jnd = found.find("jnd", "observer");
  if (jnd == nullptr || !jnd->value || !jnd->low || !jnd->high) return std::nullopt;
  return ConfidenceInterval{.low = *jnd->low, .high = *jnd->high};
}

ObserverOutcome outcome_of(const CoverageCell& cell, const Random& of_observer) {
  const double alpha =
      std::pow(10.0, kAlphaSpread * (2.0 * of_observer.split("alpha").uniform() - 1.0));
  const PsychometricFunction observer{.shape = PsychometricShape::weibull,
                                      .alpha = alpha,
                                      .beta = cell.beta,
                                      .gamma = kGuess,
                                      .lambda = kLapseOfCoverage};
  const DiscriminationTask task = task_of_coverage();
  PlacedTrials placed{};
  for (const ProcedureSettings& settings : cell.tracks) {
    placed.tracks.push_back({.settings = settings, .levels = task.varied});
  }
  const std::vector<PsychometricBlock> blocks =
      run_again(task, placed, observer, of_observer.split("data"));
  DiscriminationData data{.key = "observer"};
  for (const PsychometricBlock& block : blocks) data.hits[block.x] = {block.hits, block.trials};
  ObserverOutcome outcome{.truth = observer.inverse(kCommonPerformance)};
  outcome.delta = interval_of_jnd(fit_discrimination(task, std::span(&data, 1)));
  data.by_procedure =
      true;  // and without `placed`: the interval of another proportion is not needed
  const DiscriminationFit fit = fit_discrimination(task, std::span(&data, 1));
  outcome.has_threshold = FoundNumbers(fit.thresholds).value("jnd", "observer").has_value();
  if (!outcome.has_threshold) return outcome;
  const auto repeated = procedure_interval(task, blocks, placed, kCommonPerformance);
  if (!repeated) return outcome;
  outcome.interval = repeated->threshold;
  outcome.without = repeated->without;
  return outcome;
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

}  // namespace

std::size_t CoverageCell::trials() const {
  std::size_t sum = 0;
  for (const ProcedureSettings& track : tracks) sum += procedure_of(track).most_trials(track);
  return sum;
}

std::vector<CoverageCell> coverage_cells() {
  const StepList steps{0.2, 0.1, 0.1, 0.1, 0.05};
  const auto transformed = [&](std::size_t down, std::size_t trials, std::size_t start) {
    return TransformedUpDown{.track = {.grid = kGridOfCoverage,
                                       .start = level_of(kGridOfCoverage, start),
                                       .rule = {.up = 1, .down = down},
                                       .steps_up = steps,
                                       .steps_down = steps,
                                       .stop = {.trials = trials}}};
  };
  const WeightedUpDown weighted{.grid = kGridOfCoverage,
                                .start = level_of(kGridOfCoverage, kFirstStart),
                                .target = 0.75,
                                .steps_down = {0.1, 0.1, 0.1, 0.1, 0.05},
                                .stop = {.trials = 60}};
  std::vector<CoverageCell> cells{};
  for (const double beta : {1.3, 3.5}) {
    cells.push_back({"3-down/1-up, 60 trials", {transformed(3, 60, kFirstStart)}, beta});
    cells.push_back({"3-down/1-up, 2 × 40 trials",
                     {transformed(3, 40, kFirstStart), transformed(3, 40, kSecondStart)},
                     beta});
    cells.push_back({"2-down/1-up, 60 trials", {transformed(2, 60, kFirstStart)}, beta});
    cells.push_back({"weighted up-down, 75 %, 60 trials", {weighted}, beta});
  }
  return cells;
}

IntervalCoverage interval_coverage(const CoverageCell& cell, const IntervalCoverageRun& run) {
  std::vector<ObserverOutcome> outcomes(run.observers);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < run.observers; i = next++) {
      outcomes[i] =
          outcome_of(cell, Random(run.seed).split("coverage").split(static_cast<std::uint64_t>(i)));
    }
  };
  {
    std::vector<std::jthread> others{};
    for (std::size_t i = 1; i < run.jobs; ++i) others.emplace_back(work);
    work();
  }
  IntervalCoverage coverage{.observers = run.observers};
  std::vector<double> ratios{};
  for (const ObserverOutcome& outcome : outcomes) {
    if (outcome.delta) {
      ++coverage.of_delta;
      coverage.delta_below += outcome.delta->high < outcome.truth ? 1 : 0;
      coverage.delta_above += outcome.delta->low > outcome.truth ? 1 : 0;
    }
    coverage.thresholds += outcome.has_threshold ? 1 : 0;
    if (!outcome.interval) continue;
    ++coverage.intervals;
    coverage.below += outcome.interval->high < outcome.truth ? 1 : 0;
    coverage.above += outcome.interval->low > outcome.truth ? 1 : 0;
    coverage.without += outcome.without;
    ratios.push_back(outcome.interval->high / outcome.interval->low);
  }
  coverage.ratio = median_of(std::move(ratios));
  return coverage;
}

std::string interval_coverage_header() {
  return "procedure\tbeta\tlapse\ttrials\tobservers\tthresholds\tintervals\tbelow\tabove\tcovered\t"
         "median_ratio\twithout\tdelta_intervals\tdelta_covered";
}

std::string row_text(const CoverageCell& cell, const IntervalCoverage& coverage) {
  const auto covered = [](std::size_t of, std::size_t outside) {
    return of == 0 ? 0.0 : 1.0 - static_cast<double>(outside) / static_cast<double>(of);
  };
  std::array<char, 160> numbers{};
  std::snprintf(
      numbers.data(), numbers.size(), "%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%.4f\t%.3f\t%.5f\t%zu\t%.4f",
      cell.trials(), coverage.observers, coverage.thresholds, coverage.intervals, coverage.below,
      coverage.above, covered(coverage.intervals, coverage.below + coverage.above), coverage.ratio,
      coverage.intervals == 0
          ? 0.0
          : static_cast<double>(coverage.without) /
                static_cast<double>(coverage.intervals * kRepetitionsOfProcedures),
      coverage.of_delta, covered(coverage.of_delta, coverage.delta_below + coverage.delta_above));
  return std::string(cell.procedure) + '\t' + number_text(cell.beta) + '\t' +
         number_text(kLapseOfCoverage) + '\t' + numbers.data();
}

}  // namespace asperity
