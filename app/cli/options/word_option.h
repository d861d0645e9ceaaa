// An option that takes one word of a few.

#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace asperity {

/// Refuses a word that is not one of these, naming them.
inline CLI::Validator word_among(const std::vector<std::string>& words) {
  const auto read = [words](std::string& text) -> std::string {
    if (std::find(words.begin(), words.end(), text) != words.end()) return {};
    std::string sentence = "\"" + text + "\" is not permitted; write ";
    for (std::size_t i = 0; i < words.size(); ++i) {
      sentence += (i == 0 ? "" : i + 1 < words.size() ? ", " : " or ") + words[i];
    }
    return sentence;
  };
  return {read, "WORD"};
}

/// Reads the word as what it stands for; refuses any other, as `word_among`.
template <typename Meaning>
CLI::Validator word_of(const std::map<std::string, Meaning>& words) {
  std::vector<std::string> names{};
  for (const auto& [word, meaning] : words) names.push_back(word);
  const auto read = [words, refused = word_among(names)](std::string& text) -> std::string {
    const auto found = words.find(text);
    if (found == words.end()) return refused(text);
    text = std::to_string(static_cast<int>(found->second));
    return {};
  };
  return {read, "WORD"};
}

}  // namespace asperity
