// Reads from a stored plan at which relative amplitude a session presented its stimuli.

#pragma once

#include <span>
#include <string>
#include <vector>

#include "protocols/design/roughness_match.h"
#include "results_schema/rows.h"

namespace asperity {

/// The match of one stimulus of a session, as its trials present it.
struct PresentedMatch {
  std::string block{};  ///< that presents it
  std::string model{};
  std::string texture{};  ///< empty: none
  double relative_amplitude = 1.0;
  MatchStatus status = MatchStatus::unmatched;

  bool operator==(const PresentedMatch&) const = default;
};

/// Each match once, in the order of the trials; without references. Empty for sessions without blocks of equal
/// roughness. Statuses of later versions are left out.
std::vector<PresentedMatch> presented_matches(std::span<const PlannedTrialRow> plan);

}  // namespace asperity
