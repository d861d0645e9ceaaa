// Declares the layout of new entries of a text: in the style of their siblings.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "protocols/editing/text_entries.h"

namespace asperity {

/// Where and how a new entry is written into a container: `offset` is the place, `before` and `after` are the comma and
/// the white space around the entry.
///
/// The entry is on its own line where its neighbours are, with their indentation and their line break; otherwise on the
/// line of the neighbour.
struct EntryGap {
  std::size_t offset = 0;
  std::string before{};
  std::string after{};
  std::string line_break{};  ///< "\n" or "\r\n"; empty: the entry is on the line of its neighbour
  std::string margin{};      ///< the indentation of its own line
  std::string indent{};      ///< one level of indentation of the document
  std::string colon{};       ///< with the white space around it
};

/// The gap before the entry with this index, or after the last one.
EntryGap gap_at(const JsonDocument& document, const TextContainer& container, std::size_t index);

/// The text of a value, laid out for the gap after `key` ("" or a key in quotation marks): on one line where the gap has
/// no line or where it fits into 120 bytes, otherwise with each entry on its own line. Numbers and texts have the
/// characters that they have in `value`.
std::string laid_out(const JsonDocument& value, const EntryGap& gap, std::string_view key);

}  // namespace asperity
