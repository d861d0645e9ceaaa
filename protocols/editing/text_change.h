// Declares changes of a text as replacements of its characters.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// `length` bytes from `offset` are replaced by `text`.
struct TextChange {
  std::size_t offset = 0;
  std::size_t length = 0;
  std::string text{};
};

/// Changes of one text: disjoint, in ascending order, all offsets in the text before any change.
using TextChanges = std::vector<TextChange>;

/// The text after the changes.
std::string changed(std::string_view text, const TextChanges& changes);

}  // namespace asperity
