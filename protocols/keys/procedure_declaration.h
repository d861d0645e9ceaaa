// Declares the key "procedure" of a block as a protocol states it.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "protocols/design/protocol.h"

namespace asperity {

/// What a file states about a procedure. Together with the dimension and the design of its block it determines
/// Protocol::Block::LevelProcedure.
struct ProcedureDeclaration {
  /// The ranges of the parameters of psi and QUEST+ that are stated.
  struct Prior {
    std::optional<ValueRange> threshold{};
    std::optional<ValueRange> slope{};
    std::optional<ValueRange> lapse{};
  };
  struct Stop {
    std::size_t trials = 0;
    std::optional<std::size_t> reversals{};
    std::optional<std::size_t> clipped_moves{};
    std::optional<IntervalRule> interval{};
  };
  struct Track {
    std::optional<double> start{};
  };
  struct CatchTrials {
    CatchType type = CatchType::easy;
    std::optional<double> level{};
    int every = 0;
  };

  std::string method{};  ///< the id of a Procedure
  std::size_t repetitions = 0;
  std::size_t down = UpDownRule{}.down;
  std::size_t up = UpDownRule{}.up;
  std::optional<double> target{};
  double start = 0.0;
  StepList steps{};  ///< of both directions, unless their own are stated
  StepList steps_up{};
  StepList steps_down{};
  Prior prior{};
  std::vector<NuisanceParameter> marginalised = Psi{}.marginalised;
  std::string settings_json = External{}.settings_json;
  double answer_within_s = External{}.answer_within_s;
  Stop stop{};
  std::vector<Track> tracks{};  ///< none: one track
  bool timeouts_are_incorrect = false;
  std::optional<CatchTrials> catch_trials{};
};

}  // namespace asperity
