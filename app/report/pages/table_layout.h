// A table of a report with the widths that its columns get and the lines that its cells break into.

#pragma once

#include <vector>

#include <QtCore/QString>
#include <QtCore/QStringList>
#include <QtGui/QFont>

#include "app/report/text/report.h"

namespace asperity {

/// Breaks a text into lines no wider than that: between words, and within one that is too long.
QStringList broken_lines(const QString& text, const QFont& font, double width);
double text_width(const QString& text, const QFont& font);

/// A row: per cell its lines.
struct LaidOutRow {
  std::vector<QStringList> cells{};
  double height = 0.0;
};

struct LaidOutTable {
  QFont font{};
  QFont bold{};
  double line_height = 0.0;
  double padding = 0.0;         ///< above and below the lines of a row
  std::vector<double> left{};   ///< of each column
  std::vector<double> right{};  ///< of each column; a gap is between
  LaidOutRow heading{};
  std::vector<LaidOutRow> rows{};
};

/// No wider than `width`: columns get what they need where that fits; otherwise those of words break
/// into lines, and at last the letters become smaller.
LaidOutTable lay_out(const ReportTable& table, const QString& family, double width);

}  // namespace asperity
