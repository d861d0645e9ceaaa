// Names that look the same and are not: an accented letter as one character or as two.

#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// The places of two names that differ in nothing but the number of characters of a letter: with an accent as part of
/// the letter (Unicode's form NFC) in one, and with the accent as a character after the letter (NFD) in the other, as
/// macOS and some spreadsheets write it. The second place is the first that has an earlier partner. Also two names with
/// different accents of which one has each form are found: which accent belongs to which letter is not looked up.
std::optional<std::pair<std::size_t, std::size_t>> names_in_two_forms(
    const std::vector<std::string>& names);

}  // namespace asperity
