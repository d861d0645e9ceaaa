// What somebody who does not see a window, or has no mouse, meets in it.

#pragma once

#include <QtCore/QStringList>
#include <QtWidgets/QWidget>

namespace asperity {

/// Visible controls without a name that can be read out: a text, an accessible name or a label that is their buddy,
/// with at least one letter.
QStringList nameless_controls(const QWidget& window);

/// Steps of Tab between visible controls that lead against the reading order: to a control above, unless another column
/// begins there on the right, or to one further left in the same line.
QStringList steps_against_reading(const QWidget& window);

}  // namespace asperity
