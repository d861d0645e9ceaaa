// Makes fit.tsv of an export: counts of responses at the levels of a numeric factor, for fitting
// programs.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "analysis/words/phrase.h"
#include "app/exports/columns/export_column.h"
#include "app/exports/columns/study_vocabulary.h"
#include "app/exports/export_folder.h"

namespace asperity {

/// Whether a response is included in the files of counts: analyses count it, its session is completed (that of an incomplete
/// session is a selection of its conditions), and it is not a number.
bool is_counted_for_fits(const ExportPlace& at);

/// "order = first, texture = stone": the levels of all factors except the repetition (`kColumnFactor`) and these.
std::string levels_text_of_factors(const nlohmann::json& factors,
                                   const std::vector<std::string>& without);

/// For each participant, protocol, question, numeric factor with several levels and combination of
/// the levels of all other factors: `k` of `n` responses at `x`. `k` counts correct responses, or
/// where responses are neither correct nor incorrect those with one answer, with rows for each
/// answer.
///
/// Responses count if `is_counted_for_fits`. The repetition (`kColumnFactor`) is neither a level nor a condition, regardless of the names of its levels: its
/// responses are pooled. In a discrimination a response "cannot tell" is counted in `unsure` and not in `k`, with the number
/// of alternatives in `m`, as the family `psyfit` reads them. Tasks whose responses are words have no rows here
/// (DetectionTable).
class FitTable final {
 public:
  explicit FitTable(const StudyVocabulary& vocabulary) : vocabulary_(vocabulary) {}

  /// With the column "language" in a study in several languages.
  std::vector<ExportColumn> columns() const;

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
    std::int64_t unsure = 0;  ///< "cannot tell", in none of the numbers above
    std::map<std::string, std::int64_t> chosen{};
  };
  struct Levels {
    std::map<double, Count> counts{};
    std::size_t alternatives = 0;  ///< of a discrimination; otherwise 0
  };

  const StudyVocabulary& vocabulary_;
  bool has_choices_ = false;     ///< that analyses count, in a completed session
  bool has_detections_ = false;  ///< of tasks whose responses are words
  std::map<Curve, Levels> curves_{};
};

}  // namespace asperity
