// Declares the pages of a form for a protocol, and the keys of each.

#pragma once

#include <span>
#include <string_view>

namespace asperity {

/// A key of a protocol on a page of the form.
struct PagePart {
  std::string_view key{};
  /// Of a key with objects by name: which keys of these objects are on the page. Empty: all.
  std::span<const std::string_view> of_entries{};
  bool are_left_out = false;  ///< all but `of_entries`
  /// The page is named after the key: a form shows it also without a value.
  bool is_in_title = false;
};

/// A page of the form, in the order in which a study is planned.
struct FormPage {
  std::string_view id{};
  std::string_view label{};
  std::string_view meaning{};  ///< ends with a full stop
  std::span<const PagePart> parts{};
  bool lists_texts = false;  ///< all texts that participants read follow, each in a field
};

/// Every key of a protocol is on one page, and every key of a block on one page of "blocks", except for `keys_of_files`.
std::span<const FormPage> form_pages();

/// Keys that have one correct value in every file, which a form does not offer.
std::span<const std::string_view> keys_of_files();

/// Whether a page has the key of an object, an entry of the part.
bool has_key(const PagePart& part, std::string_view key);

/// The page with the value at a JSON pointer; the first page if none has it.
const FormPage& form_page_of(std::string_view pointer);

}  // namespace asperity
