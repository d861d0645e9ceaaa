// The fixed words in the tables of an analysis, in the language of the windows.

#pragma once

#include <string>

#include <QtCore/QCoreApplication>
#include <QtCore/QString>

#include "app/findings/outcome/analysis_outcome.h"

namespace asperity {

/// What a study has named itself (textures, models, pictures) stays as it is.
class AnalysisWords final {
  Q_DECLARE_TR_FUNCTIONS(AnalysisWords)
 public:
  /// The heading of a column of `reading_table(table.table)`: "Wilson 95 %" of "wilson 95 %".
  static QString of_heading(const NamedTable& table, const std::string& column);
  /// What stands in a column: "Total" among persons, "all" among columns (cell_words.h).
  static QString of_cell(const std::string& column, const std::string& text);
};

}  // namespace asperity
