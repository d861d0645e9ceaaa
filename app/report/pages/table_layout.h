// Lays out a table of a report: the widths of its columns and the lines of its cells.

#pragma once

#include <cstddef>
#include <vector>

#include <QtCore/QString>
#include <QtCore/QStringList>
#include <QtGui/QFont>

#include "app/report/text/report.h"

namespace asperity {

/// Breaks a text into lines of at most this width: between words, and within a word that is longer.
QStringList broken_lines(const QString& text, const QFont& font, double width);
double text_width(const QString& text, const QFont& font);

/// A row: per cell its lines.
struct LaidOutRow {
  std::vector<QStringList> cells{};
  double height = 0.0;
};

/// The columns of a table that stand side by side: all of them, or, of a table that is too wide,
/// those that identify its rows and some of the others.
struct LaidOutTable {
  std::vector<std::size_t> columns{};  ///< their places in the table
  QFont font{};
  QFont bold{};
  double line_height = 0.0;
  double padding = 0.0;         ///< above and below the lines of a row
  std::vector<double> left{};   ///< of each column
  std::vector<double> right{};  ///< of each column, with a gap to the next
  LaidOutRow heading{};
  std::vector<LaidOutRow> rows{};
};

/// At most `width` wide: columns have their natural width where that fits; otherwise columns of
/// words are broken into lines, and the font size is reduced to no less than 7 points. A table that
/// is still too wide is divided into several parts, to be placed one below the other; each begins
/// with the columns that identify a row.
std::vector<LaidOutTable> lay_out(const ReportTable& table, const QString& family, double width);

}  // namespace asperity
