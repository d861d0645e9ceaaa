// Visits the explored surfaces or trials of a study as rows, with what may affect them: conditions, and places in the session.

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/findings/gathering/gathered_answers.h"
#include "app/findings/gathering/gathered_exploration.h"
#include "results_schema/tables/tidy_table.h"

namespace asperity {

/// What a row is about.
enum class ExploredUnit { surface, trial };

/// A counted trial, or a surface that was felt in it.
struct ExploredRow {
  const GatheredAnswer& answer;
  std::size_t surface =
      0;  ///< index in GatheredAnswers::surfaces; of a trial that of its first one
};

/// A factor of the rows.
class ExploredFactor final {
 public:
  ExploredFactor(const GatheredAnswers& gathered, ExploredBy by, std::string of_trials = {});

  std::string name{};
  std::vector<std::string> levels{};  ///< in order, those that a row has
  /// Whether it is a condition of the mixed models. Repetitions are not: they are places in the session.
  bool is_condition = true;
  bool is_complete = true;  ///< each row has a level

  /// Index in `levels`; LabelColumn::kMissing where the row has none.
  std::size_t level(const ExploredRow& row) const {
    const std::uint32_t word = word_of_level(row);
    return word == kNoWord ? LabelColumn::kMissing : code_of_word_[word];
  }
  /// For GatheredExploration.
  ExploredCondition condition(std::size_t level) const {
    return {.by = by_, .factor = of_trials_, .level = words_[level]};
  }

 private:
  friend class ExploredRows;

  std::uint32_t word_of_level(const ExploredRow& row) const;
  void set_levels(const std::vector<bool>& words);

  const GatheredAnswers& gathered_;
  ExploredBy by_ = ExploredBy::trial;
  std::string of_trials_{};                      ///< the name of a factor of the trials
  std::vector<std::uint32_t> by_combination_{};  ///< of these, words by GatheredAnswer::factors
  std::vector<bool> is_left_out_{};              ///< of these, by the word of the block
  std::vector<std::uint32_t> words_{};           ///< of the levels
  std::vector<std::size_t> code_of_word_{};
};

/// The counted trials, or the surfaces that were felt in them, in the order of the responses. There may be millions of
/// rows, which are visited and not stored.
///
/// Factors are the repetition (`column`), the factors of the trials, the block (`block`) and the item of the surface
/// (`surface`; that of the response of a trial only where each trial has one surface), those with 2 to 24 levels. Left
/// out are levels that a procedure chose or that were drawn for every trial, and items that are one with a factor.
class ExploredRows final {
 public:
  ExploredRows(const GatheredAnswers& gathered, ExploredUnit unit);

  std::size_t size() const noexcept { return size_; }
  std::size_t participants() const noexcept { return participants_; }  ///< with a row
  const std::vector<ExploredFactor>& factors() const noexcept { return factors_; }
  void for_each(const std::function<void(const ExploredRow&)>& visit) const;

 private:
  void add_factor(ExploredFactor factor);
  void add_factors_of_trials();
  void add_items();
  bool is_one_with_a_condition(const ExploredFactor& items) const;

  const GatheredAnswers& gathered_;
  ExploredUnit unit_ = ExploredUnit::surface;
  std::size_t size_ = 0;
  std::size_t participants_ = 0;
  std::vector<ExploredFactor> factors_{};
};

}  // namespace asperity
