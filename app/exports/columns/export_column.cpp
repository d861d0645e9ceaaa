#include "app/exports/columns/export_column.h"

#include <utility>
#include <variant>

namespace asperity {

std::vector<std::string> column_names(const std::vector<ExportColumn>& columns) {
  std::vector<std::string> names{};
  for (const ExportColumn& column : columns) names.push_back(column.name);
  return names;
}

Cell cell_for(ExportAudience audience, const ExportColumn& column, const ExportPlace& at) {
  const bool hidden = audience == ExportAudience::published && at.response_is_withheld &&
                      column.publication == Publication::without_questionnaires;
  const bool is_published = audience == ExportAudience::published && column.published_cell;
  Cell cell = hidden ? Cell{} : is_published ? column.published_cell(at) : column.cell(at);
  const auto* text = std::get_if<std::string>(&cell);
  return text != nullptr && text->empty() ? Cell{} : cell;
}

std::vector<ExportColumn> columns_for(ExportAudience audience, std::vector<ExportColumn> columns,
                                      std::vector<std::string>& left_out) {
  if (audience == ExportAudience::own) return columns;
  std::vector<ExportColumn> kept{};
  for (ExportColumn& column : columns) {
    if (column.publication == Publication::dropped ||
        column.publication == Publication::dropped_unless_named) {
      left_out.push_back(column.name);
    } else {
      kept.push_back(std::move(column));
    }
  }
  return kept;
}

}  // namespace asperity
