// Declares lists of phrases in a sentence.

#pragma once

#include <vector>

#include "analysis/words/phrase.h"

namespace asperity {

/// The items as a list: "a, b or c"; "nothing" without items.
Phrase joined_by_or(const std::vector<Phrase>& items);
/// "a, b and c".
Phrase joined_by_and(const std::vector<Phrase>& items);

}  // namespace asperity
