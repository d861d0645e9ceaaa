// Declares what is wrong in a text that is no JSON, and how it is corrected.

#pragma once

#include <cstddef>
#include <string_view>

#include "analysis/words/phrase.h"

namespace asperity {

/// Of a text in quotation marks that the parser refuses for this reason, one of a closed set (lexer.hpp of nlohmann).
Phrase problem_of_text(std::string_view reason);

/// Whether words of JSON (true, null, NaN) and numbers consist of such letters.
bool is_of_word(char letter);
/// The word or the single character there.
std::string_view token_at(std::string_view text, std::size_t from);
/// How the token that the parser does not expect at `from` is corrected; empty where the token itself is the problem.
/// `expected`: what the parser expects instead.
Phrase correction_at(std::string_view text, std::size_t from, std::string_view expected);
/// The sentence about a token (%1) for which there is no correction. `expected` is one of a closed set (`token_type_name` of
/// lexer.hpp), or empty.
Phrase unexpected(std::string_view expected);

}  // namespace asperity
