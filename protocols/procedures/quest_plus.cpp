// Declares the procedure by the functions of a posterior track, about all parameters.

#include "protocols/procedures/quest_plus.h"

#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

const QuestPlus& quest_in(const ProcedureSettings& settings) {
  return std::get<QuestPlus>(settings);
}

constexpr Procedure kQuestPlus{
    .id = "quest_plus",
    .meaning = "the level from which the most is expected about threshold, slope and lapse rate",
    .check =
        [](const ProcedureSettings& settings, ProcedureProblems& problems) {
          check_posterior_track(quest_in(settings).track, problems);
        },
    .levels =
        [](const ProcedureSettings& settings) { return levels_of(quest_in(settings).track.grid); },
    .rule = [](const ProcedureSettings& settings) -> LevelRule {
      return posterior_rule(quest_in(settings).track, {});
    },
    .most_trials =
        [](const ProcedureSettings& settings) { return quest_in(settings).track.stop.trials; },
    .has_fixed_length =
        [](const ProcedureSettings& settings) {
          return !quest_in(settings).track.stop.interval.has_value();
        },
    .target = [](const ProcedureSettings& settings) -> std::optional<double> {
      return quest_in(settings).track.prior.performance;
    },
    .simulated_tracks = kSimulatedPosteriorTracks};

}  // namespace

const Procedure& quest_plus() { return kQuestPlus; }

}  // namespace asperity
