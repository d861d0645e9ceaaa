// Writes to standard error under a mutex, limits how often progress is shown, and aligns columns.

#include "app/cli/output/terminal.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <ctime>
#include <string_view>
#include <unistd.h>
#include <utility>

#include "app/findings/outcome/display_number.h"
#include "app/study_files/study_condition.h"
#include "app/words/shown_text.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

std::mutex& error_stream_mutex() {
  static std::mutex mutex;
  return mutex;
}

void write_error(std::string_view text) {
  const std::lock_guard lock(error_stream_mutex());
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string text_of_cell(const Cell& cell) {
  if (std::holds_alternative<std::monostate>(cell)) return "n/a";
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return display_whole(*whole);
  if (const auto* number = std::get_if<double>(&cell)) {
    return *number < 0.0 ? "−" + text_of_number(-*number) : text_of_number(*number);
  }
  return shown_in_a_line(std::get<std::string>(cell));
}

}  // namespace

Progress::Progress(std::string what, std::optional<std::chrono::steady_clock::duration> between)
    : what_(std::move(what)),
      between_(between),
      terminal_(isatty(STDERR_FILENO) == 1),
      last_line_(std::chrono::steady_clock::now()) {}

Progress::~Progress() {
  if (terminal_ && last_ >= 0) write_error("\r\x1b[K");
}

bool Progress::is_due(int percent) {
  if (terminal_) return percent > last_;
  if (!between_) return percent / 10 > last_ / 10 || last_ < 0;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_line_ < *between_) return false;
  last_line_ = now;
  return true;
}

void Progress::show(double fraction) {
  const std::lock_guard lock(mutex_);
  const int percent = static_cast<int>(std::floor(100.0 * std::clamp(fraction, 0.0, 1.0)));
  if (!is_due(percent)) return;
  last_ = percent;
  if (!terminal_) {
    const int shown = between_ ? percent : percent / 10 * 10;
    write_error(what_ + ": " + std::to_string(shown) + " %\n");
    return;
  }
  constexpr int kWidth = 30;
  const int full = kWidth * percent / 100;
  std::string bar{};
  for (int i = 0; i < kWidth; ++i) bar += i < full ? "█" : "░";
  write_error("\r\x1b[K" + what_ + ' ' + bar + ' ' + std::to_string(percent) + " %");
}

void say(const std::string& line) {
  // A progress bar may stand on the line; it comes back below with its next step.
  static const bool terminal = isatty(STDERR_FILENO) == 1;
  write_error((terminal ? "\r\x1b[K" : "") + shown_in_a_line(line) + '\n');
}

ShownOutput::ShownOutput(std::ostream& stream) : stream_(stream), target_(stream.rdbuf(this)) {}

ShownOutput::~ShownOutput() { stream_.rdbuf(target_); }

ShownOutput::int_type ShownOutput::overflow(int_type character) {
  if (traits_type::eq_int_type(character, traits_type::eof()))
    return traits_type::not_eof(character);
  const char letter = traits_type::to_char_type(character);
  return xsputn(&letter, 1) == 1 ? character : traits_type::eof();
}

std::streamsize ShownOutput::xsputn(const char* text, std::streamsize count) {
  const std::string shown = shown_in_lines({text, static_cast<std::size_t>(count)});
  const auto size = static_cast<std::streamsize>(shown.size());
  return target_->sputn(shown.data(), size) == size ? count : 0;
}

int ShownOutput::sync() { return target_->pubsync(); }

std::string warning_text(const Diagnostic& warning) {
  return warning.file + ':' + std::to_string(warning.line) + ':' + std::to_string(warning.column) +
         ": warning: " + warning.message.english() + " (" + warning.pointer + ')';
}

void say_condition(const Study& study) {
  if (const auto remark = remark_on(study)) say("asperity: " + remark->english());
}

void say_unrecorded(const std::optional<Phrase>& why) {
  if (why) say("asperity: " + why->english());
}

std::string local_time_text(const std::string& utc) {
  std::tm parts{};
  if (::strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%S", &parts) == nullptr) return utc;
  const std::time_t time = ::timegm(&parts);
  std::tm local{};
  ::localtime_r(&time, &local);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &local);
  return text.data();
}

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

std::string aligned(const Table& table) {
  std::vector<bool> numeric(table.columns.size(), true);
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (std::holds_alternative<std::string>(row[column])) numeric[column] = false;
    }
  }
  return aligned(table, numeric);
}

std::string aligned(const Table& table, const std::vector<bool>& numeric) {
  const std::size_t columns = table.columns.size();
  std::vector<std::size_t> widths(columns, 0);
  std::vector<std::vector<std::string>> texts{};
  for (std::size_t column = 0; column < columns; ++column) {
    widths[column] = width_of(table.columns[column]);
  }
  for (const std::vector<Cell>& row : table.rows) {
    std::vector<std::string>& cells = texts.emplace_back();
    for (std::size_t column = 0; column < columns; ++column) {
      cells.push_back(shown_in_a_line(text_of_cell(row.at(column))));
      widths[column] = std::max(widths[column], width_of(cells.back()));
    }
  }
  std::string out{};
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string text{};
    for (std::size_t column = 0; column < columns; ++column) {
      const std::string room(widths[column] - width_of(cells[column]), ' ');
      if (column > 0) text += "  ";
      text += numeric[column] ? room + cells[column] : cells[column] + room;
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + '\n';
  };
  line(table.columns);
  for (const std::vector<std::string>& cells : texts) line(cells);
  return out;
}

}  // namespace asperity
