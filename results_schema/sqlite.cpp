// SQLite's calls and result codes turned into exceptions that a person can act upon.

#include "results_schema/sqlite.h"

#include <new>

#include <sqlite3.h>

#include "results_schema/error_text.h"
#include "results_schema/study.h"

namespace asperity {
namespace {

/// A path as SQLite's URI syntax wants it.
std::string uri_of(const std::filesystem::path& file, const char* parameters) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char character : std::filesystem::absolute(file).string()) {
    if (character == '%' || character == '?' || character == '#') {
      const auto code = static_cast<unsigned char>(character);
      uri += {'%', kDigits[code >> 4], kDigits[code & 15]};
    } else {
      uri += character;
    }
  }
  return uri + parameters;
}

/// Empty where the code leaves open what happened.
std::string known_meaning_of(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return kDiskIsFull;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "another program has been writing to the study for more than a minute; close it and "
             "try again";
    case SQLITE_READONLY:
      return "it is read-only here; check the permissions of the folder and of study.sqlite";
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return "study.sqlite is damaged; restore it from a copy";
    case SQLITE_CANTOPEN:
      return "study.sqlite cannot be opened; check the permissions of the folder and of its files";
    case SQLITE_IOERR:
      return "the disk could not be read or written; check the disk, then try again. Nothing that "
             "was stored before is lost";
    case SQLITE_PERM:
      return "the system denied access; check the permissions of the folder and of its files";
    case SQLITE_NOMEM:
      return "too little memory is free; close other programs, then try again";
    case SQLITE_PROTOCOL:
      return "the log next to study.sqlite does not match its index; close the programs that use "
             "the study, then open it again with write access to its folder";
    default:
      return {};
  }
}

}  // namespace

Database::Database(std::filesystem::path folder, const std::filesystem::path& file, Mode mode)
    : folder_(std::move(folder)) {
  int flags = SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  const char* parameters = "";
  switch (mode) {
    case Mode::create:
      flags |= SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
      break;
    case Mode::read_write:
      flags |= SQLITE_OPEN_READWRITE;
      break;
    case Mode::read_only:
      flags |= SQLITE_OPEN_READONLY;
      parameters = "?mode=ro&readonly_shm=1";
      break;
    case Mode::read_only_rebuilding_index:
      flags |= SQLITE_OPEN_READONLY;
      parameters = "?mode=ro";
      break;
    case Mode::immutable:
      flags |= SQLITE_OPEN_READONLY;
      parameters = "?mode=ro&immutable=1";
      break;
    case Mode::in_memory:
      flags |= SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE;
      break;
  }
  const std::string name = mode == Mode::in_memory ? ":memory:" : uri_of(file, parameters);
  const int code = sqlite3_open_v2(name.c_str(), &handle_, flags, nullptr);
  try {
    if (code != SQLITE_OK) fail(code, "cannot be opened");
    if (mode == Mode::read_write && sqlite3_db_readonly(handle_, "main") == 1) {
      fail(SQLITE_READONLY, "cannot be written to");
    }
    sqlite3_busy_timeout(handle_, kBusyTimeout_ms);
    // Rules for writing, whose statement reads the schema: a seal is checked without locks, in a file that may be
    // being compacted, and must not find that it makes no sense.
    if ((flags & SQLITE_OPEN_READONLY) != 0) return;
    execute("PRAGMA foreign_keys = ON; PRAGMA recursive_triggers = ON; PRAGMA synchronous = FULL;");
  } catch (...) {
    sqlite3_close_v2(handle_);
    throw;
  }
}

Database::~Database() {
  for (const auto& [sql, statement] : idle_) sqlite3_finalize(statement);
  sqlite3_close_v2(handle_);
}

sqlite3_stmt* Database::prepared(std::string_view sql) {
  if (const auto idle = idle_.find(sql); idle != idle_.end()) {
    sqlite3_stmt* const statement = idle->second;
    idle_.erase(idle);
    return statement;
  }
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(handle_, sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (code != SQLITE_OK) fail(code, "cannot be read");
  return statement;
}

void Database::give_back(sqlite3_stmt* statement) noexcept {
  // More than a program has texts of statements; those of a merge name tables and columns.
  constexpr std::size_t kMostIdle = 256;
  sqlite3_reset(statement);  // the error that it repeats has been reported
  sqlite3_clear_bindings(statement);
  try {
    if (idle_.size() < kMostIdle) {
      idle_.emplace(sqlite3_sql(statement), statement);
      return;
    }
  } catch (const std::bad_alloc&) {  // it is prepared again
  }
  sqlite3_finalize(statement);
}

void Database::execute(const std::string& sql) {
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code, "cannot be used");
}

std::int64_t Database::last_row_id() const noexcept { return sqlite3_last_insert_rowid(handle_); }

void Database::fail(int code, const std::string& what) const {
  std::string meaning = known_meaning_of(code);
  if (meaning.empty()) {
    // SQLite's words name the constraint, the table or the file, which a report of the error needs. What it remembers may be
    // of another call: of one that succeeded it says "not an error".
    const bool remembers = handle_ != nullptr && sqlite3_errcode(handle_) != SQLITE_OK;
    meaning = (code & 0xff) == SQLITE_CONSTRAINT ? "the row violates a constraint of the table"
                                                 : "the database reported an error";
    meaning += "; run asperity verify on the study. Quote in a report of this error: ";
    meaning += remembers ? sqlite3_errmsg(handle_) : sqlite3_errstr(code);
  }
  throw ResultsError("the study " + folder_.string() + " " + what + ": " + meaning, folder_, code);
}

Statement::Statement(Database& database, std::string_view sql)
    : database_(database), handle_(database.prepared(sql)) {}

Statement::~Statement() { database_.give_back(handle_); }

bool Statement::step() {
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  database_.fail(code,
                 sqlite3_stmt_readonly(handle_) != 0 ? "cannot be read" : "cannot store a row");
}

void Statement::run() {
  while (step()) {
  }
  sqlite3_reset(handle_);
  parameter_ = 0;
}

std::int64_t Statement::integer_at(int column) const noexcept {
  return sqlite3_column_int64(handle_, column);
}

std::string Statement::text_at(int column) {
  column_ = column;
  std::string text;
  read_next(text);
  return text;
}

Statement& Statement::bind_column(const Statement& other, int column) {
  const int code =
      sqlite3_bind_value(handle_, ++parameter_, sqlite3_column_value(other.handle_, column));
  if (code != SQLITE_OK) database_.fail(code, "cannot be used");
  return *this;
}

void Statement::bind_next(std::int64_t value) { sqlite3_bind_int64(handle_, ++parameter_, value); }

void Statement::bind_next(double value) { sqlite3_bind_double(handle_, ++parameter_, value); }

void Statement::bind_next(const std::string& value) {
  const int code = sqlite3_bind_text64(handle_, ++parameter_, value.data(), value.size(),
                                       SQLITE_TRANSIENT, SQLITE_UTF8);
  // Without its copy the parameter would be NULL.
  if (code != SQLITE_OK) database_.fail(code, "cannot be used");
}

void Statement::bind_next(std::nullopt_t) { sqlite3_bind_null(handle_, ++parameter_); }

bool Statement::is_null() const noexcept {
  return sqlite3_column_type(handle_, column_) == SQLITE_NULL;
}

void Statement::read_next(std::int64_t& value) noexcept {
  value = sqlite3_column_int64(handle_, column_++);
}

void Statement::read_next(int& value) noexcept { value = sqlite3_column_int(handle_, column_++); }

void Statement::read_next(bool& value) noexcept {
  value = sqlite3_column_int(handle_, column_++) != 0;
}

void Statement::read_next(double& value) noexcept {
  value = sqlite3_column_double(handle_, column_++);
}

void Statement::bind_next(const std::optional<StoredWords>& words) {
  if (!words) {
    bind_next(std::nullopt);
    bind_next(std::nullopt);
    return;
  }
  bind_next(words->text);
  bind_next(words->json.empty() ? std::nullopt : std::optional(words->json));
}

void Statement::read_next(std::optional<StoredWords>& words) {
  std::optional<std::string> text;
  std::optional<std::string> json;
  read_next(text);
  read_next(json);
  words.reset();
  if (text) words.emplace(*std::move(text), json.value_or(""));
}

void Statement::read_next(StoredWords& words) {
  std::optional<StoredWords> read;
  read_next(read);
  words = read.value_or(StoredWords{});
}

void Statement::read_next(std::string& value) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_, column_));
  if (text == nullptr && sqlite3_errcode(database_.handle()) == SQLITE_NOMEM) {
    database_.fail(SQLITE_NOMEM, "cannot be read");
  }
  const int bytes = sqlite3_column_bytes(handle_, column_++);
  value.assign(text == nullptr ? "" : text, static_cast<std::size_t>(bytes));
}

Transaction::Transaction(Database& database) : database_(database) {
  database.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  // SQLite is back in autocommit mode after a commit, and after the errors at which it rolls back by itself.
  if (sqlite3_get_autocommit(database_.handle()) == 0) {
    sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
}

void Transaction::commit() { database_.execute("COMMIT"); }

}  // namespace asperity
