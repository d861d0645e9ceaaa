// Writes the outcomes of a study as tab-separated rows, and rejects a row with an unreadable cell.

#include "app/power/curve/study_rows.h"

#include <charconv>
#include <system_error>
#include <vector>

#include "app/words/text_parts.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr const char* kMissing = "n/a";

const std::vector<std::string>& columns() {
  static const std::vector<std::string> kColumns{
      "run", "effect",      "participants", "family", "test",  "method",
      "p",   "corrected_p", "estimate",     "lower",  "upper", "status"};
  return kColumns;
}

Cell number_cell(const std::optional<double>& number) {
  return number ? Cell(*number) : Cell(std::monostate{});
}

/// False for a text that is not a number and not missing.
bool read(const std::string& text, std::optional<double>& number) {
  if (text == kMissing) return true;
  number = number_in(text);
  return number.has_value();
}

/// False for a text that is not a whole number of this type.
template <class Whole>
bool read_whole(const std::string& text, Whole& number) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && rest == end;
}

}  // namespace

std::string study_columns() {
  const std::string header = tsv_of({.columns = columns()});
  return header.substr(0, header.find('\n'));
}

std::string rows_of(const PowerOrder& order, const StudyPlace& place,
                    std::span<const SimulatedOutcome> outcomes) {
  Table table{.columns = columns()};
  for (const SimulatedOutcome& outcome : outcomes) {
    table.rows.push_back({place.run, order.effects[place.effect],
                          std::int64_t{order.participants[place.size]}, outcome.family,
                          outcome.test, outcome.method, number_cell(outcome.p),
                          number_cell(outcome.corrected_p), number_cell(outcome.estimate),
                          number_cell(outcome.lower), number_cell(outcome.upper), outcome.status});
  }
  const std::string text = tsv_of(table);
  return text.substr(text.find('\n') + 1);
}

bool StudyRow::is_of(const PowerOrder& order, const StudyPlace& place) const {
  return run == place.run && effect == order.effects[place.effect] &&
         participants == order.participants[place.size];
}

std::optional<StudyRow> study_row_in(std::string_view line) {
  const std::vector<std::string> cells = parts_of(std::string(line), '\t');
  if (cells.size() != columns().size()) return std::nullopt;
  StudyRow row{
      .effect = cells[1],
      .outcome = {.family = cells[3], .test = cells[4], .method = cells[5], .status = cells[11]}};
  const bool is_read = read_whole(cells[0], row.run) && read_whole(cells[2], row.participants) &&
                       read(cells[6], row.outcome.p) && read(cells[7], row.outcome.corrected_p) &&
                       read(cells[8], row.outcome.estimate) && read(cells[9], row.outcome.lower) &&
                       read(cells[10], row.outcome.upper);
  return is_read ? std::optional(row) : std::nullopt;
}

}  // namespace asperity
