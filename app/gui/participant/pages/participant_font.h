// The font of the participant's picture.

#pragma once

#include <QtGui/QFont>

namespace asperity {

/// The general font of the desktop; `size_px` is at least 1.
QFont participant_font(int size_px, bool bold);

}  // namespace asperity
