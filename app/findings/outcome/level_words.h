// Describes the levels of a varied parameter and the procedure that chooses them, as a methods section states them.

#pragma once

#include <string>

#include "protocols/design/protocol.h"

namespace asperity {

/// All functions require that the block varies a parameter.

/// The unit of the varied parameter.
std::string unit_of_varied(const Protocol::Block& block);

/// "differs from it by 5 %, 10 % and 20 %", said of the comparison; the range where there are many. `standard`: "it".
std::string levels_text(const Protocol::Block& block, const std::string& standard);
bool has_catch_trials(const Protocol::Block& block);
/// "differs from the standard by 150 %"; empty without easy catch trials: those of the other types present two standards.
std::string catch_level_text(const Protocol::Block& block);
/// The same in the past tense, and of levels that a procedure can choose: "could differ from it by 2 % to 100 %".
std::string in_past(std::string differing);
std::string as_possible(std::string differing);

/// How the levels of the main block were chosen, in sentences in the past tense: the rule, its start, steps, bounds and
/// end, and the catch trials. Publications are cited by their keys in brackets: "[Levitt 1971]".
std::string procedure_sentences(const Protocol::Block& block);

}  // namespace asperity
