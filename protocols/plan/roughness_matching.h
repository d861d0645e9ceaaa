// Declares the estimate of the amplitudes at which stimuli are as rough as a reference.

#pragma once

#include <optional>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/design/roughness_match.h"
#include "protocols/design/trial.h"
#include "protocols/procedures/procedure.h"

namespace asperity {

/// A track needs so many reversals: fewer do not enclose the amplitude between two answers of each kind.
inline constexpr int kFewestReversals = 2;

/// The answers of one track, and the stimulus whose relative amplitude it varied.
struct AnsweredTrack {
  std::string stimulus{};
  std::string model{};
  std::string texture{};
  ProcedureSettings settings{};
  std::vector<LevelAnswer> answers{};
};

/// The up-down track of settings whose levels approach equal proportions of both answers; empty for others.
std::optional<UpDownTrack> equality_track(const ProcedureSettings& settings);

/// Whether the tracks of this block determine amplitudes: a block with `equal_roughness` names it. Other blocks can vary the
/// relative amplitude as well (a JND), and match nothing.
bool matches_roughness(const Protocol& protocol, const Protocol::Block& block);

/// One match for each stimulus, in the order of the tracks. `vary` is the dimension of the block of the tracks.
///
///   ln a = (1/T)·Σ_t (1/R_t)·Σ_r ln a_tr
///
/// a_tr is the relative amplitude of the trial with the reversal r of track t [Levitt 1971]. The tracks have equal
/// weights, so that the errors of tracks from above and from below, which are opposite, cancel. Rounded to 12 significant
/// digits.
///
/// A track with fewer than kFewestReversals reversals whose last answer leads beyond an end of the range gives this end,
/// for the stimulus. If tracks give both ends, or one has too few reversals elsewhere, the amplitude is unchanged.
///
/// [Levitt 1971] Levitt: Transformed up-down methods in psychoacoustics.
std::vector<RoughnessMatch> roughness_matches(const Dimension& vary,
                                              const std::vector<AnsweredTrack>& tracks);

/// What a surface of a block with `equal_roughness` has from the matches: that of its stimulus, or as the reference.
void apply_match(const std::vector<RoughnessMatch>& matches, PlannedPresentation& planned);

/// Whether both surfaces have the same stimulus, whatever its template, role and amplitude.
bool are_of_same_stimulus(const PlannedPresentation& one, const PlannedPresentation& other);

}  // namespace asperity
