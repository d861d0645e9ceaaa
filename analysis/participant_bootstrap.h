// The bootstrap over participants, of any statistic of a group.

#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>

#include "analysis/proportion.h"

namespace asperity {

/// The interval of a statistic, from resamples of participants with all their trials: trials of one participant depend on
/// each other, and a resample of single trials would give intervals that are too short. Percentile interval with
/// quantiles of type 7 [Davison 1997]; it is too short for few participants.
///
/// [Davison 1997] Davison, Hinkley: Bootstrap methods and their application.
struct ParticipantBootstrap {
  std::optional<ConfidenceInterval> interval{};  ///< nothing for fewer than two participants
  std::size_t draws = 0;
  std::size_t without = 0;  ///< draws in which the statistic does not exist; left out
};

struct BootstrapPlan {
  std::size_t participants = 0;
  std::size_t draws = 2000;
  double confidence = 0.95;
};

/// `statistic` receives the places of the participants of one draw, of which some occur several times and others do not
/// occur. The draws are those of the seed kSeedOfTests.
ParticipantBootstrap bootstrap_participants(
    const BootstrapPlan& plan,
    const std::function<std::optional<double>(std::span<const std::size_t>)>& statistic);

}  // namespace asperity
