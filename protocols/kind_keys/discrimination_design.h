// The designs of a discrimination: what the trials of a block present, and what a response is.

#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "analysis/words/phrase.h"

namespace asperity {

/// One type of trial: the roles of its surfaces, as listed before positions are drawn.
struct DesignTrial {
  std::array<std::string_view, 3> roles{};  ///< empty: no surface
  bool is_signal = true;                    ///< "yes" is correct, where the options are words

  std::size_t surfaces() const noexcept;
  bool presents(std::string_view role) const noexcept;
};

/// A block lists a standard and a comparison in every design. A trial presents them as its type states, and one repetition of
/// a block has a trial of every type at each level.
struct DiscriminationDesign {
  std::string_view id{};    ///< as in protocols and in the store
  std::string_view name{};  ///< in sentences, after the article
  Phrase with_article{};    ///< "an oddity task"
  std::span<const DesignTrial> trials{};
  /// The values of the options in words: of the correct response to a signal, and of the other one. Empty where one of the
  /// surfaces is chosen.
  std::string_view yes{};
  std::string_view no{};
  /// Where a surface is chosen: the correct one differs from the others, and may be the standard. Otherwise it is the
  /// comparison.
  bool asks_for_odd_one = false;

  /// Whether there are trials without a signal, and therefore false alarms.
  bool has_noise() const noexcept { return !yes.empty(); }
  /// Whether one of three surfaces is chosen.
  bool is_choice_of_three() const noexcept { return !has_noise() && surfaces() == 3; }
  /// The number of surfaces of every trial.
  std::size_t surfaces() const noexcept { return trials.front().surfaces(); }
  /// The number of surfaces of which one is chosen; 0 where the options are words. A guess is correct with the probability
  /// 1/alternatives, and a response "cannot tell" counts as such a guess.
  std::size_t alternatives() const noexcept { return has_noise() ? 0 : surfaces(); }
  /// The probability that a guess is correct: of a choice of a surface, or of one of two words.
  double guess_rate() const noexcept {
    return has_noise() ? 0.5 : 1.0 / static_cast<double>(surfaces());
  }
  /// Whether trials with this number of comparisons have a signal.
  bool is_signal(std::size_t comparisons) const noexcept;
  /// The value of the correct option in trials with this number of comparisons: a surface by its role, or one of the words.
  std::string_view correct_response(std::size_t comparisons) const noexcept;
};

/// The design of a block that states none: one of two surfaces is chosen.
const DiscriminationDesign& two_alternatives() noexcept;
/// One surface: is it the comparison? Equally often the standard and the comparison.
const DiscriminationDesign& yes_no_task() noexcept;
/// Two surfaces: do they differ? Equally often different and equal; pairs of two standards and of two comparisons are equally
/// frequent, so that no single surface indicates the response.
const DiscriminationDesign& same_different_task() noexcept;
/// Three surfaces: which is the comparison? The others are standards.
const DiscriminationDesign& three_alternatives() noexcept;
/// Three surfaces, two of them equal: which is the odd one? Equally often a comparison among standards and a standard among
/// comparisons, so that no single surface indicates the response.
const DiscriminationDesign& oddity_task() noexcept;

/// All designs, in the order in which documents list them.
std::span<const DiscriminationDesign* const> discrimination_designs();
/// Null where there is no such design.
const DiscriminationDesign* find_design(std::string_view id) noexcept;
/// The design whose options in words include `option`; null where there is none.
const DiscriminationDesign* design_with_option(std::string_view option) noexcept;

}  // namespace asperity
