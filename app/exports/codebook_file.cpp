// Collects the columns of each added file, and describes its own columns and those of MANIFEST.tsv too.

#include "app/exports/codebook_file.h"

#include <array>
#include <utility>

#include "app/exports/columns/codebook.h"
#include "results_schema/tables/table_file.h"

namespace asperity {
namespace {

constexpr const char* kCodebook = "codebook.tsv";

// The columns of codebook.tsv itself.
std::vector<ExportColumn> columns_about_columns() {
  constexpr std::array<std::pair<const char*, const char*>, 11> kMeanings{
      {{"file", "file within the folder; * matches any text"},
       {"column", "name of the column"},
       {"description", "meaning of a cell"},
       {"type", "text, integer, number, boolean (1 or 0), utc_time or json"},
       {"unit", "unit, in SI notation; 1 for a dimensionless number"},
       {"levels", "possible values of a cell, separated by |"},
       {"minimum", "smallest declared or observed value"},
       {"maximum", "largest declared or observed value"},
       {"missing", "when a cell is missing"},
       {"publication", "how the column appears in a public export"},
       {"source", "source of the description: the program, a force model, a place in a protocol"}}};
  std::vector<ExportColumn> columns{};
  for (const auto& [name, meaning] : kMeanings) {
    ExportColumn& column = columns.emplace_back();
    column.name = name;
    column.description = meaning;
    column.type = "text";
  }
  return columns;
}

// The columns of MANIFEST.tsv.
std::vector<ExportColumn> manifest_columns() {
  std::vector<ExportColumn> columns(4);
  columns[0].name = "file";
  columns[0].description = "file within the folder";
  columns[0].type = "text";
  columns[1].name = "rows";
  columns[1].description = "rows of a table, without the names of the columns";
  columns[1].type = "integer";
  columns[1].missing = "the file is not a table";
  columns[2].name = "sha256";
  columns[2].description = "SHA-256 of the file";
  columns[2].type = "text";
  columns[3].name = "left_out";
  columns[3].description =
      "columns that a public export omits; answer(NAME): the answers to this question";
  columns[3].type = "text";
  columns[3].missing = "none";
  return columns;
}

}  // namespace

void CodebookFile::add(const std::string& file, const std::vector<ExportColumn>& columns) {
  for (const ExportColumn& column : columns) rows_.push_back(codebook_row(file, column));
}

void CodebookFile::write(ExportFolder& folder) {
  add(kCodebook, columns_about_columns());
  add("MANIFEST.tsv", manifest_columns());
  TableFile file(folder.path_of(kCodebook), TableFile::Format::tsv, codebook_columns());
  for (const std::vector<Cell>& row : rows_) file.add(row);
  folder.add(kCodebook, file.finish());
}

}  // namespace asperity
