// Records the outputs of a study outside its folder: exports, reports, copies, merged studies.

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

#include "analysis/words/phrase.h"
#include "results_schema/study.h"

namespace asperity {

/// An output that is being made, in the list of its study. It is listed before anything is read for it, so that a participant
/// who withdraws while it is made finds it in the list. An output that is not completed is taken off the list, unless it has
/// taken its place; one whose program was killed stays there as incomplete.
///
/// To be made before the study is read for the output. Opens the study for writing, each time for a moment; a reader in the
/// same process must be one that reads beside writers (Study::read_beside_writers).
class ListedOutput final {
 public:
  /// Where it cannot be listed, because the study is read-only or damaged, `complete` states so.
  ListedOutput(const Study& study, OutputKind kind, const std::filesystem::path& path);
  ListedOutput(const ListedOutput&) = delete;
  ListedOutput& operator=(const ListedOutput&) = delete;
  ~ListedOutput();

  /// The output is complete. Returns the reason where the study does not list it.
  std::optional<Phrase> complete();

 private:
  std::filesystem::path study_{};
  std::filesystem::path path_{};
  std::optional<std::pair<dev_t, ino_t>> before_{};  ///< what was at the path
  std::optional<std::int64_t> entry_{};
  std::optional<Phrase> unlisted_{};
};

/// "public export": the kind of output in lists.
Phrase kind_words(OutputKind kind);

/// The listed outputs that may contain a participant's data: for a person, the outputs made since they were added. A
/// simulated participant has no real date; for those, the outputs that contain the label or cannot be read now.
/// Of an output whose program was killed, the path is that of its remains, NAME.part. Errors: ResultsError for an unknown label.
std::vector<OutputRow> outputs_of_participant(const Study& study, const std::string& label);

/// The same of the outputs that a withdrawal has found.
std::vector<OutputRow> outputs_of_withdrawal(const Withdrawal& withdrawal,
                                             const std::string& label);

}  // namespace asperity
