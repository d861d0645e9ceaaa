// Writes the levels of a column in one cell, separated by |, and its publication in words.

#include "app/exports/columns/codebook.h"

#include "app/exports/columns/column_making.h"

namespace asperity {
namespace {

const char* publication_word(Publication publication) {
  switch (publication) {
    case Publication::kept:
      return "kept";
    case Publication::without_questionnaires:
      return "without answers to questionnaires";
    case Publication::without_free_text:
      return "without free text";
    case Publication::dropped_unless_named:
      return "omitted unless named";
    case Publication::dropped_with_new_labels:
      return "omitted with new labels";
    case Publication::dropped:
      return "dropped";
  }
  return "";
}

}  // namespace

const std::vector<std::string>& codebook_columns() {
  static const std::vector<std::string> kColumns{"file",    "column",      "description", "type",
                                                 "unit",    "levels",      "minimum",     "maximum",
                                                 "missing", "publication", "source"};
  return kColumns;
}

std::vector<Cell> codebook_row(const std::string& file, const ExportColumn& column) {
  std::string levels{};
  for (const std::string& level : column.levels) levels += (levels.empty() ? "" : " | ") + level;
  return {file,
          column.name,
          column.description,
          column.type,
          column.unit.empty() ? Cell{} : Cell{column.unit},
          levels.empty() ? Cell{} : Cell{levels},
          export_columns::optional_cell(column.minimum),
          export_columns::optional_cell(column.maximum),
          column.missing,
          std::string(publication_word(column.publication)),
          column.source};
}

}  // namespace asperity
