// Finds which of the elements of a list, ordered by their use, fit into a number of bytes.

#pragma once

#include <cstddef>
#include <iterator>

namespace asperity {

/// The first of the last elements that need at most `most_bytes` together; the end if the last one alone needs more.
/// `bytes_of`: of an element.
template <typename List, typename BytesOf>
typename List::iterator newest_within(List& list, std::size_t most_bytes, BytesOf bytes_of) {
  std::size_t needed = 0;
  auto first = list.end();
  while (first != list.begin() && needed + bytes_of(*std::prev(first)) <= most_bytes) {
    needed += bytes_of(*--first);
  }
  return first;
}

}  // namespace asperity
