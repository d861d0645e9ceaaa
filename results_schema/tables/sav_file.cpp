// Writes with ReadStat: shortens names and labels, and sets a fixed date for equal bytes.

#include "results_schema/tables/sav_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <new>
#include <set>
#include <stdexcept>

#include <readstat.h>

#include "results_schema/files/file_system.h"
#include "results_schema/hashes/sha256_stream.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

constexpr std::size_t kMostOfAName_bytes = 64;
constexpr std::size_t kMostOfALabel_bytes = 255;
constexpr std::size_t kMostOfAValueLabel_bytes = 120;
constexpr std::size_t kMostOfAText_bytes = 32'000;

/// Where the header of a system file keeps when it was written, and what stands there instead.
constexpr std::size_t kDateAt = 92;
constexpr std::string_view kNoDate = "01 Jan 7000:00:00";

bool is_reserved(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  });
  static constexpr std::array<std::string_view, 13> kWords{
      "ALL", "AND", "BY", "EQ", "GE", "GT", "LE", "LT", "NE", "NOT", "OR", "TO", "WITH"};
  return std::find(kWords.begin(), kWords.end(), name) != kWords.end();
}

/// As much of `text` as fits, whole characters, and a sign that there was more.
std::string shortened(const std::string& text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return text;
  constexpr std::string_view kMore = "…";
  std::size_t end = most_bytes - kMore.size();
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end).append(kMore);
}

/// Labels of values as they fit, those that are cut with a number where they would be alike.
std::vector<std::string> shortened_apart(
    const std::vector<std::pair<double, std::string>>& value_labels) {
  std::set<std::string> taken{};
  for (const auto& [value, label] : value_labels) {
    if (label.size() <= kMostOfAValueLabel_bytes) taken.insert(label);
  }
  std::vector<std::string> made{};
  for (const auto& [value, label] : value_labels) {
    std::string text = shortened(label, kMostOfAValueLabel_bytes);
    if (label.size() > kMostOfAValueLabel_bytes) {
      for (int number = 2; !taken.insert(text).second; ++number) {
        const std::string ending = " (" + std::to_string(number) + ")";
        text = shortened(label, kMostOfAValueLabel_bytes - ending.size()) + ending;
      }
    }
    made.push_back(std::move(text));
  }
  return made;
}

readstat_measure_t measure_of(SavVariable::Measure measure) {
  switch (measure) {
    case SavVariable::Measure::nominal:
      return READSTAT_MEASURE_NOMINAL;
    case SavVariable::Measure::ordinal:
      return READSTAT_MEASURE_ORDINAL;
    case SavVariable::Measure::scale:
      return READSTAT_MEASURE_SCALE;
  }
  return READSTAT_MEASURE_UNKNOWN;
}

}  // namespace

std::vector<std::string> sav_names(const std::vector<std::string>& names) {
  std::set<std::string> taken{};
  const auto in_lower_case = [](std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](char letter) {
      return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    });
    return name;
  };
  std::vector<std::string> made{};
  for (std::string name : names) {
    for (char& letter : name) {
      if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
    }
    if (name.empty() || std::isalpha(static_cast<unsigned char>(name.front())) == 0 ||
        is_reserved(name)) {
      name = "v_" + name;
    }
    name.resize(std::min(name.size(), kMostOfAName_bytes));
    while (name.size() > 1 && name.back() == '_') name.pop_back();
    std::string candidate = name;
    for (int number = 2; !taken.insert(in_lower_case(candidate)).second; ++number) {
      const std::string ending = "_" + std::to_string(number);
      candidate = name.substr(0, kMostOfAName_bytes - ending.size()) + ending;
    }
    made.push_back(std::move(candidate));
  }
  return made;
}

struct SavFile::State {
  explicit State(const std::filesystem::path& file_path)
      : file(file_path), writer(readstat_writer_init()) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { readstat_writer_free(writer); }

  /// ReadStat's way out: C, so that nothing may be thrown through it.
  static ssize_t take(const void* bytes, std::size_t count, void* state) noexcept {
    auto* self = static_cast<State*>(state);
    try {
      std::string text(static_cast<const char*>(bytes), count);
      for (std::size_t i = 0; i < kNoDate.size(); ++i) {
        const std::size_t at = kDateAt + i;
        if (at >= self->bytes && at < self->bytes + count) text[at - self->bytes] = kNoDate[i];
      }
      self->bytes += count;
      self->buffer += text;
      if (self->buffer.size() > kBuffer_bytes) self->flush();
      return static_cast<ssize_t>(count);
    } catch (...) {
      self->failure = std::current_exception();
      return -1;
    }
  }

  void flush() {
    sha256.add(buffer.data(), buffer.size());
    file.write(buffer.data(), buffer.size());
    buffer.clear();
  }

  void check(readstat_error_t code) {
    if (failure) std::rethrow_exception(failure);
    if (code == READSTAT_OK) return;
    if (code == READSTAT_ERROR_MALLOC) throw std::bad_alloc();
    throw ResultsError("the file " + file.path().string() + " cannot be written: " +
                           readstat_error_message(code) + "; fix the problem, then export again",
                       file.path());
  }

  static constexpr std::size_t kBuffer_bytes = std::size_t{1} << 18;
  OutputFile file;
  readstat_writer_t* writer;
  std::vector<readstat_variable_t*> variables{};
  std::size_t bytes = 0;
  std::string buffer{};
  Sha256Stream sha256{};
  WrittenTable written{};
  std::exception_ptr failure{};
};

SavFile::SavFile(const std::filesystem::path& path, const std::vector<SavVariable>& variables,
                 std::size_t rows, const std::string& title)
    : state_(std::make_unique<State>(path)) {
  readstat_writer_t* const writer = state_->writer;
  readstat_set_data_writer(writer, &State::take);
  readstat_writer_set_file_label(writer, shortened(title, 64).c_str());
  readstat_writer_set_file_timestamp(writer, 0);
  state_->check(readstat_writer_set_compression(writer, READSTAT_COMPRESS_ROWS));
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const SavVariable& variable = variables[i];
    const std::size_t width = std::clamp(variable.width_bytes, std::size_t{1}, kMostOfAText_bytes);
    readstat_variable_t* const made =
        readstat_add_variable(writer, variable.name.c_str(),
                              variable.is_text ? READSTAT_TYPE_STRING : READSTAT_TYPE_DOUBLE,
                              variable.is_text ? width : 0);
    state_->variables.push_back(made);
    readstat_variable_set_label(made, shortened(variable.label, kMostOfALabel_bytes).c_str());
    if (!variable.is_text) {
      const std::string format = "F12." + std::to_string(variable.decimals);
      readstat_variable_set_format(made, format.c_str());
    }
    readstat_variable_set_measure(made, measure_of(variable.measure));
    if (!variable.value_labels.empty()) {
      readstat_label_set_t* const labels = readstat_add_label_set(
          writer, READSTAT_TYPE_DOUBLE, ("labels" + std::to_string(i)).c_str());
      const std::vector<std::string> texts = shortened_apart(variable.value_labels);
      for (std::size_t label = 0; label < texts.size(); ++label) {
        const auto& [value, text] = variable.value_labels[label];
        if (text.size() > kMostOfAValueLabel_bytes) ++state_->written.cut_cells;
        readstat_label_double_value(labels, value, texts[label].c_str());
      }
      readstat_variable_set_label_set(made, labels);
    }
    if (variable.missing) {
      state_->check(readstat_variable_add_missing_double_value(made, *variable.missing));
    }
  }
  state_->check(readstat_begin_writing_sav(writer, state_.get(), static_cast<long>(rows)));
}

SavFile::~SavFile() = default;

void SavFile::add(const std::vector<Cell>& row) {
  readstat_writer_t* const writer = state_->writer;
  state_->check(readstat_begin_row(writer));
  for (std::size_t i = 0; i < row.size(); ++i) {
    const readstat_variable_t* const variable = state_->variables.at(i);
    if (const auto* whole = std::get_if<std::int64_t>(&row[i])) {
      state_->check(readstat_insert_double_value(writer, variable, static_cast<double>(*whole)));
    } else if (const auto* number = std::get_if<double>(&row[i])) {
      state_->check(readstat_insert_double_value(writer, variable, *number));
    } else if (const auto* text = std::get_if<std::string>(&row[i])) {
      const bool fits = text->size() <= kMostOfAText_bytes;
      if (!fits) ++state_->written.cut_cells;
      state_->check(readstat_insert_string_value(
          writer, variable, fits ? text->c_str() : shortened(*text, kMostOfAText_bytes).c_str()));
    } else {
      state_->check(readstat_insert_missing_value(writer, variable));
    }
  }
  state_->check(readstat_end_row(writer));
  ++state_->written.rows;
}

WrittenTable SavFile::finish() {
  state_->check(readstat_end_writing(state_->writer));
  state_->flush();
  state_->written.sha256 = state_->sha256.hexadecimal();
  return state_->written;
}

}  // namespace asperity
