// QUEST+ in one dimension.

#pragma once

#include "protocols/procedures/posterior_track.h"

namespace asperity {

struct Procedure;

/// The level with the least expected entropy of the joint distribution of threshold, slope and lapse rate [Watson 2017]. One
/// dimension of levels and two responses make it the psi procedure without nuisance parameters; it has its own name
/// because studies report it by this name.
///
/// [Watson 2017] Watson: QUEST+: A general multidimensional Bayesian adaptive psychometric method.
struct QuestPlus {
  PosteriorTrack track{};

  bool operator==(const QuestPlus&) const = default;
};

const Procedure& quest_plus();

}  // namespace asperity
