// The texts of keys: which there are, and that the German texts of the windows have these.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "protocols/form/form_pages.h"
#include "protocols/keys/texts_of_keys.h"
#include "protocols/kinds/experiment_kind.h"

namespace asperity {
namespace {

using testing::IsEmpty;
using testing::IsSupersetOf;

TEST(KeyTexts, AreThoseOfEveryPlaceInATable) {
  EXPECT_THAT(texts_of_keys(),
              IsSupersetOf<std::string_view>({
                  "The participants.",                  // an object
                  "Planned participants",               // a label
                  "Sessions per participant.",          // a key
                  "one period",                         // a computed default
                  "in greyscale",                       // a word
                  "every participant chooses a scale",  // a word of one of several forms
                  "after half of the trials",           // a word in a list
                  "Trials in a row.",                   // an entry by name
                  "A level: a number or a name.",       // an entry of a list
                  "Levels of the anchor",               // a key of an entry by name
              }));
}

/// The words with an underscore, as keys and words of a file have it.
std::set<std::string> words_of_files(std::string_view text) {
  std::set<std::string> found{};
  std::string word{};
  for (const char c : std::string(text) + ' ') {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
      continue;
    }
    if (word.find('_') != std::string::npos) found.insert(word);
    word.clear();
  }
  return found;
}

/// The text without the names of keys in backticks, of which the form shows the labels.
std::string without_names(std::string_view text) {
  static const std::map<std::string_view, std::string_view> kLabels = labels_of_keys();
  static const std::regex kInBackticks("`(\\w+)`");
  const std::string all(text);
  for (std::sregex_iterator name(all.begin(), all.end(), kInBackticks), end; name != end; ++name) {
    EXPECT_TRUE(kLabels.contains(name->str(1))) << all;
  }
  return std::regex_replace(all, kInBackticks, "");
}

/// The form shows labels in place of keys. What remains is typed as it is written here.
TEST(KeyTexts, NameNoKeys) {
  const std::set<std::string> typed{"relative_amplitude", "vibration_models", "data_driven"};
  for (const std::string_view text : texts_of_keys()) {
    std::vector<std::string> keys{};
    std::ranges::set_difference(words_of_files(without_names(text)), typed,
                                std::back_inserter(keys));
    EXPECT_THAT(keys, IsEmpty()) << text;
    EXPECT_EQ(text.find(" key"), std::string_view::npos) << text;
  }
}

/// As the file of translations writes it.
std::string with_entities(std::string_view text) {
  std::string written{};
  for (const char c : text) {
    switch (c) {
      case '&':
        written += "&amp;";
        break;
      case '<':
        written += "&lt;";
        break;
      case '>':
        written += "&gt;";
        break;
      case '"':
        written += "&quot;";
        break;
      case '\'':
        written += "&apos;";
        break;
      default:
        written += c;
    }
  }
  return written;
}

/// What the translation file has under a context; translations_test.py checks that each is translated.
std::set<std::string> texts_with_a_translation(const std::string& context) {
  std::ifstream stream(ASPERITY_SOURCE_DIR "/app/gui/translations/asperity_de.ts",
                       std::ios::binary);
  const std::string file{std::istreambuf_iterator<char>(stream), {}};
  const std::string opening = "<source>";
  std::set<std::string> sources{};
  const std::size_t begin = file.find("<name>" + context + "</name>");
  const std::size_t end = file.find("</context>", begin);
  if (begin == std::string::npos) return sources;
  for (std::size_t at = file.find(opening, begin); at < end; at = file.find(opening, at)) {
    at += opening.size();
    sources.insert(file.substr(at, file.find("</source>", at) - at));
  }
  return sources;
}

/// scripts/key_texts.py reads them from the sources, where it could miss a new way to write a table.
TEST(KeyTexts, AreThoseThatAreTranslated) {
  std::set<std::string> texts{};
  for (const std::string_view text : texts_of_keys()) texts.insert(with_entities(text));
  for (const std::string_view text : problems_of_keys()) texts.insert(with_entities(text));
  for (const ExperimentKind* const kind : experiment_kinds()) {
    for (const KindTest& test : kind->tests) texts.insert(with_entities(test.meaning));
  }
  for (const FormPage& page : form_pages()) {
    texts.insert({with_entities(page.label), with_entities(page.meaning)});
  }
  const std::set<std::string> translated = texts_with_a_translation("Keys");
  std::vector<std::string> missing{};
  std::set_difference(texts.begin(), texts.end(), translated.begin(), translated.end(),
                      std::back_inserter(missing));
  EXPECT_THAT(missing, IsEmpty());
}

TEST(WordsOfKeys, AreThoseThatAreTranslated) {
  const std::set<std::string> translated = texts_with_a_translation("WordsOfKeys");
  for (const std::string_view word : words_of_keys()) {
    EXPECT_TRUE(translated.contains(std::string(word))) << word;
  }
}

}  // namespace
}  // namespace asperity
