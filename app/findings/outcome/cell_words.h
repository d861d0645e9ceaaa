// Displays the fixed words in the cells of an analysis's tables as text.

#pragma once

#include <string>

#include "app/words/phrase.h"

namespace asperity {

/// Codes of the measures in the table of anchors by place: of estimates the change is a ratio, of the others a difference.
inline constexpr const char* kAnchorEstimate = "anchor_estimate";
inline constexpr const char* kAnchorRating = "anchor_rating";
inline constexpr const char* kAnchorCorrect = "anchor_correct";

/// "d′" for `d_prime` in the column `measure`, "pairs: a / b" for `pairs|a|b` in the column `test`,
/// "20 participants" for `20|participants` in the column `n`. Words without a display text, and all
/// names from a study, are unchanged.
Phrase words_of_cell(const std::string& column, const std::string& text);

/// "strong, wavelength 2.5 mm" for the condition "strong, wavelength_m 0.0025": numbers after the name of a parameter or
/// factor with a unit are written with this unit.
std::string words_of_condition(const std::string& condition);

/// "amplitude" for the parameter or factor `amplitude_m`: its name as text, without the unit.
std::string words_of_parameter(const std::string& key);
/// "m" for the parameter or factor `amplitude_m`; empty for a name without a unit.
std::string unit_of_parameter(const std::string& key);

}  // namespace asperity
