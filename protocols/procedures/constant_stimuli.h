// The method of constant stimuli.

#pragma once

#include <cstddef>
#include <vector>

#include "protocols/procedures/level_answer.h"
#include "protocols/procedures/level_grid.h"

namespace asperity {

struct Procedure;

/// Every level equally often, in a random order: each repetition presents every level once, shuffled by the stream of
/// the track (`Random::split(repetition)`), so that a prefix of whole repetitions is balanced. The answers determine
/// only how many trials there have been; a delivered level that differs from the proposed one changes nothing.
struct ConstantStimuli {
  std::vector<double> levels{};  ///< ascending; `levels_of` a grid, or a list
  std::size_t repetitions = 0;

  bool operator==(const ConstantStimuli&) const = default;
};

const Procedure& constant_stimuli();

}  // namespace asperity
