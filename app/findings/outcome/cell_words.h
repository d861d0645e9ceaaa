// Displays the fixed words in the cells of an analysis's tables as text.

#pragma once

#include <cstddef>
#include <string>

#include "analysis/words/phrase.h"

namespace asperity {

struct TestSubject;

/// Codes of the measures in the table of anchors by place: of estimates the change is a ratio, of the others a difference.
inline constexpr const char* kAnchorEstimate = "anchor_estimate";
inline constexpr const char* kAnchorRating = "anchor_rating";
inline constexpr const char* kAnchorCorrect = "anchor_correct";

// The display text of a stored word, by what it names (WordText of result_table.h). Words without a display text, and all names
// from a study, are unchanged.

/// "−∞" for "-Inf", "cannot tell" for "cannot_tell": words that have a display text in every column.
Phrase words_of_name(const std::string& stored);
/// "d′" for `d_prime`.
Phrase words_of_measure(const std::string& code);
Phrase words_of_property(const std::string& code);
/// "pairs"
Phrase words_of_test(const std::string& name);
/// "pairs: a / b", also without a subject.
Phrase words_of_test(const std::string& name, const TestSubject& about);
/// "pairs, preference" for names that are separated by commas.
Phrase words_of_tests(const std::string& names);
/// "a / b", "rough: a / b", "women, men", "amplitude".
Phrase words_of_subject(const TestSubject& about);
/// "sign-flip test, exact"; `permutations`: empty, "exact" or their number.
Phrase words_of_method(const std::string& code, const std::string& permutations);
/// "20 participants"
Phrase words_of_count(std::size_t count, const std::string& unit);
Phrase words_of_unit(const std::string& unit);
/// A reason in place of a number: "outside the presented levels"; also of several measures,
/// `jnd, weber: above_levels; slope: not_increasing`.
Phrase words_of_status(const std::string& code);
/// "trial, per 10", "amplitude"
Phrase words_of_factor(const std::string& code);
Phrase words_of_trial_group(const std::string& code);
Phrase words_of_level(const std::string& code);
Phrase words_of_catch_type(const std::string& code);
Phrase words_of_anchor_place(const std::string& code);
Phrase words_of_role(const std::string& code);
/// `words_of_condition`, "all trials" for `all`.
Phrase words_of_condition_or_all(const std::string& condition);
Phrase words_of_item(const std::string& item);
/// "Female", "Total"
Phrase words_of_sex(const std::string& sex);
/// The level of the factor `column`, or "all".
Phrase words_of_repetition(const std::string& level);

/// "strong, wavelength 2.5 mm" for the condition "strong, wavelength_m 0.0025": numbers after the name of a parameter or
/// factor with a unit are written with this unit.
std::string words_of_condition(const std::string& condition);

/// "amplitude" for the parameter or factor `amplitude_m`: its name as text, without the unit.
std::string words_of_parameter(const std::string& key);
/// "m" for the parameter or factor `amplitude_m`; empty for a name without a unit.
std::string unit_of_parameter(const std::string& key);

}  // namespace asperity
