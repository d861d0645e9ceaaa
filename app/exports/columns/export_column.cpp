#include "app/exports/columns/export_column.h"

#include <array>
#include <utility>
#include <variant>

namespace asperity {

std::optional<std::string> unit_at_end_of(std::string_view name) {
  // An ending that contains another stands before it.
  static constexpr std::array<std::pair<std::string_view, const char*>, 14> kUnits{
      {{"_N_s_per_m", "N s/m"},
       {"_N_per_m", "N/m"},
       {"_N_m", "N m"},
       {"_m_per_s2", "m/s2"},
       {"_m_per_s", "m/s"},
       {"_rad_per_s", "rad/s"},
       {"_per_m", "1/m"},
       {"_per_s", "1/s"},
       {"_rad", "rad"},
       {"_kg", "kg"},
       {"_Hz", "Hz"},
       {"_N", "N"},
       {"_m", "m"},
       {"_s", "s"}}};
  for (const auto& [ending, unit] : kUnits) {
    if (name.ends_with(ending)) return unit;
  }
  return std::nullopt;
}

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
