// Reads from a stored plan at which relative amplitude a session presented its stimuli.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"
#include "protocols/design/roughness_match.h"
#include "results_schema/rows.h"

namespace asperity {

/// The match of one stimulus of a session, as its trials present it.
struct PresentedMatch {
  std::string block{};       ///< that presents it
  std::string matched_in{};  ///< the block whose responses determined it
  std::string stimulus{};    ///< as planned: the template with model and texture
  std::string model{};
  std::string texture{};  ///< empty: none
  double relative_amplitude = 1.0;
  MatchStatus status = MatchStatus::unmatched;

  bool operator==(const PresentedMatch&) const = default;
};

/// Whether blocks of the protocol present matches: plans of other protocols need not be read.
bool presents_matches(const Protocol& protocol);

/// Each match of these trials once, in their order; without references. Empty for protocols without blocks of equal
/// roughness. Statuses of later versions are left out. `trials`: those with an attempt that counts, so that a match that a
/// participant did not feel, or whose session is excluded, is not reported.
std::vector<PresentedMatch> presented_matches(const Protocol& protocol,
                                              std::span<const PlannedTrialRow> trials);

/// Each match once, whichever blocks present it; `block` is empty.
std::vector<PresentedMatch> without_blocks(std::vector<PresentedMatch> matches);

}  // namespace asperity
