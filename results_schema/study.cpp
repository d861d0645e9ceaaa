// Making and opening a study; its participants, protocols and solutions.

#include "results_schema/study.h"

#include <array>
#include <atomic>
#include <bit>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <fstream>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include <sqlite3.h>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/sqlite.h"
#include "results_schema/study_sharing.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

constexpr int kApplicationId = 0x41737072;  // "Aspr"
constexpr const char* kUtcNow = "strftime('%Y-%m-%dT%H:%M:%fZ', 'now')";

std::filesystem::path log_of(const std::filesystem::path& database, const char* suffix) {
  std::filesystem::path path = database;
  path += suffix;
  return path;
}

int number_of(Database& database, const char* sql) {
  Statement statement(database, sql);
  int number = 0;
  if (statement.step()) statement.read(number);
  return number;
}

void make_database(const std::filesystem::path& folder, const std::string& name,
                   std::span<const Migration> migrations) {
  Database database(folder, database_in(folder), Database::Mode::create);
  Statement journal(database, "PRAGMA journal_mode = WAL");
  std::string mode;
  if (journal.step()) journal.read(mode);
  journal.run();
  if (mode != "wal") {
    throw ResultsError("a study cannot be created in " + folder.string() +
                           ": its file system does not support a write-ahead log; use a local disk",
                       folder);
  }
  Transaction transaction(database);
  database.execute("PRAGMA application_id = " + std::to_string(kApplicationId));
  migrate(database, 0, migrations);
  Statement(database,
            std::string("INSERT INTO study (id, name, created_utc) VALUES (1, ?, ") + kUtcNow + ")")
      .bind(name)
      .run();
  transaction.commit();
}

/// See Study::read_beside_writers.
std::atomic<bool> reads_beside_writers{false};

const char* const kFolders[] = {"protocols", "stimuli", "recordings", "locks"};

void fill_new_study(const std::filesystem::path& folder, const std::string& name,
                    std::span<const Migration> migrations) {
  for (const char* const part : kFolders) make_folders(folder / part);
  make_database(folder, name, migrations);
  // SQLite gives its log and index the mode that the database has.
  if (is_group_folder(folder)) share_study(folder);
  sync_folder(folder);
}

/// "Asperity 0.2.0, commit 1a2b3c4": the program that began the last session. Empty where no session is found, as in a
/// schema that has other tables.
std::string program_of_last_session(Database& database) {
  std::string version;
  std::string commit;
  try {
    Statement statement(
        database, "SELECT program_version, program_commit FROM session ORDER BY id DESC LIMIT 1");
    if (!statement.step()) return {};
    statement.read(version, commit);
  } catch (const ResultsError&) {
    return {};
  }
  return "Asperity " + version + ", commit " + commit;
}

/// Why a study of schema `version` cannot be opened, and what to do about it.
std::string refusal_of_schema(Database& database, int version,
                              std::span<const Migration> migrations) {
  const int oldest = migrations.front().version;
  const int newest = migrations.back().version;
  const std::string program = program_of_last_session(database);
  return "the study " + database.folder().string() + " has the schema version " +
         std::to_string(version) +
         (program.empty() ? ", which another version of Asperity wrote"
                          : " (its last session was begun by " + program + ")") +
         ". This program reads " +
         (oldest == newest
              ? "only the schema version " + std::to_string(newest)
              : "the schema versions " + std::to_string(oldest) + " to " + std::to_string(newest)) +
         ". Open the study with the version of Asperity that wrote it" +
         (version < oldest ? ", or create a new study" : " or with a newer one");
}

}  // namespace

std::filesystem::path database_in(const std::filesystem::path& folder) {
  return folder / "study.sqlite";
}

bool log_is_empty(const std::filesystem::path& folder) {
  // "Write-Ahead Log File Format" of SQLite: without such a header there is nothing of use in a log.
  constexpr std::size_t kHeader_bytes = 32;
  constexpr std::uint32_t kMagic =
      0x377f0682;  // or the next number: of the order of bytes in checksums
  const std::filesystem::path log = log_of(database_in(folder), "-wal");
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(log, error);
  if (error || bytes <= kHeader_bytes) return true;
  std::array<unsigned char, 12> start{};
  std::ifstream file(log, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(start.data()), start.size())) return false;
  const auto number_at = [&start](std::size_t at) {
    return std::uint32_t{start[at]} << 24 | std::uint32_t{start[at + 1]} << 16 |
           std::uint32_t{start[at + 2]} << 8 | std::uint32_t{start[at + 3]};
  };
  const std::uint32_t page_bytes = number_at(8);
  return (number_at(0) & ~1U) != kMagic || !std::has_single_bit(page_bytes) || page_bytes < 512 ||
         page_bytes > 65536;
}

void migrate(Database& database, int from, std::span<const Migration> migrations) {
  for (const Migration& migration : migrations) {
    if (migration.version > from) database.execute(std::string(migration.sql));
  }
  database.execute("PRAGMA user_version = " + std::to_string(migrations.back().version));
}

Study::Store::Snapshot::Snapshot(Database& snapshot_database) : database(snapshot_database) {
  if (sqlite3_get_autocommit(database.handle()) != 0) {
    database.execute("BEGIN");
    began = true;
  }
}

Study::Store::Snapshot::~Snapshot() {
  if (began) sqlite3_exec(database.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

Study::Store::Store(std::filesystem::path study_folder, Access study_access,
                    std::span<const Migration> study_migrations)
    : folder(std::move(study_folder)), access(study_access), migrations(study_migrations) {
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    if (!std::filesystem::exists(folder, error)) {
      throw ResultsError("there is no folder " + folder.string() + "; name the folder of a study",
                         folder, ENOENT);
    }
    const std::filesystem::path around = folder.parent_path();
    throw ResultsError(
        folder.string() + " is a file; name the folder of a study" +
            (folder.filename() == database_in("").filename()
                 ? ", here the folder of this file, " + (around.empty() ? "." : around.string())
                 : ""),
        folder, ENOTDIR);
  }
  if (!std::filesystem::is_regular_file(database_in(folder), error)) {
    throw ResultsError("the folder " + folder.string() +
                           " is not a study: it has no study.sqlite. Name the folder of a study, "
                           "or create a new one",
                       folder, ENOENT);
  }
  connect();
}

Study::Store::~Store() {
  end_of_condition.request_stop();
  if (seal && database) seal->seal_again(*database);
}

void Study::Store::connect() {
  if (access == Access::read_only) {
    connect_for_reading();
    return;
  }
  database = std::make_unique<Database>(folder, database_in(folder), Database::Mode::read_write);
  check_identity();
  seal.emplace(folder, *database);
  if (schema_version < migrations.back().version) bring_up_to_date();
  complete_deletions();
}

void Study::Store::bring_up_to_date() {
  Transaction transaction(*database);
  // Of two programs that bring an older study up to date at once the second finds it done.
  const int version = number_of(*database, "PRAGMA user_version");
  if (version < migrations.back().version) {
    const std::filesystem::path kept =
        log_of(database_in(folder), (".version-" + std::to_string(version)).c_str());
    if (!std::filesystem::exists(kept)) {
      // Under another name until it is whole; the transaction keeps others from doing the same.
      const std::filesystem::path part = part_of(kept);
      std::error_code ignored;
      std::filesystem::remove(part, ignored);
      {
        // The connection that writes cannot be copied from; nothing is written yet.
        Database before(folder, database_in(folder), Database::Mode::read_only_rebuilding_index);
        Database copy(folder, part, Database::Mode::create);
        copy_pages(before, copy);
      }
      rename_to_free_name(part, kept);
      sync_folder(folder);
    }
    migrate(*database, version, migrations);
  }
  transaction.commit();
  schema_version = migrations.back().version;
}

void Study::Store::read_up_to_date_in_memory(const Stamp& before) {
  auto copy = std::make_unique<Database>(folder, "", Database::Mode::in_memory);
  copy_pages(*database, *copy);
  Transaction transaction(*copy);
  migrate(*copy, schema_version, migrations);
  transaction.commit();
  database = std::move(copy);
  immutable_since = before;
}

void Study::Store::connect_for_reading() {
  constexpr int kTries = 100;
  constexpr std::chrono::milliseconds kPause{20};
  const std::filesystem::path file = database_in(folder);
  for (int left = kTries;; --left) {
    const bool has_index = std::filesystem::exists(log_of(file, "-shm"));
    immutable_since.reset();
    const Stamp before = stamp();
    Database::Mode mode = Database::Mode::read_only;
    // A writer that was killed leaves both behind. Where the log is no more than a header, SQLite would wait in
    // vain for an index that fits it.
    if (log_is_empty(folder) && !(has_index && is_being_written(folder))) {
      immutable_since = before;
      mode = Database::Mode::immutable;
    } else if (!has_index || (reads_beside_writers && ::access(folder.c_str(), W_OK) == 0)) {
      mode = Database::Mode::read_only_rebuilding_index;
    }
    try {
      database = std::make_unique<Database>(folder, file, mode);
      check_identity();
      if (schema_version < migrations.back().version) read_up_to_date_in_memory(before);
      if (!is_outdated()) return;
    } catch (const ResultsError& error) {
      // The writer's files may come or go between our look and our opening them.
      const int kind = error.code() & 0xff;
      const bool may_pass = is_outdated() || kind == SQLITE_CANTOPEN || kind == SQLITE_READONLY ||
                            kind == SQLITE_BUSY;
      if (!may_pass || left == 0) throw;
    }
    if (left < kTries) std::this_thread::sleep_for(kPause);
  }
}

void Study::Store::check_identity() {
  if (number_of(*database, "PRAGMA application_id") != kApplicationId) {
    throw ResultsError("the folder " + folder.string() +
                           " is not a study: its study.sqlite was made by another program. Name "
                           "the folder of a study",
                       folder);
  }
  const int version = number_of(*database, "PRAGMA user_version");
  if (version < migrations.front().version || version > migrations.back().version) {
    throw ResultsError(refusal_of_schema(*database, version, migrations), folder);
  }
  schema_version = version;
  if (number_of(*database, "SELECT count(*) FROM study") != 1) {
    throw ResultsError("the study " + folder.string() +
                           " is damaged: its table study must have one row; restore it from a copy",
                       folder);
  }
}

Study::Store::Stamp Study::Store::stamp() const {
  const std::filesystem::path file = database_in(folder);
  const auto modified_ns = [](const struct stat& status) {
    return static_cast<std::int64_t>(status.st_mtim.tv_sec) * 1'000'000'000 +
           status.st_mtim.tv_nsec;
  };
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) fail_on_file(file, "examined", errno);
  Stamp stamp{
      .modified_ns = modified_ns(status), .bytes = status.st_size, .file_number = status.st_ino};
  struct stat log {};
  if (::stat(log_of(file, "-wal").c_str(), &log) == 0) {
    stamp.log_modified_ns = modified_ns(log);
    stamp.log_bytes = log.st_size;
  }
  return stamp;
}

bool Study::Store::is_outdated() const { return immutable_since && stamp() != *immutable_since; }

void Study::Store::follow_writers() {
  if (is_outdated()) connect_for_reading();
}

Database& Study::Store::writable() {
  if (access == Access::read_only) {
    throw ResultsError("the study " + folder.string() +
                           " is open for reading only; open it for writing to change it",
                       folder, SQLITE_READONLY);
  }
  return *database;
}

Study::Study(std::unique_ptr<Store> store) : store_(std::move(store)) {}
Study::Study(Study&&) noexcept = default;
Study& Study::operator=(Study&&) noexcept = default;
Study::~Study() = default;

Study Study::create(const std::filesystem::path& folder, const std::string& name) {
  return create(folder, name, migrations());
}

Study Study::create(const std::filesystem::path& folder, const std::string& name,
                    std::span<const Migration> migrations) {
  if (name.empty())
    throw std::invalid_argument("the name of a study must not be empty; give a name");
  if (!std::filesystem::exists(folder)) {
    make_folder_at_once(folder, kOwnersFolder, [&](const std::filesystem::path& content) {
      fill_new_study(content, name, migrations);
    });
    return open(folder, Access::read_write, migrations);
  }
  if (!std::filesystem::is_directory(folder)) {
    throw ResultsError("a study cannot be created in " + folder.string() +
                           ": it is a file; name a new or an empty folder",
                       folder, ENOTDIR);
  }
  if (!is_free(folder)) {
    throw ResultsError("a study cannot be created in " + folder.string() +
                           ": it is not empty; name a new or an empty folder",
                       folder, EEXIST);
  }
  // Of several programs that find the folder empty, one makes the file; after an error the others remove nothing.
  const std::filesystem::path file = database_in(folder);
  const int made = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (made < 0) fail_on_file(file, "made", errno);
  ::close(made);
  try {
    fill_new_study(folder, name, migrations);
    return open(folder, Access::read_write, migrations);
  } catch (...) {
    std::error_code error;
    for (const char* const part : kFolders) std::filesystem::remove(folder / part, error);
    for (const char* const suffix : {"", "-wal", "-shm", "-journal"}) {
      std::filesystem::remove(log_of(database_in(folder), suffix), error);
    }
    throw;
  }
}

Study Study::open(const std::filesystem::path& folder, Access access) {
  return open(folder, access, migrations());
}

Study Study::open(const std::filesystem::path& folder, Access access,
                  std::span<const Migration> migrations) {
  return Study(std::make_unique<Store>(folder, access, migrations));
}

void Study::read_beside_writers() noexcept { reads_beside_writers = true; }

bool Study::exists(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::is_regular_file(database_in(folder), error);
}

bool Study::can_be_written(const std::filesystem::path& folder) noexcept {
  // As the one whose rights count, who need not be the one who started the program.
  const auto may_write = [](const std::filesystem::path& path) {
    return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
  };
  if (!may_write(folder) || !may_write(folder / "study.sqlite")) return false;
  for (const char* const part : {"recordings", "locks"}) {
    if (!may_write(folder / part) && errno != ENOENT) return false;
  }
  return true;
}

const std::filesystem::path& Study::folder() const noexcept { return store_->folder; }
Access Study::access() const noexcept { return store_->access; }

int Study::schema_version() const noexcept { return store_->schema_version; }

void Study::read_at_one_moment(const std::function<void()>& reading) const {
  if (store_->inside_read) {
    reading();
    return;
  }
  // What is read of one moment names files, which go with the participant. A result without them is right, and better.
  for (;;) {
    std::int64_t deletions = 0;
    const auto is_overtaken = [this, &deletions] {
      return store_->read(number_of_deletions) != deletions;
    };
    try {
      store_->read([&](Database& database) {
        deletions = number_of_deletions(database);
        reading();
        return true;
      });
      if (!is_overtaken()) return;
    } catch (const std::exception&) {
      if (!is_overtaken()) throw;
    }
  }
}

std::string Study::name() const {
  return store_->read([](Database& database) {
    Statement statement(database, "SELECT name FROM study");
    std::string name;
    if (statement.step()) statement.read(name);
    return name;
  });
}

bool is_participant_label(const std::string& label) {
  constexpr std::size_t kMost = 32;
  return !label.empty() && label.size() <= kMost &&
         label.find_first_not_of(
             "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos;
}

void Study::add_participant(const ParticipantRow& participant) {
  Database& database = store_->writable();
  const std::string& label = participant.label;
  if (!is_participant_label(label)) {
    throw ResultsError("\"" + label +
                           "\" is not a participant label; it must consist of 1 to 32 letters and "
                           "digits (0-9, A-Z, a-z)",
                       store_->folder);
  }
  Statement unfinished(database, "SELECT 1 FROM withdrawal WHERE label = ?");
  if (unfinished.bind(label).step()) {
    throw ResultsError("the study " + store_->folder.string() + " cannot have a participant " +
                           label +
                           " yet: the deletion of the data under this label is not complete. Close "
                           "the study, then open it again for writing, which completes it",
                       store_->folder);
  }
  Statement statement(database,
                      std::string("INSERT INTO participant (label, is_virtual, age_years, sex, "
                                  "handedness, answers_json, created_utc) "
                                  "VALUES (?, ?, ?, ?, ?, ?, coalesce(nullif(?, ''), ") +
                          kUtcNow + "))");
  statement
      .bind(label, participant.is_virtual, participant.age_years, participant.sex,
            participant.handedness, participant.answers_json, participant.created_utc)
      .run();
}

void Study::add_participants(const std::vector<ParticipantRow>& participants) {
  Transaction transaction(store_->writable());
  for (const ParticipantRow& participant : participants) add_participant(participant);
  transaction.commit();
}

std::vector<ParticipantRow> Study::participants() const {
  return store_->read([](Database& database) {
    Statement statement(database,
                        "SELECT label, is_virtual, age_years, sex, handedness, answers_json, "
                        "created_utc, withdrawn FROM participant ORDER BY label");
    std::vector<ParticipantRow> rows;
    while (statement.step()) {
      ParticipantRow& row = rows.emplace_back();
      statement.read(row.label, row.is_virtual, row.age_years, row.sex, row.handedness,
                     row.answers_json, row.created_utc, row.withdrawn);
    }
    return rows;
  });
}

std::optional<ParticipantRow> Study::participant(const std::string& label) const {
  for (ParticipantRow& row : participants()) {
    if (row.label == label) return std::move(row);
  }
  return std::nullopt;
}

std::int64_t Study::add_protocol(const ProtocolRow& protocol) {
  Database& database = store_->writable();
  const std::string sha256 = sha256_of(protocol.source);
  if (!protocol.source_sha256.empty() && protocol.source_sha256 != sha256) {
    throw ResultsError("the protocol " + protocol.name + " does not have the SHA-256 " +
                           protocol.source_sha256 + " that is stated for it, but " + sha256 +
                           "; store the text whose SHA-256 is stated",
                       store_->folder);
  }
  Transaction transaction(database);
  std::int64_t id = 0;
  Statement known(database, "SELECT id FROM protocol WHERE source_sha256 = ?");
  if (known.bind(sha256).step()) {
    known.read(id);
    return id;
  }
  Statement(database,
            "INSERT INTO protocol (name, version, kind, design, source_sha256, source) "
            "VALUES (?, ?, ?, ?, ?, ?)")
      .bind(protocol.name, protocol.version, protocol.kind, protocol.design, sha256,
            protocol.source)
      .run();
  id = database.last_row_id();
  transaction.commit();
  return id;
}

std::vector<ProtocolRow> Study::protocols() const {
  return store_->read([](Database& database) {
    Statement statement(database,
                        "SELECT id, name, version, kind, design, source_sha256, source "
                        "FROM protocol ORDER BY name, version, source_sha256");
    std::vector<ProtocolRow> rows;
    while (statement.step()) {
      ProtocolRow& row = rows.emplace_back();
      statement.read(row.id, row.name, row.version, row.kind, row.design, row.source_sha256,
                     row.source);
    }
    return rows;
  });
}

ProtocolRow Study::protocol(std::int64_t id) const {
  for (ProtocolRow& row : protocols()) {
    if (row.id == id) return std::move(row);
  }
  throw ResultsError("the study " + store_->folder.string() + " has no protocol with the id " +
                         std::to_string(id) + "; run asperity verify on the study",
                     store_->folder);
}

void Study::remember_solution(const std::string& key, const std::string& solution_json) {
  Statement(store_->writable(), "INSERT INTO solution VALUES (?, ?) ON CONFLICT DO NOTHING")
      .bind(key, solution_json)
      .run();
}

std::optional<std::string> Study::solution(const std::string& key) const {
  return store_->read([&key](Database& database) {
    Statement statement(database, "SELECT solution_json FROM solution WHERE key = ?");
    std::optional<std::string> solution;
    if (statement.bind(key).step()) statement.read(solution);
    return solution;
  });
}

}  // namespace asperity
