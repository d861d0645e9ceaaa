// Finds the English words of a problem that no window can translate.

#pragma once

#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/words/phrase.h"
#include "protocols/file/diagnostic.h"

namespace asperity::test {

/// A text that is the same in every language and contains words in a row outside of quotation marks: a sentence, or a
/// part of one, that is no phrase. Empty: there is none.
inline std::string untranslated(const Phrase& phrase) {
  if (phrase.is_verbatim()) {
    static const std::regex kQuoted("\"[^\"]*\"");
    static const std::regex kWords("[a-z]{2,} [a-z]{2,}");
    const std::string bare = std::regex_replace(phrase.english(), kQuoted, "");
    return std::regex_search(bare, kWords) ? phrase.english() : std::string();
  }
  for (const Phrase& argument : phrase.arguments()) {
    if (std::string found = untranslated(argument); !found.empty()) return found;
  }
  return {};
}

/// Every problem and warning of a protocol is shown in the language of the windows.
inline void expect_translatable(const std::vector<Diagnostic>& found) {
  for (const Diagnostic& each : found) {
    EXPECT_EQ(untranslated(each.message), "") << text_of(each);
  }
}

}  // namespace asperity::test
