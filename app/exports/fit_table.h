// fit.tsv of an export: counts of responses at the levels of a numeric factor, as fits take them.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/exports/columns/export_column.h"
#include "app/exports/export_folder.h"
#include "app/words/phrase.h"

namespace asperity {

/// For each participant, protocol, question, numeric factor with several levels and combination of the
/// levels of all other factors: `k` of `n` responses at `x`. `k` counts correct responses, or where
/// none is correct or incorrect those of one answer, with rows for each answer.
///
/// Counted are responses that analyses count, of completed sessions: those of a session that was not
/// completed are a selection of its conditions. Answers that are numbers have no rows. The repetition (`kColumnFactor`)
/// is neither a level nor a condition, whatever its levels are called: its responses are pooled.
class FitTable final {
 public:
  static std::vector<ExportColumn> columns();

  /// `at` with a session, a trial, an attempt and one of its responses.
  void add(const ExportPlace& at);
  /// Why there is nothing to fit, of a file that would have this name; nothing where there is.
  std::optional<Phrase> why_empty(const std::string& name) const;
  void write(ExportFolder& folder, const std::string& name) const;

 private:
  struct Curve {
    std::string participant{};
    std::string protocol{};
    std::string version{};
    std::string source_sha256{};
    std::string question{};
    std::string factor{};
    std::string others{};  ///< "order = first, texture = stone"
    auto operator<=>(const Curve&) const = default;
  };
  struct Count {
    std::int64_t responses = 0;
    std::int64_t judged = 0;
    std::int64_t correct = 0;
    std::map<std::string, std::int64_t> chosen{};
  };
  using Levels = std::map<double, Count>;

  bool has_choices_ = false;  ///< that analyses count, in a completed session
  std::map<Curve, Levels> curves_{};
};

}  // namespace asperity
