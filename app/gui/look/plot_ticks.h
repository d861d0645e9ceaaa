// Ticks of the plots in windows.

#pragma once

#include <QtCore/QSharedPointer>

class QCPAxis;
class QCPAxisTicker;

namespace asperity {

/// From now on the vertical axis has about `most` ticks, and fewer while its plot is so low that their labels
/// would touch. It gets the plain ticker.
void keep_labels_apart(QCPAxis& axis, int most);

/// Of a linear axis: the usual ticks, with a minus sign before negative numbers.
QSharedPointer<QCPAxisTicker> plain_ticker();
/// The same at each multiple of `step`.
QSharedPointer<QCPAxisTicker> step_ticker(double step);

/// Of a logarithmic axis: decades, and 1, 2 and 5 of each where fewer than two of them are shown, since one
/// number is no scale. With the number format "eb" they are written as powers of ten in every language.
QSharedPointer<QCPAxisTicker> decade_ticker();

}  // namespace asperity
