// Declares the procedure by the functions of an up-down track, with numbers of responses per move.

#include "protocols/procedures/transformed_up_down.h"

#include "protocols/procedures/procedure.h"

namespace asperity {
namespace {

const UpDownTrack& track_of(const ProcedureSettings& settings) {
  return std::get<TransformedUpDown>(settings).track;
}

void check_transformed(const ProcedureSettings& settings, ProcedureProblems& problems) {
  check_track(track_of(settings), problems);
}

LevelRule transformed_rule(const ProcedureSettings& settings) {
  return [track = track_of(settings)](std::span<const LevelAnswer> answers, const Random&) {
    return next_of(track, answers);
  };
}

std::optional<double> transformed_target(const ProcedureSettings& settings) {
  return target_of(track_of(settings));
}

constexpr Procedure kTransformedUpDown{
    .id = "transformed_up_down",
    .meaning = "down after n correct responses in succession, up after m incorrect ones",
    .check = check_transformed,
    .levels = [](const ProcedureSettings& settings) { return levels_of(track_of(settings).grid); },
    .rule = transformed_rule,
    .most_trials = [](const ProcedureSettings& settings) { return track_of(settings).stop.trials; },
    .has_fixed_length =
        [](const ProcedureSettings& settings) { return has_fixed_length(track_of(settings).stop); },
    .target = transformed_target};

}  // namespace

const Procedure& transformed_up_down() { return kTransformedUpDown; }

}  // namespace asperity
