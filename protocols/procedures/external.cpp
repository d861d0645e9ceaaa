// Presents the level that the program states, and checks the example as constant stimuli.

#include "protocols/procedures/external.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/numbers/number_text.h"
#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

const External& external_of(const ProcedureSettings& settings) {
  return std::get<External>(settings);
}

/// The example of levels: as many whole repetitions as the trials need.
ConstantStimuli example_of(const External& method) {
  const std::size_t levels = std::max<std::size_t>(method.levels.size(), 1);
  return {.levels = method.levels, .repetitions = (method.trials + levels - 1) / levels};
}

void check_external(const ProcedureSettings& settings, ProcedureProblems& problems) {
  const External& method = external_of(settings);
  ConstantStimuli levels = example_of(method);
  levels.repetitions = 1;
  for (const ProcedureProblem& problem : problems_of(levels)) {
    problems.report(problem.setting, problem.message);
  }
  if (method.trials == 0 || method.trials > kMostTrials) {
    problems.report("stop.trials",
                    phrase("Protocols",
                           "a program must not be able to continue a track without end; state the "
                           "maximum number of trials of a track, between 1 and %1")
                        .with(std::to_string(kMostTrials)));
  }
  if (!(method.answer_within_s >= 1.0 && method.answer_within_s <= 600.0)) {
    problems.report(
        "answer_within_s",
        phrase("Protocols",
               "the program cannot have %1 s for its answer; state between 1 and 600 seconds")
            .with(number_text(method.answer_within_s)));
  }
}

LevelRule example_rule(const ProcedureSettings& settings) {
  const External& method = external_of(settings);
  return [rule = constant_stimuli().rule(example_of(method)), trials = method.trials](
             std::span<const LevelAnswer> answers, const Random& of_track) -> NextStep {
    if (answers.size() >= trials) return TrackEnd::trials;
    return rule(answers, of_track);
  };
}

constexpr Procedure kExternal{
    .id = "external",
    .meaning = "the levels that a program of the laboratory states (run --external)",
    .check = check_external,
    .levels = [](const ProcedureSettings& settings) { return external_of(settings).levels; },
    .rule = example_rule,
    .most_trials = [](const ProcedureSettings& settings) { return external_of(settings).trials; },
    .has_fixed_length = [](const ProcedureSettings&) { return false; },
    .target = [](const ProcedureSettings&) -> std::optional<double> { return std::nullopt; },
    .simulated_tracks = 1};

}  // namespace

std::optional<double> presented_level(const External& method, double stated) {
  constexpr double kRoundingOfRange = 1e-9;
  const std::vector<double>& levels = method.levels;
  if (levels.empty() || !std::isfinite(stated)) return std::nullopt;
  const double margin = kRoundingOfRange * (levels.back() - levels.front());
  if (stated < levels.front() - margin || stated > levels.back() + margin) return std::nullopt;
  return *std::min_element(levels.begin(), levels.end(), [stated](double one, double other) {
    return std::abs(one - stated) < std::abs(other - stated);
  });
}

const Procedure& external() { return kExternal; }

}  // namespace asperity
