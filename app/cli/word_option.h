// An option that takes one word of a few.

#pragma once

#include <cstddef>
#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace asperity {

/// Reads the word as what it stands for; refuses any other, naming those that there are.
template <typename Meaning>
CLI::Validator word_of(const std::map<std::string, Meaning>& words) {
  const auto read = [words](std::string& text) -> std::string {
    const auto found = words.find(text);
    if (found != words.end()) {
      text = std::to_string(static_cast<int>(found->second));
      return {};
    }
    std::string sentence = "there is no \"" + text + "\"; write ";
    std::size_t left = words.size();
    for (const auto& [word, meaning] : words) {
      --left;
      sentence += word + (left > 1 ? ", " : left == 1 ? " or " : "");
    }
    return sentence;
  };
  return {read, "WORD"};
}

}  // namespace asperity
