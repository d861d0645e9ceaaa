// What a protocol states for a discrimination alone.

#pragma once

#include <optional>
#include <string>

#include "protocols/kind_keys/discrimination_design.h"

namespace asperity {

/// What a response of a discrimination means.
enum class DiscriminationJudgement {
  performance,  ///< the comparison is the correct response
  comparison,   ///< no response is correct: which of the two has more of something
};

/// What a catch trial presents, and therefore which response in it is an error.
enum class CatchType {
  easy,  ///< the comparison at an easy level: every response but the correct one is a lapse of attention
  no_signal,  ///< two standards, where the comparison has to be found: every response but "cannot tell" is a false alarm
  identical_pair,  ///< two standards, where no response is correct: every response but "cannot tell" is an error
};

/// The text in a protocol file and in the store.
const char* text_of(CatchType type) noexcept;

/// The question of a discrimination.
struct DiscriminationQuestion {
  std::optional<DiscriminationJudgement> judgement{};
  /// Of the judgement "comparison": for the surface with this value of the varied parameter; `more` if it is not stated.
  enum class AsksFor { more, less };
  std::optional<AsksFor> asks_for{};
};

/// A scale in a block of a discrimination that rates the confidence in the response to another question of the trial.
struct ConfidenceRating {
  std::string of{};  ///< the name of that question
};

/// A block of a discrimination.
struct DiscriminationBlock {
  /// Null in a stored protocol of a version with other designs.
  const DiscriminationDesign* design = &two_alternatives();
};

/// How a virtual participant discriminates; see virtual_observer.h.
struct DiscriminationObserver {
  /// The magnitude decreases where the varied parameter increases (with the spacing).
  bool magnitude_decreases = false;
  /// Of a yes/no task: the magnitude above which the response is "yes", as a fraction of the mean normal force, in m/s²,
  /// or in mm/N (below which, where the signal has the smaller magnitude).
  std::optional<double> yes_above{};
  /// Of a same–different task: the relative difference between two magnitudes from which on the response is "different";
  /// 0.1 is a difference of 10 %.
  std::optional<double> different_above{};
  /// Of a choice between surfaces with the option "cannot tell": the relative difference between two magnitudes below which
  /// this is the response. Absent: it never is.
  std::optional<double> unsure_within{};
};

/// Excludes participants by their errors in catch trials, all types and blocks together: those with more errors than
/// stated, or with a greater proportion of errors. One of them is stated.
struct CatchExclusion {
  std::optional<int> more_errors_than{};
  std::optional<double> error_rate_above{};

  bool operator==(const CatchExclusion&) const = default;
};

}  // namespace asperity
