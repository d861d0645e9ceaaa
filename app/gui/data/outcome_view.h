// Shows the outcome of an analysis: question, answer, figure, table, method.

#pragma once

#include <functional>

#include <QtCore/QString>

#include "app/findings/outcome/analysis_outcome.h"
#include "app/findings/outcome/figure.h"

class QWidget;

namespace asperity {

/// The actions that a figure offers.
struct FigureWishes {
  std::function<void(const Figure&, double width_mm)> save{};
  std::function<void(const Figure&)> copy{};
};

/// A new widget without a parent; it does not refer to `outcome` afterwards.
QWidget* make_outcome(const AnalysisOutcome& outcome, const FigureWishes& wishes);

/// "1 answer", "2 answers".
QString answers_text(int count);

}  // namespace asperity
