// Copies each file once while its checksum is computed, and refuses links and special files.

#include "results_schema/study_files.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <map>
#include <set>
#include <system_error>
#include <vector>

#include "results_schema/deletion/study_deletion.h"
#include "results_schema/files/file_system.h"
#include "results_schema/files/folder_entries.h"
#include "results_schema/hashes/sha256.h"
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

/// The stimuli that rows name, with the SHA-256 that they must have. One that was changed
/// between two sessions has two, of which one can be there; `verify` says so.
std::map<std::string, std::set<std::string>> checksums_of_stimuli(Database& database) {
  std::map<std::string, std::set<std::string>> files;
  Statement statement(database, "SELECT DISTINCT path, sha256 FROM session_file");
  while (statement.step()) {
    std::string path;
    std::string sha256;
    statement.read(path, sha256);
    files[path].insert(sha256);
  }
  return files;
}

/// Whether a file that no row names goes along: what people put there does; what a running
/// program has not finished, and the database, which is copied in its own way, do not.
bool is_loose_file(const std::filesystem::path& relative) {
  const std::string first = relative.begin()->string();
  if (first == "locks" || first == "recordings" || first.rfind("study.sqlite", 0) == 0)
    return false;
  return relative.extension() != ".tmp" && relative.extension() != kPartEnding;
}

/// "the study /data/rough cannot be copied: its "
std::string start_of_refusal(const std::filesystem::path& study, const FileTransferWords& words) {
  return "the study " + study.string() + " cannot be " + words.participle + ": its ";
}

/// A link leads to what is not of the study, or to what a copy would hold twice.
void refuse_link(const std::filesystem::path& study, const std::filesystem::path& relative,
                 const FileTransferWords& words) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::read_symlink(study / relative, error);
  if (error) return;
  throw ResultsError(start_of_refusal(study, words) + relative.string() +
                         " is a symbolic link to " + target.string() +
                         ", and a copy cannot contain links. Replace the link with its target, or "
                         "remove it, then " +
                         words.verb + " again",
                     study / relative, ELOOP);
}

/// A FIFO, a socket, a device: what a copy cannot hold is never left out without a word.
void refuse_special_file(const std::filesystem::path& study, const std::filesystem::path& relative,
                         const FileTransferWords& words) {
  throw ResultsError(start_of_refusal(study, words) + relative.string() +
                         " is not a regular file. Remove it, then " + words.verb + " again",
                     study / relative, EINVAL);
}

/// The same as refuse_link for every part of a path that a row names.
void refuse_links_on(const std::filesystem::path& study, const std::filesystem::path& relative,
                     const FileTransferWords& words) {
  std::filesystem::path part;
  for (const std::filesystem::path& name : relative) refuse_link(study, part /= name, words);
}

/// One file at a time.
class Transfer final {
 public:
  Transfer(const std::filesystem::path& from, const std::filesystem::path& to,
           const FileTransfer& transfer)
      : from_(from), to_(to), transfer_(transfer) {}

  /// A file that rows name, with one of these SHA-256.
  void take_vouched(const std::string& path, const std::set<std::string>& sha256) const {
    refuse_links_on(from_, path, transfer_.words);
    if (sha256.contains(take(path))) return;
    throw ResultsError(start_of_refusal(from_, transfer_.words) + "file " + path +
                           " has changed since it was used (its SHA-256 differs); restore it, "
                           "then " +
                           transfer_.words.verb + " again",
                       from_ / path);
  }

  /// Returns the SHA-256 of what is there now.
  std::string take(const std::filesystem::path& relative) const {
    if (transfer_.stop.stop_requested()) {
      throw ResultsError("the study " + from_.string() + " was not " + transfer_.words.participle +
                             ": the program was asked to stop, and nothing was written. Repeat "
                             "the command to " +
                             transfer_.words.verb + " it",
                         from_, ECANCELED);
    }
    const std::filesystem::path source = path_in_study(from_, relative.string());
    const std::filesystem::path target = path_in_study(to_, transfer_.new_path(relative).string());
    if (!std::filesystem::exists(std::filesystem::symlink_status(target))) {
      return copy_and_hash(source, target);
    }
    std::string sha256 = sha256_of_file(source);
    if (sha256_of_file(target) != sha256) transfer_.refuse_other_content(relative);
    return sha256;
  }

 private:
  const std::filesystem::path& from_;
  const std::filesystem::path& to_;
  const FileTransfer& transfer_;
};

}  // namespace

void refuse_linked_database(const std::filesystem::path& study, const FileTransferWords& words) {
  refuse_link(study, database_in(study).filename(), words);
}

void transfer_files(Database& rows, const std::filesystem::path& from,
                    const std::filesystem::path& to, const FileTransfer& transfer) {
  const std::map<std::string, std::set<std::string>> stimuli = checksums_of_stimuli(rows);
  std::set<std::filesystem::path> being_deleted = files_being_deleted(rows, from);
  const Transfer one(from, to, transfer);
  for (const auto& [path, sha256] : stimuli) one.take_vouched(path, sha256);
  // As many as attempts: one after another.
  Statement recording(rows, "SELECT path, sha256 FROM recording ORDER BY path");
  while (recording.step()) {
    std::string path;
    std::string sha256;
    recording.read(path, sha256);
    one.take_vouched(path, {sha256});
  }
  for (const auto& entry : entries_below(from)) {
    const std::filesystem::path relative = entry.path().lexically_relative(from);
    // A folder comes before its content.
    if (being_deleted.contains(entry.path()) ||
        being_deleted.contains(entry.path().parent_path())) {
      being_deleted.insert(entry.path());
      continue;
    }
    if (!is_loose_file(relative) || stimuli.contains(relative.string())) continue;
    if (transfer.leaves_out && transfer.leaves_out(relative)) continue;
    refuse_link(from, relative, transfer.words);
    if (entry.is_directory()) continue;
    if (!entry.is_regular_file()) refuse_special_file(from, relative, transfer.words);
    one.take(relative);
  }
  for (const char* const part : {"protocols", "stimuli", "recordings", "locks"}) {
    std::filesystem::create_directories(to / part);
  }
  for (const auto& entry : entries_below(to)) {
    if (entry.is_directory()) sync_folder(entry.path());
  }
  sync_folder(to);
}

}  // namespace asperity
