// What a Study keeps while it is open. Seen by this folder only.

#pragma once

#include <array>
#include <exception>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/hashes/seal.h"
#include "results_schema/migrations.h"
#include "results_schema/sqlite.h"
#include "results_schema/study.h"

namespace asperity {

struct Study::Store {
  /// What changes when a program writes to the database.
  struct Stamp {
    std::int64_t modified_ns = 0;
    std::int64_t bytes = 0;
    std::uint64_t file_number = 0;
    std::optional<std::int64_t> log_modified_ns{};  ///< absent: there is no log
    std::int64_t log_bytes = 0;
    bool operator==(const Stamp&) const = default;
  };

  Store(std::filesystem::path study_folder, Access study_access,
        std::span<const Migration> study_migrations);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// The connection, for writing. Throws when the study was opened for reading.
  Database& writable();

  /// Runs `function(database)` on one consistent state of the study.
  ///
  /// A study that no other program has open is read as an immutable file, without locks, because locks would
  /// leave files behind. Should a program begin to write meanwhile, what was read is discarded and
  /// read again with locks.
  template <typename Function>
  auto read(Function function) {
    if (inside_read) return function(*database);
    const ReadMark mark(*this);
    for (;;) {
      follow_writers();
      try {
        const Snapshot snapshot(*database);
        auto result = function(*database);
        if (!is_outdated()) return result;
      } catch (const std::exception&) {  // of whatever made no sense of a file that was changing
        if (!is_outdated()) throw;
      }
    }
  }

  struct InterruptedDeletion {
    UnfinishedDeletion deletion{};
    std::vector<OutputRow> outputs{};
    bool is_complete = false;  ///< by this opening of the study
  };
  /// Of a label that no participant has.
  std::optional<InterruptedDeletion> interrupted_deletion(Database& of,
                                                          const std::string& label) const;

  std::filesystem::path folder;
  Access access = Access::read_only;
  std::span<const Migration> migrations{};  ///< of the program
  std::unique_ptr<Database> database{};
  std::optional<SealBreaker> seal{};  ///< of a writer
  /// Set while the file, or a copy of it in memory, is read without locks.
  std::optional<Stamp> immutable_since{};
  int schema_version = 0;  ///< of the file
  bool inside_read = false;
  /// By this opening of the study: a repeated command reports it as done.
  struct CompletedDeletion {
    UnfinishedDeletion deletion{};
    std::vector<OutputRow> outputs{};  ///< before paths were blanked
  };
  std::vector<CompletedDeletion> completed_deletions{};
  std::shared_future<StudyCondition> condition{};  ///< invalid until it is requested
  std::stop_source end_of_condition{};             ///< the destructor does not wait for it

 private:
  /// Nested reads see the state of the outermost.
  struct ReadMark {
    explicit ReadMark(Store& marked) : store(marked) { store.inside_read = true; }
    ~ReadMark() { store.inside_read = false; }
    ReadMark(const ReadMark&) = delete;
    ReadMark& operator=(const ReadMark&) = delete;
    Store& store;
  };
  /// A read transaction, unless one is running.
  struct Snapshot {
    explicit Snapshot(Database& snapshot_database);
    ~Snapshot();
    Snapshot(const Snapshot&) = delete;
    Snapshot& operator=(const Snapshot&) = delete;
    Database& database;
    bool began = false;
  };

  void connect();
  void connect_for_reading();
  void bring_up_to_date();
  void complete_deletions() noexcept;
  void read_up_to_date_in_memory(const Stamp& before);
  void check_identity();
  void follow_writers();
  bool is_outdated() const;
  Stamp stamp() const;
};

/// Brings the schema from version `from`, 0 of an empty file, to the newest, inside the caller's transaction.
void migrate(Database& database, int from, std::span<const Migration> migrations);

/// The whole content of one database, as it is now, in place of that of another.
void copy_pages(Database& from, Database& to);

/// [0-9A-Za-z]{1,32}: what a label consists of, and what files named after a participant rely on.
bool is_participant_label(const std::string& label);

/// The part of a study that is one file.
std::filesystem::path database_in(const std::filesystem::path& folder);

/// Whether the database's write-ahead log adds nothing to it: it is absent, ends with its header, which is written
/// before the first row, or has none that is valid.
bool log_is_empty(const std::filesystem::path& folder);

/// The element of a closed set that a word of a column ("session.state") stands for. Errors: ResultsError naming the
/// column and the words that it may have; tables enforce them, but not against a tool that switches that off.
template <typename Enum, std::size_t kCount>
Enum enum_of(const std::string& text, const std::array<Enum, kCount>& all, const char* column) {
  std::string words;
  for (const Enum value : all) {
    if (text == text_of(value)) return value;
    words += (words.empty() ? "" : ", ") + std::string(text_of(value));
  }
  throw ResultsError("study.sqlite has the value \"" + text + "\" in the column " + column +
                         "; the permitted values are " + words +
                         ". Another program has changed the file. Restore the study from a copy; "
                         "asperity verify lists everything that was changed",
                     "study.sqlite");
}

}  // namespace asperity
