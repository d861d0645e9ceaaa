// What one window tells another when something goes wrong.

#pragma once

#include <QtCore/QMetaType>

namespace asperity {

/// What helps after a session that failed.
enum class AfterFailure {
  start_again,  ///< the same order once more: what stood in the way lies outside it
  check_again,  ///< what the order was checked against is not so any more
  go_on,        ///< the session is in the store and goes on from there
};

/// What followed when the participant's screen was unplugged.
enum class ScreenLoss {
  force_stopped,  ///< a surface was felt: the emergency stop was pressed for them
  pausing,        ///< there was no force: the session pauses
  still_gone,     ///< somebody looked for the screen again
};

}  // namespace asperity

Q_DECLARE_METATYPE(asperity::AfterFailure)
