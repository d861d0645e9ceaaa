// Implements the application of changes to a text.

#include "protocols/editing/text_change.h"

namespace asperity {

std::string changed(std::string_view text, const TextChanges& changes) {
  std::string result{};
  std::size_t copied = 0;
  for (const TextChange& change : changes) {
    result.append(text.substr(copied, change.offset - copied)).append(change.text);
    copied = change.offset + change.length;
  }
  return result.append(text.substr(copied));
}

}  // namespace asperity
