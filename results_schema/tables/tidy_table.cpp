// Quoted cells are unquoted in place: a cell never becomes longer.

#include "results_schema/tables/tidy_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

#include "results_schema/study.h"
#include "results_schema/tables/name_forms.h"
#include "results_schema/tables/table.h"
#include "results_schema/tables/table_words.h"

namespace asperity {
namespace {

bool is_missing(std::string_view cell) {
  return cell.empty() || cell == "NA" || cell == kMissingCell;
}

/// The unseen character at an end of a text; null without one.
const UnseenCharacter* unseen_at_end(std::string_view text) {
  for (const UnseenCharacter& each : kUnseenCharacters) {
    if (text.starts_with(each.bytes) || text.ends_with(each.bytes)) return &each;
  }
  return nullptr;
}

std::string_view without_blanks(std::string_view cell) {
  for (;;) {
    if (const UnseenCharacter* const unseen = unseen_at_end(cell)) {
      const bool is_first = cell.starts_with(unseen->bytes);
      cell.remove_prefix(is_first ? unseen->bytes.size() : 0);
      cell.remove_suffix(is_first ? 0 : unseen->bytes.size());
    } else if (cell.starts_with(' ') || cell.starts_with('\t')) {
      cell.remove_prefix(1);
    } else if (cell.ends_with(' ') || cell.ends_with('\t')) {
      cell.remove_suffix(1);
    } else {
      return cell;
    }
  }
}

/// The digits of a number whose thousands are separated, such as "1,000", "-1 000 000.5" or "1'000": without the
/// separators. Nothing for any other text.
std::optional<std::string> without_thousands(std::string_view cell) {
  std::string plain(cell);
  for (const UnseenCharacter& each : kUnseenCharacters) {
    for (std::size_t at = 0; (at = plain.find(each.bytes)) != std::string::npos;) {
      plain.replace(at, each.bytes.size(), " ");
    }
  }
  const auto is_digit = [&plain](std::size_t i) {
    return i < plain.size() && plain[i] >= '0' && plain[i] <= '9';
  };
  std::size_t at = plain.starts_with('-') ? 1 : 0;
  const std::size_t first = at;
  while (is_digit(at)) ++at;
  // 0,125 is no number of thousands.
  if (at == first || at - first > 3 || plain[first] == '0' || at >= plain.size()) return {};
  const char separator = plain[at];
  if (separator != ',' && separator != ' ' && separator != '\'') return {};
  while (at < plain.size() && plain[at] == separator) {
    if (!is_digit(at + 1) || !is_digit(at + 2) || !is_digit(at + 3)) return {};
    plain.erase(at, 1);
    at += 3;
  }
  if (!number_in(plain)) return {};
  return plain;
}

bool has_decimal_comma(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  if (comma == std::string_view::npos) return false;
  std::string pointed(cell);
  pointed[comma] = '.';
  return number_in(pointed).has_value();
}

/// Walks over the text of a file from a place in its first line on, cell by cell.
class CellReader final {
 public:
  CellReader(std::string& text, std::size_t begin, std::uint32_t line, const std::string& name)
      : text_(text), name_(name), at_(begin), line_(line) {}

  bool at_end() const { return at_ >= text_.size(); }
  std::uint32_t line() const { return line_; }
  void begin_row() { column_ = 0; }
  std::size_t column() const { return column_; }

  [[noreturn]] void refuse(const std::string& sentence) const {
    throw ResultsError(
        name_ + ':' + std::to_string(line_) + ':' + std::to_string(column_) + ": " + sentence,
        name_);
  }

  /// The next cell of this row; `last` when the row ends with it.
  std::string_view next(char separator, bool& last) {
    ++column_;
    char* const begin = text_.data() + at_;
    char* end = begin;
    if (!at_end() && *begin == '"') {
      end = unquote(begin, separator);
    } else {
      while (!at_end() && text_[at_] != separator && text_[at_] != '\n') ++at_;
      end = text_.data() + at_;
      if ((at_end() || text_[at_] == '\n') && end > begin && end[-1] == '\r') --end;
    }
    last = at_end() || text_[at_] == '\n';
    if (!at_end()) {
      if (text_[at_] == '\n') ++line_;
      ++at_;
    }
    return {begin, static_cast<std::size_t>(end - begin)};
  }

 private:
  char* unquote(char* out, char separator) {
    ++at_;
    std::uint32_t breaks = 0;
    for (;; ++at_) {
      if (at_end())
        refuse("the quotation mark that opens this cell is not closed; add the closing one");
      if (text_[at_] == '"') {
        ++at_;
        if (at_end() || text_[at_] != '"') break;
      }
      if (text_[at_] == '\n') ++breaks;
      *out++ = text_[at_];
    }
    if (!at_end() && text_[at_] == '\r') ++at_;
    if (!at_end() && text_[at_] != separator && text_[at_] != '\n') {
      refuse(
          "text follows the quotation mark that closes this cell; write a quotation mark within "
          "the cell twice");
    }
    line_ += breaks;
    return out;
  }

  std::string& text_;
  const std::string& name_;
  std::size_t at_;
  std::uint32_t line_;
  std::size_t column_ = 0;
};

/// Where the text stops being UTF-8; its size when it is.
std::size_t utf8_ends_at(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  std::size_t at = 0;
  while (at < text.size()) {
    const unsigned char first = byte(at);
    if (first < 0x80) {
      ++at;
      continue;
    }
    const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || text.size() - at < length) return at;
    // Too long a form, half of a pair of UTF-16 or more than there is: the second byte tells.
    const unsigned char second = byte(at + 1);
    const unsigned char least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned char most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (second < least || second > most) return at;
    for (std::size_t i = 2; i < length; ++i) {
      if (byte(at + i) < 0x80 || byte(at + i) > 0xBF) return at;
    }
    at += length;
  }
  return at;
}

char separator_of(std::string_view header, const std::string& name) {
  const auto has = [header](char c) { return header.find(c) != std::string_view::npos; };
  if (has('\t')) return '\t';
  if (!has(',') && has(';')) {
    throw ResultsError(name +
                           ":1:1: the columns are separated by semicolons; save the table with "
                           "commas (or tabs) and decimal points",
                       name);
  }
  return ',';
}

}  // namespace

TidyTable::TidyTable(std::string whole, std::string name)
    : text_(std::make_unique<std::string>(std::move(whole))), name_(std::move(name)) {
  std::string_view text = *text_;
  if (text.substr(0, 2) == "\xFF\xFE" || text.substr(0, 2) == "\xFE\xFF") {
    throw ResultsError(name_ + ":1:1: the file is UTF-16; save it as UTF-8", name_);
  }
  text = text_of_table(text, name_);
  if (const std::size_t end = utf8_ends_at(text); end < text.size()) {
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    throw ResultsError(name_ + ':' + std::to_string(line) +
                           ": a character of this line is not UTF-8; save the table as UTF-8",
                       name_);
  }
  // Spreadsheets write this line for themselves: it states the separator, which the header shows as well.
  std::uint32_t header = 1;
  if (text.starts_with("sep=") && text.find_first_of("\r\n") == 5) {
    text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
    ++header;
  }
  CellReader reader(*text_, text_->size() - text.size(), header, name_);
  const char separator = separator_of(text.substr(0, text.find('\n')), name_);
  if (reader.at_end())
    reader.refuse("the header line is missing; add a line with the names of the columns");
  for (bool last = false; !last;) {
    const std::string_view cell = reader.next(separator, last);
    const auto place =
        name_ + ':' + std::to_string(header) + ':' + std::to_string(reader.column()) + ": ";
    if (cell.empty()) throw ResultsError(place + "the column has no name; give it one", name_);
    if (has(cell)) {
      throw ResultsError(place + "the column name \"" + std::string(cell) +
                             "\" occurs twice; rename one of the columns",
                         name_);
    }
    add_column(std::string(cell));
  }
  // At once: while they grow there would be two of the largest part of a table.
  const auto most_rows = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  lines_.reserve(most_rows);
  // A cell is a character long at least, whatever the header and empty lines promise.
  cells_.reserve(std::min(most_rows * columns_.size(), text.size() + 1));
  while (!reader.at_end()) {
    const std::uint32_t line = reader.line();
    const std::size_t begin = cells_.size();
    reader.begin_row();
    for (bool last = false; !last;) cells_.push_back(reader.next(separator, last));
    const std::size_t found = cells_.size() - begin;
    if (found == 1 && cells_.back().empty()) {
      cells_.pop_back();
      continue;
    }
    if (found != columns_.size()) {
      throw ResultsError(
          name_ + ':' + std::to_string(line) + ':' +
              std::to_string(std::min(found, columns_.size()) + 1) + ": the row has " +
              std::to_string(found) + (found == 1 ? " cell" : " cells") + ", the header has " +
              std::to_string(columns_.size()) + (columns_.size() == 1 ? " column" : " columns") +
              (separator == ',' && found > columns_.size()
                   ? "; put quotation marks around a text that contains a comma, and write numbers "
                     "with a decimal point"
                   : "; give each row one cell per column"),
          name_);
    }
    lines_.push_back(line);
  }
}

std::size_t TidyTable::rows_in(const std::variant<LabelColumn, NumberColumn>& cells) noexcept {
  const auto* const labels = std::get_if<LabelColumn>(&cells);
  return labels == nullptr ? std::get<NumberColumn>(cells).size() : labels->codes.size();
}

TidyTable::TidyTable(std::vector<Column> columns, std::string name) : name_(std::move(name)) {
  const auto refuse_column = [this](const Column& column, const char* why) {
    throw std::invalid_argument("the column " + column.name + " of " + name_ + why);
  };
  for (Column& column : columns) {
    if (!made_.empty() && rows_in(column.cells) != rows()) {
      refuse_column(column,
                    " is not as long as the first one; all columns must have the same length");
    }
    if (const auto* const labels = std::get_if<LabelColumn>(&column.cells)) {
      const bool has_names =
          std::all_of(labels->codes.begin(), labels->codes.end(), [labels](std::size_t code) {
            return code < labels->names.size() || code == LabelColumn::kMissing;
          });
      if (!has_names) {
        refuse_column(
            column, " has a code without a name; every code must be less than the number of names");
      }
    } else {
      const NumberColumn& numbers = std::get<NumberColumn>(column.cells);
      const bool is_finite = std::all_of(
          numbers.begin(), numbers.end(),
          [](const std::optional<double>& number) { return !number || std::isfinite(*number); });
      if (!is_finite) {
        refuse_column(column, " has a number that is not finite; all must be finite");
      }
    }
    add_column(std::move(column.name));
    made_.push_back(std::move(column.cells));
  }
}

const LabelColumn& TidyTable::made_names(std::size_t column) const {
  if (const auto* const labels = std::get_if<LabelColumn>(&made_[column])) return *labels;
  throw std::logic_error("the column " + columns_[column] + " of " + name_ +
                         " has numbers, not names; read it as numbers");
}

void TidyTable::add_column(std::string column) {
  index_of_column_.emplace(column, columns_.size());  // the first of equal names
  columns_.push_back(std::move(column));
}

bool TidyTable::has(std::string_view column) const {
  return index_of_column_.contains(std::string(column));
}

std::size_t TidyTable::index_of(std::string_view column) const {
  const auto found = index_of_column_.find(std::string(column));
  if (found != index_of_column_.end()) return found->second;
  std::string sentence = name_ + ":1:1: there is no column \"" + std::string(column) +
                         "\"; add it, or use one of the columns";
  constexpr std::size_t kMostNamed = 100;
  for (std::size_t i = 0; i < std::min(columns_.size(), kMostNamed); ++i) {
    sentence += (i > 0 ? ", " : " ") + columns_[i];
  }
  if (columns_.size() > kMostNamed) {
    sentence += " and " + std::to_string(columns_.size() - kMostNamed) + " more";
  }
  throw ResultsError(sentence, name_);
}

std::string_view TidyTable::cell(std::size_t row, std::size_t column) const {
  if (!made_.empty()) {
    const LabelColumn& made = made_names(column);
    const std::size_t code = made.codes[row];
    return code == LabelColumn::kMissing ? std::string_view{} : made.names[code];
  }
  const std::string_view text = cells_[row * columns_.size() + column];
  return is_missing(text) ? std::string_view{} : text;
}

void TidyTable::refuse(std::size_t row, std::string_view column,
                       const std::string& sentence) const {
  const std::size_t line = made_.empty() ? lines_[row] : row + 2;
  throw ResultsError(name_ + ':' + std::to_string(line) + ':' +
                         std::to_string(index_of(column) + 1) + ": " + sentence,
                     name_);
}

std::vector<std::string_view> TidyTable::texts(std::string_view column) const {
  const std::size_t index = index_of(column);
  std::vector<std::string_view> texts(rows());
  for (std::size_t row = 0; row < rows(); ++row) texts[row] = cell(row, index);
  return texts;
}

bool TidyTable::has_certain_decimal_comma(std::size_t column) const {
  for (std::size_t row = 0; row < rows(); ++row) {
    const std::string_view text = without_blanks(cell(row, column));
    if (has_decimal_comma(text) && !without_thousands(text)) return true;
  }
  return false;
}

std::vector<std::optional<double>> TidyTable::numbers(std::string_view column) const {
  const std::size_t index = index_of(column);
  if (!made_.empty()) {
    if (const auto* const made = std::get_if<NumberColumn>(&made_[index])) return *made;
  }
  std::vector<std::optional<double>> numbers(rows());
  for (std::size_t row = 0; row < rows(); ++row) {
    std::string_view text = without_blanks(cell(row, index));
    if (is_missing(text)) continue;
    if (text.front() == '+') text.remove_prefix(1);
    numbers[row] = number_in(text);
    if (numbers[row] && std::isfinite(*numbers[row])) {
      const double magnitude = std::abs(*numbers[row]);
      if (magnitude == 0.0 || (magnitude >= kLeastNumber && magnitude <= kGreatestNumber)) continue;
      refuse(row, column,
             std::string(column) + " is " + std::string(text) +
                 "; numbers from 1e-100 to 1e100 in magnitude can be analysed. Write it in another "
                 "unit");
    }
    const std::string of = std::string(column) + " is \"" + std::string(text) + "\", ";
    const bool may_be_decimal = text.find(',') != std::string_view::npos;
    if (const auto plain = without_thousands(text);
        plain && !(may_be_decimal && has_certain_decimal_comma(index))) {
      refuse(row, column, of + "with a thousands separator; write " + *plain);
    }
    if (text.starts_with(kMinusSign)) {
      refuse(row, column, of + "with a minus sign (U+2212); write a hyphen (-)");
    }
    if (has_decimal_comma(text))
      refuse(row, column, of + "with a decimal comma; write a decimal point");
    refuse(row, column, of + "which is not a number; write a number, or leave the cell empty");
  }
  return numbers;
}

std::vector<double> TidyTable::all_numbers(std::string_view column) const {
  const std::vector<std::optional<double>> found = numbers(column);
  std::vector<double> all(found.size());
  for (std::size_t row = 0; row < found.size(); ++row) {
    if (!found[row]) refuse(row, column, std::string(column) + " is missing; enter a value");
    all[row] = *found[row];
  }
  return all;
}

std::vector<std::uint64_t> TidyTable::counts(std::string_view column, std::uint64_t most) const {
  const std::vector<double> found = all_numbers(column);
  std::vector<std::uint64_t> counts(found.size());
  const auto most_number = static_cast<double>(most);
  for (std::size_t row = 0; row < found.size(); ++row) {
    if (!(found[row] >= 0.0 && found[row] <= most_number && std::floor(found[row]) == found[row])) {
      refuse(row, column,
             std::string(column) + " is " + text_of_number(found[row]) +
                 "; it must be a whole number from 0" +
                 (most < kMostCounted || found[row] > most_number ? " to " + std::to_string(most)
                                                                  : ""));
    }
    counts[row] = static_cast<std::uint64_t>(found[row]);
  }
  return counts;
}

LabelColumn TidyTable::made_labels(const LabelColumn& made) const {
  LabelColumn labels{};
  labels.codes.resize(made.codes.size(), LabelColumn::kMissing);
  std::vector<std::size_t> code_of(made.names.size(), LabelColumn::kMissing);
  for (std::size_t row = 0; row < made.codes.size(); ++row) {
    if (made.codes[row] == LabelColumn::kMissing) continue;
    std::size_t& code = code_of[made.codes[row]];
    if (code == LabelColumn::kMissing) {
      code = labels.names.size();
      labels.names.push_back(made.names[made.codes[row]]);
    }
    labels.codes[row] = code;
  }
  return labels;
}

LabelColumn TidyTable::labels(std::string_view column) const {
  const std::size_t index = index_of(column);
  if (!made_.empty()) return made_labels(made_names(index));
  LabelColumn labels{};
  labels.codes.resize(rows(), LabelColumn::kMissing);
  std::unordered_map<std::string_view, std::size_t> code_of{};
  for (std::size_t row = 0; row < rows(); ++row) {
    const std::string_view text = cell(row, index);
    if (text.empty()) continue;
    const auto [found, first] = code_of.emplace(text, labels.names.size());
    if (first) labels.names.emplace_back(text);
    labels.codes[row] = found->second;
    if (!first) continue;
    if (const UnseenCharacter* const unseen = unseen_at_end(text)) {
      refuse(row, column,
             std::string(column) + " is \"" + std::string(text) + "\", with " +
                 std::string(unseen->name) + " at an end; delete it");
    }
  }
  if (const auto pair = names_in_two_forms(labels.names)) {
    const auto second = std::find(labels.codes.begin(), labels.codes.end(), pair->second);
    refuse(static_cast<std::size_t>(second - labels.codes.begin()), column,
           std::string(column) + " is \"" + labels.names[pair->second] +
               "\", and an earlier row has \"" + labels.names[pair->first] +
               "\": an accented letter is one character in one of them and two in the other. "
               "Write the name with the same characters everywhere (Unicode NFC)");
  }
  return labels;
}

LabelColumn TidyTable::labels(std::string_view column, std::vector<std::string> names) const {
  const LabelColumn found = labels(column);
  std::vector<std::size_t> code_of(found.names.size(), LabelColumn::kMissing);
  for (std::size_t i = 0; i < found.names.size(); ++i) {
    const auto name = std::find(names.begin(), names.end(), found.names[i]);
    if (name != names.end()) code_of[i] = static_cast<std::size_t>(name - names.begin());
  }
  LabelColumn labels{.names = std::move(names), .codes = found.codes};
  for (std::size_t row = 0; row < rows(); ++row) {
    std::size_t& code = labels.codes[row];
    if (code == LabelColumn::kMissing) continue;
    if (code_of[code] == LabelColumn::kMissing) {
      std::string sentence =
          std::string(column) + " is \"" + found.names[code] + "\"; it must be one of:";
      for (std::size_t i = 0; i < labels.names.size(); ++i) {
        sentence += (i > 0 ? ", " : " ") + labels.names[i];
      }
      refuse(row, column, sentence);
    }
    code = code_of[code];
  }
  return labels;
}

LabelColumn TidyTable::all_labels(std::string_view column) const {
  LabelColumn found = labels(column);
  const auto missing = std::find(found.codes.begin(), found.codes.end(), LabelColumn::kMissing);
  if (missing != found.codes.end()) {
    refuse(static_cast<std::size_t>(missing - found.codes.begin()), column,
           std::string(column) + " is missing; enter a value");
  }
  return found;
}

}  // namespace asperity
