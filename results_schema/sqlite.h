// SQLite behind types: a connection, a statement, a transaction. Seen by this folder only.

#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "results_schema/stored_words.h"

struct sqlite3;
struct sqlite3_stmt;

namespace asperity {

/// Long enough for a queue of sessions that sync to a slow disk; a lock held longer is a defect.
inline constexpr int kBusyTimeout_ms = 60'000;

/// One connection. Every failure is a ResultsError that names the study and explains the failure.
class Database final {
 public:
  /// `read_only` needs a readable log and index (-wal, -shm) and writes to neither; `immutable`
  /// looks at the one file only; `rebuilding_index` is for a log whose index was lost, and writes a
  /// new one; `in_memory` is a new one that is no file and ends with the connection.
  enum class Mode {
    create,
    read_write,
    read_only,
    read_only_rebuilding_index,
    immutable,
    in_memory
  };

  /// `folder` is what errors name; `file` is the database.
  Database(std::filesystem::path folder, const std::filesystem::path& file, Mode mode);
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  ~Database();

  /// Statements without parameters or results, one after another.
  void execute(const std::string& sql);
  std::int64_t last_row_id() const noexcept;
  sqlite3* handle() const noexcept { return handle_; }
  const std::filesystem::path& folder() const noexcept { return folder_; }
  [[noreturn]] void fail(int code, const std::string& what) const;

 private:
  friend class Statement;
  /// A statement of this text, which nobody else has until it is given back.
  sqlite3_stmt* prepared(std::string_view sql);
  /// Without its parameters and its row, which would keep others from writing.
  void give_back(sqlite3_stmt* statement) noexcept;

  std::filesystem::path folder_;
  sqlite3* handle_ = nullptr;
  /// Statements that were given back, by their text: to prepare one, with the triggers and constraints of its table, takes
  /// several times as long as to run it.
  std::multimap<std::string, sqlite3_stmt*, std::less<>> idle_{};
};

/// A prepared statement; parameters are bound and columns read in order. The database outlives it.
class Statement final {
 public:
  Statement(Database& database, std::string_view sql);
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  template <typename... Values>
  Statement& bind(const Values&... values) {
    (bind_next(values), ...);
    return *this;
  }
  /// Whether there is a row.
  bool step();
  /// Runs to the end and makes ready for other parameters.
  void run();
  template <typename... Values>
  void read(Values&... values) {
    column_ = 0;
    (read_next(values), ...);
  }
  /// One column of the row, from 0, for a caller that learns the columns only when it runs.
  std::int64_t integer_at(int column) const noexcept;
  std::string text_at(int column);
  /// The next parameter becomes what column `column` of the row of `other` is, of the same type.
  Statement& bind_column(const Statement& other, int column);
  /// Every column of a row, whose number is known only when it runs.
  template <typename Value>
  void read_all(std::vector<Value>& values) {
    column_ = 0;
    for (Value& value : values) read_next(value);
  }

 private:
  void bind_next(std::int64_t value);
  void bind_next(int value) { bind_next(static_cast<std::int64_t>(value)); }
  void bind_next(bool value) { bind_next(static_cast<std::int64_t>(value ? 1 : 0)); }
  void bind_next(double value);
  void bind_next(const std::string& value);
  void bind_next(const char* value) { bind_next(std::string(value)); }
  void bind_next(std::nullopt_t);
  /// The text and the codes: two columns.
  void bind_next(const std::optional<StoredWords>& words);
  void bind_next(const StoredWords& words) { bind_next(std::optional<StoredWords>(words)); }
  template <typename Value>
  void bind_next(const std::optional<Value>& value) {
    if (value) {
      bind_next(*value);
    } else {
      bind_next(std::nullopt);
    }
  }

  bool is_null() const noexcept;
  void read_next(std::int64_t& value) noexcept;
  void read_next(int& value) noexcept;
  void read_next(bool& value) noexcept;
  void read_next(double& value) noexcept;
  void read_next(std::string& value);
  void read_next(std::optional<StoredWords>& words);
  void read_next(StoredWords& words);
  template <typename Value>
  void read_next(std::optional<Value>& value) {
    if (is_null()) {
      value.reset();
      ++column_;
    } else {
      read_next(value.emplace());
    }
  }

  Database& database_;
  sqlite3_stmt* handle_ = nullptr;
  int parameter_ = 0;
  int column_ = 0;
};

/// Takes the write lock at once (BEGIN IMMEDIATE), so that what is read inside is still true when
/// it is acted upon. Rolls back unless committed.
class Transaction final {
 public:
  explicit Transaction(Database& database);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();
  void commit();

 private:
  Database& database_;
};

}  // namespace asperity
