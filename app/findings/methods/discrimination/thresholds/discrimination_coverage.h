// The simulated coverage of the intervals of thresholds whose levels a procedure chose, and the note with it.

#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "analysis/words/phrase.h"
#include "app/findings/methods/discrimination/thresholds/discrimination_tasks.h"

namespace asperity {

/// Of the 95 % interval of the threshold at 75 % correct, of simulated observers with slope β and a lapse rate of 2 %.
struct SimulatedCoverage {
  std::string_view procedure{};  ///< as in docs/data/interval_coverage.tsv
  std::size_t down = 0;          ///< correct responses before a move down; 1 of a weighted up-down
  double target = 0.0;           ///< of a weighted up-down; otherwise 0
  std::size_t tracks = 1;
  std::size_t trials = 0;  ///< of each track
  double beta = 0.0;
  double coverage_percent = 0.0;
};
/// The rows of docs/data/interval_coverage.tsv, which scripts/recovery writes there and here.
std::span<const SimulatedCoverage> simulated_coverages();

/// A block whose levels a procedure chose.
struct BlockWithProcedure {
  const Protocol::Block* block = nullptr;
  bool is_performance = true;  ///< of two alternatives: only such observers were simulated
};

/// What a table of these intervals must state: the coverage for the procedures of these blocks if it is outside 93 to 97 %,
/// and that of all simulated procedures for those that were not simulated. Empty if there is nothing to state.
Phrase note_on_coverage(std::span<const BlockWithProcedure> blocks);

/// The simulated coverage of the 95 % interval of the JND, of a judgement of performance or of a comparison, with responses
/// "cannot tell" at constant levels: the rows `unforced_thresholds` of docs/data/coverage.tsv.
Phrase note_on_unforced_jnd(bool is_performance);

}  // namespace asperity
