// Declares one trial of a session: its surfaces and its question.

#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "protocols/answers/trial_question.h"
#include "protocols/design/protocol.h"
#include "stimuli/stimulus_description.h"

namespace asperity {

/// One surface of a trial.
struct PlannedPresentation {
  int position = 0;    ///< 1-based, in the order of presentation
  std::string role{};  ///< "alternative", "target", "anchor"
  std::string item{};  ///< the model (selection) or texture that it is an instance of
  std::string code{};  ///< label for blinded use: "A" for the first position, then "B", …
  std::string stimulus_template{};  ///< the template of the stimulus, by its name in the protocol
  StimulusDescription stimulus{};
  std::optional<EqualForce> equal_force{};
};

struct Trial {
  int ordinal = 0;  ///< 1-based within the session
  std::string block{};
  int block_ordinal = 0;  ///< 1-based within the session; every run of a block counts
  Phase phase = Phase::main;
  int repetition = 1;  ///< 0 of an anchor
  std::map<std::string, Level, std::less<>> factors{};
  std::vector<PlannedPresentation> presentations{};
  TrialQuestion question{};
};

}  // namespace asperity
