// What chooses the levels of a track from the responses so far, as a value, and the registry of all procedures.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/numbers/random.h"
#include "protocols/procedures/constant_stimuli.h"
#include "protocols/procedures/external.h"
#include "protocols/procedures/procedure_problems.h"
#include "protocols/procedures/psi.h"
#include "protocols/procedures/quest_plus.h"
#include "protocols/procedures/transformed_up_down.h"
#include "protocols/procedures/weighted_up_down.h"

namespace asperity {

/// The settings of a procedure; the alternative determines the procedure.
using ProcedureSettings =
    std::variant<ConstantStimuli, TransformedUpDown, WeightedUpDown, Psi, QuestPlus, External>;

/// A procedure for choosing levels: all that differs between procedures.
///
/// A `LevelRule` is a pure function. A track stores its answers alone: resuming, verifying and replaying it call the rule
/// with the stored answers and compare. Equal settings, answers and stream give equal levels bit for bit, on every
/// platform for the linear scale and with the same C library for the others. The levels of `External` are stated by a
/// program and are stored; its rule gives only an example.
///
/// Every function takes settings of the own alternative (otherwise std::bad_variant_access); all except `check`
/// assume that `check` reports nothing.
struct Procedure {
  std::string_view id{};       ///< as in protocols and in the store
  std::string_view meaning{};  ///< how it chooses levels, as an entry of a list
  /// Reports every problem, with its remedy.
  void (*check)(const ProcedureSettings& settings, ProcedureProblems& problems) = nullptr;
  /// Every level that `next` can return, ascending.
  std::vector<double> (*levels)(const ProcedureSettings& settings) = nullptr;
  /// The rule with these settings, and with what follows from them alone, such as a table of likelihoods.
  LevelRule (*rule)(const ProcedureSettings& settings) = nullptr;
  /// No track has more trials.
  std::size_t (*most_trials)(const ProcedureSettings& settings) = nullptr;
  /// Whether every track has `most_trials`, whatever the answers.
  bool (*has_fixed_length)(const ProcedureSettings& settings) = nullptr;
  /// The proportion of correct responses at the level that the levels approach, or at the threshold that they serve to
  /// estimate; empty if they do not depend on the answers.
  std::optional<double> (*target)(const ProcedureSettings& settings) = nullptr;
  /// The number of tracks that an estimate simulates: fewer where the choice of a level takes longer.
  std::size_t simulated_tracks = 400;
};

/// All procedures, in the order of `ProcedureSettings`, in which documents list them.
std::span<const Procedure* const> procedures();
/// Null where there is no such procedure.
const Procedure* find_procedure(std::string_view id) noexcept;
const Procedure& procedure_of(const ProcedureSettings& settings);
/// Of psi and QUEST+; null for other procedures.
const PosteriorTrack* posterior_track_of(const ProcedureSettings& settings) noexcept;

/// The problems of settings; empty for settings that can be used.
std::vector<ProcedureProblem> problems_of(const ProcedureSettings& settings);

/// `Procedure::rule`. Errors: std::invalid_argument with the first problem of the settings.
LevelRule level_rule(const ProcedureSettings& settings);

/// One step of this rule, for those who need a single one. Errors: as `level_rule`.
NextStep next_step(const ProcedureSettings& settings, std::span<const LevelAnswer> answers,
                   const Random& of_track);

/// The probability of a correct response at a level.
using ChanceOfCorrect = std::function<double(double level)>;

/// The answers of a track whose levels are presented as proposed to an observer with independent responses.
std::vector<LevelAnswer> simulated_track(const LevelRule& rule, const ChanceOfCorrect& observer,
                                         const Random& of_track);
/// A response at a level.
using OutcomeOfObserver = std::function<LevelOutcome(double level, Random& random)>;
/// The same of an observer whose responses can be "cannot tell". One stream serves all responses.
std::vector<LevelAnswer> simulated_track(const LevelRule& rule, const OutcomeOfObserver& observer,
                                         const Random& of_track);
/// The same of a single track. Errors: as `level_rule`.
std::vector<LevelAnswer> simulated_track(const ProcedureSettings& settings,
                                         const ChanceOfCorrect& observer, const Random& of_track);

/// The expected number of trials of a track: exact where the length is fixed; otherwise the mean of `simulated_tracks` of
/// this observer with streams of a fixed seed (with 400, the standard error is a twentieth of the SD between tracks).
/// Errors: std::invalid_argument with the first problem of the settings.
double expected_trials(const ProcedureSettings& settings, const ChanceOfCorrect& observer);

}  // namespace asperity
