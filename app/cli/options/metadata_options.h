// The options of the command line that state a study's authors, license and ethics approval.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results_schema/rows.h"

namespace CLI {
class App;
}

namespace asperity {

struct MetadataOptions {
  std::vector<std::string> authors{};
  std::optional<std::string> license{};
  std::optional<std::string> ethics{};

  bool is_any() const { return !authors.empty() || license || ethics; }
  /// `metadata` with what was given; an empty text takes it away.
  StudyMetadata applied_to(StudyMetadata metadata) const;
};

/// What an option with an empty text, --license "", means. One of blanks alone is a mistake everywhere.
enum class EmptyText { mistake, takes_away };

/// --author, --license and --ethics.
void add_metadata_options(CLI::App& command, MetadataOptions& options, EmptyText empty);

}  // namespace asperity
