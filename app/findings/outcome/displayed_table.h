// Formats the tables of a result for people.

#pragma once

#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "app/findings/outcome/result_table.h"

namespace asperity {

/// Who reads a table. The cells are the same; the headings are not.
enum class Reader {
  window,    ///< every column alone: "JND, 95 % CI", "force, N"
  report,    ///< an interval follows its number: "95 % CI", "force (N)"
  terminal,  ///< by ids, with which programs find the same numbers in JSON: "jnd 95 %"
};

struct DisplayedColumn {
  Phrase heading{};
  bool holds_words = false;  ///< names and levels, as opposed to quantities: aligned at the left
};

struct DisplayedTable {
  std::vector<DisplayedColumn> columns{};
  std::vector<std::vector<Phrase>> rows{};  ///< an empty phrase is a missing cell
};

/// The table for a reader: without columns of files and, but for the first, without empty columns, words as text, limits of an
/// interval together: "[0.36, 0.81]", quantities with the prefix of their unit. A force is rounded to a millinewton, a length to ten
/// micrometres, a p to three decimals or "< .001", a test statistic to two decimals; all other numbers of a quantity, with their
/// intervals and standard errors, to the same number of decimals: `decimals_of` the narrowest interval, or without intervals two and
/// more for small numbers. Numbers are rounded here and nowhere before.
DisplayedTable displayed(const ResultTable& table, Reader reader);

/// The heading of one column for a reader.
Phrase heading_for(const ResultColumn& column, Reader reader);

}  // namespace asperity
