// What studies from before schema version 7 store as sentences, by the codes that they would have now.

#pragma once

#include <string>

#include "app/words/phrase.h"

namespace asperity {

/// A reason, a remark or a note as version 0.1.0 and the versions up to schema 6 stored it, in the program's words of that
/// time: English, and for what was chosen in a window the language of that window. What was typed stays as it is.
///
/// Those studies are append-only and can be read without being changed, so they are not rewritten, and their sentences
/// are looked up here. This is the only place of the program that reads a sentence, and its table has the wordings of
/// then: it does not follow when the words of today change. What is stored from schema 7 on has codes and never comes
/// here.
Phrase phrase_of_earlier(const std::string& sentence);
/// The same for the remark of an item of a device profile.
Phrase remark_of_earlier(const std::string& sentence);

}  // namespace asperity
