// Tables as text: the TSV that the program writes and reads back.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asperity {

/// Missing, a whole number, a number, or text.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

struct Table {
  std::vector<std::string> columns{};
  std::vector<std::vector<Cell>> rows{};
};

/// UTF-8, one header line, `n/a` for missing, shortest digits that read back to the same number
/// whatever the locale. Tabs, line breaks and carriage returns in text become spaces (TSV has no
/// quoting); `replaced` counts the cells in which that happened.
std::string tsv_of(const Table& table, std::size_t* replaced = nullptr);

/// Reads what `tsv_of` writes; every cell is text or missing. Errors: ResultsError with line and
/// column for a row of another length, a missing header, a name that stands twice.
Table read_tsv(std::string_view text, const std::string& file_name);

/// Shortest digits that read back to the same double; "nan", "inf", "-inf" for those.
std::string text_of_number(double value);
/// The whole text as a number, whatever the locale; nothing when it is not one.
std::optional<double> number_in(std::string_view text);
/// The order of names: those that are numbers by value ("4.6e-05" before "5e-05"), then the others as texts.
bool precedes_by_value(std::string_view one, std::string_view other);

}  // namespace asperity
