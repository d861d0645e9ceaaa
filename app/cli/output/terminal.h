// What the command line prints with: progress and tables that fit a terminal.

#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <vector>

#include "analysis/words/phrase.h"
#include "protocols/file/diagnostic.h"
#include "results_schema/study.h"
#include "results_schema/tables/table.h"

namespace asperity {

/// The longest line of a sentence on a terminal.
inline constexpr std::size_t kTerminalColumns = 100;

/// A bar on a terminal, plain lines otherwise; on standard error.
///
/// Threads: any.
class Progress final {
 public:
  /// A line every tenth; with `between` instead at most one in this time, the first after it: for a command whose other
  /// messages stand on standard error too, so that a short one has none.
  explicit Progress(std::string what,
                    std::optional<std::chrono::steady_clock::duration> between = {});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `fraction` from 0 to 1.
  void show(double fraction);

 private:
  bool is_due(int percent);

  std::string what_{};
  std::optional<std::chrono::steady_clock::duration> between_{};
  bool terminal_ = false;
  int last_ = -1;  ///< percent
  std::chrono::steady_clock::time_point last_line_{};
  std::mutex mutex_{};
};

/// One line on standard error, whole also where other threads write, with control characters shown. Threads: any.
void say(const std::string& line);

/// While it lives, what is written to a stream has its control characters shown, except line feeds and tabs
/// (app/words/shown_text.h): names, labels and texts of files are among it.
class ShownOutput final : private std::streambuf {
 public:
  /// `stream` must outlive it.
  explicit ShownOutput(std::ostream& stream);
  ~ShownOutput() override;
  ShownOutput(const ShownOutput&) = delete;
  ShownOutput& operator=(const ShownOutput&) = delete;

 private:
  int_type overflow(int_type character) override;
  std::streamsize xsputn(const char* text, std::streamsize count) override;
  int sync() override;

  std::ostream& stream_;
  std::streambuf* target_;
};

/// "FILE:LINE:COLUMN: warning: PROBLEM (/json/pointer)"
std::string warning_text(const Diagnostic& warning);

/// What whoever reads on should know of the study's file, if anything.
void say_condition(const Study& study);

/// Why the study does not list what was made of it, if it does not.
void say_unrecorded(const std::optional<Phrase>& why);

/// "2026-11-22 13:05", on the clock of this machine; a text that is no UTC time as it is.
std::string local_time_text(const std::string& utc);

/// "1 session", "3 sessions".
std::string counted(std::size_t count, const std::string& thing);

/// Aligned columns: text to the left, numbers to the right, two spaces between. Each row is one line: line breaks and other
/// control characters of a text are shown by their numbers.
std::string aligned(const Table& table);
/// The same with the columns at the right that are `numeric`, whatever their cells.
std::string aligned(const Table& table, const std::vector<bool>& numeric);

}  // namespace asperity
