// Selects the function and the columns of an audience; withheld cells are missing.

#include "app/exports/columns/export_column.h"

#include <utility>
#include <variant>

namespace asperity {

std::vector<std::string> column_names(const std::vector<ExportColumn>& columns) {
  std::vector<std::string> names{};
  for (const ExportColumn& column : columns) names.push_back(column.name);
  return names;
}

namespace {

const std::function<Cell(const ExportPlace&)>& function_of(const ExportColumn& column,
                                                           ExportAudience audience) {
  if (audience == ExportAudience::relabelled && column.relabelled_cell) {
    return column.relabelled_cell;
  }
  return is_public(audience) && column.published_cell ? column.published_cell : column.cell;
}

}  // namespace

bool is_left_out(Publication publication, ExportAudience audience) noexcept {
  switch (publication) {
    case Publication::kept:
    case Publication::without_questionnaires:
    case Publication::without_free_text:
      return false;
    case Publication::dropped_with_new_labels:
      return audience == ExportAudience::relabelled;
    case Publication::dropped_unless_named:
    case Publication::dropped:
      return is_public(audience);
  }
  return false;
}

Cell cell_for(ExportAudience audience, const ExportColumn& column, const ExportPlace& at) {
  const bool is_hidden = is_public(audience) && at.response_is_withheld &&
                         column.publication == Publication::without_questionnaires;
  Cell cell = is_hidden ? Cell{} : function_of(column, audience)(at);
  const auto* text = std::get_if<std::string>(&cell);
  return text != nullptr && text->empty() ? Cell{} : cell;
}

std::vector<ExportColumn> columns_for(ExportAudience audience, std::vector<ExportColumn> columns,
                                      std::vector<std::string>& left_out) {
  std::vector<ExportColumn> kept{};
  for (ExportColumn& column : columns) {
    if (is_left_out(column.publication, audience)) {
      left_out.push_back(column.name);
    } else {
      kept.push_back(std::move(column));
    }
  }
  return kept;
}

}  // namespace asperity
