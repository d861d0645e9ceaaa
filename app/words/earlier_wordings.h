// Converts sentences stored in studies before schema version 7 to the codes used now.

#pragma once

#include <string>

#include "app/words/phrase.h"

namespace asperity {

/// A reason, a remark or a note as version 0.1.0 and the versions up to schema 6 stored it, in the
/// program's words of that time: English, and for reasons chosen in a window the language of that
/// window. Typed text is unchanged.
///
/// Those studies are append-only and can be read without being changed, so they are not rewritten,
/// and their sentences are looked up here. This is the only part of the program that parses a
/// sentence, and its table contains the wordings of that time: it is independent of later changes
/// of wording. Data stored from schema 7 on have codes and are not processed here.
Phrase phrase_of_earlier(const std::string& sentence);
/// The same for the remark of an item of a device profile.
Phrase remark_of_earlier(const std::string& sentence);

}  // namespace asperity
