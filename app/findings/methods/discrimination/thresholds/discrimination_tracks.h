// Runs the tracks of a discrimination again, with simulated observers: the intervals of thresholds where a procedure chose levels.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "analysis/psychometric/procedure_bootstrap.h"
#include "analysis/psychometric/psychometric_model.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

/// The limits of the slope β of a Weibull function where a procedure chose levels by performance. Few trials near one level
/// hardly determine a slope, and the threshold of a function without limits can be anywhere (docs/procedures.md).
inline constexpr SlopeRange kSlopesOfProcedures{.least = 1.0, .greatest = 8.0};
/// Of the bootstrap of an interval.
inline constexpr std::size_t kRepetitionsOfProcedures = 500;

/// How the trials of one psychometric function were placed.
struct PlacedTrials {
  struct Track {
    ProcedureSettings settings{};  ///< with the number of trials of a track that was not finished
    Dimension levels{};            ///< how the protocol states them
    bool is_unfinished = false;    ///< the session ended before the procedure stopped
  };
  std::size_t unfinished_tracks() const;
  std::vector<Track> tracks{};
  /// Trials by value of the parameter whose level no procedure chose from the responses.
  std::map<double, std::uint64_t> fixed{};
  /// The tracks moved down after choices of the comparison, although the hits are choices of the standard.
  bool counts_standard = false;
  /// Of unforced choices: the number of alternatives, and the proportion of the errors in expectation that are responses
  /// "cannot tell" (`unsure_share_of_errors`). 0 where there is no such response.
  std::size_t alternatives = 0;
  double unsure_share = 0.0;
};

/// Of incorrect responses and of responses "cannot tell", which are errors by (m − 1)/m with m alternatives: the proportion
/// of these errors that the latter make up, 0 without any.
double unsure_share_of_errors(const ChoiceCount& count, std::size_t alternatives);

/// Of the trials of one track of a block, in any order. `of_block`: the settings of all its tracks; `levels`: how it states
/// their levels.
PlacedTrials::Track placed_track(std::vector<const DiscriminationTrial*> trials,
                                 std::span<const ProcedureSettings> of_block,
                                 const Dimension& levels);

/// Of the trials of one function; nothing where no procedure chose a level, or its settings are not known. `trials`: in any
/// order.
std::optional<PlacedTrials> placed_trials(const GatheredAnswers& gathered,
                                          const DiscriminationStudy& study,
                                          std::span<const DiscriminationTrial* const> trials);

/// The same trials of an observer with this function, by x as in `psychometric_input`.
///
/// The function ψ is that of hits with split responses "cannot tell", and an observer gives one of three responses. With m
/// alternatives and r = `unsure_share`
///
///   P(cannot tell) = r·(1 − ψ)·m/(m − 1),   P(incorrect) = (1 − r)·(1 − ψ),   P(correct) = ψ − P(cannot tell)/m,
///
/// so that the expected hits are ψ: where a stimulus is not perceived, a constant proportion of the guesses is replaced by
/// "cannot tell". r = 1 leaves no guess and r = 0 is the forced choice. P(correct) ≥ 0 because ψ ≥ 1/m.
std::vector<PsychometricBlock> run_again(const DiscriminationTask& task, const PlacedTrials& placed,
                                         const PsychometricFunction& observer,
                                         const Random& of_run);

/// `bootstrap_procedure` with constant seed. performance: Weibull functions with slopes of `kSlopesOfProcedures`; comparison:
/// cumulative normal functions, with lapses as in the fit. Thresholds up to a third and three times the levels of the
/// procedure, or half of their range beyond them on the linear scale of a comparison. Nothing for fewer than two x.
std::optional<ProcedureBootstrap> procedure_interval(const DiscriminationTask& task,
                                                     std::span<const PsychometricBlock> blocks,
                                                     const PlacedTrials& placed,
                                                     double proportion_of_hits);

}  // namespace asperity
