// Checks levels and repetitions, and states the next level by the answers so far.

#include "protocols/procedures/constant_stimuli.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "analysis/numbers/number_text.h"
#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

const ConstantStimuli& of(const ProcedureSettings& settings) {
  return std::get<ConstantStimuli>(settings);
}

void check_constant(const ProcedureSettings& settings, ProcedureProblems& problems) {
  const ConstantStimuli& method = of(settings);
  if (method.levels.empty()) {
    problems.report("levels",
                    phrase("Protocols",
                           "there is no level; state at least one, better five to nine around the "
                           "expected threshold"));
  }
  if (method.levels.size() > kMostLevels) {
    problems.report("levels", phrase("Protocols", "there are more than %1 levels; remove some")
                                  .with(std::to_string(kMostLevels)));
  }
  for (std::size_t i = 0; i < method.levels.size(); ++i) {
    if (!std::isfinite(method.levels[i])) {
      problems.report("levels",
                      phrase("Protocols", "level %1 is not a finite number; correct or remove it")
                          .with(std::to_string(i + 1)));
      return;
    }
    if (i == 0 || method.levels[i] > method.levels[i - 1]) continue;
    problems.report("levels",
                    phrase("Protocols",
                           "the level %1 follows %2; list the levels in ascending order, each once")
                        .with(number_text(method.levels[i]), number_text(method.levels[i - 1])));
    return;
  }
  if (method.repetitions == 0) {
    problems.report("repetitions",
                    phrase("Protocols", "no level is presented; set the repetitions to 1 or more"));
  } else if (method.repetitions > kMostTrials / std::max<std::size_t>(method.levels.size(), 1)) {
    problems.report(
        "repetitions",
        phrase("Protocols", "the track has more than %1 trials; use fewer repetitions or levels")
            .with(std::to_string(kMostTrials)));
  }
}

std::vector<double> constant_levels(const ProcedureSettings& settings) {
  return of(settings).levels;
}

std::size_t constant_trials(const ProcedureSettings& settings) {
  return of(settings).levels.size() * of(settings).repetitions;
}

NextStep constant_next(const ConstantStimuli& method, std::span<const LevelAnswer> answers,
                       const Random& of_track) {
  if (answers.size() >= method.levels.size() * method.repetitions) return TrackEnd::trials;
  const std::size_t count = method.levels.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random random = of_track.split(static_cast<std::uint64_t>(answers.size() / count));
  random.shuffle(std::span(order));
  return NextLevel{.level = method.levels[order[answers.size() % count]]};
}

LevelRule constant_rule(const ProcedureSettings& settings) {
  return [method = of(settings)](std::span<const LevelAnswer> answers, const Random& of_track) {
    return constant_next(method, answers, of_track);
  };
}

constexpr Procedure kConstantStimuli{
    .id = "constant_stimuli",
    .meaning = "every level equally often, in random order",
    .check = check_constant,
    .levels = constant_levels,
    .rule = constant_rule,
    .most_trials = constant_trials,
    .has_fixed_length = [](const ProcedureSettings&) { return true; },
    .target = [](const ProcedureSettings&) -> std::optional<double> { return std::nullopt; }};

}  // namespace

const Procedure& constant_stimuli() { return kConstantStimuli; }

}  // namespace asperity
