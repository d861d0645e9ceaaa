// The union of the studies of several stations: what is merged, under which labels, and what it amounts to.

#pragma once

#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>

#include "results_schema/rows.h"

namespace asperity {

/// A study whose rows and files become part of a merged study. It is not changed.
struct MergeSource {
  std::filesystem::path folder{};
  /// In the merged study its labels begin with this: letters and digits, or nothing.
  std::string prefix{};
};

/// Whether data that were deleted from one of two copies of a study can still be in the other one. Both may be of use: a
/// study that was copied to several stations before its first session. The study does not store whose data were deleted, so
/// that only the user can determine it.
enum class DeletionsInCopies {
  unchecked,  ///< such studies are refused
  checked,    ///< the user states that they are not
};

struct MergeSettings {
  /// What is stated here replaces what the studies state; it is required where they state different things.
  StudyMetadata metadata{};
  DeletionsInCopies deletions_in_copies = DeletionsInCopies::unchecked;
  std::stop_token stop{};  ///< a stop is an error, and nothing is left
};

/// The numbers of rows in a merged study.
struct MergedCounts {
  bool was_there =
      false;  ///< an earlier merge of the same studies made it, and nothing was written
  std::int64_t participants = 0;
  std::int64_t sessions = 0;
  std::int64_t incomplete_sessions = 0;  ///< of `sessions`: those that can be resumed
  std::int64_t attempts = 0;
  std::int64_t recordings = 0;
};

}  // namespace asperity
