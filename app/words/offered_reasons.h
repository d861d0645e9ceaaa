// The reasons that windows offer to an experimenter who has to state one.

#pragma once

#include <vector>

#include "app/words/phrase.h"

namespace asperity {

/// What a reason is asked for.
enum class ReasonFor {
  repeating,          ///< the last trial
  skipping,           ///< the trial under way
  aborting,           ///< the session
  unblinding,         ///< the experimenter
  flagging,           ///< an attempt
  excluding_attempt,  ///< from analyses
  excluding_session,
  including,  ///< what was excluded
  noting,     ///< a note of one click
};

/// In the order in which they are offered. Each is stored by its code, whatever the language of the window.
std::vector<Phrase> offered_reasons(ReasonFor what);

/// All of them, and those that the program states for a participant who withdraws.
std::vector<Phrase> coded_offers();

}  // namespace asperity
