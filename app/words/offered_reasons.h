// The reasons that windows offer to an experimenter who has to state one.

#pragma once

#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

/// The action for which a reason is requested.
enum class ReasonFor {
  repeating,          ///< the last trial
  skipping,           ///< the current trial
  aborting,           ///< the session
  unblinding,         ///< the experimenter
  flagging,           ///< an attempt
  excluding_attempt,  ///< from analyses
  excluding_session,
  including,  ///< what was excluded before
  noting,     ///< a note made with one click
};

/// In the order of the windows. Each is stored by its code, in every language of the window.
std::vector<Phrase> offered_reasons(ReasonFor what);

/// All reasons, including those that the program states for a participant who withdraws.
std::vector<Phrase> coded_offers();

}  // namespace asperity
