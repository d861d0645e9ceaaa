// Records the figures that a command drew from its stored result, so that it can replace them when the result has grown.

#pragma once

#include <filesystem>
#include <utility>

#include "results_schema/files/atomic_file.h"

namespace asperity {

/// The figures that a command drew from one result: a JSON file (`asperity.drawn_figures/1`) with the path of each, relative to the
/// folder of the record, and the SHA-256 of its content.
class DrawnFigures final {
 public:
  explicit DrawnFigures(std::filesystem::path record) : record_(std::move(record)) {}

  /// `allow` for a figure that has the content with which it is recorded, because it is the command's own; otherwise `given`: a
  /// figure that has been changed since, or that is not of this result, is not replaced unasked. A damaged record has no figures.
  Overwrite overwrite_of(const std::filesystem::path& figure, Overwrite given) const;

  /// Records the figure as it is now. Errors: ResultsError.
  void record(const std::filesystem::path& figure) const;

 private:
  std::filesystem::path record_;
};

}  // namespace asperity
