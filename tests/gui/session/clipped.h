// What of a window's contents cannot be read whole.

#pragma once

#include <QtCore/QStringList>

class QWidget;

namespace asperity {

/// Words on labels and buttons that have less room than they need, widgets that stick out of what they
/// stand in or lie over one another, one line each. Lines that end in an ellipsis are no such.
QStringList clipped_in(const QWidget& window);

}  // namespace asperity
