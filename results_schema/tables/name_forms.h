// Names that look the same and are not: an accented letter as one character or as two; labels in other letter case or with
// other leading zeros.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {

/// The places of two names that differ in nothing but the number of characters of a letter: with an accent as part of
/// the letter (Unicode's form NFC) in one, and with the accent as a character after the letter (NFD) in the other, as
/// macOS and some spreadsheets write it. The second place is the first that has an earlier partner. Also two names with
/// different accents of which one has each form are found: which accent belongs to which letter is not looked up.
std::optional<std::pair<std::size_t, std::size_t>> names_in_two_forms(
    const std::vector<std::string>& names);

/// A participant's label in lower case and without leading zeros of its numbers: "p1" of "P01". Labels with the same form
/// are easily written for each other, and are one name for some programs, and for file systems without letter case.
std::string label_form(std::string_view label);

}  // namespace asperity
