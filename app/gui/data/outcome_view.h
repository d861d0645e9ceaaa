// An outcome of an analysis as people read it: question, answer, figure, table, method.

#pragma once

#include <functional>

#include <QtCore/QString>

#include "app/findings/figure.h"
#include "app/findings/study/analysis_outcome.h"

class QWidget;

namespace asperity {

/// What a person wants of a figure.
struct FigureWishes {
  std::function<void(const Figure&, double width_mm)> save{};
  std::function<void(const Figure&)> copy{};
};

/// A new widget without a parent, which keeps nothing of `outcome`.
QWidget* make_outcome(const AnalysisOutcome& outcome, const FigureWishes& wishes);

/// "1 answer", "2 answers".
QString answers_text(int count);

}  // namespace asperity
