// Spools rows into a temporary file, and writes them when the longest text of each column is known.

#include "app/exports/sav_table.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <unistd.h>

#include "results_schema/study.h"
#include "results_schema/tables/table.h"

namespace asperity {

namespace {

constexpr double kMissingCode = -1.0;

bool is_text(const ExportColumn& column) {
  return column.type != "number" && column.type != "integer" && column.type != "boolean";
}

Cell as_text(const Cell& cell) {
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&cell)) return text_of_number(*number);
  return cell;
}

SavVariable::Measure measure_of(const ExportColumn& column) {
  const bool is_quantity = column.type == "number" || column.type == "integer";
  return is_quantity ? SavVariable::Measure::scale : SavVariable::Measure::nominal;
}

}  // namespace

SavTable::SavTable(std::vector<ExportColumn> columns, const std::filesystem::path& spool_folder)
    : spool_folder_(spool_folder), columns_(std::move(columns)), seen_(columns_.size()) {
  std::string path = (spool_folder / "rows-XXXXXX").string();
  const int descriptor = ::mkstemp(path.data());
  if (descriptor >= 0) ::unlink(path.c_str());
  spool_.reset(descriptor < 0 ? nullptr : ::fdopen(descriptor, "w+b"));
  if (!spool_) {
    throw ResultsError("no file can be created in " + spool_folder.string() + ": " +
                           std::strerror(errno) + "; fix the problem, then export again",
                       spool_folder, errno);
  }
}

void SavTable::put(const void* bytes, std::size_t count) {
  if (std::fwrite(bytes, 1, count, spool_.get()) == count) return;
  const int error_number = errno;
  throw ResultsError("the rows of an SPSS table cannot be written to a temporary file in " +
                         spool_folder_.string() + ": " + std::strerror(error_number) +
                         "; free some space there, then export again",
                     spool_folder_, error_number);
}

bool SavTable::get(void* bytes, std::size_t count) {
  return std::fread(bytes, 1, count, spool_.get()) == count;
}

bool SavTable::is_coded(std::size_t column) const {
  return columns_[column].type == "boolean" ||
         (columns_[column].type == "text" && !columns_[column].levels.empty());
}

void SavTable::add(std::vector<Cell> row) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    // Answers to a question may be numbers in some protocols and words in others.
    if (is_text(columns_[i])) row[i] = as_text(row[i]);
    const char kind = static_cast<char>(row[i].index());
    put(&kind, 1);
    Seen& seen = seen_[i];
    if (const auto* whole = std::get_if<std::int64_t>(&row[i])) {
      put(whole, sizeof *whole);
    } else if (const auto* number = std::get_if<double>(&row[i])) {
      put(number, sizeof *number);
    } else if (const auto* text = std::get_if<std::string>(&row[i])) {
      const std::size_t bytes = text->size();
      put(&bytes, sizeof bytes);
      put(text->data(), bytes);
      seen.width_bytes = std::max(seen.width_bytes, bytes);
      if (is_coded(i)) seen.texts.insert(*text);
    } else {
      seen.any_missing = true;
    }
  }
  ++rows_;
}

bool SavTable::read_row(std::vector<Cell>& row) {
  for (Cell& cell : row) {
    char kind = 0;
    if (!get(&kind, 1)) return false;
    switch (kind) {
      case 0:
        cell = Cell{};
        break;
      case 1:
        if (!get(&cell.emplace<std::int64_t>(), sizeof(std::int64_t))) return false;
        break;
      case 2:
        if (!get(&cell.emplace<double>(), sizeof(double))) return false;
        break;
      default: {
        std::size_t bytes = 0;
        if (!get(&bytes, sizeof bytes)) return false;
        std::string& text = cell.emplace<std::string>(bytes, ' ');
        if (!get(text.data(), bytes)) return false;
      }
    }
  }
  return true;
}

std::vector<std::string> SavTable::names() const {
  std::vector<std::string> names{};
  for (const ExportColumn& column : columns_) names.push_back(column.name);
  return sav_names(names);
}

WrittenTable SavTable::write(const std::filesystem::path& path, const std::string& title) {
  const std::vector<std::string> in_file = names();
  std::vector<SavVariable> variables(columns_.size());
  std::vector<std::map<std::string, double>> codes(columns_.size());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const ExportColumn& column = columns_[i];
    SavVariable& variable = variables[i];
    variable.name = in_file[i];
    variable.label = column.description;
    if (!column.unit.empty() && column.unit != "1") variable.label += " [" + column.unit + "]";
    variable.measure = measure_of(column);
    if (column.type != "number") variable.decimals = 0;
    variable.is_text = is_text(column) && !is_coded(i);
    variable.width_bytes = seen_[i].width_bytes;
    if (column.type == "boolean") {
      variable.value_labels = {{0.0, "no"}, {1.0, "yes"}};
    } else if (is_coded(i)) {
      std::vector<std::string> levels = column.levels;
      for (const std::string& text : seen_[i].texts) {  // texts without a declaration
        if (std::find(levels.begin(), levels.end(), text) == levels.end()) levels.push_back(text);
      }
      for (std::size_t level = 0; level < levels.size(); ++level) {
        const auto code = static_cast<double>(level + 1);
        codes[i][levels[level]] = code;
        variable.value_labels.emplace_back(code, levels[level]);
      }
    }
    if (is_coded(i) && seen_[i].any_missing && column.missing != "never") {
      variable.value_labels.emplace_back(kMissingCode, column.missing);
      variable.missing = kMissingCode;
    }
  }
  SavFile file(path, variables, rows_, title);
  std::rewind(spool_.get());
  std::vector<Cell> row(columns_.size());
  for (std::size_t done = 0; done < rows_; ++done) {
    if (!read_row(row)) {
      throw ResultsError(
          "the rows of " + path.string() + " cannot be read from the temporary file; export again",
          path, EIO);
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (const auto* text = std::get_if<std::string>(&row[i]); text != nullptr && is_coded(i)) {
        row[i] = codes[i].at(*text);
      } else if (row[i].index() == 0 && variables[i].missing) {
        row[i] = *variables[i].missing;
      }
    }
    file.add(row);
  }
  return file.finish();
}

}  // namespace asperity
