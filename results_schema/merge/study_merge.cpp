// A new study with the participants of several studies, made in one step.

#include "results_schema/merge/study_merge.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <system_error>
#include <utility>
#include <vector>

#include "results_schema/files/folder_entries.h"
#include "results_schema/files/part_folder.h"
#include "results_schema/hashes/seal.h"
#include "results_schema/hashes/sha256.h"
#include "results_schema/merge/merge_sources.h"
#include "results_schema/merge/merged_rows.h"
#include "results_schema/part_files.h"
#include "results_schema/study.h"
#include "results_schema/study_files.h"
#include "results_schema/study_sharing.h"
#include "results_schema/study_store.h"

namespace asperity {
namespace {

const FileTransferWords kMergeWords{.participle = "merged", .verb = "merge"};

std::filesystem::path canonical_folder(const std::filesystem::path& folder) {
  const std::filesystem::path path =
      std::filesystem::weakly_canonical(std::filesystem::absolute(folder)).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

void refuse_prefix(const MergeSource& source) {
  if (source.prefix.empty() || is_participant_label(source.prefix)) return;
  refuse_source(source, "\"" + source.prefix +
                            "\" is not permitted as a prefix of its labels; use letters and "
                            "digits (0-9, A-Z, a-z)");
}

void refuse_condition(const MergeSource& source, StudyCondition condition) {
  switch (condition) {
    case StudyCondition::whole:
      return;
    case StudyCondition::changed:
      refuse_source(source,
                    "its study.sqlite has changed since Asperity last closed it (its SHA-256 "
                    "differs from that in study.sqlite.sha256). \"asperity verify\" lists the "
                    "possible causes; if the change was intended, remove study.sqlite.sha256 and "
                    "merge again");
    case StudyCondition::broken:
      refuse_source(source,
                    "its study.sqlite is damaged, and rows may be missing; restore it from a copy, "
                    "then merge again");
  }
}

/// Which study the files of the merged one came from, to name it where another has a different one.
class FilesOfSources final {
 public:
  FilesOfSources(OpenSources sources, std::stop_token stop)
      : sources_(sources), stop_(std::move(stop)) {}

  void transfer_to(const std::filesystem::path& to) {
    for (const OpenSource& source : sources_) {
      transfer_files(
          source.database, source.study.folder(), to,
          {.words = kMergeWords,
           .new_path = [&](const std::filesystem::path& path) { return taken(source, path); },
           .refuse_other_content = [&](const std::filesystem::path& path) { refuse(source, path); },
           .leaves_out = states_part,
           .stop = stop_});
    }
  }

 private:
  std::filesystem::path taken(const OpenSource& source, const std::filesystem::path& path) {
    std::filesystem::path merged = merged_path(source.source, path);
    // Recordings are as many as attempts, and no two participants have the same label.
    if (*path.begin() != "recordings") first_.try_emplace(merged.string(), &source.source, path);
    return merged;
  }

  [[noreturn]] void refuse(const OpenSource& source, const std::filesystem::path& path) const {
    const auto first = first_.find(merged_path(source.source, path).string());
    const MergeSource& other =
        first == first_.end() ? sources_.front().source : *first->second.first;
    const std::filesystem::path other_path = first == first_.end() ? path : first->second.second;
    refuse_pair(other, source.source,
                "the files " + (other.folder / other_path).string() + " and " +
                    (source.source.folder / path).string() +
                    " differ, and the merged study can have only one of them. If no session used "
                    "one of them, rename or remove it; otherwise the sessions used different "
                    "stimuli under one name, and the studies cannot be merged");
  }

  OpenSources sources_;
  std::stop_token stop_;
  /// The source and its path, by the path in the merged study.
  std::map<std::string, std::pair<const MergeSource*, std::filesystem::path>> first_{};
};

/// Of a simulation the time at which its first participant was added, on the simulated calendar: its parts then give the
/// same file as the whole, whenever they were simulated.
std::string creation_of_merged(Database& merged, OpenSources sources) {
  Statement participant(merged, "SELECT min(is_virtual), min(created_utc) FROM participant");
  if (participant.step() && participant.integer_at(0) == 1) return participant.text_at(1);
  std::string first = creation_of(sources.front().database);
  for (const OpenSource& source : sources) first = std::min(first, creation_of(source.database));
  return first;
}

/// The rest of the folder is new, and becomes visible only as a whole: what is written is synced once, at the end.
void fill_database(Database& merged, OpenSources sources, const StudyMetadata& metadata) {
  merged.execute("PRAGMA synchronous = OFF; PRAGMA secure_delete = ON");
  list_participants(merged, sources);
  copy_merged_rows(merged, sources);
  // The last transaction is synced, and with its checkpoint the whole file.
  merged.execute("PRAGMA synchronous = FULL");
  Transaction transaction(merged);
  Statement(merged, "UPDATE study SET created_utc = ?, license = ?, ethics_approval = ?")
      .bind(creation_of_merged(merged, sources), metadata.license, metadata.ethics_approval)
      .run();
  Statement author(merged, "INSERT INTO author VALUES (?, ?)");
  int position = 0;
  for (const std::string& name : metadata.authors) author.bind(++position, name).run();
  transaction.commit();
  merged.execute("PRAGMA wal_checkpoint(TRUNCATE)");
}

MergedCounts counts_in(Database& merged) {
  Statement statement(merged,
                      "SELECT (SELECT count(*) FROM participant), (SELECT count(*) FROM session), "
                      "(SELECT count(*) FROM session WHERE state <> 'completed'), "
                      "(SELECT count(*) FROM attempt), (SELECT count(*) FROM recording)");
  MergedCounts counts{};
  if (statement.step()) {
    statement.read(counts.participants, counts.sessions, counts.incomplete_sessions,
                   counts.attempts, counts.recordings);
  }
  return counts;
}

[[noreturn]] void refuse_taken(const std::filesystem::path& folder, const std::string& why) {
  throw ResultsError("the studies cannot be merged into " + folder.string() +
                         ", which already exists" + why + "; name a new folder",
                     folder, EEXIST);
}

bool have_same_bytes(const std::filesystem::path& one, const std::filesystem::path& other) {
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(other, error)) &&
         std::filesystem::file_size(one, error) == std::filesystem::file_size(other, error) &&
         !error && sha256_of_file(one) == sha256_of_file(other);
}

/// Whether `folder` has all files of the study that was merged into `made`: the same studies give the same files.
bool has_files_of(const std::filesystem::path& folder, const std::filesystem::path& made) {
  for (const auto& entry : entries_below(made)) {
    const std::filesystem::path relative = entry.path().lexically_relative(made);
    if (entry.is_directory() || *relative.begin() == "locks") continue;
    if (!have_same_bytes(entry.path(), folder / relative)) return false;
  }
  return true;
}

/// Runs `reading` while each study is read at one moment.
void read_all_at_one_moment(const std::list<Study>& studies, std::list<Study>::const_iterator next,
                            const std::function<void()>& reading) {
  if (next == studies.end()) {
    reading();
    return;
  }
  next->read_at_one_moment([&] { read_all_at_one_moment(studies, std::next(next), reading); });
}

}  // namespace

void Study::refuse_merge_to(std::span<const MergeSource> sources,
                            const std::filesystem::path& folder) {
  if (sources.empty()) {
    throw std::invalid_argument("no study to merge is named; name the folders of studies");
  }
  if (std::filesystem::exists(std::filesystem::symlink_status(folder)) && !Study::exists(folder)) {
    refuse_taken(folder, "");
  }
  const std::filesystem::path to = canonical_folder(folder);
  std::map<std::filesystem::path, const MergeSource*> known;
  for (const MergeSource& source : sources) {
    refuse_prefix(source);
    const std::filesystem::path from = canonical_folder(source.folder);
    if (const auto [other, is_new] = known.try_emplace(from, &source); !is_new) {
      refuse_pair(*other->second, source, "they are the same folder; name each study once");
    }
    if (std::mismatch(from.begin(), from.end(), to.begin(), to.end()).first == from.end()) {
      refuse_source(source, "the merged study, " + folder.string() +
                                ", would be in its folder; name a folder outside the study");
    }
    refuse_linked_database(from, kMergeWords);
  }
}

MergedCounts Study::merge(std::span<const MergeSource> sources, const std::filesystem::path& folder,
                          const MergeSettings& settings) {
  refuse_merge_to(sources, folder);
  const std::filesystem::path to = canonical_folder(folder);
  std::list<Study> studies;
  for (const MergeSource& source : sources) {
    studies.push_back(open(source.folder, Access::read_only));
    refuse_condition(source, studies.back().condition());
  }
  const bool was_there = Study::exists(to);
  constexpr const char* kOther = " and is not the merge of these studies as they are now";
  std::optional<PartFolder> part;
  MergedCounts counts{};
  // Begun again where data are deleted meanwhile.
  const auto fill = [&] {
    std::vector<OpenSource> opened;
    std::size_t i = 0;
    for (const Study& study : studies) {
      opened.push_back({sources[i++], study, *study.store_->database});
      refuse_unfinished(opened.back());
    }
    if (settings.deletions_in_copies == DeletionsInCopies::unchecked) {
      refuse_undone_deletions(opened);
    }
    const StudyMetadata metadata = merged_metadata(opened, settings.metadata);
    part.reset();
    part.emplace(to, kOwnersFolder);
    {
      const Study merged = create(part->content(), to.filename().string());
      Database& database = *merged.store_->database;
      fill_database(database, opened, metadata);
      counts = counts_in(database);
    }
    // Before the files, which can be many.
    if (was_there && !have_same_bytes(database_in(part->content()), database_in(to))) {
      refuse_taken(folder, kOther);
    }
    FilesOfSources(opened, settings.stop).transfer_to(part->content());
  };
  name_target_in_errors(part, [&] {
    read_all_at_one_moment(studies, studies.begin(), fill);
    if (!has_seal(part->content())) seal_new(part->content());
    if (!was_there) {
      part->take_place();
    } else if (!has_files_of(to, part->content())) {
      refuse_taken(folder, kOther);
    }
    counts.was_there = was_there;
  });
  return counts;
}

}  // namespace asperity
