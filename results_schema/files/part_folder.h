// A folder that appears under its name when it is complete, or not at all.

#pragma once

#include <filesystem>
#include <optional>
#include <sys/types.h>
#include <utility>

#include "results_schema/files/atomic_file.h"
#include "results_schema/study.h"

namespace asperity {

/// A folder in the making: `NAME.part/content`, next to `NAME`, whose place it takes at the end.
///
/// `NAME.part/lock` is locked by the program that makes it. What a killed program left there is removed by the next
/// one that makes the same folder.
///
/// Errors: ResultsError for a NAME.part that another program is making, and for one that no PartFolder made or whose
/// lock cannot be trusted (a network file system): it is not touched.
class PartFolder final {
 public:
  /// Makes the folders above `target` that are missing. `mode` is that of the folder, before the umask.
  PartFolder(const std::filesystem::path& target, mode_t mode);
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;
  /// Removes NAME.part, and with it what did not take its place or was replaced.
  ~PartFolder();

  /// Removes what a program left that was killed after `target` took its place. Errors: those of the constructor.
  static void remove_leftover(const std::filesystem::path& target);

  /// The folder to be filled.
  const std::filesystem::path& content() const noexcept { return content_; }

  /// Renames the folder; what is in it must be synced. With Overwrite::allow a folder of that name is replaced in one
  /// step. On disk when it returns. Errors: ResultsError, also for a name that is taken (and `refuse`).
  void take_place(Overwrite overwrite = Overwrite::refuse);

  /// The same error with the name that the folder would have had in place of that of `content`, which is removed and means
  /// nothing to a reader.
  ResultsError about_target(const ResultsError& error) const;

 private:
  bool claim();
  void refuse_what_is_not_left_by_us() const;
  void clear() noexcept;

  std::filesystem::path target_{};
  std::filesystem::path part_{};
  std::filesystem::path content_{};
  std::filesystem::path replaced_{};
  std::filesystem::path lock_path_{};
  int lock_ = -1;
};

/// Runs steps that fill a folder in the making and let it take its place. Their errors about its content are about the target
/// (`about_target`); errors before there is a folder are unchanged. `Part`: PartFolder, or a folder that has one. The steps may
/// begin it again.
template <class Part, class Steps>
void name_target_in_errors(const std::optional<Part>& part, const Steps& steps) {
  try {
    steps();
  } catch (const ResultsError& error) {
    if (!part) throw;
    throw part->about_target(error);
  }
}

/// Makes a folder of what `fill` writes into the path that it is given, or none. Errors: those of PartFolder and of `fill`,
/// about the target.
template <class Fill>
void make_folder_at_once(const std::filesystem::path& target, mode_t mode, const Fill& fill) {
  std::optional<PartFolder> part(std::in_place, target, mode);
  name_target_in_errors(part, [&] {
    fill(part->content());
    part->take_place();
  });
}

}  // namespace asperity
