// The phrases that have a code, and lists of them.

#pragma once

#include <functional>
#include <map>
#include <string>

#include "analysis/words/phrase.h"

namespace asperity {

/// Every phrase that has a code, by its code. A code never changes; its words may change.
const std::map<std::string, Phrase, std::less<>>& coded_phrases();

/// Both, separated by a semicolon; the second where the first is empty.
Phrase with_semicolon(const Phrase& first, const Phrase& second);
/// Both, separated by a comma; the second where the first is empty.
Phrase with_comma(const Phrase& first, const Phrase& second);

/// Whether the phrase was made by one of these two. A list of more than two is nested: the first of a pair is the list
/// so far.
bool is_phrase_list(const Phrase& phrase);
/// One more phrase in a list of this kind; the phrase itself where `first` is empty.
Phrase with_next(const Phrase& list, const Phrase& first, const Phrase& second);

}  // namespace asperity
