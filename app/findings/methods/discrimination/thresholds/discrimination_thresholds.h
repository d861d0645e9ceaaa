// Estimates thresholds of a discrimination by psychometric functions.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/numbers/finding.h"
#include "analysis/numbers/proportion.h"
#include "analysis/psychometric/psychometric_model.h"
#include "analysis/psychometric/unforced_bootstrap.h"
#include "analysis/words/phrase.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tracks.h"
#include "app/findings/tidy/finding_list.h"
#include "app/findings/tidy/tidy_families.h"

namespace asperity {

/// One psychometric function, with the key of its findings.
struct DiscriminationData {
  FindingKey key{};
  HitsByValue hits{};
  /// A procedure chose levels from the responses.
  bool by_procedure = false;
  /// How it placed the trials; without it there are no intervals.
  std::optional<PlacedTrials> placed{};
  /// Bootstrap intervals are computed, where they take time.
  bool needs_intervals = true;
};

/// The proportion correct with d′ = 1 in two-alternative forced choice without bias: Φ(1/√2).
inline constexpr double kProportionAtUnitSensitivity = 0.7602499389065233;
inline constexpr double kProportionAtThreshold = 0.75;
/// The proportion correct at the threshold of a design in which a surface is chosen, with guess rate γ: halfway between
/// guessing and certainty, (1 + γ)/2.
double proportion_at_threshold(const DiscriminationDesign& design);
/// The same with d′ = 1 and without bias: of three alternatives by `ForcedChoice`, of an oddity task by the differencing rule
/// (`Oddity`).
double proportion_at_unit_sensitivity(const DiscriminationDesign& design);
/// The lapse rate of each of the two responses where no response is correct.
inline constexpr double kSymmetricLapseRate = 0.02;
/// The greatest lapse rate that is fitted where responses are correct or incorrect.
inline constexpr double kGreatestLapseRate = 0.06;

/// The psychometric function of a task whose levels did not depend on the responses.
///
/// performance: a Weibull function of the absolute difference x from the standard, γ of the design, λ fitted between 0 and
/// `kGreatestLapseRate`. comparison: a cumulative normal function of the value x of the parameter, γ = λ =
/// `kSymmetricLapseRate`.
PsychometricModel psychometric_model(const DiscriminationTask& task);

/// The table and the options of the family `psyfit` for `psychometric_model` and the threshold at this proportion of hits.
TidyInput psychometric_input(const DiscriminationTask& task,
                             std::span<const DiscriminationData> data, double proportion_of_hits);

/// Where a procedure chose levels, the slope of a Weibull function is limited to `kSlopesOfProcedures`, and the intervals are
/// those of `procedure_interval`, or of the posterior distribution of psi and QUEST+: the delta method assumes levels that do not depend on the responses.
/// A response "cannot tell" counts as in `split_hits`; the intervals of other data are then those of `bootstrap_unforced`.
struct DiscriminationFit {
  /// Analysis `psychometric`: of the family `psyfit`, or with limited slopes and the same names. Of a choice of three
  /// surfaces also fit.design, the id of the design.
  std::vector<Finding> functions{};
  /// By key, analysis `thresholds`, in the unit of the parameter unless stated otherwise:
  ///   pse          of a comparison: the value at which both responses are equally frequent, without lapses
  ///   jnd          performance: the difference from the standard at `proportion_at_threshold` correct responses, 75 % with
  ///                two alternatives; comparison: ½(x75 − x25), without lapses
  ///   jnd.dprime1  performance: the difference from the standard at d′ = 1
  ///   jnd.posterior  performance, if psi or QUEST+ chose the levels: the posterior mean of the same difference, with a
  ///                credible interval; a status where the prior determines it
  ///   weber        jnd divided by the standard, without a unit; not for a standard of 0
  ///   slope        dψ/dx at the threshold; a status as well where the fitted slope is at its bound
  ///   standard     the value of the parameter in the standard
  ///   without      repetitions of the procedure without a threshold, of `kRepetitionsOfProcedures`, where it was repeated
  ///   unfinished.tracks  tracks whose session ended before the procedure stopped, of n; absent where there are none
  /// A word and a status in place of a number that cannot be estimated, or that is outside the presented levels.
  std::vector<Finding> thresholds{};
  /// The sentences of `WhyNoThreshold` in `thresholds`, each once, except for those of slopes.
  std::vector<Phrase> reasons{};
};
/// The trials by x, ascending: the value, or with correct responses its distance from the standard.
std::vector<UnforcedBlock> unforced_blocks(const DiscriminationTask& task, const HitsByValue& hits);
/// The same with responses "cannot tell" as guessed hits (`split_block`).
std::vector<PsychometricBlock> psychometric_blocks(const DiscriminationTask& task,
                                                   const HitsByValue& hits);
/// The basis of an estimate that is divided by the standard, above 0; its method is the same.
Basis basis_in_standards(Basis estimate, double standard);

/// Of a design with options in words: `fit_detections`.
DiscriminationFit fit_discrimination(const DiscriminationTask& task,
                                     std::span<const DiscriminationData> data);

}  // namespace asperity
