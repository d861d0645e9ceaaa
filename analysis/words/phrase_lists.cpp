// Implements lists of phrases, as nested pairs of the items so far and the next one.

#include "analysis/words/phrase_lists.h"

#include <cstddef>
#include <utility>

namespace asperity {

namespace {

Phrase joined(const std::vector<Phrase>& items, const Phrase& last_two) {
  if (items.empty()) return phrase("Lists", "nothing");
  const Phrase next_two = phrase("Lists", "%1, %2");
  Phrase list = items.front();
  for (std::size_t i = 1; i < items.size(); ++i) {
    // Moved: a copy of the list for each item would take a second for 4,000 names.
    std::vector<Phrase> both{};
    both.push_back(std::move(list));
    both.push_back(items[i]);
    list = (i + 1 == items.size() ? last_two : next_two).filled(std::move(both));
  }
  return list;
}

}  // namespace

Phrase joined_by_or(const std::vector<Phrase>& items) {
  return joined(items, phrase("Lists", "%1 or %2"));
}

Phrase joined_by_and(const std::vector<Phrase>& items) {
  return joined(items, phrase("Lists", "%1 and %2"));
}

}  // namespace asperity
