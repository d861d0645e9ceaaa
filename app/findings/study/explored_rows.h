// Converts the exploration in a study to rows for tidy tables, with what may affect it: conditions, and places in the session.

#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "app/findings/study/gathered_answers.h"
#include "app/findings/study/trial_factors.h"
#include "results_schema/tidy_table.h"

namespace asperity {

/// What a row is about.
enum class ExploredUnit { surface, trial };

/// A factor of the rows.
struct ExploredFactor {
  TrialFactor factor{};
  /// Whether it is a condition of the mixed models. Repetitions are not: they are places in the session.
  bool is_condition = true;
};

/// The counted trials, or the surfaces that were felt in them, in the order of the responses.
///
/// Factors are the repetition (`column`), the factors of the trials, the block (`block`) and the item of the surface
/// (`surface`; that of the response of a trial only where each trial has one surface), those with 2 to 24 levels. Left
/// out are levels that a procedure chose or that were drawn for every trial, and items that are one with a factor.
class ExploredRows final {
 public:
  ExploredRows(const GatheredAnswers& gathered, ExploredUnit unit);

  std::size_t size() const noexcept { return places_.size(); }
  LabelColumn people() const;
  const std::vector<ExploredFactor>& factors() const noexcept { return factors_; }

  /// Of surfaces. A value of 0 is stored for a surface that was not touched.
  NumberColumn quantity(std::optional<double> SessionAnswers::Exploration::*of) const;
  /// Of trials: of the first question, from the cue.
  NumberColumn response_times() const;

  /// The place of the trial in its block, in tens of trials; that of the block in its session; that of the session.
  NumberColumn trial_places() const;
  NumberColumn block_places() const;
  NumberColumn session_places() const;

 private:
  struct Place {
    const GatheredAnswer* answer = nullptr;
    std::size_t surface = 0;
  };
  template <typename Of>
  NumberColumn column(const Of& of) const;
  template <typename Of>
  void add_factor(const std::string& name, const Of& level_of, bool is_condition = true);
  void add_factors_of_trials();
  void add_items(ExploredUnit unit);

  const GatheredAnswers& gathered_;
  std::vector<Place> places_{};
  std::vector<ExploredFactor> factors_{};
};

/// Trials per unit of `trial_places`.
inline constexpr double kTrialsPerPlace = 10.0;

}  // namespace asperity
