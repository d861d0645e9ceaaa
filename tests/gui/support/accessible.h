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

/// Shown labels and cells in a colour that means something (fine, needs attention, stopped), without the shape of that
/// state and without words: in grey they would look like any other.
QStringList told_by_color_alone(const QWidget& window);

}  // namespace asperity
