// The fixed words that stand in the cells of an analysis's tables, as people read them.

#pragma once

#include <string>

#include "app/words/phrase.h"

namespace asperity {

/// "d′" of `d_prime` in the column `measure`, "pairs: a / b" of `pairs|a|b` in the column `test`, "20
/// participants" of `20|participants` in the column `n`. What has no other words, and every name that a
/// study has given, stays.
Phrase words_of_cell(const std::string& column, const std::string& text);

/// "amplitude" of the parameter or factor `amplitude_m`: its name in words, without the unit.
std::string words_of_parameter(const std::string& key);

}  // namespace asperity
