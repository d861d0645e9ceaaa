// Declares the procedure by the functions of a posterior track, with the marginalised parameters.

#include "protocols/procedures/psi.h"

#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

const Psi& psi_in(const ProcedureSettings& settings) { return std::get<Psi>(settings); }

constexpr Procedure kPsi{
    .id = "psi",
    .meaning =
        "the level from which the most is expected about the threshold, nuisance parameters "
        "marginalised",
    .check =
        [](const ProcedureSettings& settings, ProcedureProblems& problems) {
          check_posterior_track(psi_in(settings).track, problems);
        },
    .levels =
        [](const ProcedureSettings& settings) { return levels_of(psi_in(settings).track.grid); },
    .rule = [](const ProcedureSettings& settings) -> LevelRule {
      return posterior_rule(psi_in(settings).track, psi_in(settings).marginalised);
    },
    .most_trials =
        [](const ProcedureSettings& settings) { return psi_in(settings).track.stop.trials; },
    .has_fixed_length =
        [](const ProcedureSettings& settings) {
          return !psi_in(settings).track.stop.interval.has_value();
        },
    .target = [](const ProcedureSettings& settings) -> std::optional<double> {
      return psi_in(settings).track.prior.performance;
    },
    .simulated_tracks = kSimulatedPosteriorTracks};

}  // namespace

const Procedure& psi() { return kPsi; }

}  // namespace asperity
