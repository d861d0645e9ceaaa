// Makes fit.tsv of an export: counts of responses at the levels of a numeric factor, for fitting
// programs.

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

/// For each participant, protocol, question, numeric factor with several levels and combination of
/// the levels of all other factors: `k` of `n` responses at `x`. `k` counts correct responses, or
/// where responses are neither correct nor incorrect those with one answer, with rows for each
/// answer.
///
/// Responses count if analyses count them and their session is completed: those of an incomplete
/// session are a selection of its conditions. Answers that are numbers have no rows. The repetition
/// (`kColumnFactor`) is neither a level nor a condition, regardless of the names of its levels: its
/// responses are pooled.
class FitTable final {
 public:
  static std::vector<ExportColumn> columns();

  /// `at` with a session, a trial, an attempt and one of its responses.
  void add(const ExportPlace& at);
  /// Why there are no data to fit, for a file of this name; nothing where there are.
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
