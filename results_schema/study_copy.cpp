// A consistent copy of a study that may be in use.

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <exception>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include <sqlite3.h>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/hashes/seal.h"
#include "results_schema/hashes/sha256_stream.h"
#include "results_schema/study.h"
#include "results_schema/study_sharing.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

/// Copies one file to disk. Returns the SHA-256 of what was copied.
std::string copy_and_hash(const std::filesystem::path& from, const std::filesystem::path& to) {
  constexpr std::size_t kPiece_bytes = 1 << 18;
  errno = 0;
  std::ifstream source(from, std::ios::binary);
  if (!source) fail_on_file(from, "read", errno != 0 ? errno : EIO);
  make_folders(to.parent_path());
  OutputFile target(to);
  Sha256Stream sha256;
  std::vector<char> piece(kPiece_bytes);
  do {
    source.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    const auto count = static_cast<std::size_t>(source.gcount());
    target.write(piece.data(), count);
    sha256.add(piece.data(), count);
  } while (source);
  if (source.bad()) fail_on_file(from, "read", EIO);
  target.sync_and_close();
  return sha256.hexadecimal();
}

/// The files that rows name, with the SHA-256 that they must have. A stimulus that was changed
/// between two sessions has two, of which one can be there; `verify` says so.
std::map<std::string, std::set<std::string>> checksums_by_path(Database& database) {
  std::map<std::string, std::set<std::string>> files;
  Statement statement(database,
                      "SELECT path, sha256 FROM recording "
                      "UNION SELECT path, sha256 FROM session_file");
  while (statement.step()) {
    std::string path;
    std::string sha256;
    statement.read(path, sha256);
    files[path].insert(sha256);
  }
  return files;
}

/// Whether a file that no row names goes into a copy: what people put there does; what a running
/// program has not finished, and the database, which is copied in its own way, do not.
bool is_loose_file(const std::filesystem::path& relative) {
  const std::string first = relative.begin()->string();
  if (first == "locks" || first == "recordings" || first.rfind("study.sqlite", 0) == 0)
    return false;
  return relative.extension() != ".tmp" && relative.extension() != kPartEnding;
}

/// A link leads to what is not of the study, or to what a copy would hold twice.
void refuse_link(const std::filesystem::path& study, const std::filesystem::path& relative) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(study / relative, error);
  if (error) return;
  throw ResultsError("the study " + study.string() + " cannot be copied: its " + relative.string() +
                         " is a symbolic link to " + target.string() +
                         ", and a copy cannot contain links. Replace the link with its target, or "
                         "remove it, then copy again",
                     study / relative, ELOOP);
}

/// A FIFO, a socket, a device: what a copy cannot hold is never left out without a word.
void refuse_special_file(const std::filesystem::path& study,
                         const std::filesystem::path& relative) {
  throw ResultsError("the study " + study.string() + " cannot be copied: its " + relative.string() +
                         " is not a regular file. Remove it, then copy again",
                     study / relative, EINVAL);
}

/// The same as refuse_link for every part of a path that a row names.
void refuse_links_on(const std::filesystem::path& study, const std::filesystem::path& relative) {
  std::filesystem::path part;
  for (const std::filesystem::path& name : relative) refuse_link(study, part /= name);
}

void copy_files(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::map<std::string, std::set<std::string>> vouched;
  std::set<std::filesystem::path> being_deleted;
  {
    Database copy(to, database_in(to), Database::Mode::read_write);
    vouched = checksums_by_path(copy);
    being_deleted = files_being_deleted(copy, from);
  }
  for (const auto& [path, sha256] : vouched) {
    refuse_links_on(from, path);
    if (!sha256.contains(copy_and_hash(path_in_study(from, path), path_in_study(to, path)))) {
      throw ResultsError(
          "the study " + from.string() + " cannot be copied: its file " + path +
              " has changed since it was used (its SHA-256 differs); restore it, then copy again",
          from / path);
    }
  }
  for (const auto& entry : entries_below(from)) {
    const std::filesystem::path relative = entry.path().lexically_relative(from);
    // A folder comes before its content.
    if (being_deleted.contains(entry.path()) ||
        being_deleted.contains(entry.path().parent_path())) {
      being_deleted.insert(entry.path());
      continue;
    }
    if (!is_loose_file(relative) || vouched.contains(relative.string())) continue;
    refuse_link(from, relative);
    if (entry.is_directory()) continue;
    if (!entry.is_regular_file()) refuse_special_file(from, relative);
    copy_and_hash(entry.path(), to / relative);
  }
  for (const char* const part : {"protocols", "stimuli", "recordings", "locks"}) {
    std::filesystem::create_directories(to / part);
  }
  for (const auto& entry : entries_below(to)) {
    if (entry.is_directory()) sync_folder(entry.path());
  }
  sync_folder(to);
}

/// A copy of a study whose deletion is under way has the label and free pages.
void complete_deletions_of(Database& copy) {
  for (const UnfinishedDeletion& deletion : unfinished_deletions(copy)) {
    complete_deletion(copy, deletion, {});
  }
}

/// The study lists the copy that is being made at `path`; to the copy it is the study itself.
void remove_itself_from_outputs(Database& copy, const std::filesystem::path& path) {
  std::vector<std::int64_t> ids;
  Statement output(copy, "SELECT id, path FROM output WHERE kind = 'copy' AND made_utc IS NULL");
  while (output.step()) {
    std::int64_t id = 0;
    std::string listed;
    output.read(id, listed);
    std::error_code unreadable;  // a folder of another user, for example, which is not this copy
    if (std::filesystem::weakly_canonical(listed, unreadable) == path) ids.push_back(id);
  }
  for (const std::int64_t id : ids) {
    Statement(copy, "DELETE FROM output WHERE id = ?").bind(id).run();
  }
}

}  // namespace

void copy_pages(Database& from, Database& to) {
  sqlite3_backup* const backup = sqlite3_backup_init(to.handle(), "main", from.handle(), "main");
  if (backup == nullptr) to.fail(sqlite3_errcode(to.handle()), "cannot be written");
  sqlite3_backup_step(backup, -1);  // in one go: no writer can come between two pages
  const int code = sqlite3_backup_finish(backup);
  if (code != SQLITE_OK) to.fail(code, "cannot be written");
}

void Study::refuse_copy_to(const std::filesystem::path& folder) const {
  const std::filesystem::path from = std::filesystem::canonical(store_->folder);
  const std::filesystem::path to =
      std::filesystem::weakly_canonical(std::filesystem::absolute(folder));
  if (std::filesystem::exists(std::filesystem::symlink_status(to))) {
    throw ResultsError("a study cannot be copied to " + folder.string() +
                           ", which already exists; name a new folder",
                       folder, EEXIST);
  }
  if (std::mismatch(from.begin(), from.end(), to.begin(), to.end()).first == from.end()) {
    throw ResultsError(
        "a study cannot be copied into itself; name a folder outside the study, not " +
            folder.string(),
        folder, EINVAL);
  }
  if (seal_of(from) == Seal::broken) {
    throw ResultsError("the study " + from.string() +
                           " cannot be copied: its study.sqlite has changed since Asperity last "
                           "closed it (its SHA-256 differs from that in study.sqlite.sha256). "
                           "\"asperity verify\" lists the possible causes; if the change was "
                           "intended, remove study.sqlite.sha256 and copy again",
                       from);
  }
  refuse_link(from, database_in(from).filename());
}

void Study::copy_to(const std::filesystem::path& folder) const {
  refuse_copy_to(folder);
  const std::filesystem::path from = std::filesystem::canonical(store_->folder);
  const std::filesystem::path to =
      std::filesystem::weakly_canonical(std::filesystem::absolute(folder));
  std::optional<PartFolder> part;
  name_target_in_errors(part, [&] {
    // Rows of one moment, with files that go with the participant: once more, without them, where data are deleted meanwhile.
    for (bool is_whole = false; !is_whole;) {
      part.emplace(to, kOwnersFolder);
      const std::filesystem::path& content = part->content();
      const std::int64_t deletions = store_->read([&content](Database& database) {
        Database copy(content, database_in(content), Database::Mode::create);
        copy_pages(database, copy);
        return number_of_deletions(database);
      });
      try {
        copy_files(from, content);
        is_whole = store_->read(number_of_deletions) == deletions;
      } catch (const std::exception&) {
        if (store_->read(number_of_deletions) == deletions) throw;
      }
    }
    {
      Database copy(part->content(), database_in(part->content()), Database::Mode::read_write);
      remove_itself_from_outputs(copy, to);
      complete_deletions_of(copy);
    }
    seal_new(part->content());
    part->take_place();
  });
}

}  // namespace asperity
