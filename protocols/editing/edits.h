// Declares the edits of a protocol's text: values, members and entries of lists.

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "protocols/editing/text_change.h"
#include "protocols/file/json_document.h"

namespace asperity {

// An edit returns the changes of `document.text()`. All characters outside of the touched entry and one comma next to
// it remain: order, white space, line breaks, members `$comment` and the notation of numbers. The new text is JSON again, with the
// tree that the same edit gives of `document.root()`. It can exceed a limit of JsonDocument, which its next reader
// reports.
//
// `document` has its own tree (not one of `with_root`) and no key twice. Pointers are JSON pointers (RFC 6901); `value`
// is the text of a JSON value, as of a number that a user has typed.
//
// Time: proportional to the number of siblings, below 1 ms for 800 of them. In a protocol of 5,000 lines the reading of the
// document takes 10 ms, and a renaming (renaming.h), which walks over all values, 2 ms.
//
// Errors of all: ProtocolError with a place of the document for a value that does not exist, for a key that exists
// already, and for an index after the end; ProtocolError with a place in the new value if that is not JSON.

/// The text as JSON, in quotation marks. Errors: std::invalid_argument for a text that is not UTF-8.
std::string json_string(std::string_view text);

/// Replaces the characters of one value by those of `value`, without white space around them. No changes if the value is
/// the same: 5e-05 is not replaced by 0.00005.
TextChanges set_value(const JsonDocument& document, const std::string& pointer,
                      std::string_view value);

/// Inserts a member after the nearest one that precedes it in `order`, else before the nearest that follows it, else at
/// the end; with the line, indentation and colon of its siblings.
TextChanges insert_member(const JsonDocument& document, const std::string& object,
                          std::string_view key, std::string_view value,
                          std::span<const std::string_view> order);
/// The same in a protocol, in the order of the table of the object; at the end where the object has no table.
TextChanges insert_member(const JsonDocument& protocol, const std::string& object,
                          std::string_view key, std::string_view value);

/// Inserts an entry into an array before the entry with this index; the number of entries is the end.
TextChanges insert_entry(const JsonDocument& document, const std::string& array, std::size_t index,
                         std::string_view value);

/// Removes a member or an entry with the comma before it, of the first one with the comma after it, and with its line.
/// After an insertion this gives the same bytes as before.
TextChanges remove_entry(const JsonDocument& document, const std::string& pointer);
/// The same of several entries of any containers; of one in another, the outer one.
TextChanges remove_entries(const JsonDocument& document, std::span<const std::string> pointers);

/// Moves a member or an entry among its siblings, so that `index` of them precede it. Commas and white space between the
/// siblings stay.
TextChanges move_entry(const JsonDocument& document, const std::string& pointer, std::size_t index);

/// Inserts a copy with the same characters after a member or an entry. `key`: of the copy of a member; not used in an
/// array.
TextChanges duplicate_entry(const JsonDocument& document, const std::string& pointer,
                            std::string_view key = {});

}  // namespace asperity
